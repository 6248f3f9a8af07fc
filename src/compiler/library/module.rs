//! Module of nodes: their WGSL, and what naga and the interpreter make of it.
//!
//! The nodes that Chiaro ships are one module of some 140 files, of which a look needs a few. So
//! their ports and docs are read from the scan alone, and naga parses a file, with all that it uses
//! from other files, when somebody first asks for one of its functions. A person's own node is a
//! module of its own, which naga has validated whole before the node joins the library.

use std::collections::{BTreeSet, HashMap};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use chiaro_locale::tr;
use naga::Handle;
use rustc_hash::FxHashMap;

use super::rules::{FormRule, read_rules};
use crate::diag::Diagnostic;
use crate::interp::{Derivatives, FunctionOptions, Literals, Program};
use crate::wgsl::{self, Declaration, LinkedSource, Operations, ValidModule, WgslError};

/// WGSL with the functions of one or more nodes.
#[derive(Debug)]
pub struct NodeModule {
    /// Text of all files, with a map back to them.
    pub linked: LinkedSource,
    /// Places of declarations by name: the file's index, and the declaration's among those of the
    /// file.
    by_name: HashMap<String, (usize, usize)>,
    /// Rules by function.
    rules: HashMap<String, Vec<FormRule>>,
    parts: ModuleParts,
    programs: Mutex<HashMap<String, Result<Arc<Program>, Diagnostic>>>,
    /// Greatest differences of balanced forms, by function.
    form_errors: Mutex<HashMap<String, f64>>,
}

/// Parts of a module that naga sees.
#[derive(Debug)]
enum ModuleParts {
    /// All of the text at once.
    Whole(Box<ModulePart>),
    /// Each file with all that it uses, once somebody has asked for one of its functions.
    Files(Vec<OnceLock<Result<ModulePart, Diagnostic>>>),
}

/// Part of a module as naga parsed and validated it.
#[derive(Debug)]
struct ModulePart {
    valid: ValidModule,
    literals: Literals,
    operations: Operations,
    functions: FxHashMap<String, Handle<naga::Function>>,
}

/// Declaration in a module.
#[derive(Clone, Copy, Debug)]
pub struct ModuleDeclaration<'a> {
    /// Declaration as scanned; ranges in it begin at the beginning of its file.
    pub scanned: &'a Declaration,
    /// Text without the docs.
    pub text: &'a str,
    /// First byte of the text in the module.
    pub start: usize,
}

impl NodeModule {
    /// Module whose files are parsed and validated when they are first used.
    pub fn of_files(linked: LinkedSource) -> Self {
        let parts = linked.files.iter().map(|_| OnceLock::new()).collect();
        Self::new(linked, ModuleParts::Files(parts))
    }

    /// Module of text that naga has validated whole.
    ///
    /// `text` is what naga read: the linked text, with a function for the form of every rule.
    pub fn of_valid(linked: LinkedSource, text: String, valid: ValidModule) -> Self {
        let part = ModulePart::new(valid, text);
        Self::new(linked, ModuleParts::Whole(Box::new(part)))
    }

    fn new(linked: LinkedSource, parts: ModuleParts) -> Self {
        let mut by_name = HashMap::new();
        let mut rules = HashMap::new();
        for (file, of_file) in linked.files.iter().enumerate() {
            for (index, declaration) in of_file.scan.declarations.iter().enumerate() {
                by_name.insert(declaration.name.clone(), (file, index));
                // A line that is no rule was reported where the file was read.
                let own = read_rules(declaration).unwrap_or_default();
                if !own.is_empty() {
                    rules.insert(declaration.name.clone(), own);
                }
            }
        }
        Self {
            linked,
            by_name,
            rules,
            parts,
            programs: Mutex::default(),
            form_errors: Mutex::default(),
        }
    }

    /// Forms that a function comes to where facts about its arguments hold, the cheapest first.
    pub fn rules(&self, function: &str) -> &[FormRule] {
        self.rules.get(function).map_or(&[], Vec::as_slice)
    }

    /// All functions that have rules.
    pub fn ruled_functions(&self) -> impl Iterator<Item = &str> {
        self.rules.keys().map(String::as_str)
    }

    /// Module of naga with a function, and the literals of the text that naga read.
    ///
    /// # Errors
    /// Those of [`valid`](Self::valid).
    pub fn read(&self, function: &str) -> Result<(&ValidModule, &Literals), Diagnostic> {
        self.part(function).map(|part| (&part.valid, &part.literals))
    }

