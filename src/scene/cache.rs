//! Values that take long to make, kept in the [cache](crate::files::cache) of the program, if it
//! has one.
//!
//! A value goes by everything that it is made of: what its maker was given, and the sources of this
//! crate and of documents, with the versions of other crates. So another code, or another content,
//! never finds an old value.

use std::hash::Hash;

use crate::clock::Clock;
use crate::files::cache::{CacheKey, opened};

/// Hash of the sources that make values, from the build script.
const SOURCES: &str = env!("CHIARO_SCENE_SOURCES");

/// Time that it takes to make a value worth keeping, in seconds, beside the time to read it.
const LEAST_SECONDS: f64 = 0.02;
/// Rate at which entries are read and checked, in bytes a second.
const BYTES_A_SECOND: f64 = 4e8;

/// Value that the cache can hold.
pub(crate) trait CachedValue: Sized {
    /// Appends the value to an entry.
    fn write(&self, entry: &mut EntryWriter);

    /// Reads the value from an entry; `None` where the entry holds no such value.
    fn read(entry: &mut EntryReader<'_>) -> Option<Self>;
}

/// Value of a kind that is made of `sources`: from the cache, or else made, and kept if making it
/// took longer than reading it will.
///
/// # Errors
/// Those of `make`.
pub(crate) fn cached<T: CachedValue, E>(
    kind: &str,
    sources: &impl Hash,
    make: impl FnOnce() -> Result<T, E>,
) -> Result<T, E> {
    let Some(cache) = opened() else { return make() };
    let key = CacheKey::of(&(SOURCES, kind, sources));
    if let Some(value) = cache.find(key, |content| T::read(&mut EntryReader(content))) {
        return Ok(value);
    }
    let clock = Clock::start();
    let value = make()?;
    let seconds = clock.seconds();
    if seconds > LEAST_SECONDS {
        let mut entry = EntryWriter::default();
        value.write(&mut entry);
        if seconds > LEAST_SECONDS + entry.0.len() as f64 / BYTES_A_SECOND {
            cache.keep(key, &entry.0);
        }
    }
    Ok(value)
}

/// Writer of an entry's content.
#[derive(Debug, Default)]
pub(crate) struct EntryWriter(Vec<u8>);

impl EntryWriter {
    pub(crate) fn number(&mut self, number: u64) {
        self.0.extend_from_slice(&number.to_le_bytes());
    }

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        self.number(bytes.len() as u64);
        self.0.extend_from_slice(bytes);
    }

    pub(crate) fn words(&mut self, words: impl ExactSizeIterator<Item = u32>) {
        self.number(words.len() as u64);
        self.0.reserve(4 * words.len());
        words.for_each(|word| self.0.extend_from_slice(&word.to_le_bytes()));
    }

    pub(crate) fn vectors<const N: usize>(&mut self, vectors: &[[f32; N]]) {
        self.words(vectors.as_flattened().iter().map(|x| x.to_bits()));
    }
}

/// Reader of an entry's content; every part is `None` where the content ends before it does.
#[derive(Debug)]
pub(crate) struct EntryReader<'b>(&'b [u8]);

impl<'b> EntryReader<'b> {
    #[cfg(test)]
    pub(crate) fn of(entry: &'b EntryWriter) -> Self {
        Self(&entry.0)
    }

    fn take(&mut self, count: usize) -> Option<&'b [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    pub(crate) fn number(&mut self) -> Option<u64> {
        Some(u64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    pub(crate) fn bytes(&mut self) -> Option<&'b [u8]> {
        let count = usize::try_from(self.number()?).ok()?;
        self.take(count)
    }

    pub(crate) fn words(&mut self) -> Option<Vec<u32>> {
        let count = usize::try_from(self.number()?).ok()?;
        let (words, _) = self.take(count.checked_mul(4)?)?.as_chunks::<4>();
        Some(words.iter().map(|word| u32::from_le_bytes(*word)).collect())
    }

    pub(crate) fn vectors<const N: usize>(&mut self) -> Option<Vec<[f32; N]>> {
        let words = self.words()?;
        let (vectors, rest) = words.as_chunks::<N>();
        rest.is_empty().then(|| vectors.iter().map(|vector| vector.map(f32::from_bits)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_and_nothing_of_an_entry_that_is_cut() {
        let vectors = [[1.5_f32, -0.0, f32::MIN_POSITIVE], [0.1, f32::MAX, 3.0]];
        let mut entry = EntryWriter::default();
        entry.number(7);
        entry.bytes(b"name");
        entry.words([1, u32::MAX].into_iter());
        entry.vectors(&vectors);
        let read = |content: &[u8]| {
            let mut entry = EntryReader(content);
            let parts = (entry.number()?, entry.bytes()?.to_vec(), entry.words()?);
            Some((parts, entry.vectors::<3>()?))
        };
        let parts = (7, b"name".to_vec(), vec![1, u32::MAX]);
        assert_eq!(read(&entry.0), Some((parts, vectors.to_vec())));
        for length in 0..entry.0.len() {
            assert_eq!(read(&entry.0[..length]), None, "{length} bytes");
        }
        let mut entry = EntryWriter::default();
        entry.number(u64::MAX);
        assert_eq!(EntryReader(&entry.0).words(), None);
        assert_eq!(EntryReader(&entry.0).bytes(), None);
        entry.0.clear();
        entry.words([1, 2, 3, 4].into_iter());
        assert_eq!(EntryReader(&entry.0).vectors::<3>(), None, "no whole vectors");
    }
}
