//! Random edits can be undone and redone, and keep a valid document valid.

use chiaro_compiler::document::{Edit, Editable, GraphId, History, Look, Scene, SceneEdit};
use chiaro_language::diag::Diagnostic;
use chiaro_language::ids::NodeId;
use proptest::prelude::*;

use super::random::Random;

impl Random {
    fn index(&mut self, count: usize) -> Option<usize> {
        self.chance(5).then(|| self.below(count + 2))
    }

    /// A random edit; most can be applied.
    pub(crate) fn edit(&mut self, look: &Look) -> Edit {
        let definitions: Vec<_> = look.definitions.keys().cloned().collect();
        let graph = match self.pick(&definitions) {
            Some(id) if self.chance(4) => GraphId::Definition(id.clone()),
            _ => GraphId::Look,
        };
        let of = look.graph_of(&graph).unwrap();
        let ids: Vec<NodeId> = of.nodes.keys().cloned().collect();
        let kinds: Vec<String> = look.definitions.keys().map(ToString::to_string).collect();
        let id = self
            .pick(&ids)
            .cloned()
            .filter(|_| self.chance(9))
            .unwrap_or_else(|| self.slug().into());
        let light =
            look.lights.keys().nth(self.below(3)).cloned().unwrap_or_else(|| self.slug().into());
        match self.below(35) {
            0 => Edit::AddNode {
                graph,
                id: self.slug().into(),
                node: self.node(&kinds),
                index: self.index(ids.len()),
            },
            1 | 2 => Edit::RemoveNode { graph, id },
            3 => Edit::SetName { graph, id, name: format!("name {}", self.below(9)) },
            4 => Edit::SetKind {
                graph,
                id,
                kind: self.pick(&kinds).cloned().unwrap_or("base".to_owned()),
            },
            29 if self.chance(2) => {
                let for_each = self.chance(2).then(|| self.light_set());
                Edit::SetForEach { graph, id, for_each }
            }
            29 if self.chance(3) => Edit::SetNodeLinks { graph, id, links: self.node_links() },
            29 => Edit::SetMuted { graph, id, muted: self.chance(2) },
            30 => Edit::SetCollapsed { graph, id, collapsed: self.chance(2) },
            31 => Edit::AddNote {
                graph,
                id: self.slug().as_str().into(),
                note: self.note(),
                index: self.index(2),
            },
            32 => match of.notes.keys().next().cloned() {
                Some(note) if self.chance(5) => {
                    Edit::SetNote { graph, id: note, note: self.note() }
                }
                Some(note) => Edit::RemoveNote { graph, id: note },
                None => Edit::SetBookmarks { graph, bookmarks: self.bookmarks() },
            },
            33 => Edit::SetBookmarks { graph, bookmarks: self.bookmarks() },
            5 => Edit::SetTier { graph, id, tier: self.node(&[]).tier },
            6 => Edit::MoveNodes { graph, positions: [(id, [1.5, -2.0])].into() },
            7 => {
                let port = self.slug().as_str().into();
                Edit::SetValue { graph, id, port, value: self.value(), index: self.index(2) }
            }
            8 | 9 => {
                let port = of.nodes.get(&id).and_then(|node| node.values.keys().next().cloned());
                let port = port.unwrap_or("offset".into());
                if self.chance(5) {
                    Edit::ClearValue { graph, id, port }
                } else {
                    Edit::SetValue { graph, id, port, value: self.value(), index: None }
                }
            }
            10..=12 => match self.wire(&ids) {
                Some(wire) => Edit::AddWire {
                    graph,
                    wire,
                    index: self.index(of.wires.len()).filter(|_| self.chance(2)),
                },
                None => Edit::SetLookName { name: "no nodes".to_owned() },
            },
            13 => match self.pick(&of.wires).cloned() {
                Some(wire) => Edit::RemoveWire { graph, wire },
                None => Edit::SetColorSpace { color_space: self.look().color_space },
            },
            14 => Edit::AddFrame {
                graph,
                id: self.slug().as_str().into(),
                frame: self.frame(vec![id]),
                index: None,
            },
            15 => match of.frames.keys().next().cloned() {
                Some(frame) if self.chance(5) => {
                    Edit::SetFrame { graph, id: frame, frame: self.frame(vec![id]) }
                }
                Some(frame) => Edit::RemoveFrame { graph, id: frame },
                None => Edit::SetLookName { name: "no frames".to_owned() },
            },
            16 => Edit::AddLight {
                id: self.slug().as_str().into(),
                light: self.light(),
                index: self.index(2),
            },
            17 => Edit::SetLight { id: light, light: self.light() },
            18 => Edit::RemoveLight { id: light },
            _ => self.other_edit(look, &kinds),
        }
    }

