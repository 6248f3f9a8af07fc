//! Search for a node to add.

use chiaro_locale::{tr, tr_in};
use eframe::egui;
use std::sync::Arc;

use eframe::egui::{
    Align2, Area, Id, Key, Modifiers, Order, Pos2, RichText, ScrollArea, TextEdit, Ui, pos2, vec2,
};

use crate::catalog::{Catalog, NodeKind, Port};
use crate::document::Endpoint;
use crate::fields::names;
use crate::ids::NodeId;
use crate::library::Type;
use crate::widgets::theme;

const WIDTH: f32 = 300.0;
const ROW: f32 = 24.0;
const ROWS: f32 = 11.0;

/// Loose wire that the new node is to be wired to.
#[derive(Clone, Debug)]
pub(crate) struct LooseWire {
    pub(crate) end: Endpoint,
    pub(crate) ty: Type,
    /// Types that the wire's end accepts, where that end is an input.
    pub(crate) accepts: Vec<Type>,
    pub(crate) is_output: bool,
}

impl LooseWire {
    /// Port of `kind` that the wire would lead to, by index, and how well it fits.
    pub(crate) fn fit(&self, kind: &NodeKind) -> Option<(usize, f32)> {
        if self.is_output {
            let ports = kind.inputs.iter().enumerate().filter(|(_, port)| port.takes(&self.ty));
            let first = kind.inputs.iter().position(Port::is_wirable);
            // The first wirable input is a node's main input, and weighs more.
            let weight = |index| if Some(index) == first { 1.5 } else { 0.0 };
            return best(
                ports.map(|(index, port)| (index, fitness(&self.ty, &port.ty) + weight(index))),
            );
        }
        let fits = |ty: &Type| self.accepts.iter().any(|to| ty.convert_to(to).is_some());
        let ports =
            kind.outputs.iter().enumerate().filter(|(_, port)| kind.is_reroute || fits(&port.ty));
        best(ports.map(|(index, port)| (index, fitness(&port.ty, &self.ty))))
    }
}

fn fitness(from: &Type, to: &Type) -> f32 {
    if from == to {
        2.0
    } else if from.converts_without_loss(to) {
        1.0
    } else {
        0.0
    }
}

fn best(ports: impl Iterator<Item = (usize, f32)>) -> Option<(usize, f32)> {
    // Of equally good ports the first wins, as ports stand in the order of their importance.
    ports.fold(None, |best, (index, fit)| match best {
        Some((_, known)) if known >= fit => best,
        _ => Some((index, fit)),
    })
}

/// An open search.
pub(crate) struct Palette {
    /// Point where the search was opened, on the screen.
    pub(crate) at: Pos2,
    pub(crate) loose: Option<LooseWire>,
    /// Node to be swapped for the chosen kind, and its present kind.
    pub(crate) swaps: Option<(NodeId, Option<Arc<NodeKind>>)>,
    query: String,
    index: usize,
    is_new: bool,
}

/// Outcome of one frame of a search.
pub(crate) enum SearchOutcome {
    Open,
    Closed,
    Chosen(Arc<NodeKind>),
}

impl Palette {
    pub(crate) fn new(at: Pos2, loose: Option<LooseWire>) -> Self {
        Self { at, loose, swaps: None, query: String::new(), index: 0, is_new: true }
    }

    /// Search for a kind to swap a node for.
    pub(crate) fn swapping(at: Pos2, node: NodeId, kind: Option<Arc<NodeKind>>) -> Self {
        Self { swaps: Some((node, kind)), ..Self::new(at, None) }
    }

