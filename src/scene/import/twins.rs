//! Rows of the tables of twins.

use super::foreign::ForeignNode;

/// A node of another program, and what it is made of here.
#[derive(Clone, Copy, Debug)]
pub(super) struct Twin {
    /// Kind of the other program's node, with its variant after a colon and its type after a point
    /// where these matter: `extract:0`, `constant.float`, `ShaderNodeMath:ADD`.
    pub(super) kind: &'static str,
    /// The recipe.
    pub(super) recipe: &'static str,
    /// Names of the node's outputs with the ports of the recipe's last node, as `outx=x outy=y`;
    /// empty where every output is the recipe's own.
    pub(super) outputs: &'static str,
    /// Difference that is worth telling, as a sentence without a full stop; empty for none.
    pub(super) told: &'static str,
}

/// A row whose recipe is equal to the node.
pub(super) const fn twin(kind: &'static str, recipe: &'static str) -> Twin {
    Twin { kind, recipe, outputs: "", told: "" }
}

impl Twin {
    /// The row with several outputs.
    pub(super) const fn outputs(self, outputs: &'static str) -> Self {
        Self { outputs, ..self }
    }

    /// The row with a difference that is told.
    pub(super) const fn told(self, told: &'static str) -> Self {
        Self { told, ..self }
    }

    /// Port of our node for an output of the other program's; `None` for the recipe's own.
    pub(super) fn port(&self, output: &str) -> Option<&'static str> {
        let mut pairs = self.outputs.split_whitespace().filter_map(|pair| pair.split_once('='));
        if output.is_empty() {
            return pairs.next().map(|(_, port)| port);
        }
        pairs.find(|(name, _)| *name == output).map(|(_, port)| port)
    }
}

/// Types for which a row without a type holds: of others, colors with alpha above all, arithmetic
/// differs.
const PLAIN: [&str; 13] = [
    "",
    "float",
    "integer",
    "boolean",
    "color3",
    "vector2",
    "vector3",
    "multioutput",
    "surfaceshader",
    "BSDF",
    "EDF",
    "string",
    "filename",
];

/// The row for one output of a node whose outputs are different things; its kind is
/// `ShaderNodeTexCoord>uv`.
pub(super) fn twin_of_output(
    twins: &'static [Twin],
    node: &ForeignNode,
    output: &str,
) -> Option<&'static Twin> {
    twins.iter().find(|twin| twin.kind.split_once('>') == Some((&node.kind, output)))
}

/// True for a node that has rows for its outputs.
pub(super) fn is_by_outputs(twins: &'static [Twin], node: &ForeignNode) -> bool {
    twins.iter().any(|twin| twin.kind.split_once('>').is_some_and(|(kind, _)| kind == node.kind))
}

/// The row for a node, the most special first.
pub(super) fn twin_of(twins: &'static [Twin], node: &ForeignNode) -> Option<&'static Twin> {
    let ForeignNode { kind, variant, ty, .. } = node;
    let find = |key: &str| twins.iter().find(|twin| twin.kind == key);
    let is_plain = PLAIN.contains(&ty.as_str());
    let plain = |key: String| if is_plain { find(&key) } else { None };
    find(&format!("{kind}:{variant}.{ty}"))
        .or_else(|| plain(format!("{kind}:{variant}")))
        .or_else(|| if variant.is_empty() { find(&format!("{kind}.{ty}")) } else { None })
        .or_else(|| if variant.is_empty() { plain(kind.clone()) } else { None })
}
