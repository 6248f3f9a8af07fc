//! Facts about the arguments of a call, proved by their ranges.

use crate::compile::intervals::{self, Floats, Length, Ranges};
use crate::document::Tier;
use crate::library::{Fact, FactLimit};

/// True if ranges prove all facts.
pub(super) fn all_hold(facts: &[Fact], tier: Tier, arguments: &[Ranges]) -> bool {
    facts.iter().all(|fact| holds(fact, tier, arguments).unwrap_or(false))
}

/// `None` for an argument without numbers.
fn holds(fact: &Fact, tier: Tier, arguments: &[Ranges]) -> Option<bool> {
    let floats = |parameter: usize| {
        intervals::floats(arguments.get(parameter)?).filter(|floats| !floats.is_empty())
    };
    let all = |parameter: usize, holds: &dyn Fn(Floats) -> bool| {
        Some(floats(parameter)?.into_iter().all(|x| !x.nan && !x.is_none() && holds(x)))
    };
    let limit = |limit: &FactLimit, side: fn(Floats) -> f64, pick: fn(f64, f64) -> f64| match limit
    {
        FactLimit::Number(number) => Some(*number),
        FactLimit::Parameter(parameter) => {
            let floats = floats(*parameter)?;
            let is_number = floats.iter().all(|x| !x.nan && !x.is_none());
            is_number.then(|| floats.into_iter().map(side).reduce(pick)).flatten()
        }
    };
    match fact {
        Fact::Tier(least) => Some(tier >= *least),
        Fact::Finite(parameter) => all(*parameter, &|x| {
            let largest = f64::from(f32::MAX);
            x.low >= -largest && x.high <= largest
        }),
        Fact::Unit(parameter) => all(*parameter, &|x| x.length == Length::One),
        Fact::AtLeast(parameter, least) => {
            let least = limit(least, |x| x.high, f64::max)?;
            all(*parameter, &|x| x.low >= least)
        }
        Fact::AtMost(parameter, most) => {
            let most = limit(most, |x| x.low, f64::min)?;
            all(*parameter, &|x| x.high <= most)
        }
        Fact::Below(parameter, most) => {
            let most = limit(most, |x| x.low, f64::min)?;
            all(*parameter, &|x| x.high < most)
        }
        Fact::Within(parameter, most) => all(*parameter, &|x| x.is_within(-most, *most)),
        Fact::Is(parameter, number) => all(*parameter, &|x| x.low == *number && x.high == *number),
    }
}
