//! Keys that are selected over all tracks, and what is done with them: moved, scaled, copied,
//! pasted, deleted.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::path::PathBuf;

use chiaro_locale::tr;
use eframe::egui::{Event, Id, Key, Modifiers, Pos2, Rect, Response, Ui};

use super::{LEAST, Timeline, markers, owners};
use crate::commands::{Command, keyboard};
use crate::document::{Edit, Target, TimeKey, TimeKeys};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::frame::Track;
use crate::state::keying::retime;
use crate::state::revision::DocumentNumber;
use crate::state::session::Session;

/// Place of a key: the document of its track, and the indices of the track and of the key in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct KeyAt {
    pub(super) owner: Owner,
    pub(super) track: usize,
    pub(super) key: usize,
}

/// A track with the keys of it that are selected.
#[derive(Clone, PartialEq)]
pub(super) struct PickedTrack {
    pub(super) owner: Owner,
    pub(super) index: usize,
    pub(super) track: TimeKeys,
    pub(super) keys: Vec<usize>,
}

impl PickedTrack {
    /// True if the document has the track just so.
    fn is_in(&self, session: &Session) -> bool {
        let keys = self.owner.keys(session);
        keys.is_some_and(|keys| keys.base.look.time_keys.get(self.index) == Some(&self.track))
    }
}

/// Keys that were copied of a track.
#[derive(Clone)]
struct CopiedKeys {
    owner: Owner,
    target: Target,
    keys: Vec<TimeKey>,
}

/// Track and time of a key, in seconds, by which it is found again where keys before it came or
/// went.
type KeyIdentity = (Target, f64);

/// Origin of the selection: number of the document, and the files of the scene and the shot.
type SelectionPlace = (DocumentNumber, Option<PathBuf>, Option<PathBuf>);

/// Greatest number of selections that an undo may bring back.
const MOST_SELECTIONS: usize = 64;

/// Drag of the selected keys by one of them.
pub(super) struct KeyDrag {
    /// Widget that the drag began at, under which the edits are one step.
    widget: Id,
    /// Place of the pointer when the drag began.
    from: Pos2,
    /// Time of the key that is dragged when the drag began, in seconds.
    time: f64,
    /// Number of the values that is dragged, and its change for a point upward; `None` where keys
    /// move in time alone.
    height: Option<(usize, f64)>,
    picked: Vec<PickedTrack>,
}

/// Selected keys, and how the tracks are shown.
#[derive(Default)]
pub(super) struct KeySheet {
    pub(super) selected: BTreeSet<KeyAt>,
    /// The key that was chosen last.
    pub(super) active: Option<KeyAt>,
    /// Identities of the selected keys, as of the last frame.
    known: HashMap<KeyAt, KeyIdentity>,
    place: Option<SelectionPlace>,
    /// Selections before and after edits of their keys, in the order of the edits: what an undo or
    /// a redo brings back is found by its tracks, since keys that moved have other identities.
    edited: Vec<Vec<PickedTrack>>,
    /// True from an edit of the selected keys until the document has it.
    is_edited: bool,
    /// The selection as of the last frame, once there were edits.
    last: Vec<PickedTrack>,
    /// Tracks that are opened into curves.
    pub(super) open: HashSet<(Owner, Target)>,
    /// Values at the lower and the upper edge of opened tracks.
    pub(super) heights: HashMap<(Owner, Target), [f64; 2]>,
    /// Tracks as they were when a drag began, and the widget that is dragged.
    held: Option<(Id, Vec<PickedTrack>)>,
    /// Drag of keys.
    drag: Option<KeyDrag>,
    /// Corner where a box began, and the keys that were selected before.
    box_from: Option<(Pos2, BTreeSet<KeyAt>)>,
    /// Keys that are shown, and where.
    places: Vec<(KeyAt, Pos2)>,
    copied: Vec<CopiedKeys>,
}

