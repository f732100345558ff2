//! A position from sin(θ/2) and cos(θ/2) in pieces, squared.

use super::Pieces;
use crate::plan::kernel::squared;
use crate::program::{Builder, Id};

/// sin(θ/2) and cos(θ/2), in as many pieces.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Halves {
    pub(crate) sine: Pieces,
    pub(crate) cosine: Pieces,
}

impl Halves {
    /// Emits the position.
    pub(crate) fn lower(&self, b: &mut Builder) -> Vec<Id> {
        let Self { sine, cosine } = self;
        let (half_sine, magic) = sine.within_anchor(b, "half_sine");
        let (half_cosine, _) = cosine.within_anchor(b, "half_cosine");
        let [x, y] = squared(b, half_sine, half_cosine);
        // Where both change their sign neither coordinate does.
        vec![if sine.alternates == cosine.alternates { x } else { sine.alternate(b, x, magic) }, y]
    }

    pub(crate) fn rounding(&self) -> f64 {
        let mut b = Builder::new(self.sine.reduction.float);
        let position = self.lower(&mut b);
        self.sine.rounding_of(&b.finish(position))
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let Self { sine, cosine } = self;
        format!("sin(θ/2) by {}, cos(θ/2) by as many of {}, squared", sine.describe(), cosine.terms())
    }
}
