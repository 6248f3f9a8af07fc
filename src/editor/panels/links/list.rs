//! The two panes: rows of lights and of objects, each with a mark of how it stands to what is
//! selected in the other pane, and the rule that decides.

use std::collections::BTreeSet;

use chiaro_locale::tr;
use eframe::egui::{
    Align2, FontId, Rect, Response, Role, ScrollArea, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    collapsing_header, pos2, vec2,
};

use super::layer::LayerRow;
use super::relation::{LinkChange, Relation};
use super::{LightRow, ObjectRow, PaneContext};
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
    /// Layers that the light does not reach, where there is one pair.
    dark: Option<String>,
    /// Names of lights in the rule, and casters of shadows, where there is one pair.
    aside: Vec<String>,
}

impl RowStanding {
    /// The standing of pairs of lights and objects.
    fn of<'p>(
        context: &PaneContext<'_>,
        pairs: impl Iterator<Item = (&'p LightId, &'p ObjectRow)>,
    ) -> Self {
        let mut found = Self::default();
        for (light, row) in pairs {
            let Some(state) = context.matrix.row_state(context.relation, row, light) else {
                continue;
            };
            found.all += 1;
            found.yes += usize::from(state.is_so);
            found.rule.clone_from(&state.rule);
            (found.dark, found.aside) = (None, Vec::new());
            found.aside.extend(names_in(&state.rule, context));
            let light_name = context.mix.lights.name(light);
            let object = match row {
                ObjectRow::Object(object) => object,
                ObjectRow::Layer(object, layer) => {
                    let name = context.matrix.layer_name(object, layer);
                    let told = layer.sentence(state.is_so, [name, light_name], object);
                    found.tell(format!("{told}: {}", state.rule));
                    continue;
                }
            };
            let is_light = context.relation == Relation::Light;
            let casters = match is_light {
                true => context.matrix.casters(object, light),
                false => Vec::new(),
            };
            let dark = match is_light {
                true => context.matrix.dark_layers(object, light),
                false => Vec::new(),
            };
            let count = casters.len();
            let casters: Vec<&str> = casters.into_iter().map(ObjectId::as_str).collect();
            let casters = (!casters.is_empty()).then(|| casters.join(", "));
            let dark = (!dark.is_empty()).then(|| tr!("not {layers}", layers = dark.join(", ")));
            let mut told = context.relation.sentence(state.is_so, object, light_name);
            told += &format!(": {}", state.rule);
            if let Some(dark) = &dark {
                told += &format!(", {dark}");
            }
            let tells = state.is_so && is_light;
            if tells {
                told = match &casters {
                    None => tr!("{told}, with no shadows there"),
                    Some(casters) => tr!("{told}, with shadows of {casters}"),
                };
            }
            found.tell(told);
            // A row has room only for what the links of shadows change.
            let is_plain = count == context.matrix.object_count();
            found.dark = dark;
            found.aside.extend((tells && !is_plain).then(|| match &casters {
                None => tr!("no shadows there").to_owned(),
                Some(casters) => tr!("shadows of {casters}"),
            }));
        }
        if found.all > 1 {
            found.rule = tr!("{yes} of {all}", yes = found.yes, all = found.all);
            (found.dark, found.aside) = (None, Vec::new());
        }
        if found.all > found.rules.len() {
            found.rules.push(tr!("and {count} more", count = found.all - found.rules.len()));
        }
        found
    }

    /// Keeps a sentence for the tooltip, where there is room for it.
    fn tell(&mut self, sentence: String) {
        if self.rules.len() < RULES {
            self.rules.push(sentence);
        }
    }

    /// The rule with what stands beside it; what is left out tells most, and stands first.
    fn told(&self) -> String {
        let dark = self.dark.iter().map(String::as_str);
        let aside = self.aside.iter().map(String::as_str);
        dark.chain([self.rule.as_str()]).chain(aside).collect::<Vec<_>>().join(" · ")
    }

    fn is_all(&self) -> bool {
        self.all > 0 && self.yes == self.all
    }
}

