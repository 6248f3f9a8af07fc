//! The look's shader in Godot's language, from its GLSL ES 3.00.
//!
//! Godot's language is a part of that GLSL: functions, structs and constants stay as they are. What
//! it has in other ways is rewritten, each by a row of a table: words, inputs of the vertex, what
//! the picture's camera and object are asked for. Uniform blocks become uniforms (`uniforms`).

use std::collections::BTreeSet;
use std::fmt::Write as _;

use chiaro_locale::tr;

use super::uniforms::Uniforms;
use crate::wgsl::{identifiers, rename_identifiers};

/// Words of GLSL that Godot has by other names.
const WORDS: [(&str, &str); 4] = [
    ("mat2x2", "mat2"),
    ("mat3x3", "mat3"),
    ("mat4x4", "mat4"),
    ("gl_FrontFacing", "FRONT_FACING"),
];

/// Words that Godot's language has for itself: names of the look get an end.
const TAKEN: [&str; 15] = [
    "E",
    "INF",
    "NAN",
    "PI",
    "TAU",
    "filter_linear",
    "filter_nearest",
    "global",
    "group_uniforms",
    "instance",
    "render_mode",
    "shader_type",
    "source_color",
    "stencil_mode",
    "varying",
];

/// Functions that Godot calls: a function of the look by that name gets an end.
const CALLED: [&str; 7] = ["fog", "fragment", "light", "process", "sky", "start", "vertex"];

/// Numbers that a vertex passes on: name, type, and what Godot has for it.
const VARYINGS: [(&str, &str, &str); 5] = [
    ("v_position", "vec3", "(MODEL_MATRIX * vec4(VERTEX, 1.0)).xyz"),
    ("v_position_object", "vec3", "VERTEX"),
    ("v_normal", "vec3", "MODEL_NORMAL_MATRIX * NORMAL"),
    (
        "v_tangent",
        "vec4",
        "vec4((MODEL_MATRIX * vec4(TANGENT, 0.0)).xyz,\n        \
         dot(cross(NORMAL, TANGENT), BINORMAL) * determinant(MODEL_NORMAL_MATRIX) < 0.0\n        \
         ? -1.0 : 1.0)",
    ),
    // Rows of textures run down in Godot, up in Chiaro.
    ("v_uv", "vec2", "vec2(UV.x, 1.0 - UV.y)"),
];

/// Members that a fragment asks its camera and object for: the member, a name for its value, the
/// value's type, and what Godot has for it.
const SURROUNDINGS: [(&str, &str, &str, &str); 6] = [
    (
        "u_view.eye",
        "eye",
        "vec4",
        // A parallel projection has 1 there.
        "PROJECTION_MATRIX[3][3] == 0.0\n        \
         ? vec4(CAMERA_POSITION_WORLD, 1.0) : vec4(INV_VIEW_MATRIX[2].xyz, 0.0)",
    ),
    ("u_view.clip_from_world", "clip_from_world", "mat4", "PROJECTION_MATRIX * VIEW_MATRIX"),
    ("u_view.camera_from_world", "VIEW_MATRIX", "", ""),
    // Pixels are counted from the top, as in Chiaro.
    ("u_view.screen", "screen", "vec4", "vec4(1.0, 1.0, 0.0, 0.0)"),
    ("u_object.world_from_object", "MODEL_MATRIX", "", ""),
    (
        "u_object.world_from_normal",
        "world_from_normal",
        "mat3",
        // Godot's own MODEL_NORMAL_MATRIX is the model's where the three axes have one scale.
        "transpose(inverse(mat3(MODEL_MATRIX)))",
    ),
];

/// The beginning of the shader's modes.
pub(super) struct ShaderOptions<'a> {
    /// Name of the look.
    pub(super) title: &'a str,
    /// Name of the look's script.
    pub(super) script: &'a str,
    /// True if both sides of triangles are drawn.
    pub(super) has_both_sides: bool,
    /// True if no pixel is transparent.
    pub(super) is_opaque: bool,
    /// True if the look's numbers are linear light, false if they are as shown.
    pub(super) is_linear: bool,
    /// Structs of uniform blocks.
    pub(super) blocks: &'a BTreeSet<String>,
}

