//! Warnings for looks that read texture coordinates, or the tangents that follow them, on meshes
//! that have none.

use std::collections::HashSet;

use chiaro_locale::tr;

use super::setup::{Setup, SetupLook, SetupObject};
use crate::compile::{
    CompileOptions, CompiledShader, TypedSource, VertexAttribute, check, compile,
};
use crate::diag::{Diagnostic, WithWarnings};
use crate::ids::NodePath;
use crate::library::{Context, Library, Treatment};

/// Greatest number of nodes that a message names; further nodes are counted.
const MOST_NAMED: usize = 3;

/// Inputs of a look that a mesh without UVs cannot give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MissingInput {
    /// Texture coordinates, which are 0.
    Uvs,
    /// Tangents alone, which lie level; that may be intended.
    Tangents,
}

impl MissingInput {
    /// The inputs that a shader lacks on such a mesh; the graver one of both.
    pub(super) fn of(shader: &CompiledShader) -> Option<Self> {
        let reads = |lack: &Self| shader.needs.contexts.iter().any(|c| lack.is_of(*c));
        [Self::Uvs, Self::Tangents].into_iter().find(reads)
    }

    /// True if a context is made from the lacking attribute.
    fn is_of(self, context: Context) -> bool {
        let attribute = match self {
            Self::Uvs => VertexAttribute::Uv,
            Self::Tangents => VertexAttribute::Tangent,
        };
        VertexAttribute::read_by(context).contains(&attribute)
    }
}

/// A warning for each object whose look reads UVs that its mesh does not have, and a note where it
/// reads tangents alone, whether or not the object is in sight. Looks that cannot be compiled are
/// passed over.
pub fn missing_uvs(setup: &Setup, library: &Library) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for object in setup.objects.iter().filter(|object| !object.mesh.has_uvs) {
        for &index in &worn(object) {
            let look = &setup.looks[index];
            let Ok(compiled) = compile(&look.look, library, &CompileOptions::default()) else {
                continue;
            };
            let shader = compiled.value;
            if let Some(lack) = MissingInput::of(&shader) {
                found.push(without_uvs(object, look, lack, &readers(look, &shader, lack, library)));
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

/// The diagnostic for an object whose mesh has no UVs, where `readers` are the nodes of its look
/// that read what the mesh lacks.
pub(super) fn without_uvs(
    object: &SetupObject,
    look: &SetupLook,
    lack: MissingInput,
    readers: &[NodePath],
) -> Diagnostic {
    let named: Vec<String> =
        readers.iter().take(MOST_NAMED).map(|path| format!("`{path}`")).collect();
    let more = readers.len() - named.len();
    let named = if more > 0 {
        tr!("{names} and {more} more", names = named.join(", "))
    } else {
        named.join(", ")
    };
    let by = if named.is_empty() { String::new() } else { tr!(", by {named}") };
    let subject = subject(object);
    let problem = match lack {
        MissingInput::Uvs => {
            let message =
                tr!("{subject} has no UVs, which its look reads{by}: they are 0 all over it");
            Diagnostic::warning("no-uvs", message).hint(tr!(
                "unwrap the mesh in a modeling program, wire other coordinates into the node's \
                 UV, or show the look on a \
                 shape that has UVs (`shape:sphere`)"
            ))
        }
        MissingInput::Tangents => {
            let message = tr!(
                "{subject} has no UVs, along which its look's tangents would run{by}: they lie \
                 level"
            );
            Diagnostic::note("level-tangents", message).hint(tr!(
                "for highlights, wire Axes around a direction into the node's X axis and Y axis; \
                 for strokes that follow the form, unwrap the mesh in a modeling program"
            ))
        }
    };
    let mut problem = match readers.first() {
        Some(path) => problem.node(path.clone()),
        None => problem,
    };
    look.source.locate(&mut problem);
    problem
}

/// The subject of the message: the mesh and the object that the warning is about.
fn subject(object: &SetupObject) -> String {
    tr!("the mesh `{name}` of object `{id}`", name = object.mesh.name, id = object.id)
}

/// The nodes in a look's module that read what a mesh lacks.
pub(super) fn readers(
    look: &SetupLook,
    shader: &CompiledShader,
    lack: MissingInput,
    library: &Library,
) -> Vec<NodePath> {
    let Ok(WithWarnings { value: typed, .. }) = check(&look.look, library, None) else {
        return Vec::new();
    };
    let emitted: HashSet<&NodePath> = shader.spans.nodes().collect();
    let is_reader = |node: &&crate::compile::TypedNode| {
        let mut inputs = node.inputs.iter().flatten();
        node.def.special != Treatment::Output
            && emitted.contains(&node.path)
            && inputs
                .any(|input| matches!(input.source, TypedSource::Context(of) if lack.is_of(of)))
    };
    typed.nodes.iter().filter(is_reader).map(|node| node.path.clone()).collect()
}
