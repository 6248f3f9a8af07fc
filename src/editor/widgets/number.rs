//! Fields for numbers, all of the window's. A field shows fewer digits than its number has: what
//! it shows is written back only where something else was typed, and only when the field is left
//! by Enter, by Tab or by a press elsewhere. Escape gives up what was typed.

use std::cell::RefCell;
use std::ops::RangeInclusive;
use std::rc::Rc;

use eframe::egui::emath::{Numeric, format_with_decimals_in_range};
use eframe::egui::{DragValue, Slider, SliderClamping, Ui};

use super::rows;

/// Text of a number, within a range of decimals.
type NumberWriter<'a> = Box<dyn Fn(f64, RangeInclusive<usize>) -> String + 'a>;

/// Number that a text says.
type NumberReader<'a> = Box<dyn Fn(&str) -> Option<f64> + 'a>;

/// Field for a number: dragged, or clicked and typed.
pub(crate) fn number_field<'a, N: Numeric>(ui: &Ui, number: &'a mut N) -> DragValue<'a> {
    number_field_as(ui, number, format_with_decimals_in_range, read)
}

/// Field for a number with a form of its own as text. `write` takes the range of decimals too.
pub(crate) fn number_field_as<'a, N: Numeric>(
    ui: &Ui,
    number: &'a mut N,
    write: impl Fn(f64, RangeInclusive<usize>) -> String + 'a,
    read: impl Fn(&str) -> Option<f64> + 'a,
) -> DragValue<'a> {
    let (write, read) = form(ui, write, read);
    #[expect(clippy::disallowed_methods, reason = "this is the field that all others are")]
    let field = DragValue::new(number);
    field.custom_formatter(write).custom_parser(read).update_while_editing(false)
}

/// Slider with a field for its number. A slider that nobody touches leaves its number as it is,
/// outside the range and with all its digits.
pub(crate) fn number_slider<'a, N: Numeric>(
    ui: &Ui,
    number: &'a mut N,
    range: RangeInclusive<N>,
) -> Slider<'a> {
    let (write, read) = form(ui, format_with_decimals_in_range, read);
    #[expect(clippy::disallowed_methods, reason = "this is the slider that all others are")]
    let slider = Slider::new(number, range).clamping(SliderClamping::Edits);
    slider.custom_formatter(write).custom_parser(read).update_while_editing(false)
}

/// Both directions between a number and its text. A text that says no more than the one that the
/// field showed, or that is given up, is read as no number.
fn form<'a>(
    ui: &Ui,
    write: impl Fn(f64, RangeInclusive<usize>) -> String + 'a,
    read: impl Fn(&str) -> Option<f64> + 'a,
) -> (NumberWriter<'a>, NumberReader<'a>) {
    let shown = Rc::new(RefCell::new(String::new()));
    let is_given_up = !rows::leaves_with_text(ui);
    let written = Rc::clone(&shown);
    let write = move |number, decimals| {
        let text = write(number, decimals);
        written.borrow_mut().clone_from(&text);
        text
    };
    let read = move |text: &str| {
        let number = read(text).filter(|_| !is_given_up)?;
        (read(&shown.borrow()) != Some(number)).then_some(number)
    };
    (Box::new(write), Box::new(read))
}

/// Finite number that a text says, with spaces anywhere and a minus of either kind.
pub(crate) fn read(text: &str) -> Option<f64> {
    let text: String = text.chars().filter(|letter| !letter.is_whitespace()).collect();
    text.replace('\u{2212}', "-").parse().ok().filter(|number: &f64| number.is_finite())
}
#[cfg(test)]
mod tests {
    use eframe::egui::{
        Context, Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2,
    };

    use super::*;
    use crate::commands::keyboard;

    /// A window with one field, 2 digits of which are shown.
    struct Desk {
        ctx: Context,
        number: f64,
        is_slider: bool,
        /// True if others take Escape before the field is shown, as the canvas does.
        loses_escape: bool,
        field: Rect,
        changes: usize,
    }

    const FINE: f64 = 0.123_456;
    /// A field and a slider, each where Escape is taken by others, and where not.
    const KINDS: [[bool; 2]; 4] = [[false, false], [false, true], [true, false], [true, true]];

