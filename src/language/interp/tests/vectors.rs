//! Functions of vectors and matrices.

use naga::{Expression, MathFunction, RelationalFunction};

use super::*;

const A: [f64; 3] = [1.0, -2.0, 3.0];
const B: [f64; 3] = [0.5, 4.0, -1.0];

fn both(signature: &str, expression: &str) -> Value {
    eval(signature, expression, &[A.into(), B.into()])
}

#[test]
fn componentwise() {
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "a + b"), [1.5, 2.0, 2.0].into());
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "a * b"), [0.5, -8.0, -3.0].into());
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "2.0 * a - b / 2.0"),
        [1.75, -6.0, 6.5].into()
    );
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "max(a, b)"), [1.0, 4.0, 3.0].into());
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "-abs(a)"), [-1.0, -2.0, -3.0].into());
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "mix(a, b, 0.5)"),
        [0.75, 1.0, 1.0].into()
    );
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "mix(a, b, vec3(0, 1, 0.5))"),
        [1.0, 4.0, 1.0].into()
    );
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "clamp(a, vec3(0.0), vec3(2.0))"),
        [1.0, 0.0, 2.0].into()
    );
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "select(a, b, a < b)"),
        [1.0, 4.0, 3.0].into(),
        "each component by its own condition"
    );
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "select(a, b, true)"), B.into());
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<bool>", "a < b"),
        Value::bvec(&[false, true, false])
    );
    assert_eq!(both("vec3<f32>; vec3<f32> -> bool", "any(a < b)"), true.into());
    assert_eq!(both("vec3<f32>; vec3<f32> -> bool", "all(a < b)"), false.into());
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<bool>", "!(a < b)"),
        Value::bvec(&[true, false, true])
    );
    assert_eq!(
        eval(
            "vec2<f32>; vec2<i32> -> vec2<f32>",
            "ldexp(a, b)",
            &[[1.0, 3.0].into(), Value::ivec(&[4, -1])]
        ),
        [16.0, 1.5].into()
    );
}

#[test]
fn geometry() {
    assert_eq!(both("vec3<f32>; vec3<f32> -> f32", "dot(a, b)"), (-10.5).into());
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "cross(a, b)"), [-10.0, 2.5, 5.0].into());
    assert_close(&both("vec3<f32>; vec3<f32> -> f32", "length(a)"), &[14_f64.sqrt()], 1e-15);
    assert_close(
        &both("vec3<f32>; vec3<f32> -> f32", "distance(a, b)"),
        &[52.25_f64.sqrt()],
        1e-15,
    );
    let unit = A.map(|x| x / 14_f64.sqrt());
    assert_close(&both("vec3<f32>; vec3<f32> -> vec3<f32>", "normalize(a)"), &unit, 1e-15);
    // a - 2 (b . a) b
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "reflect(a, b)"),
        [11.5, 82.0, -18.0].into()
    );
    assert_eq!(both("vec3<f32>; vec3<f32> -> vec3<f32>", "faceForward(a, a, b)"), A.into());
    assert_eq!(
        both("vec3<f32>; vec3<f32> -> vec3<f32>", "faceForward(a, a, -b)"),
        A.map(|x| -x).into()
    );
}

#[test]
fn refraction_obeys_snell() {
    let refract = |incident: f64, ratio: f64| {
        let arguments = [[incident.sin(), -incident.cos()].into(), [0.0, 1.0].into(), ratio.into()];
        eval("vec2<f32>; vec2<f32>; f32 -> vec2<f32>", "refract(a, b, c)", &arguments)
    };
    let incident: f64 = 0.7;
    let refracted = (incident.sin() / 1.5).asin();
    assert_close(&refract(incident, 1.0 / 1.5), &[refracted.sin(), -refracted.cos()], 1e-15);
    assert_eq!(refract(1.2, 1.5), [0.0, 0.0].into(), "total reflection");
}

#[test]
fn swizzles() {
    let v = [[1.0, 2.0, 3.0, 4.0].into()];
    assert_eq!(eval("vec4<f32> -> vec4<f32>", "a.wzyx", &v), [4.0, 3.0, 2.0, 1.0].into());
    assert_eq!(eval("vec4<f32> -> vec2<f32>", "a.rr", &v), [1.0, 1.0].into());
    assert_eq!(eval("vec4<f32> -> f32", "a.yzw.zx.y", &v), 2.0.into());
    assert_eq!(eval("vec4<f32> -> vec4<f32>", "vec4(a.xy, a.xy)", &v), [1.0, 2.0, 1.0, 2.0].into());
    assert_eq!(eval("vec4<f32> -> vec3<f32>", "vec3(a.w)", &v), [4.0, 4.0, 4.0].into());
}

