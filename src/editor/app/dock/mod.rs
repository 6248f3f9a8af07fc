//! The panels of the window: which there are, and how they share it. They can be dragged by their
//! tabs, stacked, split, closed and brought back; the arrangement is remembered.

mod workspace;

use eframe::egui;
use eframe::egui::{
    Color32, Rect, Response, Sense, Stroke, TextStyle, Ui, UiBuilder, Vec2, Visuals, WidgetInfo,
    WidgetText, vec2,
};
use egui_tiles::{
    Behavior, Container, Linear, LinearDir, SimplificationOptions, TabState, Tabs, Tile, TileId,
    Tiles, Tree, UiResponse,
};
use serde::{Deserialize, Serialize};

use crate::widgets::theme;
pub(crate) use workspace::Workspace;

/// Beside the name on a tab, in points.
const TAB_MARGIN: f32 = 20.0;
/// The width of the arrows that move tabs, in points.
const ARROW: f32 = 30.0;
/// For so many frames a tab that came to the front is brought into view.
const FRAMES: u8 = 3;
/// Panels are laid out in as much room at least, in points.
const LEAST: Vec2 = Vec2::splat(48.0);

/// A part of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Panel {
    Picture,
    Graph,
    Paint,
    Samples,
    Sheet,
    Directions,
    Rules,
    Inspector,
    Code,
    Effects,
    Cost,
    Probe,
    Profile,
    Keys,
    Timeline,
    Layers,
    Lights,
    Objects,
    Problems,
    History,
    Library,
    Fit,
}

impl Panel {
    /// All, in the order of menus.
    pub(crate) const ALL: [Self; 22] = [
        Self::Picture,
        Self::Graph,
        Self::Paint,
        Self::Samples,
        Self::Sheet,
        Self::Directions,
        Self::Rules,
        Self::Layers,
        Self::Lights,
        Self::Objects,
        Self::Library,
        Self::History,
        Self::Inspector,
        Self::Profile,
        Self::Keys,
        Self::Timeline,
        Self::Code,
        Self::Problems,
        Self::Effects,
        Self::Cost,
        Self::Probe,
        Self::Fit,
    ];