    /// Shows the search within `screen`.
    pub(crate) fn show(&mut self, ui: &Ui, screen: egui::Rect, catalog: &Catalog) -> SearchOutcome {
        let found = self.found(catalog);
        let key = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        if key(Key::Escape) {
            return SearchOutcome::Closed;
        }
        if key(Key::ArrowDown) {
            self.index += 1;
        }
        if key(Key::ArrowUp) {
            self.index = self.index.saturating_sub(1);
        }
        self.index = self.index.min(found.len().saturating_sub(1));
        if key(Key::Enter) {
            return found
                .get(self.index)
                .map_or(SearchOutcome::Open, |kind| SearchOutcome::Chosen(kind.clone()));
        }
        let size = vec2(WIDTH, ROW * ROWS + 60.0);
        let corner = pos2(
            self.at.x.min(screen.max.x - size.x).max(screen.min.x),
            self.at.y.min(screen.max.y - size.y).max(screen.min.y),
        );
        let mut outcome = SearchOutcome::Open;
        let area = Area::new(Id::unique("palette"))
            .order(Order::Foreground)
            .fixed_pos(corner)
            .pivot(Align2::LEFT_TOP);
        let shown = area.show(ui.ctx(), |ui| {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_width(WIDTH);
                self.show_query(ui);
                if let Some(chosen) = self.show_list(ui, &found) {
                    outcome = SearchOutcome::Chosen(chosen);
                }
            });
        });
        let is_outside = ui.input(|input| {
            let press = input.pointer.any_pressed().then(|| input.pointer.interact_pos()).flatten();
            press.is_some_and(|press| !shown.response.rect.contains(press))
        });
        let was_new = std::mem::replace(&mut self.is_new, false);
        if is_outside && !was_new && matches!(outcome, SearchOutcome::Open) {
            SearchOutcome::Closed
        } else {
            outcome
        }
    }

    fn show_query(&mut self, ui: &mut Ui) {
        let hint = match (&self.loose, &self.swaps) {
            (Some(_), _) => tr!("Search for what fits this wire"),
            (_, Some(_)) => tr!("Swap for: search for a node"),
            _ => tr!("Search for a node"),
        };
        let edit =
            TextEdit::singleline(&mut self.query).hint_text(hint).desired_width(f32::INFINITY);
        let response = ui.add(edit.id(Id::unique("palette query")));
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SearchInput, true, hint));
        if self.is_new {
            response.request_focus();
        }
        if response.changed() {
            self.index = 0;
        }
    }

    fn show_list(&self, ui: &mut Ui, found: &[Arc<NodeKind>]) -> Option<Arc<NodeKind>> {
        if found.is_empty() {
            ui.add_space(6.0);
            ui.label(RichText::new(tr!("Nothing of that name")).color(theme::of(ui).dim));
            return None;
        }
        let mut chosen = None;
        ui.spacing_mut().item_spacing.y = 0.0;
        ScrollArea::vertical()
            .max_height(ROW * ROWS)
            .min_scrolled_height(ROW * ROWS)
            .auto_shrink([false, true])
            .show(ui, |ui| {
                for (index, kind) in found.iter().enumerate() {
                    let is_current = index == self.index;
                    let (rect, response) = ui
                        .allocate_exact_size(vec2(ui.available_width(), ROW), egui::Sense::click());
                    response.widget_info(|| {
                        egui::WidgetInfo::labeled(
                            egui::Role::Button,
                            true,
                            tr!("Add {node}", node = names::of(&kind.id, &kind.label)),
                        )
                    });
                    if is_current && ui.input(|input| input.keys_down.len()) > 0 {
                        response.scroll_to_me(None);
                    }
                    if ui.is_rect_visible(rect) {
                        paint_row(ui, rect, kind, is_current, response.hovered());
                    }
                    if response
                        .on_hover_text(first_sentence(names::of(&kind.id, &kind.help)))
                        .clicked()
                    {
                        chosen = Some(kind.clone());
                    }
                }
            });
        chosen
    }

    /// Kinds that fit the query and the loose wire or the swapped node, best first.
    fn found(&self, catalog: &Catalog) -> Vec<Arc<NodeKind>> {
        let mut found: Vec<(f32, &Arc<NodeKind>)> = Vec::new();
        for kind in catalog.all() {
            let fit = match &self.loose {
                Some(loose) => match loose.fit(kind) {
                    Some((_, fit)) => fit,
                    None => continue,
                },
                None => self
                    .swaps
                    .as_ref()
                    .and_then(|(_, old)| likeness(old.as_ref()?, kind))
                    .unwrap_or(0.0),
            };
            if let Some(score) = score(&self.query, kind) {
                found.push((score + fit * 2.0, kind));
            }
        }
        // The sort is stable, so that equals stay in the library's order.
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.into_iter().map(|(_, kind)| kind.clone()).collect()
    }
}

/// Kinds of nodes that fit a query, best first; all of them where it is empty.
pub(crate) fn kinds(catalog: &Catalog, query: &str) -> Vec<Arc<NodeKind>> {
    let query = query.to_owned();
    Palette { query, ..Palette::new(Pos2::ZERO, None) }.found(catalog)
}

/// Share of a node's ports that stay when another kind takes its place, 0 to 1; `None` where it is
/// the same kind.
fn likeness(old: &NodeKind, new: &NodeKind) -> Option<f32> {
    if old.id == new.id {
        return None;
    }
    let stays = |ports: &[Port], others: &[Port]| {
        let same = |port: &&Port| {
            others.iter().any(|other| (&other.name, &other.ty) == (&port.name, &port.ty))
        };
        ports.iter().filter(same).count() as f32 / ports.len().max(1) as f32
    };
    let gives = |index: usize| new.outputs.get(index).map(|port| &port.ty);
    let is_taken_up = old.outputs.first().is_none_or(|port| gives(0) == Some(&port.ty));
    let is_near = f32::from(u8::from(old.category == new.category));
    Some(if is_taken_up {
        0.5 + 0.35 * stays(&old.inputs, &new.inputs) + 0.15 * is_near
    } else {
        0.0
    })
}