    impl Desk {
        fn new([is_slider, loses_escape]: [bool; 2]) -> Self {
            let (ctx, number, field, changes) = (Context::default(), FINE, Rect::ZERO, 0);
            let mut desk = Self { ctx, number, is_slider, loses_escape, field, changes };
            desk.frame(Vec::new());
            desk.frame(Vec::new());
            desk
        }

        fn frame(&mut self, events: Vec<Event>) {
            let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(400.0, 200.0)));
            let input = RawInput { events, screen_rect, ..RawInput::default() };
            let output = self.ctx.clone().run_ui(input, |ui| {
                keyboard::begin_frame(ui.ctx());
                if self.loses_escape {
                    keyboard::take(ui, (Modifiers::NONE, Key::Escape));
                }
                let response = if self.is_slider {
                    ui.add(number_slider(ui, &mut self.number, 0.0..=1.0).max_decimals(2))
                } else {
                    ui.add(number_field(ui, &mut self.number).speed(0.01).max_decimals(2))
                };
                self.changes += usize::from(response.changed());
                self.field = response.rect;
            });
            output.drop_without_applying_deltas();
        }

        fn click(&mut self, pos: Pos2) {
            self.frame(vec![Event::PointerMoved(pos)]);
            for pressed in [true, false] {
                let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
                self.frame(vec![Event::PointerButton { pos, button, pressed, modifiers }]);
            }
            self.frame(Vec::new());
        }

        fn enter(&mut self, text: &str) {
            self.click(self.field.right_center() - vec2(8.0, 0.0));
            assert!(self.ctx.text_edit_focused(), "the field is typed in");
            if !text.is_empty() {
                self.frame(vec![Event::Text(text.to_owned())]);
                self.frame(Vec::new());
            }
        }

        /// Presses and releases a key at once, as a slow window gets both.
        fn key(&mut self, key: Key) {
            let event = |pressed| Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            };
            self.frame(vec![event(true), event(false)]);
            self.frame(Vec::new());
        }

        fn leave(&mut self) {
            self.click(pos2(390.0, 190.0));
            assert!(!self.ctx.text_edit_focused(), "the field is left");
        }
    }

    #[test]
    fn a_field_that_is_left_as_it_was_changes_nothing() {
        for kind in KINDS {
            // Nothing typed, and the text that the field showed.
            for text in ["", "0.12", " 0.120 ", "no number", "nan"] {
                let mut desk = Desk::new(kind);
                desk.enter(text);
                desk.leave();
                desk.enter(text);
                desk.key(Key::Enter);
                desk.enter(text);
                desk.key(Key::Escape);
                assert_eq!((desk.number, desk.changes), (FINE, 0), "{text:?}, {kind:?}");
            }
        }
    }

    #[test]
    fn a_typed_number_is_taken_when_the_field_is_left_and_given_up_by_escape() {
        for kind in KINDS {
            let mut desk = Desk::new(kind);
            desk.enter("0.5");
            assert_eq!((desk.number, desk.changes), (FINE, 0), "it is still being typed");
            desk.key(Key::Escape);
            assert_eq!((desk.number, desk.changes), (FINE, 0), "{kind:?}");
            desk.enter("0.5");
            desk.key(Key::Enter);
            assert_eq!((desk.number, desk.changes), (0.5, 1), "{kind:?}");
            desk.enter("0.75");
            desk.leave();
            assert_eq!((desk.number, desk.changes), (0.75, 2), "{kind:?}");
            desk.enter("\u{2212}3");
            desk.key(Key::Tab);
            let wanted = if desk.is_slider { 0.0 } else { -3.0 };
            assert_eq!((desk.number, desk.changes), (wanted, 3), "{kind:?}");
        }
    }

    #[test]
    fn a_slider_that_nobody_touches_leaves_a_number_outside_its_range() {
        let mut desk = Desk::new([true, false]);
        desk.number = 7.654_321;
        desk.frame(Vec::new());
        assert_eq!((desk.number, desk.changes), (7.654_321, 0));
    }
}