impl KeySheet {
    /// Forgets where keys were shown.
    pub(super) fn begin_frame(&mut self, session: &Session) {
        self.follow(session);
        self.places.clear();
    }

    /// Follows the selected keys to where they are now, and forgets those that are no more, or are
    /// of another document.
    pub(super) fn follow(&mut self, session: &Session) {
        let scene = session.open_scene().and_then(|open_scene| open_scene.path());
        let shot = session.shot().map(|shot| shot.path().to_owned());
        let place = (session.revisions().document, scene.map(PathBuf::from), shot);
        if self.place.as_ref() != Some(&place) {
            let is_new = self.place.replace(place).is_some();
            if is_new {
                self.selected.clear();
                self.known.clear();
                self.edited.clear();
                self.last.clear();
                self.is_edited = false;
                self.drag = None;
            }
        }
        let known = std::mem::take(&mut self.known);
        let now = |at: &KeyAt| match known.get(at) {
            Some(identity) => found(session, *at, identity),
            None => identity(session, *at).map(|_| *at),
        };
        self.active = self.active.filter(|at| self.selected.contains(at)).and_then(|at| now(&at));
        self.selected = self.selected.iter().filter_map(now).collect();
        if std::mem::take(&mut self.is_edited) {
            let now = self.picked(session);
            if !self.edited.contains(&now) {
                self.edited.push(now);
            }
        } else if let Some(earlier) = self.brought_back(session) {
            let keys = |picked: &PickedTrack| {
                let (owner, track) = (picked.owner, picked.index);
                picked.keys.clone().into_iter().map(move |key| KeyAt { owner, track, key })
            };
            self.selected = earlier.iter().flat_map(keys).collect();
            self.active = self.active.filter(|at| self.selected.contains(at));
        }
        self.learn(session);
    }

    /// The selection that was edited, or came of an edit, and that an undo or a redo brought back
    /// since the last frame, in place of one that came of an edit or was edited.
    fn brought_back(&self, session: &Session) -> Option<&[PickedTrack]> {
        let is_there = |state: &[PickedTrack]| state.iter().all(|picked| picked.is_in(session));
        if self.last.is_empty() || is_there(&self.last) || !self.edited.contains(&self.last) {
            return None;
        }
        let places = |state: &[PickedTrack]| -> Vec<(Owner, usize)> {
            state.iter().map(|picked| (picked.owner, picked.index)).collect()
        };
        let of_same = |state: &&Vec<PickedTrack>| places(state) == places(&self.last);
        let mut states = self.edited.iter().rev().filter(of_same);
        states.find(|state| is_there(state)).map(Vec::as_slice)
    }

    /// Notes a selection whose keys are edited.
    fn note_edited(&mut self, picked: Vec<PickedTrack>) {
        match self.edited.iter().position(|state| *state == picked) {
            // What came of it before is not to be redone any more, or is a drag that goes on.
            Some(at) => self.edited.truncate(at + 1),
            None => self.edited.push(picked),
        }
        if self.edited.len() > MOST_SELECTIONS {
            self.edited.remove(0);
        }
        self.is_edited = true;
    }

    /// Learns the identities of keys that were selected in this frame; to be called before edits of
    /// the frame are carried out.
    pub(super) fn learn(&mut self, session: &Session) {
        self.known.retain(|at, _| self.selected.contains(at));
        for at in &self.selected {
            if !self.known.contains_key(at)
                && let Some(identity) = identity(session, *at)
            {
                self.known.insert(*at, identity);
            }
        }
        if !self.edited.is_empty() && !self.is_edited {
            self.last = self.picked(session);
        }
    }

    /// Selects keys of a track that will be as `keys` says, in place of those of it that were.
    fn select(&mut self, picked: &PickedTrack, keys: &TimeKeys, selected: &[usize]) {
        let PickedTrack { owner, index: track, .. } = *picked;
        let is_other = |at: &KeyAt| (at.owner, at.track) != (owner, track);
        self.selected.retain(is_other);
        self.known.retain(|at, _| is_other(at));
        for &key in selected {
            let at = KeyAt { owner, track, key };
            self.selected.insert(at);
            if let Some(of_track) = keys.keys.get(key) {
                self.known.insert(at, (keys.target.clone(), of_track.time));
            }
        }
        self.active = self.active.filter(|at| self.selected.contains(at));
    }

