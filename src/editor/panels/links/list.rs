//! The two panes: rows of lights and of objects, each with a mark of how it stands to what is
//! selected in the other pane, and the rule that decides.

use std::collections::BTreeSet;

use eframe::egui::{
    Align2, FontId, Rect, Response, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    pos2, vec2,
};

use super::relation::{LinkChange, Relation};
use super::{LightRow, PaneContext};
use crate::commands::Command;
use crate::ids::{LightId, ObjectId};
use crate::panels::lights::swatch;
use crate::widgets::rows::{leave_with_pointer, picture_frame, row_ground, undo_keys};
use crate::widgets::text::{cell, hint};
use crate::widgets::theme;

const ROW: f32 = 24.0;
/// Greatest number of rules in a tooltip.
const RULES: usize = 12;

/// Change that a mark asks for, and the objects that it is of.
pub(super) type MarkedChange = (LinkChange, Vec<ObjectId>);

/// Standing of a row to what is selected in the other pane.
#[derive(Clone, Debug, Default, PartialEq)]
struct RowStanding {
    /// Number of pairs in the relation.
    yes: usize,
    /// Number of all pairs.
    all: usize,
    /// Sentences on the pairs: who, whom, and the rule.
    rules: Vec<String>,
    /// The rule, where there is one pair.
    rule: String,
    /// Casters of shadows, where there is one pair.
    shadows: String,
}

impl RowStanding {
    /// The standing of pairs of lights and objects.
    fn of<'p>(
        context: &PaneContext<'_>,
        pairs: impl Iterator<Item = (&'p LightId, &'p ObjectId)>,
    ) -> Self {
        let mut found = Self::default();
        for (light, object) in pairs {
            let Some(state) = context.matrix.state(context.relation, object, light) else {
                continue;
            };
            found.all += 1;
            found.yes += usize::from(state.is_so);
            found.rule.clone_from(&state.rule);
            let casters = match context.relation {
                Relation::Light => context.matrix.casters(object, light),
                Relation::Shadow => Vec::new(),
            };
            let count = casters.len();
            let casters: Vec<&str> = casters.into_iter().map(ObjectId::as_str).collect();
            let shadows = match casters.as_slice() {
                [] => "no shadows there".to_owned(),
                casters => format!("shadows of {}", casters.join(", ")),
            };
            let tells = state.is_so && context.relation == Relation::Light;
            // A row has room only for what the links of shadows change.
            let is_plain = count == context.matrix.object_count();
            found.shadows = if tells && !is_plain { shadows.clone() } else { String::new() };
            if found.rules.len() < RULES {
                let verb = context.relation.verb(state.is_so);
                let name = context.mix.lights.name(light);
                let shadows = if tells { format!(", with {shadows}") } else { String::new() };
                found.rules.push(format!("{object} {verb} {name}: {}{shadows}", state.rule));
            }
        }
        if found.all > 1 {
            found.rule = format!("{} of {}", found.yes, found.all);
            found.shadows.clear();
        }
        if found.all > found.rules.len() {
            found.rules.push(format!("and {} more", found.all - found.rules.len()));
        }
        found
    }

    fn is_all(&self) -> bool {
        self.all > 0 && self.yes == self.all
    }
}

/// Lights of a row.
fn lights_of(context: &PaneContext<'_>, row: &LightRow) -> BTreeSet<LightId> {
    context.mix.lights.of_term(&row.term())
}

/// Shows the pane of lights. Returns the change that a click on a mark asks for.
pub(super) fn lights(
    ui: &mut Ui,
    context: &PaneContext<'_>,
    rows: &[LightRow],
    chosen: &mut BTreeSet<LightRow>,
    objects: &BTreeSet<ObjectId>,
    out: &mut Vec<Command>,
) -> Option<MarkedChange> {
    let asked = match objects.len() {
        0 => "Lights".to_owned(),
        1 => format!("Lights of {}", objects.first().map_or("", ObjectId::as_str)),
        count => format!("Lights of {count} objects"),
    };
    head(ui, &asked);
    let rows: Vec<&LightRow> = rows.iter().collect();
    if rows.is_empty() {
        hint(ui, "There are no lights yet.");
    }
    let mut change = None;
    pane(ui, "lights", rows.len(), |ui, index| {
        let row = rows[index];
        let all = lights_of(context, row);
        let pairs = all.iter().flat_map(|light| objects.iter().map(move |object| (light, object)));
        let standing = (!objects.is_empty()).then(|| RowStanding::of(context, pairs));
        let (name, of) = match row {
            LightRow::Group(group) => (format!("group {group}"), "group"),
            LightRow::Light(id) => (context.mix.lights.name(id).to_owned(), "light"),
        };
        let color = match row {
            LightRow::Light(id) => context.mix.lights.lights().get(id),
            LightRow::Group(_) => None,
        };
        let color = color.map(|light| swatch(light, context.space));
        let is_out = !context.mix.shines(&row.term());
        let line =
            PaneLine { name: &name, of, color, is_quiet: is_out, standing: standing.as_ref() };
        let (response, is_marked) = line.show(ui, chosen.contains(row), out);
        select(ui, &response, &rows, index, chosen);
        if let Some(standing) = standing.filter(|_| is_marked) {
            let terms = vec![row.term()];
            let marked = match standing.is_all() {
                true => LinkChange::Unlink(terms),
                false => LinkChange::Link(terms),
            };
            change = Some((marked, objects.iter().cloned().collect()));
        }
    });
    change
}

