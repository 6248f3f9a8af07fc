//! Light table: a row for each group and each light of the scene, or of the look where there is no
//! scene, and a column for each of their fields. Many cells are changed at once, by values or by
//! what is done to them (`*1.2`, `+0.1`), in one undo step.
//!
//! In a scene the table edits the scene: a light that only looks have is shown as inherited, and an
//! edit puts a light of the scene in its place. Keyed cells are the exception: a value that is set
//! goes into the key that is set there, of the scene or of the look.

mod change;
mod column;
mod editing;
mod grid;
mod keyboard;
mod layout;
mod menu;
mod paint;
mod selection;
mod sheet;
mod typed;

use std::collections::BTreeMap;

use chiaro_locale::{text, tr};
use eframe::egui;
use eframe::egui::{Align, Id, Layout, RichText, Role, TextEdit, Ui, WidgetInfo};

use super::lights::add;
use crate::commands::{Command, PanelId};
use crate::document::LightSet;
use crate::fields::mix::MixedLights;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::session::Session;
use crate::viewport::solo_bar;
use crate::widgets::text::hint;
use crate::widgets::theme;
use column::Column;
use grid::CellGrid;
use selection::ShownCells;
use sheet::{Row, Sheet};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::LIGHT_TABLE,
    text!("Light table"),
    text!("All lights and groups as a table: set, key and compare any field of many at once"),
    PanelPlace::BELOW_GRAPH,
    |bench, ui, context| {
        let table = bench.memory.of::<LightTable>();
        table.columns.clone_from(&context.safety.settings.light_columns);
        table.show(ui, context.session)
    },
);

/// Width of the filter's field, in points.
const FILTER: f32 = 160.0;
/// Least width of a bar that leads to the other panels about lights, in points.
const WIDE: f32 = 580.0;

/// The panel and its state.
#[derive(Default)]
pub(crate) struct LightTable {
    lights: MixedLights,
    grid: CellGrid,
    /// Text of the set whose lights are listed; empty for all.
    filter: String,
    /// Columns that were shown or hidden by hand, by their words: the settings keep them.
    columns: BTreeMap<String, bool>,
}

impl LightTable {
    /// Shows the table.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        self.lights.sync(session);
        let mut out = Vec::new();
        let filter = (!self.filter.trim().is_empty()).then(|| LightSet::parse(self.filter.trim()));
        self.bar(ui, session, filter.as_ref().and_then(|read| read.as_ref().err()), &mut out);
        // Notes stand below: what is clicked must not move when one comes or goes.
        ui.with_layout(Layout::bottom_up(Align::LEFT), |ui| {
            if !session.view.solo.lights.is_empty() || !session.view.solo.muted.is_empty() {
                out.extend(solo_bar::show(ui, session));
            }
            if let Some(mix) = (Sheet { session, lights: &self.lights }).mix() {
                mix.solo_note(ui, &mut out);
            }
            let filter = filter.and_then(Result::ok);
            let layout = Layout::top_down(Align::LEFT);
            ui.with_layout(layout, |ui| self.table(ui, session, filter.as_ref(), &mut out));
        });
        out
    }

    /// Shows the rows of a set, or all.
    fn table(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        filter: Option<&LightSet>,
        out: &mut Vec<Command>,
    ) {
        let sheet = Sheet { session, lights: &self.lights };
        let rows = sheet.rows(filter, self.grid.sort);
        if !rows.iter().any(|row| matches!(row, Row::Light(_))) {
            hint(
                ui,
                match filter {
                    Some(_) => {
                        tr!("No light is of this set. Sets name ids, \"names\" and group:names, \
                             with * for any letters.")
                    }
                    None => tr!("There are no lights yet."),
                },
            );
            return;
        }
        let columns: Vec<Column> = Column::all().filter(|column| self.is_shown(*column)).collect();
        let shown = ShownCells { rows: &rows, columns: &columns };
        let before = self.grid.selection.cursor().map(|(row, _)| row.clone());
        self.grid.show(ui, sheet, shown, out);
        let now = self.grid.selection.cursor().map(|(row, _)| row.clone());
        if let Some(Row::Light(id)) = now.filter(|now| Some(now) != before.as_ref()) {
            out.push(Command::ChooseLight(id));
        }
        if let Some(column) = self.grid.hidden.take() {
            out.push(self.keeping(column, false));
        }
    }

    /// Command that remembers whether a column is shown.
    fn keeping(&self, column: Column, is_shown: bool) -> Command {
        let mut columns = self.columns.clone();
        columns.insert(column.word().to_owned(), is_shown);
        Command::KeepLightColumns(columns)
    }

    /// True if a column is shown: as it was chosen, or else if any light has such a field.
    fn is_shown(&self, column: Column) -> bool {
        self.columns.get(column.word()).copied().unwrap_or_else(|| match column {
            Column::Id | Column::Space => false,
            Column::Exposure => !self.lights.groups(None).is_empty(),
            Column::Field(field) => {
                self.lights.lights().values().any(|light| field.is_of(light.kind))
            }
            _ => true,
        })
    }

    fn bar(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        wrong: Option<&crate::document::SetError>,
        out: &mut Vec<Command>,
    ) {
        let is_wide = ui.available_width() > WIDE;
        ui.horizontal_wrapped(|ui| {
            let colors = theme::of(ui);
            let ink = if wrong.is_some() { colors.error } else { colors.text };
            let edit = TextEdit::singleline(&mut self.filter)
                .id(Id::unique("filter of the light table"))
                .hint_text(tr!("Filter: group:rim - key"))
                .text_color(ink)
                .desired_width(FILTER)
                .char_limit(400);
            let response = ui.add(edit);
            response.widget_info(|| {
                WidgetInfo::labeled(Role::TextInput, true, tr!("Filter of lights"))
            });
            let help =
                tr!("Lists the lights of a set: * is every light. key | group:rim - \"Sun\" says \
                     more: ids, groups and names, with | for either, - for without, & for both, \
                     and ( )");
            match wrong {
                Some(why) => {
                    ui.label(RichText::new(why.to_string()).small().color(colors.error));
                }
                None => drop(response.on_hover_text(help)),
            }
            self.columns_menu(ui, out);
            add::menus(ui, session, self.lights.shared(), out);
            for (panel, label, help) in [
                (PanelId::MIXER, tr!("Mixer"), tr!("The groups' masters, as faders")),
                (PanelId::LINKS, tr!("Links"), tr!("Which lights light which objects, and why")),
            ] {
                if is_wide && ui.button(label).on_hover_text(help).clicked() {
                    out.push(Command::ShowPanel(panel));
                }
            }
        });
        ui.add_space(2.0);
    }

    fn columns_menu(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let menu = egui::containers::menu::MenuButton::new(tr!("Columns")).config(
            egui::containers::menu::MenuConfig::new()
                .close_behavior(egui::PopupCloseBehavior::CloseOnClickOutside),
        );
        let (response, _) = menu.ui(ui, |ui| {
            for column in Column::all().filter(|column| *column != Column::Name) {
                let mut is_shown = self.is_shown(column);
                let check = ui.checkbox(&mut is_shown, column.label());
                if check.on_hover_text(column.help()).changed() {
                    out.push(self.keeping(column, is_shown));
                }
            }
            ui.separator();
            let help = tr!("Shows the columns that a light of the table has something in");
            if ui.button(tr!("Only what lights have")).on_hover_text(help).clicked() {
                out.push(Command::KeepLightColumns(BTreeMap::new()));
            }
        });
        response.on_hover_text(tr!("Shows and hides columns"));
    }
}
