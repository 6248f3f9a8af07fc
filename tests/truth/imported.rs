//! Nodes of MaterialX and Blender, imported, against their documented formulas in f64.

use crate::support::eval::truth;
use chiaro::document::Tier;
use chiaro::frame::{EvalSample, SetupLook};
use chiaro::import::{GraphFile, import_graph};
use chiaro::library::Library;

/// A node of MaterialX: its kind and type, inputs as `name type value`, and its numbers.
type Case<'a> = (&'a str, &'a str, &'a [&'a str], &'a [f64]);

fn value(text: &str, file: &str, kind: GraphFile) -> [f64; 4] {
    let imported = import_graph(text, file, kind, Library::built_in());
    let imported = imported.unwrap_or_else(|problems| panic!("{problems:?}\n{text}"));
    assert!(imported.warnings.is_empty(), "{:?}\n{text}", imported.warnings);
    let mut look = imported.value;
    look.tier = Some(Tier::Exact);
    let read = chiaro::document::Look::read(&look.to_text(), "look.json");
    let look = SetupLook { look, source: read.source.into(), folder: Default::default() };
    truth(&look, "", &[EvalSample::default()])[0]
}

fn is_near(found: [f64; 4], expected: &[f64], what: &str) {
    // A number is gray in a picture, a vector of two has no blue.
    let expected: Vec<f64> = match *expected {
        [x] => vec![x; 3],
        [x, y] => vec![x, y, 0.0],
        ref more => more.to_vec(),
    };
    for (index, expected) in expected.iter().enumerate() {
        let off = (found[index] - expected).abs();
        assert!(off < 1e-6 * expected.abs().max(1.0), "{what}: {found:?}, not {expected:?}");
    }
}

