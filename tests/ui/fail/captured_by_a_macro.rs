use pendula::pendulum;

macro_rules! swing {
    ($theta0:expr, $n:literal) => {
        pendulum!(theta0 = $theta0, n = $n)
    };
}

fn main() {
    let _theta = swing!(5, 4);
    let _theta = swing!(1, 0);
}
