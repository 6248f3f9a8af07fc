//! What is asked for of painting light on the picture.

use super::App;
use crate::app::dock::Panel;
use crate::tools::fitting::{Fitting, Wish};

impl App {
    pub(super) fn apply_to_fitting(&mut self, wish: Wish) {
        match wish {
            Wish::Turn(on) => self.turn_fitting(on),
            Wish::Leave => self.fitting.leave(&mut self.session),
            Wish::Fit(what) => self.fitting.fit(what, &self.session),
            Wish::Stop => self.fitting.stop(),
            Wish::Apply => {
                if let Some(edit) = self.fitting.apply(&mut self.session) {
                    self.tell(|session| session.apply(edit, None));
                    self.fitting.is_taken_on(&self.session);
                }
            }
            Wish::Discard => self.fitting.discard(&mut self.session),
            Wish::Clear => self.fitting.clear(&mut self.session),
            Wish::Back => Fitting::go_back(&mut self.session),
        }
    }

    /// Begins or ends painting on the picture, which a probe and a turntable would be in the way
    /// of.
    pub(super) fn turn_fitting(&mut self, on: bool) {
        self.fitting.turn(on, &mut self.session);
        if on {
            self.probe.turn(false);
            self.viewport.stop_turning();
            self.start = None;
            self.dock.open(Panel::Picture);
            self.dock.open(Panel::Fit);
        }
    }
}
