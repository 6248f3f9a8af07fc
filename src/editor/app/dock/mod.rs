//! Dock: the panels of the window, and their layout. Panels can be dragged by their tabs, stacked,
//! split, closed and brought back; the layout is remembered.

mod workspace;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    Color32, Rect, Response, Sense, Stroke, TextStyle, Ui, UiBuilder, Vec2, Visuals, WidgetInfo,
    WidgetText, vec2,
};
use egui_tiles::{
    Behavior, Container, Linear, LinearDir, SimplificationOptions, TabState, Tabs, Tile, TileId,
    Tiles, Tree, UiResponse,
};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::commands::PanelId;
use crate::panels::{self, PANELS, PanelRow, PanelStack};

use crate::widgets::theme;
pub(crate) use workspace::Workspace;

/// Room beside the name on a tab, in points.
const TAB_MARGIN: f32 = 20.0;
/// Width of the arrows that scroll tabs, in points.
const ARROW: f32 = 30.0;
/// Number of frames in which a tab that came to the front is brought into view.
const FRAMES: u8 = 3;
/// Smallest size that panels are laid out in, in points.
const LEAST: Vec2 = Vec2::splat(48.0);

/// A panel in its tile: in a saved layout, the panel's name.
#[derive(Clone, Copy)]
struct Pane(&'static PanelRow);

impl Pane {
    fn of(id: PanelId) -> Option<Self> {
        panels::row_of(id).map(Self)
    }
}

impl PartialEq for Pane {
    fn eq(&self, other: &Self) -> bool {
        self.0.id == other.0.id
    }
}

impl Serialize for Pane {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.id.0)
    }
}

impl<'de> Deserialize<'de> for Pane {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        let row = PANELS.iter().find(|row| row.id.0 == name);
        row.map(Self).ok_or_else(|| de::Error::custom(format!("there is no panel {name}")))
    }
}

/// Layout of the panels in the window.
pub(crate) struct Dock {
    tree: Tree<Pane>,
    workspace: Workspace,
    /// Layout of the other workspace, once that was entered.
    aside: Option<Tree<Pane>>,
    /// True if the layouts differ from the saved ones.
    is_changed: bool,
}

impl Default for Dock {
    fn default() -> Self {
        Self {
            tree: arrangement(),
            workspace: Workspace::default(),
            aside: None,
            is_changed: false,
        }
    }
}

/// Default layout: picture and graph side by side, other panels below and beside them.
fn arrangement() -> Tree<Pane> {
    let mut tiles = Tiles::default();
    let mut stacked = |stack| {
        let rows = PANELS.iter().filter(|row| row.place.stack == Some(stack));
        let panes = rows.map(|row| tiles.insert_pane(Pane(row))).collect();
        tiles.insert_tab_tile(panes)
    };
    let picture = stacked(PanelStack::Picture);
    let below = stacked(PanelStack::BelowPicture);
    let graph = stacked(PanelStack::Graph);
    let document = stacked(PanelStack::Document);
    let inspector = stacked(PanelStack::Inspector);
    let mut shared = |dir, parts: &[(TileId, f32)]| {
        let mut linear = Linear::new(dir, parts.iter().map(|(tile, _)| *tile).collect());
        parts.iter().for_each(|(tile, share)| linear.shares.set_share(*tile, *share));
        tiles.insert_container(Container::Linear(linear))
    };
    let left = shared(LinearDir::Vertical, &[(picture, 0.58), (below, 0.42)]);
    let right = shared(LinearDir::Vertical, &[(document, 0.44), (inspector, 0.56)]);
    let root = shared(LinearDir::Horizontal, &[(left, 0.33), (graph, 0.45), (right, 0.22)]);
    Tree::new(egui::Id::unique("dock"), root, tiles)
}