    /// Tells where a key is shown.
    pub(super) fn shown_at(&mut self, key: KeyAt, at: Pos2) {
        self.places.push((key, at));
    }

    /// Selects a key by a press: alone, or with a modifier beside the others.
    pub(super) fn press(&mut self, key: KeyAt, modifiers: Modifiers, is_drag: bool) {
        let adds = modifiers.shift || modifiers.command;
        if adds && !is_drag && self.selected.contains(&key) {
            self.selected.remove(&key);
            return;
        }
        if !(adds || is_drag && self.selected.contains(&key)) {
            self.selected.clear();
        }
        self.selected.insert(key);
        self.active = Some(key);
    }

    /// Tracks with selected keys.
    pub(super) fn picked(&self, session: &Session) -> Vec<PickedTrack> {
        let mut by_track: BTreeMap<(Owner, usize), Vec<usize>> = BTreeMap::new();
        for at in &self.selected {
            by_track.entry((at.owner, at.track)).or_default().push(at.key);
        }
        let picked = |((owner, index), keys): ((Owner, usize), Vec<usize>)| {
            let track = owner.keys(session)?.base.look.time_keys.get(index)?.clone();
            Some(PickedTrack { owner, index, track, keys })
        };
        by_track.into_iter().filter_map(picked).collect()
    }

    /// The tracks as they were when the drag of a widget began; as they are, where it is not
    /// dragged.
    pub(super) fn held_while(
        &mut self,
        session: &Session,
        response: &Response,
    ) -> Vec<PickedTrack> {
        if !response.dragged() && !response.changed() {
            return Vec::new();
        }
        let held = self.held.as_ref().filter(|(id, _)| *id == response.id && response.dragged());
        if let Some((_, picked)) = held.filter(|_| !response.drag_started()) {
            return picked.clone();
        }
        let picked = self.picked(session);
        self.held = Some((response.id, picked.clone()));
        picked
    }

    /// Times of the first and the last selected key, in seconds.
    pub(super) fn range(&self, session: &Session) -> Option<[f64; 2]> {
        let mut range: Option<[f64; 2]> = None;
        for at in &self.selected {
            let keys = at.owner.keys(session)?;
            let time = keys.base.look.time_keys.get(at.track)?.keys.get(at.key)?.time;
            let [low, high] = range.unwrap_or([time, time]);
            range = Some([low.min(time), high.max(time)]);
        }
        range
    }

    /// Replaces tracks, each with the keys of it that are selected then.
    pub(super) fn replace(
        &mut self,
        session: &Session,
        edited: Vec<(PickedTrack, retime::EditedTrack)>,
        widget: Option<Id>,
        out: &mut Vec<Command>,
    ) {
        let before: Vec<PickedTrack> = edited.iter().map(|(picked, _)| picked.clone()).collect();
        // Copies are pasted beside keys that may not be selected.
        if before.iter().all(|picked| !picked.keys.is_empty()) {
            self.note_edited(before);
        }
        let mut edits: BTreeMap<Owner, Vec<Edit>> = BTreeMap::new();
        for (picked, (keys, selected)) in edited {
            self.select(&picked, &keys, &selected);
            let PickedTrack { owner, index: track, .. } = picked;
            let own = owner.keys(session).and_then(|it| it.base.look.time_keys.get(track));
            if own != Some(&keys) {
                edits.entry(owner).or_default().push(Edit::SetTimeKeys { index: track, keys });
            }
        }
        for (owner, edits) in edits {
            send(session, owner, edits, widget, out);
        }
    }

