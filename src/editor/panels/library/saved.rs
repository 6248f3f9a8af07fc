//! Parts of the library: folders of the user, of the project, and those that others share, as
//! pictures to search, to drag and to press.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use eframe::egui::{ComboBox, Label, RichText, Role, ScrollArea, Ui, WidgetInfo, vec2};

use super::super::thumbs::Thumbs;
use super::cards;
use super::part_card::PartCard;
use super::save_form::SaveForm;
use super::upkeep::PartUpkeep;
use super::words;
use crate::commands::{Command, LibraryCommand};
use crate::panels::layers::preset_parts;
use crate::state::parts::saving::{PartChoice, PartDraft, keepable};
use crate::state::parts::{FOLDER, FoundParts, Part, PartKind, PartsReader, shipped};
use crate::state::safety::Safety;
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use crate::widgets::text::hint;
use crate::widgets::theme;

/// Least width of a part's picture, in points.
const CARD: f32 = 96.0;
/// Gap between cards, in points.
const GAP: f32 = 6.0;

/// Folder of the library, as the panel lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Shelf {
    pub(super) title: String,
    pub(super) folder: PathBuf,
    /// True for a folder that can be taken off the list.
    pub(super) is_shared: bool,
}

/// Parts of the library, and the form that saves one.
pub(crate) struct SavedParts {
    wake: Arc<dyn Fn() + Send + Sync>,
    reader: Option<PartsReader>,
    /// Folders that were read last, or are being read.
    asked: Vec<PathBuf>,
    /// True if the folders are to be read again.
    is_stale: bool,
    was_focused: bool,
    found: Vec<FoundParts>,
    kind: Option<PartKind>,
    cards: Vec<PartCard>,
    /// Cards of the presets of *Add layer*.
    presets: Vec<PartCard>,
    form: Option<SaveForm>,
    upkeep: PartUpkeep,
}

impl BackgroundJobs for SavedParts {
    fn is_busy(&self) -> bool {
        self.reader.as_ref().is_some_and(BackgroundJobs::is_busy)
    }

    fn wait(&self) {
        if let Some(reader) = &self.reader {
            reader.wait();
        }
    }
}

