//! What the library knows of a node.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use super::Context;
use super::types::Type;
use crate::diag::Diagnostic;
use crate::document::{Tier, Value};
use crate::ids::PortName;
use crate::interp::{Derivatives, Options, Program};
use crate::wgsl::{Declaration, Linked, Operations, Scan, Valid};

/// A kind of node.
#[derive(Clone, Debug)]
pub struct NodeDef {
    /// The file's stem: what documents say in `kind`.
    pub kind: String,
    /// What people read.
    pub label: String,
    /// The folder.
    pub category: String,
    /// What it does, in paragraphs.
    pub help: String,
    /// Where it comes from: `BADF eq. 5`.
    pub sources: Vec<String>,
    /// In the order of the docs.
    pub inputs: Vec<Input>,
    /// One for a plain result, else one for each member of the result.
    pub outputs: Vec<Output>,
    /// Its functions, in file order.
    pub variants: Vec<Variant>,
    /// What turns artist's parameters into what the variants take.
    pub prepare: Option<Prepare>,
    /// When the node may be left out.
    pub bypasses: Vec<Bypass>,
    /// Inputs that are kept within 0 and 1.
    pub bounds: Vec<Bound>,
    /// When all numbers of the result lie in [0, 1]; `None` for never.
    pub unit_when: Option<Vec<Condition>>,
    /// Whether the result is a color whose alpha lies in [0, 1].
    pub has_unit_alpha: bool,
    /// How far its cheaper tiers may be from the exact one.
    pub errors: Vec<TierError>,
    /// Named settings.
    pub presets: Vec<Preset>,
    /// What there is to say of its code where nothing is wrong: loops that a counter ends.
    pub notes: Vec<Diagnostic>,
    /// What the compiler must know it by.
    pub special: Special,
    /// The WGSL that its functions stand in.
    pub module: Arc<NodeModule>,
    /// The file, as messages name it.
    pub file: String,
}

/// Nodes that the compiler treats on its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Special {
    /// A plain node.
    #[default]
    None,
    /// The look's result.
    Output,
    /// Names a light; its variant is the light's type.
    Light,
    /// Passes its input on.
    Reroute,
}

/// An input port.
#[derive(Clone, Debug)]
pub struct Input {
    /// Its name, in WGSL and in documents.
    pub name: PortName,
    /// What people read.
    pub label: String,
    /// What is said about it.
    pub help: String,
    /// Its type in the first function that takes it.
    pub ty: Type,
    /// What it has while unwired and without a value.
    pub fallback: Fallback,
    /// The least value.
    pub min: Option<f64>,
    /// The greatest value.
    pub max: Option<f64>,
    /// The unit of its numbers: `rad`, `px`, `s`.
    pub unit: String,
    /// How it is edited: `slider`, `color`, `direction`, `path`; empty for the type's own way.
    pub widget: String,
    /// Choices: the words and what people read for them.
    pub options: Vec<(String, String)>,
    /// Whether it is the surroundings' and never shown as a port.
    pub hidden: bool,
}

/// What an input has while unwired and without a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Fallback {
    /// A value.
    Value(Value),
    /// Something of the surroundings.
    Context(Context),
    /// Whatever another input of the node has.
    Same(PortName),
    /// Nothing: it must be wired.
    Wire,
}

/// An output port.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name.
    pub name: PortName,
    /// What people read.
    pub label: String,
    /// What is said about it.
    pub help: String,
    /// Its type in the first function.
    pub ty: Type,
}

/// One function of a node.
#[derive(Clone, Debug)]
pub struct Variant {
    /// The function's name.
    pub function: String,
    /// The choice that it implements: the input's index and the word.
    pub choice: Option<(usize, String)>,
    /// The wider type that it is for.
    pub width: Option<Type>,
    /// Its tier.
    pub tier: Tier,
    /// What it takes, in order.
    pub parameters: Vec<Parameter>,
    /// What it gives.
    pub result: Type,
    /// Whether the result's members are the outputs.
    pub result_is_struct: bool,
}

/// What a function's parameter is bound to.
#[derive(Clone, Debug, PartialEq)]
pub enum Parameter {
    /// An input, by index, as this type.
    Input(usize, Type),
    /// The result of `prepare`.
    Prepared,
    /// The sampler of an image input.
    Sampler(usize),
}

/// A node's second function, run in f64 before the fragment wherever its parameters are known
/// there.
#[derive(Clone, Debug)]
pub struct Prepare {
    /// The function's name.
    pub function: String,
    /// The inputs it takes, with the types it takes them as.
    pub parameters: Vec<(usize, Type)>,
    /// The struct it gives.
    pub result: Type,
}