    /// Changes all selected keys without moving them, as one step.
    pub(super) fn change(
        &mut self,
        session: &Session,
        change: impl Fn(&PickedTrack) -> TimeKeys,
        out: &mut Vec<Command>,
    ) {
        let edited = self.picked(session).into_iter().map(|picked| {
            let edited = (change(&picked), picked.keys.clone());
            (picked, edited)
        });
        let edited = edited.collect();
        self.replace(session, edited, None, out);
    }

    /// Moves or scales the keys of tracks as they were when a gesture began.
    pub(super) fn retime(
        &mut self,
        session: &Session,
        held: Vec<PickedTrack>,
        (scale, time): (f64, &dyn Fn(f64) -> f64),
        widget: Option<Id>,
        out: &mut Vec<Command>,
    ) {
        let edited = held.into_iter().map(|picked| {
            let edited = retime::retimed(&picked.track, &picked.keys, scale, time);
            (picked, edited)
        });
        let edited = edited.collect();
        self.replace(session, edited, widget, out);
    }

    /// Deletes the selected keys. A value without its last key is the document's own again.
    pub(super) fn delete(&mut self, session: &Session, out: &mut Vec<Command>) {
        let mut edits: BTreeMap<Owner, Vec<Edit>> = BTreeMap::new();
        let mut emptied = Vec::new();
        for picked in self.picked(session) {
            let left = retime::without(&picked.track, &picked.keys);
            if left.keys.is_empty() {
                emptied.push(picked);
                continue;
            }
            let edit = Edit::SetTimeKeys { index: picked.index, keys: left };
            edits.entry(picked.owner).or_default().push(edit);
        }
        // From the last on, so that indices stay.
        for picked in emptied.into_iter().rev() {
            let Some(keys) = picked.owner.keys(session) else { continue };
            edits.entry(picked.owner).or_default().push(keys.unkey(&picked.track.target));
        }
        for (owner, edits) in edits {
            send(session, owner, edits, None, out);
        }
        self.selected.clear();
    }

    /// Copies the selected keys; true if there are any.
    pub(super) fn copy(&mut self, session: &Session) -> bool {
        let picked = self.picked(session);
        if picked.is_empty() {
            return false;
        }
        let copied = |picked: PickedTrack| {
            let keys = picked.keys.iter().map(|key| picked.track.keys[*key].clone());
            let (owner, keys) = (picked.owner, keys.collect());
            CopiedKeys { owner, target: picked.track.target, keys }
        };
        self.copied = picked.into_iter().map(copied).collect();
        true
    }

    /// True if keys can be pasted.
    pub(super) fn has_copies(&self) -> bool {
        !self.copied.is_empty()
    }

    /// Pastes the copied keys, the first at a time: into their own tracks, or, where they are of
    /// one track, into that of the selected key.
    pub(super) fn paste(&mut self, session: &Session, time: f64, out: &mut Vec<Command>) {
        let all = self.copied.iter().flat_map(|copied| &copied.keys);
        let Some(first) = all.map(|key| key.time).min_by(f64::total_cmp) else { return };
        let copied = self.copied.clone();
        let is_one = copied.len() == 1;
        let tracks = |owner: Owner| {
            owner.keys(session).map(|keys| keys.base.look.time_keys.as_slice()).unwrap_or_default()
        };
        let (mut edited, mut added) = (Vec::new(), BTreeMap::<Owner, Vec<Edit>>::new());
        for CopiedKeys { owner, target, keys } in copied {
            let active = self.active.filter(|at| {
                let track = tracks(at.owner).get(at.track);
                is_one && track.is_some_and(|track| are_alike(&track.keys, &keys))
            });
            let own = tracks(owner).iter().position(|track| track.target == target);
            let place = active.map(|at| (at.owner, at.track)).or(own.map(|track| (owner, track)));
            match place {
                Some((owner, index)) => {
                    let track = tracks(owner)[index].clone();
                    let with = retime::with_copies(&track, &keys, time - first);
                    edited.push((PickedTrack { owner, index, track, keys: Vec::new() }, with));
                }
                None => {
                    let track = TimeKeys::new(target);
                    let (keys, _) = retime::with_copies(&track, &keys, time - first);
                    added.entry(owner).or_default().push(Edit::AddTimeKeys { keys, index: None });
                }
            }
        }
        self.selected.clear();
        self.replace(session, edited, None, out);
        for (owner, edits) in added {
            send(session, owner, edits, None, out);
        }
    }

