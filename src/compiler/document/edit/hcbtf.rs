//! Edits of HCBTFs.

use std::sync::Arc;

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use super::parts::{at, insert_at};
use super::patch::Patch;
use super::{EditResult, Editable, all_or_none, impossible};
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, Rule, Tile, UnknownFields};

/// Edit of an HCBTF.
///
/// Undo steps hold only the changed data: painting over a tile is kept as a [`Patch`], and a
/// removed tile as itself, shared with all its other owners.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "edit", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the fields are named after what they set")]
pub enum HcbtfEdit {
    /// Several edits as one: all or none.
    Group { edits: Vec<HcbtfEdit> },
    /// Replaces the whole HCBTF, as when another program changed its file.
    Replace {
        #[serde(with = "crate::document::image::of_hcbtf")]
        hcbtf: Box<Hcbtf>,
    },
    /// Paints a sample anew, as pasting does; `None` leaves the sample to the rules again.
    SetTile {
        address: Address,
        #[serde(with = "crate::document::image::of_tile")]
        tile: Option<Arc<Tile>>,
    },
    /// Changes a part of a painted sample, as a stroke does: see [`HcbtfEdit::paint`].
    PatchTile { address: Address, patch: Patch },
    /// Paints a sample as another is painted.
    CopyTile { from: Address, to: Address },
    /// Leaves a painted sample to the rules again.
    DeleteTile { address: Address },
    /// Changes all rules; `unknown` are the fields of the rules that this version does not know, by
    /// index.
    SetRules {
        rules: Vec<Rule>,
        #[serde(default, skip_serializing_if = "UnknownFields::is_empty")]
        unknown: UnknownFields,
    },
    /// Adds a rule before the one at `index`; without one it comes last. `unknown` are its fields
    /// that this version does not know.
    AddRule {
        rule: Rule,
        index: Option<usize>,
        #[serde(default, skip_serializing_if = "UnknownFields::is_empty")]
        unknown: UnknownFields,
    },
    /// Changes a rule.
    SetRule { index: usize, rule: Rule },
    /// Removes a rule.
    RemoveRule { index: usize },
    /// Moves a rule to where it is number `to` of all.
    MoveRule { from: usize, to: usize },
    /// Sets whether the tile repeats without a seam.
    SetTiling { is_tiling: bool },
    /// Changes the grid. Nothing is resampled: painted samples whose address or size does not fit
    /// any more are removed, and rules that name such an address too; undo brings them back.
    SetGrid { grid: Grid },
}

impl HcbtfEdit {
    /// Edit that makes a sample look like `tile`, as at the end of a stroke: a patch of the changed
    /// texels, where the sample was painted before.
    pub fn paint(hcbtf: &Hcbtf, address: Address, tile: Tile) -> Self {
        match hcbtf.painted(address).filter(|before| before.size() == tile.size()) {
            Some(before) => match Patch::between(before, &tile) {
                Some(patch) => Self::PatchTile { address, patch },
                None => nothing(),
            },
            None => Self::SetTile { address, tile: Some(Arc::new(tile)) },
        }
    }

    /// Label of the edit for undo.
    pub fn label(&self) -> String {
        match self {
            Self::Group { edits } => {
                edits.first().map_or_else(|| "nothing".to_owned(), Self::label)
            }
            Self::Replace { .. } => tr!("load the file again").to_owned(),
            Self::SetTile { address, tile: Some(_) } | Self::PatchTile { address, .. } => {
                tr!("paint {address}")
            }
            Self::SetTile { address, tile: None } | Self::DeleteTile { address } => {
                tr!("delete {address}")
            }
            Self::CopyTile { to, .. } => tr!("copy to {to}"),
            Self::SetRules { .. } => tr!("change the rules").to_owned(),
            Self::AddRule { rule, .. } => tr!("add the rule {rule}", rule = rule.word()),
            Self::SetRule { rule, .. } => tr!("change the rule {rule}", rule = rule.word()),
            Self::RemoveRule { .. } => tr!("remove a rule").to_owned(),
            Self::MoveRule { .. } => tr!("move a rule").to_owned(),
            Self::SetTiling { is_tiling: true } => tr!("let the tile repeat").to_owned(),
            Self::SetTiling { .. } => tr!("let the tile end").to_owned(),
            Self::SetGrid { .. } => tr!("change the grid").to_owned(),
        }
    }
}

