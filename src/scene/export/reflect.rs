//! Reflection of naga modules: entry points, bindings, and the layout of uniforms.

use naga::{AddressSpace, ImageClass, Module, ShaderStage, TypeInner};
use serde::Serialize;

/// An entry point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EntryPoint {
    /// Name of the entry point in WGSL; a language may name it differently.
    pub name: String,
    /// Stage: `vertex` or `fragment`.
    pub stage: &'static str,
    /// Attributes of a vertex shader; empty for a fragment shader.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub attributes: Vec<AttributeDescription>,
    /// Outputs of a fragment shader; empty for a vertex shader.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub outputs: Vec<LocatedValue>,
}

/// A vertex attribute.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AttributeDescription {
    /// Location of the attribute.
    pub location: u32,
    /// Name of the attribute.
    pub name: String,
    /// Type of the attribute, in WGSL.
    #[serde(rename = "type")]
    pub ty: String,
    /// Meaning of the attribute for a mesh.
    pub semantic: &'static str,
}

/// An argument or a result at a location.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LocatedValue {
    /// Location of the value.
    pub location: u32,
    /// Name of the value; empty where it has none.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Type of the value, in WGSL.
    #[serde(rename = "type")]
    pub ty: String,
}

/// Kind of a binding for a graphics API.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum BindingType {
    /// A uniform buffer.
    Uniform,
    /// A storage buffer, read only.
    Storage,
    /// A sampled texture.
    Texture,
    /// A sampler.
    Sampler,
}

/// A global variable with a binding.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BoundVariable {
    /// Group of the binding.
    pub group: u32,
    /// Number of the binding in the group.
    pub binding: u32,
    /// Name of the variable.
    pub name: String,
    /// Kind of the binding.
    pub kind: BindingType,
    /// Type of the variable, in WGSL.
    pub ty: String,
    /// Size of a buffer, rounded up to 16; 0 for other kinds. In bytes.
    pub size: u32,
    /// Members of a buffer's struct.
    pub members: Vec<Member>,
}

/// A member of a struct in a buffer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Member {
    /// Name of the member.
    pub name: String,
    /// Type of the member, in WGSL.
    #[serde(rename = "type")]
    pub ty: String,
    /// Offset of the member from the start of the struct that it belongs to, in bytes.
    pub offset: u32,
    /// Size of the member, in bytes.
    pub size: u32,
    /// Distance from one column of a matrix or one element of an array to the next, in bytes; 0 for
    /// other types.
    #[serde(skip_serializing_if = "is_zero")]
    pub stride: u32,
    /// Members of a struct, or of an array's elements.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<Member>,
}

fn is_zero(number: &u32) -> bool {
    *number == 0
}

/// The entry points, vertex before fragment.
pub(super) fn entry_points(module: &Module) -> Vec<EntryPoint> {
    let point = |point: &naga::EntryPoint| {
        let arguments =
            point.function.arguments.iter().map(|a| (a.name.clone(), a.ty, a.binding.as_ref()));
        let inputs: Vec<LocatedValue> =
            arguments.flat_map(|(name, ty, binding)| located(module, name, ty, binding)).collect();
        let outputs = point
            .function
            .result
            .iter()
            .flat_map(|r| located(module, None, r.ty, r.binding.as_ref()));
        let is_vertex = point.stage == ShaderStage::Vertex;
        EntryPoint {
            name: point.name.clone(),
            stage: stage_name(point.stage),
            attributes: if is_vertex {
                inputs.into_iter().map(attribute).collect()
            } else {
                Vec::new()
            },
            outputs: if is_vertex { Vec::new() } else { outputs.collect() },
        }
    };
    module.entry_points.iter().map(point).collect()
}

/// A stage's name.
pub(super) fn stage_name(stage: ShaderStage) -> &'static str {
    match stage {
        ShaderStage::Vertex => "vertex",
        ShaderStage::Fragment => "fragment",
        _ => "compute",
    }
}

fn attribute(found: LocatedValue) -> AttributeDescription {
    let semantic = match found.name.as_str() {
        "position" => "position in object space",
        "normal" => "unit normal in object space",
        "tangent" => {
            "unit tangent along u in object space; w is 1, or -1 where the bitangent is mirrored"
        }
        "uv" => "texture coordinates, v up",
        "color" => "straight RGBA; white where the mesh has none",
        _ => "",
    };
    AttributeDescription { location: found.location, name: found.name, ty: found.ty, semantic }
}

/// All values with a location in an argument or a result.
fn located(
    module: &Module,
    name: Option<String>,
    ty: naga::Handle<naga::Type>,
    binding: Option<&naga::Binding>,
) -> Vec<LocatedValue> {
    if let Some(naga::Binding::Location { location, .. }) = binding {
        return vec![LocatedValue {
            location: *location,
            name: name.unwrap_or_default(),
            ty: type_name(module, ty),
        }];
    }
    let TypeInner::Struct { members, .. } = &module.types[ty].inner else { return Vec::new() };
    let of_member = |member: &naga::StructMember| match &member.binding {
        Some(naga::Binding::Location { location, .. }) => Some(LocatedValue {
            location: *location,
            name: member.name.clone().unwrap_or_default(),
            ty: type_name(module, member.ty),
        }),
        _ => None,
    };
    members.iter().filter_map(of_member).collect()
}