    /// Begins to drag the selected keys by one of them.
    pub(super) fn begin_drag(
        &mut self,
        ui: &Ui,
        session: &Session,
        widget: Id,
        time: f64,
        height: Option<(usize, f64)>,
    ) {
        let Some(from) = ui.input(|input| input.pointer.press_origin()) else { return };
        self.drag = Some(KeyDrag { widget, from, time, height, picked: self.picked(session) });
    }

    /// Gives up a drag of keys: those that moved go back, and stay selected.
    fn give_up_drag(&mut self, session: &Session, out: &mut Vec<Command>) {
        let Some(KeyDrag { picked, .. }) = self.drag.take() else { return };
        let mut moved = BTreeSet::new();
        for picked in picked {
            let now = picked.owner.keys(session);
            let now = now.and_then(|keys| keys.base.look.time_keys.get(picked.index));
            if now != Some(&picked.track) {
                moved.insert(picked.owner);
            }
            self.select(&picked, &picked.track, &picked.keys);
        }
        // A drag is one step of each document: of the shot alone, where one is open.
        let steps = if session.shot().is_some() { moved.len().min(1) } else { moved.len() };
        out.extend(std::iter::repeat_n(Command::Undo, steps));
    }

    /// Begins and goes on with a box that selects the keys within it.
    pub(super) fn drag_box(&mut self, ui: &Ui, response: &Response) {
        let modifiers = ui.input(|input| input.modifiers);
        if response.drag_started()
            && let Some(from) = ui.input(|input| input.pointer.press_origin())
        {
            let adds = modifiers.shift || modifiers.command;
            let before = if adds { self.selected.clone() } else { BTreeSet::new() };
            self.box_from = Some((from, before));
        }
        if response.clicked() && !(modifiers.shift || modifiers.command) {
            self.selected.clear();
        }
    }

    /// Selects what lies in the box, once all keys are shown; the box is returned while it is
    /// drawn.
    pub(super) fn select_in_box(&mut self, ui: &Ui) -> Option<Rect> {
        let (from, before) = self.box_from.as_ref()?;
        let (is_down, to) = ui.input(|input| {
            (input.pointer.any_down(), input.pointer.interact_pos().unwrap_or(*from))
        });
        let drawn = Rect::from_two_pos(*from, to);
        let inside = self.places.iter().filter(|(_, at)| drawn.contains(*at));
        self.selected = before.iter().copied().chain(inside.map(|(key, _)| *key)).collect();
        self.active = self.selected.last().copied();
        if !is_down {
            self.box_from = None;
        }
        is_down.then_some(drawn)
    }
}