/// A declaration of GLSL with the comment before it.
#[derive(Debug)]
struct Declaration {
    comment: String,
    text: String,
}

impl Declaration {
    /// The first words, of which declarations are told apart.
    fn begins_with(&self, word: &str) -> bool {
        self.text.starts_with(word)
    }

    /// The name of a struct.
    fn structure(&self) -> Option<&str> {
        self.text.strip_prefix("struct ")?.split([' ', '{']).next()
    }
}

/// Writes the shader.
///
/// # Errors
/// What the shader reads that Godot has nothing for, in words.
pub(super) fn write(
    fragment: &str,
    uniforms: &mut Uniforms,
    options: &ShaderOptions<'_>,
) -> Result<String, String> {
    let words = free_words(fragment);
    let fragment = without_clashes(fragment, uniforms, &words);
    uniforms.take(&words);
    let renamed = with_words_of_godot(&fragment, &words);
    let parts = declarations(&with_float_layers(&with_signed_shifts(&renamed)));
    let is_block = |part: &Declaration| {
        let name = part.structure();
        name.is_some_and(|name| name == "Varyings" || options.blocks.contains(name))
    };
    let (mut structs, mut constants, mut functions) = (String::new(), String::new(), String::new());
    let (mut varyings, mut main) = (String::new(), None);
    let mut passed_on = Vec::new();
    for part in &parts {
        let Declaration { comment, text } = part;
        if is_block(part)
            || ["#version", "precision", "layout", "uniform"].iter().any(|it| part.begins_with(it))
        {
            continue;
        }
        if part.begins_with("smooth in") || part.begins_with("flat in") {
            let name = text.trim_end_matches(';').rsplit(' ').next().unwrap_or_default();
            let known = VARYINGS.iter().find(|(known, ..)| *known == name);
            let (name, ty, value) = known.ok_or_else(|| tr!("`{name}` of its vertices"))?;
            let _infallible = writeln!(varyings, "varying {ty} {name};");
            passed_on.push(format!("    {name} = {value};\n"));
        } else if part.begins_with("struct") {
            let _infallible = write!(structs, "{comment}{text}\n\n");
        } else if part.begins_with("const") {
            let _infallible = writeln!(constants, "{comment}{text}");
        } else if part.begins_with("void main()") {
            main = Some(text);
        } else {
            let _infallible = write!(functions, "{comment}{text}\n\n");
        }
    }
    let taken = free_words(&format!("{structs}{constants}{functions}{}", main.map_or("", |it| it)));
    let main = fragment_function(main.ok_or_else(|| tr!("no entry point"))?, options, &taken)?;
    let body = uniforms.rewrite(&format!("{functions}{main}"));
    if let Some(word) = identifiers(&body).iter().find(|word| word.starts_with("u_")) {
        return Err(format!("`{}`", &word[2..]));
    }
    let values = uniforms.values_text();
    let read = format!("{values}{body}");
    let mut modes = vec!["unshaded"];
    if options.has_both_sides {
        modes.push("cull_disabled");
    }
    if !options.is_opaque {
        // What is opaque of it casts shadows and hides what lies behind.
        modes.push("depth_prepass_alpha");
    }
    let mut text = format!(
        "// {}: made by Chiaro {}, Godot 4.\n\
         // Colors and lights are the look's own: {} keeps the uniforms up to date.\n\
         shader_type spatial;\nrender_mode {};\n\n",
        options.title,
        env!("CARGO_PKG_VERSION"),
        options.script,
        modes.join(", ")
    );
    text += &uniforms.declarations(&read);
    let _infallible = write!(text, "{varyings}\n{structs}{constants}");
    if !constants.is_empty() {
        text.push('\n');
    }
    text += uniforms.encoding(&read);
    text += &values;
    let (functions, main) = split_main(&body);
    text += functions;
    text += if options.is_linear { ALBEDO_OF_LIGHT } else { ALBEDO_OF_SHOWN };
    let _infallible = write!(text, "\nvoid vertex() {{\n{}}}\n\n{main}", passed_on.concat());
    Ok(text)
}

