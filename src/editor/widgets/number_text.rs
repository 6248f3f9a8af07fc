//! Numbers as people type them: with a point or a comma before the decimals, in percent, and as
//! simple arithmetic (`1/4`, `24*2`, `-3+1`).

use std::iter::Peekable;
use std::str::Chars;

/// Most letters of a text that is read.
const LONGEST: usize = 100;

/// Finite number that a text says, with spaces anywhere and a minus of either kind.
pub(crate) fn read(text: &str) -> Option<f64> {
    let letter = |letter: char| match letter {
        '\u{2212}' => '-',
        '\u{d7}' | '\u{b7}' => '*',
        '\u{f7}' | ':' => '/',
        other => other,
    };
    let text: String = text.chars().filter(|c| !c.is_whitespace()).map(letter).collect();
    if text.len() > LONGEST {
        return None;
    }
    let mut letters = text.chars().peekable();
    let number = sum(&mut letters)?;
    (letters.next().is_none() && number.is_finite()).then_some(number)
}

/// Reads `product (+ product | - product)*`.
fn sum(letters: &mut Peekable<Chars<'_>>) -> Option<f64> {
    let mut number = product(letters)?;
    while let Some(sign) = letters.next_if(|letter| "+-".contains(*letter)) {
        let next = product(letters)?;
        number = if sign == '+' { number + next } else { number - next };
    }
    Some(number)
}

/// Reads `factor (* factor | / factor)*`.
fn product(letters: &mut Peekable<Chars<'_>>) -> Option<f64> {
    let mut number = factor(letters)?;
    while let Some(sign) = letters.next_if(|letter| "*/".contains(*letter)) {
        let next = factor(letters)?;
        number = if sign == '*' { number * next } else { number / next };
    }
    Some(number)
}

/// Reads a number, or a sum in brackets, with signs before and percent after.
fn factor(letters: &mut Peekable<Chars<'_>>) -> Option<f64> {
    if letters.next_if_eq(&'-').is_some() {
        return factor(letters).map(|number| -number);
    }
    if letters.next_if_eq(&'+').is_some() {
        return factor(letters);
    }
    let number = if letters.next_if_eq(&'(').is_some() {
        let number = sum(letters)?;
        letters.next_if_eq(&')')?;
        number
    } else {
        digits(letters)?
    };
    Some(if letters.next_if_eq(&'%').is_some() { number / 100.0 } else { number })
}

/// Reads digits with decimals and an exponent. One comma is a decimal comma; a number with a point
/// too, or with several commas, is not guessed at.
fn digits(letters: &mut Peekable<Chars<'_>>) -> Option<f64> {
    let mut text = String::new();
    while let Some(letter) =
        letters.next_if(|letter| letter.is_ascii_digit() || ".,".contains(*letter))
    {
        text.push(if letter == ',' { '.' } else { letter });
    }
    // An exponent belongs to digits only, so that no word is one.
    let has_digits = text.contains(|letter: char| letter.is_ascii_digit());
    if has_digits && letters.next_if(|letter| "eE".contains(*letter)).is_some() {
        text.push('e');
        text.extend(letters.next_if(|letter| "+-".contains(*letter)));
        while let Some(digit) = letters.next_if(char::is_ascii_digit) {
            text.push(digit);
        }
    }
    text.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_people_type_them() {
        for (text, number) in [
            ("0.5", 0.5),
            ("0,5", 0.5),
            (",5", 0.5),
            ("5.", 5.0),
            (" 1 000 ", 1000.0),
            ("30%", 0.3),
            ("1/4", 0.25),
            ("0,4*2", 0.8),
            ("24*2", 48.0),
            ("-3+1", -2.0),
            ("\u{2212}3", -3.0),
            ("1e-3", 0.001),
            ("2E2", 200.0),
            ("2-1e0", 1.0),
            ("2*(3-1)/-4", -1.0),
            ("7-2-1", 4.0),
            ("8/2/2", 2.0),
            ("3 \u{d7} 2", 6.0),
        ] {
            let read = read(text);
            assert!(read.is_some_and(|read| (read - number).abs() < 1e-12), "{text}: {read:?}");
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        let long = "1+".repeat(LONGEST) + "1";
        for text in [
            "",
            "abc",
            "nan",
            "inf",
            "1/0",
            "0/0",
            "1.2.3",
            "1,000,000",
            "1,000.5",
            "1+",
            "*2",
            "(1",
            "1)",
            "30x",
            "1e",
            "--",
            "2 3%4",
            "e5",
            &long,
        ] {
            assert_eq!(read(text), None, "{text}");
        }
        assert_eq!(read(&"(".repeat(LONGEST)), None);
    }
}