/// Goes on with a drag of keys. The pointer leads and not the widget, for keys change their places
/// among others while they are dragged.
pub(super) fn go_on(
    timeline: &mut Timeline,
    ui: &Ui,
    session: &Session,
    axis: super::Axis,
    out: &mut Vec<Command>,
) {
    let Some(drag) = &timeline.sheet.drag else { return };
    if keyboard::is_escape_pressed(ui.ctx()) {
        return timeline.sheet.give_up_drag(session, out);
    }
    let (is_down, to, is_locked) = ui.input(|input| {
        (input.pointer.any_down(), input.pointer.interact_pos(), input.modifiers.shift)
    });
    if !is_down {
        timeline.sheet.drag = None;
        return;
    }
    let mut by = to.unwrap_or(drag.from) - drag.from;
    if is_locked && drag.height.is_some() {
        if by.x.abs() > by.y.abs() { by.y = 0.0 } else { by.x = 0.0 }
    }
    let wished = drag.time + axis.time(drag.from.x + by.x) - axis.time(drag.from.x);
    let later = if by.x == 0.0 { 0.0 } else { timeline.snapped(wished) - drag.time };
    let moved = drag.picked.iter().map(|picked| {
        let (mut track, mut keys) =
            retime::retimed(&picked.track, &picked.keys, 1.0, |time| retime::tidy(time + later));
        if let Some((at, unit)) = drag.height.filter(|_| by.y != 0.0) {
            track = retime::raised(&track, &keys, at, f64::from(-by.y) * unit);
        }
        keys.dedup();
        (picked.clone(), (track, keys))
    });
    let (moved, widget) = (moved.collect(), drag.widget);
    timeline.sheet.replace(session, moved, Some(widget), out);
}

/// Identity of a key, where it is there.
fn identity(session: &Session, at: KeyAt) -> Option<KeyIdentity> {
    let track = at.owner.keys(session)?.base.look.time_keys.get(at.track)?;
    Some((track.target.clone(), track.keys.get(at.key)?.time))
}

/// Place of a key that was at a place, where it still is there.
fn found(session: &Session, at: KeyAt, (target, time): &KeyIdentity) -> Option<KeyAt> {
    let tracks = &at.owner.keys(session)?.base.look.time_keys;
    let is_it = |track: &TimeKeys| track.target == *target;
    let is_in_place = tracks.get(at.track).is_some_and(is_it);
    let track = if is_in_place { at.track } else { tracks.iter().position(is_it)? };
    let keys = &tracks[track].keys;
    let is_then = |key: &TimeKey| (key.time - time).abs() < 0.5 * LEAST;
    let is_in_place = keys.get(at.key).is_some_and(is_then);
    let key = if is_in_place { at.key } else { keys.iter().position(is_then)? };
    Some(KeyAt { track, key, ..at })
}

/// True if keys of one list can stand among those of the other: their values are of one form.
fn are_alike(a: &[TimeKey], b: &[TimeKey]) -> bool {
    let width = |keys: &[TimeKey]| {
        let ends = crate::document::TrackEnds::default();
        Track { keys, ends, turns: false }.numbers(0).map(|numbers| numbers.len().min(3))
    };
    let (a, b) = (width(a), width(b));
    a.is_some() && a == b
}

/// Sends edits of a document as one: a step of its own, or a part of the one that goes on while a
/// widget is held.
fn send(
    session: &Session,
    owner: Owner,
    mut edits: Vec<Edit>,
    widget: Option<Id>,
    out: &mut Vec<Command>,
) {
    let Some(owned) = OwnedKeys::of(session, owner) else { return };
    let edit = if edits.len() == 1 { edits.remove(0) } else { Edit::Group { edits } };
    out.extend(match widget {
        Some(widget) => owned.held(widget, edit),
        None => owned.once(edit),
    });
}