    /// What its tab says.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Picture => "Picture",
            Self::Graph => "Graph",
            Self::Paint => "Paint",
            Self::Samples => "Samples",
            Self::Sheet => "Sheet",
            Self::Directions => "Light and eye",
            Self::Rules => "Fill rules",
            Self::Inspector => "Inspector",
            Self::Code => "Code",
            Self::Effects => "Effects",
            Self::Cost => "Cost and accuracy",
            Self::Probe => "Probe",
            Self::Profile => "Profile",
            Self::Keys => "Keys",
            Self::Timeline => "Timeline",
            Self::Layers => "Layers",
            Self::Lights => "Lights",
            Self::Objects => "Objects",
            Self::Problems => "Problems",
            Self::History => "History",
            Self::Library => "Library",
            Self::Fit => "Paint light",
        }
    }

    /// What it is for.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Picture => "The look on a mesh: drag the lights and the camera",
            Self::Graph => "The nodes of the look and their wires",
            Self::Paint => {
                "A surface that changes with the light and the eye, to be painted on (HCBTF)"
            }
            Self::Samples => {
                "All lights and views of what is painted at a glance: go from one to another, \
                 copy, delete"
            }
            Self::Sheet => {
                "All of what is painted and filled in one picture, as the thesis lays it out; \
                 tells what lies where"
            }
            Self::Directions => {
                "Where the light and the eye are that you paint for, and what is painted already"
            }
            Self::Rules => "The rules that fill the lights and views that nobody painted",
            Self::Inspector => "The values of what is selected",
            Self::Code => "The generated WGSL",
            Self::Effects => "Everything that the picture costs, what was left out, and the proof",
            Self::Cost => "What each tier costs in time, and how far it is from the truth",
            Self::Probe => "The value on every wire at a pixel, f32 beside f64 (I)",
            Self::Profile => {
                "How a layer's tone falls with the angle: drag offset, fall-off and cut-off"
            }
            Self::Keys => "Values that change with the direction of a light or of the view",
            Self::Timeline => "Values that change with time: keys, play, scrub",
            Self::Layers => "The look as a stack of layers: another view of the same graph",
            Self::Lights => "The lights that layers name: which shine, from where, how bright",
            Self::Objects => {
                "The objects of the scene: their meshes, their looks, where they stand"
            }
            Self::Problems => "What is wrong, where, and what mends it",
            Self::History => "Everything that was done; a click goes there and back",
            Self::Library => "Nodes to drag onto the canvas, and finished looks to begin with",
            Self::Fit => {
                "Paint on the picture where it should be lighter or darker: the look is fitted to \
                 that (L)"
            }
        }
    }

    /// Where it comes back to when it was closed: beside the first of these that is there.
    fn neighbours(self) -> &'static [Self] {
        match self {
            Self::Picture | Self::Graph | Self::Inspector => &[],
            Self::Paint => &[Self::Graph],
            Self::Sheet => &[Self::Paint, Self::Graph],
            Self::Rules => &[Self::Inspector],
            Self::Samples => {
                &[Self::Profile, Self::Keys, Self::Code, Self::Effects, Self::Problems]
            }
            Self::Profile | Self::Keys | Self::Timeline => {
                &[Self::Profile, Self::Keys, Self::Code, Self::Effects]
            }
            Self::Code | Self::Problems | Self::Effects | Self::Cost | Self::Probe | Self::Fit => {
                &[
                    Self::Code,
                    Self::Problems,
                    Self::Effects,
                    Self::Cost,
                    Self::Probe,
                    Self::Profile,
                    Self::Keys,
                ]
            }
            Self::Directions
            | Self::Layers
            | Self::Lights
            | Self::Objects
            | Self::Library
            | Self::History => &[
                Self::Layers,
                Self::Lights,
                Self::Objects,
                Self::Library,
                Self::History,
                Self::Inspector,
            ],
        }
    }
}

/// How the panels share the window.
pub(crate) struct Dock {
    tree: Tree<Panel>,
    workspace: Workspace,
    /// The layout of the other workspace, once that was entered.
    aside: Option<Tree<Panel>>,
    /// What is saved of it is another now.
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

/// Picture and graph side by side, what they are made of below and beside them.
fn arrangement() -> Tree<Panel> {
    let mut tiles = Tiles::default();
    let mut tabs = |panels: &[Panel]| {
        let panes = panels.iter().map(|panel| tiles.insert_pane(*panel)).collect();
        tiles.insert_tab_tile(panes)
    };
    let picture = tabs(&[Panel::Picture]);
    let below = tabs(&[
        Panel::Profile,
        Panel::Keys,
        Panel::Code,
        Panel::Problems,
        Panel::Effects,
        Panel::Cost,
        Panel::Probe,
    ]);
    let graph = tabs(&[Panel::Graph]);
    let stack =
        tabs(&[Panel::Layers, Panel::Lights, Panel::Objects, Panel::Library, Panel::History]);
    let inspector = tabs(&[Panel::Inspector]);
    let mut shared = |dir, parts: &[(TileId, f32)]| {
        let mut linear = Linear::new(dir, parts.iter().map(|(tile, _)| *tile).collect());
        parts.iter().for_each(|(tile, share)| linear.shares.set_share(*tile, *share));
        tiles.insert_container(Container::Linear(linear))
    };
    let left = shared(LinearDir::Vertical, &[(picture, 0.58), (below, 0.42)]);
    let right = shared(LinearDir::Vertical, &[(stack, 0.44), (inspector, 0.56)]);
    let root = shared(LinearDir::Horizontal, &[(left, 0.33), (graph, 0.45), (right, 0.22)]);
    Tree::new(egui::Id::unique("dock"), root, tiles)
}

impl Dock {
    /// Shows every panel where it lies; `content` fills one.
    pub(crate) fn show(&mut self, ui: &mut Ui, content: &mut dyn FnMut(&mut Ui, Panel)) {
        let mut shown = Shown { content, is_changed: false, wanted: None };
        self.tree.ui(&mut shown, ui);
        self.is_changed |= shown.is_changed;
        if let Some(wanted) = shown.wanted {
            self.tree.make_active(|tile, _| tile == wanted);
            self.is_changed = true;
        }
    }