    /// Top-level declaration by name.
    pub fn declaration(&self, name: &str) -> Option<ModuleDeclaration<'_>> {
        self.by_name.get(name).and_then(|&place| self.declaration_at(place))
    }

    fn declaration_at(&self, (file, index): (usize, usize)) -> Option<ModuleDeclaration<'_>> {
        let file = self.linked.files.get(file)?;
        let scanned = file.scan.declarations.get(index)?;
        let start = file.span.start + scanned.body.start;
        let text = self.linked.text.get(start..file.span.start + scanned.body.end)?;
        Some(ModuleDeclaration { scanned, text, start })
    }

    /// Module of naga with a function, and with all that the function uses.
    ///
    /// # Errors
    /// A diagnostic that says why naga refuses the function's file, or that there is no such
    /// function.
    pub fn valid(&self, function: &str) -> Result<&ValidModule, Diagnostic> {
        self.part(function).map(|part| &part.valid)
    }

    /// Module of naga with a function, and the function in it; `None` where naga refuses the
    /// function's file, or where there is no such function.
    pub fn function(&self, name: &str) -> Option<(&ValidModule, Handle<naga::Function>)> {
        let part = self.part(name).ok()?;
        Some((&part.valid, *part.functions.get(name)?))
    }

    /// Number of operations of a function, counted in the IR; 0 where there is no such function.
    pub fn operations(&self, function: &str) -> u64 {
        let count = |part: &ModulePart| {
            let handle = part.functions.get(function)?;
            Some(part.operations.of_handle(*handle))
        };
        self.part(function).ok().and_then(count).unwrap_or_default()
    }

    /// Number of loops of a function, with those of the functions that it calls; 0 where there is
    /// no such function.
    pub fn loops(&self, function: &str) -> u64 {
        let count = |part: &ModulePart| {
            let handle = part.functions.get(function)?;
            Some(part.operations.loops_of_handle(*handle))
        };
        self.part(function).ok().and_then(count).unwrap_or_default()
    }

    /// Greatest difference that forms of the balanced tier make of a function, and of all that it
    /// calls.
    pub fn form_error(&self, function: &str) -> f64 {
        let mut known = self.form_errors.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(&error) = known.get(function) {
            return error;
        }
        let Ok(valid) = self.valid(function) else { return 0.0 };
        // naga lists a function after all that it calls.
        let mut errors: Vec<f64> = Vec::new();
        for (_, called) in valid.module.functions.iter() {
            let name = called.name.as_deref().unwrap_or_default();
            let own = self.rules(name).iter().filter(|rule| rule.is_balanced());
            let own = own.filter_map(|rule| rule.bound).fold(0.0, f64::max);
            let inner = called.expressions.iter().filter_map(|(_, expression)| match expression {
                naga::Expression::CallResult(callee) => errors.get(callee.index()).copied(),
                _ => None,
            });
            let error = inner.fold(own, f64::max);
            errors.push(error);
            known.insert(name.to_owned(), error);
        }
        known.get(function).copied().unwrap_or_default()
    }

    /// Program of a function that runs on the CPU, with constants at f64; compiled on the first
    /// call. Derivatives are 0 in the program, because all values before the fragment are the same
    /// in all fragments.
    ///
    /// # Errors
    /// A diagnostic that names the part of the function that the interpreter cannot run, and those
    /// of [`valid`](Self::valid).
    pub fn program(&self, function: &str) -> Result<Arc<Program>, Diagnostic> {
        let mut programs = self.programs.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(program) = programs.get(function) {
            return program.clone();
        }
        let program = self.part(function).and_then(|part| {
            let options = FunctionOptions {
                derivatives: Derivatives::Zero,
                literals: Some(&part.literals),
                ..FunctionOptions::default()
            };
            Program::compile(&part.valid.module, function, options).map(Arc::new)
        });
        programs.insert(function.to_owned(), program.clone());
        program
    }

    fn part(&self, function: &str) -> Result<&ModulePart, Diagnostic> {
        let files = match &self.parts {
            ModuleParts::Whole(part) => return Ok(part),
            ModuleParts::Files(files) => files,
        };
        let Some(&(file, _)) = self.by_name.get(function) else {
            let message = tr!("there is no function `{function}`");
            return Err(Diagnostic::error("interp-unknown-function", message));
        };
        files[file].get_or_init(|| self.parse_file(file)).as_ref().map_err(Diagnostic::clone)
    }

    /// File as naga reads it: the file's declarations, and all that they use.
    fn parse_file(&self, file: usize) -> Result<ModulePart, Diagnostic> {
        let own = self.linked.files[file].scan.declarations.len();
        let mut open: Vec<(usize, usize)> = (0..own).map(|index| (file, index)).collect();
        let mut used = BTreeSet::new();
        let mut forms = String::new();
        while let Some((file, index)) = open.pop() {
            if used.insert((file, index)) {
                let declaration = &self.linked.files[file].scan.declarations[index];
                open.extend(declaration.uses.iter().filter_map(|name| self.by_name.get(name)));
                for rule in self.rules(&declaration.name) {
                    forms.push_str(&rule.text);
                    let names = wgsl::identifiers(&rule.text);
                    open.extend(names.iter().filter_map(|name| self.by_name.get(name)));
                }
            }
        }
        let mut text = String::new();
        // Begin of each declaration in the part, and in the module.
        let mut begins = Vec::new();
        for declaration in used.into_iter().filter_map(|place| self.declaration_at(place)) {
            begins.push((text.len(), declaration.start));
            text.push_str(declaration.text);
            text.push('\n');
        }
        text.push_str(&forms);
        match wgsl::parse(&text) {
            Ok(valid) => Ok(ModulePart::new(valid, text)),
            Err(error) => {
                let span = error.span.and_then(|span| {
                    let &(begin, start) =
                        begins.iter().rev().find(|(begin, _)| *begin <= span.start)?;
                    Some(span.start - begin + start..span.end - begin + start)
                });
                Err(refused(&self.linked, "invalid-wgsl", &WgslError { span, ..error }))
            }
        }
    }
}

