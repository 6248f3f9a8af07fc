//! Groups of lanes, by the instruction where they continue.

/// Lanes that stand at the same instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LaneGroup {
    pub(super) counter: usize,
    pub(super) lanes: u64,
}

/// Groups of lanes under way; the one with the smallest counter moves.
///
/// A construct's code lies between its entry and its exit, and callees before their callers, so the
/// lanes ahead wait where those behind will pass, and join them there.
#[derive(Debug)]
pub(super) struct LaneGroups {
    pub(super) current: LaneGroup,
    /// Waiting groups, the next to be met last. No two stand at the same instruction.
    waiting: Vec<LaneGroup>,
    /// Counter of the next waiting group.
    limit: usize,
}

impl LaneGroups {
    pub(super) fn new(start: LaneGroup) -> Self {
        Self { current: start, waiting: Vec::new(), limit: usize::MAX }
    }

    /// Chooses the group that moves, after the counter has changed.
    #[inline(always)]
    pub(super) fn settle(&mut self) {
        if self.current.counter >= self.limit {
            self.meet();
        }
    }

    #[cold]
    fn meet(&mut self) {
        let moved = self.current;
        self.wait(moved);
        self.finish();
    }

    /// Ends the current group, and returns true if another goes on.
    pub(super) fn finish(&mut self) -> bool {
        let next = self.waiting.pop();
        self.update();
        if let Some(next) = next {
            self.current = next;
        }
        next.is_some()
    }

    /// Sends each of the current lanes to its `target`.
    pub(super) fn scatter(&mut self, target: impl Fn(usize) -> usize) {
        let mut rest = self.current.lanes;
        let mut is_first = true;
        while rest != 0 {
            let counter = target(rest.trailing_zeros() as usize);
            let mut lanes = 0;
            for lane in (0..u64::BITS as usize).filter(|lane| rest >> lane & 1 != 0) {
                lanes |= u64::from(target(lane) == counter) << lane;
            }
            rest &= !lanes;
            let group = LaneGroup { counter, lanes };
            if is_first {
                self.current = group;
            } else {
                self.wait(group);
            }
            is_first = false;
        }
    }

    /// Sends `lanes` to `target`; the rest of the current group goes on.
    #[inline(always)]
    pub(super) fn branch(&mut self, lanes: u64, target: usize) {
        if lanes == self.current.lanes {
            self.current.counter = target;
        } else if lanes != 0 {
            self.current.lanes &= !lanes;
            self.wait(LaneGroup { counter: target, lanes });
        }
    }

    fn wait(&mut self, group: LaneGroup) {
        match self.waiting.binary_search_by(|other| group.counter.cmp(&other.counter)) {
            Ok(index) => self.waiting[index].lanes |= group.lanes,
            Err(index) => self.waiting.insert(index, group),
        }
        self.update();
    }

    fn update(&mut self) {
        self.limit = self.waiting.last().map_or(usize::MAX, |next| next.counter);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hindmost_move_and_meet_the_rest() {
        let mut groups = LaneGroups::new(LaneGroup { counter: 5, lanes: 0b1111 });
        groups.branch(0b0011, 9);
        groups.settle();
        assert_eq!(groups.current, LaneGroup { counter: 5, lanes: 0b1100 });
        groups.branch(0b0100, 2);
        groups.settle();
        assert_eq!(groups.current, LaneGroup { counter: 2, lanes: 0b0100 });
        groups.current.counter = 9;
        groups.settle();
        assert_eq!(groups.current, LaneGroup { counter: 5, lanes: 0b1000 });
        groups.current.counter = 9;
        groups.settle();
        assert_eq!(groups.current, LaneGroup { counter: 9, lanes: 0b1111 });
        assert!(!groups.finish());
    }

    #[test]
    fn lanes_scatter_and_end_one_group_after_the_other() {
        let mut groups = LaneGroups::new(LaneGroup { counter: 5, lanes: 0b10_1101 });
        groups.scatter(|lane| [7, 0, 7, 3, 0, 20][lane]);
        groups.settle();
        assert_eq!(groups.current, LaneGroup { counter: 3, lanes: 0b1000 });
        assert!(groups.finish());
        assert_eq!(groups.current, LaneGroup { counter: 7, lanes: 0b101 });
        assert!(groups.finish());
        assert_eq!(groups.current, LaneGroup { counter: 20, lanes: 0b10_0000 });
        assert!(!groups.finish());
    }
}
