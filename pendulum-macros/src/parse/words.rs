//! The words of the macro's input that stand for something: parameters, methods, types and outputs.

use crate::report::{list, nearest};
use syn::{Error, Ident, Result};

/// What the macro's input has words for.
pub(crate) trait Keyword: Sized + 'static {
    /// What one of them is called in messages.
    const KIND: &'static str;
    const ALL: &'static [Self];
    const WORDS: &'static [&'static str];
    /// What they are called elsewhere, and their words here.
    const SYNONYMS: &'static [(&'static str, &'static str)];

    fn from_word(word: &str) -> Option<Self>;
}

/// Declares an enum whose variants have names in the macro's input, and others elsewhere.
macro_rules! keywords {
    ($(#[$doc:meta])* $name:ident = $kind:literal {
        $($(#[$variant_doc:meta])* $variant:ident = $word:literal $(| $synonym:literal)*),* $(,)?
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum $name { $($(#[$variant_doc])* $variant),* }

        impl $name {
            pub(crate) fn word(self) -> &'static str {
                match self { $(Self::$variant => $word),* }
            }
        }

        impl Keyword for $name {
            const KIND: &'static str = $kind;
            const ALL: &'static [Self] = &[$(Self::$variant),*];
            const WORDS: &'static [&'static str] = &[$($word),*];
            const SYNONYMS: &'static [(&'static str, &'static str)] = &[$($(($synonym, $word),)*)*];

            fn from_word(word: &str) -> Option<Self> {
                match word { $($word => Some(Self::$variant),)* _ => None }
            }
        }
    };
}

keywords! {
    /// What is given by `name = value`. What it is called elsewhere is in lower case.
    Parameter = "parameter" {
        Theta0 = "theta0" | "θ" | "θ0" | "θ_0" | "angle" | "angle0" | "amplitude",
        Velocity0 = "velocity0" | "v" | "v0" | "v_0" | "vel" | "vel0" | "vel_0" | "speed" | "speed0"
            | "initial_velocity" | "theta_dot" | "thetadot" | "theta_dot0" | "dtheta" | "dtheta0" | "θ̇" | "θ̇0",
        Omega = "omega" | "w" | "w0" | "ω" | "ω0" | "ω_0" | "rate" | "angular_frequency" | "freq" | "frequency" | "f"
            | "f0" | "hz" | "period",
        G = "g" | "gravity",
        Length = "length" | "l" | "ℓ" | "ell" | "len",
        N = "n" | "terms" | "nterms" | "n_terms" | "order" | "degree" | "harmonics",
        Tol = "tol" | "tolerance" | "tolerence" | "accuracy" | "eps" | "epsilon" | "err" | "error" | "max_error",
        TMax = "t_max" | "t" | "t_end" | "time" | "duration" | "horizon",
        Method = "method",
        Float = "float" | "type" | "precision",
        Outputs = "outputs",
    }
}

keywords! {
    /// How the motion is approximated.
    Method = "method" {
        /// Eq. 3 from any state: θ0 cos ωt + (θ̇0/ω) sin ωt.
        SmallAngle = "small_angle" | "linear",
        /// Eq. 17: θ0 cos(2πt/T).
        Harmonic = "harmonic",
        /// Eq. 22: `2 arcsin(k sn_N)`.
        Fourier = "fourier" | "paper",
        /// The Fourier series of θ itself.
        Series = "series",
        /// A polynomial in the reduced phase.
        Polynomial = "polynomial" | "poly" | "pieces",
    }
}

keywords! {
    /// The type of t and of the results.
    Float = "float" { F64 = "f64" | "double", F32 = "f32" | "single" | "float" }
}

keywords! {
    /// A quantity to be computed.
    Output = "output" {
        Theta = "theta" | "θ" | "angle",
        Velocity = "velocity" | "v" | "vel" | "speed" | "theta_dot" | "dtheta" | "θ̇" | "omega",
        Acceleration = "acceleration" | "acc" | "accel" | "theta_ddot",
        Position = "position" | "pos" | "x" | "y" | "xy",
        Wrapped = "wrapped" | "wrap",
    }
}

impl Output {
    pub(crate) fn is_angle(self) -> bool {
        matches!(self, Self::Theta | Self::Wrapped)
    }
}

/// What `ident` stands for, or the nearest word.
pub(super) fn one_word<T: Keyword>(ident: &Ident) -> Result<T> {
    let (kind, text) = (T::KIND, ident.to_string());
    T::from_word(&text).ok_or_else(|| {
        let synonym = T::SYNONYMS.iter().find(|(synonym, _)| *synonym == text).map(|&(_, word)| word);
        let message = synonym.or_else(|| nearest(&text, T::WORDS)).map_or_else(
            || format!("unknown {kind} `{text}`: {}", one_of::<T>()),
            |known| format!("unknown {kind} `{text}`: did you mean `{known}`?"),
        );
        Error::new(ident.span(), message)
    })
}

/// What may be said instead of what was.
pub(super) fn one_of<T: Keyword>() -> String {
    let is_parameter = Parameter::from_word(T::KIND).is_some();
    let or_nothing = if is_parameter { format!("; or leave `{}` out", T::KIND) } else { String::new() };
    format!("it is one of {}{or_nothing}", list(T::WORDS))
}
