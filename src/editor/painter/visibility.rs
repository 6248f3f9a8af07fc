//! Visibility of the painting: whether the open look shows it, and where in the picture the sample
//! at work is.

use std::path::{Path, PathBuf};

use chiaro_locale::tr;
use eframe::egui::Ui;

use crate::commands::{Command, ViewCommand};
use crate::state::orbit::Orbit;
use crate::state::painting::work::OpenPainting;
use crate::state::painting::{PaintingUpdate, look};
use crate::state::revision::{DocumentNumber, MeaningRevision, PaintingNumber, PictureRevision};
use crate::state::session::Session;
use crate::state::session::painting::{is_painting_shown, view_at_sample};

/// Visibility of the painting, as far as known.
#[derive(Default)]
pub(super) struct PaintingVisibility {
    /// True if the sample at work is marked in the picture.
    marks: bool,
    /// True if the open look shows the painting, with the inputs that this was found for: finding
    /// out reads files.
    shown: Option<(VisibilityInputs, bool)>,
    /// View of the picture before it was turned to a sample on a flat square, and its document.
    turned_from: Option<(DocumentNumber, Box<Orbit>)>,
}

/// Inputs of the visibility: while they stay the same, so does the visibility.
#[derive(Clone, PartialEq)]
struct VisibilityInputs {
    look: (DocumentNumber, MeaningRevision, Option<PathBuf>),
    painting: Option<(PaintingNumber, Option<PathBuf>)>,
    scene: Option<PictureRevision>,
}

impl VisibilityInputs {
    fn now(session: &Session) -> Self {
        Self {
            look: (
                session.revisions().document,
                session.revisions().meaning,
                session.path().map(Path::to_path_buf),
            ),
            painting: session
                .painting()
                .map(|work| (work.number(), work.path().map(Path::to_path_buf))),
            scene: session.scene_revision(),
        }
    }
}

impl PaintingVisibility {
    /// Updates the visibility, once a frame.
    pub(super) fn tick(&mut self, session: &Session) -> PaintingUpdate {
        let now = VisibilityInputs::now(session);
        if self.shown.as_ref().is_none_or(|(of, _)| *of != now) {
            self.shown = Some((now, is_painting_shown(session)));
        }
        let number = session.revisions().document;
        let is_there = look::lies_flat(&session.view.orbit);
        self.turned_from = self.turned_from.take().filter(|(of, _)| *of == number && is_there);
        PaintingUpdate { is_shown: self.is_shown(), is_marked: self.marks && self.is_shown() }
    }

    /// True if the open look shows the painting, as of the last tick.
    pub(super) fn is_shown(&self) -> bool {
        self.shown.as_ref().is_some_and(|(_, is_shown)| *is_shown)
    }

    /// Shows the button that marks the sample at work in the picture.
    pub(super) fn mark(&mut self, ui: &mut Ui) {
        let help = tr!(
            "Tints the sample at work in the picture. It is seen only where the light and the eye \
             stand to the surface as they do here; other places show other samples. Where nothing \
             is tinted, Show in the picture turns to it"
        );
        ui.toggle_value(&mut self.marks, tr!("Where it shows")).on_hover_text(help);
    }

    /// Shows the buttons that turn the picture to the sample at work, and back.
    pub(super) fn turn(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        work: &OpenPainting,
        out: &mut Vec<Command>,
    ) {
        if let Some(view) = view_at_sample(session, work) {
            let help = tr!(
                "Turns the picture's camera and light to where the eye and the light are that you \
                 paint for, over a flat square"
            );
            if ui.small_button(tr!("Show in the picture")).on_hover_text(help).clicked() {
                let before = &session.view.orbit;
                if !look::lies_flat(before) {
                    self.turned_from =
                        Some((session.revisions().document, Box::new(before.clone())));
                }
                out.push(Command::View(ViewCommand::TurnTo(Box::new(view))));
            }
        }
        if let Some((_, view)) =
            self.turned_from.as_ref().filter(|_| look::lies_flat(&session.view.orbit))
        {
            let help = tr!("Shows what the picture showed before, from where it was seen");
            if ui.small_button(tr!("Back to the mesh")).on_hover_text(help).clicked() {
                out.push(Command::View(ViewCommand::TurnTo(view.clone())));
            }
        }
    }
}