impl Hcbtf {
    /// Applies an edit and returns the one that takes it back.
    ///
    /// # Errors
    /// A diagnostic where the edit is impossible: it names a part that does not exist, or sets a
    /// value that no HCBTF holds, such as a tile of another size than the grid's. The HCBTF is then
    /// as it was.
    pub fn apply(&mut self, edit: HcbtfEdit) -> EditResult<HcbtfEdit> {
        self.edit(edit, false)
    }
}

impl Editable for Hcbtf {
    type Edit = HcbtfEdit;

    fn edit(&mut self, edit: HcbtfEdit, is_known_good: bool) -> EditResult<HcbtfEdit> {
        use std::mem::replace;
        if !is_known_good {
            check(self, &edit)?;
        }
        Ok(match edit {
            HcbtfEdit::Group { edits } => {
                HcbtfEdit::Group { edits: all_or_none(self, edits, is_known_good)? }
            }
            HcbtfEdit::Replace { hcbtf } => {
                HcbtfEdit::Replace { hcbtf: Box::new(replace(self, *hcbtf)) }
            }
            HcbtfEdit::SetTile { address, tile } => set_tile(self, address, tile),
            HcbtfEdit::PatchTile { address, patch } => patch_tile(self, address, &patch)?,
            HcbtfEdit::CopyTile { from, to } => {
                let tile = self.painted(from).ok_or_else(|| unpainted(from))?.clone();
                set_tile(self, to, Some(tile))
            }
            HcbtfEdit::DeleteTile { address } => {
                self.painted(address).ok_or_else(|| unpainted(address))?;
                set_tile(self, address, None)
            }
            HcbtfEdit::SetRules { rules, unknown } => {
                let before = take_unknown(self);
                put_unknown(self, unknown);
                HcbtfEdit::SetRules { rules: replace(&mut self.rules, rules), unknown: before }
            }
            HcbtfEdit::AddRule { rule, index, unknown } => {
                let index = insert_at(&mut self.rules, rule, index)?;
                renumber_unknown(self, |old| Some(old + usize::from(old >= index)));
                if !unknown.is_empty() {
                    let mut all = take_unknown(self);
                    all.insert(index.to_string(), unknown.into());
                    put_unknown(self, all);
                }
                HcbtfEdit::RemoveRule { index }
            }
            HcbtfEdit::SetRule { index, rule } => {
                HcbtfEdit::SetRule { index, rule: replace(at(&mut self.rules, index)?, rule) }
            }
            HcbtfEdit::RemoveRule { index } => {
                at(&mut self.rules, index)?;
                let unknown = unknown_of_rule(self, index);
                renumber_unknown(self, |old| {
                    (old != index).then(|| old - usize::from(old > index))
                });
                let rule = self.rules.remove(index);
                HcbtfEdit::AddRule { rule, index: Some(index), unknown }
            }
            HcbtfEdit::MoveRule { from, to } => {
                at(&mut self.rules, from)?;
                at(&mut self.rules, to)?;
                let rule = self.rules.remove(from);
                self.rules.insert(to, rule);
                renumber_unknown(self, |old| {
                    Some(match old {
                        _ if old == from => to,
                        _ if from < old && old <= to => old - 1,
                        _ if to <= old && old < from => old + 1,
                        _ => old,
                    })
                });
                if from == to { nothing() } else { HcbtfEdit::MoveRule { from: to, to: from } }
            }
            HcbtfEdit::SetTiling { is_tiling } => {
                HcbtfEdit::SetTiling { is_tiling: replace(&mut self.is_tiling, is_tiling) }
            }
            HcbtfEdit::SetGrid { grid } => set_grid(self, grid),
        })
    }

    fn label(&self, edit: &HcbtfEdit) -> String {
        edit.label()
    }

    fn does_nothing(edit: &HcbtfEdit) -> bool {
        matches!(edit, HcbtfEdit::Group { edits } if edits.is_empty())
    }