/// The values that go from the vertex shader to the fragment shader.
pub(super) fn varyings(module: &Module) -> Vec<LocatedValue> {
    let vertex = module.entry_points.iter().filter(|point| point.stage == ShaderStage::Vertex);
    let results = vertex.filter_map(|point| point.function.result.as_ref());
    results.flat_map(|result| located(module, None, result.ty, result.binding.as_ref())).collect()
}

/// The bindings, in the order of the source.
pub(super) fn bindings(module: &Module) -> Vec<BoundVariable> {
    module.global_variables.iter().filter_map(|(_, variable)| bound(module, variable)).collect()
}

fn bound(module: &Module, variable: &naga::GlobalVariable) -> Option<BoundVariable> {
    let at = variable.binding.as_ref()?;
    let inner = &module.types[variable.ty].inner;
    let kind = match (variable.space, inner) {
        (AddressSpace::Uniform, _) => BindingType::Uniform,
        (_, TypeInner::Image { .. }) => BindingType::Texture,
        (_, TypeInner::Sampler { .. }) => BindingType::Sampler,
        _ => BindingType::Storage,
    };
    let members = match inner {
        TypeInner::Struct { members, .. } => members.iter().map(|m| member(module, m)).collect(),
        _ => Vec::new(),
    };
    let size = if kind == BindingType::Uniform {
        inner.size(module.to_ctx()).next_multiple_of(16)
    } else {
        0
    };
    let (group, binding) = (at.group, at.binding);
    let (name, ty) = (variable.name.clone().unwrap_or_default(), type_name(module, variable.ty));
    Some(BoundVariable { group, binding, name, kind, ty, size, members })
}

/// The description of a member. Recursion is bounded: WGSL has no recursive types, and those of a
/// look nest a few levels deep.
fn member(module: &Module, found: &naga::StructMember) -> Member {
    let inner = &module.types[found.ty].inner;
    let (stride, element) = match inner {
        TypeInner::Matrix { rows, .. } => {
            (if *rows == naga::VectorSize::Bi { 8 } else { 16 }, None)
        }
        TypeInner::Array { base, stride, .. } => (*stride, Some(*base)),
        TypeInner::Struct { .. } => (0, Some(found.ty)),
        _ => (0, None),
    };
    let members = match element.map(|element| &module.types[element].inner) {
        Some(TypeInner::Struct { members, .. }) => {
            members.iter().map(|inside| member(module, inside)).collect()
        }
        _ => Vec::new(),
    };
    Member {
        name: found.name.clone().unwrap_or_default(),
        ty: type_name(module, found.ty),
        offset: found.offset,
        size: inner.size(module.to_ctx()),
        stride,
        members,
    }
}

/// The name of a type in WGSL.
fn type_name(module: &Module, ty: naga::Handle<naga::Type>) -> String {
    let named = &module.types[ty];
    match &named.inner {
        TypeInner::Scalar(scalar) => scalar_name(*scalar),
        TypeInner::Vector { size, scalar } => format!("vec{}{}", *size as u32, suffix(*scalar)),
        TypeInner::Matrix { columns, rows, scalar } => {
            format!("mat{}x{}{}", *columns as u32, *rows as u32, suffix(*scalar))
        }
        TypeInner::Array { base, size, .. } => match size {
            naga::ArraySize::Constant(count) => {
                format!("array<{}, {count}>", type_name(module, *base))
            }
            _ => format!("array<{}>", type_name(module, *base)),
        },
        TypeInner::Image { class: ImageClass::Depth { .. }, .. } => "texture_depth_2d".to_owned(),
        TypeInner::Image { arrayed: true, .. } => "texture_2d_array<f32>".to_owned(),
        TypeInner::Image { .. } => "texture_2d<f32>".to_owned(),
        TypeInner::Sampler { .. } => "sampler".to_owned(),
        _ => named.name.clone().unwrap_or_default(),
    }
}

fn scalar_name(scalar: naga::Scalar) -> String {
    match scalar.kind {
        naga::ScalarKind::Bool => "bool".to_owned(),
        kind => format!("{}{}", letter(kind), u32::from(scalar.width) * 8),
    }
}

fn suffix(scalar: naga::Scalar) -> String {
    match scalar.kind {
        naga::ScalarKind::Bool => "<bool>".to_owned(),
        kind => letter(kind).to_string(),
    }
}

fn letter(kind: naga::ScalarKind) -> char {
    match kind {
        naga::ScalarKind::Sint => 'i',
        naga::ScalarKind::Uint => 'u',
        _ => 'f',
    }
}
