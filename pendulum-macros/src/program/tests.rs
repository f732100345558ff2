//! What each operation is, does, reads and costs.

use super::rounding::Known;
use super::*;

/// A program of one operation on constants, some of them in the other type.
fn run(float: Float, op: impl FnOnce(&mut Builder) -> Id) -> f64 {
    let mut b = Builder::new(float);
    let result = op(&mut b);
    b.finish(vec![result]).run(7.0)[0]
}

fn of_two(x: f64, y: f64, op: fn(Id, Id) -> Op) -> f64 {
    run(Float::F64, |b| {
        let (x, y) = (b.constant(x), b.constant(y));
        b.push(op(x, y))
    })
}

#[test]
fn operations_as_rust_has_them() {
    assert_eq!(run(Float::F64, Builder::input), 7.0);
    assert_eq!(of_two(3.0, 0.7, Op::Add), 3.7);
    assert_eq!(of_two(3.0, 0.7, Op::Sub), 3.0 - 0.7);
    assert_eq!(of_two(3.0, 0.7, Op::Mul), 3.0 * 0.7);
    assert_eq!(of_two(3.0, 0.7, Op::Div), 3.0 / 0.7);
    assert_eq!(of_two(-3.0, 0.7, |x, _| Op::Abs(x)), 3.0);
    assert!((of_two(3.0, 0.7, |x, _| Op::Root(x)) - 3f64.sqrt()).abs() <= 4.0 * f64::EPSILON);
    for (x, limit) in [(1.0, 2.0), (2.0, 1.0), (2.0, 2.0), (-1.0, 0.5)] {
        assert_eq!(of_two(x, limit, |x, limit| Op::Min { limit, x }), f64::min(x, limit));
        assert_eq!(of_two(x, limit, |x, limit| Op::Max { limit, x }), f64::max(x, limit));
        assert_eq!(
            of_two(x, limit, |a, b| Op::Select { a, b, then: a, otherwise: b }),
            if x < limit { x } else { limit }
        );
        assert_eq!(
            of_two(x, limit, |a, b| Op::Select { a, b, then: b, otherwise: a }),
            if x < limit { limit } else { x }
        );
    }
    // No number is below itself.
    assert_eq!(of_two(1.0, 2.0, |a, b| Op::Select { a, b: a, then: a, otherwise: b }), 2.0);
    // NaN passes, and is below nothing.
    assert!(of_two(f64::NAN, 1.0, |x, limit| Op::Min { limit, x }).is_nan());
    assert!(of_two(f64::NAN, 1.0, |x, limit| Op::Max { limit, x }).is_nan());
    for (sign, same) in [(2.0, 1.0), (-2.0, -1.0), (0.0, 1.0), (-0.0, -1.0)] {
        assert_eq!(of_two(5.0, sign, |x, sign| Op::Along { x, sign }), 5.0 * same);
        assert_eq!(of_two(-5.0, sign, |x, sign| Op::Along { x, sign }), -5.0 * same);
        assert_eq!(of_two(-5.0, sign, |magnitude, sign| Op::CopySign { magnitude, sign }), 5.0 * same);
    }
    assert_eq!(of_two(5.0, -1.0, |x, sign| Op::Against { x, sign }), 5.0);
    assert_eq!(of_two(5.0, 1.0, |x, sign| Op::Against { x, sign }), -5.0);
    assert_eq!(of_two(5.0, -0.0, |x, sign| Op::Against { x, sign }), 5.0);
    // 27 significant bits.
    assert_eq!(of_two(1.0 + f64::EPSILON + 2f64.powi(-26), 0.0, |x, _| Op::Head(x)), 1.0 + 2f64.powi(-26));
    assert_eq!(of_two(1.0 + 2f64.powi(-27), 0.0, |x, _| Op::Head(x)), 1.0);
}