    /// Whether this panel is seen.
    pub(crate) fn shows(&self, panel: Panel) -> bool {
        self.tree
            .tiles
            .find_pane(&panel)
            .is_some_and(|tile| self.tree.active_tiles().contains(&tile))
    }

    /// Whether this panel is there, seen or behind another's tab.
    pub(crate) fn has(&self, panel: Panel) -> bool {
        self.tree.tiles.find_pane(&panel).is_some()
    }

    /// Brings a panel to the front; one that was closed comes back.
    pub(crate) fn open(&mut self, panel: Panel) {
        if !self.has(panel) {
            self.bring_back(panel);
        }
        self.tree.make_active(|_, tile| matches!(tile, Tile::Pane(found) if *found == panel));
        self.is_changed = true;
    }

    /// Takes a panel away.
    pub(crate) fn close(&mut self, panel: Panel) {
        if let Some(tile) = self.tree.tiles.find_pane(&panel) {
            self.tree.remove_recursively(tile);
            self.is_changed = true;
        }
    }

    fn bring_back(&mut self, panel: Panel) {
        let tiles = &mut self.tree.tiles;
        let pane = tiles.insert_pane(panel);
        if panel == Panel::Timeline && below_graph(tiles, pane).is_some() {
            return;
        }
        let beside = panel.neighbours().iter().filter(|other| **other != panel);
        let beside = beside
            .filter_map(|other| tiles.find_pane(other))
            .find_map(|tile| tiles.parent_of(tile));
        if let Some(Tile::Container(container)) = beside.and_then(|tabs| tiles.get_mut(tabs)) {
            container.add_child(pane);
            return;
        }
        let tabs = tiles.insert_tab_tile(vec![pane]);
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

/// Puts a panel below the graph; `None` where there is no place for it.
fn below_graph(tiles: &mut Tiles<Panel>, pane: TileId) -> Option<()> {
    let graph = tiles.parent_of(tiles.find_pane(&Panel::Graph)?)?;
    let around = tiles.parent_of(graph)?;
    let Some(Tile::Container(Container::Linear(_))) = tiles.get(around) else { return None };
    let own = tiles.insert_tab_tile(vec![pane]);
    let mut both = Linear::new(LinearDir::Vertical, vec![graph, own]);
    both.shares.set_share(graph, 0.68);
    both.shares.set_share(own, 0.32);
    let both = tiles.insert_container(Container::Linear(both));
    if let Some(Tile::Container(Container::Linear(row))) = tiles.get_mut(around) {
        row.children.iter_mut().filter(|child| **child == graph).for_each(|child| *child = both);
        row.shares.replace_with(graph, both);
    }
    Some(())
}

/// What the tree asks while it is shown.
struct Shown<'a> {
    content: &'a mut dyn FnMut(&mut Ui, Panel),
    is_changed: bool,
    /// The panel that was chosen from the list of those without room for their tabs.
    wanted: Option<TileId>,
}

impl Behavior<Panel> for Shown<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _: TileId, panel: &mut Panel) -> UiResponse {
        let frame = match panel {
            Panel::Graph => egui::Frame::new(),
            _ => theme::panel(ui),
        };
        frame.show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            // In less room than a few letters panels need not know what to do: the rest of them is
            // cut off.
            let room = ui.available_rect_before_wrap();
            let whole = Rect::from_min_size(room.min, room.size().max(LEAST));
            ui.scope_builder(UiBuilder::new().max_rect(whole), |ui| {
                ui.set_clip_rect(ui.clip_rect().intersect(room.expand(1.0)));
                (self.content)(ui, *panel);
            });
        });
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, panel: &Panel) -> WidgetText {
        panel.label().into()
    }

    fn tab_ui(
        &mut self,
        tiles: &mut Tiles<Panel>,
        ui: &mut Ui,
        id: egui::Id,
        tile: TileId,
        state: &TabState,
    ) -> Response {
        let Some(&panel) = tiles.get_pane(&tile) else {
            return ui.allocate_response(vec2(0.0, 0.0), Sense::hover());
        };
        let colors = theme::of(ui);
        let color = if state.active { colors.text } else { colors.dim };
        let font = TextStyle::Body.resolve(ui.style());
        let galley = ui.painter().layout_no_wrap(panel.label().to_owned(), font, color);
        let (_, rect) =
            ui.allocate_space(vec2(galley.size().x + TAB_MARGIN, ui.available_height()));
        let response = ui.interact(rect, id, Sense::click_and_drag());
        response.widget_info(|| {
            WidgetInfo::selected(egui::Role::Tab, true, state.active, panel.label())
        });
        if !state.is_being_dragged {
            let color = if response.hovered() { colors.text } else { color };
            // What is cut off by the end of the row has no half letters.
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
        response.context_menu(|ui| wants_closed = ui.button("Close this panel").clicked());
        if wants_closed {
            tiles.remove(tile);
            self.is_changed = true;
        }
        response.on_hover_text(panel.help())
    }

    /// Where tabs have no room beside each other: a list of all of them, and the one in front is
    /// always seen.
    fn top_bar_right_ui(
        &mut self,
        tiles: &Tiles<Panel>,
        ui: &mut Ui,
        stack: TileId,
        tabs: &Tabs,
        offset: &mut f32,
    ) {
        let font = TextStyle::Body.resolve(ui.style());
        let mut end = 0.0;
        let mut all = Vec::new();
        for (tile, panel) in
            tabs.children.iter().filter_map(|tile| Some((*tile, *tiles.get_pane(tile)?)))
        {
            let galley =
                ui.painter().layout_no_wrap(panel.label().to_owned(), font.clone(), Color32::WHITE);
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
                let entry = ui.selectable_label(is_it, panel.label()).on_hover_text(panel.help());
                let label = format!("Show {}", panel.label());
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
            WidgetInfo::labeled(egui::Role::Button, true, "All panels of this stack")
        });
        menu.response.on_hover_text("Lists all panels that lie here");
        let known = egui::Id::unique("front tab").with(stack);
        let (before, frames) =
            ui.data(|data| data.get_temp::<(Option<TileId>, u8)>(known)).unwrap_or_default();
        let Some((tile, _, span)) = all.into_iter().find(|(tile, ..)| tabs.active == Some(*tile))
        else {
            return;
        };
        let frames = if before == Some(tile) { frames.saturating_add(1) } else { 0 };
        // How wide all tabs are together is known in the frame after.
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

/// A line in place of what is not there yet.
pub(crate) fn hint(ui: &mut Ui, text: &str) {
    ui.label(egui::RichText::new(text).color(theme::of(ui).dim));
}

/// Text in a column of a row, cut where it is too long.
pub(crate) fn cell(
    ui: &Ui,
    rect: egui::Rect,
    text: &str,
    font: egui::FontId,
    color: egui::Color32,
) {
    let mut job = egui::text::LayoutJob::single_section(
        text.to_owned(),
        egui::text::TextFormat { font_id: font, color, ..egui::text::TextFormat::default() },
    );
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width().max(0.0));
    let galley = ui.fonts_mut(|fonts| fonts.layout_job(job));
    let at = egui::pos2(rect.left(), rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(at, galley, color);
}
