//! Groups that the looks of a project share: files in the `nodes/` folder beside them.

use std::path::Path;

use chiaro_locale::tr;

use super::Session;
use crate::document::{Edit, Graph, GraphId, Look};
use crate::files::{Disk, Files as _, MemoryFiles, make_folder, write_atomic};
use crate::ids::{DefinitionId, make_slug};

impl Session {
    /// Writes a group of the look's own to a file of the project. From then on the look takes it
    /// from there, as all looks beside it do. A group that was the project's before, and was
    /// changed here, takes its old place. Returns a message.
    pub(crate) fn share_group(&mut self, id: &DefinitionId) -> String {
        self.try_share(id).unwrap_or_else(|why_not| why_not)
    }

    fn try_share(&mut self, id: &DefinitionId) -> Result<String, String> {
        let Some(folder) = self.path().and_then(Path::parent).map(|folder| folder.join("nodes"))
        else {
            return Err(tr!("Save the look first: a project is the folder that its looks lie in")
                .to_owned());
        };
        let own = &self.look().definitions;
        let Some(definition) = own.get(id).cloned() else {
            return Err(tr!("This group is of the library already").to_owned());
        };
        let name =
            if definition.label.is_empty() { id.to_string() } else { definition.label.clone() };
        let mut inner = definition
            .graph
            .nodes
            .values()
            .filter_map(|node| own.get_key_value(node.kind.as_str()));
        if let Some((inner, of)) = inner.next() {
            let inner = if of.label.is_empty() { inner.as_str() } else { &of.label };
            return Err(tr!(
                "\"{name}\" holds \"{inner}\", which only this look has: share that first"
            ));
        }
        let file_of = |slug: &str| folder.join(format!("{slug}.json"));
        // The file is written to the disk, so the disk tells whether its name is free.
        let is_known = self.project.library.groups.contains_key(id.as_str())
            && Disk.has_file(&file_of(id.as_str()));
        let is_taken = |slug: &str| {
            let is_other = slug != id.as_str() && own.contains_key(slug);
            is_other
                || self.project.library.kinds().any(|kind| kind == slug)
                || Disk.metadata(&file_of(slug)).is_some()
        };
        let shared =
            if is_known { id.clone() } else { DefinitionId::new(make_slug(&name, is_taken)) };
        let edit = handed_over(self.look(), id, &shared)?;

        let mut file = Look { name: name.clone(), ..Look::default() };
        file.definitions.insert(shared.clone(), definition);
        let path = file_of(shared.as_str());
        make_folder(&folder)
            .map_err(|problem| format!("{}: {}", folder.display(), problem.message))?;
        let text = file.to_text();
        write_atomic(&path, text.as_bytes()).map_err(|problem| problem.message)?;
        // The group is available at once; the folder is read anew on a thread of its own.
        let mut written = MemoryFiles::default();
        written.add(path.clone(), text);
        let library = self.project.library.with_project(&written, &folder);
        self.project.set_library(library);
        self.project.sync(self.look.document());
        self.reload_library();
        self.apply(edit, None).map_err(|problem| problem.message)?;
        let path = path.display();
        Ok(tr!("\"{name}\" is in {path}: every look beside this one has it now"))
    }
}

/// The edit by which all nodes of a group of the look's own become nodes of the project's
/// group.
fn handed_over(look: &Look, own: &DefinitionId, shared: &DefinitionId) -> Result<Edit, String> {
    let graphs = || {
        let groups =
            look.definitions.iter().map(|(id, of)| (GraphId::Definition(id.clone()), &of.graph));
        std::iter::once((GraphId::Look, &look.graph)).chain(groups)
    };
    let of_kind = |kind: &str| {
        let set = |graph: &GraphId, of: &Graph| -> Vec<Edit> {
            let nodes = of.nodes.iter().filter(|(_, node)| node.kind == own.as_str());
            nodes
                .map(|(id, _)| Edit::SetKind {
                    graph: graph.clone(),
                    id: id.clone(),
                    kind: kind.to_owned(),
                })
                .collect()
        };
        graphs().flat_map(|(graph, of)| set(&graph, of)).collect::<Vec<_>>()
    };
    // A group that is in use cannot be removed, so nodes of a group that keeps its id get
    // another kind for a moment.
    let between = if own == shared { format!("{own}_shared") } else { shared.to_string() };
    let mut edits = of_kind(&between);
    edits.push(Edit::RemoveDefinition { id: own.clone() });
    if own == shared {
        edits.extend(of_kind(shared.as_str()));
    }
    let edit = Edit::Group { edits };
    let mut trial = look.clone();
    trial.apply(edit.clone()).map_err(|problem| problem.message)?;
    let loses = trial.exposed != look.exposed
        || trial.direction_keys != look.direction_keys
        || trial.time_keys != look.time_keys;
    if loses {
        return Err(tr!(
            "Values inside of it are keyed or exposed in this look: make them inputs of the group, \
             and key those"
        )
        .to_owned());
    }
    Ok(edit)
}