fn paint_row(ui: &Ui, rect: egui::Rect, kind: &NodeKind, is_current: bool, is_hovered: bool) {
    let painter = ui.painter();
    if is_current || is_hovered {
        let fill = if is_current { theme::of(ui).accent_dim } else { theme::of(ui).field };
        painter.rect_filled(rect, 4.0, fill);
    }
    let bar = egui::Rect::from_min_size(rect.min + vec2(4.0, 5.0), vec2(4.0, ROW - 10.0));
    painter.rect_filled(bar, 2.0, theme::of(ui).of_category(&kind.category).gamma_multiply(1.6));
    let font = egui::FontId::proportional(theme::TEXT_SIZE);
    painter.text(
        rect.left_center() + vec2(16.0, 0.0),
        Align2::LEFT_CENTER,
        names::of(&kind.id, &kind.label),
        font.clone(),
        theme::of(ui).text,
    );
    painter.text(
        rect.right_center() - vec2(8.0, 0.0),
        Align2::RIGHT_CENTER,
        tr_in("node", &kind.category),
        font,
        theme::of(ui).dim,
    );
}

/// First sentence of a help text.
fn first_sentence(text: &str) -> &str {
    text.split_inclusive(". ").next().unwrap_or(text).trim()
}

/// Score of a kind for a query; `None` unless every word of the query is found in the kind.
fn score(query: &str, kind: &NodeKind) -> Option<f32> {
    let languages = [Words::english(kind), Words::shown(kind)];
    let mut sum = 0.0;
    for word in query.to_lowercase().split_whitespace() {
        let scores = languages.iter().filter_map(|words| words.score(word, &kind.id));
        sum += scores.reduce(f32::max)?;
    }
    // Of two equal kinds the one with the shorter name is nearer to the query.
    let length = languages[1].label.chars().count() as f32;
    Some(sum - length * 0.01 * f32::from(u8::from(!query.is_empty())))
}

/// Texts of a kind in one language, by which it is found.
struct Words<'a> {
    /// In lower case.
    label: String,
    category: String,
    help: &'a str,
}

impl<'a> Words<'a> {
    fn english(kind: &'a NodeKind) -> Self {
        let (label, category) = (kind.label.to_lowercase(), kind.category.clone());
        Self { label, category, help: &kind.help }
    }

    fn shown(kind: &'a NodeKind) -> Self {
        Self {
            label: names::of(&kind.id, &kind.label).to_lowercase(),
            category: tr_in("node", &kind.category).to_lowercase(),
            help: names::of(&kind.id, &kind.help),
        }
    }

    fn score(&self, word: &str, id: &str) -> Option<f32> {
        let label = &self.label;
        if label.starts_with(word) {
            return Some(10.0);
        }
        if label.split([' ', '-']).any(|part| part.starts_with(word)) {
            return Some(8.0);
        }
        if label.contains(word) || id.contains(word) {
            return Some(6.0);
        }
        if self.category.starts_with(word) {
            return Some(5.0);
        }
        if is_subsequence(word, label) {
            return Some(3.0);
        }
        (word.len() > 2 && self.help.to_lowercase().contains(word)).then_some(1.0)
    }
}

fn is_subsequence(word: &str, text: &str) -> bool {
    let mut text = text.chars();
    word.len() > 1 && word.chars().all(|c| text.any(|t| t == c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    fn find(query: &str, loose: Option<LooseWire>) -> Vec<String> {
        let catalog = Catalog::new(Library::built_in());
        let mut palette = Palette::new(Pos2::ZERO, loose);
        query.clone_into(&mut palette.query);
        palette.found(&catalog).iter().map(|kind| kind.id.clone()).collect()
    }

    #[test]
    fn the_nearest_name_comes_first() {
        assert_eq!(find("profile", None)[0], "profile");
        assert_eq!(find("light la", None)[0], "light_layer");
        assert_eq!(find("prfl", None)[0], "profile");
        assert!(find("zzzz", None).is_empty());
    }

    #[test]
    fn what_keeps_the_most_of_a_node_is_offered_first_in_its_place() {
        let catalog = Catalog::new(Library::built_in());
        let of = |kind: &str| {
            let palette =
                Palette::swapping(Pos2::ZERO, NodeId::new("a"), catalog.get(kind).cloned());
            palette.found(&catalog).iter().map(|kind| kind.id.clone()).collect::<Vec<_>>()
        };
        for kind in ["add", "light_layer", "profile"] {
            let (old, found) = (catalog.get(kind).unwrap(), of(kind));
            let first = catalog.get(&found[0]).unwrap();
            assert_eq!(first.outputs[0].ty, old.outputs[0].ty, "{kind}: {found:?}");
            assert_ne!(found[0], kind, "to itself nobody swaps");
        }
    }

    #[test]
    fn only_what_fits_a_wire_is_offered() {
        let end = Endpoint::new("a", "b");
        let light = LooseWire { end, ty: Type::Light, accepts: vec![Type::Light], is_output: true };
        let found = find("", Some(light));
        assert!(
            found.contains(&"light_apply".to_owned()) && !found.contains(&"profile".to_owned()),
            "{found:?}"
        );
    }
}
