//! Attributes, documentation and visibility of the item are its user's own.

#![deny(warnings, missing_docs)]

mod inner {
    pub mod deeper {
        pendula::pendulum! {
            /// Seen by the parent only.
            #[derive(Clone, Copy, Debug, Default, Eq, Hash, Ord, PartialEq, PartialOrd)]
            #[must_use]
            #[non_exhaustive]
            pub(super) struct Parent;
            theta0 = 1, tol = 1e-3
        }
    }

    pub(crate) fn start() -> f64 {
        assert_eq!(format!("{:?}", deeper::Parent::default()), "Parent");
        deeper::Parent::theta(0.0)
    }
}

pendula::pendulum! {
    #[cfg(any())]
    struct Absent;
    theta0 = 1, tol = 1e-3
}

pendula::pendulum! {
    #[cfg_attr(not(any()), derive(Clone), cfg_attr(true, cfg(false)))]
    struct AbsentToo;
    theta0 = 1, tol = 1e-3
}

pendula::pendulum! {
    #[deprecated = "its own impl is no use of it"]
    pub(crate) struct Old;
    theta0 = 1, tol = 1e-3
}

fn main() {
    assert!((inner::start() - 1.0).abs() <= 1e-3);
}
