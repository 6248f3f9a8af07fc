//! Looks that read texture coordinates, on meshes that have none.

use std::collections::HashSet;

use super::setup::{Setup, SetupLook, SetupObject};
use crate::compile::{CompiledShader, Options, TypedSource, check, compile};
use crate::diag::Diagnostic;
use crate::ids::NodePath;
use crate::library::{Context, Library, Special};

/// More nodes than this are counted and not named.
const MOST_NAMED: usize = 3;

/// A warning for each object whose look reads UVs that its mesh does not have, whether or not the object is in sight. Looks
/// that cannot be compiled are passed over.
pub fn missing_uvs(setup: &Setup, library: &Library) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for object in setup.objects.iter().filter(|object| !object.mesh.has_uvs) {
        for &index in &worn(object) {
            let look = &setup.looks[index];
            let shader = compile(&look.look, library, &Options::default()).ok();
            if let Some(shader) = shader.filter(|shader| shader.needs.context(Context::Uv)) {
                found.push(without_uvs(object, look, &readers(look, &shader, library)));
            }
        }
    }
    found
}

/// The looks that an object wears, each once.
fn worn(object: &SetupObject) -> Vec<usize> {
    let mut worn: Vec<usize> = object.looks.iter().flatten().copied().collect();
    worn.sort_unstable();
    worn.dedup();
    worn
}

/// The warning of an object whose mesh has no UVs, which these nodes of its look read.
pub(super) fn without_uvs(object: &SetupObject, look: &SetupLook, readers: &[NodePath]) -> Diagnostic {
    let named: Vec<String> = readers.iter().take(MOST_NAMED).map(|path| format!("`{path}`")).collect();
    let more = readers.len() - named.len();
    let named = if more > 0 { format!("{} and {more} more", named.join(", ")) } else { named.join(", ") };
    let by = if named.is_empty() { String::new() } else { format!(", by {named}") };
    let message = format!("{} has no UVs, which its look reads{by}: they are 0 all over it", subject(object));
    let problem = Diagnostic::warning("no-uvs", message).hint(
        "unwrap the mesh in a modelling program, wire other coordinates into the node's UV, or show the look on a shape that \
         has UVs (`shape:sphere`)",
    );
    let mut problem = match readers.first() {
        Some(path) => problem.node(path.clone()),
        None => problem,
    };
    look.source.locate(&mut problem);
    problem
}

/// What the message begins with: whose warning it is.
fn subject(object: &SetupObject) -> String {
    format!("the mesh `{}` of object `{}`", object.mesh.name, object.id)
}

/// The nodes in a look's module that read UVs.
pub(super) fn readers(look: &SetupLook, shader: &CompiledShader, library: &Library) -> Vec<NodePath> {
    let Ok((typed, _)) = check(&look.look, library, None) else { return Vec::new() };
    let emitted: HashSet<&NodePath> = shader.spans.nodes().collect();
    let is_reader = |node: &&crate::compile::TypedNode| {
        let mut inputs = node.inputs.iter().flatten();
        node.def.special != Special::Output
            && emitted.contains(&node.path)
            && inputs.any(|input| input.source == TypedSource::Context(Context::Uv))
    };
    typed.nodes.iter().filter(is_reader).map(|node| node.path.clone()).collect()
}
