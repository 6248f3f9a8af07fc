//! A window in which an HCBTF is painted.

use std::path::Path;

use chiaro::document::Hcbtf;
use chiaro::editor::App;

use super::Hand;

/// A window with a file opened in it, which asks nobody for a place to save.
pub(crate) fn opened(path: &Path) -> Hand {
    let mut hand = Hand::with(|ctx| App::new(ctx, None).without_dialogs());
    hand.app_mut().open(path);
    hand.settle();
    hand
}

/// What is painted, without a stroke that goes on.
pub(crate) fn hcbtf(hand: &Hand) -> &Hcbtf {
    hand.app().session().painting().unwrap().hcbtf()
}