#[test]
fn products_with_matrices() {
    // 2 columns, 3 rows.
    let m = Value::matrix(&[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    let vector =
        eval("mat2x3<f32>; vec2<f32> -> vec3<f32>", "a * b", &[m.clone(), [10.0, 1.0].into()]);
    assert_eq!(vector, [14.0, 25.0, 36.0].into());
    let vector = eval(
        "mat2x3<f32>; vec3<f32> -> vec2<f32>",
        "b * a",
        &[m.clone(), [1.0, 10.0, 100.0].into()],
    );
    assert_eq!(vector, [321.0, 654.0].into());
    let n = Value::matrix(&[[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]]);
    let product = eval("mat2x3<f32>; mat4x2<f32> -> mat4x3<f32>", "a * b", &[m.clone(), n]);
    let expected = [[9.0, 12.0, 15.0], [19.0, 26.0, 33.0], [29.0, 40.0, 51.0], [39.0, 54.0, 69.0]];
    assert_eq!(product, Value::matrix(&expected));
    let scaled =
        eval("mat2x3<f32> -> mat2x3<f32>", "2.0 * a + a * 0.5 - a", std::slice::from_ref(&m));
    assert_eq!(scaled, Value::matrix(&[[1.5, 3.0, 4.5], [6.0, 7.5, 9.0]]));
    let transposed = eval("mat2x3<f32> -> mat3x2<f32>", "transpose(a)", &[m]);
    assert_eq!(transposed, Value::matrix(&[[1.0, 4.0], [2.0, 5.0], [3.0, 6.0]]));
}

/// Matrix whose determinant is known, because it is a product of a lower and an upper triangular
/// one.
fn lu<const N: usize>() -> ([[f64; N]; N], f64) {
    let lower = |row: usize, column: usize| {
        if row > column { (row + 2 * column + 1) as f64 } else { f64::from(row == column) }
    };
    let upper = |row: usize, column: usize| {
        if row <= column { (row + 2) as f64 - 1.5 * column as f64 } else { 0.0 }
    };
    let entry = |row: usize, column: usize| (0..N).map(|k| lower(row, k) * upper(k, column)).sum();
    let columns = std::array::from_fn(|column| std::array::from_fn(|row| entry(row, column)));
    (columns, (0..N).map(|i| upper(i, i)).product())
}

fn determinant_of<const N: usize>() {
    let (columns, expected) = lu::<N>();
    let actual =
        eval(&format!("mat{N}x{N}<f32> -> f32"), "determinant(a)", &[Value::matrix(&columns)]);
    assert_close(&actual, &[expected], 1e-12);
}

#[test]
fn determinants() {
    determinant_of::<2>();
    determinant_of::<3>();
    determinant_of::<4>();
}

/// Runs `f`, in which `from` has been replaced by a function that WGSL does not have.
fn run_with(source: &str, change: impl Fn(&mut Expression), argument: &Value) -> Value {
    let mut module = module(source);
    for (_, function) in module.functions.iter_mut() {
        for (_, expression) in function.expressions.iter_mut() {
            change(expression);
        }
    }
    let program = Program::compile(&module, "f", FunctionOptions::default()).unwrap();
    program.call(std::slice::from_ref(argument), Precision::F64).unwrap()
}

fn inverse_of<const N: usize>() {
    let (columns, _) = lu::<N>();
    let change = |expression: &mut Expression| {
        if let Expression::Math { fun: fun @ MathFunction::Transpose, .. } = expression {
            *fun = MathFunction::Inverse;
        }
    };
    let source = source(&format!("mat{N}x{N}<f32> -> mat{N}x{N}<f32>"), "transpose(a) * a");
    let mut identity = [[0.0; N]; N];
    (0..N).for_each(|i| identity[i][i] = 1.0);
    assert_close(
        &run_with(&source, change, &Value::matrix(&columns)),
        identity.as_flattened(),
        1e-12,
    );
}

#[test]
fn inverses() {
    inverse_of::<2>();
    inverse_of::<3>();
    inverse_of::<4>();
}

#[test]
fn tests_for_nan_and_infinity() {
    let source = "fn f(a: vec3<f32>) -> bool { return all(a == a); }";
    let becomes = |wanted: RelationalFunction| {
        move |expression: &mut Expression| {
            if let Expression::Binary { left, .. } = *expression {
                *expression = Expression::Relational { fun: wanted, argument: left };
            }
        }
    };
    let all = |fun, x: f64| run_with(source, becomes(fun), &Value::vec(&[x; 3]));
    assert_eq!(all(RelationalFunction::IsNan, f64::NAN), true.into());
    assert_eq!(all(RelationalFunction::IsNan, f64::INFINITY), false.into());
    assert_eq!(all(RelationalFunction::IsInf, f64::NEG_INFINITY), true.into());
    assert_eq!(all(RelationalFunction::IsInf, 1e300), false.into());
}
