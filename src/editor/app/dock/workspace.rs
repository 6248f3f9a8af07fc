//! Workspaces: two layouts of the panels, one for looks and one for painting. Each keeps its layout
//! by hand: whoever comes back to a workspace finds it as it was left.

use chiaro_locale::tr;
use egui_tiles::{Container, Tile, Tree};
use serde_json::{Value, json};

use super::{Dock, Pane, arrangement};
use crate::commands::PanelId;
use crate::panels::PANELS;

/// Task that the panels are laid out for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Workspace {
    /// Editing a look and its graph.
    #[default]
    Look,
    /// Painting what the open look shows.
    Painting,
}

impl Workspace {
    /// All workspaces, in the order of menus.
    pub(crate) const ALL: [Self; 2] = [Self::Look, Self::Painting];

    /// Label of the workspace in the menu.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Look => tr!("Layout for looks"),
            Self::Painting => tr!("Layout for painting"),
        }
    }

    /// Explanation of when the workspace comes by itself.
    pub(crate) fn help(self) -> &'static str {
        match self {
            Self::Look => {
                tr!("Where the panels lie while nothing is painted: it comes with every look that \
                     shows no open painting")
            }
            Self::Painting => {
                tr!("Where the panels lie while you paint: it comes and goes with what is painted")
            }
        }
    }
}

impl Dock {
    /// The present workspace.
    pub(crate) fn workspace(&self) -> Workspace {
        self.workspace
    }

    /// Lays the panels out for another workspace, as they last lay there. The first time, painting
    /// begins with the open panels and those that it needs.
    pub(crate) fn enter(&mut self, workspace: Workspace) {
        if self.workspace == workspace {
            return;
        }
        self.workspace = workspace;
        self.is_changed = true;
        let next = self.aside.take();
        let is_first = next.is_none();
        let next = next.unwrap_or_else(|| self.tree.clone());
        let mut left = std::mem::replace(&mut self.tree, next);
        if workspace == Workspace::Painting {
            uncover_graph(&mut left);
            if is_first {
                self.open_for_painting();
            }
        }
        self.aside = Some(left);
    }

    /// Lays the panels out as a new window does; the other layout stays.
    pub(crate) fn reset(&mut self) {
        self.tree = arrangement();
        self.is_changed = true;
        if self.workspace == Workspace::Painting {
            self.open_for_painting();
        }
    }

    /// Brings the panels for painting to the front, the one to paint on last.
    fn open_for_painting(&mut self) {
        let rows = PANELS.iter().rev().filter(|row| row.place.is_for_painting);
        rows.for_each(|row| self.open(row.id));
    }

    /// Both layouts, where one of them changed since the last call.
    pub(crate) fn changed(&mut self) -> Option<Value> {
        if !std::mem::take(&mut self.is_changed) {
            return None;
        }
        let here = serde_json::to_value(&self.tree).ok()?;
        let aside =
            self.aside.as_ref().map(serde_json::to_value).transpose().ok()?.unwrap_or_default();
        Some(match self.workspace {
            Workspace::Look => json!({ "look": here, "painting": aside }),
            Workspace::Painting => json!({ "look": aside, "painting": here }),
        })
    }

    /// Restores saved layouts, and begins with the one for looks. A layout that cannot be read, or
    /// in which a panel is twice, changes nothing. Old settings have one layout alone: painting
    /// left its panels in it.
    pub(crate) fn restore(&mut self, saved: &Value) {
        let read = |name: &str| saved.get(name).and_then(sound);
        let (look, painting) = match sound(saved) {
            Some(mut only) => {
                let before = only.clone();
                let was_covered = uncover_graph(&mut only);
                (Some(only), was_covered.then_some(before))
            }
            None => (read("look"), read("painting")),
        };
        if let Some(look) = look {
            (self.tree, self.aside, self.workspace) = (look, painting, Workspace::Look);
        }
    }
}

/// A saved layout, where it can be used.
fn sound(saved: &Value) -> Option<Tree<Pane>> {
    let tree = serde_json::from_value::<Tree<Pane>>(saved.clone()).ok()?;
    let count = |panel| {
        tree.tiles
            .tiles()
            .filter(|tile| matches!(tile, Tile::Pane(found) if found.0.id == panel))
            .count()
    };
    let is_sound = PANELS.iter().all(|row| count(row.id) < 2)
        && count(PanelId::PICTURE) + count(PanelId::GRAPH) > 0;
    (is_sound && tree.root.is_some()).then_some(tree)
}

/// Brings the graph to the front where the panel to paint on covers it: that panel was opened to
/// paint, and looks are made of graphs. Returns true if the graph was covered.
fn uncover_graph(tree: &mut Tree<Pane>) -> bool {
    let tile = |panel| tree.tiles.find_pane(&Pane::of(panel)?);
    let (graph, paint) = (tile(PanelId::GRAPH), tile(PanelId::PAINT));
    let (Some(graph), Some(paint)) = (graph, paint) else { return false };
    let Some(stack) = tree.tiles.parent_of(graph) else { return false };
    match tree.tiles.get_mut(stack) {
        Some(Tile::Container(Container::Tabs(tabs))) if tabs.active == Some(paint) => {
            tabs.set_active(graph);
            true
        }
        _ => false,
    }
}
