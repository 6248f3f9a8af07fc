//! Shader nodes of Blender 5 with their twins here. Inputs are named by the sockets' identifiers,
//! in lower case: `Base Color` is `base_color`; `set_` and a name is a property of the node.

use chiaro_locale::text;

use super::twins::{Twin, twin};

/// Told of surfaces: what light does to them is simpler here.
const LIT: &str = text!("the surface is lit by the look's own light `key`").english();

/// Our vector in Blender's axes, of which z is up: (x, -z, y).
macro_rules! in_axes_of_blender {
    ($recipe:literal $(,)?) => {
        concat!("rotate_vector(vector: ", $recipe, ", axis: [1, 0, 0], angle: 1.5707963267948966)")
    };
}

/// Blender's vector in our axes, of which y is up.
macro_rules! in_our_axes {
    ($recipe:literal $(,)?) => {
        concat!("rotate_vector(vector: ", $recipe, ", axis: [1, 0, 0], angle: -1.5707963267948966)")
    };
}

/// A row of `ShaderNodeMath`, which may clamp its result.
macro_rules! math {
    ($operation:literal, $recipe:literal $(,)?) => {
        twin(
            concat!("ShaderNodeMath:", $operation),
            concat!(
                "switch_value(condition: set_use_clamp|false, on: clamp_range(value: ",
                $recipe,
                "), off: ",
                $recipe,
                ")"
            ),
        )
    };
}

/// A row of `ShaderNodeVectorMath`.
macro_rules! vector_math {
    ($operation:literal, $recipe:literal $(,)?) => {
        twin(concat!("ShaderNodeVectorMath:", $operation), $recipe)
    };
}

/// A row of `ShaderNodeMix` for colors, of which Blender may clamp the result.
macro_rules! mix_colors {
    ($blend:literal, $result:literal $(,)?) => {
        twin(
            concat!("ShaderNodeMix:RGBA-", $blend),
            concat!(
                "switch_value(condition: set_clamp_result|false, on: clamp_range(value: \
                 mix_values(a: a_color|0, b: ",
                $result,
                ", factor: factor_float|0.5, clamped: set_clamp_factor|true)), off: \
                 mix_values(a: a_color|0, b: ",
                $result,
                ", factor: factor_float|0.5, clamped: set_clamp_factor|true))"
            ),
        )
    };
}

