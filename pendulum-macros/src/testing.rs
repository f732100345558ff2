//! What tests everywhere begin with: the scene of a text, and reproducible randomness.

use crate::check::check;
use crate::motion::{Regime, Swing};
use crate::parse::parse;
use crate::report::Report;
use crate::scene::Scene;
use proc_macro2::TokenStream;

/// The stages before planning, and the mistakes they found.
pub(crate) fn checked(tokens: TokenStream) -> (Option<Scene>, Vec<syn::Error>) {
    let mut report = Report::default();
    let scene = parse(tokens, &mut report).and_then(|request| check(request, &mut report));
    let errors = report.finish().err().map(|error| error.into_iter().collect());
    (scene, errors.unwrap_or_default())
}

/// The scene of a text without mistakes.
pub(crate) fn scene(text: &str) -> Scene {
    let (scene, errors) = checked(text.parse().unwrap());
    assert!(errors.is_empty(), "{text}: {errors:#?}");
    scene.unwrap()
}

/// Its motion, from a turning point to the other and back.
pub(crate) fn swing(scene: &Scene) -> &Swing {
    let Regime::Swing(swing) = &scene.motion.regime else { panic!("{:?} is no swing", scene.motion) };
    swing
}

/// `SplitMix64` (Steele, Lea and Flood 2014), whose every seed is a good one.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Below `n`, which is at least 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Between two integers, both included.
    pub(crate) fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as usize) as i64
    }

    /// True once in `n` times.
    pub(crate) fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// In [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn choose<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }
}
