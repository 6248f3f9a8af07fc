//! Fields for numbers, all of the window's. A field shows fewer digits than its number has: what
//! it shows is written back only where something else was typed, and only when the field is left
//! by Enter, by Tab or by a press elsewhere. Escape gives up what was typed.
//!
//! A text that is no number stays in the field after Enter and Tab, with the reason; after a press
//! elsewhere the number of before is back, and the window's status has the reason, as where a
//! number was beyond the field's range.

use std::cell::{Cell, RefCell};
use std::ops::RangeInclusive;
use std::rc::Rc;

use chiaro_locale::tr;
use eframe::egui::emath::{Numeric, format_with_decimals_in_range};
use eframe::egui::response::Flags;
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{
    Context, DragValue, Id, Key, PointerButton, Response, Slider, SliderClamping, TextEdit, Ui,
    Widget,
};

pub(crate) use super::number_text::read;
use super::{rows, theme};

/// Number behind a field: read with `None`, and written.
type NumberAccess<'a> = Box<dyn FnMut(Option<f64>) -> f64 + 'a>;

/// Number that a text says.
type NumberReader<'a> = Box<dyn Fn(&str) -> Option<f64> + 'a>;

/// Field for a number: dragged, or clicked and typed.
pub(crate) fn number_field<'a, N: Numeric>(ui: &Ui, number: &'a mut N) -> NumberField<'a> {
    number_field_as(ui, number, format_with_decimals_in_range, read)
}

/// Field for a number with a form of its own as text. `write` takes the range of decimals too.
pub(crate) fn number_field_as<'a, N: Numeric>(
    ui: &Ui,
    number: &'a mut N,
    write: impl Fn(f64, RangeInclusive<usize>) -> String + 'a,
    read: impl Fn(&str) -> Option<f64> + 'a,
) -> NumberField<'a> {
    let typing = NumberInput::new(ui, number, read);
    let own = Rc::clone(&typing);
    #[expect(clippy::disallowed_methods, reason = "this is the field that all others are")]
    let field = DragValue::from_get_set(move |number| own.number(number));
    let field = match N::INTEGRAL {
        true => field.max_decimals(0).range(N::MIN..=N::MAX).speed(0.25),
        false => field,
    };
    let [written, parsed] = [(); 2].map(|()| Rc::clone(&typing));
    let field = field
        .custom_formatter(move |number, decimals| written.show(write(number, decimals)))
        .custom_parser(move |text| parsed.take(text))
        .update_while_editing(false);
    NumberField { field, typing }
}

/// Slider with a field for its number. A slider that nobody touches leaves its number as it is,
/// outside the range and with all its digits.
pub(crate) fn number_slider<'a, N: Numeric>(
    ui: &Ui,
    number: &'a mut N,
    range: RangeInclusive<N>,
) -> NumberSlider<'a> {
    let typing = NumberInput::new(ui, number, read);
    let range = range.start().to_f64()..=range.end().to_f64();
    typing.range.set(Some([*range.start(), *range.end()]));
    let own = Rc::clone(&typing);
    #[expect(clippy::disallowed_methods, reason = "this is the slider that all others are")]
    let slider = Slider::from_get_set(range, move |number| own.number(number));
    let slider = if N::INTEGRAL { slider.integer() } else { slider };
    let slider = slider.clamping(SliderClamping::Edits);
    let [written, parsed] = [(); 2].map(|()| Rc::clone(&typing));
    let slider = slider
        .custom_formatter(move |number, decimals| {
            written.show(format_with_decimals_in_range(number, decimals))
        })
        .custom_parser(move |text| parsed.take(text))
        .update_while_editing(false);
    NumberSlider { slider, typing }
}

/// Field for a number, with its options.
pub(crate) struct NumberField<'a> {
    field: DragValue<'a>,
    typing: Rc<NumberInput<'a>>,
}

