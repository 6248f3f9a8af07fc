//! Enter in a dialog, which acts as its first button; Escape leaves the dialog, as every modal of
//! egui does.

use eframe::egui::{Key, Modifiers, Ui};

/// True if Enter confirms the dialog that begins here. A field or a button that has the focus keeps
/// its Enter: ask before the dialog's own widgets are shown, which give the focus up when they take
/// the key.
pub(crate) fn enters(ui: &Ui) -> bool {
    let is_free = ui.memory(|memory| memory.focused().is_none());
    is_free && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter))
}
