//! Everything that the picture may cost: effects that run, those kept from before, those dropped,
//! and the proof.

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use eframe::egui::{Color32, FontId, Rect, RichText, ScrollArea, Sense, Ui, pos2, vec2};
use std::sync::Arc;

use crate::commands::{Command, PanelId};
use crate::frame::{Effect, EffectCost, EffectKind, EffectState};
use crate::ids::NodePath;
use crate::panels::table::{PanelPlace, PanelRow, Presence};
use crate::widgets::text::{cell, hint};
use crate::widgets::theme::{self, Colors};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::EFFECTS,
    text!("Effects"),
    text!("Everything that the picture costs, what was left out, and the proof"),
    PanelPlace::BELOW_PICTURE,
    |bench, ui, _| {
        let effects = bench.picture.as_ref().map(|picture| &picture.effects);
        bench.memory.of::<Effects>().show(ui, effects)
    },
)
.with_each_frame(|bench, _, _, presence| {
    if let Some(picture) = &mut bench.picture {
        picture.tells_effects = presence == Presence::Seen;
    }
    Vec::new()
});

const ROW: f32 = 20.0;
/// Least width of a row that tells the reason of an effect, in points.
const REASONED: f32 = 330.0;
const STATES: [EffectState; 3] = [EffectState::Runs, EffectState::Cached, EffectState::Dropped];

/// State of the panel.
pub(crate) struct Effects {
    /// Effects that the lines below were made from.
    of: Arc<Vec<Effect>>,
    lines: Vec<Line>,
    /// True for each state that is listed, in the order of [`STATES`].
    is_listed: [bool; 3],
}

enum Line {
    Kind(EffectKind, usize),
    Effect(usize),
}

impl Default for Effects {
    fn default() -> Self {
        Self { of: Arc::default(), lines: Vec::new(), is_listed: [true; 3] }
    }
}

impl Effects {
    /// Lists `effects`, by kind; a click on the effect of a node leads to the node.
    pub(crate) fn show(&mut self, ui: &mut Ui, effects: Option<&Arc<Vec<Effect>>>) -> Vec<Command> {
        let Some(effects) = effects else {
            hint(ui, tr!("This window has no GPU, so that it draws nothing"));
            return Vec::new();
        };
        if !Arc::ptr_eq(effects, &self.of) {
            self.of = effects.clone();
            self.list();
        }
        if self.of.is_empty() {
            hint(ui, tr!("The effects are listed with the next picture of the look at rest"));
            return Vec::new();
        }
        self.filters(ui);
        let mut commands = Vec::new();
        ui.spacing_mut().item_spacing.y = 0.0;
        ScrollArea::vertical().auto_shrink([false, false]).show_rows(
            ui,
            ROW,
            self.lines.len(),
            |ui, rows| {
                for line in &self.lines[rows] {
                    match line {
                        Line::Kind(kind, count) => head(ui, *kind, *count),
                        Line::Effect(index) => commands.extend(row(ui, &self.of[*index])),
                    }
                }
            },
        );
        commands
    }

    /// Shows the number of effects in each state; a click hides or shows those.
    fn filters(&mut self, ui: &mut Ui) {
        let mut is_changed = false;
        ui.horizontal_wrapped(|ui| {
            for (state, is_listed) in STATES.into_iter().zip(&mut self.is_listed) {
                let count = self.of.iter().filter(|effect| effect.state == state).count();
                let color =
                    if *is_listed { color(state, theme::of(ui)) } else { theme::of(ui).dim };
                let text = RichText::new(counted(state, count)).color(color);
                let help = if *is_listed {
                    tr!("Listed; a click hides them")
                } else {
                    tr!("Hidden; a click lists them")
                };
                let button = egui::Button::new(text).small().selected(*is_listed);
                if ui.add(button).on_hover_text(help).clicked() {
                    *is_listed = !*is_listed;
                    is_changed = true;
                }
            }
        });
        ui.add_space(2.0);
        if is_changed {
            self.list();
        }
    }

    fn list(&mut self) {
        let is_listed = |effect: &Effect| {
            STATES.iter().zip(&self.is_listed).any(|(s, on)| *on && *s == effect.state)
        };
        let mut order: Vec<usize> =
            (0..self.of.len()).filter(|&index| is_listed(&self.of[index])).collect();
        let rank = |state: EffectState| STATES.iter().position(|other| *other == state);
        order.sort_by_key(|&index| (self.of[index].kind, rank(self.of[index].state)));
        self.lines.clear();
        for group in order.chunk_by(|&a, &b| self.of[a].kind == self.of[b].kind) {
            self.lines.push(Line::Kind(self.of[group[0]].kind, group.len()));
            self.lines.extend(group.iter().map(|&index| Line::Effect(index)));
        }
    }
}

fn counted(state: EffectState, count: usize) -> String {
    match state {
        EffectState::Runs => trn!(count, "{count} runs", "{count} run"),
        EffectState::Cached => tr!("{count} cached"),
        EffectState::Dropped => tr!("{count} dropped"),
    }
}

fn color(state: EffectState, colors: &Colors) -> Color32 {
    match state {
        EffectState::Runs => colors.accent,
        EffectState::Cached => colors.second,
        EffectState::Dropped => colors.text,
    }
}

