//! Cost of the picture that was drawn last: its time, its passes, and the shares of its layers.

use std::collections::BTreeMap;
use std::sync::Arc;

use chiaro_locale::{tr, trn};

use crate::frame::{Effect, EffectKind, EffectState, FramePlan};
use crate::ids::{NodeId, NodePath};
use crate::library::PassId;

/// Pass of a picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrawnPass {
    pub(crate) id: PassId,
    /// Reason why the pass is needed.
    reason: String,
    /// True if an earlier picture's result was taken.
    is_kept: bool,
}

impl DrawnPass {
    pub(crate) fn label(&self) -> &'static str {
        self.id.title()
    }

    /// Reason and state, as the end of a sentence.
    pub(crate) fn words(&self) -> String {
        let reason = self.reason.replace('`', "\"");
        if self.is_kept { tr!("{reason} (kept from before: no time)") } else { reason }
    }
}

/// Cost of a picture.
#[derive(Clone, Debug, Default)]
pub(crate) struct PictureCost {
    /// Size of the picture, in pixels.
    pub(crate) size: [u32; 2],
    /// Time from the handing over to the GPU to the end of its work, in milliseconds, once known.
    pub(crate) milliseconds: Option<f64>,
    pub(crate) passes: Vec<DrawnPass>,
    /// Operations that are counted in a fragment for each node of the look's own graph.
    pub(crate) operations: Arc<BTreeMap<NodeId, u64>>,
}

impl PictureCost {
    /// Cost of a plan of which `is_kept` tells the passes whose results still stand.
    pub(crate) fn of(plan: &FramePlan, is_kept: impl Fn(PassId, u64) -> bool) -> Self {
        let passes = plan.passes.iter().map(|pass| DrawnPass {
            id: pass.id,
            reason: pass.reason.clone(),
            is_kept: is_kept(pass.id, pass.input_hash),
        });
        Self { size: plan.size, passes: passes.collect(), ..Self::default() }
    }

    /// Counts the operations of nodes.
    pub(crate) fn counted(effects: &[Effect]) -> BTreeMap<NodeId, u64> {
        let mut operations = BTreeMap::new();
        for effect in effects {
            let counts = effect.kind == EffectKind::Node && effect.state == EffectState::Runs;
            let path = effect.node.as_deref().filter(|_| counts).map(NodePath::parse);
            if let Some(id) = path.as_ref().and_then(NodePath::outermost) {
                *operations.entry(id.clone()).or_default() += effect.cost.operations;
            }
        }
        operations
    }

    /// The passes that are not the picture's own.
    pub(crate) fn passes_before(&self) -> impl Iterator<Item = &DrawnPass> {
        self.passes.iter().filter(|pass| pass.id != PassId::LOOK)
    }

    /// The cost in few words.
    pub(crate) fn short(&self) -> String {
        let passes = trn!(count = self.passes.len(), "{count} pass", "{count} passes");
        match self.milliseconds {
            Some(milliseconds) => format!("{} · {passes}", time_text(milliseconds)),
            None => passes,
        }
    }

    /// A share in words: of the time, where that is known.
    pub(crate) fn share_text(&self, share: f64) -> String {
        let percent = share * 100.0;
        match self.milliseconds.map(|time| time_text(time * share)) {
            Some(time) => tr!("{percent:.0} %, some {time}"),
            None => format!("{percent:.0} %"),
        }
    }
}

/// A time in milliseconds, with as many digits as mean something.
pub(crate) fn time_text(milliseconds: f64) -> String {
    match milliseconds {
        time if time < 1.0 => format!("{time:.2} ms"),
        time if time < 10.0 => format!("{time:.1} ms"),
        time => format!("{time:.0} ms"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cost_is_told_in_few_words() {
        let mut cost = PictureCost::default();
        assert_eq!(cost.share_text(0.25), "25 %");
        let pass = |id| DrawnPass { id, reason: "`a` reads it".to_owned(), is_kept: true };
        cost.passes = vec![pass(PassId::LOOK)];
        assert_eq!(cost.short(), "1 pass");
        assert!(cost.passes_before().next().is_none());
        assert_eq!(cost.passes[0].words(), "\"a\" reads it (kept from before: no time)");
        cost.milliseconds = Some(4.16);
        assert_eq!(cost.short(), "4.2 ms · 1 pass");
        assert_eq!(cost.share_text(0.25), "25 %, some 1.0 ms");
        assert_eq!((time_text(0.125), time_text(31.6)), ("0.12 ms".into(), "32 ms".into()));
    }
}
