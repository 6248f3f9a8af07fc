//! The whole of a look's host work as one WGSL source: lights in their frames, keys, and the
//! numbers of every module's `Look` uniform.
//!
//! `host_code` translates the source, so that each language has the same program; `interp` runs it
//! in tests. `keyed`, where the look has keys, takes the settings (parameters and lights) to those
//! that hold in the surroundings; `MODULE_numbers` makes the numbers of a module's uniform of them,
//! one for each four bytes.

mod keyed;
mod literal;
mod modules;
mod settings;
mod templates;

use std::collections::BTreeMap;

use chiaro_locale::tr;

use super::exposed::Parameters;
use super::modules::Modules;
use crate::compile::TypedGraph;
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::interp::Value;
use crate::library::Type;
use crate::wgsl::scan;

pub(super) use literal::{literal, number, vec3};
pub(super) use settings::{LightSetting, ParameterSetting};

/// Functions of the program that are the same for all looks.
const HOST: &str = include_str!("host.wgsl");

/// A look's host work.
#[derive(Clone, Debug)]
pub(super) struct HostWork {
    /// The source, in WGSL.
    pub(super) wgsl: String,
    /// Parameters that may be set, or that keys move.
    pub(super) parameters: Vec<ParameterSetting>,
    /// Lights that the program reads.
    pub(super) lights: Vec<LightSetting>,
    /// True if `keyed` is among the functions.
    pub(super) is_keyed: bool,
    /// Modules that have a `Look` uniform.
    pub(super) modules: Vec<ModuleNumbers>,
    /// Other objects whose distances drive keys: their ids and members of the surroundings.
    pub(super) near: Vec<(String, String)>,
}

/// The numbers of a module's uniform.
#[derive(Clone, Debug)]
pub(super) struct ModuleNumbers {
    /// Name of the module.
    pub(super) module: &'static str,
    /// Name of the function that makes the numbers.
    pub(super) function: String,
    /// Words that hold integers.
    pub(super) integers: Vec<usize>,
    /// The same numbers as a struct, for languages that call the program in the shader itself.
    pub(super) structure: StructFunction,
}

/// A function that makes the struct `Look` of a module's shader. The source of the program does not
/// have the function: the struct is the shader's.
#[derive(Clone, Debug)]
pub(super) struct StructFunction {
    /// Name of the function.
    pub(super) name: String,
    /// Statements of the function, which takes `settings` and `around`.
    body: String,
}

impl StructFunction {
    /// The function in WGSL.
    pub(super) fn wgsl(&self) -> String {
        format!(
            "/// What is known before the fragment, of parameters and lights.\n\
             fn {}(settings: Settings, around: Surroundings) -> Look {{\n{}}}\n",
            self.name, self.body
        )
    }
}

/// Builds the program of a look.
///
/// # Errors
/// `host-program`: a part of the look that the program cannot hold, in words.
pub(super) fn build(
    look: &Look,
    typed: &TypedGraph,
    modules: &Modules,
    parameters: &Parameters,
) -> Result<HostWork, Diagnostic> {
    let mut declarations = Declarations::default();
    declarations.add(HOST)?;
    for host in modules.modules.iter().filter_map(|module| module.host()) {
        declarations.add(&host.source.wgsl)?;
    }
    let settings = settings::Settings::of(look, modules, parameters)?;
    let near = keyed::near_objects(look);
    let mut functions = String::new();
    let mut found = Vec::new();
    for module in &modules.modules {
        if let Some(numbers) = modules::write(module, &settings, &mut functions)? {
            found.push(numbers);
        }
    }
    let draw = modules.modules.iter().find(|module| module.is_draw());
    let keys = match draw.and_then(|module| module.host()) {
        Some(host) => keyed::write(look, typed, host, &settings)?,
        None => None,
    };
    let mut text = declarations.text(&near);
    text += &settings.wgsl();
    text += keys.as_deref().unwrap_or_default();
    text += &functions;
    Ok(HostWork {
        wgsl: text,
        parameters: settings.parameters,
        lights: settings.lights,
        is_keyed: keys.is_some(),
        modules: found,
        near,
    })
}

/// The error of a look whose host work cannot be written.
fn problem(message: impl Into<String>) -> Diagnostic {
    Diagnostic::error("host-program", message)
        .hint(tr!("export languages instead, and compute these numbers as LOOK.json says"))
}

/// Declarations of several sources, each once.
#[derive(Default)]
struct Declarations {
    known: BTreeMap<String, String>,
    order: Vec<String>,
}

impl Declarations {
    fn add(&mut self, source: &str) -> Result<(), Diagnostic> {
        for declaration in scan(source).declarations {
            let text = source.get(declaration.span.clone()).unwrap_or_default().to_owned();
            match self.known.get(&declaration.name) {
                Some(known) if *known == text => {}
                Some(_) => {
                    return Err(problem(tr!(
                        "two functions are called `{name}`",
                        name = declaration.name
                    )));
                }
                None => {
                    self.order.push(declaration.name.clone());
                    self.known.insert(declaration.name, text);
                }
            }
        }
        Ok(())
    }

    fn text(&self, near: &[(String, String)]) -> String {
        let mut text = String::new();
        for name in &self.order {
            let mut declaration = self.known[name].clone();
            if name == "Surroundings"
                && let Some(end) = declaration.rfind('}')
            {
                let members: String =
                    near.iter().map(|(_, member)| format!("    {member}: f32,\n")).collect();
                declaration.insert_str(end, &members);
            }
            text += &declaration;
            text += "\n\n";
        }
        text
    }
}

/// A name for WGSL like `wanted`, which none of `taken` is.
fn identifier(wanted: &str, taken: &[&str]) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let mut name: String = wanted.chars().map(kept).collect::<String>().to_lowercase();
    while name.contains("__") {
        name = name.replace("__", "_");
    }
    let name = name.trim_matches('_').to_owned();
    let name = match name.chars().next() {
        None => "value".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("value_{name}"),
        Some(_) => name,
    };
    // A word with an end is none that the language has for itself.
    let is_free = |name: &String| !taken.contains(&name.as_str()) && is_no_word(name);
    let ended = [name.clone(), format!("{name}_of_look")].into_iter();
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    ended.chain(numbered).find(is_free).unwrap_or(name)
}

/// True for a name that WGSL takes as a member's.
fn is_no_word(name: &str) -> bool {
    crate::wgsl::parse(&format!(
        "struct Names {{ {name}: f32 }}\nfn f(n: Names) -> f32 {{ return n.{name}; }}"
    ))
    .is_ok()
}

/// The value of a parameter's type that a document's value is.
fn typed(value: &crate::document::Value, ty: &Type) -> Option<Value> {
    crate::compile::typed_value(value, ty).ok()
}
