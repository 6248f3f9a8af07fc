//! Many lanes at once, against closed forms and against one call after the other.

use super::super::{Bindings, BoundProgram, LANES, Lanes};
use super::*;

pub(super) fn stage(source: &str, function: &str) -> Program {
    let literals = Literals::of(source);
    Program::compile(&module(source), function, FunctionOptions::stage(&literals))
        .unwrap_or_else(|e| panic!("{e}"))
}

pub(super) fn bind<'p>(
    program: &'p Program,
    bindings: &Bindings,
    precision: Precision,
) -> BoundProgram<'p> {
    program.bind(bindings, precision).unwrap_or_else(|problems| panic!("{}", problems[0]))
}

/// Runs `f` with the arguments of each lane, and returns the result of each.
fn run_lanes(source: &str, arguments: &[Vec<Value>]) -> Vec<Value> {
    let program = stage(source, "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    run_batch(&mut lanes, arguments)
}

fn run_batch(lanes: &mut Lanes<'_>, arguments: &[Vec<Value>]) -> Vec<Value> {
    arguments.iter().enumerate().for_each(|(lane, arguments)| lanes.set(lane, arguments).unwrap());
    lanes.run(arguments.len()).unwrap_or_else(|e| panic!("{e}"));
    (0..arguments.len()).map(|lane| lanes.get(lane)).collect()
}

/// Runs `f` of one i32 for each number.
fn each(source: &str, numbers: impl Iterator<Item = i32>) -> Vec<i32> {
    let arguments: Vec<Vec<Value>> = numbers.map(|i| vec![i.into()]).collect();
    let results = run_lanes(source, &arguments);
    results.iter().map(|value| value.as_f64().unwrap() as i32).collect()
}

#[test]
fn derivatives_are_differences_within_a_quad() {
    // The differences of x^2 + 3 x y - y from (x, y) to (x + 1, y) and (x, y + 1) are 2 x + 1 + 3 y
    // and 3 x - 1.
    let source = "
        @fragment fn f(@builtin(position) p: vec4f) -> @location(0) vec4f {
            let q = p.x * p.x + 3.0 * p.x * p.y - p.y;
            return vec4f(dpdxFine(q), dpdyFine(q), fwidthFine(q), dpdx(7.0 * p.x) + dpdy(p.y));
        }";
    let coarse = source.replace("Fine(q)", "Coarse(q)");
    let at = |lane: usize| ((lane / 4 * 2 + lane % 2) as f64, (10 + lane % 4 / 2) as f64);
    for (source, is_coarse) in [(source, false), (coarse.as_str(), true)] {
        let program = stage(source, "f");
        let bound = bind(&program, &Bindings::new(), Precision::F64);
        let mut lanes = bound.lanes().unwrap();
        let position = &program.inputs()[0];
        assert_eq!(position.builtin(), Some(naga::BuiltIn::Position { invariant: false }));
        lanes.write(position, 0, &std::array::from_fn::<f64, LANES, _>(|lane| at(lane).0));
        lanes.write(position, 1, &std::array::from_fn::<f64, LANES, _>(|lane| at(lane).1));
        lanes.run(LANES).unwrap();
        for lane in 0..LANES {
            let (x, y) = at(lane);
            // Corner that the differences start from.
            let (x0, y0) = (f64::from(lane as u32 / 4 * 2), 10.0);
            let (x, y) = if is_coarse { (x0, y0) } else { (x, y) };
            let (dx, dy) = (2.0 * x0 + 1.0 + 3.0 * y, 3.0 * x - 1.0);
            assert_eq!(lanes.get(lane), [dx, dy, dx.abs() + dy.abs(), 8.0].into(), "lane {lane}");
        }
    }
}

#[test]
fn every_lane_loops_as_often_as_it_should() {
    let source = "
        fn f(n: i32) -> i32 {
            var sum = 0;
            for (var i = 0; i < n; i++) {
                if i % 3 == 1 { continue; }
                if sum > 100 { break; }
                for (var j = i; j > 0; j /= 2) { sum += j; }
            }
            return sum;
        }";
    let expected = |n: i32| {
        let mut sum = 0;
        for i in (0..n).filter(|i| i % 3 != 1) {
            if sum > 100 {
                break;
            }
            sum +=
                std::iter::successors(Some(i), |j| Some(j / 2)).take_while(|j| *j > 0).sum::<i32>();
        }
        sum
    };
    let numbers = || (0..LANES as i32).map(|i| i * 37 % 41);
    assert_eq!(each(source, numbers()), numbers().map(expected).collect::<Vec<_>>());
}

#[test]
fn loops_end_in_their_continuing_part() {
    let source = "
        fn f(n: i32) -> i32 {
            var i = 0;
            var sum = 0;
            loop {
                if i == 5 { break; }
                sum += 10;
                continuing { i += 1; sum += i; break if i >= n; }
            }
            return sum;
        }";
    let expected = |n: i32| {
        let rounds = n.clamp(1, 5);
        10 * rounds + rounds * (rounds + 1) / 2
    };
    assert_eq!(each(source, 0..9), (0..9).map(expected).collect::<Vec<_>>());
}

#[test]
fn lanes_part_in_switches_and_returns() {
    let source = "
        fn g(i: i32) -> i32 {
            switch i {
                case 0, 3: { return 100; }
                case 1: { if i == 1 { break; } return -1; }
                case -7: { return 7; }
                default: { return i; }
            }
            return 50;
        }
        fn f(i: i32) -> i32 {
            if i > 40 { return g(i - 41) + g(3); }
            var r = g(i % 5);
            if i % 2 == 0 { r += g(1); } else { r -= g(-7); }
            return r;
        }";
    let g = |i: i32| match i {
        0 | 3 => 100,
        1 => 50,
        -7 => 7,
        _ => i,
    };
    let expected = |i: i32| match i {
        41.. => g(i - 41) + g(3),
        _ if i % 2 == 0 => g(i % 5) + g(1),
        _ => g(i % 5) - g(-7),
    };
    assert_eq!(each(source, 0..64), (0..64).map(expected).collect::<Vec<_>>());
}

#[test]
fn variables_and_pointers_are_each_lanes_own() {
    let source = "
        var<private> calls: i32 = 5;
        fn bump(p: ptr<function, i32>, by: i32) { *p += by; calls += 1; }
        fn swap(a: ptr<private, i32>, b: ptr<function, array<i32, 4>>, i: i32) \
        { let t = *a; *a = (*b)[i]; (*b)[i] = t; }
        fn f(i: i32) -> i32 {
            var a = array<i32, 4>(i, i * 2, i * 3, i * 4);
            for (var j = 0; j < i % 4; j++) { bump(&a[j], 100); }
            if i % 2 == 1 { swap(&calls, &a, i % 4); }
            return a[i % 4] * 10 + calls;
        }";
    let expected = |i: i32| {
        let mut a = [i, i * 2, i * 3, i * 4];
        let place = (i % 4) as usize;
        let mut calls = 5;
        for x in &mut a[..place] {
            *x += 100;
            calls += 1;
        }
        if i % 2 == 1 {
            std::mem::swap(&mut calls, &mut a[place]);
        }
        a[place] * 10 + calls
    };
    assert_eq!(each(source, 0..64), (0..64).map(expected).collect::<Vec<_>>());
    // Private variables begin anew with every batch.
    let program = stage(source, "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    let arguments = vec![vec![Value::I32(7)]; 4];
    assert_eq!(run_batch(&mut lanes, &arguments), run_batch(&mut lanes, &arguments));
}

#[test]
fn discarded_lanes_are_told_and_go_on_helping() {
    let source = "
        fn cut(x: f32) { if x > 10.0 { discard; } }
        @fragment fn f(@location(0) x: f32) -> @location(0) f32 { cut(x); return dpdx(x * x); }";
    let program = stage(source, "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    let x = &program.inputs()[0];
    assert_eq!((x.location(), x.name.as_str()), (Some(0), "x"));
    lanes.write(x, 0, &[10.0, 11.0, 12.0, 13.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(lanes.run(8).unwrap().discarded, 0b1110);
    let mut results = [0.0; 8];
    lanes.read(&program.outputs()[0], 0, &mut results);
    assert_eq!((results[0], &results[4..]), (21.0, &[3.0, 3.0, 7.0, 7.0][..]));
    lanes.write(x, 0, &[20.0; 4]);
    assert_eq!(lanes.run(4).unwrap().discarded, 0b1111);
    assert_eq!(lanes.run(0).unwrap().discarded, 0);
}

#[test]
fn endless_lanes_are_given_up() {
    let source = "fn f(x: i32) -> i32 { var i = x; while (i >= 0) { i ^= 1; } return i; }";
    let literals = Literals::of(source);
    let options = FunctionOptions::stage(&literals);
    // Stages are given up within seconds; a nearer end is reached in the same way.
    assert!(options.step_limit <= 1 << 29, "{}", options.step_limit);
    let options = FunctionOptions { step_limit: 1 << 20, ..options };
    let program = Program::compile(&module(source), "f", options).unwrap();
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    let mut lanes = bound.lanes().unwrap();
    for (lane, x) in [-1, -5, 3, -7].into_iter().enumerate() {
        lanes.set(lane, &[x.into()]).unwrap();
    }
    assert_eq!(lanes.run(4).unwrap_err().code, "interp-endless");
    lanes.set(2, &[(-2).into()]).unwrap();
    lanes.run(4).unwrap();
    assert_eq!(lanes.get(2), (-2).into());
}

#[test]
fn lanes_take_a_bounded_memory() {
    let program = stage("fn f(i: i32) -> f32 { var a: array<f32, 2000000>; return a[i]; }", "f");
    let bound = bind(&program, &Bindings::new(), Precision::F64);
    assert_eq!(bound.lanes().unwrap_err().code, "interp-too-big");
    assert_eq!(bound.machine().call(&[3.into()]).unwrap(), 0.0.into());
}

#[test]
fn ports_of_stages_tell_what_they_are() {
    let source = "
        struct Input \
        { @builtin(position) at: vec4f, @location(2) @interpolate(flat) id: u32, @location(0) uv: \
        vec2f }
        struct Output { @location(1) color: vec4f, @builtin(frag_depth) depth: f32 }
        @fragment fn f(in: Input, @builtin(front_facing) front: bool) -> Output {
            return Output(vec4f(in.uv, f32(in.id), select(0.0, 1.0, front)), in.at.z);
        }";
    let program = stage(source, "f");
    let told: Vec<_> = program
        .inputs()
        .iter()
        .map(|port| (port.name.as_str(), port.location(), port.kind, port.size))
        .collect();
    use super::super::ScalarKind::{Bool, Float, U32};
    let expected = [
        ("in.at", None, Float, 4),
        ("in.id", Some(2), U32, 1),
        ("in.uv", Some(0), Float, 2),
        ("front", None, Bool, 1),
    ];
    assert_eq!(told, expected);
    let [color, depth] = program.outputs() else { panic!("two outputs") };
    assert_eq!((color.location(), color.name.as_str()), (Some(1), "color"));
    assert_eq!(depth.builtin(), Some(naga::BuiltIn::FragDepth));
    let bound = bind(&program, &Bindings::new(), Precision::F32);
    let mut lanes = bound.lanes().unwrap();
    let [at, id, uv, front] = program.inputs() else { panic!("four inputs") };
    lanes.write(at, 2, &[0.5, 0.25]);
    lanes.write(id, 0, &[4_294_967_295.0, 3.0]);
    lanes.write(uv, 0, &[0.1, 0.2]);
    lanes.write(uv, 1, &[0.3, 0.4]);
    lanes.write(front, 0, &[1.0, 0.0]);
    lanes.run(2).unwrap();
    let single = |x: f64| f64::from(x as f32);
    let color = |uv: [f64; 2], id, front| Value::from([single(uv[0]), single(uv[1]), id, front]);
    assert_eq!(
        lanes.get(0),
        Value::Struct(vec![color([0.1, 0.3], 4_294_967_296.0, 1.0), 0.5.into()])
    );
    assert_eq!(lanes.get(1), Value::Struct(vec![color([0.2, 0.4], 3.0, 0.0), 0.25.into()]));
}
