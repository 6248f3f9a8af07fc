//! Contents of menus that may be higher than the window, and menus that hold other controls.

use std::mem;

use chiaro_locale::tr;
use eframe::egui::containers::menu::{MenuButton, MenuConfig, is_in_menu};
use eframe::egui::{
    ComboBox, Key, PopupCloseBehavior, RectAlign, Response, Role, ScrollArea, TextEdit, Tooltip,
    Ui, WidgetInfo, WidgetText,
};

use crate::widgets::text::hint;

/// Room of a window that a menu leaves above and below itself, in points.
const MARGIN: f32 = 44.0;
/// Width and greatest height of a list with a search, in points.
const LIST: [f32; 2] = [240.0, 320.0];
/// Passes in which the search of a list that was opened takes the keyboard: an area is measured
/// before anything in it can have the keyboard.
const OPENING: u64 = 2;

/// Search among the entries of a list, shown as they are found.
pub(crate) struct MenuSearch {
    words: Vec<String>,
    /// True if the first entry that is found is chosen.
    takes_first: bool,
    is_empty: bool,
}

impl MenuSearch {
    /// Shows an entry where all words are in its text. Returns true if it is chosen.
    pub(crate) fn entry(&mut self, ui: &mut Ui, text: &str) -> bool {
        let lower = text.to_lowercase();
        if !self.words.iter().all(|word| lower.contains(word)) {
            return false;
        }
        self.is_empty = false;
        let is_chosen = ui.button(text).clicked() || mem::take(&mut self.takes_first);
        if is_chosen {
            ui.close();
        }
        is_chosen
    }
}

/// Shows a button with a list that a search shortens; the search has the keyboard at once, and
/// Enter chooses the first entry.
pub(crate) fn searching(
    ui: &mut Ui,
    (text, name): (&str, &str),
    search: &mut String,
    add: impl FnOnce(&mut Ui, &mut MenuSearch),
) -> Response {
    let contents = |ui: &mut Ui| {
        ui.set_width(LIST[0]);
        let takes_first = search_field(ui, name, search);
        let words: Vec<String> = search.split_whitespace().map(str::to_lowercase).collect();
        let has_words = !words.is_empty();
        let mut search = MenuSearch { words, takes_first, is_empty: true };
        let area = ScrollArea::vertical().max_height(LIST[1]).auto_shrink([false, true]);
        area.show(ui, |ui| add(ui, &mut search));
        if search.is_empty && has_words {
            hint(ui, tr!("Nothing of that name"));
        }
    };
    // A second popup would close the menu that the button is in.
    if is_in_menu(ui) {
        return ui.menu_button(text, contents).response;
    }
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    MenuButton::new(text).config(config).ui(ui, contents).0
}

/// Shows the search of a list, which has the keyboard once the list is opened, and is empty then.
/// Returns true if Enter was pressed in it.
pub(crate) fn search_field(ui: &mut Ui, name: &str, search: &mut String) -> bool {
    let now = ui.ctx().cumulative_pass_nr();
    let id = ui.scope_id().with("passes of an open list");
    let [opened, last] = ui.data(|data| data.get_temp(id)).unwrap_or([u64::MAX; 2]);
    let was_shown = last.checked_add(1).is_some_and(|next| next >= now);
    let opened = if was_shown { opened } else { now };
    ui.data_mut(|data| data.insert_temp(id, [opened, now]));
    if !was_shown {
        search.clear();
    }
    let field = TextEdit::singleline(search).hint_text(name).desired_width(f32::INFINITY);
    let field = ui.add(field);
    field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, name));
    if now - opened <= OPENING {
        ui.memory_mut(|memory| memory.request_focus(field.id));
    }
    let pressed = |key| ui.input(|input| input.key_pressed(key));
    let takes_first = field.lost_focus() && pressed(Key::Enter);
    // A single Escape leaves both the search and the list.
    if pressed(Key::Escape) {
        ui.close();
    }
    takes_first
}

/// Shows the contents of a menu, with a scroll bar where the window is too low for all of them.
pub(crate) fn scrolling<R>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
    let height = (ui.ctx().content_rect().height() - MARGIN).max(MARGIN);
    // A popup tells no height that it may take; without a least one it takes a few rows.
    let area = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
    area.show(ui, add).inner
}

/// Shows a button with a menu of controls, which stays open while they are used.
pub(crate) fn staying<R>(
    ui: &mut Ui,
    text: impl Into<WidgetText>,
    add: impl FnOnce(&mut Ui) -> R,
) -> Response {
    let text = text.into();
    // A second popup would close the menu that the button is in.
    if is_in_menu(ui) {
        return ui.menu_button(text, |ui| scrolling(ui, add)).response;
    }
    let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    MenuButton::new(text).config(config).ui(ui, |ui| scrolling(ui, add)).0
}

/// Shows a combo box with this text, or within a menu, which its list would close, a menu.
pub(crate) fn choice(
    ui: &mut Ui,
    combo: ComboBox,
    text: impl Into<WidgetText>,
    add: impl FnOnce(&mut Ui),
) -> Response {
    let text = text.into();
    if is_in_menu(ui) {
        return ui.menu_button(text, |ui| scrolling(ui, add)).response;
    }
    combo.selected_text(text).show_ui(ui, add).response
}

/// Tells beside a disabled entry of a menu why it is so: below, the text would cover the next one.
pub(crate) fn why_disabled(response: &Response, why: impl Into<WidgetText>) {
    let mut tooltip = Tooltip::for_disabled(response);
    tooltip.popup = tooltip.popup.align(RectAlign::RIGHT_START);
    tooltip.show(|ui| ui.label(why));
}
