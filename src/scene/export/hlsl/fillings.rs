//! Members that fill up space in structs.
//!
//! naga writes them into every struct of a shader (`int _pad1_0;`), so that the members of a
//! uniform lie where its bytes are. A struct that no uniform holds has bytes that concern nobody,
//! and reads better without.

use std::collections::{BTreeMap, BTreeSet};

/// A member of a struct.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Member<'t> {
    /// Type of the member, without the length of an array.
    ty: &'t str,
    /// True for a member that fills up space.
    pub(super) is_filling: bool,
}

/// Members of structs, by the names of the structs.
pub(super) type Structs<'t> = BTreeMap<&'t str, Vec<Member<'t>>>;

/// The structs that a text declares.
pub(super) fn structs(text: &str) -> Structs<'_> {
    let mut found = Structs::new();
    let mut within = None;
    for line in text.lines() {
        if let Some(name) = beginning(line) {
            found.insert(name, Vec::new());
            within = Some(name);
        } else if line == "};" {
            within = None;
        } else if let Some(members) = within.and_then(|name| found.get_mut(name)) {
            let words = line.trim_start().trim_start_matches("row_major ");
            let ty = words.split(' ').next().unwrap_or_default();
            members.push(Member { ty, is_filling: is_filling(line) });
        }
    }
    found
}

/// The text without members that fill up space in structs that no uniform holds.
pub(super) fn without_fillings(text: &str) -> String {
    let structs = structs(text);
    let mut held: BTreeSet<&str> = BTreeSet::new();
    let mut open: Vec<&str> = text.lines().filter_map(uniform).collect();
    while let Some(ty) = open.pop() {
        if let Some(members) = structs.get(ty).filter(|_| held.insert(ty)) {
            open.extend(members.iter().map(|member| member.ty));
        }
    }
    let mut result = String::with_capacity(text.len());
    let mut is_held = true;
    for line in text.lines() {
        is_held = beginning(line).map_or(is_held || line == "};", |name| held.contains(name));
        if is_held || !is_filling(line) {
            result.push_str(line);
            result.push('\n');
        }
    }
    result
}

/// The struct that a line begins: `struct Pair {`.
fn beginning(line: &str) -> Option<&str> {
    line.strip_prefix("struct ")?.strip_suffix(" {")
}

/// The type of the uniform in `cbuffer look : register(b2) { Look look; }`.
fn uniform(line: &str) -> Option<&str> {
    let (_, held) = line.strip_prefix("cbuffer ")?.split_once("{ ")?;
    held.trim_start_matches("row_major ").split(' ').next()
}

/// True for `    int _pad1_0;` and `    int _end_pad_0;`.
fn is_filling(line: &str) -> bool {
    let name = line.trim_start().strip_prefix("int ").unwrap_or_default();
    (name.starts_with("_pad") || name.starts_with("_end_pad")) && name.ends_with(';')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn structs_of_uniforms_keep_what_fills_them() {
        let text = "\
struct Inner {
    float3 a;
    int _end_pad_0;
};

struct Pair {
    float2 b;
    int _pad1_0;
    Inner c;
};

struct Look {
    Inner inner[2];
    int _end_pad_0;
};

cbuffer look : register(b2) { Look look; }
";
        assert_eq!(without_fillings(text), text.replace("    int _pad1_0;\n", ""));
        let found = structs(text);
        let filling: Vec<bool> = found["Pair"].iter().map(|member| member.is_filling).collect();
        assert_eq!(filling, [false, true, false]);
        assert_eq!(found["Look"][0].ty, "Inner");
    }
}