impl NumberField<'_> {
    /// Sets the least and the greatest number.
    pub(crate) fn range<N: Numeric>(mut self, range: RangeInclusive<N>) -> Self {
        self.typing.range.set(Some([range.start().to_f64(), range.end().to_f64()]));
        self.field = self.field.range(range);
        self
    }

    /// Keeps a number outside of the range until it is edited, where `clamps` is false.
    pub(crate) fn clamp_existing_to_range(mut self, clamps: bool) -> Self {
        self.field = self.field.clamp_existing_to_range(clamps);
        self
    }

    /// Sets the change of the number by a drag over a point.
    pub(crate) fn speed(mut self, speed: impl Into<f64>) -> Self {
        self.field = self.field.speed(speed);
        self
    }

    /// Sets the most decimals that are shown.
    pub(crate) fn max_decimals(mut self, decimals: usize) -> Self {
        self.field = self.field.max_decimals(decimals);
        self
    }

    /// Sets the text before the number.
    pub(crate) fn prefix(mut self, prefix: impl Into<String>) -> Self {
        self.field = self.field.prefix(prefix.into());
        self
    }

    /// Sets the unit after the number, which can be typed, too.
    pub(crate) fn suffix(mut self, unit: impl Into<String>) -> Self {
        let unit = unit.into();
        self.typing.unit.replace(unit.clone());
        self.field = self.field.suffix(unit);
        self
    }
}

impl Widget for NumberField<'_> {
    fn ui(self, ui: &mut Ui) -> Response {
        let id = ui.next_auto_id();
        if let Some(response) = self.typing.reopened(ui, id) {
            return response;
        }
        let response = ui.add(self.field);
        self.typing.tell(ui, id);
        response
    }
}

/// Slider for a number, with its options.
pub(crate) struct NumberSlider<'a> {
    slider: Slider<'a>,
    typing: Rc<NumberInput<'a>>,
}

impl<'a> NumberSlider<'a> {
    fn with(mut self, set: impl FnOnce(Slider<'a>) -> Slider<'a>) -> Self {
        self.slider = set(self.slider);
        self
    }

    /// Takes whole numbers only.
    pub(crate) fn integer(self) -> Self {
        self.with(Slider::integer)
    }

    /// Moves in steps of the number's magnitude.
    pub(crate) fn logarithmic(self, is_logarithmic: bool) -> Self {
        self.with(|slider| slider.logarithmic(is_logarithmic))
    }

    /// Sets the most decimals that are shown.
    pub(crate) fn max_decimals(self, decimals: usize) -> Self {
        self.with(|slider| slider.max_decimals(decimals))
    }

    /// Shows the field of the number, or the slider alone.
    pub(crate) fn show_value(self, is_shown: bool) -> Self {
        self.with(|slider| slider.show_value(is_shown))
    }

    /// Sets the distance of two numbers that the slider stops at.
    pub(crate) fn step_by(self, step: f64) -> Self {
        self.with(|slider| slider.step_by(step))
    }

    /// Sets the text after the field.
    pub(crate) fn text(self, text: impl Into<String>) -> Self {
        self.with(|slider| slider.text(text.into()))
    }

    /// Fills the rail up to the handle.
    pub(crate) fn trailing_fill(self, is_filled: bool) -> Self {
        self.with(|slider| slider.trailing_fill(is_filled))
    }

    /// Stands the slider up.
    pub(crate) fn vertical(self) -> Self {
        self.with(Slider::vertical)
    }

    /// Takes typed numbers outside of the range of the slider.
    pub(crate) fn unbounded(self) -> Self {
        self.typing.range.set(None);
        self.with(|slider| slider.clamping(SliderClamping::Never))
    }

    /// Sets the unit after the number, which can be typed, too.
    pub(crate) fn suffix(self, unit: impl Into<String>) -> Self {
        let unit = unit.into();
        self.typing.unit.replace(unit.clone());
        self.with(|slider| slider.suffix(unit))
    }
}

impl Widget for NumberSlider<'_> {
    fn ui(self, ui: &mut Ui) -> Response {
        let id = ui.next_auto_id();
        if RefusedText::of(ui, id).is_none() {
            let response = ui.add(self.slider);
            self.typing.tell(ui, id);
            return response;
        }
        let shown = ui.horizontal(|ui| {
            let slider = ui.add(self.slider.show_value(false));
            let field = self.typing.reopened(ui, id);
            field.map_or_else(|| slider.clone(), |field| field.union(slider.clone()))
        });
        shown.inner
    }
}