/// Shows the pane of objects. Returns the change that a click on a mark asks for.
pub(super) fn objects(
    ui: &mut Ui,
    context: &PaneContext<'_>,
    lights: &BTreeSet<LightRow>,
    chosen: &mut BTreeSet<ObjectId>,
    out: &mut Vec<Command>,
) -> Option<MarkedChange> {
    let asked = match (lights.len(), lights.first()) {
        (1, Some(LightRow::Light(id))) => format!("Objects and {}", context.mix.lights.name(id)),
        (1, Some(LightRow::Group(group))) => format!("Objects and group {group}"),
        (0, _) => "Objects".to_owned(),
        (count, _) => format!("Objects and {count} rows of lights"),
    };
    head(ui, &asked);
    let rows: Vec<&ObjectId> = context.open_scene.scene().objects.keys().collect();
    if rows.is_empty() {
        hint(ui, "The scene has no objects yet.");
    }
    let all: BTreeSet<LightId> = lights.iter().flat_map(|row| lights_of(context, row)).collect();
    let mut change = None;
    pane(ui, "objects", rows.len(), |ui, index| {
        let id = rows[index];
        let pairs = all.iter().map(|light| (light, id));
        let standing = (!lights.is_empty()).then(|| RowStanding::of(context, pairs));
        let is_hidden = context.open_scene.scene().objects.get(id).is_some_and(|o| !o.visible);
        let name = id.as_str();
        let line = PaneLine {
            name,
            of: "object",
            color: None,
            is_quiet: is_hidden,
            standing: standing.as_ref(),
        };
        let (response, is_marked) = line.show(ui, chosen.contains(id), out);
        select(ui, &response, &rows, index, chosen);
        if let Some(standing) = standing.filter(|_| is_marked) {
            let terms = lights.iter().map(LightRow::term).collect();
            let marked = match standing.is_all() {
                true => LinkChange::Unlink(terms),
                false => LinkChange::Link(terms),
            };
            change = Some((marked, vec![id.clone()]));
        }
    });
    change
}

fn head(ui: &mut Ui, text: &str) {
    let text = eframe::egui::RichText::new(text).small().color(theme::of(ui).dim);
    ui.add(eframe::egui::Label::new(text).truncate());
}

fn pane(ui: &mut Ui, salt: &str, count: usize, mut row: impl FnMut(&mut Ui, usize)) {
    ui.spacing_mut().item_spacing.y = 0.0;
    let area = ScrollArea::vertical().auto_shrink([false, false]).id_salt(salt);
    area.show_rows(ui, ROW, count, |ui, rows| {
        for index in rows {
            ui.push_id(index, |ui| row(ui, index));
        }
    });
}

/// Selects rows by a click: one; with Ctrl one more or less; with Shift all between.
fn select<T: Ord + Clone>(
    ui: &Ui,
    response: &Response,
    rows: &[&T],
    index: usize,
    chosen: &mut BTreeSet<T>,
) {
    if !response.clicked() {
        return;
    }
    response.request_focus();
    let row = rows[index];
    let modifiers = ui.input(|input| input.modifiers);
    if modifiers.command {
        if !chosen.remove(row) {
            chosen.insert(row.clone());
        }
    } else if let Some(first) = rows.iter().position(|row| chosen.contains(*row))
        && modifiers.shift
    {
        let between = first.min(index)..=first.max(index);
        *chosen = rows[between].iter().map(|row| (*row).clone()).collect();
    } else if chosen.len() == 1 && chosen.contains(row) {
        chosen.clear();
    } else {
        *chosen = BTreeSet::from([row.clone()]);
    }
}

/// Row of a pane.
struct PaneLine<'l> {
    name: &'l str,
    /// Word for what the row is.
    of: &'l str,
    color: Option<eframe::egui::Color32>,
    /// True for a light that is out, and for an object that is hidden.
    is_quiet: bool,
    standing: Option<&'l RowStanding>,
}

