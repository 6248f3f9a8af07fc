//! Dock: the panels of the window, and their layout. Panels can be dragged by their tabs, stacked,
//! split, closed and brought back; the layout is remembered.

mod columns;
mod heights;
mod tabs;
mod workspace;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{
    Color32, Rect, Response, Sense, Stroke, TextStyle, TextWrapMode, Ui, UiBuilder, Vec2, Visuals,
    WidgetInfo, WidgetText, vec2,
};
use egui_tiles::{
    Behavior, Container, EditAction, Linear, LinearDir, SimplificationOptions, TabState, Tabs,
    Tile, TileId, Tiles, Tree, UiResponse,
};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::commands::PanelId;
use crate::panels::{self, PANELS, PanelRow, PanelStack};

use crate::widgets::theme;
use tabs::TabWidths;
pub(crate) use workspace::Workspace;

/// Height of the row of tabs, which is also the side of the arrows that scroll them; in points.
const BAR: f32 = 28.0;
/// Least room beside the name on a tab, in points.
const TAB_MARGIN: f32 = 10.0;
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
        row.map(Self).ok_or_else(|| de::Error::custom(tr!("there is no panel {name}")))
    }
}

/// Layout of the panels in the window.
pub(crate) struct Dock {
    tree: Tree<Pane>,
    workspace: Workspace,
    /// Layout of the other workspace, once that was entered.
    aside: Option<Tree<Pane>>,
    /// Panel that was opened, until its stack has the height that the panel needs.
    opened: Option<TileId>,
    /// True if the layouts differ from the saved ones.
    is_changed: bool,
}

impl Default for Dock {
    fn default() -> Self {
        Self {
            tree: arrangement(),
            workspace: Workspace::default(),
            aside: None,
            opened: None,
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
        let own_shares = self.widen_columns(ui.available_width());
        let mut shown = TileBehavior {
            content,
            is_changed: false,
            is_resized: false,
            widths: TabWidths::default(),
            wanted: None,
        };
        self.tree.ui(&mut shown, ui);
        let TileBehavior { is_changed, is_resized, wanted, .. } = shown;
        self.is_changed |= is_changed;
        if let Some(own) = own_shares.filter(|_| !is_resized) {
            self.restore_columns(&own);
        }
        if let Some(wanted) = wanted {
            self.tree.make_active(|tile, _| tile == wanted);
            self.is_changed = true;
        }
        if self.opened.take().is_some_and(|opened| self.raise(opened)) {
            ui.ctx().request_discard("an opened panel has another height");
        }
    }

    fn tile_of(&self, panel: PanelId) -> Option<TileId> {
        self.tree.tiles.find_pane(&Pane::of(panel)?)
    }

    /// True if this panel is seen.
    pub(crate) fn shows(&self, panel: PanelId) -> bool {
        self.tile_of(panel).is_some_and(|tile| self.tree.active_tiles().contains(&tile))
    }

    /// Place of a panel that is seen, with the row of tabs above it.
    pub(crate) fn place(&self, panel: PanelId) -> Option<Rect> {
        let stack = self.tree.tiles.parent_of(self.tile_of(panel)?)?;
        self.tree.tiles.rect(stack).filter(|_| self.shows(panel))
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
        self.opened = self.tile_of(panel);
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
    /// True if a hand moved the boundary of two tiles.
    is_resized: bool,
    widths: TabWidths,
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
        let size = vec2(self.widths.of(tile), ui.available_height());
        let (_, rect) = ui.allocate_space(size);
        let response = ui.interact(rect, id, Sense::click_and_drag());
        response.widget_info(|| {
            WidgetInfo::selected(egui::Role::Tab, true, state.active, panel.label.tr())
        });
        let font = TextStyle::Body.resolve(ui.style());
        let name = WidgetText::from(panel.label.tr());
        // Half a point more than the name takes, so that rounding shortens none.
        let room = (size.x - TAB_MARGIN + 0.5).max(0.0);
        let galley = name.into_galley(ui, Some(TextWrapMode::Truncate), room, font);
        let is_whole = !galley.elided;
        if !state.is_being_dragged && size.x > 0.0 {
            let color = if response.hovered() { colors.text } else { color };
            let at = rect.center() - galley.size() / 2.0;
            ui.painter().galley_with_override_text_color(at, galley, color);
            if state.active {
                ui.painter().hline(
                    rect.shrink(TAB_MARGIN / 2.0).x_range(),
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
        match is_whole {
            true => response.on_hover_text(panel.help.tr()),
            false => response.on_hover_text(format!("{}\n{}", panel.label.tr(), panel.help.tr())),
        }
    }

    /// Lays out the tabs of a stack before they are drawn, so that nothing is left to scroll.
    fn top_bar_right_ui(
        &mut self,
        tiles: &Tiles<Pane>,
        ui: &mut Ui,
        _: TileId,
        tabs: &Tabs,
        offset: &mut f32,
    ) {
        self.wanted = self.widths.lay_out(ui, tiles, tabs).or(self.wanted);
        // The arrows that scroll come by what the tabs took in the last frame, when the row may
        // have been wider. An offset of an arrow's width allows for that; the tiles clamp it to 0
        // before they draw.
        *offset = BAR;
    }

    fn tab_bar_height(&self, _: &egui::Style) -> f32 {
        BAR
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

    fn on_edit(&mut self, edit: EditAction) {
        self.is_changed = true;
        self.is_resized |= edit == EditAction::TileResized;
    }
}
