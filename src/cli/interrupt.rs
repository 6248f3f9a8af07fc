//! Ctrl-C: unfinished files are removed, and the program ends.

use std::io::Write as _;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::files::remove_unfinished;

/// Exit code of a program that was ended by Ctrl-C, as shells have it: 128 and the signal's number.
pub(super) const INTERRUPTED: u8 = 130;

static IS_INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// True if the program is ending by Ctrl-C. Work that is refused for that reason has not gone
/// wrong.
pub(super) fn is_interrupted() -> bool {
    IS_INTERRUPTED.load(Ordering::SeqCst)
}

/// Installs a handler that removes unfinished files and ends the program on Ctrl-C (and on a polite
/// request to end).
///
/// Files are written beside their final path and then renamed, so every file is whole at any
/// moment; without the handler the unfinished one would stay behind.
#[expect(
    clippy::disallowed_methods,
    reason = "nothing is left to be saved, and main waits for the GPU"
)]
pub(super) fn clean_up_on_interrupt() {
    let handler = || {
        IS_INTERRUPTED.store(true, Ordering::SeqCst);
        remove_unfinished();
        // The reason is the last line, for whoever reads a farm's logs.
        let _ = writeln!(std::io::stderr(), "asked to end: what is whole stays, no file is half");
        std::process::exit(INTERRUPTED.into());
    };
    // Setting the handler fails if the process has one already, as a program that embeds us may
    // have: then its handler stays.
    let _ = ctrlc::set_handler(handler);
}
