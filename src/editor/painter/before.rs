//! The view that a painting's flat square replaced.

use crate::state::orbit::Orbit;
use crate::state::painting::look::lies_flat;
use crate::state::session::Session;

/// Camera before the square, kept until another look is open. A scene has views of its own, so
/// nothing is kept for a scene.
#[derive(Debug, Default)]
pub(crate) struct ViewBefore {
    view: Option<Orbit>,
}

impl ViewBefore {
    /// Keeps the view that the square is about to replace.
    pub(crate) fn keep(&mut self, session: &Session) {
        if session.open_scene().is_none() && !lies_flat(&session.view.orbit) {
            self.view = Some(session.view.orbit.clone());
        }
    }

    /// Notes that a painting is shown. After a restart the square comes first, and the view after
    /// it is the default view.
    pub(crate) fn is_painted(&mut self, session: &Session) {
        if lies_flat(&session.view.orbit) {
            self.view.get_or_insert_default();
        }
    }

    /// View to restore, once the open look shows no painting.
    pub(crate) fn given_back(&mut self, session: &Session) -> Option<Orbit> {
        let is_due = session.open_scene().is_none() && lies_flat(&session.view.orbit);
        is_due.then(|| self.view.take()).flatten()
    }
}
