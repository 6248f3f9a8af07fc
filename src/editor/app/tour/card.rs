//! Card of a step, beside a ring around the step's target. Both lie over panels and under menus.

use chiaro_locale::tr;
use eframe::egui::{
    Area, Button, Context, Frame, Id, Layout, Margin, Order, Pos2, Rect, RichText, Stroke,
    StrokeKind, Ui, Vec2, pos2, vec2,
};

use super::{Step, TourTexts};
use crate::commands::Command;
use crate::state::session::Session;
use crate::widgets::spots::{self, Spot};
use crate::widgets::theme;

/// Width of the card, in points; less in a narrow window.
const WIDTH: f32 = 312.0;
/// Height of the card before it was shown, in points.
const HEIGHT: f32 = 190.0;
/// Distance from the ring to the card, in points.
const GAP: f32 = 14.0;
/// Distance from the window's edge to the card, in points.
const EDGE: f32 = 10.0;

/// Button that was pressed on the card.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Answer {
    Show,
    Back,
    Next,
    End,
}

/// Progress of the tour.
#[derive(Clone, Copy)]
pub(super) struct TourProgress {
    pub(super) index: usize,
    /// Number of steps.
    pub(super) count: usize,
    pub(super) is_done: bool,
}

/// Shows a step. Returns the button that was pressed.
pub(super) fn show(
    ui: &Ui,
    session: &Session,
    step: &Step,
    progress: TourProgress,
    can_show: bool,
) -> Option<Answer> {
    let target = (step.spots)(session).iter().find_map(|spot| spots::find(ui.ctx(), spot));
    if let Some(target) = target {
        ring(ui, target);
    }
    let mut answer = None;
    let title = tr!(
        "{title}  ·  {step} of {count}",
        title = step.title,
        step = progress.index + 1,
        count = progress.count
    );
    // The step's panels are kept clear: they show what the artist does, and its effect.
    let clear = step.panels.iter().filter_map(|panel| spots::find(ui.ctx(), &Spot::Panel(*panel)));
    card(ui, target, &clear.collect::<Vec<_>>(), |ui| {
        head(ui, &title, &mut answer);
        ui.label(step.task.tr());
        ui.label(RichText::new(step.reason.tr()).color(theme::of(ui).dim));
        dots(ui, progress);
        ui.horizontal(|ui| {
            if ui
                .add_enabled(progress.index > 0, Button::new(tr!("Back")))
                .on_hover_text(tr!("To the step before"))
                .clicked()
            {
                answer = Some(Answer::Back);
            }
            let help = tr!("Does it for you, as a step that Undo takes back");
            let button = ui
                .add_enabled(can_show && !progress.is_done, Button::new(tr!("Show me")))
                .on_hover_text(help);
            if button.on_disabled_hover_text(tr!("There is nothing to do here now")).clicked() {
                answer = Some(Answer::Show);
            }
            ui.with_layout(Layout::right_to_left(eframe::egui::Align::Center), |ui| {
                let (label, help) = match progress.is_done {
                    true => (tr!("Next"), tr!("On to the next step, whenever you like")),
                    false => (tr!("Skip"), tr!("On to the next step, without this one")),
                };
                let colors = theme::of(ui);
                let button = if progress.is_done {
                    Button::new(label).fill(colors.accent_dim)
                } else {
                    Button::new(label)
                };
                if ui.add(button).on_hover_text(help).clicked() {
                    answer = Some(Answer::Next);
                }
            });
        });
    });
    answer
}

/// Shows suggestions after the last step. Returns the chosen command, and true if the tour is over.
pub(super) fn last(ui: &Ui, session: &Session, texts: &TourTexts) -> (Option<Command>, bool) {
    let (mut next, mut answer) = (None, None);
    card(ui, None, &[], |ui| {
        head(ui, texts.title.tr(), &mut answer);
        ui.label((texts.made)(session));
        ui.label(RichText::new(texts.more.tr()).color(theme::of(ui).dim));
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| {
            for (label, help, command) in texts.next {
                if ui.button(label.tr()).on_hover_text(help.tr()).clicked() {
                    next = Some(command.clone());
                }
            }
        });
    });
    let is_over = next.is_some() || answer.is_some();
    (next, is_over)
}

/// Shows the title, and the button that ends the tour.
fn head(ui: &mut Ui, title: &str, answer: &mut Option<Answer>) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(title).strong().color(theme::of(ui).accent));
        ui.with_layout(Layout::right_to_left(eframe::egui::Align::Center), |ui| {
            if ui
                .small_button(tr!("End tour"))
                .on_hover_text(tr!("The look stays as it is; Help has the tour again"))
                .clicked()
            {
                *answer = Some(Answer::End);
            }
        });
    });
}

/// Shows one dot for each step: done, present, or to come.
fn dots(ui: &mut Ui, progress: TourProgress) {
    let (rect, _) =
        ui.allocate_exact_size(vec2(ui.available_width(), 14.0), eframe::egui::Sense::hover());
    let colors = theme::of(ui);
    for index in 0..progress.count {
        let at = pos2(rect.left() + 4.0 + index as f32 * 13.0, rect.center().y);
        let is_behind = index < progress.index || index == progress.index && progress.is_done;
        match (is_behind, index == progress.index) {
            (true, _) => ui.painter().circle_filled(at, 3.5, colors.second),
            (false, true) => ui.painter().circle_filled(at, 3.5, colors.accent),
            (false, false) => ui.painter().circle_stroke(at, 3.0, Stroke::new(1.0, colors.dim)),
        };
    }
    if progress.is_done {
        let font = eframe::egui::TextStyle::Body.resolve(ui.style());
        let text = tr!("Done: play on, or go on");
        ui.painter().text(
            rect.right_center(),
            eframe::egui::Align2::RIGHT_CENTER,
            text,
            font,
            colors.second,
        );
    }
}

