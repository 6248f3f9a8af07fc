//! Numbers as people read them: sizes in a handy unit, and counts with their nouns.

use chiaro_locale::trn;

/// Text of a number of bytes, in a unit of a handy size.
pub fn bytes(bytes: u64) -> String {
    let kib = bytes as f64 / 1024.0;
    let mib = kib / 1024.0;
    match bytes {
        0..1024 => trn!(bytes, "{bytes} byte", "{bytes} bytes"),
        // Sizes that would read 1024.0 KiB read 1.00 MiB.
        _ if kib < 1023.95 => format!("{kib:.1} KiB"),
        _ if mib < 9.995 => format!("{mib:.2} MiB"),
        _ => format!("{mib:.1} MiB"),
    }
}

/// Text of a count with a noun that takes an `s`: `1 image`, `2 images`.
pub fn count(number: u64, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_a_unit_that_shows_something() {
        for (size, told) in [
            (0, "0 bytes"),
            (1, "1 byte"),
            (1023, "1023 bytes"),
            (1024, "1.0 KiB"),
            (1_480, "1.4 KiB"),
            ((1 << 20) - 1, "1.00 MiB"),
            (1 << 20, "1.00 MiB"),
            (10 << 20, "10.0 MiB"),
            (3 << 29, "1536.0 MiB"),
        ] {
            assert_eq!(bytes(size), told, "{size}");
        }
        assert_eq!(
            [count(0, "image"), count(1, "image"), count(2, "image")],
            ["0 images", "1 image", "2 images"]
        );
    }
}
