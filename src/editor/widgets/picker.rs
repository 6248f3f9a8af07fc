//! Picker that a color's swatch opens: a square of saturation and brightness, a strip of hues, red,
//! green and blue as every painting program counts them, the opacity, and the hex code. egui's own
//! picker has a choice of `U8`, which no painter knows, and gives none of its parts a name for
//! screen readers.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::style::StyleModifier;
use eframe::egui::{
    Color32, CornerRadius, EventFilter, Id, Key, Mesh, Modifiers, Popup, PopupCloseBehavior, Rect,
    Response, Role, Sense, Shape, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, color_picker, pos2,
    vec2,
};

use crate::widgets::number::{number_field, number_slider};
use crate::widgets::theme;

/// Size of the square, in points.
const SQUARE: Vec2 = vec2(236.0, 150.0);
/// Height of the strip of hues, in points.
const STRIP: f32 = 16.0;
/// Number of steps that the square is painted in along each side: between them colors are mixed.
const STEPS: u8 = 12;
/// Step of an arrow key, as a part of the whole range.
const STEP: f32 = 0.01;

/// Color by its hue, saturation and brightness, each from 0 to 1, as shown (sRGB-encoded).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Hsv {
    h: f32,
    s: f32,
    v: f32,
}

impl Hsv {
    fn to_rgb(self) -> [f32; 3] {
        [5.0, 3.0, 1.0].map(|n| {
            let k = (n + 6.0 * self.h).rem_euclid(6.0);
            self.v - self.v * self.s * k.min(4.0 - k).clamp(0.0, 1.0)
        })
    }

    fn of(rgb: [f32; 3]) -> Self {
        let [r, g, b] = rgb.map(|x| x.clamp(0.0, 1.0));
        let (most, least) = (r.max(g).max(b), r.min(g).min(b));
        let range = most - least;
        let sixth = match range {
            0.0 => 0.0,
            _ if most == r => (g - b) / range,
            _ if most == g => (b - r) / range + 2.0,
            _ => (r - g) / range + 4.0,
        };
        let s = if most > 0.0 { range / most } else { 0.0 };
        Self { h: (sixth / 6.0).rem_euclid(1.0), s, v: most }
    }

    /// Hue, saturation and brightness of a color, with the hue and the saturation that a hand last
    /// gave it: gray has no hue, and black neither.
    fn remembered(ui: &Ui, id: Id, rgb: [f32; 3]) -> Self {
        let last: Option<Self> = ui.data(|data| data.get_temp(id));
        let is_it = |last: &Self| last.to_rgb().iter().zip(rgb).all(|(a, b)| (a - b).abs() < 2e-3);
        last.filter(is_it).unwrap_or_else(|| Self::of(rgb))
    }

    fn color(self) -> Color32 {
        color32(self.to_rgb())
    }
}

fn color32(rgb: [f32; 3]) -> Color32 {
    let [r, g, b] = rgb.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// Shows a swatch of a straight color as it is seen, and below it, while it is open, the picker.
/// `hex` shows a field for the hex code. Returns the swatch, and the new color where a hand changed
/// it here.
pub(crate) fn swatch(
    ui: &mut Ui,
    color: [f32; 4],
    with_alpha: bool,
    name: impl FnOnce(Response) -> Response,
    hex: impl FnOnce(&mut Ui),
) -> (Response, Option<[f32; 4]>) {
    let (rect, response) = ui.allocate_exact_size(ui.spacing().interact_size, Sense::click());
    let [r, g, b, a] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::ColorWell, ui.is_enabled(), tr!("Color"));
        info.current_text_value = Some(format!("#{r:02x}{g:02x}{b:02x}{a:02x}"));
        info
    });
    let response = name(response);
    let popup = response.id.with("picker");
    let is_open = Popup::is_id_open(ui.ctx(), popup);
    paint_swatch(ui, rect, &response, is_open, Color32::from_rgba_unmultiplied(r, g, b, a));
    // Fields of the picker look as fields do elsewhere, not as the entries of a menu.
    let menu = Popup::menu(&response).id(popup).style(StyleModifier::default());
    let menu = menu.close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let shown = menu.show(|ui| {
        ui.set_width(SQUARE.x);
        ui.spacing_mut().item_spacing.y = 6.0;
        let changed = pick(ui, popup, color, with_alpha);
        ui.horizontal(hex);
        changed
    });
    // A single Escape leaves both a field of the picker and the picker.
    if shown.is_some() && ui.input(|input| input.key_pressed(Key::Escape)) {
        Popup::close_id(ui.ctx(), popup);
    }
    (
        response.on_hover_text(tr!("Click to pick another color")),
        shown.and_then(|shown| shown.inner),
    )
}