fn plural(kind: EffectKind) -> &'static str {
    match kind {
        EffectKind::Pass => tr!("Passes"),
        EffectKind::Object => tr!("Objects"),
        EffectKind::Look => tr!("Looks"),
        EffectKind::Light => tr!("Lights"),
        EffectKind::Attribute => tr!("Vertex attributes"),
        EffectKind::Texture => tr!("Images"),
        EffectKind::Casters => tr!("Shadows"),
        EffectKind::Uniforms => tr!("Uniforms"),
        EffectKind::Node => tr!("Nodes"),
    }
}

fn head(ui: &mut Ui, kind: EffectKind, count: usize) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let font = FontId::proportional(theme::SMALL_TEXT);
    cell(ui, rect, &format!("{}  {count}", plural(kind)), font, theme::of(ui).dim);
    let y = rect.bottom() - 1.0;
    ui.painter().hline(rect.x_range(), y, egui::Stroke::new(1.0, theme::of(ui).grid));
}

fn row(ui: &mut Ui, effect: &Effect) -> Option<Command> {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    let name = effect.what.replace('`', "");
    let name = name.strip_prefix("node ").or(name.strip_prefix("object ")).unwrap_or(&name);
    response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, tr!("Effect {name}")));
    let is_dropped = effect.state == EffectState::Dropped;
    let node =
        effect.node.as_deref().map(NodePath::parse).and_then(|path| path.outermost().cloned());
    if response.hovered() && node.is_some() {
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).field.gamma_multiply(0.6));
    }
    let dot = if is_dropped { theme::of(ui).dim } else { color(effect.state, theme::of(ui)) };
    let center = pos2(rect.left() + 7.0, rect.center().y);
    match effect.state {
        EffectState::Dropped => {
            ui.painter().circle_stroke(center, 3.5, egui::Stroke::new(1.5, dot))
        }
        _ => ui.painter().circle_filled(center, 3.5, dot),
    };
    let font = FontId::proportional(theme::TEXT_SIZE);
    let (left, width) = (rect.left() + 18.0, rect.width() - 18.0);
    // In a narrow panel reason and proof are told by the help alone.
    let has_reason = width > REASONED;
    let share = if has_reason { 0.3 } else { 0.68 };
    let name_width = (width * share).clamp(70.0, 220.0);
    let proof = effect.proof.map(|proof| proof.label());
    let seen_proof = proof.filter(|_| has_reason);
    let proof_width = if seen_proof.is_some() { (width * 0.22).min(140.0) } else { 0.0 };
    let cost_width = if has_reason { (width * 0.24).min(130.0) } else { width - name_width };
    let column = |from: f32, width: f32| {
        Rect::from_min_size(pos2(from, rect.top()), vec2(width, rect.height()))
    };
    let ink = if is_dropped { theme::of(ui).dim } else { theme::of(ui).text };
    cell(ui, column(left, name_width - 8.0), name, font.clone(), ink);
    let cost = short_cost(effect);
    cell(ui, column(left + name_width, cost_width - 8.0), &cost, font.clone(), ink);
    let reason = effect.reason.replace('`', "");
    let reason_left = left + name_width + cost_width;
    let reason_width = (rect.right() - proof_width - 8.0 - reason_left).max(0.0);
    if has_reason {
        cell(ui, column(reason_left, reason_width), &reason, font.clone(), theme::of(ui).dim);
    }
    if let Some(proof) = seen_proof {
        cell(
            ui,
            column(rect.right() - proof_width, proof_width),
            proof,
            font,
            dot.gamma_multiply(1.3),
        );
    }
    let state = match effect.state {
        EffectState::Runs => tr!("Runs for this picture"),
        EffectState::Cached => tr!("Done for an earlier picture, and still stands"),
        EffectState::Dropped => tr!("Not done"),
    };
    let cost = match is_dropped {
        true => tr!("Saves {cost}", cost = effect.cost),
        false => tr!("Costs {cost}", cost = effect.cost),
    };
    let mut lines = vec![format!("{name}: {state}"), cost, reason];
    lines.extend(proof.map(|proof| tr!("Proof: {proof}")));
    lines.extend(node.is_some().then(|| tr!("A click shows the node").to_owned()));
    let clicked = response.clicked();
    response.on_hover_text(lines.join("\n"));
    node.filter(|_| clicked).map(|id| Command::Show(NodePath::root(id)))
}

/// Main part of an effect's cost, in few letters; a saving has a minus before it.
fn short_cost(effect: &Effect) -> String {
    let cost = &effect.cost;
    let short = match (cost.milliseconds, cost.operations) {
        (Some(milliseconds), _) => {
            EffectCost { milliseconds: Some(milliseconds), ..EffectCost::default() }.to_string()
        }
        (None, 1..) if effect.kind != EffectKind::Pass => {
            tr!("{count} ops", count = cost.operations)
        }
        _ if cost.bytes > 0 => EffectCost::bytes(cost.bytes).to_string(),
        _ => return String::new(),
    };
    if effect.state == EffectState::Dropped { format!("\u{2212}{short}") } else { short }
}
