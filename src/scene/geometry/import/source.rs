//! Bytes of a file, read where they are asked for, so that a file of a gigabyte is nowhere whole.

use std::cell::RefCell;
use std::fmt::Display;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::ops::Range;
use std::rc::Rc;

use chiaro_locale::tr;

use super::report::ImportProblem;
use crate::diag::Diagnostic;
use crate::files::OpenFile;

/// A file, or a part of one. Clones read from the same file.
#[derive(Clone)]
pub(super) struct Source<'f> {
    file: Rc<RefCell<Box<dyn OpenFile + 'f>>>,
    /// The part's bytes in the file.
    range: Range<u64>,
}

impl<'f> Source<'f> {
    /// The whole of a file.
    ///
    /// # Errors
    /// Those of the file.
    pub(super) fn whole(mut file: Box<dyn OpenFile + 'f>) -> io::Result<Self> {
        let length = file.seek(SeekFrom::End(0))?;
        Ok(Self { file: Rc::new(RefCell::new(file)), range: 0..length })
    }

    /// Length in bytes.
    pub(super) fn length(&self) -> u64 {
        self.range.end - self.range.start
    }

    /// A part of this part; `None` where it reaches beyond.
    pub(super) fn part(&self, offset: u64, length: u64) -> Option<Self> {
        let start = self.range.start.checked_add(offset)?;
        let end = start.checked_add(length)?;
        (end <= self.range.end).then(|| Self { file: Rc::clone(&self.file), range: start..end })
    }

    /// The first `most` bytes, or all where there are fewer.
    pub(super) fn head(&self, most: u64) -> Result<Vec<u8>, ImportProblem> {
        let end = self.range.end.min(self.range.start.saturating_add(most));
        Self { range: self.range.start..end, ..self.clone() }.all()
    }

    /// All bytes.
    pub(super) fn all(&self) -> Result<Vec<u8>, ImportProblem> {
        let mut bytes = vec![0; self.length() as usize];
        self.read(0, &mut bytes)?;
        Ok(bytes)
    }

    /// Reads the bytes from `offset` on, as many as there is room for.
    pub(super) fn read(&self, offset: u64, into: &mut [u8]) -> Result<(), ImportProblem> {
        let place = self.part(offset, into.len() as u64).map(|part| part.range.start);
        let mut file = self.file.borrow_mut();
        let read =
            place.ok_or_else(|| io::Error::from(io::ErrorKind::UnexpectedEof)).and_then(|place| {
                file.seek(SeekFrom::Start(place))?;
                file.read_exact(into)
            });
        read.map_err(|why| unreadable(&why).into())
    }
}

/// The error for a file that the system does not read.
pub(super) fn unreadable(why: &dyn Display) -> Diagnostic {
    Diagnostic::error("mesh-read", tr!("the mesh cannot be read: {why}"))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    #[test]
    fn a_part_ends_where_it_ends() {
        let whole = Source::whole(Box::new(Cursor::new([0_u8, 1, 2, 3, 4, 5]))).unwrap();
        let part = whole.part(1, 4).unwrap();
        assert_eq!((whole.length(), part.length()), (6, 4));
        assert_eq!(part.all().unwrap(), [1, 2, 3, 4]);
        assert_eq!(part.head(2).unwrap(), [1, 2]);
        assert_eq!(part.head(9).unwrap(), [1, 2, 3, 4]);
        assert_eq!(part.part(2, 2).unwrap().all().unwrap(), [3, 4]);
        let mut bytes = [0; 2];
        assert!(part.read(1, &mut bytes).is_ok());
        assert_eq!(bytes, [2, 3]);
        assert!(part.read(3, &mut bytes).is_err());
        assert!(part.part(2, 3).is_none() && part.part(u64::MAX, 1).is_none());
    }
}
