//! Keyboard of the table, while the cursor's cell has the focus: moves, edits, the clipboard, keys.

use chiaro_locale::{tr, trn};
use eframe::egui::{Event, EventFilter, Key, Modifiers, Ui};

use super::change::{CellChanges, Entry};
use super::column::Column;
use super::grid::{CellGrid, id_of};
use super::selection::{Place, ShownCells};
use super::sheet::{CellValue, Row, Sheet};
use crate::commands::Command;
use crate::document::{Edit, Target};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::state::keying::KeyedBy;
use crate::widgets::rows::undo_keys;

impl CellGrid {
    /// Takes the keys of the cursor's cell.
    pub(super) fn keys(
        &mut self,
        ui: &Ui,
        sheet: Sheet<'_>,
        shown: ShownCells<'_>,
        out: &mut Vec<Command>,
    ) {
        let Some(place) = self.selection.cursor().cloned() else { return };
        let id = id_of(&place);
        if self.editing.is_some() || !ui.memory(|memory| memory.has_focus(id)) {
            return;
        }
        let arrows =
            EventFilter { horizontal_arrows: true, vertical_arrows: true, ..<_>::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
        undo_keys(ui, out);
        let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
        for (key, sign) in [(Key::ArrowUp, "+="), (Key::ArrowDown, "-=")] {
            // Nudges of one stay at the cells are one step.
            if let Some(step) = place.1.nudge()
                && pressed(Modifiers::ALT, key)
            {
                let entry = Entry::Text(format!("{sign}{step}"));
                self.enter(sheet, shown, &entry, Some(id), out);
            }
        }
        for (key, by) in [
            (Key::ArrowUp, [-1, 0]),
            (Key::ArrowDown, [1, 0]),
            (Key::ArrowLeft, [0, -1]),
            (Key::ArrowRight, [0, 1]),
            (Key::PageUp, [-10, 0]),
            (Key::PageDown, [10, 0]),
            (Key::Home, [0, -1000]),
            (Key::End, [0, 1000]),
        ] {
            for (modifiers, extends) in [(Modifiers::SHIFT, true), (Modifiers::NONE, false)] {
                if pressed(modifiers, key) {
                    self.selection.step(shown, by, extends);
                    self.follows = true;
                }
            }
        }
        if pressed(Modifiers::COMMAND, Key::A) {
            self.selection.select_more(shown);
        }
        let value = sheet.cell(&place.0, place.1).value;
        if let Some(CellValue::Switch(is_on)) = value {
            if pressed(Modifiers::NONE, Key::Space) || pressed(Modifiers::NONE, Key::Enter) {
                self.enter(sheet, shown, &Entry::Switch(!is_on), None, out);
            }
        } else if pressed(Modifiers::NONE, Key::Enter) || pressed(Modifiers::NONE, Key::F2) {
            self.begin(ui, sheet, &place, None);
        }
        if pressed(Modifiers::NONE, Key::Delete) || pressed(Modifiers::NONE, Key::Backspace) {
            self.enter(sheet, shown, &Entry::Reset, None, out);
        }
        self.clipboard(ui, sheet, shown, out);
        self.typing(ui, sheet, &place, out);
    }

    fn clipboard(
        &mut self,
        ui: &Ui,
        sheet: Sheet<'_>,
        shown: ShownCells<'_>,
        out: &mut Vec<Command>,
    ) {
        let is_it = |event: &Event| matches!(event, Event::Copy | Event::Cut | Event::Paste(_));
        let events: Vec<Event> = ui.input_mut(|input| {
            let (taken, left) = std::mem::take(&mut input.events).into_iter().partition(is_it);
            input.events = left;
            taken
        });
        for event in events {
            match event {
                Event::Paste(text) => self.paste(sheet, shown, &text, out),
                _ => out.push(Command::Copy(self.copied(sheet, shown))),
            }
        }
    }

    /// Begins an edit with what is typed, of a quick hand several letters; K keys the cells.
    fn typing(&mut self, ui: &Ui, sheet: Sheet<'_>, place: &Place, out: &mut Vec<Command>) {
        let typed: String = ui.input(|input| {
            let texts = input.events.iter().filter_map(|event| match event {
                Event::Text(text) => Some(text.as_str()),
                _ => None,
            });
            texts.collect()
        });
        if typed.trim().is_empty() {
            return;
        }
        let keys_value = place.1.field().is_some() && typed.eq_ignore_ascii_case("k");
        ui.input_mut(|input| input.events.retain(|event| !matches!(event, Event::Text(_))));
        if keys_value {
            out.extend(self.keying(sheet));
        } else if !place.1.is_switch() {
            self.begin(ui, sheet, place, Some(typed));
        }
    }

    fn paste(&self, sheet: Sheet<'_>, shown: ShownCells<'_>, text: &str, out: &mut Vec<Command>) {
        let lines: Vec<Vec<&str>> = text
            .trim_end_matches(['\n', '\r'])
            .lines()
            .map(|line| line.split('\t').collect())
            .collect();
        let width = lines.iter().map(Vec::len).max().unwrap_or_default();
        let mut changes = CellChanges::new(sheet);
        for ((row, column), [y, x]) in self.selection.covered(shown, [lines.len(), width]) {
            if let Some(text) = lines[y].get(x) {
                changes.set(&row, column, &Entry::Text((*text).to_owned()));
            }
        }
        out.extend(changes.commands(None));
    }

    /// Selected cells as a text: a line a row, with tabs between columns.
    pub(super) fn copied(&self, sheet: Sheet<'_>, shown: ShownCells<'_>) -> String {
        let text = |place: Option<Place>| {
            let value = place.and_then(|(row, column)| sheet.cell(&row, column).value);
            value.map(|value| value.text(sheet.session)).unwrap_or_default()
        };
        let line = |line: Vec<Option<Place>>| line.into_iter().map(text).collect::<Vec<_>>();
        let lines = self.selection.lines(shown).into_iter();
        lines.map(|cells| line(cells).join("\t")).collect::<Vec<_>>().join("\n")
    }

    /// Targets of the selected cells that keys can move, with those keys.
    pub(super) fn targets<'s>(&self, sheet: Sheet<'s>) -> Vec<(OwnedKeys<'s>, Target)> {
        let rows = sheet.rows(None, None);
        let mut found = Vec::new();
        for row in &rows {
            let Row::Light(id) = row else { continue };
            for column in Column::all().filter(|column| self.selection.has(&(row.clone(), *column)))
            {
                let Some(field) = column.field() else { continue };
                let is_there = sheet.cell(row, column).value.is_some();
                found.extend(sheet.target(id, field).filter(|_| is_there));
            }
        }
        found
    }

    /// Command that keys the selected cells at the playhead, as one step.
    pub(super) fn keying(&self, sheet: Sheet<'_>) -> Vec<Command> {
        let mut targets = self.targets(sheet);
        targets.retain(|(owned, target)| {
            !matches!(owned.keys.keyed_by(target), KeyedBy::Direction(_))
        });
        let (mut count, mut out) = (0, Vec::new());
        for owner in [Owner::Look, Owner::Scene] {
            let of_owner = targets.iter().filter(|(owned, _)| owned.owner == owner);
            let edits: Vec<Edit> =
                of_owner.filter_map(|(owned, target)| owned.keys.key_in_time(target)).collect();
            count += edits.len();
            let owned = OwnedKeys::of(sheet.session, owner).filter(|_| !edits.is_empty());
            out.extend(owned.and_then(|owned| owned.once(Edit::Group { edits })));
        }
        if count == 0 {
            let text = tr!(
                "None of these cells can be keyed in time: keys move lights of the scene, and of \
                 the look that is open"
            );
            return vec![Command::Tell(text.to_owned())];
        }
        out.push(Command::Tell(trn!(
            count,
            "{count} value is keyed at the playhead",
            "{count} values are keyed at the playhead"
        )));
        out
    }
}
