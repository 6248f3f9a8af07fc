//! The view that a painting's flat square took the place of.

use crate::state::orbit::Orbit;
use crate::state::painting::look::lies_flat;
use crate::state::session::Session;

/// Keeps that view until another look is open. A scene has views of its own, and none is kept of
/// it.
#[derive(Debug, Default)]
pub(crate) struct ViewBefore {
    view: Option<Orbit>,
}

impl ViewBefore {
    /// Keeps the view that the square is about to take the place of.
    pub(crate) fn keep(&mut self, session: &Session) {
        if session.stage().is_none() && !lies_flat(&session.view.orbit) {
            self.view = Some(session.view.orbit.clone());
        }
    }

    /// Notes that a painting is shown. After a restart its square was there first, and what comes
    /// after it is the view that the program begins with.
    pub(crate) fn is_painted(&mut self, session: &Session) {
        if lies_flat(&session.view.orbit) {
            self.view.get_or_insert_default();
        }
    }

    /// The view to be given back, once what is open shows no painting.
    pub(crate) fn given_back(&mut self, session: &Session) -> Option<Orbit> {
        let is_due = session.stage().is_none() && lies_flat(&session.view.orbit);
        is_due.then(|| self.view.take()).flatten()
    }
}