/// Does what keys of the keyboard ask for while the pointer is over the panel.
pub(super) fn keys(
    timeline: &mut Timeline,
    ui: &Ui,
    session: &Session,
    panel: Rect,
    out: &mut Vec<Command>,
) {
    // Keys that are selected have the focus, which is no field to type into.
    let is_taken = keyboard::is_dialog_open(ui.ctx()) || ui.ctx().text_edit_focused();
    if is_taken || !ui.rect_contains_pointer(panel) {
        return;
    }
    let take = |modifiers, key| keyboard::take(ui, (modifiers, key));
    if take(Modifiers::NONE, Key::F) {
        timeline.fit_selected(session);
    }
    if take(Modifiers::NONE, Key::M) {
        markers::add(session, timeline.snapped(session.view.time), out);
    }
    for (key, way) in [(Key::OpenBracket, -1.0), (Key::CloseBracket, 1.0)] {
        if take(Modifiers::NONE, key)
            && let Some(time) = timeline.neighbor(super::times(session), session, way)
        {
            timeline.go(time, out);
        }
        if take(Modifiers::ALT, key)
            && let Some(time) = timeline.neighbor(markers::times(session), session, way)
        {
            timeline.go(time, out);
        }
    }
    if take(Modifiers::COMMAND, Key::A) {
        let all = owners(session).flat_map(|owned| {
            let tracks = owned.look().time_keys.iter().enumerate();
            tracks.flat_map(move |(track, keys)| {
                (0..keys.keys.len()).map(move |key| KeyAt { owner: owned.owner, track, key })
            })
        });
        timeline.sheet.selected = all.collect();
    }
    if take(Modifiers::COMMAND, Key::D) && timeline.sheet.copy(session) {
        timeline.sheet.active = None;
        timeline.sheet.paste(session, timeline.snapped(session.view.time), out);
    }
    let is_it = |event: &Event| matches!(event, Event::Copy | Event::Cut | Event::Paste(_));
    let is_wanted = !timeline.sheet.selected.is_empty() || timeline.sheet.has_copies();
    let mut events: Vec<Event> = Vec::new();
    if is_wanted {
        ui.input_mut(|input| {
            let (ours, others) = std::mem::take(&mut input.events).into_iter().partition(is_it);
            input.events = others;
            events = ours;
        });
    }
    for event in events {
        match event {
            Event::Copy if timeline.sheet.copy(session) => {
                out.push(Command::Copy(tr!("Keys of the timeline").to_owned()));
            }
            Event::Cut if timeline.sheet.copy(session) => {
                timeline.sheet.delete(session, out);
                out.push(Command::Copy(tr!("Keys of the timeline").to_owned()));
            }
            Event::Paste(_) => {
                timeline.sheet.paste(session, timeline.snapped(session.view.time), out);
            }
            _ => {}
        }
    }
    if !timeline.sheet.selected.is_empty()
        && (take(Modifiers::NONE, Key::Delete) || take(Modifiers::NONE, Key::Backspace))
    {
        timeline.sheet.delete(session, out);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::document::Value;
    use crate::library::Library;

    const LOOK: &str = r##"{"chiaro": "look", "nodes": [{"id": "fill", "kind": "fill_layer"},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "fill", "to": "output.color"}],
        "time_keys": [{"target": "fill.opacity", "keys": [{"time": 0, "value": 0.1},
            {"time": 1, "value": 0.5}, {"time": 2, "value": 0.9}]}]}"##;

    fn opened() -> Session {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.start_from(LOOK, "keys");
        session
    }

    /// Sets the keys of the track to others, each with its time as value.
    fn set(session: &mut Session, times: &[f64]) {
        let mut keys = session.look().time_keys[0].clone();
        let model = keys.keys[0].clone();
        let at = |&time: &f64| TimeKey { time, value: Value::Number(time), ..model.clone() };
        keys.keys = times.iter().map(at).collect();
        session.apply(Edit::SetTimeKeys { index: 0, keys }, None).unwrap();
    }

    /// A sheet with one key selected, after the frame of the press.
    fn pressed(session: &Session, key: usize) -> KeySheet {
        let mut sheet = KeySheet::default();
        sheet.begin_frame(session);
        sheet.press(KeyAt { owner: Owner::Look, track: 0, key }, Modifiers::NONE, false);
        sheet.learn(session);
        sheet
    }

    fn times(sheet: &KeySheet, session: &Session) -> Vec<f64> {
        let track = &session.look().time_keys[0].keys;
        sheet.selected.iter().map(|at| track[at.key].time).collect()
    }

    #[test]
    fn a_selected_key_stays_itself_while_others_come_and_go() {
        let mut session = opened();
        let mut sheet = pressed(&session, 1);
        set(&mut session, &[0.0, 0.5, 0.75, 1.0, 2.0]);
        sheet.begin_frame(&session);
        assert_eq!(times(&sheet, &session), [1.0]);
        assert_eq!(sheet.active.map(|at| at.key), Some(3));
        set(&mut session, &[1.0, 2.0]);
        sheet.begin_frame(&session);
        assert_eq!(times(&sheet, &session), [1.0]);
    }

    #[test]
    fn no_other_key_is_selected_in_place_of_one_that_an_undo_took_back() {
        let mut session = opened();
        set(&mut session, &[0.0, 1.0, 1.5, 2.0]);
        let mut sheet = pressed(&session, 2);
        session.undo();
        sheet.follow(&session);
        assert!(sheet.selected.is_empty() && sheet.active.is_none());
        let mut commands = Vec::new();
        sheet.delete(&session, &mut commands);
        assert!(commands.is_empty(), "{commands:?}");
    }

    #[test]
    fn an_undo_selects_the_keys_that_it_moves_back() {
        let mut session = opened();
        let mut sheet = pressed(&session, 1);
        sheet.press(KeyAt { owner: Owner::Look, track: 0, key: 2 }, Modifiers::SHIFT, false);
        sheet.learn(&session);
        // Twice as slow: the first key comes to where the second was.
        let (held, mut commands) = (sheet.picked(&session), Vec::new());
        sheet.retime(&session, held, (2.0, &|time| 2.0 * time), None, &mut commands);
        sheet.learn(&session);
        set(&mut session, &[0.0, 2.0, 4.0]);
        let mut seen = |session: &Session| {
            sheet.begin_frame(session);
            sheet.learn(session);
            times(&sheet, session)
        };
        assert_eq!(seen(&session), [2.0, 4.0]);
        session.undo();
        assert_eq!(seen(&session), [1.0, 2.0]);
        session.redo();
        assert_eq!(seen(&session), [2.0, 4.0]);
        // Who selected other keys since keeps them.
        sheet.press(KeyAt { owner: Owner::Look, track: 0, key: 0 }, Modifiers::NONE, false);
        sheet.learn(&session);
        session.undo();
        sheet.begin_frame(&session);
        assert_eq!(times(&sheet, &session), [0.0]);
    }

    #[test]
    fn moved_keys_stay_selected_and_another_document_has_none() {
        let mut session = opened();
        let mut sheet = pressed(&session, 1);
        let (held, mut commands) = (sheet.picked(&session), Vec::new());
        let later = |time: f64| time + 0.5;
        sheet.retime(&session, held, (1.0, &later), None, &mut commands);
        sheet.learn(&session);
        assert_eq!(commands.len(), 1);
        set(&mut session, &[0.0, 1.5, 2.0]);
        sheet.begin_frame(&session);
        assert_eq!(times(&sheet, &session), [1.5]);
        // The same keys, at the same times, in another document.
        session.start_from(LOOK, "again");
        set(&mut session, &[0.0, 1.5, 2.0]);
        sheet.begin_frame(&session);
        assert!(sheet.selected.is_empty());
    }

    #[test]
    fn a_drag_that_is_given_up_is_one_step_back_with_its_keys_selected() {
        let mut session = opened();
        let mut sheet = pressed(&session, 1);
        let widget = Id::unique("key");
        let drag = |picked| KeyDrag { widget, from: Pos2::ZERO, time: 1.0, height: None, picked };
        sheet.drag = Some(drag(sheet.picked(&session)));
        let mut commands = Vec::new();
        sheet.give_up_drag(&session, &mut commands);
        assert!(commands.is_empty(), "nothing moved yet: {commands:?}");
        sheet.drag = Some(drag(sheet.picked(&session)));
        set(&mut session, &[0.0, 1.5, 2.0]);
        sheet.give_up_drag(&session, &mut commands);
        assert_eq!(commands, [Command::Undo]);
        assert!(sheet.drag.is_none());
        session.undo();
        sheet.begin_frame(&session);
        assert_eq!(times(&sheet, &session), [1.0]);
    }
}
