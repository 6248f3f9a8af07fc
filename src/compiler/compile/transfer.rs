//! Tables of what nodes make of one value: a threshold, a ramp, a curve, or several after one
//! another.

use std::sync::Arc;

use chiaro_locale::tr;

use super::check::{TypedGraph, TypedNode, TypedSource};
use super::host::conversion_program;
use super::value::typed_value;
use crate::interp::{self, Program};
use crate::library::{ArgumentSource, Conversion, Type};

/// Numbers of a table: more than a half float tells apart from 0 to 1.
pub const TRANSFER_SIZE: usize = 4096;
/// Greatest value that a table goes to.
const MAX_DOMAIN: f64 = 64.0;
/// Difference of a result that counts as a change.
const CHANGE: f64 = 1e-6;
/// Differences of channels that one another's values leave.
const CROSSING: f64 = 1e-5;

/// Result of nodes after one another for one value, with all their other inputs fixed. Where the
/// value is a color, each channel comes of that channel alone.
#[derive(Clone, Debug)]
pub struct Transfer {
    calls: Vec<TransferCall>,
    is_color: bool,
}

/// Call of a node's function.
#[derive(Clone, Debug)]
struct TransferCall {
    /// Conversion of what comes in.
    conversion: Option<Arc<Program>>,
    program: Arc<Program>,
    /// Arguments, of which those at `places` are what comes in.
    arguments: Vec<interp::Value>,
    places: Vec<usize>,
    /// The member of the result that goes on.
    member: Option<usize>,
}

/// Table of a transfer, from 0 on in even steps.
#[derive(Clone, Debug, PartialEq)]
pub struct TransferTable {
    /// Value of the last row; what is greater is the same.
    pub last: f64,
    /// Rows: of each value the three channels.
    pub rows: Vec<[f64; 3]>,
}

impl Transfer {
    /// Transfer of the nodes of a chain, the last of which takes the value; each with the input
    /// that the chain goes through.
    ///
    /// # Errors
    /// The reason why there is no table, as the end of a sentence.
    pub(super) fn new(graph: &TypedGraph, chain: &[(usize, usize)]) -> Result<Self, String> {
        let Some(&(node, input)) = chain.last() else {
            return Err(tr!("what bends it is the layer itself").to_owned());
        };
        let source = graph.wire(node, input);
        let from = source.map(|(node, output)| graph.output_type(node, output));
        let is_color = match from {
            Some(Type::Float) => false,
            Some(Type::Color | Type::Composite) => true,
            _ => return Err(tr!("what is bent is neither a number nor a color").to_owned()),
        };
        let mut calls = Vec::with_capacity(chain.len());
        for (place, &(index, input)) in chain.iter().enumerate().rev() {
            let next = place.checked_sub(1).and_then(|next| chain.get(next));
            let output = next.and_then(|&(node, input)| graph.wire(node, input));
            calls.push(TransferCall::new(graph, (index, input), output.map_or(0, |(_, at)| at))?);
        }
        let transfer = Self { calls, is_color };
        transfer.check_channels()?;
        Ok(transfer)
    }

    /// The table, up to where nothing changes any more.
    ///
    /// # Errors
    /// A channel that cannot be computed, or one that goes by the others.
    pub fn table(&self) -> Result<TransferTable, String> {
        let mut last = 1.0;
        while last < MAX_DOMAIN && self.changes_after(last)? {
            last *= 2.0;
        }
        let step = last / (TRANSFER_SIZE - 1) as f64;
        let rows = (0..TRANSFER_SIZE).map(|row| self.at([row as f64 * step; 3]));
        Ok(TransferTable { last, rows: rows.collect::<Result<_, _>>()? })
    }

