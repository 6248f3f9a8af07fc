//! Widths of the tabs of a stack: all names that there is room for, the one in front always.

use std::collections::HashMap;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Color32, TextStyle, Ui, WidgetInfo};
use egui_tiles::{TileId, Tiles};

use super::{Pane, TAB_MARGIN};
use crate::panels::PanelRow;

/// Room beside the name on a tab where there is plenty, in points.
const PLENTY: f32 = 20.0;
/// Least width of a tab with a shortened name, in points.
const SHORTENED: f32 = 64.0;

/// Widths of the tabs of all stacks, in points; 0 for a tab without room.
#[derive(Default)]
pub(super) struct TabWidths(HashMap<TileId, f32>);

impl TabWidths {
    /// Width of a tab, in points; 0 where it has no room.
    pub(super) fn of(&self, tile: TileId) -> f32 {
        self.0.get(&tile).copied().unwrap_or_default()
    }

    /// Finds the widths of a stack's tabs in the room that is left in its row. Where some have no
    /// room, a button at the end of the row lists all of them; returns the one that is chosen
    /// there.
    pub(super) fn lay_out(
        &mut self,
        ui: &mut Ui,
        tiles: &Tiles<Pane>,
        tabs: &egui_tiles::Tabs,
    ) -> Option<TileId> {
        let panels: Vec<(TileId, &PanelRow)> = tabs
            .children
            .iter()
            .filter_map(|tile| Some((*tile, tiles.get_pane(tile)?.0)))
            .collect();
        let font = TextStyle::Body.resolve(ui.style());
        let name = |panel: &PanelRow| {
            let name = panel.label.tr().to_owned();
            ui.painter().layout_no_wrap(name, font.clone(), Color32::WHITE).size().x
        };
        let names: Vec<f32> = panels.iter().map(|(_, panel)| name(panel)).collect();
        let front = panels.iter().position(|(tile, _)| tabs.active == Some(*tile));
        let mut widths = fitted(&names, front, ui.available_width());
        let mut chosen = None;
        if widths.contains(&0.0) {
            ui.add_space(4.0);
            chosen = list(ui, &panels, tabs.active);
            widths = fitted(&names, front, ui.available_width());
        }
        self.0.extend(panels.iter().map(|(tile, _)| *tile).zip(widths));
        chosen
    }
}

/// Shows a button that lists all panels of a stack. Returns the chosen one.
fn list(ui: &mut Ui, panels: &[(TileId, &PanelRow)], front: Option<TileId>) -> Option<TileId> {
    let mut chosen = None;
    let menu = ui.menu_button("...", |ui| {
        for (tile, panel) in panels {
            let is_it = front == Some(*tile);
            let entry = ui.selectable_label(is_it, panel.label.tr()).on_hover_text(panel.help.tr());
            let label = tr!("Show {panel}", panel = panel.label);
            entry.widget_info(|| WidgetInfo::selected(egui::Role::MenuItem, true, is_it, &label));
            if entry.clicked() {
                chosen = Some(*tile);
                ui.close();
            }
        }
    });
    menu.response.widget_info(|| {
        WidgetInfo::labeled(egui::Role::Button, true, tr!("All panels of this stack"))
    });
    menu.response.on_hover_text(tr!("Lists all panels that lie here"));
    chosen
}

/// Widths of tabs beside each other, from those of their names. In a narrow row margins shrink
/// first, then the longest names are shortened, and then the last tabs have no room; the one in
/// front keeps its own.
fn fitted(names: &[f32], front: Option<usize>, room: f32) -> Vec<f32> {
    let all: f32 = names.iter().sum();
    let margin = ((room - all) / names.len().max(1) as f32).min(PLENTY);
    if margin >= TAB_MARGIN {
        return names.iter().map(|name| name + margin).collect();
    }
    let whole: Vec<f32> = names.iter().map(|name| name + TAB_MARGIN).collect();
    let narrowest = |index: usize| {
        if Some(index) == front { whole[index] } else { whole[index].min(SHORTENED) }
    };
    let mut shown: Vec<usize> = (0..names.len()).collect();
    while shown.iter().map(|index| narrowest(*index)).sum::<f32>() > room
        && let Some(last) = shown.iter().rposition(|index| Some(*index) != front)
    {
        shown.remove(last);
    }
    // The front tab aside, the names share the room from the shortest to the longest, so that the
    // long ones are cut to one width.
    let mut left = room - front.map_or(0.0, |front| whole[front]);
    let mut others: Vec<usize> =
        shown.iter().copied().filter(|index| Some(*index) != front).collect();
    others.sort_by(|a, b| whole[*a].total_cmp(&whole[*b]));
    let mut widths = vec![0.0; names.len()];
    for (index, rest) in others.iter().zip((1..=others.len()).rev()) {
        widths[*index] = whole[*index].min(left / rest as f32);
        left -= widths[*index];
    }
    if let Some(front) = front {
        widths[front] = whole[front].min(room.max(0.0));
    }
    widths
}

#[cfg(test)]
mod tests {
    use super::fitted;

    const NAMES: [f32; 5] = [40.0, 40.0, 50.0, 110.0, 45.0];

    #[test]
    fn tabs_with_room_have_their_whole_names_and_margins_shrink_first() {
        assert_eq!(fitted(&NAMES, Some(0), 900.0), [60.0, 60.0, 70.0, 130.0, 65.0]);
        assert_eq!(fitted(&NAMES, Some(0), 360.0), [55.0, 55.0, 65.0, 125.0, 60.0]);
    }

    #[test]
    fn long_names_are_shortened_before_a_tab_goes() {
        assert_eq!(fitted(&NAMES, Some(0), 300.0), [50.0, 50.0, 60.0, 85.0, 55.0]);
        let in_front = fitted(&NAMES, Some(3), 300.0);
        assert_eq!((in_front[3], in_front[4]), (120.0, 0.0), "the front's name is whole");
    }

    #[test]
    fn the_first_tabs_and_the_one_in_front_stay() {
        assert_eq!(fitted(&NAMES, Some(4), 160.0), [50.0, 50.0, 0.0, 0.0, 55.0]);
        assert_eq!(fitted(&NAMES, Some(0), 30.0), [30.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(fitted(&NAMES, None, 0.0), [0.0; 5]);
        assert!(fitted(&[], None, 100.0).is_empty());
    }

    #[test]
    fn tabs_never_take_more_than_the_room() {
        for room in 0..600 {
            for front in [None, Some(0), Some(3)] {
                let widths = fitted(&NAMES, front, room as f32);
                assert!(widths.iter().sum::<f32>() <= room as f32 + 1e-3, "{room}: {widths:?}");
            }
        }
    }
}
