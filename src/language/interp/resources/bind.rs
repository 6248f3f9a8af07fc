//! Binding of resources to a program, with checks that they fit.

use std::collections::BTreeMap;

use chiaro_locale::tr;

use super::{
    BoundContent, BoundResources, Resource, ResourceKind, Sampler, Texture, TextureDimension,
};
use crate::diag::Diagnostic;
use crate::interp::lanes::Lanes;
use crate::interp::{Machine, Precision, Program, Shape, Value};

/// Greatest number of scalars in a buffer: 512 MiB.
const MAX_SCALARS: u64 = 1 << 26;

#[derive(Clone, Debug)]
enum ResourceContent {
    Value(Value),
    Texture(Texture),
    Sampler(Sampler),
}

/// Resources to bind, by group and binding. Resources that a program does not ask for do no harm.
#[derive(Clone, Debug, Default)]
pub struct Bindings {
    contents: BTreeMap<(u32, u32), ResourceContent>,
}

impl Bindings {
    /// Bindings without resources.
    pub fn new() -> Self {
        Self::default()
    }

    /// Binds the whole value of a uniform or storage buffer; an array of any length is the last
    /// part of the value.
    pub fn buffer(&mut self, group: u32, binding: u32, value: Value) -> &mut Self {
        self.contents.insert((group, binding), ResourceContent::Value(value));
        self
    }

    /// Binds a texture.
    pub fn texture(&mut self, group: u32, binding: u32, texture: Texture) -> &mut Self {
        self.contents.insert((group, binding), ResourceContent::Texture(texture));
        self
    }

    /// Binds a sampler.
    pub fn sampler(&mut self, group: u32, binding: u32, sampler: Sampler) -> &mut Self {
        self.contents.insert((group, binding), ResourceContent::Sampler(sampler));
        self
    }
}

/// Program with all resources that it reads, from which machines are made, on any number of
/// threads.
#[derive(Clone, Debug)]
pub struct BoundProgram<'p> {
    program: &'p Program,
    precision: Precision,
    contents: Vec<BoundContent>,
}

impl<'p> BoundProgram<'p> {
    pub(in crate::interp) fn new(
        program: &'p Program,
        bindings: &Bindings,
        precision: Precision,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let mut contents = Vec::new();
        for resource in program.resources() {
            match bound_content(
                resource,
                bindings.contents.get(&(resource.group, resource.binding)),
                precision,
            ) {
                Ok(content) => contents.push(content),
                Err(problem) => problems.push(problem),
            }
        }
        if problems.is_empty() { Ok(Self { program, precision, contents }) } else { Err(problems) }
    }

    /// Program that the resources are bound to.
    pub fn program(&self) -> &'p Program {
        self.program
    }

    /// Precision of floats.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// Machine with memory in which the program runs one call after the other.
    pub fn machine(&self) -> Machine<'_> {
        Machine::new(self.program, self.precision, &self.contents)
    }

    /// Lanes with memory in which the program runs for many lanes at once.
    ///
    /// # Errors
    /// `interp-too-big`: the program's variables take more memory than lanes are granted (512 MiB).
    pub fn lanes(&self) -> Result<Lanes<'_>, Diagnostic> {
        Lanes::new(self)
    }

    pub(in crate::interp) fn resources(&self) -> BoundResources<'_> {
        BoundResources { contents: &self.contents, operations: &self.program.operations }
    }
}

