//! Inputs of the look's node: the exposed parameters that change the picture.

use chiaro_locale::tr;

use super::super::{PackageRequest, refusal};
use super::literal;
use crate::diag::Diagnostic;
use crate::document::{Light, Target};
use crate::export::description::ExposedParameter;
use crate::ids::LightId;
use crate::interp::{Scalar, Value};
use crate::library::Type;

/// An input of the node.
#[derive(Clone, Debug)]
pub(super) struct NodeInput<'a> {
    /// Name under which the artist exposed the value.
    pub(super) name: &'a str,
    /// Type in MaterialX, and in GLSL.
    pub(super) ty: (&'static str, &'static str),
    /// Value in the look.
    pub(super) default: Value,
    /// Description for people.
    pub(super) told: &'a ExposedParameter,
    /// The light's field that the input sets; `None` for inputs of nodes.
    pub(super) light: Option<(&'a LightId, &'a str)>,
}

/// Types of a parameter in MaterialX and in GLSL.
pub(super) fn types(ty: &Type) -> Option<(&'static str, &'static str)> {
    Some(match ty {
        Type::Float => ("float", "float"),
        Type::Int => ("integer", "int"),
        Type::Bool => ("boolean", "bool"),
        Type::Vec2 => ("vector2", "vec2"),
        Type::Vec3 => ("vector3", "vec3"),
        Type::Vec4 => ("vector4", "vec4"),
        Type::Color | Type::Composite => ("color4", "vec4"),
        Type::Mat3 => ("matrix33", "mat3"),
        _ => return None,
    })
}

/// The inputs, in the artist's order.
///
/// # Errors
/// - `not-in-package`: a parameter that is taken as two types.
pub(super) fn inputs<'a>(
    request: &'a PackageRequest<'a>,
) -> Result<Vec<NodeInput<'a>>, Diagnostic> {
    let mut found = Vec::new();
    for (index, told) in request.description.parameters.iter().enumerate() {
        let Some(name) = told.name.as_ref().filter(|_| told.live) else { continue };
        let exposed = request.look.exposed.iter().find(|exposed| exposed.name == *name);
        let input = match exposed.map(|exposed| &exposed.target) {
            Some(Target::Light { light, field }) => {
                let Some((ty, default)) = light_field(request, light, field) else { continue };
                let light = Some((light, field.as_str()));
                NodeInput { name: name.as_str(), ty, default, told, light }
            }
            _ => {
                let mut settings =
                    request.work.parameters.iter().filter(|setting| setting.index == index);
                let Some(setting) = settings.next() else { continue };
                if settings.next().is_some() {
                    return Err(refusal(
                        tr!("the parameter `{name}` is taken as two types"),
                        tr!("give each node that reads the parameter a parameter of its own"),
                    ));
                }
                let Some(ty) = types(&setting.ty) else { continue };
                let default = setting.default.clone();
                NodeInput { name: name.as_str(), ty, default, told, light: None }
            }
        };
        found.push(input);
    }
    Ok(found)
}

/// Type and value of a field of a light that the host work reads.
fn light_field(
    request: &PackageRequest<'_>,
    id: &LightId,
    field: &str,
) -> Option<((&'static str, &'static str), Value)> {
    let light = &request.work.lights.iter().find(|light| light.id == *id)?.light;
    let (_, numbers) = fields(light).into_iter().find(|(name, _)| *name == field)?;
    let vector = || Value::Vector(numbers.iter().map(|x| Scalar::Float(*x)).collect());
    Some(match (field, numbers.as_slice()) {
        (_, [x]) => (("float", "float"), Value::Float(*x)),
        ("color", _) => (("color3", "vec3"), vector()),
        _ => (("vector3", "vec3"), vector()),
    })
}

/// Numbers of a light as the host work's struct has them, in its order.
pub(super) fn fields(light: &Light) -> Vec<(&'static str, Vec<f64>)> {
    vec![
        ("direction", light.direction.to_vec()),
        ("position", light.position.to_vec()),
        ("aim", light.aim.to_vec()),
        ("color", light.color.to_vec()),
        ("intensity", vec![light.intensity]),
        ("inner", vec![light.inner]),
        ("outer", vec![light.outer]),
        ("half_distance", vec![light.half_distance]),
        ("range", vec![light.range]),
        // Neither aimed at another object nor in shadow maps.
        ("aimed_at", vec![0.0; 4]),
        ("shadow_map", vec![0.0, 0.0, 1.0, -1.0]),
    ]
}

/// Numbers of a light in GLSL, a line for each number and vector: `given` has what inputs set.
pub(super) fn light_text(light: &Light, given: impl Fn(&str) -> Option<String>) -> String {
    let fields = fields(light);
    let last = fields.len() - 1;
    let mut text = String::new();
    for (index, (name, numbers)) in fields.iter().enumerate() {
        let own = || match numbers.as_slice() {
            [x] => literal::number(*x),
            _ => literal::vector(&format!("vec{}", numbers.len()), numbers),
        };
        let value = given(name).unwrap_or_else(own);
        let end = if index == last { "" } else { "," };
        text += &format!("        {value}{end} // {}\n", name.replace('_', " "));
    }
    text
}
