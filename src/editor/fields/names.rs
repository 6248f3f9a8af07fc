//! Labels of nodes and their ports in the user's language. Those of the library are looked up;
//! names that people gave are shown as they are.

use chiaro_locale::{tr, tr_in};

use crate::library::{Library, Type};

/// True for a kind of node, or a group, that comes with Chiaro.
pub(crate) fn is_own(kind: &str) -> bool {
    let library = Library::built_in();
    library.nodes.contains_key(kind) || library.groups.contains_key(kind)
}

/// Text of a kind of node, such as its label or that of a port, as it is shown.
pub(crate) fn of<'a>(kind: &str, text: &'a str) -> &'a str {
    shown(is_own(kind), text)
}

/// Text of a node as it is shown: `is_own` tells whether its kind comes with Chiaro.
pub(crate) fn shown(is_own: bool, text: &str) -> &str {
    if is_own { tr_in("node", text) } else { text }
}

/// Name of a type.
pub(crate) fn of_type(ty: &Type) -> &str {
    match ty {
        Type::Float => tr!("type" => "float"),
        Type::Int => tr!("type" => "integer"),
        Type::Bool => tr!("type" => "switch"),
        Type::Vec2 => "vec2",
        Type::Vec3 => "vec3",
        Type::Vec4 => "vec4",
        Type::Color => tr!("type" => "color"),
        Type::Composite => tr!("type" => "composite"),
        Type::Mat3 => tr!("type" => "matrix"),
        Type::Angle => tr!("type" => "angle"),
        Type::Light => tr!("type" => "light"),
        Type::Curve => tr!("type" => "curve"),
        Type::Ramp => tr!("type" => "ramp"),
        Type::Image => tr!("type" => "image"),
        Type::Hcbtf => tr!("type" => "painted surface"),
        Type::Casters => tr!("type" => "casters"),
        Type::ShadowMaps => tr!("type" => "shadow maps"),
        Type::Choice => tr!("type" => "choice"),
        Type::LightName => tr!("type" => "light's id"),
        Type::Text => tr!("type" => "text"),
        Type::Prepared(name) => name,
    }
}
