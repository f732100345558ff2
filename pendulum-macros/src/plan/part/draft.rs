//! Kernels that are made, and whose rounding is analysed, once, though a search asks for them again: for another part of
//! their limit, or by another way.

use crate::plan::form::Variant;
use crate::plan::kernel::Kernel;
use crate::plan::memo::Memo;
use crate::plan::reduction::Reduction;
use std::cell::Cell;
use std::rc::Rc;

/// An output's drafts, or what was reached where there is none.
pub(in crate::plan) type Drafts = Memo<Brief, Result<Rc<Draft>, f64>>;

/// What is asked for.
#[derive(PartialEq)]
pub(in crate::plan) struct Brief {
    /// Of polynomials; `None` of the passage.
    pub(super) variant: Option<Variant>,
    pub(super) reduction: Reduction,
    /// What is left for its truncation.
    pub(super) left: f64,
}

/// A kernel of which it isn't known whether it keeps the promise.
pub(in crate::plan) struct Draft {
    pub(super) kernel: Kernel,
    pub(super) truncation: f64,
    rounding: Cell<Option<Rounding>>,
}

#[derive(Clone, Copy)]
struct Rounding {
    bound: f64,
    cap: f64,
}

impl Rounding {
    /// Whether it stands under another cap: if it wasn't cut short, or would be again.
    fn stands_under(&self, cap: f64) -> bool {
        self.bound <= self.cap || self.bound > cap
    }
}

impl Draft {
    pub(super) fn new(kernel: Kernel, truncation: f64) -> Self {
        Self { kernel, truncation, rounding: Cell::default() }
    }

    /// As [`Kernel::rounding`].
    pub(super) fn rounding(&self, reduction: &Reduction, cap: f64) -> f64 {
        let known = self.rounding.get().filter(|known| known.stands_under(cap));
        known.map_or_else(
            || {
                let bound = self.kernel.rounding(reduction, cap);
                self.rounding.set(Some(Rounding { bound, cap }));
                bound
            },
            |known| known.bound,
        )
    }
}
