//! Sheet of a wedge: pictures of a document under combinations of values, as `chiaro wedge` writes
//! them, with the values of each cell in a JSON beside it.

use std::path::{Path, PathBuf};

use chiaro_locale::tr;
use serde_json::Value as Json;

use crate::document::Value;
use crate::files::read_text;

/// Most cells of a sheet that are listed.
const MOST_CELLS: usize = 10_000;
/// Most sheets of one name.
const MOST_SHEETS: u32 = 10_000;

/// A sheet with the values of its cells.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WedgeSheet {
    /// File of the values.
    pub(crate) path: PathBuf,
    /// The document that was varied, as the command line named it.
    pub(crate) document: PathBuf,
    pub(crate) cells: Vec<WedgeCell>,
}

/// Frames for which the values of a cell are taken into a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum CellScope {
    /// The frame of the cell where keys move a value, else the whole shot.
    #[default]
    AsKeyed,
    /// The whole shot, in place of keys.
    WholeShot,
}

/// A cell of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WedgeCell {
    /// Values by the names that were varied.
    pub(crate) values: Vec<(String, Value)>,
    /// Frame of the picture, where frames were drawn.
    pub(crate) frame: Option<i32>,
    /// Place on the sheet: left and upper edge, width and height, in pixels. `None` in sheets of
    /// older programs.
    pub(crate) place: Option<[u32; 4]>,
}

impl WedgeCell {
    /// The names that were varied, each with its value in words.
    pub(crate) fn lines(&self) -> impl Iterator<Item = (&str, String)> {
        let text = |value: &Value| match value {
            Value::Number(number) => format!("{}", (number * 1e4).round() / 1e4),
            Value::Text(text) => text.clone(),
            other => crate::document::json_of_value(other).to_string(),
        };
        self.values.iter().map(move |(name, value)| (name.as_str(), text(value)))
    }

    /// The values in words.
    pub(crate) fn value_text(&self) -> String {
        let values = self.lines().map(|(name, value)| format!("{name} = {value}"));
        values.collect::<Vec<_>>().join(", ")
    }

    /// The values in words, with the frame.
    pub(crate) fn label(&self) -> String {
        let frame = self.frame.map(|frame| tr!("frame {frame}"));
        std::iter::once(self.value_text()).chain(frame).collect::<Vec<_>>().join(", ")
    }
}

impl WedgeSheet {
    /// The sheet whose values, or whose picture, a file is; `None` for any other file.
    pub(crate) fn read(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_lowercase();
        if !["json", "png"].contains(&ending.as_str()) {
            return None;
        }
        let path = path.with_extension("json");
        // Looks and scenes say what they are in their first line; wedges, too, are small files.
        let text = read_text(&path).ok().filter(|text| text.contains("\"wedge\""))?;
        let json: Json = serde_json::from_str(&text).ok()?;
        if json.get("chiaro")?.as_str()? != "wedge" {
            return None;
        }
        let cell = |cell: &Json| {
            let values = cell.get("values")?.as_object()?.iter();
            let values = values.map(|(name, value)| {
                Some((name.clone(), serde_json::from_value(value.clone()).ok()?))
            });
            let frame = cell.get("frame").and_then(Json::as_i64);
            let frame = frame.and_then(|frame| i32::try_from(frame).ok());
            let place = cell.get("place").cloned();
            let place = place.and_then(|place| serde_json::from_value(place).ok());
            Some(WedgeCell { values: values.collect::<Option<_>>()?, frame, place })
        };
        let cells = json.get("cells")?.as_array()?.iter().take(MOST_CELLS);
        let document = PathBuf::from(json.get("document")?.as_str()?);
        Some(Self { cells: cells.filter_map(cell).collect(), document, path })
    }

    /// Picture of the sheet.
    pub(crate) fn picture(&self) -> PathBuf {
        self.path.with_extension("png")
    }
}

/// Path of a sheet in a folder, without ending, that no sheet has yet: the name, or the name with
/// the next number.
pub(crate) fn free_sheet(folder: &Path, name: &str) -> PathBuf {
    let numbered = |number: u32| match number {
        1 => folder.join(name),
        number => folder.join(format!("{name}-{number}")),
    };
    let is_free = |path: &PathBuf| {
        let parts = ["png", "json"].map(|ending| path.with_added_extension(ending));
        !path.exists() && parts.iter().all(|part| !part.exists())
    };
    let mut paths = (1..MOST_SHEETS).map(numbered);
    paths.find(is_free).unwrap_or_else(|| numbered(MOST_SHEETS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_has_a_name_of_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let name = || {
            let free = free_sheet(folder.path(), "sh010-key-intensity");
            free.file_name().unwrap().to_string_lossy().into_owned()
        };
        assert_eq!(name(), "sh010-key-intensity");
        std::fs::write(folder.path().join("sh010-key-intensity.png"), "").unwrap();
        assert_eq!(name(), "sh010-key-intensity-2");
        std::fs::write(folder.path().join("sh010-key-intensity-2.json"), "").unwrap();
        // Its pictures alone are something of somebody, too.
        std::fs::create_dir(folder.path().join("sh010-key-intensity-3")).unwrap();
        assert_eq!(name(), "sh010-key-intensity-4");
    }
}
