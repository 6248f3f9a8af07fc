//! Edits of an HCBTF can be undone and redone to the byte, and a journal gives them back.

use std::sync::Arc;

use chiaro::document::relief::{Channel, PRESETS, Pattern};
use chiaro::document::{
    Address, Directions, Grid, Hcbtf, HcbtfAngle, HcbtfEdit, History, Relief, Rule, Strokes, Tile,
    UnknownFields,
};
use chiaro::files::journal::{
    DocumentInfo, Journal, JournalSlot, Op, RecoveredDocument, recover, recover_any,
};
use chiaro::hcbtf::write;
use proptest::prelude::*;

use crate::support::random::Random;

const SIZES: [[u32; 2]; 2] = [[7, 5], [16, 16]];

/// Random edits, from a seed.
struct Edits(Random);

impl Edits {
    fn new(seed: u64) -> Self {
        Self(Random::new(seed))
    }

    fn bits(&mut self) -> u64 {
        self.0.bits()
    }

    fn below(&mut self, count: usize) -> usize {
        self.0.index(count)
    }

    fn chance(&mut self, in_ten: usize) -> bool {
        self.below(10) < in_ten
    }

    fn pick<'a, T>(&mut self, from: &'a [T]) -> Option<&'a T> {
        (!from.is_empty()).then(|| &from[self.below(from.len())])
    }

    fn grid(&mut self) -> Grid {
        let mut directions =
            || Directions { theta: 1 + self.below(3) as u32, phi: 1 + self.below(4) as u32 };
        let (light, view) = (directions(), directions());
        Grid { size: *self.pick(&SIZES).unwrap(), light, view }
    }

    /// An address, mostly within the grid.
    fn address(&mut self, hcbtf: &Hcbtf) -> Address {
        let painted: Vec<Address> = hcbtf.painted.keys().copied().collect();
        if let Some(address) = self.pick(&painted).copied().filter(|_| self.chance(6)) {
            return address;
        }
        let mut direction = |of: Directions| {
            [self.below(of.theta as usize + 1) as u32, self.below(of.phi as usize) as u32]
        };
        Address::new(direction(hcbtf.grid.light), direction(hcbtf.grid.view))
    }

    /// A tile, mostly of the grid's size; now and then the painted one with some bytes changed.
    fn tile(&mut self, hcbtf: &Hcbtf, address: Address) -> Tile {
        let size = if self.chance(9) { hcbtf.grid.size } else { SIZES[1] };
        if let Some(tile) = hcbtf.painted(address).filter(|_| self.chance(7)) {
            let mut tile = Tile::clone(tile);
            for _ in 0..self.below(5) {
                let count = tile.bytes().len();
                tile.bytes_mut()[self.below(count)] = self.bits() as u8;
            }
            return tile;
        }
        let count = 4 * size[0] * size[1];
        Tile::new(size, (0..count).map(|_| self.bits() as u8).collect()).unwrap()
    }

    fn rule(&mut self, hcbtf: &Hcbtf) -> Rule {
        match self.below(8) {
            0 => Rule::Copy { from: self.address(hcbtf) },
            1 => Rule::Lock { angles: vec![HcbtfAngle::LightPhi] },
            2 => Rule::Blend { sharpness: self.below(70) as f64 },
            3 => Rule::Rotate { turns: 1.0 / 3.0 },
            4 => Rule::Morph { sharpness: self.below(70) as f64 },
            5 => {
                let mut strokes = Strokes::preset(self.pick(&Strokes::PRESETS).unwrap());
                // The softness is now and then beyond the bounds of files.
                strokes.shadow.softness = self.below(12) as f64 / 10.0;
                Rule::Strokes(Box::new(strokes))
            }
            6 => Rule::Relief(Box::new(self.relief(hcbtf))),
            _ => Rule::Color { color: self.bits().to_le_bytes()[..4].try_into().unwrap() },
        }
    }

    /// Fields of a rule that this version does not know, now and then.
    fn unknown(&mut self) -> UnknownFields {
        let fields = self.chance(5).then(|| ("by".to_owned(), self.below(9).into()));
        fields.into_iter().collect()
    }

    /// A relief, mostly within its bounds.
    fn relief(&mut self, hcbtf: &Hcbtf) -> Relief {
        let mut relief = self.pick(&PRESETS).unwrap().1();
        if self.chance(3) {
            let from = self.address(hcbtf);
            relief.pattern = Pattern::Painted {
                heights: from,
                channel: Channel::Alpha,
                is_inverted: true,
                colors: from,
            };
        }
        (relief.seed, relief.depth) = (self.bits() as u32, self.below(12) as f64 / 10.0);
        relief
    }

    fn edit(&mut self, hcbtf: &Hcbtf) -> HcbtfEdit {
        let address = self.address(hcbtf);
        let (index, to) = (self.below(4), self.below(4));
        match self.below(16) {
            0..=4 => HcbtfEdit::paint(hcbtf, address, self.tile(hcbtf, address)),
            5 | 6 => {
                HcbtfEdit::SetTile { address, tile: Some(Arc::new(self.tile(hcbtf, address))) }
            }
            7 => HcbtfEdit::CopyTile { from: address, to: self.address(hcbtf) },
            8 => HcbtfEdit::DeleteTile { address },
            9 => HcbtfEdit::AddRule {
                rule: self.rule(hcbtf),
                index: self.chance(5).then_some(index),
                unknown: self.unknown(),
            },
            10 => HcbtfEdit::SetRule { index, rule: self.rule(hcbtf) },
            11 if self.chance(5) => HcbtfEdit::RemoveRule { index },
            11 => HcbtfEdit::SetRules {
                rules: (0..to).map(|_| self.rule(hcbtf)).collect(),
                unknown: match self.unknown() {
                    fields if to > 0 && !fields.is_empty() => {
                        [((to - 1).to_string(), fields.into())].into_iter().collect()
                    }
                    _ => UnknownFields::new(),
                },
            },
            12 => HcbtfEdit::MoveRule { from: index, to },
            13 => HcbtfEdit::SetTiling { is_tiling: self.chance(5) },
            14 => HcbtfEdit::SetGrid { grid: self.grid() },
            _ if self.chance(2) => HcbtfEdit::Replace { hcbtf: Box::new(Hcbtf::new(self.grid())) },
            _ => HcbtfEdit::Group { edits: (0..self.below(4)).map(|_| self.edit(hcbtf)).collect() },
        }
    }
}

