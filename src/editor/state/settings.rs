//! Settings that the window remembers from one start to the next. A setting that cannot be
//! understood has its default, and members that this version does not know stay in the file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::diag::Diagnostic;
use crate::files::{read_text, write_atomic};
use crate::state::display::DisplayChoice;
use crate::state::languages::LANGUAGES;
use crate::state::paths::absolute;

/// Largest number of recent files.
const MAX_RECENT: usize = 20;
/// Range of the interface's scale.
pub(crate) const SCALE: std::ops::RangeInclusive<f32> = 0.5..=3.0;

/// Memory that frames of playback take by default, in MiB.
pub const DEFAULT_FRAME_MEMORY: u32 = 512;

/// Theme of the interface: dark, light, or the system's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Theme {
    /// Light on dark.
    #[default]
    Dark,
    /// Dark on light.
    Light,
    /// The desktop's own theme.
    System,
}

/// Remembered settings of the window.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Looks, scenes and paintings that were open, the newest first.
    pub recent: Vec<PathBuf>,
    /// Colors of the interface.
    pub theme: Theme,
    /// Scale of the interface: 1 is the system's own.
    pub scale: f32,
    /// Tag of the language that the window speaks; `None` for the system's.
    pub language: Option<String>,
    /// Layout of the panels, as the panels themselves write it.
    pub layout: Option<Value>,
    /// Mesh that looks were last shown on: a path, or `shape:` and a name.
    pub mesh: Option<String>,
    /// True if that mesh lies on its back and was stood up: its z axis points up.
    pub z_is_up: bool,
    /// Columns of the light table that were shown or hidden by hand, by their words.
    pub light_columns: BTreeMap<String, bool>,
    /// Memory that frames of playback take, in MiB.
    pub frame_memory: u32,
    /// Folders of the library that others share.
    pub library_folders: Vec<PathBuf>,
    /// View that the picture is shown by; `None` for the curve of sRGB.
    pub display: Option<DisplayChoice>,
    /// Word of the farm that jobs were last for.
    pub farm: Option<String>,
    /// Settings of other versions, kept as they are.
    unknown: Map<String, Value>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            recent: Vec::new(),
            theme: Theme::default(),
            scale: 1.0,
            language: None,
            layout: None,
            mesh: None,
            z_is_up: false,
            light_columns: BTreeMap::new(),
            frame_memory: DEFAULT_FRAME_MEMORY,
            library_folders: Vec::new(),
            display: None,
            farm: None,
            unknown: Map::new(),
        }
    }
}

impl Settings {
    /// Reads settings; a missing or damaged setting has its default.
    pub fn load(path: &Path) -> Self {
        read_text(path).map_or_else(|_| Self::default(), |text| Self::read(&text))
    }

    fn read(text: &str) -> Self {
        let Ok(Value::Object(mut members)) = serde_json::from_str(text) else {
            return Self::default();
        };
        let mut take = |name: &str| members.remove(name).unwrap_or_default();
        let recent = take("recent").as_array().map_or_else(Vec::new, |paths| {
            let files = paths.iter().filter_map(Value::as_str).map(PathBuf::from);
            files.filter(|path| crate::examples::file(path).is_none()).take(MAX_RECENT).collect()
        });
        let theme = serde_json::from_value(take("theme")).unwrap_or_default();
        let scale = take("scale").as_f64().map_or(1.0, |scale| scale as f32);
        let scale = if SCALE.contains(&scale) { scale } else { 1.0 };
        let language = take("language").as_str().map(str::to_owned);
        let layout = Some(take("layout")).filter(|layout| !layout.is_null());
        let mesh = take("mesh").as_str().map(str::to_owned);
        let z_is_up = take("z_is_up").as_bool().unwrap_or_default();
        let light_columns = serde_json::from_value(take("light_columns")).unwrap_or_default();
        let frame_memory = take("frame_memory").as_u64().and_then(|mib| u32::try_from(mib).ok());
        let frame_memory = frame_memory.filter(|mib| *mib > 0).unwrap_or(DEFAULT_FRAME_MEMORY);
        let folders = take("library_folders");
        let folders = folders.as_array().into_iter().flatten().filter_map(Value::as_str);
        let library_folders = folders.map(PathBuf::from).collect();
        let display = serde_json::from_value(take("display")).unwrap_or_default();
        let farm = take("farm").as_str().map(str::to_owned);
        Self {
            recent,
            theme,
            scale,
            language,
            layout,
            mesh,
            z_is_up,
            light_columns,
            frame_memory,
            library_folders,
            display,
            farm,
            unknown: members,
        }
    }

    fn to_text(&self) -> String {
        let mut members = Map::new();
        let recent = self.recent.iter().filter_map(|path| path.to_str()).map(Value::from).collect();
        members.insert("recent".into(), Value::Array(recent));
        members.insert("theme".into(), serde_json::to_value(self.theme).unwrap_or_default());
        members.insert("scale".into(), self.scale.into());
        members.extend(self.language.clone().map(|tag| ("language".into(), tag.into())));
        members.extend(self.layout.clone().map(|layout| ("layout".into(), layout)));
        members.extend(self.mesh.clone().map(|mesh| ("mesh".into(), mesh.into())));
        if self.z_is_up {
            members.insert("z_is_up".into(), true.into());
        }
        if !self.light_columns.is_empty() {
            let columns = serde_json::to_value(&self.light_columns).unwrap_or_default();
            members.insert("light_columns".into(), columns);
        }
        if self.frame_memory != DEFAULT_FRAME_MEMORY {
            members.insert("frame_memory".into(), self.frame_memory.into());
        }
        if !self.library_folders.is_empty() {
            let folders = self.library_folders.iter().filter_map(|path| path.to_str());
            let folders = folders.map(Value::from).collect();
            members.insert("library_folders".into(), Value::Array(folders));
        }
        if let Some(display) = &self.display {
            members.insert("display".into(), serde_json::to_value(display).unwrap_or_default());
        }
        members.extend(self.farm.clone().map(|farm| ("farm".into(), farm.into())));
        members.extend(self.unknown.clone());
        let mut text = serde_json::to_string_pretty(&Value::Object(members)).unwrap_or_default();
        text.push('\n');
        text
    }

