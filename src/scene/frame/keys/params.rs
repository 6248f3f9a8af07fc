//! Table of a compiled shader's parameters by their place in the look.

use std::collections::HashMap;

use crate::compile::{Param, ParamId};
use crate::ids::{NodePath, PortName};

/// Parameters by node and port.
#[derive(Clone, Debug, Default)]
pub struct ParamTable(HashMap<(NodePath, PortName), ParamId>);

impl ParamTable {
    /// A table over a compiled shader's parameters.
    pub fn new(params: &[Param]) -> Self {
        Self(
            params
                .iter()
                .enumerate()
                .map(|(id, param)| ((param.path.clone(), param.port.clone()), id))
                .collect(),
        )
    }

    /// The parameter of the input `port` of `node`.
    pub fn find(&self, node: &NodePath, port: &PortName) -> Option<ParamId> {
        self.0.get(&(node.clone(), port.clone())).copied()
    }
}