/// A text that is no number and stays in its field.
#[derive(Clone, Debug)]
struct RefusedText {
    text: String,
    /// Number of the field, which another number makes outdated.
    number: f64,
    /// Frame in which the field was shown last.
    frame: u64,
    /// True if the field is to get the keyboard.
    wants_keyboard: bool,
}

impl RefusedText {
    /// The text that stays in the field of an id, which was shown in the frame before.
    fn of(ui: &Ui, id: Id) -> Option<Self> {
        let frame = ui.ctx().cumulative_frame_nr();
        let kept = ui.data(|data| data.get_temp::<Self>(id.with("refused")))?;
        Some(kept).filter(|kept| kept.frame + 1 >= frame)
    }
}

/// Verdict on a typed text, where there is something to tell.
#[derive(Debug)]
enum InputVerdict {
    /// The text is no number.
    Refused(String),
    /// The number was beyond the range, whose end is told of.
    Limited(String),
}

/// Both directions between a number and its text. A text that says no more than the one that the
/// field showed, or that is given up, is read as no number.
struct NumberInput<'a> {
    number: RefCell<NumberAccess<'a>>,
    read: NumberReader<'a>,
    shown: RefCell<String>,
    unit: RefCell<String>,
    range: Cell<Option<[f64; 2]>>,
    outcome: RefCell<Option<InputVerdict>>,
    is_given_up: bool,
}

impl<'a> NumberInput<'a> {
    fn new<N: Numeric>(
        ui: &Ui,
        number: &'a mut N,
        read: impl Fn(&str) -> Option<f64> + 'a,
    ) -> Rc<Self> {
        // A right click opens the menu of a value; egui's slider would take its place for a drag.
        let is_of_menu = ui.input(|input| {
            let (right, left) = (PointerButton::Secondary, PointerButton::Primary);
            (input.pointer.button_down(right) || input.pointer.button_released(right))
                && !input.pointer.button_down(left)
        });
        let access = move |new: Option<f64>| {
            if let Some(new) = new.filter(|_| !is_of_menu) {
                *number = N::from_f64(new);
            }
            number.to_f64()
        };
        Rc::new(Self {
            number: RefCell::new(Box::new(access)),
            read: Box::new(read),
            shown: RefCell::default(),
            unit: RefCell::default(),
            range: Cell::default(),
            outcome: RefCell::default(),
            is_given_up: !rows::leaves_with_text(ui),
        })
    }

    fn number(&self, new: Option<f64>) -> f64 {
        (self.number.borrow_mut())(new)
    }

    /// Remembers the text that the field shows.
    fn show(&self, text: String) -> String {
        self.shown.borrow_mut().clone_from(&text);
        text
    }

    /// Number that a text says, with or without the field's unit.
    fn read(&self, text: &str) -> Option<f64> {
        let unit = self.unit.borrow();
        let bare = text.trim().strip_suffix(unit.trim()).unwrap_or(text);
        (self.read)(bare)
    }

    /// Number that the field takes from its text; none where that says nothing new.
    fn take(&self, text: &str) -> Option<f64> {
        if self.is_given_up {
            return None;
        }
        let shown = self.shown.borrow();
        if text.trim() == shown.trim() {
            return None;
        }
        let Some(number) = self.read(text) else {
            self.outcome.replace(Some(InputVerdict::Refused(text.trim().to_owned())));
            return None;
        };
        if self.read(&shown) == Some(number) {
            return None;
        }
        Some(self.limited(number))
    }

    /// The number within the range. Where it was beyond, that is to be told.
    fn limited(&self, number: f64) -> f64 {
        let Some([least, most]) = self.range.get() else {
            return number;
        };
        let end =
            |end: f64| format_with_decimals_in_range(end, 0..=3) + self.unit.borrow().as_str();
        let told = if number > most {
            tr!("At most {most}", most = end(most))
        } else if number < least {
            tr!("At least {least}", least = end(least))
        } else {
            return number;
        };
        self.outcome.replace(Some(InputVerdict::Limited(told)));
        number.max(least).min(most)
    }