#[test]
fn integers_in_sums() {
    for float in [Float::F64, Float::F32] {
        for n in [-3.0, -2.0, 0.0, 1.0, 2.0, 7.0] {
            let value = run(float, |b| {
                let (n, magic, x) = (b.constant(n), b.constant(float.magic()), b.constant(5.0));
                let magic = b.add(n, magic);
                b.push(Op::Alternate { x, magic, bit: 0 })
            });
            assert_eq!(value, if n % 2.0 == 0.0 { 5.0 } else { -5.0 }, "{float:?} {n}");
        }
        // Fours.
        for (n, sign) in [(3.0, 1.0), (4.0, -1.0), (7.0, -1.0), (8.0, 1.0), (-1.0, -1.0), (-4.0, -1.0), (-5.0, 1.0)] {
            let value = run(float, |b| {
                let (n, magic, x) = (b.constant(n), b.constant(float.magic()), b.constant(5.0));
                let magic = b.add(n, magic);
                b.push(Op::Alternate { x, magic, bit: 2 })
            });
            assert_eq!(value, 5.0 * sign, "{float:?} {n}");
        }
        // Rounded to the nearest integer, whatever the sign.
        for (x, n) in [(2.4, 2.0), (-2.6, -3.0), (0.5, 0.0), (1.5, 2.0)] {
            let rounded = run(float, |b| {
                let (x, magic) = (b.constant(x), b.constant(float.magic()));
                let sum = b.add(x, magic);
                b.sub(sum, magic)
            });
            assert_eq!(rounded, n, "{float:?} {x}");
        }
    }
    for n in [-1000.0, -1.0, 0.0, 5.0] {
        assert_eq!(of_two(n + Float::F64.magic(), 0.0, |magic, _| Op::PowerOfTwo { magic }), n.exp2());
    }
}

#[test]
fn types() {
    assert_eq!([Float::F64.rounding_unit(), Float::F32.rounding_unit()], [2f64.powi(-53), 2f64.powi(-24)]);
    assert_eq!([Float::F64.bits(), Float::F32.bits()], [53, 24]);
    assert_eq!([Float::F64.magic(), Float::F32.magic()], [1.5 * 2f64.powi(52), 1.5 * 2f64.powi(23)]);
    // Every operation is rounded to its type.
    let third = run(Float::F32, |b| {
        let (x, y) = (b.constant(1.0), b.constant(3.0));
        b.div(x, y)
    });
    assert_eq!(third, f64::from(1.0f32 / 3.0));
    let root = run(Float::F32, |b| {
        let x = b.constant(2.0);
        b.push(Op::Root(x))
    });
    assert_eq!(root, f64::from(2f32.sqrt()));
    // There and back; nothing where it is of that type already.
    let mut b = Builder::new(Float::F32);
    let t = b.input();
    assert_eq!(b.convert(t, Float::F32), t);
    let wide = b.convert(t, Float::F64);
    let third = b.rounded(Double { hi: 1.0 / 3.0, lo: 1e-20 });
    let product = b.mul(wide, third);
    let narrow = b.convert(product, Float::F32);
    assert_eq!(b.float(), Float::F32);
    let program = b.finish(vec![narrow]);
    assert_eq!(program.run(7.0)[0], f64::from((7.0 / 3.0) as f32));
    assert_eq!(program.nodes.iter().map(|node| node.float).filter(|&float| float == Float::F64).count(), 3);
}

/// Constants keep what they are off.
#[test]
fn constants() {
    let rest = |float, constant: fn(&mut Builder) -> Id| {
        let mut b = Builder::new(float);
        let id = constant(&mut b);
        match b.finish(vec![id]).nodes[0].op {
            Op::Constant { value, rest } => (value, rest),
            other => panic!("{other:?}"),
        }
    };
    let tenth = f64::from(0.1f32);
    assert_eq!(rest(Float::F64, |b| b.rounded(Double { hi: 0.1, lo: 1e-20 })), (0.1, 1e-20));
    assert_eq!(rest(Float::F32, |b| b.rounded(Double { hi: 0.1, lo: 1e-12 })), (tenth, (0.1 - tenth) + 1e-12));
    assert_eq!(rest(Float::F32, |b| b.loose(0.1, 1e-12)), (tenth, (0.1 - tenth).abs() + 1e-12));
    assert_eq!(rest(Float::F64, |b| b.constant(0.1)), (0.1, 0.0));
}