impl PaneLine<'_> {
    /// Name of the row with the word for what it is.
    fn full_name(&self) -> String {
        match self.of {
            // A group's name begins with the word.
            "group" => self.name.to_owned(),
            of => format!("{of} {}", self.name),
        }
    }

    /// Shows the row. Returns its response, and true if its mark was clicked.
    fn show(&self, ui: &mut Ui, is_chosen: bool, out: &mut Vec<Command>) -> (Response, bool) {
        let width = ui.available_width() - 8.0;
        let (rect, response) = ui.allocate_exact_size(vec2(width, ROW), Sense::click());
        let rule = self.standing.map(|standing| standing.rule.clone()).unwrap_or_default();
        response.widget_info(|| {
            let label = format!("Link {}", self.full_name());
            let mut info = WidgetInfo::selected(Role::ListItem, true, is_chosen, label);
            info.current_text_value = Some(rule.clone());
            info
        });
        row_ground(ui, rect, &response, is_chosen);
        leave_with_pointer(ui, &response);
        if response.has_focus() {
            undo_keys(ui, out);
        }
        let colors = theme::of(ui);
        let mut left = rect.left() + 6.0;
        let is_marked = self.standing.is_some_and(|standing| {
            let at = Rect::from_min_size(pos2(left, rect.top() + 2.0), vec2(20.0, 20.0));
            left += 24.0;
            self.mark(ui, at, standing)
        });
        if let Some(color) = self.color {
            let at = Rect::from_min_size(pos2(left, rect.center().y - 7.0), vec2(14.0, 14.0));
            ui.painter().rect_filled(at, 3.0, color);
            picture_frame(ui, at);
            left += 20.0;
        }
        let font = FontId::proportional(theme::TEXT_SIZE);
        let ink = if self.is_quiet { colors.dim } else { colors.text };
        let room = (rect.right() - left).max(0.0);
        let split = left + if self.standing.is_some() { room * 0.42 } else { room };
        let name = Rect::from_min_max(pos2(left, rect.top()), pos2(split - 6.0, rect.bottom()));
        cell(ui, name, self.name, font, ink);
        if let Some(standing) = self.standing {
            let small = FontId::proportional(theme::SMALL_TEXT);
            let place = Rect::from_min_max(pos2(split, rect.top()), rect.max - vec2(4.0, 0.0));
            let text = match (standing.all, standing.shadows.is_empty()) {
                (0, _) if self.of == "group" => "no light of it".to_owned(),
                (0, _) => "no look has it".to_owned(),
                (_, true) => standing.rule.clone(),
                (_, false) => format!("{} · {}", standing.rule, standing.shadows),
            };
            cell(ui, place, &text, small, colors.dim);
        }
        let help = self.standing.map(|standing| standing.rules.join("\n")).unwrap_or_default();
        let click = "A click selects; Ctrl adds, Shift selects all between";
        let help = if help.is_empty() { click.to_owned() } else { format!("{help}\n{click}") };
        (response.on_hover_text(help), is_marked)
    }

    /// Shows how the row stands to the selection. Returns true if a click asks to change that.
    fn mark(&self, ui: &Ui, at: Rect, standing: &RowStanding) -> bool {
        let id = ui.scope_id().with("mark");
        let response = ui.interact(at, id, Sense::click());
        let is_all = standing.is_all();
        let label = format!("{} is linked", self.full_name());
        response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_all, &label));
        let colors = theme::of(ui);
        let (center, radius) = (at.center(), 5.0);
        let ink = if standing.yes > 0 { colors.accent } else { colors.dim };
        let edge = if response.hovered() || response.has_focus() { colors.text } else { ink };
        if standing.all == 0 {
            let font = FontId::proportional(theme::TEXT_SIZE);
            ui.painter().text(center, Align2::CENTER_CENTER, "–", font, colors.dim);
        } else if is_all {
            ui.painter().circle_filled(center, radius, ink);
            ui.painter().circle_stroke(center, radius, Stroke::new(1.3, edge));
        } else {
            ui.painter().circle_stroke(center, radius, Stroke::new(1.3, edge));
            if standing.yes > 0 {
                ui.painter().circle_filled(center, radius / 2.0, ink);
            }
        }
        if response.has_focus() {
            let stroke = Stroke::new(1.0, colors.accent);
            ui.painter().rect_stroke(at, 3.0, stroke, StrokeKind::Inside);
        }
        let clicked = response.clicked();
        response.on_hover_text(match is_all {
            true => "Linked: a click unlinks it",
            false => "Not linked, or not all: a click links it",
        });
        clicked
    }
}
