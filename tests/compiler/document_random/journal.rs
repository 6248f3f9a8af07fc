//! A journal gives back the work that was written to it, wherever it is cut off and whatever
//! follows its end.

use std::fs;
use std::path::Path;

use crate::support::chiaro_files::journal::{
    DocumentInfo, Journal, JournalSlot, Op, left_behind, recover,
};
use chiaro_compiler::document::{Edit, History, Look};
use proptest::prelude::*;

use super::random::Random;

/// All states of a history with their texts: the document, the states that undo leads through, and
/// those that redo leads through.
fn all_of(history: &History<Look>) -> Vec<(String, Look)> {
    let mut history = history.clone();
    let mut all = vec![(history.document().to_text(), history.document().clone())];
    let (done, undone) = history.steps();
    for _ in 0..done {
        all.push((history.undo().expect("there are more").to_owned(), history.document().clone()));
    }
    for _ in 0..done + undone {
        all.push((history.redo().expect("there are more").to_owned(), history.document().clone()));
    }
    assert!(history.redo().is_none());
    all
}

/// Random work, and the journal of it.
struct RandomJournal {
    /// Size of the journal and state of the history after each line of the journal. The first is
    /// the beginning.
    stages: Vec<(u64, History<Look>)>,
    bytes: Vec<u8>,
}

/// Does random work with a journal: gestures of several edits, undo, redo, and now and then a
/// journal begun anew.
fn work(random: &mut Random, lines: usize, folder: &Path) -> RandomJournal {
    let slot = JournalSlot::new(folder).unwrap();
    let about = DocumentInfo { name: "a look".into(), ..DocumentInfo::default() };
    let look = random.look();
    let source = look.to_text();
    let mut history = History::new(look);
    // Edits from before the journal is begun.
    for gesture in 0..random.below(4) as u64 {
        let _ = history.apply_in(gesture, random.edit(history.document()));
    }
    let mut journal = Journal::begin(&slot, &about, Some(&source), &history).unwrap();
    let mut stages = vec![(journal.size(), history.clone())];
    let mut gesture = 10;
    for _ in 0..lines {
        if random.chance(1) {
            // Begun anew as after a save.
            history.mark_saved();
            journal = Journal::begin(&slot, &about, Some(&source), &history).unwrap();
            stages = vec![(journal.size(), history.clone())];
            continue;
        }
        gesture += u64::from(random.chance(6));
        let mut ops = Vec::new();
        for _ in 0..1 + random.below(3) {
            ops.extend(one(random, &mut history, gesture));
        }
        journal.append(&ops).unwrap();
        if !ops.is_empty() {
            stages.push((journal.size(), history.clone()));
        }
    }
    let bytes = fs::read(slot.path()).unwrap();
    assert_eq!(bytes.len() as u64, journal.size());
    slot.discard();
    RandomJournal { stages, bytes }
}

fn one(random: &mut Random, history: &mut History<Look>, gesture: u64) -> Option<Op<Edit>> {
    match random.below(8) {
        0 => history.undo().is_some().then_some(Op::Undo),
        1 => history.redo().is_some().then_some(Op::Redo),
        kind => {
            let edit = random.edit(history.document());
            let gesture = (kind < 6).then_some(gesture);
            let before = history.revision();
            let _ = match gesture {
                Some(gesture) => history.apply_in(gesture, edit.clone()),
                None => history.apply(edit.clone()),
            };
            (history.revision() > before).then_some(Op::Edit { gesture, edit })
        }
    }
}

