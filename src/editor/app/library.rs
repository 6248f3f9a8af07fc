//! Library of parts: saving them, keeping them up, and putting them into the look. Each says what
//! was done.

use std::path::Path;

use chiaro_locale::tr;
use eframe::egui::{OpenUrl, Ui};

use super::App;
use super::files::PendingAction;
use super::look_export::address_of;
use crate::commands::{FilePurpose, LibraryCommand, PanelId, PartSpot};
use crate::document::GraphId;
use crate::ids::{NodeId, ObjectId, PortName};
use crate::state::parts::pictures::PictureRoute;
use crate::state::parts::placing::{self, Placement, Recipient};
use crate::state::parts::saving::{self, PartChoice, PartSource};
use crate::state::parts::{Part, PartContent, PartKind, upkeep};
use crate::state::paths::absolute;

impl App {
    /// Carries out a command about the library.
    pub(super) fn apply_to_library(&mut self, ui: &Ui, command: LibraryCommand) {
        match command {
            LibraryCommand::Offer(choice) => self.offer_part(&choice),
            LibraryCommand::Save(draft, folder) => {
                let from = self.session.path().and_then(Path::parent).map(absolute);
                let catalog = &self.session.project.catalog;
                let saved = saving::save(&draft, &absolute(&folder), from.as_deref(), catalog);
                self.tell_of_part(saved.map(|(_, told)| told));
            }
            LibraryCommand::Replace(draft, path) => {
                let from = self.session.path().and_then(Path::parent).map(absolute);
                let catalog = &self.session.project.catalog;
                let saved = upkeep::replace(&draft, &absolute(&path), from.as_deref(), catalog);
                self.tell_of_part(saved);
            }
            LibraryCommand::Rename(part, name) => {
                self.message = Some(upkeep::rename(&part, &name).unwrap_or_else(|why_not| why_not));
                self.bench.parts.changed();
            }
            LibraryCommand::Remove(part) => {
                self.message = Some(upkeep::remove(&part).unwrap_or_else(|why_not| why_not));
                self.bench.parts.changed();
            }
            LibraryCommand::ShowFile(path) => {
                let path = absolute(&path);
                let folder = path.parent().unwrap_or(&path);
                ui.ctx().open_url(OpenUrl::new_tab(address_of(folder)));
            }
            LibraryCommand::Place(part, spot) => self.place_part(&part, &spot),
            LibraryCommand::AddFolder(None) => self.dialogs.ask(FilePurpose::LibraryFolder, None),
            LibraryCommand::AddFolder(Some(folder)) => {
                let folder = absolute(&folder);
                self.safety.change_settings(|settings| {
                    if !settings.library_folders.contains(&folder) {
                        settings.library_folders.push(folder);
                    }
                });
            }
            LibraryCommand::RemoveFolder(folder) => self.safety.change_settings(|settings| {
                settings.library_folders.retain(|other| *other != folder);
            }),
        }
    }

    /// Shows the form that saves a part of the look.
    fn offer_part(&mut self, choice: &PartChoice) {
        let session = &self.session;
        let source = PartSource {
            look: session.look(),
            graph: session.graph(),
            catalog: &session.project.catalog,
        };
        match source.draft(choice) {
            Ok(draft) => {
                self.bench.parts.offer(draft);
                self.start = None;
                self.dock.open(PanelId::LIBRARY);
            }
            Err(why_not) => self.message = Some(why_not),
        }
    }

    /// Tells what was saved, or why nothing was: the form then stays.
    fn tell_of_part(&mut self, saved: Result<String, String>) {
        if saved.is_ok() {
            self.bench.parts.saved();
        }
        self.message = Some(saved.unwrap_or_else(|why_not| why_not));
    }

    fn place_part(&mut self, part: &Part, spot: &PartSpot) {
        let PartContent { kind, look, .. } = match &part.content {
            Ok(content) => content,
            Err(why) => {
                self.message = Some(tr!("\"{part}\" cannot be read: {why}", part = part.title()));
                return;
            }
        };
        match (kind, spot) {
            (PartKind::Look, PartSpot::Object(object)) => return self.dress(object, part),
            (PartKind::Look, _) if !part.is_shipped() => {
                return self.do_or_ask(PendingAction::Open(part.path.clone()));
            }
            (_, PartSpot::Object(object)) if !self.is_open_on(object) => {
                let text = tr!(
                    "{object} wears another look: click it, so that its look is open, and drop \
                     \"{part}\" once more",
                    part = part.title()
                );
                self.message = Some(text);
                return;
            }
            _ => {}
        }
        // Images lie beside the part: the look that is open gets copies of its own.
        let mut own = (**look).clone();
        let from = absolute(part.path.parent().unwrap_or(Path::new("")));
        let folder = self.session.path().and_then(Path::parent).map(absolute);
        let route = PictureRoute { from: &from, to: folder.as_deref(), takes_equal: false };
        let pictures = route.rename(&mut own, &self.session.project.catalog);
        let placed = match kind {
            PartKind::Profile | PartKind::Ramp => self.place_values(part, &own, spot),
            _ => self.placement(*kind, (&part.name, &own), spot),
        };
        match placed {
            Ok(Placement { edit, nodes, mut told }) => {
                if !pictures.along.is_empty() {
                    let files = pictures.along.join(", ");
                    told += &tr!(" · copied beside this look: {files}");
                }
                if !pictures.linked.is_empty() {
                    let files = pictures.linked.join(", ");
                    told += &tr!(" · linked, not copied: {files}");
                }
                let made = self.attempt(|session| session.apply_with(pictures.copied, edit));
                if made.is_some() {
                    if !nodes.is_empty() {
                        self.session.select(nodes);
                    }
                    self.message = Some(told);
                }
            }
            Err(why_not) => self.message = Some(why_not),
        }
    }