/// The text with Godot's words, and without names that Godot has for others.
fn with_words_of_godot(text: &str, words: &BTreeSet<String>) -> String {
    let is_function = |name: &str| {
        let head = format!(" {name}(");
        text.lines().any(|line| !line.starts_with([' ', '/']) && line.contains(&head))
    };
    let clashes = TAKEN.into_iter().chain(CALLED.into_iter().filter(|name| is_function(name)));
    let mut renamed: Vec<(&str, String)> =
        WORDS.iter().map(|(old, new)| (*old, (*new).to_owned())).collect();
    for word in clashes {
        let mut name = format!("{word}_of_look");
        while words.contains(&name) {
            name.push('_');
        }
        renamed.push((word, name));
    }
    // Members after a point, too: structs declare them by the same word.
    let apart = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
    let mut result = String::with_capacity(text.len());
    for piece in text.split_inclusive(apart) {
        let word = piece.trim_end_matches(apart);
        match renamed.iter().find(|(old, _)| *old == word) {
            Some((_, new)) => {
                result.push_str(new);
                result.push_str(&piece[word.len()..]);
            }
            None => result.push_str(piece),
        }
    }
    result
}

/// Words of a text, but for members after a point.
fn free_words(text: &str) -> BTreeSet<String> {
    let words = std::cell::RefCell::new(BTreeSet::new());
    rename_identifiers(text, |word| {
        words.borrow_mut().insert(word.to_owned());
        None
    });
    words.into_inner()
}

/// The text without values that are called as a uniform is, which Godot takes for the same: the
/// values get an end, or the uniform where a struct has a member of that name.
fn without_clashes(text: &str, uniforms: &mut Uniforms<'_>, words: &BTreeSet<String>) -> String {
    let apart = text.replace("u_look.", "u_look ");
    let free = |name: &str, end: &str| {
        let mut name = format!("{name}{end}");
        while words.contains(&name) {
            name.push('_');
        }
        name
    };
    let mut values = std::collections::BTreeMap::new();
    for name in uniforms.names() {
        if !words.contains(&name) {
            continue;
        }
        let member = format!(".{name}");
        let is_member = apart.match_indices(&member).any(|(at, _)| {
            !apart[at + member.len()..].starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_')
        });
        if is_member {
            uniforms.rename(&name, &free(&name, "_of_look"));
        } else {
            values.insert(name.clone(), free(&name, "_"));
        }
    }
    // Members of the look's own struct are read by their names.
    let (before, after) = match text.find("struct Look {") {
        Some(at) => {
            let end = text[at..].find("};").map_or(text.len(), |end| at + end);
            (&text[..end], &text[end..])
        }
        None => ("", text),
    };
    before.to_owned() + &rename_identifiers(after, |word| values.get(word).cloned())
}

/// The text with shifts of signed numbers by signed ones, as Godot wants them.
fn with_signed_shifts(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    loop {
        let found = [" >> ", " << "].iter().filter_map(|shift| rest.find(shift)).min();
        let Some(at) = found else { break };
        result.push_str(&rest[..at + 4]);
        rest = &rest[at + 4..];
        if let Some((signed, used)) = signed_number(rest)
            && is_signed(&result[..result.len() - 4])
        {
            result += &signed;
            rest = &rest[used..];
        }
    }
    result + rest
}

