//! Shaders of the crate: the compiler's, and one more entry point for targets of the other
//! encoding.

use super::super::rust::{FragmentEntry, shader_text};
use super::super::{PackageRequest, javascript};
use crate::document::ColorSpace;

/// The entry point for targets of linear light, of looks whose colors are as shown.
const LINEAR: &str = "
/// Linear light of a color as shown.
LINEAR_OF_SHOWN

/// For targets of linear light.
@fragment
fn fs_linear(PARAMETERS) -> @location(0) vec4f {
    let shown = look_color(ARGUMENTS);
    return vec4f(linear_of_shown(shown.rgb), shown.a);
}
";

/// The entry point for targets of colors as shown, of looks in linear light.
const SHOWN: &str = "
/// A color as shown of linear light.
fn shown_of_linear(light: vec3f) -> vec3f {
    let high = 1.055 * pow(light, vec3f(1.0 / 2.4)) - 0.055;
    return select(high, 12.92 * light, light <= vec3f(0.0031308));
}

/// For targets of colors as shown.
@fragment
fn fs_shown(PARAMETERS) -> @location(0) vec4f {
    let linear = look_color(ARGUMENTS);
    return vec4f(shown_of_linear(linear.rgb), linear.a);
}
";

/// The shader of a module; `None` for one of the picture that has not the form that the compiler
/// gives it.
pub(super) fn write(request: &PackageRequest<'_>, module: &str) -> Option<String> {
    let text = javascript::source(request.sources, "wgsl", module, ".wgsl");
    let text = shader_text(&text);
    if module != "draw" {
        return Some(text);
    }
    let (before, fragment) = text.split_once("\n@fragment\n")?;
    let entry = FragmentEntry::of(fragment)?;
    let is_linear = request.description.color_space == ColorSpace::Linear;
    let (same, other) =
        if is_linear { ("linear light", SHOWN) } else { ("colors as shown", LINEAR) };
    let own = format!(
        "\n/// For targets of {same}.\n@fragment\n\
         fn fs_main(PARAMETERS) -> @location(0) vec4f {{\n    return look_color(ARGUMENTS);\n}}\n"
    );
    let entries = entry.fill(&(own + other));
    Some(format!("{before}\n{}{entries}", entry.function()))
}
