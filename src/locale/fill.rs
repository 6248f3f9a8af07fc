//! Values filled into a text.

use std::fmt::{Arguments, Write as _};

/// Fills values into a text: `{inside}` becomes the value of that name, a doubled brace one brace.
/// Braces that name no value stay, so that a faulty translation is seen and not lost.
pub fn fill(text: &str, values: &[(&str, Arguments<'_>)]) -> String {
    let mut filled = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some(at) = rest.find(['{', '}']) {
        filled.push_str(&rest[..at]);
        let (brace, after) = (&rest[at..=at], &rest[at + 1..]);
        let field = after.find('}').filter(|_| brace == "{").and_then(|end| {
            let value = values.iter().find(|(inside, _)| *inside == &after[..end])?;
            Some((value.1, &after[end + 1..]))
        });
        rest = match (after.strip_prefix(brace), field) {
            (Some(after), _) => {
                filled.push_str(brace);
                after
            }
            (None, Some((value, after))) => {
                // A String takes all that is written.
                let _ = filled.write_fmt(value);
                after
            }
            (None, None) => {
                filled.push_str(brace);
                after
            }
        };
    }
    filled.push_str(rest);
    filled
}

#[cfg(test)]
mod tests {
    use super::fill;

    #[test]
    fn values_stand_where_they_are_named() {
        assert_eq!(
            fill("{b} vor {a}", &[("a", format_args!("1")), ("b", format_args!("2"))]),
            "2 vor 1"
        );
        assert_eq!(fill("{{{a:.1}}}", &[("a:.1", format_args!("0.5"))]), "{0.5}");
        assert_eq!(fill("{nothing} } {", &[]), "{nothing} } {");
    }
}