impl ModulePart {
    fn new(valid: ValidModule, text: String) -> Self {
        let operations = Operations::of(&valid.module);
        let functions = valid.module.functions.iter();
        let functions =
            functions.filter_map(|(handle, function)| Some((function.name.clone()?, handle)));
        let functions = functions.collect();
        Self { valid, literals: Literals::of(text), operations, functions }
    }
}

/// Diagnostic of an error in linked text, with the file and the line.
pub(super) fn refused(linked: &LinkedSource, code: &'static str, error: &WgslError) -> Diagnostic {
    let mut problem = Diagnostic::error(code, error.message.clone());
    let place = error.span.as_ref().and_then(|span| linked.locate(span.start));
    if let (Some((file, at)), Some(span)) = (place, &error.span) {
        problem = problem.in_file(file).at(at);
        let line = linked.text[span.start..].lines().next().unwrap_or_default().trim();
        problem = problem.hint(tr!("it is about `{line}`"));
    }
    problem
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;
    use crate::wgsl::NamedSource;

    #[test]
    fn every_shipped_node_is_valid_by_itself_and_with_all_others() {
        let library = Library::built_in();
        assert!(library.problems.is_empty(), "{:?}", library.problems);
        let module = &library.nodes["profile"].module;
        let text = crate::library::rules::with_forms(&module.linked).expect("all are rules");
        let whole = wgsl::parse(&text)
            .map_err(|error| refused(&module.linked, "invalid-wgsl", &error))
            .unwrap_or_else(|problem| panic!("{problem}"));
        let operations = Operations::of(&whole.module);
        for def in library.nodes.values() {
            assert!(Arc::ptr_eq(module, &def.module), "`{}` has a module of its own", def.kind);
            let prepare = def.prepare.iter().map(|prepare| &prepare.function);
            for function in def.variants.iter().map(|variant| &variant.function).chain(prepare) {
                if let Err(problem) = module.valid(function) {
                    panic!("{problem}");
                }
                let count = operations.of_function(&whole.module, function);
                assert_eq!(module.operations(function), count, "`{function}` says the same alone");
            }
        }
    }

    #[test]
    fn a_file_is_parsed_when_it_is_first_used_and_errors_in_it_name_their_line() {
        let right = "fn right(x: f32) -> f32 { return x * THREE; }\nconst THREE = 3.0;\n";
        let wrong = "/// Wrong.\n/// @param x : A number.\nfn wrong(x: f32) -> f32 {\n    \
                     return right(x) + nowhere;\n}\n";
        let sources = [("right.wgsl", right), ("wrong.wgsl", wrong)];
        let sources = sources.map(|(name, text)| NamedSource { name, text });
        let module = NodeModule::of_files(wgsl::link(&sources).unwrap());
        let program = module.program("right").unwrap();
        let nine = program.call(&[3.0.into()], crate::interp::Precision::F64).unwrap();
        assert_eq!((nine, module.operations("right")), (9.0.into(), 1));
        let problem = module.valid("wrong").unwrap_err();
        assert!(problem.to_string().starts_with("wrong.wgsl:4:"), "{problem}");
        assert_eq!(module.program("wrong").unwrap_err().code, "invalid-wgsl");
        assert_eq!(module.valid("none").unwrap_err().code, "interp-unknown-function");
    }
}