/// Shared operations are there once, and those that no result needs not at all.
#[test]
fn sharing_and_pruning() {
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    let (one, two) = (b.constant(1.0), b.constant(2.0));
    let unused = b.mul(t, two);
    let sum = b.add(t, one);
    assert_eq!(b.add(t, one), sum);
    assert_ne!(b.sub(t, one), sum);
    b.name(sum, "sum");
    let select = b.push(Op::Select { a: t, b: one, then: sum, otherwise: t });
    let (total, lost) = b.two_sum(select, sum);
    let _ = unused;
    let program = b.finish(vec![total, lost]);
    assert_eq!(program.nodes.iter().filter(|node| matches!(node.op, Op::Mul(..))).count(), 0);
    assert_eq!(program.named("sum").map(|id| program.nodes[id].op), Some(Op::Add(0, 1)));
    assert_eq!(program.named("none"), None);
    // t = ½: 1.5 + 1.5; of 2⁶⁰ the 1 is lost in both sums, and t + t exact.
    assert_eq!(program.run(0.5), [3.0, 0.0]);
    assert_eq!(program.run(2f64.powi(60)), [2f64.powi(61), 0.0]);
    // What a sum loses.
    let lost = |x: f64, y: f64| {
        let mut b = Builder::new(Float::F64);
        let (x, y) = (b.constant(x), b.constant(y));
        let (sum, lost) = b.two_sum(x, y);
        b.finish(vec![sum, lost]).run(0.0)
    };
    assert_eq!(lost(1.0, 2f64.powi(-60)), [1.0, 2f64.powi(-60)]);
    assert_eq!(lost(2f64.powi(-60), -1.0), [-1.0, 2f64.powi(-60)]);
}

/// Every operation's operands are kept, and renamed, when nodes before them go.
#[test]
fn operands() {
    let ops = [
        Op::Add(1, 2),
        Op::Sub(1, 2),
        Op::Mul(1, 2),
        Op::Div(1, 2),
        Op::Root(1),
        Op::Abs(1),
        Op::Head(1),
        Op::Widen(1),
        Op::Narrow(1),
        Op::Min { limit: 1, x: 2 },
        Op::Max { limit: 1, x: 2 },
        Op::Select { a: 1, b: 2, then: 3, otherwise: 4 },
        Op::Alternate { x: 1, magic: 2, bit: 3 },
        Op::CopySign { magnitude: 1, sign: 2 },
        Op::Along { x: 1, sign: 2 },
        Op::Against { x: 1, sign: 2 },
        Op::PowerOfTwo { magic: 1 },
        Op::Row { magic: 1 },
        Op::Entry { row: 1, column: 7 },
    ];
    for op in ops {
        let node = |op| Node { op, float: Float::F64, name: None };
        let constants = (0..5).map(|value| node(Op::Constant { value: f64::from(value), rest: 0.0 }));
        // Node 0 is unused.
        let (nodes, table) = (constants.chain([node(op)]).collect(), Vec::new());
        let program = Program { nodes, results: vec![5], table }.pruned();
        let (result, used) = program.nodes.split_last().unwrap();
        let (mut values, mut before) = (Vec::new(), Vec::new());
        result.op.each_operand(|id| match used[id].op {
            Op::Constant { value, .. } => values.push(value),
            other => panic!("{other:?}"),
        });
        op.each_operand(|id| before.push(id as f64));
        assert_eq!(values, before, "{op:?}");
        assert_eq!(program.results, [used.len()], "{op:?}");
        assert_eq!(used.len(), before.len(), "{op:?}");
    }
}

/// What comes before given nodes goes, and what is known of these tells the same of the results.
#[test]
fn after_given_nodes() {
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    let (third, seventh) = (b.constant(1.0 / 3.0), b.constant(1.0 / 7.0));
    let x = b.mul(t, third);
    let x = b.add(x, seventh);
    b.name(x, "x");
    let square = b.mul(x, x);
    let result = b.add(square, third);
    let program = b.finish(vec![result]);
    let rest = program.after(&[program.named("x").unwrap()]);
    let given = |program: &Program| program.rounding(&[(program.named("x").unwrap(), Known::between(0.5, 0.75))]);
    assert_eq!(given(&rest), given(&program));
    let ops: Vec<Op> = rest.nodes.iter().map(|node| node.op).collect();
    assert_eq!(ops, [program.nodes[third].op, Op::Input, Op::Mul(1, 1), Op::Add(2, 0)]);
    assert_eq!(program.after(&program.results).nodes.len(), 1);
}

