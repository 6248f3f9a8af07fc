//! Texts that are typed or pasted into cells: a value, or a change of the values that are there.

use chiaro_locale::{Text, text, tr};

use crate::document::{ColorSpace, LightField, LightQuantity};
use crate::values;
use crate::widgets::color;

/// Change of numbers by a typed text: `*1.2`, `/2`, `50%`, `+0.1`, `-=0.1`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum RelativeChange {
    Factor(f64),
    Addend(f64),
}

/// Form in which a column's numbers are typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NumberForm {
    /// Number shown for 1 in the document.
    pub(super) scale: f64,
    /// Least and greatest number in the document.
    pub(super) range: [f64; 2],
    /// Count of the numbers.
    pub(super) count: usize,
    /// Text for 0.
    pub(super) zero: Option<Text>,
    pub(super) decimals: usize,
    pub(super) suffix: &'static str,
}

impl NumberForm {
    /// Form of a field's numbers.
    pub(super) fn of(field: LightField) -> Self {
        let is_angle = field.quantity() == LightQuantity::Angle;
        let count = match field.range() {
            Some(_) => 1,
            None => 3,
        };
        let least = if field.quantity() == LightQuantity::Color { 0.0 } else { f64::MIN };
        Self {
            scale: if is_angle { 180.0 / std::f64::consts::PI } else { 1.0 },
            range: field.range().unwrap_or([least, f64::MAX]),
            count,
            zero: (field.quantity() == LightQuantity::Distance).then_some(text!("off")),
            decimals: if is_angle { 1 } else { 3 },
            suffix: if is_angle { "°" } else { "" },
        }
    }

    /// Form of a number without a unit within bounds.
    pub(super) fn plain(range: [f64; 2], suffix: &'static str) -> Self {
        Self { scale: 1.0, range, count: 1, zero: None, decimals: 3, suffix }
    }

    /// The numbers as a cell shows them.
    pub(super) fn text(self, numbers: &[f64]) -> String {
        if let (Some(zero), [0.0]) = (self.zero, numbers) {
            return zero.tr().to_owned();
        }
        let of = |number: &f64| values::number_text(number * self.scale, self.decimals);
        let all: Vec<String> = numbers.iter().map(of).collect();
        all.join("  ") + self.suffix
    }

    /// Numbers after a text was typed over `now`.
    ///
    /// # Errors
    /// The reason why the text is neither numbers nor a change of them, with an example.
    pub(super) fn read(self, text: &str, now: &[f64]) -> Result<Vec<f64>, String> {
        let [least, most] = self.range;
        let within = |number: f64| number.clamp(least, most);
        if let Some(change) = RelativeChange::read(text, least >= 0.0) {
            let changed = now.iter().map(|&number| match change {
                RelativeChange::Factor(factor) => within(number * factor),
                RelativeChange::Addend(addend) => within(number + addend / self.scale),
            });
            return Ok(changed.collect());
        }
        let is_typed = |word: &str| text.trim().to_lowercase() == word.to_lowercase();
        if self.zero.is_some_and(|zero| is_typed(zero.tr()) || is_typed(zero.english())) {
            return Ok(vec![0.0]);
        }
        let numbers = numbers(text).filter(|numbers| numbers.len() == self.count);
        let numbers = numbers.ok_or_else(|| match self.count {
            1 => tr!("\"{text}\" is no number: type 0.5, *1.2, +0.1 or 50%", text = text.trim()),
            count => tr!(
                "\"{text}\" is not {count} numbers: type 0 1 0.5, or *1.2 or +0.1 for all of them",
                text = text.trim()
            ),
        })?;
        Ok(numbers.into_iter().map(|number| within(number / self.scale)).collect())
    }
}

impl RelativeChange {
    /// A change that a text says; `None` for a text that is a value. Where numbers are never below
    /// 0, `-0.1` can only be a change.
    fn read(text: &str, is_never_below_zero: bool) -> Option<Self> {
        let text = text.trim();
        let number = |text: &str| number(text).filter(|number| number.is_finite());
        if let Some(percent) = text.strip_suffix('%') {
            return number(percent).map(|percent| Self::Factor(percent / 100.0));
        }
        for sign in ["*=", "*", "×"] {
            if let Some(rest) = text.strip_prefix(sign) {
                return number(rest).map(Self::Factor);
            }
        }
        for sign in ["/=", "/"] {
            if let Some(rest) = text.strip_prefix(sign) {
                return number(rest).filter(|by| *by != 0.0).map(|by| Self::Factor(1.0 / by));
            }
        }
        for sign in ["+=", "+"] {
            if let Some(rest) = text.strip_prefix(sign) {
                return number(rest).map(Self::Addend);
            }
        }
        if let Some(rest) = text.strip_prefix("-=") {
            return number(rest).map(|by| Self::Addend(-by));
        }
        let rest = text.strip_prefix('-').filter(|_| is_never_below_zero)?;
        number(rest).map(|by| Self::Addend(-by))
    }
}

