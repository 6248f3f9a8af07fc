//! Commands about unsaved work, and about files that other programs changed.

use chiaro_locale::tr;

use super::App;
use crate::commands::{FilePurpose, RecoveryCommand};
use crate::state::crashes::DocumentOrigin;
use crate::state::safety::disk::Conflict;

impl App {
    pub(super) fn apply_to_recovery(&mut self, command: RecoveryCommand) {
        if command == RecoveryCommand::OpenAnother {
            self.dialogs.ask(FilePurpose::Open, self.session.path());
        }
        if command == RecoveryCommand::ReadAgain
            && let Some(path) = self.safety.interrupted()
        {
            self.session.journals.crashes.trust(&DocumentOrigin::of_file(&path));
            return self.open(&path);
        }
        let painting = self.painting_number();
        let takes_back = matches!(command, RecoveryCommand::TakeBack(_));
        self.message = self.recover(command);
        self.open_lacking_look();
        if takes_back {
            self.play_frames_of_shot();
        }
        self.show_painting_taken_back(painting);
    }

    /// Carries out a command of the bar of unsaved work and changed files. Returns a message.
    fn recover(&mut self, command: RecoveryCommand) -> Option<String> {
        let Self { safety, session, .. } = self;
        match command {
            RecoveryCommand::TakeBack(number) => {
                let told = safety.take_back(number, session);
                session.look_as_kept(true);
                return Some(told);
            }
            RecoveryCommand::Throw(number, is_thrown) => safety.offers.throw(number, is_thrown),
            RecoveryCommand::Reload => {
                if let Some(Conflict::Changed(text)) = safety.disk.conflict.take() {
                    if session.reload(&text) {
                        return Some(tr!("Loaded again; Undo brings your changes back").to_owned());
                    }
                    safety.disk.conflict = Some(Conflict::Broken(text));
                }
            }
            RecoveryCommand::KeepMine => {
                if let Some(Conflict::Changed(text) | Conflict::Broken(text)) =
                    safety.disk.conflict.take()
                {
                    session.look.journal.override_with(text);
                    return Some(tr!("Saving will write over the other version").to_owned());
                }
            }
            RecoveryCommand::ReloadScene => {
                if let Some(text) = safety.disk.scene_conflict.take() {
                    let is_read = session.reload_scene(&text);
                    return Some(match is_read {
                        true => tr!("The scene was loaded again; Undo brings your changes back")
                            .to_owned(),
                        false => tr!("The scene's file cannot be read now; your version stays")
                            .to_owned(),
                    });
                }
            }
            RecoveryCommand::KeepMyScene => {
                if let (Some(text), Some(open_scene)) =
                    (safety.disk.scene_conflict.take(), session.open_scene_mut())
                {
                    open_scene.keep_mine(text);
                    return Some(
                        tr!("Saving the scene will write over the other version").to_owned(),
                    );
                }
            }
            RecoveryCommand::ReloadPainting => {
                safety.disk.painting_conflict = None;
                return Some(match session.reload_painting() {
                    Ok(_) => tr!("What is painted was loaded again; Undo brings your changes back")
                        .to_owned(),
                    Err(problems) => {
                        let why = problems
                            .first()
                            .map(|problem| problem.message.as_str())
                            .unwrap_or_default();
                        tr!("The file cannot be read now, and your version stays: {why}")
                    }
                });
            }
            RecoveryCommand::KeepMyPainting => {
                safety.disk.painting_conflict = None;
                if let Some(work) = session.painting_mut() {
                    work.keep_mine();
                    return Some(
                        tr!("Saving what is painted will write the file as it is here").to_owned(),
                    );
                }
            }
            RecoveryCommand::HideUnopened
            | RecoveryCommand::OpenAnother
            | RecoveryCommand::ReadAgain => safety.unopened = None,
            RecoveryCommand::TryAgain => session.journals.try_again(),
            RecoveryCommand::Hide => {
                safety.is_problem_read = session.keeping_problem().is_some();
                safety.disk.forget_gone();
            }
        }
        None
    }
}
