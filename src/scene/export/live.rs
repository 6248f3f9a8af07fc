//! Every value of a look as a parameter, for programs in which the look is still being tuned.
//!
//! Values that the artist exposed keep their names. Others are called after their node and input:
//! `rim_offset`. A name depends on nothing but the look's own nodes, and of nodes that are called
//! alike the first keeps the plain name, so that names stay when values change or nodes are added.

use std::collections::{BTreeSet, HashMap, HashSet};

use chiaro_locale::tr;

use super::modules::{self, Modules};
use crate::compile::{HostStep, MAX_UNIFORM_BYTES, Param, ParamId, TypedGraph, check, node_title};
use crate::diag::Diagnostic;
use crate::document::{ExposedValue, Look, Target};
use crate::ids::{NodePath, PortName, is_slug, make_slug};
use crate::library::Library;

/// Most values that are asked for: no uniform holds more.
const MOST_VALUES: usize = MAX_UNIFORM_BYTES as usize / 4;

/// Number of values that a warning names.
const MOST_NAMED: usize = 6;

/// Greatest length of a name, as documents take it.
const LONGEST_NAME: usize = 64;

/// Exposes every value of a look that its modules can read from a uniform; returns warnings of
/// those that find no room there. Choices, images and what reaches nothing stay as they are.
///
/// # Errors
/// All errors of the look, as its export would report them.
pub(super) fn expose_all_values(
    look: &mut Look,
    library: &Library,
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let exposed = look.exposed.len();
    let typed = check(look, library, None)?.value;
    look.exposed.extend(values(look, library, &typed));
    let typed = check(look, library, None)?.value;
    let found = modules::compile(&typed, "")?;
    let live = live_values(&found);
    let by_place: HashMap<(&NodePath, &PortName), ParamId> = typed
        .params
        .iter()
        .enumerate()
        .map(|(id, param)| ((&param.path, &param.port), id))
        .collect();
    let is_live = |value: &ExposedValue| match &value.target {
        Target::Input { node, port } => {
            by_place.get(&(node, port)).is_some_and(|id| live.contains(id))
        }
        Target::Light { .. } => false,
    };
    let added = look.exposed.split_off(exposed);
    look.exposed.extend(added.into_iter().filter(is_live));
    fit(look, library, (exposed, size(&found)))
}

/// Takes values away from the end until what is left fits into the largest uniform.
fn fit(
    look: &mut Look,
    library: &Library,
    (exposed, mut size): (usize, u32),
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let all = look.exposed.clone();
    while size > MAX_UNIFORM_BYTES && look.exposed.len() > exposed {
        let added = look.exposed.len() - exposed;
        let share = f64::from(MAX_UNIFORM_BYTES) / f64::from(size);
        let kept = ((added as f64 * share) as usize).min(added - 1);
        look.exposed.truncate(exposed + kept);
        let typed = check(look, library, None)?.value;
        size = self::size(&modules::compile(&typed, "")?);
    }
    let left_out = &all[look.exposed.len()..];
    if left_out.is_empty() {
        return Ok(Vec::new());
    }
    let named: Vec<&str> = left_out.iter().take(MOST_NAMED).map(|v| v.name.as_str()).collect();
    let names = match left_out.len() - named.len() {
        0 => named.join(", "),
        more => tr!("{names} and {more} more", names = named.join(", ")),
    };
    let message = tr!(
        "{count} of {all} values are no parameters: the uniform has no room beyond {most} KiB for \
         {names}",
        count = left_out.len(),
        all = all.len() - exposed,
        most = MAX_UNIFORM_BYTES / 1024
    );
    let hint = tr!("expose those that you want to set, in the window or in the look's `exposed`");
    Ok(vec![Diagnostic::warning("uniform-full", message).hint(hint)])
}

