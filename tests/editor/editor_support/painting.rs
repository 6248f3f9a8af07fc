//! Windows in which an HCBTF is painted.

use std::path::Path;

use chiaro::document::Hcbtf;
use chiaro::editor::App;

use super::User;

/// A window with a file opened in it and without dialogs: no place to save is asked for.
pub(crate) fn opened(path: &Path) -> User {
    let mut hand = User::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().open(path);
    hand.settle();
    hand
}

/// The open HCBTF, without a stroke that has not ended.
pub(crate) fn hcbtf(hand: &User) -> &Hcbtf {
    hand.app().session().painting().unwrap().hcbtf()
}
