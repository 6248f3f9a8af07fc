//! Cache of frames: pictures within a bound of memory, by the number of the frame.
//!
//! Frames that are equal have one picture, which counts once. Where room is needed, pictures that
//! no frame has any more are dropped first, the oldest before others; then the frames that are
//! shown last from now on. A frame that would itself be the last is not kept.

use std::collections::{BTreeMap, HashMap, VecDeque};
use std::ops::RangeInclusive;
use std::sync::Arc;

use super::order::PlayOrder;

/// Key of a picture: the hash of all that decides on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct PictureKey(pub(crate) u128);

/// Picture with the frames that have it.
struct CachedPicture<P> {
    picture: Arc<P>,
    bytes: usize,
    /// Number of frames.
    users: usize,
}

/// Cache of frames.
pub(crate) struct FrameCache<P> {
    /// Bound of the memory, and the memory in use, in bytes.
    limit: usize,
    bytes: usize,
    frames: BTreeMap<i32, PictureKey>,
    pictures: HashMap<PictureKey, CachedPicture<P>>,
    /// Pictures that fell out of use, the oldest first; some may be in use again.
    retired: VecDeque<PictureKey>,
}

impl<P> FrameCache<P> {
    /// An empty cache that takes so many bytes.
    pub(crate) fn new(limit: usize) -> Self {
        Self {
            limit,
            bytes: 0,
            frames: BTreeMap::new(),
            pictures: HashMap::new(),
            retired: VecDeque::new(),
        }
    }

    /// Bound of the memory, in bytes.
    pub(crate) fn limit(&self) -> usize {
        self.limit
    }

    /// Memory in use, in bytes.
    pub(crate) fn bytes(&self) -> usize {
        self.bytes
    }

    /// Sets the bound, and drops what is beyond it.
    pub(crate) fn set_limit(&mut self, limit: usize, order: PlayOrder) {
        self.limit = limit;
        while self.bytes > limit && self.drop_one(order, u32::MAX) {}
    }

    /// Numbers of the frames that are kept, with their keys.
    pub(crate) fn frames(&self) -> impl Iterator<Item = (i32, PictureKey)> {
        self.frames.iter().map(|(frame, key)| (*frame, *key))
    }

    pub(crate) fn holds(&self, frame: i32) -> bool {
        self.frames.contains_key(&frame)
    }

    /// Picture of a frame.
    pub(crate) fn get(&self, frame: i32) -> Option<&Arc<P>> {
        self.pictures.get(self.frames.get(&frame)?).map(|of| &of.picture)
    }

    /// Key of a frame's picture.
    pub(crate) fn key(&self, frame: i32) -> Option<PictureKey> {
        self.frames.get(&frame).copied()
    }

    /// Ranges of frames that are kept without a gap.
    pub(crate) fn runs(&self) -> Vec<RangeInclusive<i32>> {
        let mut runs: Vec<RangeInclusive<i32>> = Vec::new();
        for &frame in self.frames.keys() {
            match runs.last_mut() {
                Some(run) if run.end().checked_add(1) == Some(frame) => *run = *run.start()..=frame,
                _ => runs.push(frame..=frame),
            }
        }
        runs
    }

    /// Keeps the picture of a frame; false where there is no room for it.
    pub(crate) fn insert(
        &mut self,
        frame: i32,
        (key, picture, bytes): (PictureKey, Arc<P>, usize),
        order: PlayOrder,
    ) -> bool {
        if self.key(frame) == Some(key) {
            return true;
        }
        if bytes > self.limit {
            return false;
        }
        self.remove(frame);
        if let Some(known) = self.pictures.get_mut(&key) {
            known.users += 1;
            self.frames.insert(frame, key);
            return true;
        }
        let distance = order.distance(frame);
        while self.bytes.saturating_add(bytes) > self.limit {
            if !self.drop_one(order, distance) {
                return false;
            }
        }
        self.bytes += bytes;
        self.pictures.insert(key, CachedPicture { picture, bytes, users: 1 });
        self.frames.insert(frame, key);
        true
    }

    /// True if a picture of so many bytes would be kept for a frame.
    pub(crate) fn has_room(&self, frame: i32, bytes: usize, order: PlayOrder) -> bool {
        let is_unused = |key: &PictureKey| self.pictures.get(key).is_some_and(|of| of.users == 0);
        let distance = order.distance(frame);
        bytes <= self.limit
            && (self.bytes.saturating_add(bytes) <= self.limit
                || self.retired.iter().any(is_unused)
                || self.frames.keys().any(|other| order.distance(*other) > distance))
    }

    /// First frame of the round, from now on, that is not kept and has room.
    pub(crate) fn next_missing(&self, bytes: usize, order: PlayOrder) -> Option<i32> {
        let missing = order.upcoming().find(|frame| !self.holds(*frame))?;
        self.has_room(missing, bytes, order).then_some(missing)
    }

    /// A cache of the same frames that takes at most `limit` bytes; those that are shown last are
    /// left out.
    #[must_use]
    pub(crate) fn copy_within(&self, limit: usize, order: PlayOrder) -> Self {
        let mut copy = Self::new(limit);
        let mut frames: Vec<i32> = self.frames.keys().copied().collect();
        frames.sort_by_key(|frame| order.distance(*frame));
        for frame in frames {
            if let Some(key) = self.key(frame)
                && let Some(of) = self.pictures.get(&key)
            {
                copy.insert(frame, (key, of.picture.clone(), of.bytes), order);
            }
        }
        copy
    }

    /// Takes the pictures from all frames. They stay until room is needed: the same picture may be
    /// a frame's again.
    pub(crate) fn retire(&mut self) {
        for key in std::mem::take(&mut self.frames).into_values() {
            if let Some(of) = self.pictures.get_mut(&key) {
                of.users -= 1;
                if of.users == 0 {
                    self.retired.push_back(key);
                }
            }
        }
    }