    /// Patches cover nothing: each leads back one stroke, and no further.
    fn covers(older: &HcbtfEdit, newer: &HcbtfEdit) -> bool {
        match (older, newer) {
            (HcbtfEdit::SetTile { address: a, .. }, HcbtfEdit::SetTile { address: b, .. }) => {
                a.canonical() == b.canonical()
            }
            (HcbtfEdit::SetRule { index: a, .. }, HcbtfEdit::SetRule { index: b, .. }) => a == b,
            (HcbtfEdit::SetRules { .. }, HcbtfEdit::SetRules { .. })
            | (HcbtfEdit::SetTiling { .. }, HcbtfEdit::SetTiling { .. }) => true,
            _ => false,
        }
    }
}

fn nothing() -> HcbtfEdit {
    HcbtfEdit::Group { edits: Vec::new() }
}

fn unpainted(address: Address) -> Box<Diagnostic> {
    impossible(tr!("the sample at {address} is not painted"))
}

fn set_tile(hcbtf: &mut Hcbtf, address: Address, tile: Option<Arc<Tile>>) -> HcbtfEdit {
    let address = address.canonical();
    let old = match &tile {
        Some(tile) => hcbtf.painted.insert(address, tile.clone()),
        None => hcbtf.painted.remove(&address),
    };
    match (old, tile) {
        (None, None) => nothing(),
        (Some(old), Some(new)) if old == new => nothing(),
        (Some(old), Some(new)) => match Patch::between(&new, &old) {
            Some(patch) => HcbtfEdit::PatchTile { address, patch },
            None => HcbtfEdit::SetTile { address, tile: Some(old) },
        },
        (old, _) => HcbtfEdit::SetTile { address, tile: old },
    }
}

fn patch_tile(hcbtf: &mut Hcbtf, address: Address, patch: &Patch) -> EditResult<HcbtfEdit> {
    let tile = hcbtf.painted.get_mut(&address.canonical()).ok_or_else(|| unpainted(address))?;
    let other = || impossible(tr!("the sample at {address} is not what the stroke was painted on"));
    // The patch is checked before a shared tile is copied.
    if !patch.applies_to(tile) {
        return Err(other());
    }
    let patch = patch.apply(Arc::make_mut(tile)).ok_or_else(other)?;
    Ok(HcbtfEdit::PatchTile { address, patch })
}

fn set_grid(hcbtf: &mut Hcbtf, grid: Grid) -> HcbtfEdit {
    let mut back = vec![HcbtfEdit::SetGrid { grid: std::mem::replace(&mut hcbtf.grid, grid) }];
    hcbtf.painted.retain(|address, tile| {
        let stays = grid.contains(*address) && tile.size() == grid.size;
        if !stays {
            back.push(HcbtfEdit::SetTile { address: *address, tile: Some(tile.clone()) });
        }
        stays
    });
    let stays: Vec<bool> = hcbtf.rules.iter().map(|rule| rule.check(&grid).is_ok()).collect();
    if stays.contains(&false) {
        let rules = hcbtf.rules.clone();
        let unknown = take_unknown(hcbtf);
        back.push(HcbtfEdit::SetRules { rules, unknown: unknown.clone() });
        put_unknown(hcbtf, unknown);
        let kept = |old: usize| stays[..old].iter().filter(|stays| **stays).count();
        renumber_unknown(hcbtf, |old| stays.get(old)?.then(|| kept(old)));
        let mut each = stays.iter();
        hcbtf.rules.retain(|_| each.next().copied().unwrap_or_default());
    }
    match back.len() {
        1 => back.remove(0),
        _ => HcbtfEdit::Group { edits: back },
    }
}

/// Takes the unknown fields of all rules out, by index.
fn take_unknown(hcbtf: &mut Hcbtf) -> UnknownFields {
    match hcbtf.unknown.remove("rules") {
        Some(serde_json::Value::Object(fields)) => fields,
        _ => UnknownFields::new(),
    }
}

fn put_unknown(hcbtf: &mut Hcbtf, fields: UnknownFields) {
    if !fields.is_empty() {
        hcbtf.unknown.insert("rules".to_owned(), fields.into());
    }
}

fn unknown_of_rule(hcbtf: &Hcbtf, index: usize) -> UnknownFields {
    let fields = hcbtf.unknown.get("rules").and_then(|rules| rules.get(index.to_string()));
    fields.and_then(|fields| fields.as_object()).cloned().unwrap_or_default()
}