/// Asserts that the first `cut` bytes give back the history after the last whole line.
fn check(journal: &RandomJournal, cut: usize, path: &Path) -> Result<(), TestCaseError> {
    let recovered = recover::<Look>(path);
    if cut < journal.stages[0].0 as usize {
        prop_assert!(recovered.is_err());
        return Ok(());
    }
    let (_, expected) = journal.stages.iter().rfind(|(size, _)| *size as usize <= cut).unwrap();
    let recovered = recovered.map_err(|problem| TestCaseError::fail(problem.to_string()))?;
    prop_assert!(recovered.damage.is_empty(), "{:?}", recovered.damage);
    prop_assert_eq!(recovered.history.is_saved(), expected.is_saved());
    prop_assert_eq!(recovered.history.unsaved_steps(), expected.unsaved_steps());
    prop_assert_eq!(all_of(&recovered.history), all_of(expected));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A journal cut at random places, and at both sides of every line's end; also with garbage
    /// behind the cut.
    #[test]
    fn a_journal_cut_anywhere_gives_back_whole_gestures(
        seed: u64,
        size in 0..6usize,
        lines in 1..12usize,
        cuts in prop::collection::vec(any::<prop::sample::Index>(), 6),
        garbage in prop::collection::vec(any::<u8>(), 0..60),
    ) {
        let folder = tempfile::tempdir().unwrap();
        let mut random = Random::new(seed, size);
        let journal = work(&mut random, lines, folder.path());
        let path = folder.path().join("cut");
        let count = journal.bytes.len();
        let ends = journal.stages.iter().map(|(size, _)| *size as usize);
        let edges = ends.flat_map(|end| [end - 1, end]);
        for cut in cuts.iter().map(|cut| cut.index(count + 1)).chain(edges).chain([count]) {
            fs::write(&path, &journal.bytes[..cut]).unwrap();
            check(&journal, cut, &path)?;
            // Garbage behind the cut changes nothing, unless its first byte is the one that was cut
            // off.
            let mends =
                journal.bytes[cut..].first().is_some_and(|byte| garbage.first() == Some(byte));
            if !mends {
                fs::write(&path, [&journal.bytes[..cut], &garbage].concat()).unwrap();
                check(&journal, cut, &path)?;
            }
        }
    }

    /// A journal with one changed byte: all work before the byte comes back, and the loss of the
    /// rest is told.
    #[test]
    fn a_damaged_journal_gives_back_what_it_can(
        seed: u64, at: prop::sample::Index, change in 1..=255u8
    ) {
        let folder = tempfile::tempdir().unwrap();
        let mut journal = work(&mut Random::new(seed, 4), 10, folder.path());
        let path = folder.path().join("damaged");
        let at = at.index(journal.bytes.len());
        journal.bytes[at] ^= change;
        fs::write(&path, &journal.bytes).unwrap();
        match recover::<Look>(&path) {
            Err(problem) => {
                prop_assert!(at < journal.stages[0].0 as usize);
                prop_assert_eq!(problem.code, "damaged-journal");
            }
            Ok(found) => {
                let before = journal.stages.iter().rfind(|(size, _)| *size as usize <= at);
                let texts = |history: &History<Look>| history.document().to_text();
                let is_before =
                    before.is_some_and(|(_, history)| texts(history) == texts(&found.history));
                // A checksum's digit in the other case is no damage.
                let is_all = journal
                    .stages
                    .last()
                    .is_some_and(|(_, history)| texts(history) == texts(&found.history));
                prop_assert!(is_before || is_all);
                let before_last = journal.stages.iter().rev().nth(1);
                // Without the end of the line before it, the last line is one with that.
                let is_in_last = before_last.is_none_or(|(size, _)| at + 1 >= *size as usize);
                prop_assert!(is_all || is_in_last || !found.damage.is_empty());
            }
        }
    }
}

/// One journal cut at every byte.
#[test]
fn every_cut_of_one_journal() {
    let folder = tempfile::tempdir().unwrap();
    let journal = work(&mut Random::new(11, 2), 8, folder.path());
    let path = folder.path().join("cut");
    for cut in 0..=journal.bytes.len() {
        fs::write(&path, &journal.bytes[..cut]).unwrap();
        check(&journal, cut, &path).unwrap();
    }
}

/// A gesture under way comes back as far as it was written, as one step; later edits of that
/// gesture are another step.
#[test]
fn a_gesture_that_went_on_is_a_step_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let slot = JournalSlot::new(folder.path()).unwrap();
    let mut history = History::new(Look::default());
    let mut journal = Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap();
    for name in ["a", "ab", "abc"] {
        let edit = Edit::SetLookName { name: name.into() };
        history.apply_in(7, edit.clone()).unwrap();
        journal.append(&[Op::Edit { gesture: Some(7), edit }]).unwrap();
    }
    drop(slot);
    let slots = left_behind(folder.path());
    let mut found = recover::<Look>(slots[0].path()).unwrap();
    assert_eq!(found.history.document().name, "abc");
    assert!(!found.is_closed);
    found.history.apply_in(7, Edit::SetLookName { name: "later".into() }).unwrap();
    assert_eq!(found.history.unsaved_steps(), Some(2));
    found.history.undo();
    assert_eq!(found.history.document().name, "abc");
    found.history.undo();
    assert_eq!(found.history.document().name, "");
}

/// A journal of much work is bounded: begun anew, it holds the document and its steps, not every
/// edit.
#[test]
fn a_long_drag_does_not_grow_without_end() {
    let folder = tempfile::tempdir().unwrap();
    let slot = JournalSlot::new(folder.path()).unwrap();
    let mut history = History::new(Look::default());
    let mut journal = Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap();
    let mut begun = 0;
    for index in 0..60_000 {
        let edit = Edit::SetLookName { name: format!("{index} {}", "name ".repeat(100)) };
        history.apply_in(1, edit.clone()).unwrap();
        journal.append(&[Op::Edit { gesture: Some(1), edit }]).unwrap();
        if journal.is_grown() {
            begun += 1;
            journal = Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap();
        }
    }
    assert!(begun > 0 && fs::metadata(slot.path()).unwrap().len() < 10 << 20);
    let found = recover::<Look>(slot.path()).unwrap();
    assert_eq!(found.history.document().name, history.document().name);
    assert_eq!(found.history.undo_label(), history.undo_label());
}

