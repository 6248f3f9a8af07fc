//! Names of layers, as compositors and renderers have them.

use std::collections::HashSet;

/// Longest name of a layer, in bytes: with a channel's name it stays within what every version of
/// OpenEXR reads.
const MAX_NAME: usize = 240;

/// Scheme of names for contributions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LayerNaming {
    /// `light_key`, `layer_ground`: what scripts that rebuild a picture in Nuke look for.
    #[default]
    Nuke,
    /// `C_key`, as Karma names what light path expressions give.
    Karma,
    /// `Combined_key`, as Blender names light groups.
    Blender,
    /// `RGBA_key`, as Arnold names them.
    Arnold,
    /// `key` alone: for mattes, in which names are no names of layers.
    Bare,
}

/// Row of a scheme.
#[derive(Clone, Copy, Debug)]
struct Scheme {
    naming: LayerNaming,
    /// Name for people.
    name: &'static str,
    /// Beginning of the name of what lights add, alone and to one layer.
    light: &'static str,
    /// Beginning of the name of what a layer adds.
    layer: &'static str,
    /// Name of the sum of all contributions.
    whole: &'static str,
}

const SCHEMES: [Scheme; 5] = [
    Scheme {
        naming: LayerNaming::Nuke,
        name: "nuke",
        light: "light_",
        layer: "layer_",
        whole: "beauty",
    },
    Scheme { naming: LayerNaming::Karma, name: "karma", light: "C_", layer: "C_", whole: "C" },
    Scheme {
        naming: LayerNaming::Blender,
        name: "blender",
        light: "Combined_",
        layer: "Combined_",
        whole: "Combined",
    },
    Scheme {
        naming: LayerNaming::Arnold,
        name: "arnold",
        light: "RGBA_",
        layer: "RGBA_",
        whole: "RGBA",
    },
    Scheme { naming: LayerNaming::Bare, name: "", light: "", layer: "", whole: "all" },
];

impl LayerNaming {
    /// The schemes, each with its name for people.
    pub fn all() -> impl Iterator<Item = (&'static str, Self)> {
        let named = SCHEMES.iter().filter(|scheme| scheme.naming != Self::Bare);
        named.map(|scheme| (scheme.name, scheme.naming))
    }

    fn scheme(self) -> &'static Scheme {
        SCHEMES.iter().find(|scheme| scheme.naming == self).unwrap_or(&SCHEMES[0])
    }

    /// The name of what a light adds.
    pub fn of_light(self, light: &str) -> String {
        // Names in mattes are the things' own.
        if self == Self::Bare {
            return light.to_owned();
        }
        legal_name(&format!("{}{light}", self.scheme().light))
    }

    /// The name of what a group of lights adds, which is no light's.
    pub fn of_group(self, group: &str) -> String {
        match self {
            Self::Nuke | Self::Bare => legal_name(&format!("group_{group}")),
            _ => self.of_light(&format!("group_{group}")),
        }
    }

    /// The name of what a layer adds.
    pub fn of_layer(self, layer: &str) -> String {
        legal_name(&format!("{}{layer}", self.scheme().layer))
    }

    /// The name of the sum of all contributions.
    pub fn of_whole(self) -> String {
        self.scheme().whole.to_owned()
    }
}

/// True for a name that compositors take: letters, digits and underscores, not beginning with a
/// digit, for Nuke takes no layer that is a number, and a point ends the layer's name.
pub fn is_legal(name: &str) -> bool {
    let begins = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    begins && name.len() <= MAX_NAME && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// The nearest [legal](is_legal) name.
pub fn legal_name(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut legal: String = name.chars().map(|c| if is_plain(c) { c } else { '_' }).collect();
    if !legal.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        legal.insert(0, '_');
    }
    legal.truncate(MAX_NAME - 8);
    legal
}

/// A name that is none of `taken`, with a number behind it where need be, and is then taken too.
pub fn free_name(name: &str, taken: &mut HashSet<String>) -> String {
    let mut free = name.to_owned();
    let mut number = 2_u64;
    while !taken.insert(free.clone()) {
        free = format!("{name}_{number}");
        number += 1;
    }
    free
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_that_compositors_take() {
        let names: Vec<_> = LayerNaming::all().map(|(_, naming)| naming.of_light("key")).collect();
        assert_eq!(names, ["light_key", "C_key", "Combined_key", "RGBA_key"]);
        let names: Vec<_> = LayerNaming::all().map(|(_, naming)| naming.of_group("set")).collect();
        assert_eq!(names, ["group_set", "C_group_set", "Combined_group_set", "RGBA_group_set"]);
        assert_eq!(LayerNaming::Nuke.of_layer("rim.2 (soft)"), "layer_rim_2__soft_");
        for name in ["12", "a.b", "", "ä", "é 1", "-x"] {
            assert!(!is_legal(name) && is_legal(&legal_name(name)), "{name}");
        }
        assert!(
            is_legal(&legal_name(&"long".repeat(1000))) && is_legal("key_2") && !is_legal("key-2")
        );
        let mut taken = HashSet::new();
        let mut free = |name: &str| free_name(name, &mut taken);
        assert_eq!([free("a"), free("a"), free("a_2"), free("a")], ["a", "a_2", "a_2_2", "a_3"]);
    }
}
