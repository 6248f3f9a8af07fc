//! Application of commands about snapshots, about what the picture is compared with, and about
//! variations.

use chiaro_locale::tr;

use super::App;
use super::files::PendingAction;
use crate::commands::{FilePurpose, PanelId, SnapshotCommand};
use crate::panels::variations::Variations;
use crate::state::comparison::ComparedPicture;
use crate::state::shelf::SnapshotId;
use crate::state::variations::VariedSubject;
use crate::tools::flip::FlipBook;
use crate::tools::playback::Playback;
use crate::tools::wipe::Wipe;

impl App {
    pub(super) fn apply_to_snapshots(&mut self, command: SnapshotCommand) {
        match command {
            SnapshotCommand::Take => match self.session.take_snapshot() {
                Ok(name) => {
                    self.start = None;
                    self.dock.open(PanelId::SNAPSHOTS);
                    self.message = Some(tr!("{name} is taken"));
                }
                Err(problem) => self.message = Some(problem.message),
            },
            SnapshotCommand::Restore(id) => self.tell(|session| session.restore_snapshot(id)),
            SnapshotCommand::Rename(id, name) => {
                self.tell(|session| session.rename_snapshot(id, &name));
            }
            SnapshotCommand::Delete(id) => self.tell(|session| session.delete_snapshot(id)),
            SnapshotCommand::Copy(id) => self.do_or_ask(PendingAction::CopySnapshot(id)),
        }
    }

    /// Compares the picture with another, or asks for the file of one.
    pub(super) fn compare(&mut self, picture: Option<ComparedPicture>) {
        let Some(picture) = picture else {
            return self.dialogs.ask(FilePurpose::Comparison, self.session.path());
        };
        self.start = None;
        self.dock.open(PanelId::PICTURE);
        let (flip, playback) = self.bench.tools.pair::<FlipBook, Playback>();
        flip.close(playback);
        self.bench.tools.of_mut::<Wipe>().choose(Some(picture));
    }

    /// Shows a sheet of variations.
    pub(super) fn vary(&mut self, subject: VariedSubject) {
        self.start = None;
        self.bench.memory.of::<Variations>().begin(subject, &self.session);
        self.dock.open(PanelId::VARIATIONS);
    }

    /// Begins a new look with what a snapshot holds.
    pub(super) fn copy_snapshot(&mut self, id: SnapshotId) {
        let Some((text, name)) = self.session.copy_of_snapshot(id) else { return };
        self.safety.put_aside(&self.session);
        self.session.start_from(&text, &name);
        self.safety.look();
    }
}
