//! Pictures of parts on their way from folder to folder. What lies with a look, or with a part, is
//! its own, and is copied with it; what lies elsewhere is shared with others, and is linked.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use chiaro_locale::tr;

use crate::catalog::{Catalog, NodeKind};
use crate::document::{Edit, Graph, Look, Node, Target, Value};
use crate::files::{Disk, Files as _, relative, shortened};
use crate::frame::UNSAVED_HCBTF;
use crate::ids::PortName;
use crate::library::Type;
use crate::state::pictures::{CarriedPicture, free_name, is_within};

/// Largest size of all pictures that are copied with a part, in bytes; others are linked.
const MOST_BYTES: u64 = 64 << 20;

/// Way of a part's pictures.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PictureRoute<'a> {
    /// Folder that the pictures are named from, whole.
    pub(crate) from: &'a Path,
    /// Folder that they are to be named from, whole; `None` for a look without a file.
    pub(crate) to: Option<&'a Path>,
    /// True if an equal file of the same name stands for a copy. A look gets a copy of its own,
    /// which can be painted without a change of others.
    pub(crate) takes_equal: bool,
}

/// Pictures of a part that was named anew.
#[derive(Debug, Default)]
pub(crate) struct MovedPictures {
    /// Copies that are to be written into the new folder.
    pub(crate) copied: Vec<CarriedPicture>,
    /// Names of the files that are in the new folder with the part.
    pub(crate) along: Vec<String>,
    /// Names of the files that stay where they are.
    pub(crate) linked: Vec<String>,
}

impl MovedPictures {
    /// Words on the files, for a message.
    pub(crate) fn told(&self) -> Vec<String> {
        let mut told = Vec::new();
        if !self.along.is_empty() {
            told.push(tr!("copied beside it: {files}", files = self.along.join(", ")));
        }
        if !self.linked.is_empty() {
            told.push(tr!("linked, not copied: {files}", files = self.linked.join(", ")));
        }
        told
    }
}

impl PictureRoute<'_> {
    /// Names a part's pictures from the new folder. Nothing is written.
    pub(crate) fn rename(self, part: &mut Look, catalog: &Catalog) -> MovedPictures {
        let mut moved = MovedPictures::default();
        let mut left = MOST_BYTES;
        let mut known: HashMap<PathBuf, String> = HashMap::new();
        each_file(part, catalog, &mut |path| {
            let whole = shortened(&self.from.join(&*path));
            let name = known
                .entry(whole)
                .or_insert_with_key(|whole| self.name(whole, &mut left, &mut moved));
            path.clone_from(name);
        });
        moved
    }

    /// Names a file from the new folder. A path from the root leads to the same file from anywhere,
    /// and stays.
    pub(crate) fn relink(self, path: &mut String) {
        if let Some(folder) = self.to.filter(|_| Path::new(&*path).is_relative()) {
            *path = relative(&shortened(folder), &shortened(&self.from.join(&*path)));
        }
    }

    /// Name of a picture from the new folder.
    fn name(self, whole: &Path, left: &mut u64, moved: &mut MovedPictures) -> String {
        if let Some(name) = self.copy(whole, left, moved) {
            moved.along.push(name.clone());
            return name;
        }
        moved.linked.push(whole.file_name().unwrap_or_default().to_string_lossy().into_owned());
        match self.to {
            Some(folder) => relative(&shortened(folder), whole),
            None => whole.to_string_lossy().into_owned(),
        }
    }

    /// Name of the copy of a picture; `None` for one that is shared, missing or too large.
    fn copy(self, whole: &Path, left: &mut u64, moved: &mut MovedPictures) -> Option<String> {
        let folder = self.to.filter(|_| is_within(self.from, whole))?;
        let bytes = Disk.read(whole, *left).ok()?;
        let name = whole.file_name()?.to_str()?;
        let is_equal = |name: &str| {
            let there = Disk.read(&folder.join(name), bytes.len() as u64);
            there.is_ok_and(|there| there == bytes)
        };
        if self.takes_equal && is_equal(name) {
            return Some(name.to_owned());
        }
        let dot = name.rfind('.').unwrap_or(name.len());
        let is_taken = |name: &str| moved.copied.iter().any(|copied| copied.name == name);
        let name = free_name(folder, name.split_at(dot), is_taken).ok()?;
        *left = left.saturating_sub(bytes.len() as u64);
        moved.copied.push(CarriedPicture { name: name.clone(), bytes });
        Some(name)
    }
}

