//! Values that a wedge tries, one after another.

use crate::state::hue::neighbors;

/// Number of colors that are tried first.
const COLORS: usize = 5;

/// Way in which a value varies.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ValueSpread {
    /// So many numbers from one to another; angles, in radians, are shown in degrees.
    Numbers { from: f64, to: f64, count: u32, is_angle: bool },
    /// Colors as shown, red, green and blue.
    Colors(Vec<[f64; 3]>),
}

/// Value that varies: its name, as `chiaro wedge --vary` takes it, and how.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Variation {
    pub(crate) target: String,
    pub(crate) spread: ValueSpread,
}

impl Variation {
    /// Numbers around the present one.
    pub(crate) fn around(target: String, now: f64, is_angle: bool) -> Self {
        let tidy = |x: f64| (x * 1e4).round() / 1e4;
        let (from, to) = match now {
            0.0 => (0.0, 1.0),
            now => (tidy(now * 0.5), tidy(now * 1.5)),
        };
        Self { target, spread: ValueSpread::Numbers { from, to, count: 4, is_angle } }
    }

    /// The variation with numbers of a range alone.
    #[must_use]
    pub(crate) fn within(mut self, [least, most]: [f64; 2]) -> Self {
        if let ValueSpread::Numbers { from, to, .. } = &mut self.spread {
            (*from, *to) = (from.max(least).min(most), to.max(least).min(most));
        }
        self
    }

    /// The present color and its neighbors: hues beside it, darker and lighter.
    pub(crate) fn of_color(target: String, now: [f64; 3]) -> Self {
        let mut colors = vec![now.map(|x| x.clamp(0.0, 1.0))];
        while colors.len() < COLORS && push_color(&mut colors) {}
        Self { target, spread: ValueSpread::Colors(colors) }
    }

    /// Number of values.
    pub(crate) fn count(&self) -> usize {
        match &self.spread {
            ValueSpread::Numbers { count, .. } => *count as usize,
            ValueSpread::Colors(colors) => colors.len(),
        }
    }

    /// The word after `--vary`.
    pub(crate) fn word(&self) -> String {
        let values = match &self.spread {
            ValueSpread::Numbers { from, count: 0 | 1, .. } => format!("{from}"),
            ValueSpread::Numbers { from, to, count, .. } => format!("{from}..{to}/{count}"),
            ValueSpread::Colors(colors) => colors.iter().map(hex).collect::<Vec<_>>().join(","),
        };
        format!("{}={values}", self.target)
    }
}

/// Adds the most useful neighbor of the first color that is not there yet; false where there is
/// none.
pub(crate) fn push_color(colors: &mut Vec<[f64; 3]>) -> bool {
    let first = colors.first().copied().unwrap_or([1.0; 3]);
    let known: Vec<String> = colors.iter().map(hex).collect();
    let new = neighbors(first).find(|color| !known.contains(&hex(color)));
    colors.extend(new);
    new.is_some()
}

fn hex(color: &[f64; 3]) -> String {
    let [r, g, b] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_as_the_command_line_takes_them() {
        let word = |spread| Variation { target: "rim.falloff".to_owned(), spread }.word();
        assert_eq!(
            word(ValueSpread::Numbers { from: 0.3, to: 0.6, count: 3, is_angle: false }),
            "rim.falloff=0.3..0.6/3"
        );
        let one = ValueSpread::Numbers { from: 0.3, to: 0.6, count: 1, is_angle: false };
        assert_eq!(word(one), "rim.falloff=0.3");
        let colors = vec![[1.0, 0.5, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(word(ValueSpread::Colors(colors)), "rim.falloff=#ff8000,#0000ff");
        let around = Variation::around("key.intensity".to_owned(), 2.0, false);
        assert_eq!((around.word().as_str(), around.count()), ("key.intensity=1..3/4", 4));
        assert_eq!(around.within([0.0, 2.0]).word(), "key.intensity=1..2/4");
    }
    #[test]
    fn colors_are_tried_around_the_present_one() {
        let of = |color| Variation::of_color("moon.color".to_owned(), color);
        let word = of([0.45, 0.62, 1.0]).word();
        let ValueSpread::Colors(mut colors) = of([0.45, 0.62, 1.0]).spread else { panic!() };
        assert!(word.starts_with("moon.color=#739eff,") && colors.len() == COLORS, "{word}");
        while push_color(&mut colors) {}
        let mut told: Vec<String> = colors.iter().map(hex).collect();
        told.sort_unstable();
        told.dedup();
        assert!(told.len() == colors.len() && colors.len() > 20, "each is another: {told:?}");
        let ValueSpread::Colors(black) = of([0.0; 3]).spread else { panic!() };
        assert!(black.len() > 2 && black[1] != black[0], "{black:?}");
    }
}
