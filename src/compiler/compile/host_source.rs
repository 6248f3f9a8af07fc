//! A host program as data and WGSL text, for programs that run or port it without Chiaro.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::flatten::ParamId;
use super::functions::SpecializedFunctions;
use super::host::{Callee, HostProgram, ProgramStep};
use super::items::{CollectedItems, Items};
use super::names::Names;
use crate::ids::LightId;
use crate::interp;
use crate::library::{Context, Conversion, Library, Type};
use crate::wgsl::{identifiers, rename_identifiers};

/// The steps of a [`HostProgram`], for exports that write them as code.
#[derive(Clone, Debug)]
pub struct HostSource {
    /// The functions that the steps call, with all that they use; empty where none is called. Valid
    /// WGSL without entry points.
    pub wgsl: String,
    /// Each step reads only earlier ones.
    pub steps: Vec<HostStep>,
}

/// A step; operands are indices of earlier steps.
#[derive(Clone, Debug, PartialEq)]
pub enum HostStep {
    /// A value known when the look was compiled.
    Constant(interp::Value),
    /// A value that may be set.
    Param {
        /// Index into [`CompiledShader::params`](super::CompiledShader::params).
        id: ParamId,
        /// The type that the value is taken as.
        ty: Type,
        /// The document's value.
        value: interp::Value,
    },
    /// Context of the surroundings, of this light if it is one of a light.
    Context(Context, Option<LightId>),
    /// A function of [`HostSource::wgsl`] called.
    Call {
        /// Name of the context.
        function: String,
        /// Steps.
        arguments: Vec<usize>,
    },
    /// A member of a struct, by index.
    Member {
        /// The step that gives the struct.
        value: usize,
        /// Counts members from 0.
        index: usize,
    },
}

impl HostProgram {
    /// The program as data and text.
    pub fn source(&self) -> HostSource {
        let functions = Functions::collect(&self.steps);
        let step = |step: &ProgramStep| match step {
            ProgramStep::Constant(value) => HostStep::Constant(value.clone()),
            ProgramStep::Param { id, ty, value } => {
                HostStep::Param { id: *id, ty: ty.clone(), value: value.clone() }
            }
            ProgramStep::Context(context, light) => HostStep::Context(*context, light.clone()),
            ProgramStep::Call { callee, arguments, .. } => {
                HostStep::Call { function: functions.name(callee), arguments: arguments.clone() }
            }
            ProgramStep::Member { value, index } => {
                HostStep::Member { value: *value, index: *index }
            }
        };
        let steps = self.steps.iter().map(step).collect();
        HostSource { wgsl: functions.text, steps }
    }
}

/// The functions of all steps, with the names that they go by in the text.
struct Functions {
    text: String,
    collected: CollectedItems,
    conversions: BTreeMap<(Type, Type), String>,
}

impl Functions {
    fn collect(steps: &[ProgramStep]) -> Self {
        let library = Library::built_in().nodes.values().next().map(|def| def.module.clone());
        let mut items = Items::default();
        let mut conversions = BTreeMap::new();
        for step in steps {
            match step {
                ProgramStep::Call { callee: Callee::Function(function), .. } => {
                    items.want_function(function);
                }
                ProgramStep::Call { callee: Callee::Conversion { from, to }, .. } => {
                    let Conversion::Template(template) =
                        from.convert_to(to).unwrap_or(Conversion::None)
                    else {
                        continue;
                    };
                    let types = [from.wgsl().to_owned(), to.wgsl().to_owned()];
                    for name in identifiers(template).into_iter().chain(types) {
                        if let Some(library) = &library {
                            items.want(library, &name);
                        }
                    }
                    conversions.insert((from.clone(), to.clone()), template);
                }
                _ => {}
            }
        }
        let mut names = Names::default();
        let collected = items.collect(&mut names, &SpecializedFunctions::default());
        let mut text = collected.text();
        let mut named = BTreeMap::new();
        for ((from, to), template) in conversions {
            let name = names.give_exact(&format!("{to}_from_{from}"));
            let known = |word: &str| {
                library.as_ref().map(|library| collected.name(library, word).to_owned())
            };
            let body = rename_identifiers(&Conversion::Template(template).apply("value"), known);
            let _ = writeln!(
                text,
                "fn {name}(value: {}) -> {} {{\n    return {body};\n}}\n",
                from.wgsl(),
                to.wgsl()
            );
            named.insert((from, to), name);
        }
        text.truncate(text.trim_end().len());
        if !text.is_empty() {
            text.push('\n');
        }
        Self { text, collected, conversions: named }
    }

    fn name(&self, callee: &Callee) -> String {
        match callee {
            Callee::Function(function) => {
                self.collected.name(&function.module, &function.name).to_owned()
            }
            Callee::Conversion { from, to } => {
                self.conversions.get(&(from.clone(), to.clone())).cloned().unwrap_or_default()
            }
        }
    }
}
