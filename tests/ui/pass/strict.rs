//! The strictest lints of rustc that generated code has to live with.

#![deny(warnings)]
#![deny(missing_docs, missing_debug_implementations, missing_copy_implementations)]
#![deny(unreachable_pub, unused_qualifications, unused_results, trivial_casts, trivial_numeric_casts)]
#![deny(rust_2018_idioms, future_incompatible, nonstandard_style, let_underscore_drop, unused_lifetimes)]
#![forbid(unsafe_code)]

pub mod motions {
    //! One of each kind of plan.

    pendula::pendulum! {
        /// The paper's own approximation, whose constants nobody uses.
        #[derive(Clone, Copy, Debug)]
        pub struct Paper;
        theta0 = 7π/8, n = 4, outputs = [theta, velocity]
    }

    pendula::pendulum! {
        /// Every output, at any time.
        #[derive(Clone, Copy, Debug)]
        pub struct Everything;
        theta0 = 100deg, g = 9.81, length = 0.994, outputs = [theta, velocity, acceleration, position]
    }

    pendula::pendulum! {
        /// Single precision, short horizon.
        #[derive(Clone, Copy, Debug)]
        pub struct Narrow;
        theta0 = -1, velocity0 = 1, float = f32, tol = 1e-4, t_max = 100,
        outputs = [theta, velocity, acceleration, position]
    }

    pendula::pendulum! {
        /// Single precision at any time.
        #[derive(Clone, Copy, Debug)]
        pub struct NarrowAnyTime;
        theta0 = 2, float = f32
    }

    pendula::pendulum! {
        /// The series of θ itself.
        #[derive(Clone, Copy, Debug)]
        pub struct Series;
        theta0 = 1π/2, tol = 1e-6, method = series
    }

    pendula::pendulum! {
        /// Nothing but the attribute says so.
        #[deprecated]
        #[derive(Clone, Copy, Debug)]
        pub struct Old;
        theta0 = 1, tol = 1e-6
    }

    pendula::pendulum! {
        /// Nor does a condition.
        #[cfg_attr(all(), deprecated)]
        #[derive(Clone, Copy, Debug)]
        pub struct Older;
        theta0 = 1, tol = 1e-6
    }
}

fn main() {
    let theta = pendula::pendulum!(theta0 = 2.5, tol = 1e-9);
    assert!(theta(0.0) > 2.4);
    assert!(motions::Everything::position(0.0).1 > 0.17);
}
