//! Whose the keys of a frame are: those of the window, of a text field or of a dialog.

use eframe::egui;
use eframe::egui::{Key, Modifiers};

/// Whose the keys of a frame are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum KeyboardOwner {
    /// The window's, and whatever lies under the pointer.
    #[default]
    Window,
    /// A text field's; keys of [`Place::Window`](super::table::Place::Window) still work.
    Field,
    /// A dialog's, all of them.
    Dialog,
}

fn owner_id() -> egui::Id {
    egui::Id::unique("owner of the keyboard")
}

/// Remembers whose the keys of this frame are; to be called before anything of it is shown. A field
/// or a dialog that one of these keys closes would leave the others, typed as fast, to whatever
/// lies below.
pub(crate) fn begin_frame(ctx: &egui::Context) {
    let owner = if ctx.memory(|memory| memory.top_modal_layer().is_some()) {
        KeyboardOwner::Dialog
    } else if ctx.egui_wants_keyboard_input() {
        KeyboardOwner::Field
    } else {
        KeyboardOwner::Window
    };
    ctx.data_mut(|data| data.insert_temp(owner_id(), owner));
}

fn owner(ctx: &egui::Context) -> KeyboardOwner {
    ctx.data(|data| data.get_temp(owner_id())).unwrap_or_default()
}

/// Whether the keys are those of a text field or a dialog, now or when the frame began.
pub(crate) fn is_keyboard_taken(ctx: &egui::Context) -> bool {
    owner(ctx) != KeyboardOwner::Window || ctx.egui_wants_keyboard_input()
}

/// Whether all keys are those of a dialog.
pub(crate) fn is_dialog_open(ctx: &egui::Context) -> bool {
    owner(ctx) == KeyboardOwner::Dialog
}

/// Takes a key with just these modifiers, which egui's own way would not ask for: to it Shift+D is
/// D too.
pub(crate) fn take(ui: &egui::Ui, (wanted, wanted_key): (Modifiers, Key)) -> bool {
    ui.input_mut(|input| {
        let count = input.events.len();
        input.events.retain(|event| match event {
            egui::Event::Key { key, modifiers, pressed: true, .. } => {
                *key != wanted_key || !modifiers.matches_exact(wanted)
            }
            _ => true,
        });
        input.events.len() < count
    })
}