/// Display names of lights that a rule names by ids which read otherwise: "light_2 is Eye".
fn names_in(rule: &str, context: &PaneContext<'_>) -> Option<String> {
    let is_of_id = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    // Rules quote expressions; their words outside are no ids.
    let quoted = rule.split('`').skip(1).step_by(2);
    let words: BTreeSet<&str> = quoted.flat_map(|text| text.split(|c| !is_of_id(c))).collect();
    let lights = context.mix.lights.lights();
    let named = lights
        .iter()
        .filter(|(id, light)| words.contains(id.as_str()) && light.display_name(id) != id.as_str());
    let named: Vec<String> =
        named.map(|(id, light)| tr!("{id} is {name}", name = light.display_name(id))).collect();
    (!named.is_empty()).then(|| named.join(", "))
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
    objects: &BTreeSet<ObjectRow>,
    out: &mut Vec<Command>,
) -> Option<MarkedChange> {
    let asked = match (objects.len(), objects.first()) {
        (1, Some(ObjectRow::Object(object))) => tr!("Lights of {object}"),
        (1, Some(ObjectRow::Layer(object, layer))) => {
            let layer = context.matrix.layer_name(object, layer);
            tr!("Lights of {layer} of {object}")
        }
        (0, _) => tr!("Lights").to_owned(),
        (count, _) => tr!("Lights of {count} rows of objects"),
    };
    let linked: Vec<ObjectId> = objects.iter().filter_map(ObjectRow::object).cloned().collect();
    head(ui, &asked);
    let rows: Vec<&LightRow> = rows.iter().collect();
    if rows.is_empty() {
        hint(ui, tr!("There are no lights yet."));
    }
    let mut change = None;
    pane(ui, "lights", rows.len(), |ui, index| {
        let row = rows[index];
        let all = lights_of(context, row);
        let pairs = all.iter().flat_map(|light| objects.iter().map(move |object| (light, object)));
        let standing = (!objects.is_empty()).then(|| RowStanding::of(context, pairs));
        let (name, kind) = match row {
            LightRow::Group(group) => (tr!("group {name}", name = group), LineKind::Group),
            LightRow::Light(id) => (context.mix.lights.name(id).to_owned(), LineKind::Light),
        };
        let color = match row {
            LightRow::Light(id) => context.mix.lights.lights().get(id),
            LightRow::Group(_) => None,
        };
        let color = color.map(|light| swatch(light, context.space));
        let is_out = !context.mix.shines(&row.term());
        let line = PaneLine {
            name: &name,
            kind,
            color,
            is_quiet: is_out,
            standing: standing.as_ref(),
            is_fixed: linked.is_empty(),
            fold: FoldMark::Absent,
        };
        let shown = line.show(ui, chosen.contains(row), out);
        select(ui, &shown.response, &rows, index, chosen);
        if let Some(standing) = standing.filter(|_| shown.is_marked) {
            let terms = vec![row.term()];
            let marked = match standing.is_all() {
                true => LinkChange::Unlink(terms),
                false => LinkChange::Link(terms),
            };
            change = Some((marked, linked.clone()));
        }
    });
    change
}