/// All rows.
pub(super) const TWINS: &[Twin] = &[
    // A vector as a number, wherever one is linked to the other.
    twin(
        "mean",
        "dot_product(a: in, b: [0.3333333333333333, 0.3333333333333333, 0.3333333333333333])",
    ),
    twin("luminance", "color_luminance(color: in)"),
    // Math.
    math!("ADD", "add(a: value|0, b: value_001|0)"),
    math!("SUBTRACT", "subtract(a: value|0, b: value_001|0)"),
    math!("MULTIPLY", "multiply(a: value|0, b: value_001|0)"),
    math!("DIVIDE", "divide(a: value|0, b: value_001|0)"),
    math!("MULTIPLY_ADD", "add(a: multiply(a: value|0, b: value_001|0), b: value_002|0)"),
    math!("POWER", "power(base: value|0, exponent: value_001|0)"),
    math!("LOGARITHM", "logarithm(value: value|0, base: value_001|0)"),
    math!("SQRT", "square_root(value: value|0)"),
    math!("INVERSE_SQRT", "divide(a: 1, b: square_root(value: value|0))"),
    math!("ABSOLUTE", "absolute(value: value|0)"),
    math!("EXPONENT", "exponential(value: value|0)"),
    math!("MINIMUM", "minimum(a: value|0, b: value_001|0)"),
    math!("MAXIMUM", "maximum(a: value|0, b: value_001|0)"),
    math!("LESS_THAN", "compare(test: \"less\", a: value|0, b: value_001|0)"),
    math!("GREATER_THAN", "compare(test: \"greater\", a: value|0, b: value_001|0)"),
    math!("SIGN", "sign_of(value: value|0)"),
    math!(
        "COMPARE",
        "compare(test: \"equal\", a: value|0, b: value_001|0, \
         epsilon: maximum(a: value_002|0, b: 0.00001))"
    ),
    math!("ROUND", "rounding(mode: \"floor\", value: add(a: value|0, b: 0.5))"),
    math!("FLOOR", "rounding(mode: \"floor\", value: value|0)"),
    math!("CEIL", "rounding(mode: \"ceiling\", value: value|0)"),
    math!(
        "TRUNC",
        "multiply(a: sign_of(value: value|0), \
         b: rounding(mode: \"floor\", value: absolute(value: value|0)))"
    ),
    math!("FRACT", "fraction(value: value|0)"),
    math!(
        "MODULO",
        "multiply(a: sign_of(value: value|0), \
         b: modulo(a: absolute(value: value|0), b: absolute(value: value_001|0)))"
    ),
    math!("FLOORED_MODULO", "modulo(a: value|0, b: value_001|0)"),
    math!(
        "WRAP",
        "add(a: modulo(a: subtract(a: value|0, b: value_002|0), \
         b: subtract(a: value_001|0, b: value_002|0)), b: value_002|0)"
    ),
    math!(
        "SNAP",
        "multiply(a: rounding(mode: \"floor\", value: divide(a: value|0, b: value_001|0)), \
         b: value_001|0)"
    ),
    math!(
        "PINGPONG",
        "absolute(value: subtract(a: modulo(a: subtract(a: value|0, b: value_001|0), \
         b: multiply(a: value_001|0, b: 2)), b: value_001|0))"
    ),
    math!("SINE", "sine(angle: value|0)"),
    math!("COSINE", "cosine(angle: value|0)"),
    math!("TANGENT", "tangent_value(angle: value|0)"),
    math!("ARCSINE", "arcsine(value: value|0)"),
    math!("ARCCOSINE", "arccosine(value: value|0)"),
    math!("ARCTANGENT", "arctangent(y: value|0, x: 1)"),
    math!("ARCTAN2", "arctangent(y: value|0, x: value_001|0)"),
    math!("RADIANS", "multiply(a: value|0, b: 0.017453292519943295)"),
    math!("DEGREES", "multiply(a: value|0, b: 57.29577951308232)"),
    // Vectors.
    vector_math!("ADD", "add(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("SUBTRACT", "subtract(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("MULTIPLY", "multiply(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("DIVIDE", "divide(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!(
        "MULTIPLY_ADD",
        "add(a: multiply(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0]), b: vector_002|[0, 0, 0])"
    ),
    vector_math!("CROSS_PRODUCT", "cross_product(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("DOT_PRODUCT", "dot_product(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("PROJECT", "project_vector(vector: vector|[0, 0, 0], onto: vector_001|[0, 0, 0])"),
    vector_math!(
        "REFLECT",
        "reflect_vector(vector: vector|[0, 0, 0], normal: vector_001|[0, 0, 0])"
    ),
    vector_math!("DISTANCE", "vector_distance(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("LENGTH", "vector_length(vector: vector|[0, 0, 0])"),
    vector_math!("SCALE", "multiply(a: vector|[0, 0, 0], b: scale|1)"),
    vector_math!("NORMALIZE", "normalize_vector(vector: vector|[0, 0, 0])"),
    vector_math!("ABSOLUTE", "absolute(value: vector|[0, 0, 0])"),
    vector_math!("MINIMUM", "minimum(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("MAXIMUM", "maximum(a: vector|[0, 0, 0], b: vector_001|[0, 0, 0])"),
    vector_math!("FLOOR", "rounding(mode: \"floor\", value: vector|[0, 0, 0])"),
    vector_math!("CEIL", "rounding(mode: \"ceiling\", value: vector|[0, 0, 0])"),
    vector_math!("FRACTION", "fraction(value: vector|[0, 0, 0])"),
    vector_math!("SINE", "sine(angle: vector|[0, 0, 0])"),
    vector_math!("COSINE", "cosine(angle: vector|[0, 0, 0])"),
    twin("ShaderNodeSeparateXYZ", "separate_vector(vector: vector|[0, 0, 0])")
        .outputs("x=x y=y z=z"),
    twin("ShaderNodeCombineXYZ", "combine_vector(x: x|0, y: y|0, z: z|0)"),
    twin(
        "ShaderNodeMapping:POINT",
        "add(a: rotate_vector(vector: rotate_vector(vector: rotate_vector(\
         vector: multiply(a: vector|[0, 0, 0], b: scale|1), axis: [1, 0, 0], \
         angle: separate_vector(vector: rotation|[0, 0, 0]).x), axis: [0, 1, 0], \
         angle: separate_vector(vector: rotation|[0, 0, 0]).y), axis: [0, 0, 1], \
         angle: separate_vector(vector: rotation|[0, 0, 0]).z), b: location|[0, 0, 0])",
    ),
    // Numbers.
    twin("ShaderNodeValue", "number(value: held|0)"),
    twin(
        "ShaderNodeMapRange:FLOAT-LINEAR",
        "map_range(value: value|0, from_low: from_min|0, from_high: from_max|1, \
         to_low: to_min|0, to_high: to_max|1, clamped: set_clamp|true)",
    ),
    twin(
        "ShaderNodeMapRange:FLOAT-SMOOTHSTEP",
        "mix_values(a: to_min|0, b: to_max|1, factor: smooth_step_value(value: value|0, \
         low: from_min|0, high: from_max|1))",
    ),
    twin("ShaderNodeClamp:MINMAX", "clamp_range(value: value|0, low: min|0, high: max|1)"),
    twin(
        "ShaderNodeFloatCurve",
        "mix_values(a: value|0, b: curve(value: value|0, curve: curve_0), factor: factor|1)",
    )
    .told(text!("its curve goes through the same points, with other handles").english()),
    twin(
        "ShaderNodeMix:FLOAT",
        "mix_values(a: a_float|0, b: b_float|0, factor: factor_float|0.5, \
         clamped: set_clamp_factor|true)",
    ),
    twin(
        "ShaderNodeMix:VECTOR",
        "mix_values(a: a_vector|[0, 0, 0], b: b_vector|[0, 0, 0], factor: factor_float|0.5, \
         clamped: set_clamp_factor|true)",
    ),
    // Colors.
    twin("ShaderNodeRGB", "color_value(color: held|[0.5, 0.5, 0.5])"),
    mix_colors!("MIX", "b_color|0"),
    mix_colors!("MULTIPLY", "multiply(a: a_color|0, b: b_color|0)"),
    mix_colors!("ADD", "add(a: a_color|0, b: b_color|0)"),
    mix_colors!("SUBTRACT", "subtract(a: a_color|0, b: b_color|0)"),
    mix_colors!(
        "SCREEN",
        "subtract(a: 1, b: multiply(a: subtract(a: 1, b: a_color|0), b: subtract(a: 1, b: \
          b_color|0)))",
    ),
    mix_colors!("DIFFERENCE", "absolute(value: subtract(a: a_color|0, b: b_color|0))"),
    mix_colors!("DARKEN", "minimum(a: a_color|0, b: b_color|0)"),
    mix_colors!("LIGHTEN", "maximum(a: a_color|0, b: b_color|0)"),
    mix_colors!(
        "LINEAR_LIGHT",
        "add(a: a_color|0, b: subtract(a: multiply(a: b_color|0, b: 2), b: 1))"
    ),
    mix_colors!(
        "OVERLAY",
        "mix_colors(mode: \"overlay\", a: a_color|[0, 0, 0], b: b_color|[0, 0, 0], factor: 1)"
    ),
    twin(
        "ShaderNodeInvert",
        "mix_values(a: color|0, b: subtract(a: 1, b: color|0), factor: fac|1)",
    ),
    twin("ShaderNodeGamma", "gamma(color: color|[1, 1, 1], gamma: gamma|1)"),
    twin(
        "ShaderNodeBrightContrast",
        "maximum(a: add(a: multiply(a: color|[1, 1, 1], b: add(a: 1, b: contrast|0)), \
         b: subtract(a: bright|0, b: multiply(a: contrast|0, b: 0.5))), b: 0)",
    ),
    twin(
        "ShaderNodeHueSaturation",
        "mix_values(a: color|[0.8, 0.8, 0.8], b: hsv_adjust(color: color|[0.8, 0.8, 0.8], \
         hue: multiply(a: subtract(a: hue|0.5, b: 0.5), b: 6.283185307179586), \
         saturation: saturation|1, value: value|1), factor: fac|1)",
    ),
    twin("ShaderNodeRGBToBW", "dot_product(a: color|[0.5, 0.5, 0.5], b: [0.2126, 0.7152, 0.0722])"),
    twin(
        "ShaderNodeRGBCurve",
        "mix_values(a: color|[0, 0, 0], b: color_curves(color: color|[0, 0, 0], all: curve_3, \
         red: curve_0, green: curve_1, blue: curve_2), factor: fac|1)",
    )
    .told(text!("its curves go through the same points, with other handles").english()),
    twin("ShaderNodeValToRGB", "ramp(value: fac|0.5, ramp: ramp)").outputs("color=color"),
    twin("ShaderNodeSeparateColor:RGB", "separate_color(color: color|[0, 0, 0])")
        .outputs("red=red green=green blue=blue"),
    twin("ShaderNodeCombineColor:RGB", "combine_color(red: red|0, green: green|0, blue: blue|0)"),
    // Surface.
    twin("ShaderNodeTexCoord>uv", "uv()"),
    twin("ShaderNodeTexCoord>object", in_axes_of_blender!("position(space: \"object\")")),
    twin(
        "ShaderNodeTexCoord>generated",
        concat!(
            "add(a: multiply(a: ",
            in_axes_of_blender!("position(space: \"object\")"),
            ", b: 0.5), b: 0.5)"
        ),
    )
    .told(text!("the box around the object is the one from -1 to 1 here").english()),
    twin("ShaderNodeTexCoord>normal", in_axes_of_blender!("normal()"))
        .told(text!("the object's own space is the world's here").english()),
    twin("ShaderNodeTexCoord>camera", "multiply(a: position(space: \"camera\"), b: [1, 1, -1])"),
    twin("ShaderNodeTexCoord>window", "screen_place().uv"),
    twin("ShaderNodeTexCoord>reflection", in_axes_of_blender!("mirrored_view()")),
    twin("ShaderNodeNewGeometry>position", in_axes_of_blender!("position(space: \"world\")")),
    twin("ShaderNodeNewGeometry>normal", in_axes_of_blender!("normal()")),
    twin("ShaderNodeNewGeometry>tangent", in_axes_of_blender!("tangent_frame().tangent")),
    twin("ShaderNodeNewGeometry>incoming", in_axes_of_blender!("view()")),
    twin("ShaderNodeCameraData>view_z_depth", "depth()"),
    twin(
        "ShaderNodeCameraData>view_distance",
        "vector_length(vector: position(space: \"camera\"))",
    ),
    twin(
        "ShaderNodeCameraData>view_vector",
        "normalize_vector(vector: multiply(a: position(space: \"camera\"), b: [1, 1, -1]))",
    ),
    twin("ShaderNodeUVMap", "uv()"),
    twin("ShaderNodeVertexColor", "vertex_color()"),
    twin(
        "ShaderNodeLayerWeight>facing",
        concat!(
            "subtract(a: 1, b: power(base: facing(normal: ",
            in_our_axes!("normal"),
            "), exponent: switch_value(condition: compare(test: \"less\", a: blend|0.5, b: \
              0.5), on: multiply(a: blend|0.5, b: 2), off: divide(a: 0.5, b: subtract(a: 1, b: \
              blend|0.5)))))"
        ),
    ),
    twin(
        "ShaderNodeFresnel",
        concat!(
            "fresnel(normal: ",
            in_our_axes!("normal"),
            ", at_normal: power(base: divide(a: subtract(a: ior|1.5, b: 1), b: add(a: ior|1.5, \
              b: 1)), exponent: 2))"
        ),
    )
    .told(text!("what is reflected is Schlick's approximation").english()),
    twin(
        "ShaderNodeNormalMap",
        "rotate_vector(vector: normal_map(color: color|[0.5, 0.5, 1], strength: strength|1), \
          axis: [1, 0, 0], angle: 1.5707963267948966)",
    ),
    twin(
        "ShaderNodeBump",
        concat!(
            "rotate_vector(vector: bump_map(height: height|1, scale: multiply(a: strength|1, \
              b: distance|1), normal: ",
            in_our_axes!("normal"),
            "), axis: [1, 0, 0], angle: 1.5707963267948966)"
        ),
    )
    .told(text!("heights are in parts of the object's size here").english()),
    // Textures.
    twin(
        "ShaderNodeTexImage",
        "image(image: image, uv: vector, \
         wrap: set_extension{REPEAT=repeat,EXTEND=clamp,CLIP=clamp,MIRROR=mirror}, \
         filter: set_interpolation{Closest=nearest,Linear=linear,Cubic=linear,Smart=linear}, \
         encoding: image_space|\"color\")",
    )
    .outputs("color=color alpha=alpha"),
    twin(
        "ShaderNodeTexGradient:LINEAR",
        concat!(
            "clamp_range(value: separate_vector(vector: vector|",
            in_axes_of_blender!("position(space: \"object\")"),
            ").x)"
        ),
    ),
    twin(
        "ShaderNodeTexGradient:EASING",
        concat!(
            "smooth_step_value(value: separate_vector(vector: vector|",
            in_axes_of_blender!("position(space: \"object\")"),
            ").x)"
        ),
    ),
    twin(
        "ShaderNodeTexGradient:SPHERICAL",
        concat!(
            "maximum(a: subtract(a: 1, b: vector_length(vector: vector|",
            in_axes_of_blender!("position(space: \"object\")"),
            ")), b: 0)"
        ),
    ),
    // Shaders: each is the color that it shows.
    twin("ShaderNodeEmission", "multiply(a: color|[1, 1, 1], b: strength|1)"),
    twin(
        "ShaderNodeBsdfDiffuse",
        concat!(
            "multiply(a: color|[0.8, 0.8, 0.8], b: reflectance(model: \"lambert\", light: \
              light(light: \"key\"), normal: ",
            in_our_axes!("normal"),
            "))"
        ),
    )
    .told(LIT),
    twin(
        "ShaderNodeBsdfAnisotropic",
        concat!(
            "multiply(a: color|[0.8, 0.8, 0.8], b: reflectance(model: \"ggx\", light: \
              light(light: \"key\"), normal: ",
            in_our_axes!("normal"),
            ", roughness: roughness|0.5))"
        ),
    )
    .told(LIT),
    twin(
        "ShaderNodeBsdfToon",
        concat!(
            "multiply(a: color|[0.8, 0.8, 0.8], b: map_range(value: arccosine(value: \
              reflectance(model: \"lambert\", light: light(light: \"key\"), normal: ",
            in_our_axes!("normal"),
            ")), from_low: multiply(a: size|0.5, b: 1.5707963267948966), from_high: \
              multiply(a: add(a: size|0.5, b: smooth|0), b: 1.5707963267948966), to_low: 1, \
              to_high: 0))"
        ),
    )
    .told(LIT),
    twin(
        "ShaderNodeBsdfPrincipled",
        concat!(
            "set_alpha(color: add(a: add(a: multiply(a: base_color|[0.8, 0.8, 0.8], b: \
              reflectance(model: \"lambert\", light: light(light: \"key\"), normal: ",
            in_our_axes!("normal"),
            ")), b: multiply(a: specular_ior_level|0.5, b: reflectance(model: \"ggx\", light: \
              light(light: \"key\"), normal: ",
            in_our_axes!("normal"),
            ", roughness: roughness|0.5))), b: multiply(a: emission_color|[1, 1, 1], b: \
              emission_strength|0)), alpha: alpha|1)"
        ),
    )
    .told(
        text!("the surface is lit by the look's own light `key`, with a matt and a glossy part")
            .english(),
    ),
    twin("ShaderNodeBsdfTransparent", "set_alpha(color: [0, 0, 0], alpha: 0)").told(
        text!("mixed with another shader it darkens that one; give the mix its color by Set alpha")
            .english(),
    ),
    twin("ShaderNodeAddShader", "add(a: shader|0, b: shader_001|0)"),
    twin("ShaderNodeMixShader", "mix_values(a: shader|0, b: shader_001|0, factor: fac|0.5)"),
    twin("ShaderNodeShaderToRGB", "shader|0"),
];