/// Shows a card beside its target and off the areas to keep clear, or in a corner where there is no
/// target.
fn card(ui: &Ui, target: Option<Rect>, clear: &[Rect], content: impl FnOnce(&mut Ui)) {
    let ctx = ui.ctx();
    let id = Id::unique("tour card");
    let mut screen = ctx.content_rect().shrink(EDGE);
    // Buttons of the bar above work at any time, the one that saves among them.
    if let Some(save) = spots::find(ctx, &Spot::Save) {
        screen.min.y = screen.min.y.max(save.bottom() + EDGE);
    }
    let width = WIDTH.min(screen.width());
    let height = ctx.memory(|memory| memory.area_rect(id)).map_or(HEIGHT, |rect| rect.height());
    let at = place(screen, target, clear, vec2(width, height));
    let area = Area::new(id).order(Order::Middle).fixed_pos(at).constrain(true);
    area.show(ctx, |ui| {
        let colors = theme::of(ui);
        let frame = Frame::popup(ui.style())
            .stroke(Stroke::new(1.0, colors.accent))
            .inner_margin(Margin::same(12));
        frame.show(ui, |ui| {
            ui.set_width(width - 26.0);
            ui.spacing_mut().item_spacing.y = 7.0;
            content(ui);
        });
    });
}

/// Position of the card as near to the target as possible without covering the target or the areas
/// to keep clear; where there is no such position, the one that covers least, the target before all
/// else. Without a target, the lower right corner.
fn place(screen: Rect, target: Option<Rect>, clear: &[Rect], size: Vec2) -> Pos2 {
    /// Number of positions that are tried along each side.
    const TRIED: u8 = 24;
    let corner = screen.right_bottom() - size - vec2(0.0, 40.0);
    let Some(target) = target else { return corner };
    let room = (screen.size() - size).max(Vec2::ZERO);
    let middle = target.center() - size / 2.0;
    let beside = [
        pos2(target.right() + GAP, middle.y),
        pos2(target.left() - GAP - size.x, middle.y),
        pos2(middle.x, target.bottom() + GAP),
        pos2(middle.x, target.top() - GAP - size.y),
    ];
    let beside = beside.map(|at| at.clamp(screen.left_top(), screen.left_top() + room));
    let grid = (0..=TRIED)
        .flat_map(|x| (0..=TRIED).map(move |y| vec2(x.into(), y.into()) / f32::from(TRIED)));
    let grid = grid.map(|part| screen.left_top() + room * part);
    let cost = |at: Pos2| {
        let card = Rect::from_min_size(at, size);
        let covered = |rect: &Rect| {
            let common = card.intersect(*rect);
            if common.is_positive() { common.area() } else { 0.0 }
        };
        let way = target.distance_to_pos(at + size / 2.0);
        // Covered area of the target weighs more than that of the areas to keep clear, and either
        // more than any distance.
        64.0 * covered(&target.expand(GAP / 2.0))
            + 4.0 * clear.iter().map(covered).sum::<f32>()
            + way
    };
    let best = beside.into_iter().chain(grid).min_by(|a, b| cost(*a).total_cmp(&cost(*b)));
    best.unwrap_or(corner)
}

/// Draws a ring around the target of a step.
fn ring(ui: &Ui, target: Rect) {
    let layer = eframe::egui::LayerId::new(Order::Middle, Id::unique("tour ring"));
    let ctx: &Context = ui.ctx();
    let painter = ctx.layer_painter(layer);
    let accent = theme::of(ui).accent;
    let rect = target.intersect(ctx.content_rect().shrink(3.0));
    painter.rect_stroke(
        rect.expand(4.0),
        8.0,
        Stroke::new(4.0, accent.gamma_multiply(0.3)),
        StrokeKind::Middle,
    );
    painter.rect_stroke(rect.expand(2.0), 6.0, Stroke::new(2.0, accent), StrokeKind::Middle);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_card_is_on_the_screen_and_off_its_target() {
        let size = vec2(312.0, 200.0);
        for (width, height) in [(1600.0, 960.0), (760.0, 480.0)] {
            let screen = Rect::from_min_size(Pos2::ZERO, vec2(width, height));
            for target in [
                Rect::from_min_size(pos2(10.0, 10.0), vec2(60.0, 20.0)),
                Rect::from_min_size(pos2(width - 200.0, 100.0), vec2(190.0, 30.0)),
                Rect::from_min_size(pos2(5.0, height - 220.0), vec2(250.0, 200.0)),
            ] {
                let card = Rect::from_min_size(place(screen, Some(target), &[], size), size);
                assert!(
                    screen.contains_rect(card) && !card.intersects(target),
                    "{card} beside {target} on {screen}"
                );
            }
            // The target is a button in a panel, beside another panel: the card covers neither.
            let panels = [
                Rect::from_min_max(screen.min, pos2(0.3 * width, height)),
                Rect::from_min_max(pos2(0.75 * width, 0.0), screen.max),
            ];
            let button = Rect::from_min_size(pos2(0.75 * width + 4.0, 40.0), vec2(80.0, 20.0));
            let card = Rect::from_min_size(place(screen, Some(button), &panels, size), size);
            assert!(screen.contains_rect(card) && !card.intersects(button), "{card}");
            let is_clear = panels.iter().all(|panel| !card.intersects(*panel));
            assert!(is_clear || 0.45 * width < size.x, "{card} on {screen}");
            let full = Rect::from_min_size(place(screen, Some(screen), &[], size), size);
            assert!(screen.contains_rect(full), "{full}");
        }
    }
}
