use std::fs;

use super::*;

fn look(name: &str) -> Look {
    let text = format!(
        r#"{{"name": "{name}", "lights": {{"b": {{}}, "a": {{"intensity": 0.1}}}},
        "nodes": [{{"id": "base", "kind": "base"}}], "flare": 2}}"#
    );
    Look::read(&text, "test").value.unwrap()
}

fn names(shelf: &SnapshotShelf) -> Vec<&str> {
    shelf.all().map(|snapshot| snapshot.name.as_str()).collect()
}

#[test]
fn snapshots_are_taken_renamed_and_deleted_in_steps() {
    let mut shelf = SnapshotShelf::default();
    let first = shelf.take(&look("one"), 5, StepTime(1)).unwrap().id;
    let second = shelf.take(&look("two"), 6, StepTime(2)).unwrap().id;
    shelf.rename(first, "  Night  ", StepTime(3)).unwrap();
    shelf.rename(first, " ", StepTime(4)).unwrap();
    shelf.delete(second, StepTime(5)).unwrap();
    assert_eq!((names(&shelf), shelf.place()), (vec!["Night"], 4), "an empty name is none");
    assert!(shelf.of(second).is_none() && shelf.delete(second, StepTime(6)).is_err());
    assert!(shelf.undo() && shelf.undo());
    assert_eq!(names(&shelf), ["Snapshot 1", "Snapshot 2"]);
    assert_eq!(shelf.redo_label(), Some("rename Snapshot 1 to Night"));
    assert!(shelf.redo(StepTime(7)) && shelf.undo() && shelf.undo() && shelf.undo());
    assert!(!shelf.undo() && shelf.is_empty());
    let third = shelf.take(&look("three"), 7, StepTime(8)).unwrap();
    assert!(third.id > second, "numbers are not given twice");
    assert_eq!((shelf.redo(StepTime(9)), shelf.times.last()), (false, Some(StepTime(8))));
}

#[test]
fn they_lie_beside_the_look_and_come_back_as_they_were() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("toon.json");
    let mut shelf = SnapshotShelf::beside(Some(&path), &SnapshotShelf::default());
    shelf.write_beside(&path);
    assert!(!file_of(&path).exists(), "nothing is written for nothing");
    shelf.take(&look("one"), 951_782_400, StepTime(1)).unwrap();
    shelf.write_beside(&path);
    assert!(shelf.problem().is_none(), "{:?}", shelf.problem());
    let again = SnapshotShelf::beside(Some(&path), &shelf);
    let read = again.all().next().unwrap();
    let kept = shelf.all().next().unwrap();
    assert!(read.is(kept) && read.id != kept.id);
    assert_eq!(read.look.to_text(), look("one").to_text(), "unknown fields and order stay");
    // Another window adds one: both have both.
    let mut other = again;
    other.take(&look("two"), 7, StepTime(2)).unwrap();
    other.write_beside(&path);
    shelf.take(&look("three"), 8, StepTime(3)).unwrap();
    shelf.write_beside(&path);
    assert_eq!(shelf.all().count(), 3);
    // Under another name the look takes them along.
    let copy = folder.path().join("copy.json");
    shelf.write_beside(&copy);
    assert_eq!(SnapshotShelf::beside(Some(&copy), &shelf).all().count(), 3);
    let journal = SnapshotShelf::from_json(&shelf.to_json(), &shelf);
    assert!(journal.all().zip(shelf.all()).all(|(one, two)| one.is(two)));
}

#[test]
fn what_cannot_be_read_stays_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("toon.json");
    for text in ["{", r#"{"chiaro": "look"}"#, r#"{"chiaro": "snapshots", "version": 9}"#] {
        fs::write(file_of(&path), text).unwrap();
        let mut shelf = SnapshotShelf::beside(Some(&path), &SnapshotShelf::default());
        assert!(shelf.problem().is_some() && shelf.is_empty(), "{text}");
        shelf.take(&look("one"), 5, StepTime(1)).unwrap();
        shelf.write_beside(&path);
        assert!(shelf.problem().unwrap().hints.iter().any(|hint| hint.contains("move it away")));
        assert_eq!(
            (shelf.all().count(), fs::read_to_string(file_of(&path)).unwrap().as_str()),
            (1, text)
        );
    }
    let text = r#"{"chiaro": "snapshots", "version": 1, "snapshots": [
        {"name": "broken", "look": {"nodes": 3}}, {"name": "good", "look": {}}]}"#;
    fs::write(file_of(&path), text).unwrap();
    let mut shelf = SnapshotShelf::beside(Some(&path), &SnapshotShelf::default());
    assert_eq!(names(&shelf), ["good"]);
    assert!(shelf.problem().unwrap().message.contains("a snapshot"));
    shelf.take(&look("one"), 5, StepTime(1)).unwrap();
    shelf.write_beside(&path);
    let written = fs::read_to_string(file_of(&path)).unwrap();
    assert!(written.contains("\"broken\"") && written.contains("Snapshot 2"), "{written}");
}

#[test]
fn their_number_and_their_past_are_bounded() {
    let mut shelf = SnapshotShelf::default();
    for step in 0..MOST as u64 {
        shelf.take(&look("one"), step, StepTime(step)).unwrap();
    }
    let told = shelf.take(&look("one"), 0, StepTime(99)).unwrap_err();
    assert!(told.message.contains("at most 64"), "{told}");
    for step in 0..200 {
        let first = shelf.all().next().unwrap().id;
        shelf.delete(first, StepTime(100 + 2 * step)).unwrap();
        shelf.take(&look("one"), 0, StepTime(101 + 2 * step)).unwrap();
    }
    assert_eq!((shelf.place(), shelf.times.all().count()), (MOST_STEPS, MOST_STEPS));
}
