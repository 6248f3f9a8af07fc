//! Expressions folded by naga's constant evaluator, which is another implementation, against this
//! interpreter.

use super::*;

/// Value of `expression` with `a`, `b`, `c` replaced by literals, if naga folds it.
fn folded(kind: &str, expression: &str, literals: &[String]) -> Option<Value> {
    let names = ["a", "b", "c"];
    let constants: String = names
        .iter()
        .zip(literals)
        .map(|(name, literal)| format!("const {name}: {kind} = {literal};\n"))
        .collect();
    let source =
        format!("{constants} fn f() -> {kind} {{ const folded = {expression}; return folded; }}");
    #[expect(clippy::disallowed_methods, reason = "naga may refuse it")]
    let module = naga::front::wgsl::parse_str(&source).ok()?;
    let program = Program::compile(&module, "f", FunctionOptions::default()).unwrap();
    Some(program.call(&[], Precision::F32).unwrap())
}

#[test]
fn floats_agree() {
    let expressions = [
        "a + b",
        "a - b * c",
        "a / b",
        "a % b",
        "abs(a)",
        "sign(a)",
        "min(a, b)",
        "max(a, b)",
        "clamp(a, b, b + 1.0)",
        "saturate(a)",
        "cos(a)",
        "cosh(a)",
        "sin(a)",
        "sinh(a)",
        "tan(a)",
        "tanh(a)",
        "acos(a)",
        "asin(a)",
        "atan(a)",
        "atan2(a, b)",
        "asinh(a)",
        "acosh(a)",
        "atanh(a)",
        "radians(a)",
        "degrees(a)",
        "ceil(a)",
        "floor(a)",
        "round(a)",
        "fract(a)",
        "trunc(a)",
        "exp(a)",
        "exp2(a)",
        "log(a)",
        "log2(a)",
        "pow(a, b)",
        "sqrt(a)",
        "inverseSqrt(a)",
        "step(a, b)",
        "fma(a, b, c)",
        "mix(a, b, c)",
        "smoothstep(b, b + 1.0, a)",
        "distance(a, b)",
        "length(a)",
        "dot(vec3(a, b, c), vec3(c, a, b))",
        "cross(vec3(a, b, c), vec3(c, a, b)).y",
        "length(vec2(a, b))",
        "normalize(vec2(a, b)).x",
        "distance(vec2(a, b), vec2(c, a))",
        "quantizeToF16(a)",
    ];
    let mut compared = 0;
    for values in [[0.3, 0.7, -2.5], [-1.75, 2.5, 0.125], [1.5, -0.25, 3.0], [2.5, 1.25, 0.0]] {
        let literals = values.map(|x: f64| format!("{x:?}"));
        for expression in expressions {
            let Some(Value::Float(naga)) = folded("f32", expression, &literals) else { continue };
            let ours = run_in(
                Precision::F32,
                &source("f32; f32; f32 -> f32", expression),
                &values.map(Value::from),
            );
            let ours = ours.as_f64().unwrap();
            // naga uses f32's own functions, which are right to a few ulps.
            let close = (ours - naga).abs() <= 1e-6 * naga.abs().max(0.1);
            assert!(close, "{expression} at {values:?}: naga has {naga}, we have {ours}");
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared}");
}

#[test]
fn integers_agree() {
    let expressions = [
        "a + b",
        "a - b",
        "a * b",
        "a / b",
        "a % b",
        "a & b",
        "a | b",
        "a ^ b",
        "~a",
        "abs(a)",
        "min(a, b)",
        "max(a, b)",
        "clamp(a, b, c)",
        "countOneBits(a)",
        "countLeadingZeros(a)",
        "countTrailingZeros(a)",
        "reverseBits(a)",
        "firstLeadingBit(a)",
        "firstTrailingBit(a)",
        "a << 3u",
        "a >> 5u",
        "select(a, b, a < b)",
        "select(a, b, a >= c)",
    ];
    let mut compared = 0;
    for values in [[17, 5, 9], [-100, 7, 3], [1, -3, 2], [i32::MAX, 2, 40], [-1, -1, 0]] {
        let literals = values.map(|x| format!("{x}"));
        for expression in expressions {
            let Some(naga) = folded("i32", expression, &literals) else { continue };
            assert_eq!(
                run(&source("i32; i32; i32 -> i32", expression), &values.map(Value::from)),
                naga,
                "{expression}"
            );
            compared += 1;
        }
        let literals = values.map(|x| format!("{}u", x as u32));
        for expression in expressions {
            let Some(naga) = folded("u32", expression, &literals) else { continue };
            let arguments = values.map(|x| Value::from(x as u32));
            assert_eq!(
                run(&source("u32; u32; u32 -> u32", expression), &arguments),
                naga,
                "{expression}"
            );
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared}");
}
