//! Parts that are left out of a shader, each with the proof that nothing is lost.

use chiaro_locale::tr;

use crate::ids::NodePath;

/// The proof that a part can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Proof {
    /// Nothing that is seen depends on it.
    Unreachable,
    /// The part's contribution is multiplied by 0.
    ZeroWeight,
    /// With these values it gives what it is given.
    NoEffect,
    /// The value is known before drawing.
    Constant,
    /// The value equals another one, which serves for both.
    Equal,
    /// The bounds of what it can give.
    Ranges,
    /// The object lies outside of the picture.
    OffScreen,
    /// The object has no surface: a scale of 0, or a mesh without triangles.
    NoSurface,
    /// No part of it wears a look.
    NoLook,
    /// The light lights nothing: off, black or too far from every object.
    NoLight,
    /// Inputs are as they were: the last result still stands.
    Unchanged,
}

impl Proof {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Unreachable,
        Self::ZeroWeight,
        Self::NoEffect,
        Self::Constant,
        Self::Equal,
        Self::Ranges,
        Self::OffScreen,
        Self::NoSurface,
        Self::NoLook,
        Self::NoLight,
        Self::Unchanged,
    ];

    /// In words.
    pub fn label(self) -> &'static str {
        match self {
            Self::Unreachable => tr!("unreachable"),
            Self::ZeroWeight => tr!("zero weight"),
            Self::NoEffect => tr!("no effect"),
            Self::Constant => tr!("constant"),
            Self::Equal => tr!("equal to another"),
            Self::Ranges => tr!("proved by ranges"),
            Self::OffScreen => tr!("off-screen"),
            Self::NoSurface => tr!("no surface"),
            Self::NoLook => tr!("no look"),
            Self::NoLight => tr!("light reaches no object"),
            Self::Unchanged => tr!("unchanged"),
        }
    }
}

/// Part that was left out.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Removal {
    /// The node.
    #[serde(serialize_with = "path_text")]
    pub path: NodePath,
    /// Reason why nothing is lost: the end of a sentence that begins with the node.
    pub reason: String,
    /// The kind of proof.
    pub proof: Proof,
    /// True where bounds prove what the node gives: it still gives that value.
    #[serde(skip)]
    pub still_gives: bool,
    /// Operations at each fragment that are saved, counted in the node's function.
    pub operations: u64,
}

fn path_text<S: serde::Serializer>(path: &NodePath, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(path)
}
