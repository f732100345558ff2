use pendula::pendulum;

fn main() {
    // What the planner refuses is told beside other mistakes.
    let _overshoot: fn(f64) -> f64 = pendulum!(theta0 = 0.95π, n = 2, colour = 3);
    let _overshoot_at_no_time: fn(f64) -> f64 = pendulum!(theta0 = 0.95π, n = 2, t_max = -1);
    let _out_of_reach: fn(f64) -> f64 = pendulum!(theta0 = 1, tol = 1e-30, colour = 3);
    // But not what might be in reach of what was meant.
    let _in_reach_for_a_moment: fn(f64) -> f64 = pendulum!(theta0 = 1, tol = 1e-20, tmax = 1e-9);
}
