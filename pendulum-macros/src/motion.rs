//! The exact motion: regime, modulus, quarter periods, nome, period and launch phase, in more than double precision.

use crate::exact::Real;

/// One solution of θ̈ + ω² sin θ = 0.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    pub(crate) regime: Regime,
    /// θ and θ̇ at t = 0, as given.
    pub(crate) theta0: Real,
    pub(crate) velocity0: Real,
    /// The rate ω of small oscillations.
    pub(crate) omega: Real,
}

/// What kind of motion it is.
#[derive(Clone, Debug)]
pub(crate) enum Regime {
    Swing(Swing),
    Separatrix(Separatrix),
    Rotation(Rotation),
}

/// Libration between ±amplitude.
#[derive(Clone, Debug)]
pub(crate) struct Swing {
    /// The turning angle, 0 < amplitude < π.
    pub(crate) amplitude: Real,
    /// Set where θ(t) is the mirror image of the motion described: the result's sign is flipped.
    pub(crate) mirrored: bool,
    /// Phase at t = 0 in half periods after the positive turning point (of the motion before mirroring), in [−½, ½];
    /// exactly zero when released from rest, otherwise θ(0) of the unmirrored motion is ≥ 0.
    pub(crate) launch: Real,
    pub(crate) elliptic: Elliptic,
    /// T = 4K/ω.
    pub(crate) period: Real,
}

/// Over the top, again and again.
#[derive(Clone, Debug)]
pub(crate) struct Rotation {
    /// Set where θ decreases: the result's sign is flipped.
    pub(crate) mirrored: bool,
    /// Phase at t = 0 in turns after the lowest point, in [−½, ½], of the unmirrored motion.
    pub(crate) launch: Real,
    /// κ = 2ω/|velocity at the lowest point| and what follows from it.
    pub(crate) elliptic: Elliptic,
    /// |θ̇| at the lowest point.
    pub(crate) fastest: Real,
    /// |θ̇| at the top.
    pub(crate) slowest: Real,
    /// The time of one turn, 4K(κ)/fastest.
    pub(crate) period: Real,
}

/// Towards the top for ever, never reaching it: θ = 4 atan tanh(ω(t − t₀)/2).
#[derive(Clone, Debug)]
pub(crate) struct Separatrix {
    /// Set where θ decreases: the result's sign is flipped.
    pub(crate) mirrored: bool,
    /// ω·(time since the lowest point) at t = 0, of the unmirrored motion.
    pub(crate) launch: Real,
}

/// A modulus and its integrals.
#[derive(Clone, Debug)]
pub(crate) struct Elliptic {
    /// k.
    pub(crate) modulus: Real,
    /// k′ = √(1 − k²), never computed so.
    pub(crate) complementary: Real,
    /// K(k).
    pub(crate) quarter: Real,
    /// K′ = K(k′).
    pub(crate) quarter_complementary: Real,
    /// q = exp(−πK′/K).
    pub(crate) nome: Real,
    /// q′ = exp(−πK/K′).
    pub(crate) nome_complementary: Real,
}