/// Every kind once or more, at numbers where a wrong order, sign or default is seen.
#[test]
#[expect(clippy::too_many_lines, reason = "a table: one line a case")]
fn nodes_of_materialx_are_what_its_specification_says() {
    let degrees = std::f64::consts::PI / 180.0;
    let (sin, cos) = (30.0 * degrees).sin_cos();
    let luma = 0.2 * 0.2722287 + 0.5 * 0.6740818 + 0.9 * 0.0536895;
    let saturated = [0.2_f64, 0.5, 0.9].map(|x| luma + 1.5 * (x - luma));
    let range = 2.0 + 3.0 * ((0.75_f64 - 0.25) / 0.8).powf(1.0 / 2.2);
    let t = (0.3_f64 - 0.1) / 0.6;
    let remapped = 2.0 + 3.0 * (0.7 - 0.25) / 0.8;
    let cases: &[Case<'_>] = &[
        ("add", "float", &["in1 float 0.7", "in2 float 0.1"], &[0.8]),
        ("add", "color3", &["in1 color3 0.1,0.2,0.3", "in2 float 0.5"], &[0.6, 0.7, 0.8]),
        ("subtract", "vector3", &["in1 vector3 1,2,3", "in2 vector3 3,1,1"], &[-2.0, 1.0, 2.0]),
        ("multiply", "float", &["in1 float 0.7"], &[0.7]),
        ("multiply", "float", &["in2 float 0.7"], &[0.0]),
        ("divide", "float", &["in1 float 0.7", "in2 float 0.2"], &[3.5]),
        ("modulo", "float", &["in1 float -0.7", "in2 float 0.5"], &[0.3]),
        ("fract", "float", &["in float -0.3"], &[0.7]),
        ("invert", "float", &["in float 0.3", "amount float 2"], &[1.7]),
        ("absval", "vector2", &["in vector2 -0.3,0.2"], &[0.3, 0.2]),
        ("sign", "float", &["in float -0.3"], &[-1.0]),
        ("floor", "float", &["in float -0.3"], &[-1.0]),
        ("ceil", "float", &["in float 0.3"], &[1.0]),
        ("round", "float", &["in float 1.7"], &[2.0]),
        ("power", "float", &["in1 float 0.3", "in2 float 2.5"], &[0.3_f64.powf(2.5)]),
        ("safepower", "float", &["in1 float -0.3", "in2 float 2"], &[-0.09]),
        ("sin", "float", &["in float 0.5"], &[0.5_f64.sin()]),
        ("cos", "float", &["in float 0.5"], &[0.5_f64.cos()]),
        ("tan", "float", &["in float 0.5"], &[0.5_f64.tan()]),
        ("asin", "float", &["in float 0.5"], &[0.5_f64.asin()]),
        ("acos", "float", &["in float 0.5"], &[0.5_f64.acos()]),
        ("atan2", "float", &["iny float 0.5", "inx float -1"], &[0.5_f64.atan2(-1.0)]),
        ("sqrt", "float", &["in float 0.5"], &[0.5_f64.sqrt()]),
        ("ln", "float", &["in float 0.5"], &[0.5_f64.ln()]),
        ("exp", "float", &["in float 0.5"], &[0.5_f64.exp()]),
        ("min", "float", &["in1 float 0.5", "in2 float 0.2"], &[0.2]),
        ("max", "float", &["in1 float 0.5", "in2 float 0.2"], &[0.5]),
        ("clamp", "float", &["in float 1.5", "high float 1.2"], &[1.2]),
        ("clamp", "vector3", &["in vector3 -1,0.5,2"], &[0.0, 0.5, 1.0]),
        ("trianglewave", "float", &["in float 1.2"], &[0.2]),
        ("trianglewave", "float", &["in float -0.7"], &[0.3]),
        ("normalize", "vector3", &["in vector3 3,0,4"], &[0.6, 0.0, 0.8]),
        ("magnitude", "float", &["in vector3 3,0,4"], &[5.0]),
        ("distance", "float", &["in1 vector3 3,0,4", "in2 vector3 0,0,0"], &[5.0]),
        ("dotproduct", "float", &["in1 vector3 1,2,3", "in2 vector3 3,1,0.5"], &[6.5]),
        ("crossproduct", "vector3", &["in1 vector3 1,0,0", "in2 vector3 0,1,0"], &[0.0, 0.0, 1.0]),
        ("reflect", "vector3", &["in vector3 1,-1,0", "normal vector3 0,1,0"], &[1.0, 1.0, 0.0]),
        (
            "rotate3d",
            "vector3",
            &["in vector3 1,0,0", "amount float 30", "axis vector3 0,0,1"],
            &[cos, -sin, 0.0],
        ),
        ("rotate2d", "vector2", &["in vector2 1,0", "amount float 30"], &[cos, -sin]),
        (
            "place2d",
            "vector2",
            &[
                "texcoord vector2 1.5,0.5",
                "pivot vector2 0.5,0.5",
                "scale vector2 2,2",
                "rotate float 30",
                "offset vector2 0.1,0.2",
            ],
            &[0.5 * cos - 0.1 + 0.5, -0.5 * sin - 0.2 + 0.5],
        ),
        ("combine2", "vector2", &["in1 float 0.1", "in2 float 0.2"], &[0.1, 0.2]),
        ("combine3", "color3", &["in1 float 0.1", "in3 float 0.2"], &[0.1, 0.0, 0.2]),
        ("combine3", "vector3", &["in1 float 0.1", "in3 float 0.2"], &[0.1, 0.0, 0.2]),
        ("extract", "float", &["in color3 0.1,0.2,0.3", "index integer 2"], &[0.3]),
        ("convert", "color3", &["in float 0.4"], &[0.4]),
        ("constant", "color3", &["value color3 0.1,0.2,0.3"], &[0.1, 0.2, 0.3]),
        ("mix", "float", &["fg float 1", "bg float 0.2", "mix float 0.25"], &[0.4]),
        (
            "mix",
            "color3",
            &["fg color3 1,1,1", "bg color3 0,0,0", "mix color3 0.1,0.2,0.3"],
            &[0.1, 0.2, 0.3],
        ),
        ("plus", "float", &["fg float 0.5", "bg float 0.2", "mix float 0.5"], &[0.45]),
        ("minus", "float", &["fg float 0.5", "bg float 0.2"], &[-0.3]),
        ("difference", "float", &["fg float 0.5", "bg float 0.2"], &[0.3]),
        ("screen", "float", &["fg float 0.5", "bg float 0.2"], &[0.6]),
        ("inside", "float", &["in float 0.5", "mask float 0.2"], &[0.1]),
        ("outside", "float", &["in float 0.5", "mask float 0.2"], &[0.4]),
        ("ifgreater", "float", &["value1 float 0.5", "value2 float 0.5", "in2 float 7"], &[7.0]),
        ("ifgreatereq", "float", &["value1 float 0.5", "value2 float 0.5", "in1 float 7"], &[7.0]),
        ("ifequal", "float", &["value1 float 0.5", "value2 float 0.5", "in1 float 7"], &[7.0]),
        ("and", "boolean", &["in1 boolean true", "in2 boolean false"], &[0.0]),
        ("or", "boolean", &["in1 boolean true", "in2 boolean false"], &[1.0]),
        ("not", "boolean", &["in boolean false"], &[1.0]),
        ("xor", "boolean", &["in1 boolean true", "in2 boolean true"], &[0.0]),
        (
            "remap",
            "float",
            &[
                "in float 0.7",
                "inlow float 0.25",
                "inhigh float 1.05",
                "outlow float 2",
                "outhigh float 5",
            ],
            &[remapped],
        ),
        (
            "remap",
            "color3",
            &[
                "in color3 0.7,0.7,0.7",
                "inlow color3 0.25,0.25,0.25",
                "inhigh color3 1.05,1.05,1.05",
                "outlow color3 2,2,2",
                "outhigh color3 5,5,5",
            ],
            &[remapped],
        ),
        (
            "range",
            "float",
            &[
                "in float 0.75",
                "inlow float 0.25",
                "inhigh float 1.05",
                "gamma float 2.2",
                "outlow float 2",
                "outhigh float 5",
            ],
            &[range],
        ),
        (
            "smoothstep",
            "float",
            &["in float 0.3", "low float 0.1", "high float 0.7"],
            &[t * t * (3.0 - 2.0 * t)],
        ),
        ("contrast", "float", &["in float 0.7", "amount float 2", "pivot float 0.4"], &[1.0]),
        ("luminance", "color3", &["in color3 0.2,0.5,0.9"], &[luma]),
        ("saturate", "color3", &["in color3 0.2,0.5,0.9", "amount float 1.5"], &saturated),
        // A third of the wheel makes red green.
        (
            "hsvadjust",
            "color3",
            &["in color3 0.8,0.2,0.2", "amount vector3 0.3333333333,1,0.5"],
            &[0.1, 0.4, 0.1],
        ),
        (
            "ramplr",
            "float",
            &["valuel float 1", "valuer float 3", "texcoord vector2 0.25,0"],
            &[1.5],
        ),
        (
            "ramptb",
            "float",
            &["valuet float 1", "valueb float 3", "texcoord vector2 0,0.25"],
            &[2.5],
        ),
        (
            "checkerboard",
            "color3",
            &[
                "texcoord vector2 0.1,0.1",
                "uvtiling vector2 2,2",
                "color1 color3 1,0,0",
                "color2 color3 0,1,0",
            ],
            &[0.0, 1.0, 0.0],
        ),
        ("dot", "float", &["in float 0.4"], &[0.4]),
    ];
    for (kind, ty, inputs, expected) in cases {
        let mut body = String::new();
        for input in *inputs {
            let mut words = input.split(' ');
            let [name, ty, value] = [words.next(), words.next(), words.next()].map(Option::unwrap);
            body += &format!(r#"<input name="{name}" type="{ty}" value="{value}"/>"#);
        }
        // Numbers from nodes are no constants of the import, and must be the same.
        let fed = inputs.iter().filter(|input| !input.contains("index")).map(|input| {
            let mut words = input.split(' ');
            let [name, ty, value] = [words.next(), words.next(), words.next()].map(Option::unwrap);
            let node = format!(
                r#"<constant name="c_{name}" type="{ty}">
                <input name="value" type="{ty}" value="{value}"/></constant>"#
            );
            let link = format!(r#"<input name="{name}" type="{ty}" nodename="c_{name}"/>"#);
            (node, link)
        });
        let (nodes, mut links): (String, String) = fed.unzip();
        if let Some(index) = inputs.iter().find(|input| input.contains("index")) {
            let index = index.rsplit(' ').next().unwrap_or_default();
            links += &format!(r#"<input name="index" type="integer" value="{index}"/>"#);
        }
        for (nodes, body) in [("", body.as_str()), (nodes.as_str(), links.as_str())] {
            let text = format!(
                r#"<materialx version="1.39">{nodes}<{kind} name="n" type="{ty}">{body}</{kind}>
                <output name="out" type="{ty}" nodename="n"/></materialx>"#
            );
            is_near(value(&text, "n.mtlx", GraphFile::MaterialX), expected, &text);
        }
    }
}

/// Operations of Blender's nodes at numbers where a wrong order, sign or default is seen; the
/// formulas are those of its manual.
#[test]
fn nodes_of_blender_are_what_its_manual_says() {
    let (a, b, c) = (-0.7_f64, 0.4_f64, 0.3_f64);
    let cases: &[(&str, f64)] = &[
        ("ADD", a + b),
        ("SUBTRACT", a - b),
        ("MULTIPLY", a * b),
        ("DIVIDE", a / b),
        ("MULTIPLY_ADD", a * b + c),
        ("SQRT", 0.0),
        ("ABSOLUTE", 0.7),
        ("EXPONENT", a.exp()),
        ("MINIMUM", a),
        ("MAXIMUM", b),
        ("LESS_THAN", 1.0),
        ("GREATER_THAN", 0.0),
        ("SIGN", -1.0),
        ("COMPARE", 0.0),
        ("ROUND", -1.0),
        ("FLOOR", -1.0),
        ("CEIL", 0.0),
        ("TRUNC", 0.0),
        ("FRACT", 0.3),
        ("MODULO", -0.3),
        ("FLOORED_MODULO", 0.1),
        // From c to b, which is 0.1 wide: ten steps up.
        ("WRAP", 0.3),
        ("SNAP", -0.8),
        // |fract((a - b) / 2b) 2b - b|
        ("PINGPONG", ((a - b).rem_euclid(2.0 * b) - b).abs()),
        ("SINE", a.sin()),
        ("COSINE", a.cos()),
        ("TANGENT", a.tan()),
        ("ARCSINE", a.asin()),
        ("ARCCOSINE", a.acos()),
        ("ARCTANGENT", a.atan()),
        ("ARCTAN2", a.atan2(b)),
        ("RADIANS", a.to_radians()),
        ("DEGREES", a.to_degrees()),
    ];
    for (operation, expected) in cases {
        for clamps in [false, true] {
            let found = blender_math(operation, [a, b, c], clamps);
            let expected = if clamps { expected.clamp(0.0, 1.0) } else { *expected };
            // Where a step lies, a rounding of 0.1 away from it counts.
            let is_step = *operation == "WRAP" && (found[0] - 0.4).abs() < 1e-6;
            if !is_step {
                is_near(found, &[expected], operation);
            }
        }
    }
    is_near(blender_math("POWER", [0.7, 2.5, 0.0], false), &[0.7_f64.powf(2.5)], "POWER");
    is_near(blender_math("LOGARITHM", [0.7, 2.0, 0.0], false), &[0.7_f64.log2()], "LOGARITHM");
    is_near(blender_math("INVERSE_SQRT", [4.0, 0.0, 0.0], false), &[0.5], "INVERSE_SQRT");
}

fn blender_math(operation: &str, [a, b, c]: [f64; 3], clamps: bool) -> [f64; 4] {
    let text = format!(
        r#"{{"blender": "5.0.1", "material": "M", "links": [["n", "Value", "o", "Surface"]],
        "nodes": [
          {{"name": "n", "kind": "ShaderNodeMath",
            "settings": {{"operation": "{operation}", "use_clamp": {clamps}}},
            "inputs": [{{"id": "Value", "type": "VALUE", "value": {a}}},
              {{"id": "Value_001", "type": "VALUE", "value": {b}}},
              {{"id": "Value_002", "type": "VALUE", "value": {c}}}],
            "outputs": [{{"id": "Value", "type": "VALUE"}}]}},
          {{"name": "o", "kind": "ShaderNodeOutputMaterial",
            "inputs": [{{"id": "Surface", "type": "SHADER"}}]}}]}}"#
    );
    value(&text, "n.json", GraphFile::Blender)
}
