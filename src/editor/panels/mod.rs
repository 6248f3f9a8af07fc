//! Panels of the window. Each is a value: a [`PanelRow`] with its name, its help, its place, the
//! function that draws it and the threads that work for it. A new panel is a file with a row, and a
//! line in [`PANELS`].

pub(crate) mod code;
pub(crate) mod cost;
pub(crate) mod curves;
mod effects;
mod export;
mod fit;
pub(crate) mod frames;
mod graph;
mod history;
pub(crate) mod inspector;
pub(crate) mod layers;
pub(crate) mod library;
mod light_table;
pub(crate) mod lights;
pub(crate) mod links;
mod mixer;
mod objects;
mod painting;
mod picture;
mod probe;
pub(crate) mod problems;
mod shot;
mod snapshots;
pub(crate) mod start;
mod table;
mod thumbs;
pub(crate) mod variations;
pub(crate) mod wedge;
mod workbench;

use crate::commands::PanelId;
pub(crate) use table::{PanelContext, PanelRow, PanelStack, Presence};
pub(crate) use workbench::Workbench;

/// All panels, in the order of menus and of tabs.
pub(crate) static PANELS: &[PanelRow] = &[
    picture::PANEL,
    graph::PANEL,
    painting::PAINT,
    painting::SAMPLES,
    painting::SHEET,
    painting::DIRECTIONS,
    painting::RULES,
    layers::PANEL,
    lights::PANEL,
    objects::PANEL,
    shot::PANEL,
    frames::PANEL,
    variations::PANEL,
    wedge::PANEL,
    library::PANEL,
    history::PANEL,
    snapshots::PANEL,
    inspector::PANEL,
    curves::profile::PANEL,
    curves::keys::PANEL,
    curves::timeline::PANEL,
    light_table::PANEL,
    mixer::PANEL,
    links::PANEL,
    code::PANEL,
    problems::PANEL,
    effects::PANEL,
    cost::PANEL,
    export::PANEL,
    probe::PANEL,
    fit::PANEL,
];

/// Row of a panel.
pub(crate) fn row_of(id: PanelId) -> Option<&'static PanelRow> {
    PANELS.iter().find(|row| row.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_have_names_of_their_own_and_come_back_beside_others() {
        for (index, row) in PANELS.iter().enumerate() {
            assert!(PANELS[..index].iter().all(|other| other.id != row.id), "{:?}", row.id);
            assert!(row.place.beside.iter().all(|id| row_of(*id).is_some()), "{:?}", row.id);
            assert!(
                !row.label.english().is_empty() && !row.help.english().is_empty(),
                "{:?}",
                row.id
            );
        }
    }
}
