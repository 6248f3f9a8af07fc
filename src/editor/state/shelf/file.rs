//! File of a look's snapshots, `NAME.snapshots.json` beside `NAME.json`.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use serde_json::{Value as Json, json};

use super::{LookSnapshot, MOST, SnapshotId, Snapshots};
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::files::{read_text, write_atomic};

/// Word for such a file in its first line.
const KIND: &str = "snapshots";
/// Version of the file's format.
const VERSION: u64 = 1;
/// Seconds of a day.
const DAY: u64 = 86_400;

/// File of the snapshots of the look in a file.
pub(crate) fn file_of(look: &Path) -> PathBuf {
    look.with_extension("snapshots.json")
}

/// The file as it was last read or written.
#[derive(Default)]
pub(super) struct ShelfFile {
    path: PathBuf,
    /// Text of the file; `None` where there is none.
    text: Option<String>,
    /// Entries that cannot be read; they are written back.
    damaged: Vec<Json>,
    /// True if the file is not one of snapshots, or is of a later program: it stays as it is.
    is_foreign: bool,
}

impl ShelfFile {
    /// Reads the snapshots of a file, which are numbered after `last`; with what is wrong with it.
    pub(super) fn read(
        path: &Path,
        last: &mut SnapshotId,
    ) -> ((Snapshots, Self), Option<Diagnostic>) {
        let mut file = Self { path: path.to_path_buf(), ..Self::default() };
        if !path.exists() {
            return ((Vec::new(), file), None);
        }
        let name = path.display().to_string();
        let text = match read_text(path) {
            Ok(text) => text,
            Err(problem) => {
                file.is_foreign = true;
                return ((Vec::new(), file), Some(*problem));
            }
        };
        let json = parsed(&text, &name);
        file.text = Some(text);
        match json {
            Ok(json) => {
                let (list, damaged) = snapshots_of(&json, &name, last);
                let problem = (!damaged.is_empty()).then(|| {
                    let message = trn!(
                        count = damaged.len(),
                        "a snapshot in the file cannot be read",
                        "{count} snapshots in the file cannot be read"
                    );
                    let problem = Diagnostic::warning("damaged-snapshot", message);
                    problem.hint(tr!("they stay in the file as they are")).in_file(name)
                });
                file.damaged = damaged;
                ((list, file), problem)
            }
            Err(problem) => {
                file.is_foreign = true;
                ((Vec::new(), file), Some(*problem))
            }
        }
    }

    /// Snapshots that the file at a path has, where somebody else wrote it.
    ///
    /// # Errors
    /// A diagnostic where what is there must not be written over.
    pub(super) fn others(
        &mut self,
        path: &Path,
        last: &mut SnapshotId,
    ) -> Result<Snapshots, Box<Diagnostic>> {
        let is_own = self.path == path;
        let is_same = match (&self.text, path.exists()) {
            (None, is_there) => !is_there,
            (Some(text), true) => read_text(path).is_ok_and(|found| found == *text),
            // A file that was taken away is written anew.
            (Some(_), false) => true,
        };
        if is_own && is_same && !self.is_foreign {
            return Ok(Vec::new());
        }
        let ((list, file), problem) = Self::read(path, last);
        if file.is_foreign {
            let problem =
                problem.unwrap_or_else(|| Diagnostic::error("not-snapshots", tr!("no file")));
            let hint = tr!("snapshots are not written over it: move it away, and take one more");
            return Err(Box::new(problem.hint(hint)));
        }
        *self = file;
        Ok(list)
    }

    /// Writes snapshots, where the file does not say so already.
    ///
    /// # Errors
    /// A diagnostic with the reason; the file is then as it was.
    pub(super) fn write(
        &mut self,
        path: PathBuf,
        list: &[Arc<LookSnapshot>],
    ) -> Result<(), Box<Diagnostic>> {
        if list.is_empty() && self.damaged.is_empty() && self.text.is_none() {
            return Ok(());
        }
        let text = format!("{:#}\n", json_of(list, &self.damaged));
        if self.path == path && self.text.as_ref() == Some(&text) && path.exists() {
            return Ok(());
        }
        write_atomic(&path, text.as_bytes())?;
        (self.path, self.text, self.is_foreign) = (path, Some(text), false);
        Ok(())
    }
}

/// The text of a file of snapshots as JSON.
fn parsed(text: &str, file: &str) -> Result<Json, Box<Diagnostic>> {
    let wrong = |message: String| {
        Box::new(Diagnostic::error("not-snapshots", message).in_file(file.to_owned()))
    };
    let json: Json = serde_json::from_str(text)
        .map_err(|error| wrong(tr!("snapshots of the look cannot be read: {error}")))?;
    if json.get("chiaro").and_then(Json::as_str) != Some(KIND) {
        return Err(wrong(
            tr!("the file has the name of the look's snapshots, and is none").to_owned(),
        ));
    }
    match json.get("version").and_then(Json::as_u64) {
        Some(VERSION) => Ok(json),
        _ => Err(wrong(tr!("snapshots of the look are of a later version of Chiaro").to_owned())),
    }
}

