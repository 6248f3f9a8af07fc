//! Ctrl-C: what is half written goes, and so does the program.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::files::remove_unfinished;

/// What a shell gives for a program ended by Ctrl-C: 128 and the signal's number.
pub(super) const INTERRUPTED: u8 = 130;

static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Whether the program is ending by Ctrl-C. Work that is refused for that has not gone wrong.
pub(super) fn is_interrupted() -> bool {
    IS_INTERRUPTED.load(Ordering::SeqCst)
}

/// From now on Ctrl-C (and a polite request to end) removes unfinished files and ends the program.
///
/// Files are written beside their final place and then renamed, so what is there is whole at any
/// moment; without this the unfinished one would stay behind.
#[expect(
    clippy::disallowed_methods,
    reason = "nothing is left to be saved, and main waits for the GPU"
)]
pub(super) fn clean_up_on_interrupt() {
    let handler = || {
        IS_INTERRUPTED.store(true, Ordering::SeqCst);
        remove_unfinished();
        std::process::exit(INTERRUPTED.into());
    };
    // It fails where a handler is set already, which a program that embeds us may have done: then
    // it is theirs.
    let _ = ctrlc::set_handler(handler);
}
