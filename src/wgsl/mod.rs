//! WGSL sources: imports, top-level declarations, validation and spans.
