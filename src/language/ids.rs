//! Ids: names that last. An id is a slug made once; renaming a node never changes it.

use std::borrow::Borrow;
use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

macro_rules! slug_type {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[serde(from = "String", into = "String")]
        pub struct $name(Arc<str>);

        impl $name {
            /// Wraps a slug as it stands; see [`is_slug`] for what a document accepts.
            pub fn new(slug: impl Into<Arc<str>>) -> Self {
                Self(slug.into())
            }

            /// The slug itself.
            pub fn as_str(&self) -> &str {
                &self.0
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(&self.0)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{:?}", &self.0)
            }
        }

        impl From<$name> for String {
            fn from(name: $name) -> Self {
                name.as_str().to_owned()
            }
        }

        impl From<&str> for $name {
            fn from(slug: &str) -> Self {
                Self::new(slug)
            }
        }

        impl From<String> for $name {
            fn from(slug: String) -> Self {
                Self::new(slug)
            }
        }

        impl Borrow<str> for $name {
            fn borrow(&self) -> &str {
                &self.0
            }
        }

        impl AsRef<str> for $name {
            fn as_ref(&self) -> &str {
                &self.0
            }
        }
    };
}

slug_type!(
    /// Id of a node within one graph (a look's own, or a definition's).
    NodeId
);
slug_type!(
    /// Name of an input or output of a node.
    PortName
);
slug_type!(
    /// Id of a light in `look.lights` or `scene.lights`.
    LightId
);
slug_type!(
    /// Name of a group of lights.
    LightGroup
);
slug_type!(
    /// Id of a group definition, from the document or from the library.
    DefinitionId
);
slug_type!(
    /// Id of a titled frame drawn behind nodes on the canvas.
    FrameId
);
slug_type!(
    /// Id of a note on the canvas.
    NoteId
);
slug_type!(
    /// Id of an object of a scene.
    ObjectId
);

/// Id of the pseudo node, inside a definition, whose outputs are the group's inputs.
pub const GROUP_INPUTS: &str = "inputs";
/// Id of the pseudo node, inside a definition, whose inputs are the group's outputs.
pub const GROUP_OUTPUTS: &str = "outputs";

impl Default for PortName {
    fn default() -> Self {
        Self::new("")
    }
}

/// True for a text that can be an id: 1 to 64 of `a-z A-Z 0-9 _ -`, beginning with a letter or `_`.
pub fn is_slug(text: &str) -> bool {
    let first_is_letter = text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    first_is_letter
        && text.len() <= 64
        && text.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-')
}

/// Turns any text into a slug that `taken` does not hold: `"Rim light!"` becomes `rim_light`, then
/// `rim_light_2`.
pub fn make_slug(text: &str, taken: impl Fn(&str) -> bool) -> String {
    let mut slug = String::new();
    for c in text.chars() {
        if c.is_ascii_alphanumeric() {
            slug.push(c.to_ascii_lowercase());
        } else if !slug.ends_with('_') && !slug.is_empty() {
            slug.push('_');
        }
        if slug.len() >= 48 {
            break;
        }
    }
    let slug = slug.trim_end_matches('_');
    let slug = if slug.starts_with(|c: char| c.is_ascii_alphabetic()) {
        slug.to_owned()
    } else {
        format!("n_{slug}").trim_end_matches('_').to_owned()
    };
    if !taken(&slug) {
        return slug;
    }
    (2u64..)
        .map(|n| format!("{slug}_{n}"))
        .find(|candidate| !taken(candidate))
        .expect("some number is free")
}

/// Path of a node once groups are inlined: the ids of the groups around it, then its own, joined by
/// `/`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct NodePath(Arc<[NodeId]>);

impl NodePath {
    /// Path of a node of the look's own graph.
    pub fn root(id: NodeId) -> Self {
        Self(Arc::new([id]))
    }

    /// Path of a node inside the group node that `self` names.
    pub fn join(&self, id: NodeId) -> Self {
        Self(self.0.iter().cloned().chain([id]).collect())
    }

    /// Path of the group node that this node lies in.
    pub fn parent(&self) -> Option<Self> {
        let (_, groups) = self.0.split_last()?;
        (!groups.is_empty()).then(|| Self(groups.into()))
    }

    /// Ids from the outermost group to the node.
    pub fn ids(&self) -> &[NodeId] {
        &self.0
    }

    /// Id of the node of the look's own graph that holds this node (the node itself when it is in
    /// no group).
    pub fn outermost(&self) -> Option<&NodeId> {
        self.0.first()
    }

    /// Id of the node itself.
    pub fn last(&self) -> Option<&NodeId> {
        self.0.last()
    }

    /// Parses `group/inner/node`.
    pub fn parse(text: &str) -> Self {
        Self(text.split('/').filter(|part| !part.is_empty()).map(NodeId::from).collect())
    }
}

impl fmt::Display for NodePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, id) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str("/")?;
            }
            f.write_str(id.as_str())?;
        }
        Ok(())
    }
}

impl fmt::Debug for NodePath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slugs_are_readable_and_unique() {
        let taken = ["rim_light", "rim_light_2"];
        assert_eq!(make_slug("Rim light!", |s| taken.contains(&s)), "rim_light_3");
        assert_eq!(make_slug("2nd", |_| false), "n_2nd");
        assert_eq!(make_slug("光", |_| false), "n");
        assert!(is_slug(&make_slug(&"long ".repeat(100), |_| false)));
    }

    #[test]
    fn paths_survive_a_round_trip() {
        let path = NodePath::root("group".into()).join("inner".into());
        assert_eq!(path.to_string(), "group/inner");
        assert_eq!(NodePath::parse("group/inner"), path);
    }
}
