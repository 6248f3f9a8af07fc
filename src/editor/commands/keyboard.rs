//! Owner of a frame's keys: the window, a text field or a dialog. Which key does what: `table`.

use eframe::egui;
use eframe::egui::{Key, Modifiers};

use super::table::KeyScope;

/// Owner of a frame's keys.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum KeyboardOwner {
    /// The window, and the area under the pointer.
    #[default]
    Window,
    /// A text field; keys of [`KeyScope::Window`] still work.
    Field,
    /// A dialog, which owns all keys.
    Dialog,
}

fn escape_id() -> egui::Id {
    egui::Id::unique("Escape was pressed as the last frame and this one began")
}

fn owner_id() -> egui::Id {
    egui::Id::unique("owner of the keyboard")
}

/// Remembers the owner of this frame's keys; to be called before any part of the frame is shown. If
/// one key closed a field or a dialog, the others, typed as fast, would otherwise go to the widgets
/// below.
pub(crate) fn begin_frame(ctx: &egui::Context) {
    let owner = if ctx.memory(|memory| memory.top_modal_layer().is_some()) {
        KeyboardOwner::Dialog
    } else if ctx.egui_wants_keyboard_input() {
        KeyboardOwner::Field
    } else {
        KeyboardOwner::Window
    };
    let is_escape = ctx.input(|input| input.key_pressed(Key::Escape));
    ctx.data_mut(|data| {
        data.insert_temp(owner_id(), owner);
        let [_, last] = data.get_temp::<[bool; 2]>(escape_id()).unwrap_or_default();
        data.insert_temp(escape_id(), [last, is_escape]);
    });
}

/// True if Escape was pressed in this frame or the last, even where others have taken that press
/// since. A field loses the keyboard before anything is shown, is told so in both frames, and its
/// text is to be given up all the same.
pub(crate) fn is_escape_pressed(ctx: &egui::Context) -> bool {
    ctx.data(|data| data.get_temp::<[bool; 2]>(escape_id())).unwrap_or_default().contains(&true)
        || ctx.input(|input| input.key_pressed(Key::Escape))
}

fn owner(ctx: &egui::Context) -> KeyboardOwner {
    ctx.data(|data| data.get_temp(owner_id())).unwrap_or_default()
}

/// True if the keys belong to a text field or a dialog, now or when the frame began.
pub(crate) fn is_keyboard_taken(ctx: &egui::Context) -> bool {
    owner(ctx) != KeyboardOwner::Window || ctx.egui_wants_keyboard_input()
}

fn pointed_id() -> egui::Id {
    egui::Id::unique("place of keys under the pointer")
}

/// Remembers the place of keys that the pointer is over in this frame; `None` over others, such as
/// the inspector.
pub(crate) fn set_pointed(ctx: &egui::Context, place: Option<KeyScope>) {
    ctx.data_mut(|data| data.insert_temp(pointed_id(), place));
}

/// Place of keys that the pointer is over in this frame.
pub(super) fn pointed(ctx: &egui::Context) -> Option<KeyScope> {
    ctx.data(|data| data.get_temp::<Option<KeyScope>>(pointed_id())).flatten()
}

/// Text field that has the keyboard now.
pub(crate) fn text_field(ctx: &egui::Context) -> Option<egui::Id> {
    ctx.memory(egui::Memory::focused).filter(|_| ctx.text_edit_focused())
}

/// True if all keys belong to a dialog.
pub(crate) fn is_dialog_open(ctx: &egui::Context) -> bool {
    owner(ctx) == KeyboardOwner::Dialog
}

/// Takes a key with exactly these modifiers, which egui's own method does not check: to egui
/// Shift+D is D too.
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
