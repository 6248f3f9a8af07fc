//! Contents of menus that may be higher than the window, and menus that hold other controls.

use eframe::egui::containers::menu::{MenuButton, MenuConfig, is_in_menu};
use eframe::egui::{
    ComboBox, PopupCloseBehavior, RectAlign, Response, ScrollArea, Tooltip, Ui, WidgetText,
};

/// Room of a window that a menu leaves above and below itself, in points.
const MARGIN: f32 = 44.0;

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
