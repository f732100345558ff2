use pendula::pendulum;

pendulum! { struct Colon; theta0 = 1, float: f32 }
pendulum! { struct Lone; theta0 = 1, f32 }
pendulum! { struct Synonym; theta0 = 1, float = single }

fn main() {
    let _: [f32; 3] = [Colon::theta(1.0f32), Lone::theta(1.0f32), Synonym::theta(1.0f32)];
}
