//! A compiled shader's parameters by their place in the look.

use std::collections::HashMap;

use crate::compile::{Param, ParamId};
use crate::ids::{NodePath, PortName};

/// Finds parameters by place.
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

    /// The parameter of an input.
    pub fn find(&self, node: &NodePath, port: &PortName) -> Option<ParamId> {
        self.0.get(&(node.clone(), port.clone())).copied()
    }
}