impl Dock {
    /// Shows every panel in its tile; `content` fills one.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        content: &mut dyn FnMut(&mut Ui, &'static PanelRow),
    ) {
        let mut shown = TileBehavior { content, is_changed: false, wanted: None };
        self.tree.ui(&mut shown, ui);
        self.is_changed |= shown.is_changed;
        if let Some(wanted) = shown.wanted {
            self.tree.make_active(|tile, _| tile == wanted);
            self.is_changed = true;
        }
    }

    fn tile_of(&self, panel: PanelId) -> Option<TileId> {
        self.tree.tiles.find_pane(&Pane::of(panel)?)
    }

    /// True if this panel is seen.
    pub(crate) fn shows(&self, panel: PanelId) -> bool {
        self.tile_of(panel).is_some_and(|tile| self.tree.active_tiles().contains(&tile))
    }

    /// True if this panel is open, seen or behind another's tab.
    pub(crate) fn has(&self, panel: PanelId) -> bool {
        self.tile_of(panel).is_some()
    }

    /// Brings a panel to the front; a closed panel comes back.
    pub(crate) fn open(&mut self, panel: PanelId) {
        let Some(pane) = Pane::of(panel) else { return };
        if !self.has(panel) {
            self.bring_back(pane);
        }
        self.tree.make_active(|_, tile| matches!(tile, Tile::Pane(found) if *found == pane));
        self.is_changed = true;
    }

    /// Closes a panel.
    pub(crate) fn close(&mut self, panel: PanelId) {
        if let Some(tile) = self.tile_of(panel) {
            self.tree.remove_recursively(tile);
            self.is_changed = true;
        }
    }

    fn bring_back(&mut self, panel: Pane) {
        let tiles = &mut self.tree.tiles;
        let tile = tiles.insert_pane(panel);
        let place = &panel.0.place;
        if place.is_below_graph {
            // Panels that want this place share it, behind their tabs.
            let is_like = |row: &&PanelRow| row.place.is_below_graph && row.id != panel.0.id;
            let mut like = PANELS.iter().filter(is_like);
            let open = like.find_map(|row| tiles.find_pane(&Pane(row)));
            let tabs = open.and_then(|open| tiles.parent_of(open));
            if let Some(Tile::Container(Container::Tabs(tabs))) =
                tabs.and_then(|tabs| tiles.get_mut(tabs))
            {
                tabs.add_child(tile);
                return;
            }
            if below_graph(tiles, tile).is_some() {
                return;
            }
        }
        let beside = place.beside.iter().filter(|other| **other != panel.0.id);
        let beside = beside
            .filter_map(|other| tiles.find_pane(&Pane::of(*other)?))
            .find_map(|tile| tiles.parent_of(tile));
        if let Some(Tile::Container(container)) = beside.and_then(|tabs| tiles.get_mut(tabs)) {
            container.add_child(tile);
            return;
        }
        let tabs = tiles.insert_tab_tile(vec![tile]);
        match self.tree.root.map(|root| (root, self.tree.tiles.get_mut(root))) {
            Some((_, Some(Tile::Container(Container::Linear(linear)))))
                if linear.dir == LinearDir::Horizontal =>
            {
                linear.add_child(tabs);
            }
            Some((root, _)) => {
                self.tree.root = Some(self.tree.tiles.insert_horizontal_tile(vec![root, tabs]));
            }
            None => self.tree.root = Some(tabs),
        }
    }
}

/// Puts a panel below the graph; `None` where there is no graph to put it below.
fn below_graph(tiles: &mut Tiles<Pane>, pane: TileId) -> Option<()> {
    let graph = tiles.parent_of(tiles.find_pane(&Pane::of(PanelId::GRAPH)?)?)?;
    let around = tiles.parent_of(graph)?;
    let Some(Tile::Container(Container::Linear(_))) = tiles.get(around) else { return None };
    let own = tiles.insert_tab_tile(vec![pane]);
    let mut both = Linear::new(LinearDir::Vertical, vec![graph, own]);
    both.shares.set_share(graph, 0.62);
    both.shares.set_share(own, 0.38);
    let both = tiles.insert_container(Container::Linear(both));
    if let Some(Tile::Container(Container::Linear(row))) = tiles.get_mut(around) {
        row.children.iter_mut().filter(|child| **child == graph).for_each(|child| *child = both);
        row.shares.replace_with(graph, both);
    }
    Some(())
}

/// Behavior of the tree of tiles while it is drawn.
struct TileBehavior<'a> {
    content: &'a mut dyn FnMut(&mut Ui, &'static PanelRow),
    is_changed: bool,
    /// Panel that was chosen from the list of those without room for their tabs.
    wanted: Option<TileId>,
}