    fn changes_after(&self, value: f64) -> Result<bool, String> {
        let known = self.at([value; 3])?;
        for place in 1..=32 {
            let found = self.at([value * (1.0 + f64::from(place) / 32.0); 3])?;
            if (0..3).any(|channel| (found[channel] - known[channel]).abs() > CHANGE) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Result for a value; of a number all three are the same.
    fn at(&self, value: [f64; 3]) -> Result<[f64; 3], String> {
        let [r, g, b] = value;
        let mut value = match self.is_color {
            true => interp::Value::vec(&[r, g, b, 1.0]),
            false => interp::Value::Float(r),
        };
        for call in &self.calls {
            value = call.of(value).ok_or_else(|| tr!("the reference cannot run what bends it"))?;
        }
        match value.components().unwrap_or_default().as_slice() {
            [number] => Ok([*number; 3]),
            [r, g, b] | [r, g, b, _] => Ok([*r, *g, *b]),
            _ => Err(tr!("it gives neither a number nor a color").to_owned()),
        }
    }

    /// Checks that channels do not depend on one another.
    fn check_channels(&self) -> Result<(), String> {
        const VALUES: [[f64; 3]; 4] =
            [[0.1, 0.5, 0.9], [0.9, 0.2, 0.4], [0.33, 0.71, 0.05], [0.6, 0.95, 0.5]];
        for value in VALUES.into_iter().filter(|_| self.is_color) {
            let together = self.at(value)?;
            for channel in 0..3 {
                let alone = self.at([value[channel]; 3])?;
                if (alone[channel] - together[channel]).abs() > CROSSING {
                    return Err(tr!("each of its channels depends on all three").to_owned());
                }
            }
        }
        Ok(())
    }
}

impl TransferCall {
    fn new(
        graph: &TypedGraph,
        (index, varied): (usize, usize),
        output: usize,
    ) -> Result<Self, String> {
        let node = &graph.nodes[index];
        let unknown = |_| tr!("the reference cannot run `{path}`", path = node.path);
        let variant = node.variant();
        let mut arguments = Vec::with_capacity(variant.parameters.len());
        let mut places = Vec::new();
        for parameter in &variant.parameters {
            arguments.push(match parameter {
                ArgumentSource::Input(input, _) if *input == varied => {
                    places.push(arguments.len());
                    interp::Value::Float(0.0)
                }
                ArgumentSource::Input(input, _) => fixed(graph, node, *input)?,
                ArgumentSource::Choice(input) => interp::Value::I32(node.position(*input)),
                ArgumentSource::Prepared => {
                    let Some(prepare) = &node.def.prepare else { continue };
                    let inputs = prepare.parameters.iter().map(|(input, _)| *input);
                    let given = inputs.map(|input| match input == varied {
                        true => Err(varies(node, input)),
                        false => fixed(graph, node, input),
                    });
                    let given = given.collect::<Result<Vec<_>, _>>()?;
                    let program = node.def.module.program(&prepare.function).map_err(unknown)?;
                    program.call(&given, interp::Precision::F64).map_err(unknown)?
                }
                ArgumentSource::Sampler(input) => return Err(varies(node, *input)),
            });
        }
        let conversion = match (node.inputs[varied].as_ref(), graph.wire(index, varied)) {
            (Some(input), Some((from, at))) if input.conversion != Conversion::None => {
                conversion_program(&graph.output_type(from, at), &input.ty)
            }
            _ => None,
        };
        let program = node.def.module.program(&variant.function).map_err(unknown)?;
        let member = variant.result_is_struct.then_some(output);
        Ok(Self { conversion, program, arguments, places, member })
    }

    fn of(&self, value: interp::Value) -> Option<interp::Value> {
        let value = match &self.conversion {
            Some(program) => program.call(&[value], interp::Precision::F64).ok()?,
            None => value,
        };
        let mut arguments = self.arguments.clone();
        for place in &self.places {
            arguments[*place] = value.clone();
        }
        let result = self.program.call(&arguments, interp::Precision::F64).ok()?;
        match self.member {
            Some(member) => result.parts()?.get(member).cloned(),
            None => Some(result),
        }
    }
}

/// The value of an input that stays the same over the picture and in time.
fn fixed(graph: &TypedGraph, node: &TypedNode, input: usize) -> Result<interp::Value, String> {
    let varies = || varies(node, input);
    let typed = node.inputs[input].as_ref().ok_or_else(varies)?;
    let (value, param) = match &typed.source {
        TypedSource::Param(id, value) => (value, Some(*id)),
        TypedSource::Fixed(value) => (value, None),
        TypedSource::Wire { .. } | TypedSource::Context(_) => return Err(varies()),
    };
    let param = param.and_then(|id| graph.params.get(id));
    if param.is_some_and(|param| graph.is_keyed(&param.path, &param.port)) {
        return Err(varies());
    }
    typed_value(value, &typed.ty).map_err(|_| varies())
}

fn varies(node: &TypedNode, input: usize) -> String {
    let port = node.def.inputs.get(input).map_or("", |port| port.name.as_str());
    tr!("`{port}` of `{path}` is no fixed value", path = node.path)
}
