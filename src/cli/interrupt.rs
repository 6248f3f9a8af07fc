//! Ctrl-C: what is half written goes, and so does the program.

use crate::document::remove_unfinished;

/// What a shell gives for a program ended by Ctrl-C: 128 and the signal's number.
const INTERRUPTED: i32 = 130;

/// From now on Ctrl-C (and a polite request to end) removes unfinished files and ends the program.
///
/// Files are written beside their final place and then renamed, so what is there is whole at any moment; without this
/// the unfinished one would stay behind.
#[expect(clippy::disallowed_methods, reason = "nothing is left to be saved, and main waits for the GPU")]
pub(super) fn clean_up_on_interrupt() {
    let handler = || {
        remove_unfinished();
        std::process::exit(INTERRUPTED);
    };
    // It fails where a handler is set already, which a program that embeds us may have done: then it is theirs.
    let _ = ctrlc::set_handler(handler);
}