    /// Tells what came of the text of a field that was left. A text that is no number stays in the
    /// field where a key was to take it.
    fn tell(&self, ui: &Ui, id: Id) {
        let text = match self.outcome.take() {
            None => return,
            Some(InputVerdict::Limited(told)) => return note(ui.ctx(), told),
            Some(InputVerdict::Refused(text)) if text.is_empty() => return,
            Some(InputVerdict::Refused(text)) => text,
        };
        note(ui.ctx(), not_a_number(&text));
        let is_taken_by_key =
            ui.input(|input| input.key_pressed(Key::Enter) || input.key_pressed(Key::Tab));
        if is_taken_by_key {
            let (number, frame) = (self.number(None), ui.ctx().cumulative_frame_nr());
            let refused = RefusedText { text, number, frame, wants_keyboard: true };
            ui.data_mut(|data| data.insert_temp(id.with("refused"), refused));
            ui.ctx().request_repaint();
        }
    }

    /// Shows the field with the text that is no number, where one stays in it.
    fn reopened(&self, ui: &mut Ui, id: Id) -> Option<Response> {
        let key = id.with("refused");
        let before = self.number(None);
        let kept = RefusedText::of(ui, id).filter(|kept| kept.number == before);
        ui.data_mut(|data| data.remove::<RefusedText>(key));
        let RefusedText { mut text, wants_keyboard, .. } = kept?;
        let field = key.with("field");
        if wants_keyboard {
            ui.memory_mut(|memory| memory.request_focus(field));
            let end = CCursorRange::one(CCursor::new(text.chars().count()));
            let mut state = TextEdit::load_state(ui.ctx(), field).unwrap_or_default();
            state.cursor.set_char_range(Some(end));
            state.store(ui.ctx(), field);
        }
        let edit = TextEdit::singleline(&mut text)
            .id(field)
            .text_color(theme::of(ui).error)
            .desired_width(0.0)
            .clip_text(false)
            .min_size(ui.spacing().interact_size);
        let mut response = ui.add(edit);
        // What is typed is no change of the number yet.
        response.flags.set(Flags::CHANGED, false);
        if response.has_focus() {
            response.show_tooltip_text(not_a_number(&text));
            let frame = ui.ctx().cumulative_frame_nr();
            let refused = RefusedText { text, number: before, frame, wants_keyboard: false };
            ui.data_mut(|data| data.insert_temp(key, refused));
            return Some(response);
        }
        if let Some(number) = self.take(&text) {
            self.number(Some(number));
        }
        if self.number(None) != before {
            response.mark_changed();
        }
        self.tell(ui, id);
        Some(response)
    }
}

fn not_a_number(text: &str) -> String {
    tr!("Not a number: {text}")
}

fn note_id() -> Id {
    Id::unique("what came of a typed number")
}

fn note(ctx: &Context, told: String) {
    ctx.data_mut(|data| data.insert_temp(note_id(), told));
}