/// The number without a sign that a text begins with, or a vector of one, as a number with a sign;
/// and its length in the text.
fn signed_number(text: &str) -> Option<(String, usize)> {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).filter(|end| *end > 0);
    if let Some(of_vector) = text.strip_prefix("uvec") {
        let number = of_vector.get(2..)?;
        let end = digits(number)?;
        let is_vector = of_vector[..2].ends_with('(') && number[end..].starts_with("u)");
        let vector = || format!("ivec{}{})", &of_vector[..2], &number[..end]);
        return is_vector.then(|| (vector(), "uvec2(u)".len() + end));
    }
    let end = digits(text)?;
    text[end..].starts_with('u').then(|| (text[..end].to_owned(), end + 1))
}

/// True if the operand at the end of a text is a signed number, or a vector of them.
fn is_signed(text: &str) -> bool {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let last_word = |text: &str| {
        let start = text.rfind(|c: char| !is_word(c)).map_or(0, |at| at + 1);
        text[start..].to_owned()
    };
    let is_type = |word: &str| word == "int" || word.starts_with("ivec");
    let mut operand = text;
    loop {
        if let Some(inside) = operand.strip_suffix(')') {
            let Some(open) = opening(operand) else { return false };
            let function = last_word(&operand[..open]);
            if !function.is_empty() {
                return is_type(&function);
            }
            // Operands of a sum are all signed, or none is.
            operand = inside;
            continue;
        }
        let name = last_word(operand);
        if name.starts_with(|c: char| c.is_ascii_digit()) {
            return !name.ends_with('u');
        }
        let before = &operand[..operand.len() - name.len()];
        if let Some(vector) = before.strip_suffix('.') {
            operand = vector;
            continue;
        }
        // The nearest declaration of that name.
        let declared = text.rmatch_indices(&format!(" {name}")).find_map(|(at, word)| {
            let ty = last_word(&text[..at]);
            let is_whole = !text[at + word.len()..].starts_with(is_word);
            (is_whole && !ty.is_empty() && ty != "return").then_some(ty)
        });
        return !name.is_empty() && declared.is_some_and(|ty| is_type(&ty));
    }
}