/// Calls `change` for every path of a file in a look: of its nodes, of those in its groups, and of
/// its keys. Names of examples, of meshes' own images and of nothing are no paths.
pub(crate) fn each_file(look: &mut Look, catalog: &Catalog, change: &mut dyn FnMut(&mut String)) {
    let of_time: Vec<bool> =
        look.time_keys.iter().map(|keys| is_file(look, catalog, &keys.target)).collect();
    let targets = look.direction_keys.iter().flat_map(|keys| &keys.keys);
    let targets = targets.flat_map(|key| key.values.keys());
    let of_directions: HashSet<Target> =
        targets.filter(|target| is_file(look, catalog, target)).cloned().collect();
    let groups = look.definitions.values_mut().map(|definition| &mut definition.graph);
    for graph in std::iter::once(&mut look.graph).chain(groups) {
        each_file_of(graph, catalog, change);
    }
    for keys in look.time_keys.iter_mut().zip(of_time).filter_map(|(keys, is)| is.then_some(keys)) {
        keys.keys.iter_mut().for_each(|key| change_path(&mut key.value, change));
    }
    for (target, value) in look
        .direction_keys
        .iter_mut()
        .flat_map(|keys| &mut keys.keys)
        .flat_map(|key| &mut key.values)
    {
        if of_directions.contains(target) {
            change_path(value, change);
        }
    }
}

/// Calls `change` for every path of a file in a graph.
fn each_file_of(graph: &mut Graph, catalog: &Catalog, change: &mut dyn FnMut(&mut String)) {
    graph.nodes.values_mut().for_each(|node| each_file_in(node, catalog, change));
}

/// Calls `change` for every path of a file in a node.
fn each_file_in(node: &mut Node, catalog: &Catalog, change: &mut dyn FnMut(&mut String)) {
    let Some(kind) = catalog.of(node).cloned() else { return };
    for (port, value) in &mut node.values {
        if takes_file(&kind, port) {
            change_path(value, change);
        }
    }
}

/// Calls `change` for every path of a file in an edit of a look, also one of its past.
/// `is_path` says whether a text is a path where the look no longer has the node that it is for.
pub(crate) fn each_file_in_edit(
    edit: &mut Edit,
    (look, catalog): (&Look, &Catalog),
    is_path: &dyn Fn(&str) -> bool,
    change: &mut dyn FnMut(&mut String),
) {
    match edit {
        Edit::Group { edits } => {
            for edit in edits {
                each_file_in_edit(edit, (look, catalog), is_path, change);
            }
        }
        Edit::Replace { look } => each_file(look, catalog, change),
        Edit::AddNode { node, .. } => each_file_in(node, catalog, change),
        Edit::AddDefinition { definition, .. } => {
            each_file_of(&mut definition.graph, catalog, change);
        }
        Edit::SetValue { graph, id, port, value, .. } => {
            let node = look.graph_of(graph).and_then(|graph| graph.nodes.get(id.as_str()));
            let is_file = match node.and_then(|node| catalog.of(node)) {
                Some(kind) => takes_file(kind, port),
                None => matches!(value, Value::Text(text) if is_path(text)),
            };
            if is_file {
                change_path(value, change);
            }
        }
        Edit::AddTimeKeys { keys, .. } | Edit::SetTimeKeys { keys, .. }
            if is_file(look, catalog, &keys.target) =>
        {
            keys.keys.iter_mut().for_each(|key| change_path(&mut key.value, change));
        }
        Edit::AddDirectionKeys { keys, .. } | Edit::SetDirectionKeys { keys, .. } => {
            for (target, value) in keys.keys.iter_mut().flat_map(|key| &mut key.values) {
                if is_file(look, catalog, target) {
                    change_path(value, change);
                }
            }
        }
        _ => {}
    }
}

/// True if a target of a look is the path of a file.
pub(crate) fn is_file(look: &Look, catalog: &Catalog, target: &Target) -> bool {
    let Target::Input { node, port } = target else { return false };
    let kind = look.find(node).and_then(|found| catalog.of(found.node));
    kind.is_some_and(|kind| takes_file(kind, port))
}