    /// Drops everything.
    pub(crate) fn clear(&mut self) {
        *self = Self::new(self.limit);
    }

    fn remove(&mut self, frame: i32) {
        let Some(key) = self.frames.remove(&frame) else { return };
        let Some(of) = self.pictures.get_mut(&key) else { return };
        of.users -= 1;
        if of.users == 0 {
            self.bytes -= of.bytes;
            self.pictures.remove(&key);
        }
    }

    /// Drops the oldest picture out of use, or else the frame that is shown last, if that is after
    /// a frame at `distance`.
    fn drop_one(&mut self, order: PlayOrder, distance: u32) -> bool {
        while let Some(key) = self.retired.pop_front() {
            if self.pictures.get(&key).is_some_and(|of| of.users == 0)
                && let Some(of) = self.pictures.remove(&key)
            {
                self.bytes -= of.bytes;
                return true;
            }
        }
        let far = self.frames.keys().copied().max_by_key(|frame| order.distance(*frame));
        let far = far.filter(|far| distance == u32::MAX || order.distance(*far) > distance);
        far.map(|far| self.remove(far)).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::{LoopMode, Round};
    use super::*;

    fn at(step: u32) -> PlayOrder {
        PlayOrder { round: Round::new([0, 9], LoopMode::Loop), step }
    }

    fn put(cache: &mut FrameCache<u32>, frame: i32, key: u128, order: PlayOrder) -> bool {
        cache.insert(frame, (PictureKey(key), Arc::new(key as u32), 10), order)
    }

    fn kept(cache: &FrameCache<u32>) -> Vec<i32> {
        cache.frames().map(|(frame, _)| frame).collect()
    }

    #[test]
    fn memory_is_bounded_and_what_is_shown_last_goes_first() {
        let mut cache = FrameCache::new(45);
        for frame in 0..4 {
            assert!(put(&mut cache, frame, frame as u128, at(0)));
        }
        assert_eq!((cache.bytes(), kept(&cache)), (40, vec![0, 1, 2, 3]));
        assert!(!put(&mut cache, 4, 4, at(0)), "4 would be the last of all");
        assert!(!cache.has_room(4, 10, at(0)) && cache.next_missing(10, at(0)).is_none());
        // As the playhead moves on, the frame that has just been shown is the last one.
        assert!(cache.has_room(4, 10, at(2)) && cache.next_missing(10, at(2)) == Some(4));
        assert!(put(&mut cache, 4, 4, at(2)));
        assert_eq!((cache.bytes(), kept(&cache)), (40, vec![0, 2, 3, 4]));
        assert!(put(&mut cache, 5, 5, at(2)));
        assert_eq!(kept(&cache), [2, 3, 4, 5]);
        assert!(!cache.insert(6, (PictureKey(9), Arc::new(9), 46), at(2)), "more than the bound");
        assert_eq!(kept(&cache), [2, 3, 4, 5], "nothing makes room for it in vain");
        let copy = cache.copy_within(25, at(3));
        assert_eq!((copy.bytes(), kept(&copy)), (20, vec![3, 4]));
        cache.clear();
        // Frames outside the range go before all others.
        for frame in [20, 1, 2, 3] {
            assert!(put(&mut cache, frame, frame as u128, at(1)));
        }
        assert!(put(&mut cache, 4, 4, at(1)));
        assert_eq!(kept(&cache), [1, 2, 3, 4]);
        cache.set_limit(25, at(3));
        assert_eq!((cache.bytes(), kept(&cache)), (20, vec![3, 4]));
    }

    #[test]
    fn equal_frames_have_one_picture() {
        let mut cache = FrameCache::new(30);
        for frame in 0..6 {
            assert!(put(&mut cache, frame, frame as u128 / 2, at(0)), "held on twos");
        }
        assert_eq!((cache.bytes(), kept(&cache).len()), (30, 6));
        assert!(Arc::ptr_eq(cache.get(2).unwrap(), cache.get(3).unwrap()));
        assert_eq!(cache.runs(), [0..=5]);
        // A picture goes with the last frame that has it.
        cache.remove(2);
        assert_eq!((cache.bytes(), cache.get(3).map(|x| **x)), (30, Some(1)));
        cache.remove(3);
        assert_eq!((cache.bytes(), cache.runs()), (20, vec![0..=1, 4..=5]));
        // Another picture for a frame takes the place of the former one.
        assert!(put(&mut cache, 0, 7, at(0)) && put(&mut cache, 1, 7, at(0)));
        assert_eq!((cache.bytes(), cache.key(1)), (20, Some(PictureKey(7))));
    }

    #[test]
    fn pictures_out_of_use_stay_while_there_is_room() {
        let mut cache = FrameCache::new(40);
        (0..4).for_each(|frame| assert!(put(&mut cache, frame, frame as u128, at(0))));
        cache.retire();
        assert_eq!((cache.bytes(), kept(&cache).len()), (40, 0));
        // After an edit is undone the picture is the same again.
        assert!(put(&mut cache, 1, 1, at(0)));
        assert_eq!(cache.bytes(), 40);
        assert!(cache.has_room(9, 10, at(0)), "for one out of use");
        for (frame, key) in [(2, 12), (3, 13), (4, 14)] {
            assert!(put(&mut cache, frame, key, at(0)));
        }
        assert_eq!((cache.bytes(), kept(&cache)), (40, vec![1, 2, 3, 4]));
        assert!(!put(&mut cache, 9, 19, at(0)));
        cache.clear();
        assert_eq!((cache.bytes(), cache.limit(), cache.runs().len()), (0, 40, 0));
    }
}
