//! Search by words: each word of a query begins a word of what is found.

/// Rank of texts in a search, 0 best: the greatest index of a text, the most telling first, that a
/// word of the query is first found in. `None` where a word of the query begins none of their
/// words.
pub(super) fn rank(query: &str, texts: &[&str]) -> Option<usize> {
    if query.trim().is_empty() {
        return Some(0);
    }
    let texts: Vec<String> = texts.iter().map(|text| text.to_lowercase()).collect();
    let query = query.to_lowercase();
    let wanted = parts(&query).filter(|word| !word.is_empty());
    let place =
        |word: &str| texts.iter().position(|text| parts(text).any(|known| known.starts_with(word)));
    wanted.map(place).try_fold(0, |most, place| Some(most.max(place?)))
}

/// Words of a text.
fn parts(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric())
}

#[cfg(test)]
mod tests {
    use super::rank;

    #[test]
    fn words_begin_words_and_the_name_is_best() {
        let of = |query| rank(query, &["Cross-hatching, soft", "pen Ink", "A drinking cup of ink"]);
        assert_eq!(
            (of(""), of("hatch"), of("SOFT, cross"), of("ink")),
            (Some(0), Some(0), Some(0), Some(1))
        );
        assert_eq!((of("hatch cup"), of("rink"), of("ink tea")), (Some(2), None, None));
    }
}
