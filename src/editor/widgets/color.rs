//! Color field: a swatch that opens a picker, and its hex code.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::ecolor::{gamma_from_linear, linear_from_gamma};
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{Id, TextEdit, Ui};

use super::picker;
use crate::document::{ColorSpace, read_hex, srgb_to_linear};
use crate::values;
use crate::widgets::theme;

/// Edits a straight RGBA color of a look's color space. Returns the id of the widget and the new
/// color where it changed.
pub(crate) fn edit(
    ui: &mut Ui,
    label: Id,
    color: [f64; 4],
    space: ColorSpace,
    with_alpha: bool,
) -> Option<(Id, [f64; 4])> {
    let picker = |response: egui::Response| response.labelled_by(label);
    let swatch = swatch_of(ui, color, space, with_alpha, picker);
    let hex = hex(ui, label, color, space);
    swatch.or(hex)
}

/// Shows the swatch alone.
pub(crate) fn swatch(
    ui: &mut Ui,
    label: Id,
    color: [f64; 4],
    space: ColorSpace,
    with_alpha: bool,
) -> Option<(Id, [f64; 4])> {
    swatch_of(ui, color, space, with_alpha, |response| response.labelled_by(label))
}

/// Shows the picker of a swatch in place, for an opaque color as shown.
pub(crate) fn pick(ui: &mut Ui, color: [f64; 4]) -> Option<[f64; 4]> {
    let id = ui.scope_id().with("color");
    let picked = picker::pick(ui, id, color.map(|x| x as f32), false)?;
    Some(picked.map(|x| (f64::from(x) * 1e4).round() / 1e4))
}

/// Shows the picker of a swatch in place, for an opaque color of a look's color space.
pub(crate) fn pick_in(ui: &mut Ui, color: [f64; 3], space: ColorSpace) -> Option<[f64; 3]> {
    let [r, g, b] = color;
    let [r, g, b, _] = pick(ui, encoded([r, g, b, 1.0], space))?;
    Some(match space {
        ColorSpace::Display => [r, g, b],
        ColorSpace::Linear => {
            [r, g, b].map(|x| (f64::from(linear_from_gamma(x as f32)) * 1e4).round() / 1e4)
        }
    })
}

/// A typed hex code as a color of a look's color space; `None` for what is no code.
pub(crate) fn typed_in(text: &str, space: ColorSpace) -> Option<[f64; 3]> {
    let [r, g, b, _] = parse_typed(text)?;
    Some(match space {
        ColorSpace::Display => [r, g, b].map(|x| (x * 1e4).round() / 1e4),
        ColorSpace::Linear => [r, g, b].map(srgb_to_linear),
    })
}

/// Hex code of a color of a look's color space.
pub(crate) fn code(color: [f64; 3], space: ColorSpace) -> String {
    let [r, g, b] = color;
    values::hex(encoded([r, g, b, 1.0], space))
}

/// Shows the swatch alone; `name` is its name for screen readers.
pub(crate) fn named_swatch(
    ui: &mut Ui,
    name: &str,
    color: [f64; 4],
    space: ColorSpace,
    with_alpha: bool,
) -> Option<(Id, [f64; 4])> {
    swatch_of(ui, color, space, with_alpha, |response| {
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ColorWell, true, name));
        response
    })
}

fn swatch_of(
    ui: &mut Ui,
    color: [f64; 4],
    space: ColorSpace,
    with_alpha: bool,
    name: impl FnOnce(egui::Response) -> egui::Response,
) -> Option<(Id, [f64; 4])> {
    // A picker shows colors as they are seen; a look's colors are so too unless it says otherwise.
    let [r, g, b, a] = encoded(color, space).map(|x| x as f32);
    let mut typed = None;
    let (response, picked) = picker::swatch(ui, [r, g, b, a], with_alpha, name, |ui| {
        let label = ui.label(tr!("Hex code")).id;
        typed = hex(ui, label, color, space);
    });
    let decode = |x: f32| match space {
        ColorSpace::Display => f64::from(x),
        ColorSpace::Linear => f64::from(linear_from_gamma(x)),
    };
    // Four decimals are more precise than a hand in the picker, and keep files readable.
    let picked = picked.map(|[r, g, b, a]| {
        [decode(r), decode(g), decode(b), f64::from(a)].map(|x| (x * 1e4).round() / 1e4)
    });
    picked.map(|color| (response.id, color)).or(typed)
}

/// A color of a look's color space as it is shown.
pub(crate) fn encoded(color: [f64; 4], space: ColorSpace) -> [f64; 4] {
    let [r, g, b, a] = color.map(|x| x.clamp(0.0, 1.0));
    match space {
        ColorSpace::Display => [r, g, b, a],
        ColorSpace::Linear => {
            let [r, g, b] = [r, g, b].map(|x| f64::from(gamma_from_linear(x as f32)));
            [r, g, b, a]
        }
    }
}

/// Parses a color as people type it: with its `#`, without, or with one too many.
fn parse_typed(text: &str) -> Option<[f64; 4]> {
    read_hex(&format!("#{}", text.trim().trim_start_matches('#')))
}

fn hex(ui: &mut Ui, label: Id, color: [f64; 4], space: ColorSpace) -> Option<(Id, [f64; 4])> {
    let id = ui.scope_id().with("hex");
    let shown = values::hex(match space {
        ColorSpace::Display => color,
        ColorSpace::Linear => encoded(color, space),
    });
    // A code that is being typed is no color yet, so the text is kept aside.
    let mut text = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| shown.clone());
    let is_bad = parse_typed(&text).is_none();
    let edit = TextEdit::singleline(&mut text)
        .id(id)
        .align(egui::Align2::LEFT_CENTER)
        .desired_width(80.0)
        .font(egui::TextStyle::Monospace)
        .char_limit(9);
    let edit = if is_bad { edit.text_color(theme::of(ui).error) } else { edit };
    let mut output = edit.show(ui);
    let response = output.response.response.labelled_by(label);
    if response.gained_focus() {
        // A color is usually typed anew, so all of the old one is selected.
        let all = CCursorRange::two(CCursor::new(0), CCursor::new(text.chars().count()));
        output.state.cursor.set_char_range(Some(all));
        output.state.store(ui.ctx(), id);
    }
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text.clone()));
    } else {
        ui.data_mut(|data| data.remove::<String>(id));
    }
    let response = if is_bad {
        response.on_hover_text(tr!("No color: type six digits, as in #d08040"))
    } else {
        response
    };
    // Three digits may be the first of six: they are a color once typing has ended.
    let is_short = text.trim().trim_start_matches('#').len() < 6;
    let is_typed = if is_short { response.lost_focus() } else { response.changed() };
    let parsed = parse_typed(&text).filter(|_| is_typed && text.trim() != shown)?;
    let [r, g, b, a] = parsed;
    Some((
        response.id,
        match space {
            ColorSpace::Display => parsed.map(|x| (x * 1e4).round() / 1e4),
            ColorSpace::Linear => [srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b), a],
        },
    ))
}

#[cfg(test)]
mod tests {
    use super::parse_typed;

    #[test]
    fn colors_are_typed_with_or_without_their_mark() {
        let color = parse_typed("#15131c");
        assert!(color.is_some());
        for text in ["15131c", "##15131c", " #15131c "] {
            assert_eq!(parse_typed(text), color, "{text}");
        }
        assert_eq!(parse_typed("#15131"), None);
        assert_eq!(parse_typed("8af"), parse_typed("#88aaff"));
    }
}