    fn other_edit(&mut self, look: &Look, kinds: &[String]) -> Edit {
        let index = self.below(3);
        let definition = self.pick(kinds).cloned().unwrap_or("g".to_owned());
        let edit = match self.below(16) {
            0 => Some(Edit::AddDefinition {
                id: self.slug().as_str().into(),
                definition: self.definition(kinds),
                index: None,
            }),
            1 => Some(Edit::SetInterface {
                id: definition.as_str().into(),
                label: "group".to_owned(),
                help: String::new(),
                inputs: self.interface(),
                outputs: self.interface(),
            }),
            2 => Some(Edit::RemoveDefinition { id: definition.as_str().into() }),
            3 => self.exposed(look).map(|exposed| Edit::AddExposed { exposed, index: None }),
            4 => self.exposed(look).map(|exposed| Edit::SetExposed { index, exposed }),
            5 => Some(Edit::RemoveExposed { index }),
            6 => Some(Edit::AddDirectionKeys { keys: self.direction_keys(look), index: Some(0) }),
            7 => Some(Edit::SetDirectionKeys { index, keys: self.direction_keys(look) }),
            8 => Some(Edit::RemoveDirectionKeys { index }),
            9 => self.time_keys(look).map(|keys| Edit::AddTimeKeys { keys, index: None }),
            13 => Some(Edit::SetMarkers { markers: self.markers() }),
            14 => Some(Edit::SetAovs { aovs: self.aovs(look) }),
            11 => Some(Edit::SetLookTier { tier: self.look().tier }),
            12 => Some(Edit::SetMaxError { max_error: self.below(256) as f64 / 255.0 }),
            10 => self.time_keys(look).map(|keys| Edit::SetTimeKeys { index, keys }),
            _ => Some(Edit::RemoveTimeKeys { index }),
        };
        edit.unwrap_or(Edit::SetLookName { name: "nothing to key".to_owned() })
    }
}

/// The document of a history, and its text, which also holds the order.
fn all_of(history: &History<Look>) -> (Look, String) {
    (history.document().clone(), history.document().to_text())
}