/// A file that is a journal of another version or kind, or no journal at all, is refused without a
/// panic.
#[test]
fn what_is_no_journal_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    assert_eq!(recover::<Look>(&path).unwrap_err().code, "cannot-read");
    for text in ["", "\n\n\n", "{}", "0 2 99999999 {}\n", "0 18446744073709551615 00000000 \n"] {
        fs::write(&path, text).unwrap();
        assert_eq!(recover::<Look>(&path).unwrap_err().code, "damaged-journal", "{text:?}");
    }
    let slot = JournalSlot::new(folder.path()).unwrap();
    Journal::begin(
        &slot,
        &DocumentInfo::default(),
        None,
        &History::new(chiaro_compiler::document::Scene::default()),
    )
    .unwrap();
    assert_eq!(recover::<Look>(slot.path()).unwrap_err().code, "damaged-journal");
    assert!(recover::<chiaro_compiler::document::Scene>(slot.path()).is_ok());
}

/// Prints the cost of a journal: `cargo test -p chiaro-compiler --test compiler
/// what_a_journal_costs -- --ignored --nocapture`.
#[test]
#[ignore = "measures"]
#[allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]
fn what_a_journal_costs() {
    use chiaro_compiler::document::{GraphId, Node, Value};
    use chiaro_language::clock::Clock;
    let timed = |what: &str, count: u32, mut work: Box<dyn FnMut(u32) + '_>| {
        let mut each: Vec<f64> = (0..count)
            .map(|index| {
                let clock = Clock::start();
                work(index);
                clock.seconds() * 1e6
            })
            .collect();
        each.sort_by(f64::total_cmp);
        let at = |part: usize| each[(each.len() - 1) * part / 100];
        println!("{what}: median {:.1}, p95 {:.1}, most {:.1} us", at(50), at(95), at(100));
    };
    for nodes in [200, 5000] {
        println!("{nodes} nodes");
        let folder = tempfile::tempdir().unwrap();
        let slot = JournalSlot::new(folder.path()).unwrap();
        let mut look = Look::default();
        for index in 0..nodes {
            let mut node = Node {
                kind: "light_layer".into(),
                position: [f64::from(index), 7.5],
                ..Node::default()
            };
            node.values.insert("offset".into(), Value::Number(0.1));
            node.values.insert("convex".into(), Value::Vector(vec![0.1, 0.2, 0.3]));
            look.graph.nodes.insert(format!("layer_{index}").as_str().into(), node);
        }
        let mut history = History::new(look);
        let value = |index: u32| Edit::SetValue {
            graph: GraphId::Look,
            id: format!("layer_{}", index % nodes).as_str().into(),
            port: "offset".into(),
            value: Value::Number(f64::from(index) * 0.001 + 1.0),
            index: None,
        };
        let mut journal = Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap();
        timed(
            "append a value",
            1000,
            Box::new(|index| {
                journal.append(&[Op::Edit { gesture: None, edit: value(index) }]).unwrap();
            }),
        );
        for index in 0..1000 {
            history.apply(value(index)).unwrap();
        }
        timed("the same with the disk waited for", 20, Box::new(|_| journal.sync().unwrap()));
        let clock = Clock::start();
        let found = recover::<Look>(slot.path()).unwrap();
        println!("recover after 1000 edits: {:.1} ms", clock.seconds() * 1e3);
        assert_eq!(found.history.document(), history.document());
        timed("clone the history", 20, Box::new(|_| drop(history.clone())));
        timed(
            "begin anew with it",
            20,
            Box::new(|_| {
                drop(Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap());
            }),
        );
        println!("{} bytes then", fs::metadata(slot.path()).unwrap().len());
        let positions: indexmap::IndexMap<_, _> =
            history.document().graph.nodes.keys().map(|id| (id.clone(), [1.25, 2.5])).collect();
        let edit = Edit::MoveNodes { graph: GraphId::Look, positions };
        let mut journal = Journal::begin(&slot, &DocumentInfo::default(), None, &history).unwrap();
        timed(
            "append a move of all nodes",
            20,
            Box::new(|_| {
                journal.append(&[Op::Edit { gesture: None, edit: edit.clone() }]).unwrap();
            }),
        );
    }
}