fn bytes(hcbtf: &Hcbtf) -> Vec<u8> {
    write(hcbtf).unwrap_or_else(|problem| panic!("{problem}"))
}

/// All documents that undo leads through, and redo back.
fn all_of(mut history: History<Hcbtf>) -> Vec<Hcbtf> {
    let mut all = vec![history.document().clone()];
    while history.undo().is_some() {
        all.push(history.document().clone());
    }
    while history.redo().is_some() {
        all.push(history.document().clone());
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn everything_can_be_undone_and_redone(seed: u64, count in 1..30usize) {
        let mut random = Edits::new(seed);
        let grid = random.grid();
        let mut history = History::new(Hcbtf::new(grid));
        let mut states = vec![history.document().clone()];
        let mut gesture = 0;
        for _ in 0..count {
            let edit = random.edit(history.document());
            let (revision, before) = (history.revision(), history.document().clone());
            let steps = history.steps().0;
            gesture += u64::from(random.chance(7));
            let applied = history.apply_in(gesture, edit.clone());
            if applied.is_ok() && history.revision() > revision {
                // A further edit of a gesture belongs to the gesture's step.
                if history.steps().0 == steps {
                    states.pop();
                }
                states.push(history.document().clone());
                prop_assert!(write(history.document()).is_ok(), "after {:?}", edit);
            } else {
                prop_assert_eq!(history.document(), &before, "{:?}", edit);
            }
        }
        for _ in 0..2 {
            for state in states.iter().rev().skip(1) {
                prop_assert!(history.undo().is_some());
                prop_assert_eq!(history.document(), state);
            }
            prop_assert!(history.undo().is_none() && history.is_saved());
            prop_assert_eq!(bytes(history.document()), bytes(&states[0]));
            for state in &states[1..] {
                prop_assert!(history.redo().is_some());
                prop_assert_eq!(history.document(), state);
            }
            prop_assert!(history.redo().is_none());
            prop_assert_eq!(bytes(history.document()), bytes(&states[states.len() - 1]));
        }
    }

    #[test]
    fn a_journal_gives_back_every_stroke(seed: u64, before in 0..8usize, after in 0..12usize) {
        let folder = tempfile::tempdir().unwrap();
        let mut random = Edits::new(seed);
        let mut history = History::new(Hcbtf::new(random.grid()));
        for _ in 0..before {
            let edit = random.edit(history.document());
            let _ = history.apply(edit);
        }
        let slot = JournalSlot::new(folder.path()).unwrap();
        let mut journal = Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap();
        for gesture in 0..after as u64 {
            let edit = random.edit(history.document());
            let revision = history.revision();
            let gesture = random.chance(5).then_some(gesture / 2);
            let _ = match gesture {
                Some(gesture) => history.apply_in(gesture, edit.clone()),
                None => history.apply(edit.clone()),
            };
            if history.revision() > revision {
                journal.append(&[Op::Edit { gesture, edit }]).unwrap();
            }
            if random.chance(2) && history.undo().is_some() {
                journal.append::<HcbtfEdit>(&[Op::Undo]).unwrap();
            }
        }
        let found = recover::<Hcbtf>(slot.path())
            .map_err(|problem| TestCaseError::fail(problem.to_string()))?;
        prop_assert!(found.damage.is_empty(), "{:?}", found.damage);
        prop_assert_eq!(all_of(found.history), all_of(history));
        prop_assert!(matches!(recover_any(slot.path()), Ok(RecoveredDocument::Hcbtf(_))));
        slot.discard();
    }
}

/// Edits are read from JSON as they were written.
#[test]
fn edits_are_written_as_json() {
    let mut random = Edits::new(4);
    let mut hcbtf = Hcbtf::new(Grid { size: SIZES[0], ..Grid::THESIS });
    for _ in 0..400 {
        let edit = random.edit(&hcbtf);
        let text = serde_json::to_string(&edit).unwrap();
        assert_eq!(serde_json::from_str::<HcbtfEdit>(&text).unwrap(), edit, "{text}");
        let _ = hcbtf.apply(edit);
    }
    let edit = HcbtfEdit::CopyTile { from: Address::default(), to: Address::new([1, 2], [0, 0]) };
    assert_eq!(
        serde_json::to_string(&edit).unwrap(),
        concat!(
            r#"{"edit":"copy_tile","from":{"light":[0,0],"view":[0,0]},"#,
            r#""to":{"light":[1,2],"view":[0,0]}}"#
        )
    );
}

/// A stroke's edit holds the old texels of its tile, and no more than the texels that it changed.
#[test]
fn a_stroke_is_small_and_goes_on_its_own_tile_alone() {
    let size = [512, 512];
    let mut hcbtf = Hcbtf::new(Grid { size, ..Grid::THESIS });
    let address = Address::default();
    hcbtf.apply(HcbtfEdit::paint(&hcbtf, address, Tile::filled(size, [9, 9, 9, 255]))).unwrap();
    let mut tile = Tile::clone(hcbtf.painted(address).unwrap());
    for at in 0..512 {
        tile.bytes_mut()[4 * (at * 512 + at)] = 200;
    }
    let edit = HcbtfEdit::paint(&hcbtf, address, tile.clone());
    let HcbtfEdit::PatchTile { patch, .. } = &edit else { panic!("{edit:?}") };
    assert_eq!(patch.place(), [0, 0, 512, 512]);
    assert!(patch.memory() < 16_384, "{}", patch.memory());
    let back = hcbtf.apply(edit.clone()).unwrap();
    assert_eq!(**hcbtf.painted(address).unwrap(), tile);
    assert!(hcbtf.apply(edit.clone()).is_err(), "it is painted already");
    assert_eq!(**hcbtf.painted(address).unwrap(), tile);
    assert_eq!(hcbtf.apply(back).unwrap(), edit);
    assert_eq!(hcbtf.painted(address).unwrap().texel(5, 5), [9, 9, 9, 255]);
    // An edit that changes nothing is no step.
    let same = HcbtfEdit::paint(&hcbtf, address, Tile::filled(size, [9, 9, 9, 255]));
    let mut history = History::new(hcbtf);
    history.apply(same).unwrap();
    assert!(history.is_saved());
}