/// Gives the unknown fields of each rule to the rule's new index; `None` for rules that are gone.
fn renumber_unknown(hcbtf: &mut Hcbtf, to: impl Fn(usize) -> Option<usize>) {
    let renumbered = take_unknown(hcbtf)
        .into_iter()
        .filter_map(|(index, fields)| Some((to(index.parse().ok()?)?.to_string(), fields)));
    let renumbered = renumbered.collect();
    put_unknown(hcbtf, renumbered);
}

/// Checks that an edit sets values that an HCBTF can hold, groups aside.
fn check(hcbtf: &Hcbtf, edit: &HcbtfEdit) -> Result<(), Box<Diagnostic>> {
    match edit {
        HcbtfEdit::Replace { hcbtf } => {
            check_grid(&hcbtf.grid)?;
            check_rules(&hcbtf.grid, &hcbtf.rules, 0)?;
            check_room(&hcbtf.grid, hcbtf.painted.len())?;
            let mut tiles = hcbtf.painted.iter();
            tiles.try_for_each(|(address, tile)| check_tile(&hcbtf.grid, *address, Some(tile)))
        }
        HcbtfEdit::SetTile { address, tile: Some(tile) } => {
            check_tile(&hcbtf.grid, *address, Some(tile))?;
            check_one_more(hcbtf, *address)
        }
        HcbtfEdit::CopyTile { to, .. } => {
            check_tile(&hcbtf.grid, *to, None)?;
            check_one_more(hcbtf, *to)
        }
        HcbtfEdit::SetRules { rules, .. } => check_rules(&hcbtf.grid, rules, 0),
        HcbtfEdit::AddRule { rule, .. } => {
            check_rules(&hcbtf.grid, std::slice::from_ref(rule), hcbtf.rules.len())
        }
        HcbtfEdit::SetRule { rule, .. } => check_rules(&hcbtf.grid, std::slice::from_ref(rule), 0),
        HcbtfEdit::SetGrid { grid } => check_grid(grid),
        _ => Ok(()),
    }
}

fn check_grid(grid: &Grid) -> Result<(), Box<Diagnostic>> {
    grid.check().map_err(impossible)
}

fn check_tile(
    grid: &Grid,
    address: Address,
    tile: Option<&Arc<Tile>>,
) -> Result<(), Box<Diagnostic>> {
    if !grid.contains(address) {
        return Err(impossible(tr!("there is no sample at {address} in the grid")));
    }
    match tile.map(|tile| tile.size()).filter(|size| *size != grid.size) {
        None => Ok(()),
        Some([width, height]) => {
            let [w, h] = grid.size;
            Err(impossible(tr!(
                "the tile has {width} x {height} texels; the grid's tiles have {w} x {h}"
            )))
        }
    }
}

/// Checks rules that are added to `others` existing ones.
fn check_rules(grid: &Grid, rules: &[Rule], others: usize) -> Result<(), Box<Diagnostic>> {
    if rules.len() + others > Hcbtf::MAX_RULES {
        return Err(impossible(tr!("there can be at most {most} rules", most = Hcbtf::MAX_RULES)));
    }
    rules.iter().try_for_each(|rule| {
        rule.check(grid).map_err(|why| impossible(format!("{}: {why}", rule.word())))
    })
}

fn check_one_more(hcbtf: &Hcbtf, address: Address) -> Result<(), Box<Diagnostic>> {
    let is_new = hcbtf.painted(address).is_none();
    check_room(&hcbtf.grid, hcbtf.painted.len() + usize::from(is_new))
}

fn check_room(grid: &Grid, samples: usize) -> Result<(), Box<Diagnostic>> {
    let bytes = samples as u64 * grid.texels() as u64 * 4;
    if samples <= Hcbtf::MAX_PAINTED && bytes <= Hcbtf::MAX_PAINTED_BYTES {
        return Ok(());
    }
    let (most, mib) = (Hcbtf::MAX_PAINTED, Hcbtf::MAX_PAINTED_BYTES >> 20);
    Err(Box::new(
        impossible(tr!("at most {most} samples can be painted, of at most {mib} MiB"))
            .hint(tr!("take a coarser grid, or fill by rules what is painted now")),
    ))
}
