//! Branches, loops, switches, calls.

use super::*;

#[test]
fn branches() {
    let source = "
        fn f(x: f32) -> i32 {
            if (x < 0.0) { return -1; } else if (x == 0.0) { return 0; }
            var r = 1;
            if (x > 10.0) { r = 2; } else { if (x > 5.0) { r = 3; } }
            return r;
        }";
    for (x, expected) in [(-1.0, -1), (0.0, 0), (1.0, 1), (7.0, 3), (11.0, 2)] {
        assert_eq!(run(source, &[x.into()]), expected.into());
    }
}

#[test]
fn logical_operators_stop_early() {
    let source = "
        fn forever() -> bool { loop { if (false) { break; } } return true; }
        fn f(a: bool) -> bool { return (a || forever()) && !(!a && forever()); }";
    assert_eq!(run(source, &[true.into()]), true.into());
}

#[test]
fn loops_with_everything() {
    let source = "
        fn f(n: i32) -> vec3<i32> {
            var i = 0;
            var even = 0;
            var seen = 0;
            loop {
                seen += 1;
                if (i % 2 == 1) { continue; }
                if (i == 100) { break; }
                even += i;
                continuing {
                    i += 1;
                    break if i >= n;
                }
            }
            return vec3(i, even, seen);
        }";
    assert_eq!(run(source, &[10.into()]), Value::ivec(&[10, 20, 10]));
    assert_eq!(run(source, &[0.into()]), Value::ivec(&[1, 0, 1]));
    assert_eq!(run(source, &[1000.into()]), Value::ivec(&[100, 2450, 101]));
}

#[test]
fn nested_loops_and_early_return() {
    let source = "
        fn f(target_product: i32) -> vec2<i32> {
            for (var i = 1; i < 50; i++) {
                var j = 1;
                while (j <= i) {
                    if (i * j == target_product) { return vec2(i, j); }
                    if (j > 20) { break; }
                    j++;
                }
            }
            return vec2(-1);
        }";
    assert_eq!(run(source, &[91.into()]), Value::ivec(&[13, 7]));
    assert_eq!(run(source, &[53.into()]), Value::ivec(&[-1, -1]));
}

#[test]
fn variables_of_a_loop_start_anew() {
    let source = "
        fn f(n: i32) -> i32 {
            var total = 0;
            for (var i = 0; i < n; i++) {
                var fresh: i32;
                var five = 5;
                fresh += 1;
                five += fresh;
                total += five;
            }
            return total;
        }";
    assert_eq!(run(source, &[4.into()]), 24.into());
}

#[test]
fn switches() {
    let source = "
        fn f(x: i32) -> i32 {
            var r = 0;
            for (var i = 0; i < 3; i++) {
                switch (x) {
                    case 1: { r += 10; }
                    case -2, 3: { r += 20; if (i == 1) { break; } r += 1; }
                    case 4: { if (i == 0) { continue; } r += 100; }
                    case 5, default: { return -7; }
                }
                r += 1000;
            }
            return r;
        }";
    for (x, expected) in [(1, 3030), (-2, 3062), (3, 3062), (4, 2200), (5, -7), (99, -7)] {
        assert_eq!(run(source, &[x.into()]), expected.into(), "{x}");
    }
    let unsigned =
        "fn f(x: u32) -> i32 { switch x { default { return 0; } case 4000000000u { return 1; } } }";
    assert_eq!(run(unsigned, &[4_000_000_000_u32.into()]), 1.into());
    assert_eq!(run(unsigned, &[1_u32.into()]), 0.into());
}

#[test]
fn calls_of_calls() {
    let source = "
        fn f(x: f32) -> f32 { return h(g(x), g(x + 1.0)) + k(x).y; }
        fn g(x: f32) -> f32 { if (x > 1.0) { return x * 2.0; } return k(x).x; }
        fn h(a: f32, b: f32) -> f32 { return a * 10.0 + g(b); }
        fn k(x: f32) -> vec2<f32> { nothing(); return vec2(x + 100.0, x); }
        fn nothing() { }";
    // g(1) = 101, g(2) = 4, h = 1010 + g(4) = 1018, k(1).y = 1
    assert_eq!(run(source, &[1.0.into()]), 1019.0.into());
}

#[test]
fn else_if_chains_may_be_long() {
    let chain: String =
        (0..100).map(|i| format!("if (x == {i}) {{ return {}; }} else ", i * i)).collect();
    let source = format!("fn f(x: i32) -> i32 {{ {chain} {{ }} return -1; }}");
    assert_eq!(run(&source, &[99.into()]), 9801.into());
    assert_eq!(run(&source, &[100.into()]), (-1).into());
}