fn paint_swatch(ui: &Ui, rect: Rect, response: &Response, is_open: bool, color: Color32) {
    let visuals = if is_open { &ui.visuals().widgets.open } else { ui.style().interact(response) };
    let rect = rect.expand(visuals.expansion);
    color_picker::show_color_at(ui.painter(), color, rect.shrink(1.0));
    let edge = if is_open || response.hovered() || response.has_focus() {
        theme::of(ui).accent
    } else {
        visuals.bg_fill
    };
    ui.painter().rect_stroke(
        rect,
        visuals.corner_radius,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
}

/// Shows everything in the picker but the hex code. Returns the new color where a hand changed it.
/// The hue of a gray is remembered by `id`.
pub(crate) fn pick(ui: &mut Ui, id: Id, color: [f32; 4], with_alpha: bool) -> Option<[f32; 4]> {
    let [r, g, b, a] = color;
    let mut hsv = Hsv::remembered(ui, id, [r, g, b]);
    let before = hsv;
    square(ui, &mut hsv);
    hues(ui, &mut hsv);
    let mut rgb = hsv.to_rgb();
    if hsv == before {
        rgb = [r, g, b];
    }
    let mut is_changed = hsv != before;
    ui.horizontal(|ui| {
        for (value, (letter, name)) in
            rgb.iter_mut().zip([("R", tr!("Red")), ("G", tr!("Green")), ("B", tr!("Blue"))])
        {
            let mut byte = f64::from(value.clamp(0.0, 1.0)) * 255.0;
            let drag = number_field(ui, &mut byte)
                .range(0.0..=255.0)
                .max_decimals(0)
                .speed(0.5)
                .prefix(format!("{letter} "));
            let response = ui.add(drag).on_hover_text(tr!("{name}, from 0 to 255"));
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
            if response.changed() {
                *value = (byte / 255.0) as f32;
                is_changed = true;
            }
        }
    });
    if is_changed && hsv == before {
        hsv = Hsv::of(rgb);
    }
    let alpha = if with_alpha { opacity(ui, a) } else { None };
    if is_changed {
        ui.data_mut(|data| data.insert_temp(id, hsv));
    }
    let [r, g, b] = rgb;
    (is_changed || alpha.is_some()).then_some([r, g, b, alpha.unwrap_or(a)])
}

fn opacity(ui: &mut Ui, alpha: f32) -> Option<f32> {
    let mut percent = f64::from(alpha.clamp(0.0, 1.0)) * 100.0;
    ui.horizontal(|ui| {
        let label = ui.label(tr!("Opacity"));
        ui.spacing_mut().slider_width = SQUARE.x - 120.0;
        let slider = number_slider(ui, &mut percent, 0.0..=100.0).suffix("%").max_decimals(0);
        ui.add(slider).labelled_by(label.id).changed()
    })
    .inner
    .then_some((percent / 100.0) as f32)
}

/// Shows the square: saturation to the right, brightness upward.
fn square(ui: &mut Ui, hsv: &mut Hsv) {
    let (rect, response) = ui.allocate_exact_size(SQUARE, Sense::click_and_drag());
    let (v, h) = (hsv.v, hsv.h);
    response.widget_info(|| {
        WidgetInfo::slider(
            true,
            f64::from(v) * 100.0,
            tr!("Saturation and brightness: arrow keys, or drag"),
        )
    });
    if let Some(at) = grabbed(&response, rect) {
        (hsv.s, hsv.v) = (at.x, 1.0 - at.y);
    }
    let steps = arrows(ui, &response, true);
    (hsv.s, hsv.v) = ((hsv.s + steps.x).clamp(0.0, 1.0), (hsv.v + steps.y).clamp(0.0, 1.0));
    let corner = |x: u8, y: u8| vec2(f32::from(x), f32::from(y)) / f32::from(STEPS);
    let color = |at: Vec2| Hsv { h, s: at.x, v: 1.0 - at.y }.color();
    paint_grid(ui, rect, [STEPS, STEPS], corner, color);
    let at = rect.lerp_inside(vec2(hsv.s, 1.0 - hsv.v));
    let ring = if hsv.v > 0.6 && hsv.s < 0.6 { Color32::BLACK } else { Color32::WHITE };
    ui.painter().circle(at, 6.0, hsv.color(), Stroke::new(2.0, ring));
    edge(ui, rect, &response);
}

/// Shows the strip of all hues, from red to red.
fn hues(ui: &mut Ui, hsv: &mut Hsv) {
    let (rect, response) = ui.allocate_exact_size(vec2(SQUARE.x, STRIP), Sense::click_and_drag());
    let h = hsv.h;
    response.widget_info(|| {
        WidgetInfo::slider(true, f64::from(h) * 360.0, tr!("Hue: arrow keys, or drag"))
    });
    if let Some(at) = grabbed(&response, rect) {
        // The end of the strip is red again, but a hand that stays there does not jump to the
        // beginning.
        hsv.h = at.x.min(0.9999);
    }
    let step = arrows(ui, &response, false).x;
    if step != 0.0 {
        hsv.h = (hsv.h + step).rem_euclid(1.0);
    }
    let corner = |x: u8, y: u8| vec2(f32::from(x) / 36.0, f32::from(y));
    paint_grid(ui, rect, [36, 1], corner, |at| Hsv { h: at.x, s: 1.0, v: 1.0 }.color());
    let x = egui::lerp(rect.x_range(), hsv.h);
    let mark = Rect::from_center_size(pos2(x, rect.center().y), vec2(6.0, rect.height() + 4.0));
    ui.painter().rect(
        mark,
        2.0,
        Hsv { s: 1.0, v: 1.0, ..*hsv }.color(),
        Stroke::new(2.0, Color32::WHITE),
        StrokeKind::Middle,
    );
    edge(ui, rect, &response);
}

/// Point of an area that a hand holds, from 0 to 1 along each side.
fn grabbed(response: &Response, rect: Rect) -> Option<Vec2> {
    let at = response.interact_pointer_pos()?;
    // Requests the focus in the very frame that makes the first change: an edit under another focus
    // is another step.
    if !response.has_focus() {
        response.request_focus();
    }
    Some(((at - rect.min) / rect.size()).clamp(Vec2::ZERO, Vec2::splat(1.0)))
}

/// Presses of arrow keys, which would otherwise move the focus.
fn arrows(ui: &Ui, response: &Response, vertical_arrows: bool) -> Vec2 {
    if !response.has_focus() {
        return Vec2::ZERO;
    }
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    let pressed =
        |key| ui.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key)) as f32 * STEP;
    let up = if vertical_arrows { pressed(Key::ArrowUp) - pressed(Key::ArrowDown) } else { 0.0 };
    vec2(pressed(Key::ArrowRight) - pressed(Key::ArrowLeft), up)
}

