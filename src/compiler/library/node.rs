//! Description of a node in the library.

use std::sync::Arc;

use super::module::NodeModule;
use super::types::Type;
use super::{Context, Library};
use crate::diag::Diagnostic;
use crate::document::{Look, Node, Tier, Value};
use crate::ids::PortName;

/// Kind of node.
#[derive(Clone, Debug)]
pub struct NodeDef {
    /// Stem of the file's name, which documents give as `kind`.
    pub kind: String,
    /// Label that people read.
    pub label: String,
    /// Category: the folder of the file.
    pub category: String,
    /// Help text: the effect of the node, in paragraphs.
    pub help: String,
    /// Sources of the method: `BADF eq. 5`.
    pub sources: Vec<String>,
    /// Inputs, in the order of the docs.
    pub inputs: Vec<Input>,
    /// Outputs: one for a plain result, else one for each member of the result.
    pub outputs: Vec<Output>,
    /// Functions of the node, in the order of the file.
    pub variants: Vec<NodeFunction>,
    /// Function that computes the parameter of the variants from the artist's parameters.
    pub prepare: Option<PrepareFunction>,
    /// Conditions under which the node may be left out.
    pub bypasses: Vec<Bypass>,
    /// Inputs that are clamped to [0, 1].
    pub bounds: Vec<ShareBound>,
    /// Condition under which all numbers of the result lie in [0, 1]; `None` for never.
    pub unit_when: Option<Vec<Condition>>,
    /// True if the result is a color whose alpha lies in [0, 1].
    pub has_unit_alpha: bool,
    /// True if the result is an opaque color where the node's image, every color that it takes and
    /// every stop of its ramps are opaque.
    pub keeps_opaque: bool,
    /// Greatest differences of the cheaper tiers from the exact one.
    pub errors: Vec<TierError>,
    /// Named sets of values.
    pub presets: Vec<Preset>,
    /// Remarks on code without errors: loops that a counter ends.
    pub notes: Vec<Diagnostic>,
    /// Special treatment by the compiler.
    pub special: Treatment,
    /// WGSL module with the node's functions.
    pub module: Arc<NodeModule>,
    /// File name, as messages give it.
    pub file: String,
}

/// Special treatment of a node by the compiler.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Treatment {
    /// Plain node.
    #[default]
    None,
    /// Output node: the look's result.
    Output,
    /// Light node: gives the light that it names; its variant is the light's type.
    Light,
    /// Node that gives something else of the light that it names; its variant is the light's type,
    /// too.
    OfLight,
    /// Reroute: passes its input on.
    Reroute,
}

/// Input port.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name of the port, in WGSL and in documents.
    pub name: PortName,
    /// Label that people read.
    pub label: String,
    /// Help text.
    pub help: String,
    /// Type of the input in the first function that takes it.
    pub ty: Type,
    /// Value of the input while unwired and without a value of its own.
    pub fallback: Fallback,
    /// Least value.
    pub min: Option<f64>,
    /// Greatest value.
    pub max: Option<f64>,
    /// Unit of the numbers: `rad`, `px`, `s`.
    pub unit: String,
    /// Editor of the value: `slider`, `color`, `direction`, `path`; empty for the type's own
    /// editor.
    pub widget: String,
    /// Choices: the words, and the labels that people read for them.
    pub options: Vec<(String, String)>,
    /// True for an input from the surroundings that is never shown as a port.
    pub hidden: bool,
    /// Feed of the input where its node runs for each of many lights.
    pub light_feed: Option<LightFeed>,
}

/// Feed of an input whose node runs for each of many lights, one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LightFeed {
    /// An output of the node as the lights before have left it; the input's own value before the
    /// first light. A node with such an input joins lights.
    Before(PortName),
    /// Intensity of the light where it arrives; 0 where it does not.
    Reach,
    /// Number of the light among all of them, from 0.
    Index,
    /// Number of all of them.
    Count,
    /// Number that belongs to the light by its id, in any group or none.
    Number,
    /// 1 if the light is of the set that another input says, in any group or none; 0 if not.
    Member(PortName),
}

/// Value of an input that is unwired and has no value of its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Fallback {
    /// Fixed value.
    Value(Value),
    /// Value of a context.
    Context(Context),
    /// Value of another input of the node.
    Same(PortName),
    /// No value: the input must be wired.
    Wire,
}

