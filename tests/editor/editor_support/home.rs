//! `Home`: the folders of a user of the program, with the user's files beside them.

use std::fs;
use std::path::{Path, PathBuf};

use chiaro::editor::{App, Places};

use super::User;

/// Temporary folders of one user: for the program's state and configuration, and for the user's
/// files.
pub(crate) struct Home {
    folder: tempfile::TempDir,
}

impl Home {
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    pub(crate) fn places(&self) -> Places {
        Places {
            state: self.folder.path().join("state"),
            config: self.folder.path().join("config"),
        }
    }

    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A window with this user's folders, opened as the program opens a file or, without one, its
    /// start.
    pub(crate) fn window(&self, file: Option<&Path>) -> User {
        let (places, file) = (self.places(), file.map(Path::to_path_buf));
        User::with(move |ctx| {
            let mut app = App::new(ctx, None);
            app.keep_in(places.clone(), ctx);
            match &file {
                Some(file) => app.open(file),
                None => app.resume(),
            }
            app
        })
    }

    /// The same user's folders as after a crash of all running programs at this instant: files are
    /// there, locks are gone.
    pub(crate) fn after_a_crash(&self) -> Self {
        let other = Self::new();
        let journals = other.places().journals();
        fs::create_dir_all(&journals).unwrap();
        for entry in fs::read_dir(self.places().journals()).into_iter().flatten().flatten() {
            fs::copy(entry.path(), journals.join(entry.file_name())).unwrap();
        }
        other
    }

    /// Waits until no journal has grown for half a second: changes are written a tenth of a second
    /// later, or more on a busy machine.
    #[expect(
        clippy::disallowed_methods,
        reason = "a file that another thread grows tells nobody when it is done"
    )]
    pub(crate) fn wait_until_written(&self) {
        let size = || -> u64 {
            let entries = fs::read_dir(self.places().journals()).into_iter().flatten().flatten();
            entries.filter_map(|entry| Some(entry.metadata().ok()?.len())).sum()
        };
        let (mut last, mut quiet) = (size(), 0);
        for _ in 0..100 {
            std::thread::sleep(std::time::Duration::from_millis(100));
            let now = size();
            quiet = if now == last { quiet + 1 } else { 0 };
            last = now;
            if quiet == 5 {
                return;
            }
        }
        panic!("the journal never rests");
    }

    pub(crate) fn journals(&self) -> usize {
        let entries = fs::read_dir(self.places().journals()).into_iter().flatten().flatten();
        entries
            .filter(|entry| entry.path().extension().is_some_and(|ending| ending == "journal"))
            .count()
    }
}