proptest! {
    #[test]
    fn everything_can_be_undone_and_redone(seed: u64, size in 0..7usize, count in 1..40usize) {
        let mut random = Random::new(seed, size);
        let mut history = History::new(random.look());
        let mut states = vec![all_of(&history)];
        for _ in 0..count {
            let edit = random.edit(history.document());
            let revision = history.revision();
            let before = all_of(&history);
            match history.apply(edit.clone()) {
                Ok(()) if history.revision() > revision => states.push(all_of(&history)),
                // Edits that are impossible or without effect leave the history as it was.
                _ => prop_assert_eq!(&all_of(&history), &before, "{:?}", edit),
            }
            let errors: Vec<_> =
                history.document().check().into_iter().filter(Diagnostic::is_error).collect();
            prop_assert!(errors.is_empty(), "after {:?}: {:?}", edit, errors);
            let text = history.document().to_text();
            prop_assert_eq!(Look::read(&text, "").value.map(|look| look.to_text()), Some(text));
        }
        for _ in 0..2 {
            for state in states.iter().rev().skip(1) {
                prop_assert!(history.undo().is_some());
                prop_assert_eq!(&all_of(&history), state);
            }
            prop_assert!(history.undo().is_none() && history.is_saved());
            for state in &states[1..] {
                prop_assert!(history.redo().is_some());
                prop_assert_eq!(&all_of(&history), state);
            }
            prop_assert!(history.redo().is_none());
        }
    }

    #[test]
    fn edits_are_serialized(seed: u64, size in 0..5usize) {
        let mut random = Random::new(seed, size);
        let look = random.look();
        let edit = random.edit(&look);
        let text = serde_json::to_string(&edit).unwrap();
        prop_assert_eq!(serde_json::from_str::<Edit>(&text).unwrap(), edit);
    }

    #[test]
    fn a_group_is_applied_whole_or_not_at_all(seed: u64, size in 0..5usize, count in 1..8usize) {
        let mut random = Random::new(seed, size);
        let mut look = random.look();
        let before = (look.clone(), look.to_text());
        let mut edits: Vec<Edit> = (0..count).map(|_| random.edit(&look)).collect();
        edits.push(Edit::RemoveNode { graph: GraphId::Look, id: "no such node".into() });
        let group = Edit::Group { edits };
        prop_assert!(look.apply(group).is_err());
        prop_assert_eq!((look.clone(), look.to_text()), before);
    }

    #[test]
    fn scenes_are_undone_too(seed: u64, size in 0..5usize) {
        let mut random = Random::new(seed, size);
        let mut history = History::new(random.scene());
        let start = history.document().to_text();
        for _ in 0..12 {
            let id = history.document().objects.keys().next().cloned().unwrap_or("none".into());
            let edit = match random.below(15) {
                0 => SceneEdit::AddObject {
                    id: random.slug().into(), object: Box::new(random.object()), index: Some(0)
                },
                1 => SceneEdit::RemoveObject { id },
                2 => SceneEdit::SetObject { id, object: Box::new(random.object()) },
                3 => SceneEdit::SetIllumination { rotation: random.rotation() },
                4 => SceneEdit::SetCamera { camera: random.camera() },
                5 => SceneEdit::SetBackdrop { color: None },
                6 => SceneEdit::SetTime { time: random.time() },
                7 => SceneEdit::AddLight {
                    id: random.slug().into(), light: random.light(), index: None
                },
                8 => SceneEdit::SetMaster {
                    group: random.slug().as_str().into(),
                    master: random.chance(2).then(|| random.master()),
                    index: Some(0),
                },
                9 => SceneEdit::SetMutedLights { muted: random.light_set() },
                10 => {
                    let Scene { direction_keys, time_keys, .. } = random.scene();
                    SceneEdit::SetLightKeys { direction_keys, time_keys }
                }
                11 => SceneEdit::RemoveLight { id: random.slug().into() },
                12 => SceneEdit::SetSoloedLights { soloed: random.light_set() },
                13 => SceneEdit::SetOutlines { outlines: random.outlines() },
                14 => SceneEdit::SetMarkers { markers: random.markers() },
                _ => SceneEdit::Group {
                    edits: vec![
                        SceneEdit::SetSceneName { name: "a".into() }, SceneEdit::RemoveObject { id }
                    ]
                },
            };
            let text = serde_json::to_string(&edit).unwrap();
            prop_assert_eq!(&serde_json::from_str::<SceneEdit>(&text).unwrap(), &edit);
            let _ = history.apply(edit);
        }
        let end = history.document().to_text();
        while history.undo().is_some() {}
        prop_assert_eq!(history.document().to_text(), start);
        while history.redo().is_some() {}
        prop_assert_eq!(history.document().to_text(), end);
    }
}

/// Random edits of the tests above can mostly be applied.
#[test]
fn most_random_edits_can_be_applied() {
    let mut applied = 0;
    for seed in 0..1000 {
        let mut random = Random::new(seed, 6);
        let mut look = random.look();
        let edit = random.edit(&look);
        applied += usize::from(look.apply(edit).is_ok());
    }
    assert!(applied > 600, "{applied} of 1000");
}

#[test]
fn labels_of_edits_say_what_undo_takes_back() {
    let mut random = Random::new(1, 3);
    let look = random.look();
    for _ in 0..200 {
        assert!(!look.label(&random.edit(&look)).is_empty());
    }
}
