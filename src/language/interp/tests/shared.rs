//! Calls that lanes share, against single calls.

use super::super::{Bindings, LANES};
use super::lanes::{bind, stage};
use super::*;

/// Runs `f` of two i32 in lanes, batch after batch on the same memory, and compares with single
/// calls; returns the steps of each batch.
fn hold(source: &str, batches: &[&dyn Fn(i32) -> [i32; 2]]) -> Vec<u64> {
    let program = stage(source, "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let (mut lanes, mut machine) = (bound.lanes().unwrap(), program.machine(Precision::F64));
    let mut steps = Vec::new();
    for (number, batch) in batches.iter().enumerate() {
        let arguments = (0..LANES).map(|lane| batch(lane as i32).map(Value::from));
        arguments
            .clone()
            .enumerate()
            .for_each(|(lane, arguments)| lanes.set(lane, &arguments).unwrap());
        // Some batches leave lanes out.
        let count = LANES - 4 * (number % 3);
        steps.push(lanes.run(count).unwrap_or_else(|e| panic!("{e}")).steps);
        for (lane, arguments) in arguments.take(count).enumerate() {
            assert_eq!(
                lanes.get(lane),
                machine.call(&arguments).unwrap(),
                "batch {number}, lane {lane}"
            );
        }
    }
    steps
}

/// Nested calls, in all lanes and in some, with the same arguments and with others.
#[test]
fn lanes_that_share_a_call_get_what_single_calls_get() {
    let source = "
        fn inner(n: i32, k: i32) -> i32 {
            var sum = k;
            for (var i = 0; i < n; i++) { sum = sum * 3 + i; }
            return sum;
        }
        fn work(n: i32, k: i32) -> vec2i { return vec2i(inner(n, k), inner(n + 1, k)); }
        fn f(a: i32, n: i32) -> i32 {
            let x = work(n, 2);
            var y = vec2i(0);
            if a % 3 == 0 { y = work(n, a % 3); } else { y = work(5, a); }
            let z = inner(n, x.y);
            return x.x + 7 * y.x + y.y + z;
        }";
    let alike = |a| [a, 11];
    let steps = hold(
        source,
        &[&alike, &alike, &|a| [a, 12], &|a| [a, a % 9], &alike, &|_| [6, 3], &|a| [a, a / 32]],
    );
    assert!(2 * steps[1] < steps[0], "the second batch has nothing new to do: {steps:?}");
}

#[test]
fn what_remembers_or_asks_its_neighbors_is_not_shared() {
    let source = "
        var<private> count: i32;
        fn grow(n: i32) -> i32 {
            for (var i = 0; i < n; i++) { count += i + 1; }
            return count;
        }
        fn slope(n: i32) -> i32 {
            var sum = 0.0;
            for (var i = 0; i < n; i++) { sum += dpdx(f32(count)); }
            return i32(sum);
        }
        fn add(to: ptr<function, i32>, n: i32) {
            for (var i = 0; i < n; i++) { *to += i; }
        }
        fn f(a: i32, n: i32) -> i32 {
            let first = grow(n);
            var sum = a;
            add(&sum, n);
            add(&sum, n);
            return first + 10 * grow(n) + 100 * sum;
        }";
    hold(source, &[&|a| [a, 4], &|a| [a, 4], &|_| [2, 4]]);
    let sloped =
        source.replace("let first = grow(n);", "count = a * a; let first = slope(n); count = 0;");
    let program = stage(&sloped, "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    (0..LANES).for_each(|lane| lanes.set(lane, &[(lane as i32).into(), 3.into()]).unwrap());
    lanes.run(LANES).unwrap();
    for lane in 0..LANES as i32 {
        // (2 k + 1)^2 - (2 k)^2 = 4 k + 1, three times; grow(3) is 6, two additions of 3.
        let wanted = 3 * (4 * (lane / 2) + 1) + 60 + 100 * (lane + 6);
        assert_eq!(lanes.get(lane as usize), wanted.into(), "lane {lane}");
    }
}

/// Arguments are compared by their bits: NaN is the same as itself, and 0 is not -0.
#[test]
fn arguments_are_the_same_by_their_bits() {
    let source = "
        fn work(x: f32) -> f32 {
            var sum = 0.0;
            for (var i = 0; i < 3; i++) { sum += 1.0 / x; }
            return sum;
        }
        fn f(x: f32) -> f32 { return work(x); }";
    let program = stage(source, "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    for (x, wanted) in
        [(0.0, f64::INFINITY), (-0.0, f64::NEG_INFINITY), (f64::NAN, f64::NAN), (2.0, 1.5)]
    {
        (0..LANES).for_each(|lane| lanes.set(lane, &[x.into()]).unwrap());
        lanes.run(LANES).unwrap();
        assert_eq!(lanes.get(5).as_f64().unwrap().to_bits(), wanted.to_bits(), "of {x}");
    }
}