fn takes_file(kind: &NodeKind, port: &PortName) -> bool {
    let ty = kind.input(port.as_str()).map(|index| &kind.inputs[index].ty);
    matches!(ty, Some(Type::Image | Type::Hcbtf))
}

/// Calls `change` for a value that is the path of a file.
pub(crate) fn change_path(value: &mut Value, change: &mut dyn FnMut(&mut String)) {
    let Value::Text(path) = value else { return };
    let is_inside = path.is_empty()
        || path.contains("example:")
        || path.starts_with("mesh:")
        || *path == UNSAVED_HCBTF;
    if !is_inside {
        change(path);
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{draft, found, look_of, read};
    use super::*;
    use crate::state::parts::saving::{PartChoice, save};

    const MASKED: &str = r#"{"name": "From", "lights": {"key": {}}, "nodes": [
        {"id": "mask", "kind": "image", "values": {"image": "m.png"}},
        {"id": "same", "kind": "image", "values": {"image": "./m.png"}},
        {"id": "wood", "kind": "image", "values": {"image": "../shared/wood.png"}},
        {"id": "tint", "kind": "multiply"},
        {"id": "rim", "kind": "light_layer", "name": "Rim", "values": {"light": "key"}}],
      "wires": [{"from": "mask", "to": "tint.a"}, {"from": "wood", "to": "tint.b"},
        {"from": "tint", "to": "rim.convex"}, {"from": "same", "to": "rim.concave"}]}"#;

    fn image(look: &Look, id: &str) -> String {
        match &look.graph.nodes[id].values["image"] {
            Value::Text(path) => path.clone(),
            other => panic!("{other:?}"),
        }
    }

    /// A part outlives the look that it is of, and every look that uses it has a picture of its
    /// own; what lies elsewhere stays where it is, by the shortest path.
    #[test]
    fn a_part_brings_its_own_pictures_and_links_shared_ones() {
        let home = tempfile::tempdir().unwrap();
        let path = |name: &str| home.path().join(name);
        for folder in ["first", "second", "shared"] {
            std::fs::create_dir(path(folder)).unwrap();
        }
        std::fs::write(path("first/m.png"), "mask").unwrap();
        std::fs::write(path("shared/wood.png"), "wood").unwrap();
        let (from, catalog) = read(MASKED);
        let draft = draft(&from, &PartChoice::Layers(vec!["rim".into()])).unwrap();
        let folder = path("library");
        let (file, told) = save(&draft, &folder, Some(&path("first")), &catalog).unwrap();
        assert!(told.contains("copied beside it: m.png · linked, not copied: wood.png"), "{told}");
        save(&draft, &folder, Some(&path("first")), &catalog).unwrap();
        assert!(!folder.join("m-2.png").exists(), "an equal picture is there");
        std::fs::remove_dir_all(path("first")).unwrap();

        let parts = found(&folder).parts;
        let part = parts.iter().find(|part| part.path == file).unwrap();
        assert_eq!(image(look_of(part), "mask"), "m.png");
        assert_eq!(image(look_of(part), "wood"), "../shared/wood.png");
        std::fs::write(path("second/m.png"), "another").unwrap();
        let second = path("second");
        let route = PictureRoute { from: &folder, to: Some(&second), takes_equal: false };
        let mut own = look_of(part).clone();
        let moved = route.rename(&mut own, &catalog);
        assert_eq!(
            (moved.along.as_slice(), moved.linked.as_slice()),
            (&["m-2.png".to_owned()][..], &["wood.png".to_owned()][..])
        );
        assert_eq!(
            moved.copied,
            [CarriedPicture { name: "m-2.png".into(), bytes: b"mask".into() }]
        );
        assert_eq!(
            (image(&own, "mask"), image(&own, "same")),
            ("m-2.png".into(), "m-2.png".into())
        );

        // A link of an earlier version leads through the library to a picture beside the look.
        let mut own = look_of(part).clone();
        let long = Value::Text("../library/../second/m.png".to_owned());
        own.graph.nodes["mask"].values.insert("image".into(), long);
        route.rename(&mut own, &catalog);
        assert_eq!(image(&own, "mask"), "m.png");
        let unsaved = PictureRoute { to: None, ..route };
        let mut own = look_of(part).clone();
        assert!(unsaved.rename(&mut own, &catalog).copied.is_empty());
        assert_eq!(image(&own, "mask"), folder.join("m.png").display().to_string());
    }
}