/// Shows the pane of objects. Returns the change that a click on a mark asks for.
pub(super) fn objects(
    ui: &mut Ui,
    context: &PaneContext<'_>,
    (rows, unfolded): (&[ObjectRow], &mut BTreeSet<ObjectId>),
    lights: &BTreeSet<LightRow>,
    chosen: &mut BTreeSet<ObjectRow>,
    out: &mut Vec<Command>,
) -> Option<MarkedChange> {
    let asked = match (lights.len(), lights.first()) {
        (1, Some(LightRow::Light(id))) => {
            tr!("Objects and {light}", light = context.mix.lights.name(id))
        }
        (1, Some(LightRow::Group(group))) => tr!("Objects and group {group}"),
        (0, _) => tr!("Objects").to_owned(),
        (count, _) => tr!("Objects and {count} rows of lights"),
    };
    head(ui, &asked);
    let rows: Vec<&ObjectRow> = rows.iter().collect();
    let objects = &context.open_scene.scene().objects;
    let has_layers = |id: &ObjectId| {
        context.relation == Relation::Light && context.matrix.layers(id).next().is_some()
    };
    let has_folds = objects.keys().any(has_layers);
    if rows.is_empty() {
        hint(ui, tr!("The scene has no objects yet."));
    }
    let all: BTreeSet<LightId> = lights.iter().flat_map(|row| lights_of(context, row)).collect();
    let mut change = None;
    pane(ui, "objects", rows.len(), |ui, index| {
        let row = rows[index];
        let pairs = all.iter().map(|light| (light, row));
        let standing = (!lights.is_empty()).then(|| RowStanding::of(context, pairs));
        let (ObjectRow::Object(id) | ObjectRow::Layer(id, _)) = row;
        let is_hidden = objects.get(id).is_some_and(|object| !object.visible);
        let (name, kind, fold) = match row {
            ObjectRow::Object(_) if has_layers(id) => {
                let is_open = unfolded.contains(id);
                (id.to_string(), LineKind::Object, FoldMark::Triangle { is_open })
            }
            ObjectRow::Object(_) if has_folds => (id.to_string(), LineKind::Object, FoldMark::Room),
            ObjectRow::Object(_) => (id.to_string(), LineKind::Object, FoldMark::Absent),
            ObjectRow::Layer(_, layer) => {
                let kind = if layer.is_filter { LineKind::Filter } else { LineKind::Layer };
                (layer_text(context, id, layer), kind, FoldMark::Below)
            }
        };
        let line = PaneLine {
            name: &name,
            kind,
            color: None,
            is_quiet: is_hidden,
            standing: standing.as_ref(),
            is_fixed: row.object().is_none(),
            fold,
        };
        let shown = line.show(ui, chosen.contains(row), out);
        select(ui, &shown.response, &rows, index, chosen);
        if shown.is_folded && !unfolded.remove(id) {
            unfolded.insert(id.clone());
        }
        if let Some(standing) = standing.filter(|_| shown.is_marked) {
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

/// Name of a layer, with the word for one that filters.
fn layer_text(context: &PaneContext<'_>, object: &ObjectId, layer: &LayerRow) -> String {
    let name = context.matrix.layer_name(object, layer);
    if layer.is_filter { tr!("{name}, as a filter") } else { name.to_owned() }
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

/// Place before a row's name for the mark that unfolds it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum FoldMark {
    /// No row of the pane has layers.
    Absent,
    /// Other rows have layers.
    Room,
    Triangle {
        is_open: bool,
    },
    /// The row is a layer of the row above.
    Below,
}

/// Row that was shown.
struct ShownLine {
    response: Response,
    /// True if its mark was clicked.
    is_marked: bool,
    /// True if it is to be folded or unfolded.
    is_folded: bool,
}

/// Kind of a pane's row.
#[derive(Clone, Copy, PartialEq, Eq)]
enum LineKind {
    Group,
    Light,
    Object,
    Layer,
    /// Layer that filters lights.
    Filter,
}

/// Row of a pane.
struct PaneLine<'l> {
    name: &'l str,
    kind: LineKind,
    color: Option<eframe::egui::Color32>,
    /// True for a light that is out, and for an object that is hidden.
    is_quiet: bool,
    standing: Option<&'l RowStanding>,
    /// True if a click on the mark changes nothing.
    is_fixed: bool,
    fold: FoldMark,
}

impl PaneLine<'_> {
    /// Name of the row with the word for what it is.
    fn full_name(&self) -> String {
        let name = self.name;
        match self.kind {
            // A group's name begins with the word.
            LineKind::Group => name.to_owned(),
            LineKind::Light => tr!("light {name}"),
            LineKind::Object => tr!("object {name}"),
            LineKind::Layer => tr!("layer {name}"),
            LineKind::Filter => tr!("filter {name}"),
        }
    }

    /// Shows the row.
    fn show(&self, ui: &mut Ui, is_chosen: bool, out: &mut Vec<Command>) -> ShownLine {
        let width = ui.available_width() - 8.0;
        let (rect, response) = ui.allocate_exact_size(vec2(width, ROW), Sense::click());
        let rule = self.standing.map(RowStanding::told).unwrap_or_default();
        response.widget_info(|| {
            let label = tr!("Link {row}", row = self.full_name());
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
        let is_folded = self.triangle(ui, &mut left, rect);
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
        let split = left + if self.standing.is_some() { room * 0.5 } else { room };
        let name = Rect::from_min_max(pos2(left, rect.top()), pos2(split - 6.0, rect.bottom()));
        cell(ui, name, self.name, font, ink);
        if let Some(standing) = self.standing {
            let small = FontId::proportional(theme::SMALL_TEXT);
            let place = Rect::from_min_max(pos2(split, rect.top()), rect.max - vec2(4.0, 0.0));
            let text = match (standing.all, self.kind) {
                (0, LineKind::Group) => tr!("no light of it").to_owned(),
                (0, LineKind::Layer | LineKind::Filter) => tr!("not about it").to_owned(),
                (0, LineKind::Light) if self.is_fixed => {
                    tr!("the layer is not about it").to_owned()
                }
                (0, _) => tr!("no look has it").to_owned(),
                _ => standing.told(),
            };
            cell(ui, place, &text, small, colors.dim);
        }
        let help = self.standing.map(|standing| standing.rules.join("\n")).unwrap_or_default();
        let click = match self.fold {
            FoldMark::Below => {
                tr!("A click selects: the lights' marks are its own then. Its sets are changed in \
                     Objects, under Lights of its layers, or at the node itself")
            }
            _ => tr!("A click selects; Ctrl adds, Shift selects all between"),
        };
        let help = if help.is_empty() { click.to_owned() } else { format!("{help}\n{click}") };
        ShownLine { response: response.on_hover_text(help), is_marked, is_folded }
    }

    /// Shows the triangle that unfolds the row's layers, or leaves its room. Returns true if it was
    /// clicked.
    fn triangle(&self, ui: &mut Ui, left: &mut f32, rect: Rect) -> bool {
        let at = Rect::from_center_size(pos2(*left + 7.0, rect.center().y), vec2(11.0, 11.0));
        *left += match self.fold {
            FoldMark::Absent => 0.0,
            FoldMark::Room | FoldMark::Triangle { .. } => 18.0,
            FoldMark::Below => 34.0,
        };
        let FoldMark::Triangle { is_open } = self.fold else { return false };
        let response = ui.interact(at, ui.scope_id().with("fold"), Sense::click());
        let label = tr!("Layers of {object}", object = self.name);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_open, &label));
        collapsing_header::paint_default_icon(ui, f32::from(u8::from(is_open)), &response);
        let help = tr!("Layers of its looks that are about lights");
        response.on_hover_text(help).clicked()
    }

    /// Shows how the row stands to the selection. Returns true if a click asks to change that.
    fn mark(&self, ui: &Ui, at: Rect, standing: &RowStanding) -> bool {
        let id = ui.scope_id().with("mark");
        let sense = if self.is_fixed { Sense::hover() } else { Sense::click() };
        let response = ui.interact(at, id, sense);
        let is_all = standing.is_all();
        let label = tr!("{row} is linked", row = self.full_name());
        let is_on = !self.is_fixed;
        response.widget_info(|| WidgetInfo::selected(Role::CheckBox, is_on, is_all, &label));
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
        response.on_hover_text(match (self.is_fixed, is_all) {
            (true, true) => tr!("It is reached"),
            (true, false) => tr!("It is not reached, or not by all"),
            (false, true) => tr!("Linked: a click unlinks it"),
            (false, false) => tr!("Not linked, or not all: a click links it"),
        });
        clicked
    }
}