/// Snapshots as JSON, before entries that could not be read.
pub(super) fn json_of(list: &[Arc<LookSnapshot>], damaged: &[Json]) -> Json {
    let entry = |snapshot: &Arc<LookSnapshot>| {
        let look: Json = serde_json::from_str(&snapshot.look.to_text()).unwrap_or_default();
        json!({"name": snapshot.name, "taken": time_text(snapshot.taken), "look": look})
    };
    let entries: Vec<Json> = list.iter().map(entry).chain(damaged.iter().cloned()).collect();
    json!({"chiaro": KIND, "version": VERSION, "snapshots": entries})
}

/// Snapshots in JSON, numbered after `last`, and entries that cannot be read.
pub(super) fn snapshots_of(
    json: &Json,
    file: &str,
    last: &mut SnapshotId,
) -> (Snapshots, Vec<Json>) {
    let (mut list, mut damaged) = (Vec::new(), Vec::new());
    for entry in json.get("snapshots").and_then(Json::as_array).into_iter().flatten() {
        match snapshot_of(entry, file, SnapshotId(last.0 + 1)) {
            Some(snapshot) if list.len() < MOST => {
                last.0 += 1;
                list.push(Arc::new(snapshot));
            }
            _ => damaged.push(entry.clone()),
        }
    }
    (list, damaged)
}

fn snapshot_of(entry: &Json, file: &str, id: SnapshotId) -> Option<LookSnapshot> {
    let text = entry.get("look")?.to_string();
    let loaded = Look::read(&text, file);
    if loaded.has_errors() {
        return None;
    }
    let look = Arc::new(loaded.value?);
    let name = entry.get("name")?.as_str()?.to_owned();
    let taken = entry.get("taken").and_then(Json::as_str).and_then(seconds_of).unwrap_or(0);
    Some(LookSnapshot { id, name, taken, look, length: text.len() })
}

/// Day, month and year of a number of days since 1970, in the Gregorian calendar.
fn date_of(days: u64) -> [u64; 3] {
    // Years are counted from March, so that a leap day is the last of its year; from
    // https://howardhinnant.github.io/date_algorithms.html.
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let leaps = day_of_era / 1460 + day_of_era / 146_096;
    let year_of_era = (day_of_era + day_of_era / 36_524 - leaps) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    [day, month, era * 400 + year_of_era + u64::from(month <= 2)]
}

/// Number of days from 1970 to a date.
fn days_to([day, month, year]: [u64; 3]) -> Option<u64> {
    let year = year.checked_sub(u64::from(month <= 2))?;
    let (era, year_of_era) = (year / 400, year % 400);
    let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day.checked_sub(1)?;
    let day_of_era = year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year;
    (era * 146_097 + day_of_era).checked_sub(719_468)
}

/// A time in seconds since 1970 as RFC 3339 has it, in UTC.
fn time_text(seconds: u64) -> String {
    let [day, month, year] = date_of(seconds / DAY);
    let rest = seconds % DAY;
    let [hour, minute, second] = [rest / 3600, rest / 60 % 60, rest % 60];
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

/// A time in seconds since 1970 for people, in UTC.
pub(crate) fn date_text(seconds: u64) -> String {
    time_text(seconds).replace('T', " ").get(..16).unwrap_or_default().to_owned() + " UTC"
}

/// Seconds from 1970 to a time as RFC 3339 has it, in UTC.
fn seconds_of(text: &str) -> Option<u64> {
    let (date, time) = text.strip_suffix('Z')?.split_once('T')?;
    let numbers = |text: &str, by: char| -> Option<[u64; 3]> {
        let numbers: Option<Vec<u64>> =
            text.split(by).map(|part| part.parse().ok().filter(|part| *part < 10_000)).collect();
        numbers?.try_into().ok()
    };
    let [year, month, day] = numbers(date, '-')?;
    let [hour, minute, second] = numbers(time, ':')?;
    let is_date = (1..=12).contains(&month) && (1..=31).contains(&day);
    let days = is_date.then(|| days_to([day, month, year]))??;
    Some(days * DAY + hour * 3600 + minute * 60 + second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_written_and_read() {
        for (seconds, text) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_795_859_412, "2026-11-28T09:50:12Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!((time_text(seconds).as_str(), seconds_of(text)), (text, Some(seconds)));
        }
        assert_eq!(date_text(1_795_859_412), "2026-11-28 09:50 UTC");
        for wrong in ["", "yesterday", "2026-13-01T00:00:00Z", "2026-11-28", "1-2-3T4:5:6"] {
            assert_eq!(seconds_of(wrong), None, "{wrong}");
        }
    }
}