/// Output port.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name of the port.
    pub name: PortName,
    /// Label that people read.
    pub label: String,
    /// Help text.
    pub help: String,
    /// Type of the output in the first function.
    pub ty: Type,
}

/// Function of a node.
#[derive(Clone, Debug)]
pub struct NodeFunction {
    /// Name of the function.
    pub function: String,
    /// Choice that the function implements: the input's index and the word.
    pub choice: Option<(usize, String)>,
    /// Wider type that the function is for.
    pub width: Option<Type>,
    /// Tier of the function.
    pub tier: Tier,
    /// Parameters, in order.
    pub parameters: Vec<ArgumentSource>,
    /// Type of the result.
    pub result: Type,
    /// True if the members of the result are the outputs.
    pub result_is_struct: bool,
}

/// Source of the argument for a function's parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum ArgumentSource {
    /// Input, by index, as this type.
    Input(usize, Type),
    /// Result of `prepare`.
    Prepared,
    /// Sampler of an image input, by index.
    Sampler(usize),
    /// Position of a choice's word among its options, by the choice's index.
    Choice(usize),
}

/// The `prepare` function of a node, run in f64 before the fragment wherever its parameters are
/// known there.
#[derive(Clone, Debug)]
pub struct PrepareFunction {
    /// Name of the function.
    pub function: String,
    /// Indices of the inputs that the function takes, with the types of the parameters.
    pub parameters: Vec<(usize, Type)>,
    /// Type of the result, a struct.
    pub result: Type,
}

/// Bypass of a node: the conditions under which the node may be left out, and its replacement.
#[derive(Clone, Debug, PartialEq)]
pub struct Bypass {
    /// Replacement of the node's result.
    pub result: BypassResult,
    /// Conditions of the bypass; all must hold.
    pub conditions: Vec<Condition>,
    /// Reason why nothing is lost: the end of a sentence that begins with the node.
    pub reason: String,
}

/// Replacement of a bypassed node's result.
#[derive(Clone, Debug, PartialEq)]
pub enum BypassResult {
    /// Value of an input, by index.
    Input(usize),
    /// Fixed number.
    Number(f64),
}

/// Bound of an input that is a share, such as an opacity or a mask: the input is clamped to [0, 1]
/// before the node's functions see it, of a color its alpha alone.
#[derive(Clone, Debug, PartialEq)]
pub struct ShareBound {
    /// Index of the input.
    pub input: usize,
    /// Choices with which the input is a share; all must hold.
    pub conditions: Vec<Condition>,
}

/// Condition of a bypass.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Index of the input that is tested.
    pub input: usize,
    /// Test that must hold.
    pub test: Test,
}

/// Test of an input in a condition.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// All numbers of the input are this one.
    Is(f64),
    /// The first three numbers of the input are 0.
    Black,
    /// The input equals another input, by index.
    Same(usize),
    /// The choice has one of these words.
    Word(Vec<String>),
    /// All numbers of the input are known to lie in [0, 1].
    Unit,
    /// The fourth number of the input, if there is one, is known to lie in [0, 1].
    UnitAlpha,
    /// All numbers of the input are known to be no more than this.
    AtMost(Limit),
    /// All numbers of the input are known to be no less than this.
    AtLeast(Limit),
}

/// Limit that a condition compares an input with.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// Fixed number.
    Number(f64),
    /// All numbers of another input, by index.
    Input(usize),
}

/// Greatest difference of a cheaper tier from the exact one, in the numbers of the result:
/// `@error`.
#[derive(Clone, Debug, PartialEq)]
pub struct TierError {
    /// Cheaper tier.
    pub tier: Tier,
    /// Greatest absolute difference; a test holds it.
    pub bound: f64,
    /// Explanation: the quantity that differs, and where.
    pub help: String,
}

/// Preset: a named set of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// Label that people read.
    pub label: String,
    /// Values that the preset sets.
    pub values: Vec<(PortName, Value)>,
}

impl NodeDef {
    /// True if the node joins what comes of many lights: it is fed with its own outputs.
    pub fn joins_lights(&self) -> bool {
        self.inputs.iter().any(|input| matches!(input.light_feed, Some(LightFeed::Before(_))))
    }

