//! The tables of docs/format.md.

/// One table in Markdown for each kind of object, by the name that docs/format.md has it under.
pub fn field_tables() -> Vec<(&'static str, String)> {
    Vec::new()
}
