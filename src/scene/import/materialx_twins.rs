//! Nodes of MaterialX 1.39 with their twins here.

use chiaro_locale::text;

use super::twins::{Twin, twin};

/// Told of surfaces: what light does to them is simpler here.
const LIT: &str =
    text!("the surface is lit by the look's own light `key`, with a matt and a glossy part")
        .english();

/// All rows.
pub(super) const TWINS: &[Twin] = &[
    // Arithmetic.
    twin("add", "add(a: in1|0, b: in2|0)"),
    twin("subtract", "subtract(a: in1|0, b: in2|0)"),
    twin("multiply", "multiply(a: in1|0, b: in2|1)"),
    twin("divide", "divide(a: in1|0, b: in2|1)"),
    twin("modulo", "modulo(a: in1|0, b: in2|1)"),
    twin("fract", "fraction(value: in|0)"),
    twin("invert", "subtract(a: amount|1, b: in|0)"),
    twin("absval", "absolute(value: in|0)"),
    twin("sign", "sign_of(value: in|0)"),
    twin("floor", "rounding(mode: \"floor\", value: in|0)"),
    twin("ceil", "rounding(mode: \"ceiling\", value: in|0)"),
    twin("round", "rounding(mode: \"nearest\", value: in|0)"),
    twin("power", "power(base: in1|0, exponent: in2|1)"),
    twin(
        "safepower",
        "multiply(a: sign_of(value: in1|0), b: power(base: absolute(value: in1|0), exponent: \
          in2|1))",
    ),
    twin("sin", "sine(angle: in|0)"),
    twin("cos", "cosine(angle: in|0)"),
    twin("tan.float", "tangent_value(angle: in|0)"),
    twin("asin.float", "arcsine(value: in|0)"),
    twin("acos.float", "arccosine(value: in|0)"),
    twin("atan2.float", "arctangent(y: iny|0, x: inx|1)"),
    twin("sqrt", "square_root(value: in|0)"),
    twin("ln.float", "logarithm(value: in|1)"),
    twin("exp", "exponential(value: in|0)"),
    twin("min", "minimum(a: in1|0, b: in2|0)"),
    twin("max", "maximum(a: in1|0, b: in2|0)"),
    twin("clamp.float", "clamp_range(value: in|0, low: low|0, high: high|1)"),
    twin("clamp", "minimum(a: maximum(a: in|0, b: low|0), b: high|1)"),
    twin(
        "trianglewave.float",
        "subtract(a: 0.5, b: absolute(value: subtract(a: modulo(a: absolute(value: in|0), b: 1), \
         b: 0.5)))",
    ),
    // Vectors.
    twin("normalize.vector3", "normalize_vector(vector: in|[0, 0, 0])"),
    twin("magnitude", "vector_length(vector: in|[0, 0, 0])"),
    twin("distance", "vector_distance(a: in1|[0, 0, 0], b: in2|[0, 0, 0])"),
    twin("dotproduct", "dot_product(a: in1|[0, 0, 0], b: in2|[0, 0, 0])"),
    twin("crossproduct.vector3", "cross_product(a: in1|[0, 0, 0], b: in2|[0, 0, 0])"),
    twin("reflect.vector3", "reflect_vector(vector: in|[1, 0, 0], normal: normal)"),
    twin(
        "rotate3d.vector3",
        "rotate_vector(vector: in|[0, 0, 0], axis: axis|[0, 1, 0], \
         angle: multiply(a: amount|0, b: -0.017453292519943295))",
    ),
    twin(
        "rotate2d.vector2",
        "transform_uv(uv: in|[0, 0], angle: multiply(a: amount|0, b: -0.017453292519943295), \
         middle: [0, 0])",
    ),
    twin(
        "place2d.vector2",
        "add(a: subtract(a: transform_uv(uv: divide(a: subtract(a: texcoord|uv(), b: pivot|[0, \
          0]), b: scale|[1, 1]), angle: multiply(a: rotate|0, b: -0.017453292519943295), \
          middle: [0, 0]), b: offset|[0, 0]), b: pivot|[0, 0])",
    ),
    // Channels.
    twin(
        "combine2.vector2",
        "transform_uv(uv: combine_vector(x: in1|0, y: in2|0, z: 0), middle: [0, 0])",
    ),
    twin("combine3.vector3", "combine_vector(x: in1|0, y: in2|0, z: in3|0)"),
    twin("combine3.color3", "combine_color(red: in1|0, green: in2|0, blue: in3|0, alpha: 1)"),
    twin("combine4.color4", "combine_color(red: in1|0, green: in2|0, blue: in3|0, alpha: in4|0)"),
    twin("separate2.vector2", "separate_vector(vector: in|[0, 0, 0])").outputs("outx=x outy=y"),
    twin("separate3.vector3", "separate_vector(vector: in|[0, 0, 0])")
        .outputs("outx=x outy=y outz=z"),
    twin("separate3.color3", "separate_color(color: in|[0, 0, 0])")
        .outputs("outr=red outg=green outb=blue"),
    twin("separate4.color4", "separate_color(color: in|[0, 0, 0, 0])")
        .outputs("outr=red outg=green outb=blue outa=alpha"),
    twin("extract:0", "separate_vector(vector: in|[0, 0, 0]).x"),
    twin("extract:1", "separate_vector(vector: in|[0, 0, 0]).y"),
    twin("extract:2", "separate_vector(vector: in|[0, 0, 0]).z"),
    twin("extract:0.color4", "separate_color(color: in).red"),
    twin("extract:1.color4", "separate_color(color: in).green"),
    twin("extract:2.color4", "separate_color(color: in).blue"),
    twin("extract:3.color4", "separate_color(color: in).alpha"),
    twin("convert", "in|0"),
    twin("convert.color4", "in|[0, 0, 0, 1]"),
    twin("dot", "in|0"),
    twin("dot.color4", "in|[0, 0, 0, 0]"),
    // Constants.
    twin("constant.float", "number(value: value|0)"),
    twin("constant.integer", "number(value: value|0)"),
    twin("constant.boolean", "number(value: value|0)"),
    twin("constant.color3", "color_value(color: value|[0, 0, 0])"),
    twin("constant.color4", "color_value(color: value|[0, 0, 0, 0])"),
    twin("constant.vector2", "value|[0, 0]"),
    twin("constant.vector3", "vector_value(vector: value|[0, 0, 0])"),
    // Mixing.
    twin("mix", "mix_values(a: bg|0, b: fg|0, factor: mix|0, clamped: false)"),
    twin(
        "mix.color4",
        "mix_values(a: bg|[0, 0, 0, 0], b: fg|[0, 0, 0, 0], factor: mix|0, clamped: false)",
    ),
    twin(
        "mix.channels",
        "add(a: multiply(a: fg|0, b: mix|0), b: multiply(a: bg|0, b: subtract(a: 1, b: mix|0)))",
    ),
    twin("plus", "mix_values(a: bg|0, b: add(a: bg|0, b: fg|0), factor: mix|1, clamped: false)"),
    twin(
        "minus",
        "mix_values(a: bg|0, b: subtract(a: bg|0, b: fg|0), factor: mix|1, clamped: false)",
    ),
    twin(
        "difference",
        "mix_values(a: bg|0, b: absolute(value: subtract(a: bg|0, b: fg|0)), factor: mix|1, \
         clamped: false)",
    ),
    twin(
        "screen",
        "mix_values(a: bg|0, b: subtract(a: 1, b: multiply(a: subtract(a: 1, b: fg|0), \
         b: subtract(a: 1, b: bg|0))), factor: mix|1, clamped: false)",
    ),
    twin("inside", "multiply(a: in|0, b: mask|1)"),
    twin("outside", "multiply(a: in|0, b: subtract(a: 1, b: mask|0))"),
    // Conditions.
    twin(
        "ifgreater",
        "switch_value(condition: compare(test: \"greater\", a: value1|1, b: value2|0), on: in1|0, \
         off: in2|0)",
    ),
    twin(
        "ifgreatereq",
        "switch_value(condition: compare(test: \"less\", a: value1|1, b: value2|0), on: in2|0, \
         off: in1|0)",
    ),
    twin(
        "ifequal",
        "switch_value(condition: compare(test: \"equal\", a: value1|0, b: value2|0), on: in1|0, \
         off: in2|0)",
    ),
    twin("and", "multiply(a: in1|0, b: in2|0)"),
    twin("or", "maximum(a: in1|0, b: in2|0)"),
    twin("not", "subtract(a: 1, b: in|0)"),
    twin("xor", "absolute(value: subtract(a: in1|0, b: in2|0))"),
    // Adjustments.
    twin(
        "remap.float",
        "map_range(value: in|0, from_low: inlow|0, from_high: inhigh|1, to_low: outlow|0, \
         to_high: outhigh|1, clamped: false)",
    ),
    twin(
        "remap",
        "add(a: outlow|0, b: divide(a: multiply(a: subtract(a: in|0, b: inlow|0), \
         b: subtract(a: outhigh|1, b: outlow|0)), b: subtract(a: inhigh|1, b: inlow|0)))",
    ),
    twin(
        "range.float",
        "map_range(value: multiply(a: sign_of(value: map_range(value: in|0, from_low: inlow|0, \
         from_high: inhigh|1, clamped: false)), b: power(base: absolute(value: map_range(\
         value: in|0, from_low: inlow|0, from_high: inhigh|1, clamped: false)), \
         exponent: divide(a: 1, b: gamma|1))), to_low: outlow|0, to_high: outhigh|1, \
         clamped: doclamp|false)",
    ),
    twin("smoothstep.float", "smooth_step_value(value: in|0, low: low|0, high: high|1)"),
    twin(
        "contrast",
        "add(a: multiply(a: subtract(a: in|0, b: pivot|0.5), b: amount|1), b: pivot|0.5)",
    ),
    twin(
        "luminance.color3",
        "dot_product(a: in|[0, 0, 0], b: lumacoeffs|[0.2722287, 0.6740818, 0.0536895])",
    ),
    twin(
        "saturate.color3",
        "mix_values(a: dot_product(a: in|[0, 0, 0], \
         b: lumacoeffs|[0.2722287, 0.6740818, 0.0536895]), b: in|[0, 0, 0], factor: amount|1, \
         clamped: false)",
    ),
    twin(
        "hsvadjust.color3",
        "hsv_adjust(color: in|[0, 0, 0], \
         hue: multiply(a: separate_vector(vector: amount|[0, 1, 1]).x, b: 6.283185307179586), \
         saturation: separate_vector(vector: amount|[0, 1, 1]).y, \
         value: separate_vector(vector: amount|[0, 1, 1]).z)",
    ),
    // Surface.
    twin("texcoord.vector2", "uv()"),
    twin("position:object", "position(space: \"object\")"),
    twin("position:model", "position(space: \"object\")"),
    twin("position:world", "position(space: \"world\")"),
    twin("normal:world", "normal()"),
    twin("normal:object", "normal()").told(text!("its object space is the world's here").english()),
    twin("normal:model", "normal()").told(text!("its object space is the world's here").english()),
    twin("tangent:world", "tangent_frame().tangent"),
    twin("tangent:object", "tangent_frame().tangent")
        .told(text!("its object space is the world's here").english()),
    twin("bitangent:world", "tangent_frame().bitangent"),
    twin("bitangent:object", "tangent_frame().bitangent")
        .told(text!("its object space is the world's here").english()),
    twin("viewdirection:world", "negate(value: view())"),
    twin(
        "facingratio.float",
        "switch_value(condition: invert|false, on: subtract(a: 1, b: facing(normal: normal)), \
         off: facing(normal: normal))",
    ),
    twin("geomcolor", "vertex_color()"),
    twin("geomcolor.color4", "vertex_color()"),
    twin("time.float", "time()"),
    twin("frame.float", "frame()"),
    twin("normalmap.vector3", "normal_map(color: in|[0.5, 0.5, 1], strength: scale|1)"),
    // Textures and patterns.
    twin(
        "image.color3",
        "image(image: file, uv: texcoord, \
         wrap: uaddressmode{periodic=repeat,clamp=clamp,mirror=mirror}, \
         filter: filtertype{closest=nearest,linear=linear,cubic=linear}, \
         encoding: file_space{srgb_texture=color}|\"data\")",
    ),
    twin(
        "image.color4",
        "image(image: file, uv: texcoord, \
         wrap: uaddressmode{periodic=repeat,clamp=clamp,mirror=mirror}, \
         filter: filtertype{closest=nearest,linear=linear,cubic=linear}, \
         encoding: file_space{srgb_texture=color}|\"data\")",
    ),
    twin(
        "image.vector3",
        "image(image: file, uv: texcoord, \
         wrap: uaddressmode{periodic=repeat,clamp=clamp,mirror=mirror}, \
         filter: filtertype{closest=nearest,linear=linear,cubic=linear}, encoding: \"data\")",
    ),
    twin(
        "image.float",
        "separate_color(color: image(image: file, uv: texcoord, \
         wrap: uaddressmode{periodic=repeat,clamp=clamp,mirror=mirror}, \
         filter: filtertype{closest=nearest,linear=linear,cubic=linear}, \
         encoding: file_space{srgb_texture=color}|\"data\")).red",
    ),
    twin(
        "tiledimage.color3",
        "image(image: file, uv: subtract(a: multiply(a: texcoord|uv(), b: uvtiling|[1, 1]), \
         b: uvoffset|[0, 0]), filter: filtertype{closest=nearest,linear=linear,cubic=linear}, \
         encoding: file_space{srgb_texture=color}|\"data\")",
    ),
    twin(
        "tiledimage.float",
        "separate_color(color: image(image: file, \
         uv: subtract(a: multiply(a: texcoord|uv(), b: uvtiling|[1, 1]), b: uvoffset|[0, 0]), \
         filter: filtertype{closest=nearest,linear=linear,cubic=linear}, \
         encoding: file_space{srgb_texture=color}|\"data\")).red",
    ),
    twin(
        "checkerboard.color3",
        "checker(uv: subtract(a: multiply(a: texcoord|uv(), b: uvtiling|[8, 8]), \
         b: uvoffset|[0, 0]), scale: 1, color_a: color2|[0, 0, 0], color_b: color1|[1, 1, 1])",
    ),
    twin(
        "ramplr",
        "mix_values(a: valuel|0, b: valuer|0, \
         factor: separate_vector(vector: texcoord|uv()).x, clamped: true)",
    ),
    twin(
        "ramptb",
        "mix_values(a: valueb|0, b: valuet|0, \
         factor: separate_vector(vector: texcoord|uv()).y, clamped: true)",
    ),
    twin(
        "splitlr",
        "mix_values(a: valuel|0, b: valuer|0, factor: threshold(\
         value: separate_vector(vector: texcoord|uv()).x, edge: center|0.5))",
    ),
    twin(
        "splittb",
        "mix_values(a: valueb|0, b: valuet|0, factor: threshold(\
         value: separate_vector(vector: texcoord|uv()).y, edge: center|0.5))",
    ),
    // Surfaces.
    twin(
        "surface_unlit",
        "set_alpha(color: multiply(a: emission_color|[1, 1, 1], b: emission|1), alpha: opacity|1)",
    ),
    twin("surface", "set_alpha(color: add(a: bsdf|0, b: edf|0), alpha: opacity|1)"),
    twin("uniform_edf", "color|[1, 1, 1]"),
    twin("layer", "add(a: base|0, b: top|0)")
        .told(text!("the top layer hides nothing of the base").english()),
    twin(
        "oren_nayar_diffuse_bsdf",
        "multiply(a: multiply(a: color|[0.18, 0.18, 0.18], b: weight|1), \
         b: reflectance(model: \"lambert\", light: light(light: \"key\"), normal: normal))",
    )
    .told(text!("the surface is lit by the look's own light `key`, and evenly rough").english()),
    twin(
        "burley_diffuse_bsdf",
        "multiply(a: multiply(a: color|[0.18, 0.18, 0.18], b: weight|1), \
         b: reflectance(model: \"lambert\", light: light(light: \"key\"), normal: normal))",
    )
    .told(text!("the surface is lit by the look's own light `key`, and evenly rough").english()),
    twin(
        "standard_surface",
        "set_alpha(color: add(a: add(\
         a: multiply(a: multiply(a: base_color|[0.8, 0.8, 0.8], b: base|1), b: reflectance(\
         model: \"lambert\", light: light(light: \"key\"), normal: normal)), \
         b: multiply(a: multiply(a: specular_color|[1, 1, 1], b: specular|1), b: reflectance(\
         model: \"ggx\", light: light(light: \"key\"), normal: normal, \
         roughness: specular_roughness|0.2))), \
         b: multiply(a: emission_color|[1, 1, 1], b: emission|0)), alpha: opacity|1)",
    )
    .told(LIT),
    twin(
        "open_pbr_surface",
        "set_alpha(color: add(a: \
         multiply(a: multiply(a: base_color|[0.8, 0.8, 0.8], b: base_weight|1), b: reflectance(\
         model: \"lambert\", light: light(light: \"key\"), normal: geometry_normal)), \
         b: multiply(a: multiply(a: specular_color|[1, 1, 1], b: specular_weight|1), \
         b: reflectance(model: \"ggx\", light: light(light: \"key\"), normal: geometry_normal, \
         roughness: specular_roughness|0.3))), alpha: geometry_opacity|1)",
    )
    .told(LIT),
    twin(
        "gltf_pbr",
        "set_alpha(color: add(a: add(\
         a: multiply(a: base_color|[1, 1, 1], b: reflectance(\
         model: \"lambert\", light: light(light: \"key\"), normal: normal)), \
         b: multiply(a: multiply(a: specular_color|[1, 1, 1], b: specular|1), b: reflectance(\
         model: \"ggx\", light: light(light: \"key\"), normal: normal, roughness: roughness|1))), \
         b: multiply(a: emissive|[0, 0, 0], b: emissive_strength|1)), alpha: alpha|1)",
    )
    .told(LIT),
    twin(
        "UsdPreviewSurface",
        "set_alpha(color: add(a: add(\
         a: multiply(a: diffuseColor|[0.18, 0.18, 0.18], b: reflectance(\
         model: \"lambert\", light: light(light: \"key\"), normal: normal)), \
         b: reflectance(model: \"ggx\", light: light(light: \"key\"), normal: normal, \
         roughness: roughness|0.5)), b: emissiveColor|[0, 0, 0]), alpha: opacity|1)",
    )
    .told(LIT),
];