/// When a node may be left out, and what stands in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Bypass {
    /// What its result is then.
    pub result: BypassResult,
    /// All must hold.
    pub conditions: Vec<Condition>,
    /// Why nothing is lost: the end of a sentence that begins with the node.
    pub reason: String,
}

/// What stands in a bypassed node's place.
#[derive(Clone, Debug, PartialEq)]
pub enum BypassResult {
    /// An input.
    Input(usize),
    /// A number.
    Number(f64),
}

/// An input that is a share, such as an opacity or a mask: it is kept within 0 and 1 before the
/// node's functions see it, of a color its alpha alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The input.
    pub input: usize,
    /// The choices with which it is a share; all must hold.
    pub conditions: Vec<Condition>,
}

/// One condition of a bypass.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Of which input.
    pub input: usize,
    /// What must hold.
    pub test: Test,
}

/// What a bypass asks of an input.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// All its numbers are this one.
    Is(f64),
    /// Its first three numbers are 0.
    Black,
    /// It is the same as another input.
    Same(usize),
    /// The choice has one of these words.
    Word(Vec<String>),
    /// All its numbers are known to lie in [0, 1].
    Unit,
    /// Its fourth number, if it has one, is known to lie in [0, 1].
    UnitAlpha,
    /// All its numbers are known to be no more than this.
    AtMost(Limit),
    /// All its numbers are known to be no less than this.
    AtLeast(Limit),
}

/// What a condition holds an input against.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// A number.
    Number(f64),
    /// All numbers of another input.
    Input(usize),
}

/// How far a cheaper tier may be from the exact one, in the numbers of the result: `@error`.
#[derive(Clone, Debug, PartialEq)]
pub struct TierError {
    /// The tier.
    pub tier: Tier,
    /// The worst absolute difference; a test holds it.
    pub bound: f64,
    /// Of what, and where.
    pub help: String,
}

/// Named settings.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// What people read.
    pub label: String,
    /// The values it sets.
    pub values: Vec<(PortName, Value)>,
}

impl NodeDef {
    /// Its tiers, the exact one first: those that its functions are for, and those that its
    /// surroundings have.
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

    /// How far a tier may be from the exact one, where its file says so.
    pub fn error_of(&self, tier: Tier) -> Option<&TierError> {
        self.errors.iter().find(|error| error.tier == tier)
    }

    /// An input's index by name.
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|input| input.name.as_str() == name)
    }

    /// An output's index by name; an empty name is the first.
    pub fn output(&self, name: &str) -> Option<usize> {
        if name.is_empty() {
            return (!self.outputs.is_empty()).then_some(0);
        }
        self.outputs.iter().position(|output| output.name.as_str() == name)
    }

    /// The inputs that are shown as ports or values.
    pub fn visible_inputs(&self) -> impl Iterator<Item = &Input> {
        self.inputs.iter().filter(|input| !input.hidden)
    }
}

/// Validated WGSL with the functions of one or more nodes.
#[derive(Debug)]
pub struct NodeModule {
    /// The text that was validated, with the way back to files.
    pub linked: Linked,
    /// Its declarations.
    pub scan: Scan,
    /// naga's view of it.
    pub valid: Valid,
    operations: Operations,
    by_name: HashMap<String, usize>,
    programs: Mutex<HashMap<String, Result<Arc<Program>, Diagnostic>>>,
}

impl NodeModule {
    /// Wraps validated text.
    pub fn new(linked: Linked, scan: Scan, valid: Valid) -> Self {
        let by_name =
            scan.declarations.iter().enumerate().map(|(i, d)| (d.name.clone(), i)).collect();
        let operations = Operations::of(&valid.module);
        Self { linked, scan, valid, operations, by_name, programs: Mutex::default() }
    }

    /// A top-level declaration by name.
    pub fn declaration(&self, name: &str) -> Option<&Declaration> {
        self.by_name.get(name).map(|&index| &self.scan.declarations[index])
    }

    /// The operations of a function, counted in the IR.
    pub fn operations(&self, function: &str) -> u64 {
        self.operations.of_function(&self.valid.module, function)
    }

    /// A function, ready to run on the CPU, with constants at f64; compiled on the first call.
    /// Derivatives are 0 in it, because whatever runs before the fragment is the same in all of
    /// them.
    ///
    /// # Errors
    /// Names what of the function the interpreter cannot run.
    pub fn program(&self, function: &str) -> Result<Arc<Program>, Diagnostic> {
        let mut programs = self.programs.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(program) = programs.get(function) {
            return program.clone();
        }
        let source = Some(self.linked.text.as_str());
        let options = Options { derivatives: Derivatives::Zero, source, ..Options::default() };
        let program = Program::compile(&self.valid.module, function, options).map(Arc::new);
        programs.insert(function.to_owned(), program.clone());
        program
    }
}