/// A color after a text was typed over `now`: a hex code, three numbers, or a change.
///
/// # Errors
/// The reason why the text is no color, with an example.
pub(super) fn read_color(text: &str, now: [f64; 3], space: ColorSpace) -> Result<[f64; 3], String> {
    let form = NumberForm { count: 3, ..NumberForm::plain([0.0, f64::MAX], "") };
    let is_change = RelativeChange::read(text, true).is_some();
    if let Some(color) = color::typed_in(text, space).filter(|_| !is_change) {
        return Ok(color);
    }
    let numbers = form.read(text, &now).ok();
    numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok()).ok_or_else(|| {
        tr!("\"{text}\" is no color: type #ffd080, three numbers, or *1.2", text = text.trim())
    })
}

/// True or false as people write it; `None` for another word.
pub(super) fn read_switch(text: &str) -> Option<bool> {
    let typed = text.trim().to_lowercase();
    match typed.as_str() {
        word if word == tr!("on") => Some(true),
        word if word == tr!("off") => Some(false),
        "on" | "yes" | "true" | "1" | "x" => Some(true),
        "off" | "no" | "false" | "0" | "" | "-" => Some(false),
        _ => None,
    }
}

/// The one of several words that a text begins, whatever its capitals. Each has its word as it is
/// shown, and as files have it.
///
/// # Errors
/// All the words.
pub(super) fn read_word<T: Copy>(
    text: &str,
    all: impl Iterator<Item = (T, [&'static str; 2])> + Clone,
) -> Result<T, String> {
    let typed = text.trim().to_lowercase();
    let is_it = |word: &str| word.to_lowercase().starts_with(&typed);
    let found =
        all.clone().find(|(_, words)| !typed.is_empty() && words.iter().any(|word| is_it(word)));
    found.map(|(value, _)| value).ok_or_else(|| {
        let words: Vec<String> = all.map(|(_, [shown, _])| shown.to_lowercase()).collect();
        tr!("\"{text}\" is none of {words}", text = text.trim(), words = words.join(", "))
    })
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    let words = text.split(|c: char| c.is_whitespace() || ",;".contains(c));
    words.filter(|word| !word.is_empty()).map(number).collect()
}

fn number(text: &str) -> Option<f64> {
    let plain = text.trim().trim_end_matches("EV").trim_end_matches('°').trim();
    // A minus sign of typesetters is one, too.
    let number: f64 = plain.replace('−', "-").parse().ok()?;
    number.is_finite().then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_told_from_values() {
        let form = NumberForm::plain([0.0, 10.0], "");
        let of = |text: &str| form.read(text, &[2.0]).map(|numbers| numbers[0]);
        for (text, wanted) in [
            ("0.5", 0.5),
            ("*1.5", 3.0),
            ("/ 4", 0.5),
            ("50%", 1.0),
            ("+0.25", 2.25),
            ("-=0.5", 1.5),
            ("-0.5", 1.5),
            ("-3", 0.0),
            ("*9", 10.0),
        ] {
            assert_eq!(of(text), Ok(wanted), "{text}");
        }
        for text in ["", "*", "/0", "two", "1 2", "nan"] {
            assert!(of(text).is_err(), "{text}");
        }
        let signed = NumberForm::plain([-9.0, 9.0], "");
        assert_eq!(signed.read("-0.5", &[2.0]), Ok(vec![-0.5]), "a value where it can be one");
    }

    #[test]
    fn angles_are_typed_in_degrees_and_distances_switched_off() {
        let outer = NumberForm::of(LightField::Outer);
        let quarter = std::f64::consts::FRAC_PI_2;
        assert_eq!(outer.text(&[quarter]), "90°");
        assert!((outer.read("45°", &[quarter]).unwrap()[0] - quarter / 2.0).abs() < 1e-12);
        assert!((outer.read("+45", &[quarter]).unwrap()[0] - quarter * 1.5).abs() < 1e-12);
        let range = NumberForm::of(LightField::Range);
        assert_eq!(
            (range.text(&[0.0]).as_str(), range.read("Off", &[3.0])),
            ("off", Ok(vec![0.0]))
        );
        let aim = NumberForm::of(LightField::Aim);
        assert_eq!(aim.read("0, 1 -0.5", &[0.0; 3]), Ok(vec![0.0, 1.0, -0.5]));
        assert_eq!(aim.read("*2", &[1.0, 2.0, 3.0]), Ok(vec![2.0, 4.0, 6.0]));
    }

    #[test]
    fn colors_words_and_switches_are_read() {
        let white = [1.0; 3];
        let read = |text| read_color(text, white, ColorSpace::Display);
        assert_eq!(read("#ff0080").unwrap()[..2], [1.0, 0.0]);
        assert_eq!(read("0.5 0.25 1"), Ok([0.5, 0.25, 1.0]));
        assert_eq!(read("50%"), Ok([0.5; 3]));
        assert!(read("warm").is_err());
        let words = [(1, ["Directional"; 2]), (2, ["Point"; 2]), (3, ["Spot"; 2])];
        assert_eq!(read_word("sp", words.into_iter()), Ok(3));
        assert!(read_word("area", words.into_iter()).unwrap_err().contains("directional, point"));
        assert_eq!(
            [read_switch("On"), read_switch("no"), read_switch("maybe")],
            [Some(true), Some(false), None]
        );
    }
}