/// The place of the parenthesis that the last one of a text closes.
fn opening(text: &str) -> Option<usize> {
    let mut depth = 0_i32;
    for (at, c) in text.char_indices().rev() {
        depth += i32::from(c == ')') - i32::from(c == '(');
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// The text with layers of textures as floats, as Godot makes vectors: `vec3(at, layer)` where a
/// level is read.
fn with_float_layers(text: &str) -> String {
    const READ: &str = "textureLod(";
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(READ) {
        let (before, read) = rest.split_at(at + READ.len());
        result += before;
        rest = read;
        let Some(layer) = layer_of(rest) else { continue };
        let _infallible = write!(result, "{}float({})", &rest[..layer.start], &rest[layer.clone()]);
        rest = &rest[layer.end..];
    }
    result + rest
}

/// The place of the layer in the arguments of a reading, which begin the text; `None` for a texture
/// without layers.
fn layer_of(arguments: &str) -> Option<std::ops::Range<usize>> {
    const PLACE: &str = "vec3(";
    let start = arguments.find(',')? + 1;
    let place = arguments[start..].trim_start();
    let place_at = arguments.len() - place.len() + PLACE.len();
    let parts = place.strip_prefix(PLACE)?;
    let mut depth = 0_i32;
    let mut last = None;
    for (at, c) in parts.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ',' if depth == 0 && last.is_some() => return None,
            ',' if depth == 0 => last = Some(at + 1),
            ')' if depth == 0 => {
                let layer = last?;
                let blank = parts[layer..].len() - parts[layer..].trim_start().len();
                return Some(place_at + layer + blank..place_at + at);
            }
            ')' | ']' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// The functions of a text, and its last one: `fragment`.
fn split_main(body: &str) -> (&str, &str) {
    body.split_at(body.find("void fragment() {").unwrap_or(body.len()))
}

/// The entry point as Godot has it.
fn fragment_function(
    main: &str,
    options: &ShaderOptions<'_>,
    words: &BTreeSet<String>,
) -> Result<String, String> {
    let (_, body) = main.split_once("{\n").ok_or_else(|| tr!("no entry point"))?;
    let body = body.strip_suffix('}').unwrap_or(body);
    let mut body = body.to_owned();
    // What a vertex passes on is read as it is, not by a struct.
    if let Some(start) = body.find("Varyings ")
        && let Some(end) = body[start..].find(";\n")
    {
        let name = body[start..].split(' ').nth(1).unwrap_or_default().to_owned();
        let from = body[..start].rfind('\n').map_or(0, |it| it + 1);
        body.replace_range(from..start + end + 2, "");
        body = body.replace(&format!("{name}.clip"), "FRAGCOORD");
        body = body.replace(&format!("{name}."), "v_");
    }
    let mut opening = String::new();
    for (member, name, ty, value) in SURROUNDINGS {
        if !body.contains(member) {
            continue;
        }
        let mut name = name.to_owned();
        if !ty.is_empty() {
            while words.contains(&name) {
                name.push('_');
            }
            let _infallible = writeln!(opening, "    {ty} {name} = {value};");
        }
        body = body.replace(member, &name);
    }
    let mut shown = "shown".to_owned();
    while words.contains(&shown) {
        shown.push('_');
    }
    let body = body.replace("out_color = ", &format!("vec4 {shown} = "));
    let alpha = if options.is_opaque { String::new() } else { format!("    ALPHA = {shown}.a;\n") };
    Ok(format!(
        "void fragment() {{\n{opening}{body}    ALBEDO = albedo_of({shown}.rgb);\n{alpha}}}\n"
    ))
}

/// The declarations of a text, each with its comment. A declaration ends at the end of a line where
/// no brace is open.
fn declarations(text: &str) -> Vec<Declaration> {
    let mut found = Vec::new();
    let (mut comment, mut current) = (String::new(), String::new());
    let mut depth = 0_usize;
    for line in text.lines() {
        if current.is_empty() && line.is_empty() {
            comment.clear();
            continue;
        }
        if current.is_empty() && line.starts_with("//") {
            comment += line;
            comment.push('\n');
            continue;
        }
        if !current.is_empty() {
            current.push('\n');
        }
        current += line;
        let code = line.split("//").next().unwrap_or_default();
        depth += code.matches('{').count();
        depth = depth.saturating_sub(code.matches('}').count());
        let is_over = line.starts_with('#') || code.trim_end().ends_with([';', '}']);
        if depth == 0 && is_over {
            found.push(Declaration {
                comment: std::mem::take(&mut comment),
                text: std::mem::take(&mut current),
            });
        }
    }
    found
}

/// The way from a color as shown to Godot's albedo.
const ALBEDO_OF_SHOWN: &str = include_str!("shown.gdshaderinc");

/// The way from light to Godot's albedo.
const ALBEDO_OF_LIGHT: &str = include_str!("light.gdshaderinc");

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::uniforms::ImageUniform;
    use super::*;

    #[test]
    fn declarations_end_where_their_braces_do() {
        let text = "#version 300 es\n// A head.\n\n/// Doc.\nstruct Angle {\n    float x;\n};\n\n\
                    const float A = 1.0,\n    B = 2.0;\nvoid main() {\n    if (x) {\n    }\n}\n";
        let parts = declarations(text);
        let texts: Vec<&str> = parts.iter().map(|part| part.text.as_str()).collect();
        assert_eq!(texts.len(), 4, "{texts:?}");
        assert_eq!(parts[1].comment, "/// Doc.\n");
        assert_eq!(parts[1].structure(), Some("Angle"));
        assert!(texts[2].ends_with("B = 2.0;"), "{texts:?}");
        assert!(texts[3].starts_with("void main()") && texts[3].ends_with("    }\n}"), "{texts:?}");
    }

    #[test]
    fn words_of_godot_are_no_names_of_the_look() {
        let text = "const float PI = 3.0;\nmat3x3 m;\nfloat light(Light light) {\n    return \
                    light.instance * PI;\n}\n";
        assert_eq!(
            with_words_of_godot(text, &free_words(text)),
            "const float PI_of_look = 3.0;\nmat3 m;\n\
             float light_of_look(Light light_of_look) {\n    \
             return light_of_look.instance_of_look * PI_of_look;\n}\n"
        );
        let text = "float lit(Light light) {\n    return light.x;\n}\n";
        assert_eq!(with_words_of_godot(text, &free_words(text)), text);
    }

    #[test]
    fn no_parameter_of_a_function_is_called_as_a_texture_is() {
        let text =
            "vec4 image(sampler2D image_1, vec2 uv) {\n    return texture(image_1, uv);\n}\n";
        let image = ImageUniform {
            old: "u_image_1".to_owned(),
            name: "image_1".to_owned(),
            file: String::new(),
            ty: "Texture2D",
            hints: String::new(),
        };
        let (parameters, lights) = (BTreeMap::new(), BTreeMap::new());
        let mut uniforms =
            Uniforms::of(vec![], parameters, &lights, vec![image], vec![]).expect("no members");
        let text = without_clashes(text, &mut uniforms, &free_words(text));
        assert!(text.contains("image_1_, vec2") && text.contains("(image_1_, uv)"), "{text}");
        assert_eq!(uniforms.names(), ["image_1"]);
    }

    #[test]
    fn signed_numbers_are_shifted_by_signed_ones() {
        for (from, to) in [
            ("int e = int(b - 1u) >> 23u;", "int e = int(b - 1u) >> 23;"),
            ("float(uint(x + 1) << 23u)", "float(uint(x + 1) << 23u)"),
            ("int i = 4; a[i >> 2u] + b[i >> 2u]", "int i = 4; a[i >> 2] + b[i >> 2]"),
            ("uint point = 4u; point >> 2u", "uint point = 4u; point >> 2u"),
            ("uvec3 v; v >> uvec3(8u)", "uvec3 v; v >> uvec3(8u)"),
            ("ivec2 v; max(v >> uvec2(1u), a)", "ivec2 v; max(v >> ivec2(1), a)"),
            ("ivec4 v; 2 * (v.z >> 4u)", "ivec4 v; 2 * (v.z >> 4)"),
            ("uvec4 v; 2u * (v.z >> 4u)", "uvec4 v; 2u * (v.z >> 4u)"),
            ("return (texels + 3) >> 2u;", "return (texels + 3) >> 2;"),
            ("int i; uint j; return (i + k[j]) >> 2u;", "int i; uint j; return (i + k[j]) >> 2u;"),
            ("return (bits + 3u) >> 2u;", "return (bits + 3u) >> 2u;"),
            ("(a) >> uvec(", "(a) >> uvec("),
        ] {
            assert_eq!(with_signed_shifts(from), to);
        }
    }

    #[test]
    fn layers_of_textures_are_floats() {
        for (from, to) in [
            (
                "a + textureLod(s, vec3((b + c(d, e)) / f, layer), 0.0) + textureLod(s, \
                 vec3(a, views.layer[i]), 0.0)",
                "a + textureLod(s, vec3((b + c(d, e)) / f, float(layer)), 0.0) + textureLod(s, \
                 vec3(a, float(views.layer[i])), 0.0)",
            ),
            (
                "textureLod(s,\n    vec3(a,\n  l), 0.0)",
                "textureLod(s,\n    vec3(a,\n  float(l)), 0.0)",
            ),
            ("textureLod(s, vec2(a, b), 0.0)", "textureLod(s, vec2(a, b), 0.0)"),
            ("textureLod(s, vec3(a, b, c), 0.0)", "textureLod(s, vec3(a, b, c), 0.0)"),
            ("textureLod(s, vec3(a", "textureLod(s, vec3(a"),
        ] {
            assert_eq!(with_float_layers(from), to);
        }
    }
}