fn paint_grid(
    ui: &Ui,
    rect: Rect,
    cells: [u8; 2],
    corner: impl Fn(u8, u8) -> Vec2,
    color: impl Fn(Vec2) -> Color32,
) {
    let mut mesh = Mesh::default();
    for y in 0..=cells[1] {
        for x in 0..=cells[0] {
            let at = corner(x, y);
            mesh.colored_vertex(rect.lerp_inside(at), color(at));
        }
    }
    let row = u32::from(cells[0]) + 1;
    for (x, y) in
        (0..u32::from(cells[1])).flat_map(|y| (0..u32::from(cells[0])).map(move |x| (x, y)))
    {
        let first = y * row + x;
        mesh.add_triangle(first, first + 1, first + row);
        mesh.add_triangle(first + 1, first + row, first + row + 1);
    }
    ui.painter().add(Shape::mesh(mesh));
}

fn edge(ui: &Ui, rect: Rect, response: &Response) {
    let colors = theme::of(ui);
    let color = if response.has_focus() { colors.accent } else { colors.node_edge };
    ui.painter().rect_stroke(
        rect,
        CornerRadius::ZERO,
        Stroke::new(1.0, color),
        StrokeKind::Outside,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_color_comes_back_from_its_hue() {
        for step in 0..1000_u16 {
            let rgb = [step % 10, step / 10 % 10, step / 100].map(|x| f32::from(x) / 9.0);
            let back = Hsv::of(rgb).to_rgb();
            assert!(rgb.iter().zip(back).all(|(a, b)| (a - b).abs() < 1e-5), "{rgb:?} {back:?}");
        }
        assert_eq!(Hsv::of([1.0, 0.5, 0.0]), Hsv { h: 1.0 / 12.0, s: 1.0, v: 1.0 });
        assert_eq!(Hsv::of([0.5; 3]), Hsv { h: 0.0, s: 0.0, v: 0.5 });
        for odd in [f32::NAN, -1.0, 9.0, f32::INFINITY] {
            assert!(
                Hsv::of([odd, 0.2, 0.1])
                    .to_rgb()
                    .iter()
                    .all(|x| x.is_nan() || (0.0..=1.0).contains(x))
            );
        }
    }
}
