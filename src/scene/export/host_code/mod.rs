//! Host work as code: functions of WGSL in the languages of programs that draw.
//!
//! What a program computes before it draws (`prepare` of nodes, lights in their frames, keys) is
//! written once, in WGSL. [`translate`] writes it in another language, from naga's IR: names,
//! comments and structure stay, floats become 64 bits wide, and constants are read at that width as
//! [`interp`](crate::interp) reads them. A language is a file and a row of [`HOST_LANGUAGES`].

mod csharp;
mod dialect;
mod expressions;
mod function;
mod gdscript;
mod javascript;
mod module;
mod names;
mod osl;
mod python;
mod pythonic;
mod rust;
mod types;
mod uses;

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::interp::Literals;
use crate::wgsl;

/// Language that host code is written in.
pub struct HostLanguage {
    /// Name of the language in files and options.
    pub slug: &'static str,
    /// Name of the language for people.
    pub label: &'static str,
    dialect: &'static (dyn dialect::Dialect + Sync),
}

impl std::fmt::Debug for HostLanguage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.label)
    }
}

/// JavaScript.
pub const JAVASCRIPT: HostLanguage =
    HostLanguage { slug: "javascript", label: "JavaScript", dialect: &javascript::JavaScript };

/// Python 3. The text needs `import copy, math, struct` before it.
pub const PYTHON: HostLanguage =
    HostLanguage { slug: "python", label: "Python", dialect: &python::Python };

/// Rust.
pub const RUST: HostLanguage = HostLanguage { slug: "rust", label: "Rust", dialect: &rust::Rust };

/// GDScript, the language of Godot 4: static functions of a script.
pub const GDSCRIPT: HostLanguage =
    HostLanguage { slug: "gdscript", label: "GDScript", dialect: &gdscript::GdScript };

/// C#, as Unity has it. The text are members of a static class, and needs `using System;` before
/// it.
pub const CSHARP: HostLanguage =
    HostLanguage { slug: "csharp", label: "C#", dialect: &csharp::CSharp };

/// The Open Shading Language, in which looks are written as a whole; [`with_osl_preamble`] adds
/// what the text needs. No language of host programs: floats are 32 bits wide.
pub(super) const OSL: HostLanguage = HostLanguage { slug: "osl", label: "OSL", dialect: &osl::Osl };

pub(super) use osl::with_preamble as with_osl_preamble;

/// All languages of host code.
pub const HOST_LANGUAGES: [&HostLanguage; 5] = [&JAVASCRIPT, &PYTHON, &RUST, &GDSCRIPT, &CSHARP];

impl HostLanguage {
    /// Name that a function of WGSL has in the language.
    pub fn function_name(&self, name: &str) -> String {
        let name = self.dialect.styled(name, dialect::NameOf::Function);
        if self.dialect.keywords().contains(&name.as_str()) { name + "_" } else { name }
    }

    /// Name that a member of a struct of WGSL has in the language.
    pub fn member_name(&self, name: &str) -> String {
        self.dialect.styled(name, dialect::NameOf::Member)
    }
}

/// Functions of a WGSL source by their names, with all that they call, in a language.
///
/// # Errors
/// - `host-code`: the source is no WGSL, or uses what the language cannot express: textures,
///   pointers among parameters, derivatives. The message names the function.
pub fn translate(
    source: &str,
    functions: &[&str],
    language: &HostLanguage,
) -> Result<String, Diagnostic> {
    let valid = wgsl::parse(source).map_err(|error| {
        Diagnostic::error("host-code", tr!("functions for the host are no WGSL: {error}"))
    })?;
    let literals = Literals::of(source);
    module::write(&valid, &literals, functions, language.dialect).map_err(|(function, refusal)| {
        let message = tr!(
            "the function `{function}` uses {part}, which host code in {language} cannot express",
            part = refusal.0,
            language = language.label
        );
        Diagnostic::error("host-code", message)
            .hint(tr!("wire the value by other nodes, or let it be computed per fragment"))
    })
}