impl Behavior<Pane> for TileBehavior<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _: TileId, panel: &mut Pane) -> UiResponse {
        let frame = match panel.0.place.fills_room {
            true => egui::Frame::new(),
            false => theme::panel(ui),
        };
        frame.show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            // Panels need not handle less room than a few letters take: the rest of them is cut
            // off.
            let room = ui.available_rect_before_wrap();
            let whole = Rect::from_min_size(room.min, room.size().max(LEAST));
            ui.scope_builder(UiBuilder::new().max_rect(whole), |ui| {
                ui.set_clip_rect(ui.clip_rect().intersect(room.expand(1.0)));
                (self.content)(ui, panel.0);
            });
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, panel: &Pane) -> WidgetText {
        panel.0.label.tr().into()
    }

    fn tab_ui(
        &mut self,
        tiles: &mut Tiles<Pane>,
        ui: &mut Ui,
        id: egui::Id,
        tile: TileId,
        state: &TabState,
    ) -> Response {
        let Some(&Pane(panel)) = tiles.get_pane(&tile) else {
            return ui.allocate_response(vec2(0.0, 0.0), Sense::hover());
        };
        let colors = theme::of(ui);
        let color = if state.active { colors.text } else { colors.dim };
        let font = TextStyle::Body.resolve(ui.style());
        let galley = ui.painter().layout_no_wrap(panel.label.tr().to_owned(), font, color);
        let (_, rect) =
            ui.allocate_space(vec2(galley.size().x + TAB_MARGIN, ui.available_height()));
        let response = ui.interact(rect, id, Sense::click_and_drag());
        response.widget_info(|| {
            WidgetInfo::selected(egui::Role::Tab, true, state.active, panel.label.tr())
        });
        if !state.is_being_dragged {
            let color = if response.hovered() { colors.text } else { color };
            // A name that the end of the row cuts off is left out, and not shown in half letters.
            let seen = rect.intersect(ui.clip_rect()).shrink2(vec2(TAB_MARGIN / 4.0, 0.0));
            let name = galley.size().x;
            if seen.width() >= name {
                let middle =
                    rect.center().x.clamp(seen.left() + name / 2.0, seen.right() - name / 2.0);
                let at = egui::pos2(middle, rect.center().y) - galley.size() / 2.0;
                ui.painter().galley_with_override_text_color(at, galley, color);
            }
            if state.active {
                ui.painter().hline(
                    rect.shrink(10.0).x_range(),
                    rect.bottom() - 2.0,
                    Stroke::new(2.0, colors.accent),
                );
            }
        }
        if response.clicked_by(egui::PointerButton::Middle) {
            tiles.remove(tile);
            self.is_changed = true;
        }
        let mut wants_closed = false;
        response.context_menu(|ui| wants_closed = ui.button(tr!("Close this panel")).clicked());
        if wants_closed {
            tiles.remove(tile);
            self.is_changed = true;
        }
        response.on_hover_text(panel.help.tr())
    }

    /// Shows a list of all panels where their tabs have no room beside each other, and keeps the
    /// front tab in view.
    fn top_bar_right_ui(
        &mut self,
        tiles: &Tiles<Pane>,
        ui: &mut Ui,
        stack: TileId,
        tabs: &Tabs,
        offset: &mut f32,
    ) {
        let font = TextStyle::Body.resolve(ui.style());
        let mut end = 0.0;
        let mut all = Vec::new();
        for (tile, panel) in
            tabs.children.iter().filter_map(|tile| Some((*tile, tiles.get_pane(tile)?.0)))
        {
            let galley = ui.painter().layout_no_wrap(
                panel.label.tr().to_owned(),
                font.clone(),
                Color32::WHITE,
            );
            let from = end;
            end += galley.size().x + TAB_MARGIN;
            all.push((tile, panel, from..=end));
        }
        if end <= ui.available_width() {
            return;
        }
        ui.add_space(4.0);
        let menu = ui.menu_button("...", |ui| {
            for (tile, panel, _) in &all {
                let is_it = tabs.active == Some(*tile);
                let entry =
                    ui.selectable_label(is_it, panel.label.tr()).on_hover_text(panel.help.tr());
                let label = tr!("Show {panel}", panel = panel.label);
                entry.widget_info(|| {
                    WidgetInfo::selected(egui::Role::MenuItem, true, is_it, &label)
                });
                if entry.clicked() {
                    self.wanted = Some(*tile);
                    ui.close();
                }
            }
        });
        menu.response.widget_info(|| {
            WidgetInfo::labeled(egui::Role::Button, true, tr!("All panels of this stack"))
        });
        menu.response.on_hover_text(tr!("Lists all panels that lie here"));
        let known = egui::Id::unique("front tab").with(stack);
        let (before, frames) =
            ui.data(|data| data.get_temp::<(Option<TileId>, u8)>(known)).unwrap_or_default();
        let Some((tile, _, span)) = all.into_iter().find(|(tile, ..)| tabs.active == Some(*tile))
        else {
            return;
        };
        let frames = if before == Some(tile) { frames.saturating_add(1) } else { 0 };
        // The common width of all tabs is only known in the next frame.
        if frames < FRAMES {
            let room = (ui.available_width() - 2.0 * ARROW).max(0.0);
            *offset = offset.max(*span.end() - room).min(*span.start());
            ui.data_mut(|data| data.insert_temp(known, (Some(tile), frames)));
            ui.ctx().request_repaint();
        }
    }

    fn tab_bar_height(&self, _: &egui::Style) -> f32 {
        28.0
    }

    fn tab_bar_color(&self, visuals: &Visuals) -> Color32 {
        visuals.panel_fill
    }

    fn gap_width(&self, _: &egui::Style) -> f32 {
        3.0
    }

    fn min_size(&self) -> f32 {
        90.0
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions { all_panes_must_have_tabs: true, ..SimplificationOptions::default() }
    }

    fn on_edit(&mut self, _: egui_tiles::EditAction) {
        self.is_changed = true;
    }
}
