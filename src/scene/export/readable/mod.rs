//! Text of naga's back ends as a person would write it.
//!
//! naga's writers name the values of `let`s, but number what they give lines of their own: results
//! of calls, loads, derivatives and texture reads (`_e52`). They tell locals of different functions
//! apart (`dx_1`), although each function has its own, and drop comments. Nothing of that can be
//! asked of them, so a text is made readable after it was written, in steps that each keep what it
//! computes:
//!
//! - [`pieces`] splits the text into functions and what stands between them, and finds the function
//!   of naga's IR that each one is.
//! - [`inline`] puts values without a name where they are read: a place of a uniform anywhere,
//!   other values where nothing is written in between.
//! - [`names`] gives the values of each function the names that they have in WGSL.
//! - [`loops`] writes loops that count as `for`.
//! - [`brackets`] takes away brackets that change nothing, and long lines are broken.
//! - [`comments`] puts the comments of the WGSL back: before functions, structs, their members and
//!   constants by name, and before statements by the value that they declare.
//!
//! naga writes a statement a line, and all languages here agree about names, calls and brackets, so
//! the steps work on lines and words and know no grammar. A line that they do not know is kept.

mod brackets;
mod comments;
mod inline;
mod loops;
mod names;
mod pieces;
mod reserved;
mod source;
mod word;

use std::collections::{BTreeMap, BTreeSet};

use pieces::{Piece, split};
pub(super) use source::SourceComments;
pub(super) use word::{replace_words, words};

use crate::compile::write_line;
use crate::wgsl::ValidModule;

/// Traits of a language's text that its words alone do not tell.
pub(super) struct Dialect<'a> {
    /// Names in the text of variables that hold uniforms: reading one twice gives the same value.
    pub(super) uniforms: &'a BTreeSet<String>,
    /// Members that hold a vector of three floats packed, by name. A vector is made of them where
    /// they are read.
    pub(super) packed: &'a BTreeSet<String>,
    /// Names that the language has for itself.
    pub(super) reserved: &'a BTreeSet<String>,
    /// Final names of variables and functions of the module.
    pub(super) renamed: &'a BTreeMap<String, String>,
}

/// A text that naga wrote.
pub(super) struct WrittenText<'a> {
    /// The text.
    pub(super) text: String,
    /// The module that the text was written of.
    pub(super) valid: &'a ValidModule,
    /// Names in the text of variables that hold uniforms.
    pub(super) uniforms: BTreeSet<String>,
    /// Other names for variables of the module, by their names in the text.
    pub(super) renamed: BTreeMap<String, String>,
}

impl WrittenText<'_> {
    /// The text made readable, with the comments of its source; `write` writes a module in the same
    /// language.
    ///
    /// # Errors
    /// The error of `write`.
    pub(super) fn readable(
        mut self,
        source: &SourceComments,
        write: impl FnOnce(&ValidModule) -> Result<String, String>,
    ) -> Result<String, String> {
        let module = &self.valid.module;
        let reserved = reserved::reserved(&names::wanted_names(module), write)?;
        self.renamed.extend(names::plain_names(module, &self.text));
        let packed = packed_members(&self.text);
        let dialect = Dialect {
            uniforms: &self.uniforms,
            packed: &packed,
            reserved: &reserved,
            renamed: &self.renamed,
        };
        let mut pieces = split(&self.text, module);
        let is_pure = module.has_no_side_effects();
        for piece in &mut pieces {
            if let Piece::Function(function) = piece
                && function.ir.is_some()
            {
                inline::inline(function, &dialect, is_pure);
                names::rename(function, module, &dialect);
            }
        }
        comments::place(&mut pieces, source);
        let text: String = pieces.iter().map(Piece::text).collect();
        let text = replace_words(&text, |word| self.renamed.get(word).cloned());
        Ok(written_as_by_people(&loops::counted(&text)))
    }
}

/// The text without needless brackets and statements, its declarations apart, its statements broken
/// where they are long.
fn written_as_by_people(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    let mut lines = text.trim_end().lines().peekable();
    let mut is_after_block = false;
    while let Some(line) = lines.next() {
        let next = lines.peek().copied().unwrap_or_default();
        if line == "    return;" && next == "}" {
            continue;
        }
        if is_after_block && !line.is_empty() {
            written.push('\n');
        }
        is_after_block = line.starts_with('}');
        let returned = returned_at_once(line, next);
        if returned.is_some() {
            lines.next();
        }
        let line = brackets::without_needless(returned.as_deref().unwrap_or(line));
        let statement = line.trim_start();
        let indent = line.len() - statement.len();
        if statement.starts_with(['#', '/']) || !indent.is_multiple_of(4) {
            written.push_str(&line);
            written.push('\n');
        } else {
            write_line(statement, indent / 4, &mut written);
        }
    }
    written
}

/// `return VALUE;` of a line that declares a value and the next one, which returns the value. naga
/// calls such a value after its type.
fn returned_at_once(line: &str, next: &str) -> Option<String> {
    let declared = inline::DeclarationLine::of(line)?;
    let value = declared.value.filter(|value| !value.starts_with('{'))?;
    let name = next.trim_start().strip_prefix("return ")?.strip_suffix(';')?;
    let ty = declared.ty.strip_prefix("const ")?.to_lowercase();
    let is_same = name == declared.name && (ty == name || pieces::base(name) == Some(ty.as_str()));
    is_same.then(|| format!("{}return {value};", " ".repeat(declared.indent)))
}

/// Members of structs that hold vectors packed, as Metal has them.
fn packed_members(text: &str) -> BTreeSet<String> {
    let member = |line: &str| {
        let name = line.trim().strip_prefix("metal::packed_float3 ")?.strip_suffix(';')?;
        Some(name.to_owned())
    };
    text.lines().filter_map(member).collect()
}

/// Properties of modules that decide what may be moved.
trait SideEffects {
    /// True if no function writes anything but variables of its own.
    fn has_no_side_effects(&self) -> bool;
}

impl SideEffects for naga::Module {
    fn has_no_side_effects(&self) -> bool {
        let takes_pointer = |function: &naga::Function| {
            let is_pointer = |argument: &naga::FunctionArgument| {
                self.types[argument.ty].inner.pointer_space().is_some()
            };
            function.arguments.iter().any(is_pointer)
        };
        let is_read = |variable: &naga::GlobalVariable| {
            matches!(variable.space, naga::AddressSpace::Uniform | naga::AddressSpace::Handle)
        };
        self.global_variables.iter().all(|(_, variable)| is_read(variable))
            && !self.functions.iter().any(|(_, function)| takes_pointer(function))
    }
}
