//! Labels of nodes and their ports in the user's language. Those of the library are looked up;
//! names that people gave are shown as they are.

use chiaro_locale::tr_in;

use crate::catalog::CUSTOM_KIND;
use crate::library::Library;

/// True for a kind of node, or a group, that comes with Chiaro.
pub(crate) fn is_own(kind: &str) -> bool {
    let library = Library::built_in();
    let is_listed = library.nodes.contains_key(kind) || library.groups.contains_key(kind);
    is_listed || kind == CUSTOM_KIND
}

/// Text of a kind of node, such as its label or that of a port, as it is shown.
pub(crate) fn of<'a>(kind: &str, text: &'a str) -> &'a str {
    shown(is_own(kind), text)
}

/// Text of a node as it is shown: `is_own` tells whether its kind comes with Chiaro.
pub(crate) fn shown(is_own: bool, text: &str) -> &str {
    if is_own { tr_in("node", text) } else { text }
}