    fn placement(
        &self,
        kind: PartKind,
        part: (&str, &crate::document::Look),
        spot: &PartSpot,
    ) -> Result<Placement, String> {
        let session = &self.session;
        let to = self.recipient();
        let graph = session.selection.graph_id();
        let middle = || {
            let at = self.bench.canvas.place_for(None);
            [f64::from(at.x), f64::from(at.y)]
        };
        match (kind, spot) {
            (PartKind::Lights, _) => placing::lights(session.look(), part),
            (_, PartSpot::Wire(wire)) if *graph == GraphId::Look => {
                placing::in_wire(to, part, wire)
            }
            (_, PartSpot::Canvas(at)) => placing::nodes(to, graph, part, *at),
            (PartKind::Layer, PartSpot::Layer(id)) => placing::layer(to, part, Some(id)),
            (PartKind::Layer, PartSpot::Selection) => {
                placing::layer(to, part, session.selection.nodes.last())
            }
            (PartKind::Layer, _) => placing::layer(to, part, None),
            _ => placing::nodes(to, graph, part, middle()),
        }
    }

    /// Gives the values of a profile or a ramp to a node.
    fn place_values(
        &self,
        part: &Part,
        look: &crate::document::Look,
        spot: &PartSpot,
    ) -> Result<Placement, String> {
        let session = &self.session;
        let name = (part.name.as_str(), look);
        if matches!(spot, PartSpot::Canvas(_) | PartSpot::Wire(_)) {
            return self.placement(PartKind::Nodes, name, spot);
        }
        let (id, port): (Option<NodeId>, Option<PortName>) = match spot {
            PartSpot::Layer(id) => (Some(id.clone()), None),
            PartSpot::Input(port) => (session.selection.nodes.last().cloned(), Some(port.clone())),
            _ => (session.selection.nodes.last().cloned(), None),
        };
        let graph = match spot {
            PartSpot::Layer(_) => &session.look().graph,
            _ => session.graph(),
        };
        let Some((id, node)) = id.and_then(|id| graph.nodes.get_key_value(&id)) else {
            return Err(tr!("Select the node that \"{part}\" is for", part = part.title()));
        };
        let to = self.recipient();
        let mut values = placing::values(to, node, look, port.as_ref());
        if values.is_empty() {
            values = placing::values(to, node, look, None);
        }
        let title = session.look_with_library().title_of_node(id, node);
        if values.is_empty() {
            return Err(tr!(
                "{title} has no such value, so \"{part}\" is of no use to it",
                part = part.title()
            ));
        }
        let wired = values.iter().filter(|(port, _)| graph.wire_into(id, port).is_some()).count();
        let target = |port: &PortName| match spot {
            PartSpot::Layer(id) => crate::document::Target::Input {
                node: crate::ids::NodePath::root(id.clone()),
                port: port.clone(),
            },
            _ => session.selection.target(id, port),
        };
        let edit = session
            .keys()
            .set_all_at(values.iter().map(|(port, value)| (target(port), value.clone())));
        let mut told = tr!("\"{part}\" is copied into {title}", part = part.title());
        if wired > 0 {
            told += tr!(" · a wire decides in its place until it is taken off");
        }
        Ok(Placement { edit, nodes: Vec::new(), told })
    }

    /// Lets an object wear the file of a look.
    fn dress(&mut self, object: &ObjectId, part: &Part) {
        if part.is_shipped() {
            self.message = Some(tr!("\"{part}\" has no file to wear", part = part.title()));
            return;
        }
        let path = part.path.clone();
        self.message = None;
        self.change_object(object, |open_scene, object| {
            let name = open_scene.name_of(&path);
            object.looks.values_mut().for_each(|look| look.clone_from(&name));
        });
        if self.message.is_none() {
            self.message = Some(tr!(
                "{object} is linked to {file}: what is changed there changes here",
                file = path.display()
            ));
        }
    }

    /// True if an object of the scene wears the look that is open.
    fn is_open_on(&self, object: &ObjectId) -> bool {
        let Some(open_scene) = self.session.open_scene() else { return true };
        let Some(path) = self.session.path() else { return true };
        let name = open_scene.name_of(path);
        let found = open_scene.scene().objects.get(object);
        found.is_some_and(|object| object.looks.values().any(|look| *look == name))
    }

    fn recipient(&self) -> Recipient<'_> {
        Recipient {
            look: self.session.look(),
            catalog: &self.session.project.catalog,
            library: &self.session.project.library,
        }
    }
}
