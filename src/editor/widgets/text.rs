//! Lines of text: a hint in place of missing content, a cell that is cut where it is too long, and
//! a field for texts with a form of their own.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    Color32, CursorIcon, Id, Label, Popup, PopupCloseBehavior, Response, RichText, Role, Sense,
    TextEdit, TextStyle, TextWrapMode, Ui, WidgetInfo, WidgetText,
};

use super::{menu, rows, theme};

/// Greatest width of a text that is shown whole, in points.
const WHOLE: f32 = 520.0;

/// Shows a line in place of content that does not exist yet.
pub(crate) fn hint(ui: &mut Ui, text: &str) {
    ui.label(egui::RichText::new(text).color(theme::of(ui).dim));
}

/// Shows a text that is cut after so many lines; the whole of it is up to the help.
pub(crate) fn in_lines(ui: &mut Ui, text: RichText, lines: usize) -> Response {
    let style = egui::FontSelection::Default;
    let job = WidgetText::from(text).into_layout_job(ui.style(), style, egui::Align::Center);
    let mut job = Arc::unwrap_or_clone(job);
    job.wrap.max_rows = lines;
    ui.add(Label::new(job).show_tooltip_when_elided(false))
}

/// Shows a text in one line, which ends with an ellipsis where it has no room. The whole of it is
/// shown under the pointer, and a click shows it to be read and copied. Returns true if it is to be
/// copied.
pub(crate) fn in_a_line(ui: &mut Ui, text: &str, color: Color32) -> bool {
    let rich = RichText::new(text).color(color);
    let line = WidgetText::from(rich.clone());
    let room = ui.available_width();
    let line = line.into_galley(ui, Some(TextWrapMode::Truncate), room, TextStyle::Body);
    let label = Label::new(rich).truncate();
    if !line.elided {
        ui.add(label);
        return false;
    }
    let label = label.selectable(false).sense(Sense::click()).show_tooltip_when_elided(false);
    let response = ui.add(label);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, text));
    if response.hovered() || response.has_focus() {
        let underline = (1.0, theme::of(ui).accent);
        ui.painter().hline(response.rect.x_range(), response.rect.bottom(), underline);
    }
    let popup = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let copied = popup.show(|ui| {
        ui.set_width(WHOLE.min(ui.ctx().content_rect().width() * 0.8));
        let is_copied = menu::scrolling(ui, |ui| {
            ui.add(Label::new(text).wrap().selectable(true));
            ui.button(tr!("Copy")).clicked()
        });
        if is_copied {
            ui.close();
        }
        is_copied
    });
    let help = tr!("{text}\nA click shows it, to be copied.");
    response.on_hover_cursor(CursorIcon::PointingHand).on_hover_text(help);
    copied.is_some_and(|copied| copied.inner)
}

/// True if the text of a field that takes effect while it is typed is another one in this frame.
/// Escape brings back the text that the field had when it got the keyboard.
pub(crate) fn is_typed(ui: &Ui, response: &Response, text: &mut String) -> bool {
    let id = response.id.with("text before it was typed");
    let frame = ui.ctx().cumulative_frame_nr();
    // A text kept frames ago is of a field that was hidden while it had the keyboard.
    let kept = ui.data_mut(|data| data.remove_temp::<(String, u64)>(id));
    let before = kept.filter(|(_, seen)| seen + 1 >= frame).map(|(before, _)| before);
    if response.has_focus() {
        let before = before.unwrap_or_else(|| text.clone());
        ui.data_mut(|data| data.insert_temp(id, (before, frame)));
        return response.changed();
    }
    match before.filter(|before| before != text && !rows::leaves_with_text(ui)) {
        Some(before) => {
            *text = before;
            true
        }
        None => response.changed(),
    }
}

