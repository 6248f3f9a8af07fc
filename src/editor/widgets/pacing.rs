//! Pace of input: what was typed while a frame was drawn is handed to the next frames as if it had
//! been typed slowly.
//!
//! egui finds out which field has the keyboard once a frame. Where a text, Tab and the text of the
//! next field arrive together, the first field would get none of them. So a frame gets events only
//! up to the one that moves the keyboard: Tab is alone in its frame, and presses of the pointer and
//! typing are in frames of their own. The rest waits, in order.

use std::collections::VecDeque;

use eframe::egui::{Context, Event, Key, Modifiers, Plugin, RawInput, Ui};

/// Kind of an event, by what it does to the keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EventKind {
    /// Goes to the widget that has the keyboard.
    Typed,
    /// Moves the keyboard to the next widget or the one before.
    Tab,
    /// May move the keyboard to the widget under the pointer.
    Pointer,
}

impl EventKind {
    /// Kind of an event; none of one that the keyboard does not care for.
    fn of(event: &Event) -> Option<Self> {
        match event {
            Event::Key { key: Key::Tab, pressed: true, modifiers, .. }
                if *modifiers == Modifiers::NONE || modifiers.shift_only() =>
            {
                Some(Self::Tab)
            }
            Event::Key { pressed: true, .. }
            | Event::Text(_)
            | Event::Paste(_)
            | Event::Copy
            | Event::Cut
            | Event::Ime(_) => Some(Self::Typed),
            Event::PointerButton { .. } => Some(Self::Pointer),
            _ => None,
        }
    }

    /// True if one frame can have an event of this kind and then one of the other.
    fn goes_with(self, next: Self) -> bool {
        self == next && next != Self::Tab
    }
}

/// Events that wait for their frame.
#[derive(Debug, Default)]
pub(crate) struct EventPacer {
    waiting: VecDeque<Event>,
    /// Frame that got events last: a frame that is laid out twice gets no more of them.
    last: Option<u64>,
}

impl EventPacer {
    /// Adds events to those that wait, and takes the next frame's out.
    fn next_events(&mut self, new: Vec<Event>) -> Vec<Event> {
        self.waiting.extend(new);
        let mut last = None;
        let is_end = |event: &Event| {
            let Some(kind) = EventKind::of(event) else {
                return false;
            };
            last.replace(kind).is_some_and(|before: EventKind| !before.goes_with(kind))
        };
        let end = self.waiting.iter().position(is_end).unwrap_or(self.waiting.len());
        self.waiting.drain(..end).collect()
    }
}

impl Plugin for EventPacer {
    fn debug_name(&self) -> &'static str {
        "pace of input"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        let frame = ctx.cumulative_frame_nr();
        if self.last.replace(frame) == Some(frame) {
            self.waiting.extend(std::mem::take(&mut input.events));
        } else {
            input.events = self.next_events(std::mem::take(&mut input.events));
        }
    }

    fn on_begin_pass(&mut self, ui: &mut Ui) {
        if !self.waiting.is_empty() {
            ui.ctx().request_repaint();
        }
    }
}

#[cfg(test)]
mod tests {
    use eframe::egui::{PointerButton, Pos2};

    use super::*;

    fn text(text: &str) -> Event {
        Event::Text(text.to_owned())
    }

    fn key(key: Key, pressed: bool) -> Event {
        let (physical_key, modifiers) = (None, Modifiers::NONE);
        Event::Key { key, physical_key, pressed, repeat: false, modifiers }
    }

    fn button(pressed: bool) -> Event {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        Event::PointerButton { pos: Pos2::ZERO, button, pressed, modifiers }
    }

    /// Events of each frame, where all arrive at once.
    fn paced(events: &[Event]) -> Vec<Vec<Event>> {
        let mut pacer = EventPacer::default();
        let mut frames = vec![pacer.next_events(events.to_vec())];
        while !pacer.waiting.is_empty() {
            frames.push(pacer.next_events(Vec::new()));
        }
        frames
    }

    #[test]
    fn tab_has_a_frame_of_its_own_and_typing_and_presses_have_theirs() {
        let (tab, up) = (key(Key::Tab, true), key(Key::Tab, false));
        let all = [text("6"), text("40"), tab.clone(), up.clone(), text("360")];
        let frames = [vec![text("6"), text("40")], vec![tab.clone(), up], vec![text("360")]];
        assert_eq!(paced(&all), frames);
        assert_eq!(paced(&[tab.clone(), tab.clone()]), [[tab.clone()], [tab]]);
        let (down, up) = (button(true), button(false));
        let all = [text("1"), down.clone(), up.clone(), text("2"), key(Key::Enter, true)];
        let frames = [vec![text("1")], vec![down, up], vec![text("2"), key(Key::Enter, true)]];
        assert_eq!(paced(&all), frames);
    }

    #[test]
    fn what_moves_no_keyboard_is_not_held_up() {
        let moved = Event::PointerMoved(Pos2::ZERO);
        let clicks = [button(true), moved.clone(), button(false), button(true), button(false)];
        assert_eq!(paced(&clicks), [clicks.to_vec()]);
        let keys = [key(Key::A, true), key(Key::A, false), moved, text("a"), key(Key::Enter, true)];
        assert_eq!(paced(&keys), [keys.to_vec()]);
    }
}