/// Takes what is to be told of a number that was typed: that a text is none, or that the number was
/// beyond the range of its field.
pub(crate) fn take_note(ctx: &Context) -> Option<String> {
    ctx.data_mut(|data| data.remove_temp(note_id()))
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
    fn a_text_that_is_no_number_stays_after_enter_and_is_given_up_by_escape() {
        for kind in KINDS {
            let mut desk = Desk::new(kind);
            desk.enter("abc");
            desk.key(Key::Enter);
            assert_eq!(take_note(&desk.ctx).as_deref(), Some("Not a number: abc"), "{kind:?}");
            assert!(desk.ctx.text_edit_focused(), "it is still typed in: {kind:?}");
            desk.key(Key::Escape);
            assert!(!desk.ctx.text_edit_focused(), "{kind:?}");
            assert_eq!((desk.number, desk.changes), (FINE, 0), "{kind:?}");
            desk.enter("1/");
            desk.key(Key::Enter);
            desk.frame(vec![Event::Text("4".to_owned())]);
            desk.key(Key::Enter);
            assert_eq!((desk.number, desk.changes), (0.25, 1), "{kind:?}");
            desk.enter("abc");
            desk.leave();
            assert_eq!((desk.number, desk.changes), (0.25, 1), "{kind:?}");
            let note = take_note(&desk.ctx);
            assert!(note.is_some_and(|note| note.ends_with("abc")), "{kind:?}");
        }
    }

    #[test]
    fn a_number_beyond_the_range_is_limited_and_that_is_told() {
        let mut desk = Desk::new([true, false]);
        for (text, number, told) in [
            ("5", 1.0, Some("At most 1")),
            ("\u{2212}0,5", 0.0, Some("At least 0")),
            ("30%", 0.3, None),
        ] {
            desk.enter(text);
            desk.key(Key::Enter);
            assert_eq!((desk.number, take_note(&desk.ctx).as_deref()), (number, told), "{text}");
        }
    }

    /// Numbers of two fields after events that arrive at once, 1920 and 1080 before. The second one
    /// is shown in percent.
    fn after_at_once(events: impl FnOnce([Rect; 2]) -> Vec<Event>) -> [f64; 2] {
        let ctx = Context::default();
        ctx.add_plugin(crate::widgets::pacing::EventPacer::default());
        let (mut numbers, mut fields) = ([1920.0, 1080.0], [Rect::ZERO; 2]);
        let mut frame = |events: Vec<Event>| {
            let screen_rect = Some(Rect::from_min_size(Pos2::ZERO, vec2(400.0, 200.0)));
            let input = RawInput { events, screen_rect, ..RawInput::default() };
            let output = ctx.run_ui(input, |ui| {
                keyboard::begin_frame(ui.ctx());
                for ((number, field), unit) in numbers.iter_mut().zip(&mut fields).zip(["", "%"]) {
                    *field = ui.add(number_field(ui, number).suffix(unit)).rect;
                }
            });
            output.drop_without_applying_deltas();
            fields
        };
        frame(Vec::new());
        let fields = frame(Vec::new());
        frame(vec![Event::PointerMoved(fields[0].center())]);
        frame(events(fields));
        for _ in 0..12 {
            frame(Vec::new());
        }
        numbers
    }

    fn press_of(key: Key, modifiers: Modifiers) -> [Event; 2] {
        let physical_key = None;
        [true, false].map(|pressed| Event::Key {
            key,
            physical_key,
            pressed,
            repeat: false,
            modifiers,
        })
    }

    fn click_at(pos: Pos2) -> [Event; 2] {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        [true, false].map(|pressed| Event::PointerButton { pos, button, pressed, modifiers })
    }

    #[test]
    fn what_is_typed_at_once_goes_into_the_field_it_was_typed_for() {
        let text = |text: &str| Event::Text(text.to_owned());
        let key = |key| press_of(key, Modifiers::NONE).to_vec();
        let numbers = after_at_once(|[first, _]| {
            let mut all = click_at(first.center()).to_vec();
            all.extend(["6", "4", "0"].map(text));
            all.extend(key(Key::Tab));
            all.extend(["3", "6", "0"].map(text));
            all.extend(key(Key::Enter));
            all
        });
        assert_eq!(numbers, [640.0, 360.0]);
        let numbers = after_at_once(|[first, _]| {
            let mut all = click_at(first.center()).to_vec();
            all.extend(press_of(Key::A, Modifiers::COMMAND));
            all.extend(["-", "2"].map(text));
            all.extend(key(Key::Tab));
            all
        });
        assert_eq!(numbers, [-2.0, 1080.0]);
        let numbers = after_at_once(|[first, second]| {
            let mut all = click_at(first.center()).to_vec();
            all.push(text("1/4"));
            all.push(Event::PointerMoved(second.center()));
            all.extend(click_at(second.center()));
            all.push(text("30 %"));
            all.extend(key(Key::Enter));
            all
        });
        assert_eq!(numbers, [0.25, 30.0]);
    }

    #[test]
    fn a_slider_that_nobody_touches_leaves_a_number_outside_its_range() {
        let mut desk = Desk::new([true, false]);
        desk.number = 7.654_321;
        desk.frame(Vec::new());
        assert_eq!((desk.number, desk.changes), (7.654_321, 0));
    }
}