    /// True if the node's function is chosen by the type of the light that it names.
    pub fn has_light_types(&self) -> bool {
        matches!(self.special, Treatment::Light | Treatment::OfLight)
    }

    /// Tiers of the node, the exact one first: the tiers of its functions, and those of the
    /// contexts that its inputs read.
    pub fn tiers(&self) -> Vec<Tier> {
        let mut tiers: Vec<Tier> = self.variants.iter().map(|variant| variant.tier).collect();
        for input in &self.inputs {
            if let Fallback::Context(context) = &input.fallback {
                let is_cheaper = |tier: &Tier| context.at_tier(*tier, input.hidden) != *context;
                tiers.extend([Tier::Balanced, Tier::Fast].into_iter().filter(is_cheaper));
            }
        }
        tiers.sort_unstable();
        tiers.dedup();
        tiers
    }

    /// True if the node's functions of a tier take a value of a type.
    pub fn takes(&self, ty: &Type, tier: Tier) -> bool {
        let tiers = self.variants.iter().map(|variant| variant.tier);
        let own = tiers.filter(|own| *own <= tier).max().unwrap_or_default();
        let takes = |variant: &NodeFunction| {
            variant.parameters.iter().any(|source| match source {
                ArgumentSource::Input(_, taken) => taken == ty,
                ArgumentSource::Prepared => self
                    .prepare
                    .iter()
                    .flat_map(|prepare| &prepare.parameters)
                    .any(|(_, taken)| taken == ty),
                ArgumentSource::Sampler(_) | ArgumentSource::Choice(_) => false,
            })
        };
        self.variants.iter().any(|variant| variant.tier == own && takes(variant))
    }

    /// Cheapest tier whose result differs from the exact one by at most `bound`, by what is stated
    /// of the node and of the functions that it calls. `fast` is for artists to choose: what is
    /// stated of it leaves out edges. A node of a project that states nothing of its cheaper forms
    /// is exact: nobody knows what becomes of their errors within it.
    pub fn cheapest_within(&self, bound: f64) -> Tier {
        let of_forms = self.form_error();
        let stated = self.error_of(Tier::Balanced).map(|error| error.bound);
        let is_unknown = stated.is_none()
            && (self.variants.iter().any(|variant| variant.tier == Tier::Balanced)
                || (of_forms > 0.0 && !self.is_shipped()));
        let error = stated.unwrap_or_default().max(of_forms);
        if is_unknown || error > bound { Tier::Exact } else { Tier::Balanced }
    }

    /// True if a tier other than the exact one may compute in another way.
    pub fn has_cheaper(&self) -> bool {
        self.tiers().len() > 1 || self.form_error() > 0.0
    }

    /// Greatest difference that balanced forms make of the functions that the node calls.
    pub fn form_error(&self) -> f64 {
        let of = |variant: &NodeFunction| self.module.form_error(&variant.function);
        self.variants.iter().map(of).fold(0.0, f64::max)
    }

    fn is_shipped(&self) -> bool {
        let shipped = Library::built_in().nodes.values().next();
        shipped.is_some_and(|def| Arc::ptr_eq(&def.module, &self.module))
    }

    /// Tier of a node of this kind in a look's own graph.
    pub fn tier_in(&self, look: &Look, node: &Node) -> Tier {
        let asked = node.tier.or(look.tier);
        asked.unwrap_or_else(|| self.cheapest_within(look.max_error))
    }

    /// Difference of a tier from the exact one, where the node's file gives one.
    pub fn error_of(&self, tier: Tier) -> Option<&TierError> {
        self.errors.iter().find(|error| error.tier == tier)
    }

    /// Index of an input by name.
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|input| input.name.as_str() == name)
    }

    /// Index of an output by name; an empty name is the first.
    pub fn output(&self, name: &str) -> Option<usize> {
        if name.is_empty() {
            return (!self.outputs.is_empty()).then_some(0);
        }
        self.outputs.iter().position(|output| output.name.as_str() == name)
    }

    /// Inputs that are shown as ports or values.
    pub fn visible_inputs(&self) -> impl Iterator<Item = &Input> {
        self.inputs.iter().filter(|input| !input.hidden)
    }
}
