//! Changes of an HCBTF, each with the change that takes it back, so that it has a past as looks and scenes have.

use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::{Address, Applied, Editable, Hcbtf, Rule, Tile};

/// A change of an HCBTF.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Change {
    /// Paints a sample, or takes what is painted of it away.
    Tile { address: Address, tile: Option<Arc<Tile>>, label: &'static str },
    /// Other rules.
    Rules { rules: Vec<Rule>, label: &'static str },
    /// Whether the tile repeats.
    Tiling(bool),
}

/// The document with a past.
#[derive(Clone, Debug)]
pub(crate) struct Painted(pub(super) Hcbtf);

impl Editable for Painted {
    type Edit = Change;

    fn edit(&mut self, edit: Change, is_known_good: bool) -> Applied<Change> {
        let hcbtf = &mut self.0;
        if !is_known_good {
            check(hcbtf, &edit).map_err(|why| Box::new(Diagnostic::error("impossible-edit", why)))?;
        }
        Ok(match edit {
            Change::Tile { address, tile, label } => {
                let address = address.canonical();
                let before = match tile {
                    Some(tile) => hcbtf.painted.insert(address, tile),
                    None => hcbtf.painted.remove(&address),
                };
                Change::Tile { address, tile: before, label }
            }
            Change::Rules { rules, label } => {
                Change::Rules { rules: std::mem::replace(&mut hcbtf.rules, rules), label }
            }
            Change::Tiling(is_tiling) => Change::Tiling(std::mem::replace(&mut hcbtf.is_tiling, is_tiling)),
        })
    }

    fn label(edit: &Change) -> String {
        match edit {
            Change::Tile { label, address, .. } => format!("{label} ({address})"),
            Change::Rules { label, .. } => (*label).to_owned(),
            Change::Tiling(true) => "repeat the tile".to_owned(),
            Change::Tiling(false) => "do not repeat the tile".to_owned(),
        }
    }

    fn does_nothing(_: &Change) -> bool {
        false
    }

    fn covers(older: &Change, newer: &Change) -> bool {
        match (older, newer) {
            (Change::Tile { address, .. }, Change::Tile { address: other, .. }) => address == other,
            (Change::Rules { .. }, Change::Rules { .. }) | (Change::Tiling(_), Change::Tiling(_)) => true,
            _ => false,
        }
    }
}

fn check(hcbtf: &Hcbtf, edit: &Change) -> Result<(), String> {
    match edit {
        Change::Tile { address, .. } if !hcbtf.grid.contains(*address) => {
            Err(format!("there is no sample at {address}"))
        }
        Change::Tile { tile: Some(tile), .. } if tile.size() != hcbtf.grid.size => {
            Err("the tile is of another size than the grid's".to_owned())
        }
        Change::Rules { rules, .. } => rules.iter().try_for_each(|rule| rule.check(&hcbtf.grid)),
        _ => Ok(()),
    }
}
