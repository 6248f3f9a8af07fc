//! Library of everything that a look can be made of: nodes by category, saved parts, and finished
//! looks as pictures. A node is dragged onto the canvas or added by a click, a part is dropped
//! where it belongs, and a look opens as a new one.

pub(super) mod cards;
mod drops;
mod examples;
mod nodes;
mod part_card;
mod save_form;
pub(super) mod saved;
mod upkeep;
mod words;

use std::path::PathBuf;

use chiaro_locale::{text, tr};
use eframe::egui;
use eframe::egui::{Rect, Role, ScrollArea, TextEdit, Ui, WidgetInfo, vec2};

use super::thumbs::Thumbs;
use crate::commands::{Command, PanelId};
use crate::panels::table::{PanelContext, PanelPlace, PanelRow};
use crate::state::revision::SuspectsRevision;
use crate::state::session::Session;
use crate::widgets::text::hint;
use cards::Card;
pub(crate) use examples::{ExampleContent, example};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::LIBRARY,
    text!("Library"),
    text!("Nodes to drag onto the canvas, saved parts, and finished looks to begin with"),
    PanelPlace::WITH_DOCUMENT,
    |bench, ui, PanelContext { session, safety }| {
        let library = bench.memory.of::<LibraryPanel>();
        library.know_recent(safety.recent(), session);
        if bench.parts.is_saving() {
            library.tab = LibraryTab::Parts;
        }
        library.bar(ui);
        match library.tab {
            LibraryTab::Nodes => nodes::show(ui, session, &library.query),
            LibraryTab::Parts => {
                let search = (library.query.trim(), &bench.thumbs);
                bench.parts.show(ui, session, safety, search)
            }
            LibraryTab::Looks => library.looks(ui, session, &bench.thumbs),
        }
    },
)
.with_each_frame(|bench, ui, session, _| {
    bench.thumbs.update(ui, session);
    drops::each_frame(bench, ui, session)
})
.with_jobs(|bench| &bench.parts);

/// Node that is being dragged to the canvas: the payload of egui's drag and drop.
#[derive(Clone, Debug)]
pub(crate) struct DraggedKind(pub(crate) String);

/// Least width of a look's picture, in points.
const CARD: f32 = 96.0;
/// Side of a picture as drawn, in pixels.
const SIDE: f32 = 200.0;
/// Largest number of recent files that are shown.
const MOST_RECENT: usize = 8;

/// Tab of the library.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum LibraryTab {
    #[default]
    Nodes,
    Parts,
    Looks,
}

/// Least width of the search beside the tabs, in points: a narrower one takes the next line.
const SEARCH: f32 = 130.0;

/// The panel of nodes, parts and looks, and its state.
#[derive(Default)]
pub(crate) struct LibraryPanel {
    tab: LibraryTab,
    query: String,
    looks: Vec<Card>,
    /// Cards of recent files; then the files they are of, with the revision of the suspects at that
    /// time.
    recent: Vec<Card>,
    recent_of: (Vec<PathBuf>, SuspectsRevision),
}

fn search(ui: &mut Ui, query: &mut String, what: &str) {
    let width = ui.available_size_before_wrap().x;
    let response = ui.add(TextEdit::singleline(query).hint_text(what).desired_width(width));
    response.widget_info(|| WidgetInfo::labeled(Role::SearchInput, true, what));
}

impl LibraryPanel {
    /// Shows the tabs, and the search.
    fn bar(&mut self, ui: &mut Ui) {
        let what = match self.tab {
            LibraryTab::Nodes => tr!("Search nodes"),
            LibraryTab::Parts => tr!("Search parts"),
            LibraryTab::Looks => tr!("Search looks"),
        };
        let mut is_beside = false;
        ui.horizontal_wrapped(|ui| {
            ui.selectable_value(&mut self.tab, LibraryTab::Nodes, tr!("Nodes"))
                .on_hover_text(tr!("What looks are made of"));
            ui.selectable_value(&mut self.tab, LibraryTab::Parts, tr!("Parts"))
                .on_hover_text(tr!("Layers, groups, lights, profiles and ramps that were saved"));
            ui.selectable_value(&mut self.tab, LibraryTab::Looks, tr!("Looks"))
                .on_hover_text(tr!("Finished looks to begin with"));
            is_beside = ui.available_size_before_wrap().x >= SEARCH;
            if is_beside {
                search(ui, &mut self.query, what);
            }
        });
        if !is_beside {
            search(ui, &mut self.query, what);
        }
        ui.add_space(2.0);
    }

    /// Updates the recent files. Files are read only when the list changes, which is when one is
    /// opened or saved.
    pub(crate) fn know_recent<'p>(
        &mut self,
        files: impl Iterator<Item = (&'p PathBuf, bool)>,
        session: &Session,
    ) {
        let crashes = &session.journals.crashes;
        if self.tab != LibraryTab::Looks {
            return;
        }
        let there: Vec<PathBuf> =
            files.filter(|(_, is_there)| *is_there).map(|(path, _)| path.clone()).collect();
        let now = (there, crashes.suspects_revision());
        if self.recent_of != now {
            let (there, _) = &now;
            self.recent = there
                .iter()
                .take(MOST_RECENT)
                .map(|path| Card::of_file(path, SIDE, session))
                .collect();
            self.recent.retain(Card::is_readable);
            self.recent_of = now;
        }
    }

    fn looks(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        if self.looks.is_empty() {
            self.looks = Card::examples(SIDE, session);
        }
        let words = self.query.trim().to_owned();
        let groups = [(tr!("Recent"), &self.recent), (tr!("Examples"), &self.looks)];
        let groups = groups.map(|(title, cards)| (title, cards::found(cards, &words, "")));
        let mut out = Vec::new();
        if groups.iter().all(|(_, found)| found.is_empty()) {
            hint(ui, tr!("No look of that name"));
            return out;
        }
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("looks").show(ui, |ui| {
            let gap = 6.0;
            let (columns, side) = cards::columns(ui.available_width() - 8.0, CARD, gap);
            ui.spacing_mut().item_spacing = vec2(gap, gap);
            let is_split = groups.iter().all(|(_, found)| !found.is_empty());
            for (index, (title, found)) in groups.iter().enumerate() {
                if is_split {
                    hint(ui, title);
                }
                // Recent files take a single row; a search finds the others.
                let is_short = index == 0 && is_split && words.is_empty();
                let rows = if is_short { 1 } else { usize::MAX };
                for row in found.chunks(columns).take(rows) {
                    ui.horizontal(|ui| {
                        for card in row {
                            card.show(ui, side, session, thumbs, &mut out);
                        }
                    });
                }
            }
        });
        out
    }
}

/// Takes a node that is dropped over `rect`, the canvas. Returns the kind and the point.
pub(crate) fn dropped(ui: &Ui, rect: Rect) -> Option<(String, egui::Pos2)> {
    let at = ui.input(|input| input.pointer.latest_pos()).filter(|at| rect.contains(*at))?;
    let held = egui::DragAndDrop::payload::<DraggedKind>(ui.ctx())?;
    if !ui.input(|input| input.pointer.any_released()) {
        return None;
    }
    egui::DragAndDrop::clear_payload(ui.ctx());
    Some((held.0.clone(), at))
}
