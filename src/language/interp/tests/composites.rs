//! Arrays, structs, indices, pointers.

use super::*;

#[test]
fn structs_and_arrays_nest() {
    let source = "
        struct Key { direction: vec3<f32>, weight: f32 }
        struct Rig { keys: array<Key, 3>, on: bool, frame: mat2x2<f32> }
        fn f(rig: Rig, i: i32) -> Rig {
            var r = rig;
            r.keys[i].weight += 10.0;
            r.keys[2].direction.y = rig.keys[i].direction[i];
            r.on = !r.on;
            r.frame[1] = vec2(r.keys[0].weight, r.keys[1].weight);
            r.frame[0][i] = -1.0;
            return r;
        }";
    let key =
        |x: f64, weight: f64| Value::Struct(vec![[x, x + 1.0, x + 2.0].into(), weight.into()]);
    let rig = Value::Struct(vec![
        Value::Array(vec![key(1.0, 0.1), key(4.0, 0.2), key(7.0, 0.3)]),
        true.into(),
        Value::matrix(&[[0.0, 1.0], [2.0, 3.0]]),
    ]);
    let expected = Value::Struct(vec![
        Value::Array(vec![
            key(1.0, 0.1),
            key(4.0, 10.2),
            Value::Struct(vec![[7.0, 5.0, 9.0].into(), 0.3.into()]),
        ]),
        false.into(),
        Value::matrix(&[[0.0, -1.0], [0.1, 10.2]]),
    ]);
    assert_eq!(run(source, &[rig, 1.into()]), expected);
}

#[test]
fn indices_are_clamped() {
    let source = "fn f(a: array<f32, 3>, i: i32) -> f32 { var b = a; return b[i] + 10.0 * a[i]; }";
    let array = || Value::Array(vec![1.0.into(), 2.0.into(), 3.0.into()]);
    for (index, expected) in
        [(0, 11.0), (1, 22.0), (2, 33.0), (3, 33.0), (i32::MAX, 33.0), (-1, 33.0)]
    {
        assert_eq!(run(source, &[array(), index.into()]), expected.into());
    }
    let store = "fn f(i: u32) -> array<f32, 2> { var b = array(1.0, 2.0); b[i] = 9.0; return b; }";
    assert_eq!(run(store, &[7_u32.into()]), Value::Array(vec![1.0.into(), 9.0.into()]));
}

#[test]
fn dynamic_indices_of_every_composite() {
    let vector =
        |i: i32| eval("vec3<f32>; i32 -> f32", "a.zyx[b]", &[[1.0, 2.0, 3.0].into(), i.into()]);
    assert_eq!([vector(0), vector(1), vector(2)], [3.0.into(), 2.0.into(), 1.0.into()]);
    let source = "
        fn f(i: i32, j: i32) -> f32 {
            var m = mat3x2(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
            m[i][j] *= 100.0;
            var nested = array(array(1.0, 2.0), array(3.0, 4.0), array(5.0, 6.0));
            nested[i][j] += 0.5;
            let copy = nested;
            return m[i][j] + m[2][1] + copy[i][j];
        }";
    assert_eq!(run(source, &[1.into(), 0.into()]), (300.0 + 6.0 + 3.5).into());
    assert_eq!(run(source, &[2.into(), 1.into()]), (600.0 + 600.0 + 6.5).into());
}

#[test]
fn constants_of_the_module() {
    let source = "
        const SIDES = 3u;
        const TABLE = array<vec2<f32>, SIDES>(vec2(1.0, 2.0), vec2(3.0), vec2<f32>());
        const ROW = TABLE[1];
        struct Pair { a: i32, b: vec2<f32> }
        const PAIR = Pair(-5, ROW);
        fn f(i: u32) -> vec4<f32> { return vec4(TABLE[i], PAIR.b.x, f32(PAIR.a)); }";
    assert_eq!(run(source, &[0_u32.into()]), [1.0, 2.0, 3.0, -5.0].into());
    assert_eq!(run(source, &[2_u32.into()]), [0.0, 0.0, 3.0, -5.0].into());
}

#[test]
fn pointers_reach_the_callers_variables() {
    let source = "
        struct S { v: array<vec3<f32>, 2>, n: i32 }
        fn bump(p: ptr<function, f32>) { *p += 1.0; }
        fn fill(s: ptr<function, S>, i: i32) { (*s).v[i] = vec3(f32((*s).n)); (*s).n += 1; }
        fn twice(s: ptr<function, S>) { fill(s, 0); fill(s, 1); }
        fn f(x: f32) -> vec4<f32> {
            var a = x;
            bump(&a);
            bump(&a);
            var s: S;
            s.n = 5;
            twice(&s);
            let p = &s.v[1];
            (*p).y = a;
            return vec4(s.v[0].x, *p);
        }";
    assert_eq!(run(source, &[1.0.into()]), [5.0, 6.0, 3.0, 6.0].into());
}

#[test]
fn values_do_not_change_when_variables_do() {
    let source = "
        fn g(v: vec2<f32>) -> vec2<f32> { var w = v; w.x += 1.0; return w.yx; }
        fn f(a: vec2<f32>) -> array<vec2<f32>, 4> {
            var v = a;
            let before = v;
            v = v.yx;
            let between = v;
            v.x = 9.0;
            return array(before, between, g(v), g(g(v)));
        }";
    let expected = [[1.0, 2.0], [2.0, 1.0], [1.0, 10.0], [10.0, 2.0]].map(Value::from).to_vec();
    assert_eq!(run(source, &[[1.0, 2.0].into()]), Value::Array(expected));
}

#[test]
fn equality_of_results_needs_no_order_of_calls() {
    let source = "
        fn g(x: f32) -> f32 { return x * x; }
        fn f(a: f32, b: f32) -> f32 { return g(a) - g(b) * g(g(a) + g(b)); }";
    assert_eq!(run(source, &[2.0.into(), 3.0.into()]), (4.0 - 9.0 * 169.0).into());
}

#[test]
fn a_machine_starts_afresh() {
    let source = "
        fn f(n: i32) -> f32 {
            var sums: array<f32, 4>;
            var total: f32;
            for (var i = 0; i < n; i++) { var t: f32; t += 1.0; sums[i] += t; total += sums[i]; }
            return total + sums[0] + sums[3];
        }";
    let program = compile(source).unwrap();
    let mut machine = program.machine(Precision::F64);
    for (n, expected) in [(4, 6.0), (1, 2.0), (0, 0.0), (4, 6.0)] {
        assert_eq!(machine.call(&[n.into()]).unwrap(), expected.into());
    }
}

#[test]
fn entry_points_run_too() {
    let source = "
        struct Output { @location(0) color: vec4<f32> }
        @fragment fn shade(@location(0) uv: vec2<f32>) -> Output {
            return Output(vec4(uv, 0.0, 1.0));
        }";
    let program = Program::compile(&module(source), "shade", FunctionOptions::default()).unwrap();
    assert_eq!(program.parameters()[0].name, "uv");
    assert_eq!(program.parameters()[0].shape.to_string(), "vec2<f32>");
    assert_eq!(program.result().to_string(), "Output");
    let value = program.call(&[[0.25, 0.5].into()], Precision::F64).unwrap();
    assert_eq!(value.parts().unwrap()[0].as_vec(), Some([0.25, 0.5, 0.0, 1.0]));
    assert_eq!(value.to_string(), "{(0.25, 0.5, 0, 1)}");
}