impl SavedParts {
    /// `wake` is called from another thread when folders are read.
    pub(crate) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            wake: Arc::new(wake),
            reader: None,
            asked: Vec::new(),
            is_stale: true,
            was_focused: true,
            found: Vec::new(),
            kind: None,
            cards: Vec::new(),
            presets: Vec::new(),
            form: None,
            upkeep: PartUpkeep::default(),
        }
    }

    /// Shows the form that saves a part.
    pub(crate) fn offer(&mut self, draft: PartDraft) {
        self.form = Some(SaveForm::new(draft));
    }

    /// True while the form that saves a part is shown.
    pub(super) fn is_saving(&self) -> bool {
        self.form.is_some()
    }

    /// Notes that a part was saved: its folder is read again.
    pub(crate) fn saved(&mut self) {
        self.form = None;
        self.changed();
    }

    /// Notes that files of parts have changed: the folders are read again.
    pub(crate) fn changed(&mut self) {
        self.is_stale = true;
    }

    /// Shows the parts that a query finds.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        safety: &Safety,
        (query, thumbs): (&str, &Thumbs),
    ) -> Vec<Command> {
        let shelves = shelves(session, safety);
        if self.presets.is_empty() {
            self.presets = preset_parts().iter().map(PartCard::of_preset).collect();
        }
        self.read(ui, session, &shelves);
        let mut out = Vec::new();
        if self.form.as_mut().is_some_and(|form| form.show(ui, &shelves, &self.found, &mut out)) {
            self.form = None;
        }
        self.bar(ui, session, &mut out);
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("parts").show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(GAP, GAP);
            let mut count = 0;
            let mut upkeep = std::mem::take(&mut self.upkeep);
            for shelf in &shelves {
                count += self.shelf(ui, session, shelf, (query, thumbs), &mut upkeep, &mut out);
            }
            let search = (query, thumbs);
            title(ui, tr!("Add layer"), None, &mut out);
            count += self.grid(ui, session, self.presets.iter(), search, &mut upkeep, &mut out);
            title(ui, tr!("Comes with Chiaro"), None, &mut out);
            let shipped = self.in_folder(None);
            count += self.grid(ui, session, shipped, search, &mut upkeep, &mut out);
            upkeep.ask(ui, &mut out);
            self.upkeep = upkeep;
            if count == 0 {
                hint(ui, tr!("No part has these words in its name, its tags or its description"));
            }
            shared_folders(ui, &mut out);
        });
        out
    }

    /// Reads the folders again where they, or perhaps their files, have changed.
    fn read(&mut self, ui: &Ui, session: &Session, shelves: &[Shelf]) {
        let folders: Vec<PathBuf> = shelves.iter().map(|shelf| shelf.folder.clone()).collect();
        let is_focused = ui.input(|input| input.focused);
        let was_focused = std::mem::replace(&mut self.was_focused, is_focused);
        let has_come_back = is_focused && !was_focused;
        let wake = self.wake.clone();
        let reader = self.reader.get_or_insert_with(|| {
            PartsReader::new(session.assets.source().clone(), move || wake())
        });
        if has_come_back || self.asked != folders || std::mem::take(&mut self.is_stale) {
            self.asked.clone_from(&folders);
            reader.read(folders);
        }
        let answer = reader.answer();
        if answer.is_some() || self.cards.is_empty() {
            self.found = answer.unwrap_or_default();
            let saved = self
                .found
                .iter()
                .flat_map(|found| found.parts.iter().map(|part| PartCard::new(part, Some(found))));
            let own = shipped().iter().map(|part| PartCard::new(part, None));
            self.cards = saved.chain(own).collect();
        }
    }

    /// Shows the menu that saves, and the filter.
    fn bar(&mut self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
            let menu = ui.menu_button(tr!("Save…"), |ui| {
                for (label, choice) in choices(session) {
                    if ui.button(label).clicked() {
                        out.push(Command::Library(LibraryCommand::Offer(choice)));
                        ui.close();
                    }
                }
            });
            menu.response
                .on_hover_text(tr!("Saves a part of this look, so that others can have it"));
            let text = self.kind.map_or(tr!("All kinds"), PartKind::title);
            let combo = ComboBox::from_id_salt("kinds").width(84.0).selected_text(text);
            let combo = combo.show_ui(ui, |ui| {
                ui.selectable_value(&mut self.kind, None, tr!("All kinds"));
                for kind in PartKind::ALL {
                    ui.selectable_value(&mut self.kind, Some(kind), kind.title());
                }
            });
            combo
                .response
                .widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr!("Kind of parts")));
            let help = tr!("Reads the folders again");
            if ui.button(tr!("Refresh")).on_hover_text(help).clicked() {
                self.is_stale = true;
            }
        });
        ui.add_space(2.0);
    }

    /// Shows a folder; returns the number of its parts that are found.
    fn shelf(
        &self,
        ui: &mut Ui,
        session: &Session,
        shelf: &Shelf,
        search: (&str, &Thumbs),
        upkeep: &mut PartUpkeep,
        out: &mut Vec<Command>,
    ) -> usize {
        title(ui, &shelf.title, Some(shelf), out);
        let found = self.found.iter().find(|found| found.folder == shelf.folder);
        if let Some(lacking) = found.and_then(|found| found.lacking.as_ref()) {
            ui.label(RichText::new(lacking).small().color(theme::of(ui).warning));
        }
        match found {
            None => hint(ui, tr!("reading…")),
            Some(found) if shelf.is_shared && !found.is_there => {
                hint(ui, tr!("Not there at the moment: its parts come back with the folder"));
            }
            Some(found) if found.parts.is_empty() => hint(ui, tr!("Nothing is saved here yet")),
            Some(_) => {}
        }
        let cards = self.in_folder(Some(&shelf.folder));
        self.grid(ui, session, cards, search, upkeep, out)
    }

    /// Cards of the parts of a folder, or of those that Chiaro ships.
    fn in_folder(&self, folder: Option<&PathBuf>) -> impl Iterator<Item = &PartCard> {
        self.cards.iter().filter(move |card| card.folder.as_ref() == folder)
    }

    /// Shows those of some parts that are found; returns their number.
    fn grid<'c>(
        &self,
        ui: &mut Ui,
        session: &Session,
        cards: impl Iterator<Item = &'c PartCard>,
        (query, thumbs): (&str, &Thumbs),
        upkeep: &mut PartUpkeep,
        out: &mut Vec<Command>,
    ) -> usize {
        let is_kind = |part: &Part| {
            self.kind.is_none_or(|kind| part.content.as_ref().is_ok_and(|found| found.kind == kind))
        };
        let with_rank = |card: &PartCard| {
            let part = &card.part;
            let kind = part.content.as_ref().ok().map(|content| content.kind.text());
            let kind = kind.map(|kind| format!("{} {}", kind.english(), kind.tr()));
            let kind = kind.unwrap_or_default();
            // What Chiaro brings is found by English words, too.
            let [name, about] = card.words();
            let names = format!("{name} {}", part.name);
            let abouts = format!("{about} {}", part.about);
            let tags = format!("{} {}", part.shown(&part.tags), part.tags);
            words::rank(query, &[&names, &tags, &kind, &abouts])
        };
        let mut found: Vec<(usize, &PartCard)> = cards
            .filter(|card| is_kind(&card.part))
            .filter_map(|card| Some((with_rank(card)?, card)))
            .collect();
        found.sort_by_key(|(rank, _)| *rank);
        let (columns, side) = cards::columns(ui.available_width() - 8.0, CARD, GAP);
        for row in found.chunks(columns) {
            ui.horizontal(|ui| {
                for (_, card) in row {
                    card.show(ui, side, (session, thumbs), upkeep, out);
                }
            });
        }
        found.len()
    }
}

