//! What each node is held to, and how. Exact tiers err by rounding alone; cheaper ones by what their files state.

use super::case::Case;
use super::slot::{Numbers, Slot};
use crate::document::Tier;
use crate::library::Library;

/// Relative to the output's range, which is 1 or, where that is more, the largest number of the true result.
pub const DEFAULT: f64 = 2e-6;

/// How a result is held against the truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judging {
    /// By its distance from the truth.
    Plain,
    /// By its distance from all that the truth gives within four units in the last place of each input: steep or
    /// cancelling, where rounding of the inputs themselves decides. Such a result is right for inputs that no f32 can
    /// tell from the given ones; anything worse still shows.
    Steep,
    /// The same, but by the distance from the nearest of these results, and not from what lies between them: steps.
    Steps,
}

/// A node that is held to something else than [`DEFAULT`], and why.
#[derive(Clone, Copy, Debug)]
pub struct Exception {
    /// The kind of node.
    pub node: &'static str,
    /// A word of one of its choices; empty for all.
    pub word: &'static str,
    /// The bound of its exact tier.
    pub bound: f64,
    /// How it is judged.
    pub judging: Judging,
    /// Why.
    pub reason: &'static str,
}

const fn exception(
    node: &'static str,
    word: &'static str,
    bound: f64,
    judging: Judging,
    reason: &'static str,
) -> Exception {
    Exception { node, word, bound, judging, reason }
}

/// Every exception; the first that fits counts.
pub const EXCEPTIONS: &[Exception] = &[];

/// The exception that a case falls under.
pub fn exception_of(case: &Case) -> Option<&'static Exception> {
    let fits = |exception: &&Exception| {
        exception.node == case.node
            && (exception.word.is_empty() || case.choices.values().any(|word| word == exception.word))
    };
    EXCEPTIONS.iter().find(fits)
}

/// How a case is judged.
pub fn judging(case: &Case) -> Judging {
    exception_of(case).map_or(Judging::Plain, |exception| exception.judging)
}

/// What a case is held to, relative to the output's range.
pub fn bound(case: &Case, library: &Library) -> f64 {
    let exact = exception_of(case).map_or(DEFAULT, |exception| exception.bound);
    if case.tier == Tier::Exact {
        return exact;
    }
    let def = library.nodes.get(&case.node);
    exact + def.and_then(|def| def.error_of(case.tier)).map_or(0.0, |error| error.bound)
}

/// Whether a sample lies where the tier's file states a bound; elsewhere the result must be finite, and no more.
pub fn is_stated(case: &Case, slots: &[Slot], numbers: &Numbers) -> bool {
    if case.tier == Tier::Exact {
        return true;
    }
    let of = |name: &str| slots.iter().position(|slot| slot.name == name).map(|index| &numbers[index]);
    let length = of("normal").map_or(1.0, |n| n.iter().map(|x| x * x).sum::<f64>().sqrt());
    let is_narrow = case.node == "profile" && {
        let at = |name: &str| of(name).map_or(0.0, |x| x[0]);
        let tau = at("offset").clamp(0.0, std::f64::consts::PI);
        let c = at("cutoff").clamp(tau, std::f64::consts::PI);
        let f = at("falloff").clamp(tau, c);
        f - tau < 0.05
    };
    (1e-15..1e18).contains(&length) && !is_narrow
}
