//! Choices of whoever exports a look. They change a copy of it before it is compiled.

use std::sync::Arc;

use super::{live, tiers};
use crate::compile::check;
use crate::diag::Diagnostic;
use crate::document::{Look, Node, Storage, Value};
use crate::ids::{NodePath, PortName};
use crate::library::{Library, Type};

/// Choices of an export, beside what is exported to where.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExportOptions {
    /// True if nodes whose tier no export carries take the nearest that one does.
    pub takes_carried_tiers: bool,
    /// True if every value is a parameter, not only what the artist exposed.
    pub is_live: bool,
    /// Storage of painted surfaces; `None` for what fits the target.
    pub storage: Option<Storage>,
}

impl ExportOptions {
    /// Changes a look, and groups of the library that it uses, as these choices ask; `is_package`
    /// where it goes into a package. Returns what is to be told.
    ///
    /// # Errors
    /// All errors of the look.
    pub fn apply(
        &self,
        look: &mut Look,
        library: &mut Library,
        is_package: bool,
    ) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
        let mut told = Vec::new();
        if self.takes_carried_tiers {
            told.extend(tiers::take_carried_tiers(look, library));
        }
        store(look, library, self.storage, is_package)?;
        if self.is_live {
            told.extend(live::expose_all_values(look, library)?);
        }
        Ok(told)
    }
}

/// Gives all painted surfaces a storage. Without one, those of a package that are stored for speed
/// are stored in little room: a package is sent about, and its pictures are the same.
fn store(
    look: &mut Look,
    library: &mut Library,
    storage: Option<Storage>,
    is_package: bool,
) -> Result<(), Vec<Diagnostic>> {
    if storage.is_none() && !is_package {
        return Ok(());
    }
    let port = PortName::from("storage");
    let mut places = Vec::new();
    for node in check(look, library, None)?.value.nodes {
        let Some(input) = node.def.input(port.as_str()) else { continue };
        if !node.def.inputs.iter().any(|input| input.ty == Type::Hcbtf) {
            continue;
        }
        let now = node.choices.get(&input).and_then(|word| Storage::of(word)).unwrap_or_default();
        let wanted = storage.unwrap_or(match now {
            Storage::Quick => Storage::Compact,
            other => other,
        });
        if wanted != now {
            places.push((node.path.clone(), wanted));
        }
    }
    for (path, storage) in places {
        if let Some(node) = node_mut(look, library, &path) {
            node.values.insert(port.clone(), Value::Text(storage.word().to_owned()));
        }
    }
    Ok(())
}

/// The node at a path, in the look or in a group of its own or of the library.
pub(super) fn node_mut<'a>(
    look: &'a mut Look,
    library: &'a mut Library,
    path: &NodePath,
) -> Option<&'a mut Node> {
    let (last, outer) = path.ids().split_last()?;
    let Look { graph, definitions, .. } = look;
    let mut groups = outer.iter();
    let Some(mut group) = groups.next().and_then(|id| Some(graph.nodes.get(id)?.kind.clone()))
    else {
        return graph.nodes.get_mut(last).filter(|_| outer.is_empty());
    };
    loop {
        let inner = match definitions.get(group.as_str()) {
            Some(own) => &own.graph,
            None => &library.groups.get(&group)?.definition.graph,
        };
        let Some(id) = groups.next() else { break };
        group = inner.nodes.get(id)?.kind.clone();
    }
    let graph = match definitions.get_mut(group.as_str()) {
        Some(own) => &mut own.graph,
        None => &mut Arc::make_mut(library.groups.get_mut(&group)?).definition.graph,
    };
    graph.nodes.get_mut(last)
}