/// Values of the artist's own nodes, in the order of the document and of the nodes' inputs.
fn values(look: &Look, library: &Library, typed: &TypedGraph) -> Vec<ExposedValue> {
    let is_exposed: HashSet<(&NodePath, &PortName)> = look
        .exposed
        .iter()
        .filter_map(|exposed| match &exposed.target {
            Target::Input { node, port } => Some((node, port)),
            Target::Light { .. } => None,
        })
        .collect();
    let mut names = ParameterNames::new(look, library);
    let is_open = |param: &&Param| {
        let is_known = is_exposed.contains(&(&param.path, &param.port));
        param.value.is_some() && !is_known && is_of_artist(look, &param.path)
    };
    let mut open: Vec<&Param> = typed.params.iter().filter(is_open).collect();
    let mut places: HashMap<&NodePath, usize> = HashMap::new();
    for (index, param) in open.iter().enumerate() {
        places.entry(&param.path).or_insert(index);
    }
    open.sort_by_cached_key(|param| {
        let outermost = param.path.ids().first().and_then(|id| look.graph.nodes.get_index_of(id));
        let port = port_position(look, library, param);
        (outermost, places.get(&param.path).copied(), port)
    });
    open.truncate(MOST_VALUES);
    let value = |param: &Param| ExposedValue {
        name: names.give(param),
        target: Target::Input { node: param.path.clone(), port: param.port.clone() },
        label: String::new(),
    };
    open.into_iter().map(value).collect()
}

/// Position of a value's input among those of its node, as the window lists them.
fn port_position(look: &Look, library: &Library, param: &Param) -> Option<usize> {
    let kind = look.find(&param.path)?.node.kind.as_str();
    match library.group_of(look, kind) {
        Some(group) => group.inputs.iter().position(|input| input.name == param.port),
        None => library.nodes.get(kind)?.input(param.port.as_str()),
    }
}

/// True for a node that no group of the library holds.
fn is_of_artist(look: &Look, path: &NodePath) -> bool {
    look.find(path).is_some()
}

/// Values that any module reads from its uniform.
fn live_values(found: &Modules) -> BTreeSet<ParamId> {
    let steps = found.modules.iter().filter_map(|module| module.host());
    let id = |step: &HostStep| if let HostStep::Param { id, .. } = step { Some(*id) } else { None };
    steps.flat_map(|host| &host.source.steps).filter_map(id).collect()
}

/// Size of the largest `Look` uniform, in bytes.
fn size(found: &Modules) -> u32 {
    let hosts = found.modules.iter().filter_map(|module| module.host());
    hosts.map(|host| host.shader.host.size).max().unwrap_or_default()
}

/// Names of parameters, each given once.
struct ParameterNames<'a> {
    look: &'a Look,
    library: &'a Library,
    given: HashSet<String>,
    /// Beginnings of names, by node.
    of_nodes: HashMap<NodePath, String>,
    beginnings: HashSet<String>,
}

impl<'a> ParameterNames<'a> {
    fn new(look: &'a Look, library: &'a Library) -> Self {
        let given = look.exposed.iter().map(|exposed| exposed.name.to_string()).collect();
        let (of_nodes, beginnings) = (HashMap::new(), HashSet::new());
        Self { look, library, given, of_nodes, beginnings }
    }

    /// The name of a value: that of its node, and that of its input.
    fn give(&mut self, param: &Param) -> PortName {
        let node = match self.of_nodes.get(&param.path) {
            Some(known) => known.clone(),
            None => self.name_node(&param.path),
        };
        let port = param.port.as_str();
        let room = LONGEST_NAME.saturating_sub(port.len() + "__2000".len());
        let name = format!("{}_{port}", &node[..node.len().min(room)]);
        let numbered = (2_u64..).map(|number| format!("{name}_{number}"));
        let mut names = std::iter::once(name.clone()).chain(numbered);
        let name = names.find(|name| !self.given.contains(name)).unwrap_or(name);
        self.given.insert(name.clone());
        PortName::new(name)
    }

    /// The beginning of the names of a node's values: its name, or its id where another node has
    /// that name, or where it has no letters that names may have.
    fn name_node(&mut self, path: &NodePath) -> String {
        let title = node_title(self.look, self.library, path);
        let ids: Vec<&str> = path.ids().iter().map(|id| id.as_str()).collect();
        let ids = ids.join("_");
        let slug = make_slug(&title, |_| false);
        let is_taken = self.beginnings.contains(&slug);
        let is_foreign = !title.starts_with(|c: char| c.is_ascii_alphabetic()) || !is_slug(&slug);
        let name = if is_foreign || is_taken {
            make_slug(&ids, |name| self.beginnings.contains(name))
        } else {
            slug
        };
        self.beginnings.insert(name.clone());
        self.of_nodes.insert(path.clone(), name.clone());
        name
    }
}