/// Shows the button that adds a shared folder.
fn shared_folders(ui: &mut Ui, out: &mut Vec<Command>) {
    ui.add_space(GAP);
    ui.horizontal(|ui| {
        ui.label(RichText::new(tr!("Shared folders")).strong());
        let help = tr!(
            "Lists the parts of a folder that others save to as well, such as one on a server. \
             They stay where they are: what is put into a look is a copy, and says so"
        );
        let button = ui.button(tr!("Choose…")).on_hover_text(help);
        button
            .widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Choose a shared folder")));
        if button.clicked() {
            out.push(Command::Library(LibraryCommand::AddFolder(None)));
        }
    });
}

/// Shows the title of a folder.
fn title(ui: &mut Ui, title: &str, shelf: Option<&Shelf>, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let label = Label::new(RichText::new(title).strong()).truncate();
        let label = ui.add(label);
        let Some(shelf) = shelf else { return };
        label.on_hover_text(shelf.folder.display().to_string());
        if shelf.is_shared {
            let button = ui.small_button(tr!("Take off")).on_hover_text(tr!("Its files stay"));
            let name = tr!("Take off {folder}", folder = shelf.folder.display());
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
            if button.clicked() {
                let folder = shelf.folder.clone();
                out.push(Command::Library(LibraryCommand::RemoveFolder(folder)));
            }
        }
    });
}

/// Folders of the library: the user's own, the project's, and those that others share.
fn shelves(session: &Session, safety: &Safety) -> Vec<Shelf> {
    let mut shelves: Vec<Shelf> = Vec::new();
    let mut add = |title: &str, folder: PathBuf, is_shared| {
        if shelves.iter().all(|shelf| shelf.folder != folder) {
            shelves.push(Shelf { title: title.to_owned(), folder, is_shared });
        }
    };
    if let Some(folder) = safety.library() {
        add(tr!("My library"), folder, false);
    }
    let beside = |path: &Path| path.parent().map(|folder| folder.join(FOLDER));
    let scene = session.open_scene().and_then(|open_scene| open_scene.path());
    for folder in [session.path(), scene].into_iter().flatten().filter_map(beside) {
        add(tr!("This project"), folder, false);
    }
    for folder in &safety.settings.library_folders {
        let name = folder.file_name().unwrap_or(folder.as_os_str()).to_string_lossy();
        add(&tr!("Shared: {name}"), folder.clone(), true);
    }
    shelves
}

/// Parts of the look that can be saved now, each with a label.
pub(crate) fn choices(session: &Session) -> Vec<(String, PartChoice)> {
    let mut choices = vec![(tr!("This look").to_owned(), PartChoice::Look)];
    let graph = session.graph();
    let nodes: Vec<_> =
        session.selection.nodes().filter(|id| graph.nodes.contains_key(*id)).cloned().collect();
    let title = |id: &crate::ids::NodeId| {
        let node = graph.nodes.get(id);
        node.map_or_else(String::new, |node| session.look_with_library().title_of_node(id, node))
    };
    if let [id] = nodes.as_slice() {
        let title = title(id);
        let is_whole = session.selection.open_groups().is_empty();
        let choice = if is_whole {
            PartChoice::Layers(vec![id.clone()])
        } else {
            PartChoice::Nodes(vec![id.clone()])
        };
        choices.push((tr!("{title}, with what feeds it"), choice));
        if let Some(node) = graph.nodes.get(id) {
            if let Some((id, _)) = session.look().definitions.get_key_value(node.kind.as_str()) {
                choices.push((tr!("The group of {title}"), PartChoice::Group(id.clone())));
            }
            let (ramps, has_profile) = keepable(&session.project.catalog, node);
            if has_profile {
                choices.push((tr!("The profile of {title}"), PartChoice::Profile(id.clone())));
            }
            for port in ramps {
                choices.push((tr!("The ramp of {title}"), PartChoice::Ramp(id.clone(), port)));
            }
        }
    } else if !nodes.is_empty() {
        choices.push((
            trn!(count = nodes.len(), "{count} selected node", "{count} selected nodes"),
            PartChoice::Nodes(nodes),
        ));
    }
    if !session.look().lights.is_empty() {
        choices.push((tr!("All lights").to_owned(), PartChoice::Lights));
    }
    choices
}