/// Shows a field for a value that has a form as text. A text of that form takes effect while it is
/// typed; any other waits in the field with the reason below it, and is given up when the keyboard
/// leaves. Escape brings back the text of before. Returns the new value with the id of the widget.
pub(crate) fn formed<T: PartialEq>(
    ui: &mut Ui,
    label: Id,
    current: &T,
    text_of: impl Fn(&T) -> String,
    read: impl Fn(&str) -> Result<T, String>,
) -> Option<(Id, T)> {
    let id = label.with("text");
    let has_focus = ui.memory(|memory| memory.has_focus(id));
    let typed = ui.data(|data| data.get_temp::<String>(id)).filter(|_| has_focus);
    // Undo may have taken the value back while the keyboard is here.
    let is_now = |typed: &String| read(typed).map_or(true, |value| value == *current);
    let mut text = typed.filter(is_now).unwrap_or_else(|| text_of(current));
    let is_formed = read(&text).is_ok();
    let colors = theme::of(ui);
    let ink = if is_formed { colors.text } else { colors.error };
    ui.vertical(|ui| {
        let edit = TextEdit::singleline(&mut text).id(id).hint_text(tr!("none")).text_color(ink);
        let response = ui.add(edit.desired_width(f32::INFINITY)).labelled_by(label);
        let is_changed = is_typed(ui, &response, &mut text);
        if response.lost_focus() {
            ui.data_mut(|data| data.remove::<String>(id));
        } else if is_changed {
            ui.data_mut(|data| data.insert_temp(id, text.clone()));
        }
        match read(&text) {
            Ok(value) => is_changed.then_some((id, value)),
            Err(why) => {
                ui.label(RichText::new(why).small().color(theme::of(ui).error));
                None
            }
        }
    })
    .inner
}

/// Paints text in a column of a row, cut where it is too long.
pub(crate) fn cell(
    ui: &Ui,
    rect: egui::Rect,
    text: &str,
    font: egui::FontId,
    color: egui::Color32,
) {
    let mut job = egui::text::LayoutJob::single_section(
        text.to_owned(),
        egui::text::TextFormat { font_id: font, color, ..egui::text::TextFormat::default() },
    );
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width().max(0.0));
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let at = egui::pos2(rect.left(), rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, color);
}

#[cfg(test)]
mod tests {
    use eframe::egui::{Context, Event, Key, Modifiers, RawInput};

    use super::*;
    use crate::commands::keyboard;

    /// A field whose text takes effect while it is typed, with the keyboard.
    struct Desk {
        ctx: Context,
        text: String,
    }

    impl Desk {
        fn frame(&mut self, events: Vec<Event>) {
            let input = RawInput { events, ..RawInput::default() };
            let output = self.ctx.clone().run_ui(input, |ui| {
                keyboard::begin_frame(ui.ctx());
                // Others take Escape before the field is shown, as the canvas does.
                keyboard::take(ui, (Modifiers::NONE, Key::Escape));
                let mut text = self.text.clone();
                let id = Id::unique("field");
                let response = ui.add(TextEdit::singleline(&mut text).id(id));
                if is_typed(ui, &response, &mut text) {
                    self.text = text;
                }
            });
            output.drop_without_applying_deltas();
        }

        fn enter(&mut self, text: &str) {
            self.frame(Vec::new());
            self.ctx.memory_mut(|memory| memory.request_focus(Id::unique("field")));
            self.frame(Vec::new());
            self.frame(vec![Event::Text(text.to_owned())]);
        }

        fn key(&mut self, key: Key) {
            let (physical_key, modifiers) = (None, Modifiers::NONE);
            let event =
                |pressed| Event::Key { key, physical_key, pressed, repeat: false, modifiers };
            self.frame(vec![event(true), event(false)]);
            self.frame(Vec::new());
        }
    }

    #[test]
    fn escape_brings_back_the_text_of_before_and_other_keys_leave_what_was_typed() {
        let mut desk = Desk { ctx: Context::default(), text: "rim".to_owned() };
        for (key, typed, left) in [
            (Key::Escape, "rim1", "rim"),
            (Key::Enter, "rim1", "rim1"),
            (Key::Tab, "rim12", "rim12"),
        ] {
            desk.enter(&typed[desk.text.len()..]);
            assert_eq!(desk.text, typed, "it takes effect while it is typed");
            desk.key(key);
            assert_eq!(desk.text, left, "{key:?}");
        }
    }
}