/// A sum of two products costs 3, in `f32` where it is wide twice that; constants and the input nothing.
#[test]
fn costs() {
    let mut b = Builder::new(Float::F32);
    let t = b.input();
    let c = b.constant(2.0);
    let square = b.mul(t, t);
    let wide = b.convert(square, Float::F64);
    let more = b.add(wide, wide);
    let narrow = b.convert(more, Float::F32);
    let scaled = b.mul(narrow, c);
    let program = b.finish(vec![scaled]);
    assert_eq!(program.operations(), 5);
    // Two products, an addition of twice as many bits, two conversions of which one has a wide result.
    assert_eq!(program.cost(), 1.0 + 4.0 + 2.0 + 2.0 + 1.0);
    // In the order of what they were measured to cost.
    let cost = |op: fn(Id, Id) -> Op| {
        let mut b = Builder::new(Float::F64);
        let (x, y) = (b.input(), b.constant(3.0));
        let result = b.push(op(x, y));
        b.finish(vec![result]).cost()
    };
    let free = 0.0;
    let dearer = [free, cost(Op::Add), cost(|x, limit| Op::Min { limit, x }), cost(|x, _| Op::Widen(x)), cost(Op::Div)];
    let dearest = [cost(Op::Div), cost(|a, b| Op::Select { a, b, then: a, otherwise: b }), cost(|x, _| Op::Root(x))];
    assert!(dearer.is_sorted() && dearest.is_sorted() && dearer[1] > 0.0 && dearest[2] > 10.0 * dearest[1]);
    assert_eq!(cost(|x, limit| Op::Max { limit, x }), cost(|x, sign| Op::Against { x, sign }));
    assert_eq!([cost(Op::Mul), cost(Op::Sub)], [1.0, 1.0]);
}

/// Of a table of 2 and 5, and 3 and 7, the row that is the parity of t: 2 + 5t or 3 + 7t. What isn't looked up isn't kept.
#[test]
fn tables() {
    let rows = [[2.0, 5.0], [3.0, 7.0]].map(|row| row.map(Double::new).to_vec());
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    let magic = b.constant(Float::F64.magic());
    let magic = b.add(t, magic);
    let entries = b.look_up(&rows, magic);
    let product = b.mul(entries[1], t);
    let sum = b.add(entries[0], product);
    let program = b.clone().finish(vec![sum]);
    assert_eq!([-2.0, -1.0, 0.0, 1.0, 6.0].map(|t| program.run(t)[0]), [-8.0, -4.0, 2.0, 10.0, 32.0]);
    assert!(program.run(f64::NAN)[0].is_nan());
    assert_eq!(program.operations(), 4);
    // A loop over an array takes them one by one.
    let mut vectorised = program.clone();
    vectorised.table = Vec::new();
    let lost = program.cost() / vectorised.cost();
    assert!(lost > 1.0);
    // Which is one of the three ways of calling it.
    let mean = program.cost_of_calls_too() / vectorised.cost_of_calls_too();
    assert!((mean.powi(3) / lost - 1.0).abs() < 1e-14, "{mean} {lost}");
    let without = b.finish(vec![product]);
    assert_eq!((without.table.len(), unused_table().table.len()), (2, 0));
    // What is known of the row is known of its numbers.
    let known: Vec<(Id, Known)> = (0..program.nodes.len())
        .filter_map(|id| match program.nodes[id].op {
            Op::Input => Some((id, Known::between(-1.0, 1.0))),
            Op::Entry { column, .. } => Some((id, Known::within(rows[1][column].hi, rows[1][column].hi, 1e-20))),
            _ => None,
        })
        .collect();
    let result = program.rounding(&known)[0];
    assert!(result.low <= -4.0 && result.high >= 10.0 && (5e-16..2e-15).contains(&result.error), "{result:?}");
}

/// A program that makes a table and doesn't use it.
fn unused_table() -> Program {
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    b.look_up(&[vec![Double::ONE], vec![Double::ONE]], t);
    b.finish(vec![t])
}
