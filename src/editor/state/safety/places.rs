//! Folders for data of the window that belongs to no document.

use std::env::var_os;
use std::ffi::OsString;
use std::path::PathBuf;

/// The user's folders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Places {
    /// Folder for work that is not saved yet.
    pub state: PathBuf,
    /// Folder for settings.
    pub config: PathBuf,
}

impl Places {
    /// Folders of the system (XDG on Linux), or those that `CHIARO_STATE_DIR` and
    /// `CHIARO_CONFIG_DIR` name. `None` where the user has no home.
    pub fn of_user() -> Option<Self> {
        Self::from(|name| var_os(name))
    }

    fn from(variable: impl Fn(&str) -> Option<OsString>) -> Option<Self> {
        let folder =
            |name: &str| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let home = |below: &str| folder("HOME").map(|home| home.join(below));
        let (state, config) = if cfg!(target_os = "windows") {
            (folder("LOCALAPPDATA"), folder("APPDATA"))
        } else if cfg!(target_os = "macos") {
            let support = home("Library/Application Support");
            (support.clone(), support)
        } else {
            (
                folder("XDG_STATE_HOME").or_else(|| home(".local/state")),
                folder("XDG_CONFIG_HOME").or_else(|| home(".config")),
            )
        };
        let own = |name: &str, system: Option<PathBuf>| {
            let named = variable(name).filter(|name| !name.is_empty()).map(PathBuf::from);
            named.or_else(|| system.map(|folder| folder.join("chiaro")))
        };
        Some(Self {
            state: own("CHIARO_STATE_DIR", state)?,
            config: own("CHIARO_CONFIG_DIR", config)?,
        })
    }

    /// Folder of the journals.
    pub fn journals(&self) -> PathBuf {
        self.state.join("journals")
    }

    /// Folder in which running windows log their steps.
    pub fn running(&self) -> PathBuf {
        self.state.join("running")
    }

    /// Folder of the user's own library of parts.
    pub fn library(&self) -> PathBuf {
        self.config.join("library")
    }

    /// File of the settings.
    pub fn settings(&self) -> PathBuf {
        self.config.join("settings.json")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn places_are_those_of_the_system_unless_named() {
        let from = |pairs: &[(&str, &str)]| {
            Places::from(|name| {
                pairs.iter().find(|(key, _)| *key == name).map(|(_, value)| OsString::from(value))
            })
        };
        assert_eq!(from(&[]), None);
        let home = from(&[("HOME", "/home/a"), ("XDG_CONFIG_HOME", "not/absolute")]).unwrap();
        assert_eq!(home.journals(), PathBuf::from("/home/a/.local/state/chiaro/journals"));
        assert_eq!(home.settings(), PathBuf::from("/home/a/.config/chiaro/settings.json"));
        let named =
            from(&[("XDG_STATE_HOME", "/s"), ("CHIARO_CONFIG_DIR", "c"), ("HOME", "/h")]).unwrap();
        assert_eq!((named.state, named.config), ("/s/chiaro".into(), "c".into()));
    }
}