/// Content bound to one resource, if the content fits.
fn bound_content(
    resource: &Resource,
    content: Option<&ResourceContent>,
    precision: Precision,
) -> Result<BoundContent, Diagnostic> {
    let Resource { group, binding, name, kind } = resource;
    let wrong = |message: String| {
        let message = tr!("`{name}` (@group({group}) @binding({binding})) {message}");
        Diagnostic::error("interp-binding", message)
    };
    let Some(content) = content else {
        return Err(wrong(tr!("is {expected}, and nothing is bound", expected = describe(kind))));
    };
    let bound = match (kind, content) {
        (ResourceKind::Buffer(shape), ResourceContent::Value(value)) => {
            fixed(shape, value, precision)
        }
        (ResourceKind::Unsized { head, element }, ResourceContent::Value(value)) => {
            runtime_sized(head.as_deref(), element, value, precision)
        }
        (
            ResourceKind::Texture { dimension, is_arrayed, .. },
            ResourceContent::Texture(texture),
        ) => {
            let fits = texture.dimension() == *dimension && (*is_arrayed || texture.layers() == 1);
            fits.then(|| BoundContent::Texture(texture.clone()))
        }
        (ResourceKind::Sampler { is_comparison }, ResourceContent::Sampler(sampler)) => {
            (sampler.compare.is_some() == *is_comparison).then_some(BoundContent::Sampler(*sampler))
        }
        _ => None,
    };
    bound.ok_or_else(|| {
        wrong(tr!(
            "is {expected}, but {bound} was bound",
            expected = describe(kind),
            bound = describe_content(content)
        ))
    })
}

fn fixed(shape: &Shape, value: &Value, precision: Precision) -> Option<BoundContent> {
    let mut scalars = vec![0; shape.slots() as usize];
    shape.write(value, precision, &mut scalars)?;
    Some(BoundContent::Buffer { scalars, length: 0 })
}

fn runtime_sized(
    head: Option<&[(String, Shape)]>,
    element: &Shape,
    value: &Value,
    precision: Precision,
) -> Option<BoundContent> {
    let (before, elements) = match (head, value) {
        (None, Value::Array(elements)) => (&[][..], elements),
        (Some(head), Value::Struct(members)) if members.len() == head.len() + 1 => {
            let (last, before) = members.split_last()?;
            let Value::Array(elements) = last else { return None };
            (before, elements)
        }
        _ => return None,
    };
    let head_slots: u64 = head.unwrap_or(&[]).iter().map(|(_, shape)| shape.slots()).sum();
    let count = elements.len() as u64;
    let total = element.slots().checked_mul(count)?.checked_add(head_slots)?;
    // WebGPU refuses a binding that has no room for one element.
    if count == 0 || total > MAX_SCALARS {
        return None;
    }
    let mut scalars = vec![0; total as usize];
    let mut slots = scalars.as_mut_slice();
    for ((_, shape), value) in head.unwrap_or(&[]).iter().zip(before) {
        slots = shape.write(value, precision, slots)?;
    }
    for value in elements {
        slots = element.write(value, precision, slots)?;
    }
    Some(BoundContent::Buffer { scalars, length: count as u32 })
}

fn describe(kind: &ResourceKind) -> String {
    match kind {
        ResourceKind::Buffer(shape) => tr!("a buffer of {shape}"),
        ResourceKind::Unsized { head: None, element } => {
            tr!("a buffer of one or more {element}")
        }
        ResourceKind::Unsized { head: Some(head), element } => {
            let members: Vec<String> = head.iter().map(|(_, shape)| shape.to_string()).collect();
            tr!("a buffer of {members} and one or more {element}", members = members.join(", "))
        }
        ResourceKind::Texture { dimension, is_arrayed, .. } => {
            describe_texture(*dimension, *is_arrayed)
        }
        ResourceKind::Sampler { is_comparison: true } => tr!("a comparison sampler").to_owned(),
        ResourceKind::Sampler { is_comparison: false } => tr!("a sampler").to_owned(),
    }
}

fn describe_content(content: &ResourceContent) -> String {
    match content {
        ResourceContent::Value(value) => value.describe(),
        ResourceContent::Texture(texture) => {
            describe_texture(texture.dimension(), texture.layers() > 1)
        }
        ResourceContent::Sampler(Sampler { compare: Some(_), .. }) => {
            tr!("a comparison sampler").to_owned()
        }
        ResourceContent::Sampler(_) => tr!("a sampler").to_owned(),
    }
}

fn describe_texture(dimension: TextureDimension, is_arrayed: bool) -> String {
    let what = match dimension {
        TextureDimension::D1 => tr!("a 1D texture"),
        TextureDimension::D2 => tr!("a 2D texture"),
        TextureDimension::D3 => tr!("a 3D texture"),
        TextureDimension::Cube => tr!("a cube texture"),
    };
    if is_arrayed { tr!("{what} with layers") } else { what.to_owned() }
}