    /// Saves the settings, whole or not at all.
    ///
    /// # Errors
    /// The reason why the settings cannot be written; the window works without.
    pub fn save(&self, path: &Path) -> Result<(), Box<Diagnostic>> {
        if let Some(folder) = path.parent() {
            // If the folder cannot be made, writing tells why.
            let _ = std::fs::create_dir_all(folder);
        }
        write_atomic(path, self.to_text().as_bytes())
    }

    /// Changes the settings in a file: changes of another window since stay. Returns the settings
    /// after that. Where the file cannot be saved the change holds for this window, over the
    /// settings that it knew: no work of anybody's is lost.
    pub fn change(path: &Path, known: &Self, change: impl FnOnce(&mut Self)) -> Self {
        let before = if path.exists() { Self::load(path) } else { known.clone() };
        let mut settings = before.clone();
        change(&mut settings);
        if settings != before {
            // A failure is not told: the next change tries to save again.
            let _ = settings.save(path);
        }
        settings
    }

    /// Speaks the language of the settings from now on, in the whole process. Only the user's own
    /// window asks for it: what reads English, as tests do, would fail by the system's language.
    pub fn speak(&self) {
        chiaro_locale::speak(match self.language.as_deref() {
            Some(tag) => LANGUAGES.iter().find(|language| language.tag == tag),
            None => chiaro_locale::of_system(&LANGUAGES),
        });
    }

    /// Puts a file first in the list of recent files. An example is no file.
    pub fn opened(&mut self, path: &Path) {
        if crate::examples::file(path).is_some() {
            return;
        }
        let path = absolute(path);
        self.recent.retain(|other| *other != path);
        self.recent.insert(0, path);
        self.recent.truncate(MAX_RECENT);
    }

    /// Takes a file off the list of recent files.
    pub fn forget(&mut self, path: &Path) {
        self.recent.retain(|other| other != path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("made/settings.json");
        assert_eq!(Settings::load(&path), Settings::default());
        let mut settings = Settings { theme: Theme::Light, scale: 1.5, ..Settings::default() };
        settings.layout = Some(serde_json::json!({"left": 0.3}));
        settings.mesh = Some("shape:torus".to_owned());
        settings.language = Some("de".to_owned());
        settings.light_columns.insert("range".to_owned(), false);
        let [config, display, view] = ["a.ocio", "sRGB", "Film"].map(str::to_owned);
        settings.display = Some(DisplayChoice { config, display, view });
        settings.farm = Some("openjd".to_owned());
        settings.library_folders.push(PathBuf::from("/shared/looks"));
        settings.opened(Path::new("/a/one.json"));
        settings.save(&path).unwrap();
        assert_eq!(Settings::load(&path), settings);
    }

    #[test]
    fn the_newest_file_comes_first_and_once() {
        let mut settings = Settings::default();
        for index in 0..30 {
            settings.opened(Path::new(&format!("/a/{index}.json")));
        }
        settings.opened(Path::new("/a/25.json"));
        assert_eq!(settings.recent.len(), MAX_RECENT);
        let first: Vec<_> =
            settings.recent.iter().take(3).map(|path| path.to_str().unwrap()).collect();
        assert_eq!(first, ["/a/25.json", "/a/29.json", "/a/28.json"]);
    }

    #[test]
    fn examples_are_not_remembered_as_files() {
        let mut settings = Settings::default();
        settings.opened(Path::new("example:hcbtf/pencil.hcbtf"));
        assert_eq!(settings, Settings::default());
        let before =
            Settings::read(r#"{"recent": ["/home/me/example:hcbtf/pencil.hcbtf", "/a.json"]}"#);
        assert_eq!(
            before.recent,
            [PathBuf::from("/a.json")],
            "what was remembered once is forgotten"
        );
    }

    #[test]
    fn damage_costs_only_what_is_damaged() {
        for text in [
            "",
            "[]",
            "{",
            "null",
            r#"{"recent": 5, "theme": 7, "scale": "x", "language": 3, "mesh": [], "display": {},
                "farm": 1}"#,
        ] {
            assert_eq!(Settings::read(text), Settings::default(), "{text}");
        }
        let settings = Settings::read(
            r#"{"recent": ["/a", 3, "/b"], "theme": "mauve", "scale": 900, "mine": 1}"#,
        );
        assert_eq!(settings.recent, [PathBuf::from("/a"), PathBuf::from("/b")]);
        assert_eq!((settings.theme, settings.scale), (Theme::Dark, 1.0));
        assert!(settings.to_text().contains("\"mine\": 1"), "what others remember stays");
    }

    #[test]
    fn two_windows_do_not_undo_each_other() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("settings.json");
        let nothing = Settings::default();
        Settings::change(&path, &nothing, |settings| settings.opened(Path::new("/a.json")));
        Settings::change(&path, &nothing, |settings| settings.theme = Theme::System);
        let settings = Settings::load(&path);
        assert_eq!((settings.recent.len(), settings.theme), (1, Theme::System));
    }
}
