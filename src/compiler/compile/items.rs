//! The library declarations that a module needs: functions, structs and constants, taken whole from
//! their files.

use std::collections::{HashMap, HashSet, VecDeque};
use std::sync::Arc;

use super::functions::{
    Callee, Code, CodeNames, SpecializedFunctions, each_code, write_line, write_lines,
};
use super::names::Names;
use super::specialize::Function;
use crate::library::{ModuleDeclaration, NodeModule};
use crate::wgsl::{Declaration, DeclarationKind, Field, rename_identifiers};

/// Collects declarations from node modules and gives each a name of its own.
///
/// Modules of a project's own nodes carry their own copies of what they import; equal text is taken
/// once. Two custom nodes may each have a `fn tint`; then the second becomes `tint_2`, with every
/// mention of it. So does a function that is written for certain arguments beside its original.
#[derive(Debug, Default)]
pub(super) struct Items {
    modules: Vec<Arc<NodeModule>>,
    wanted: HashSet<(usize, String)>,
    made: Vec<(usize, usize)>,
}

/// The text of all items, and what functions and types are called in it.
#[derive(Debug, Default)]
pub(super) struct CollectedItems {
    /// Names and texts, in file order.
    items: Vec<(String, String)>,
    names: HashMap<(usize, String), String>,
    modules: Vec<usize>,
    made: HashMap<usize, String>,
}

/// A declaration to be printed.
enum PrintedItem<'a> {
    Original(&'a Declaration, &'a str),
    Made(&'a Declaration, usize),
}

impl Items {
    /// Asks for a function.
    pub(super) fn want_function(&mut self, function: &Function) {
        self.want(&function.module, &function.name);
    }

    /// Asks for a declaration by name, if the module has it.
    pub(super) fn want(&mut self, module: &Arc<NodeModule>, name: &str) {
        let index = self.module(module);
        self.wanted.insert((index, name.to_owned()));
    }

    /// Asks for a function that was written anew.
    pub(super) fn want_made(&mut self, module: &Arc<NodeModule>, made: usize) {
        let index = self.module(module);
        self.made.push((index, made));
    }

    /// Asks for everything that an expression names.
    pub(super) fn want_code(&mut self, module: &Arc<NodeModule>, code: &Code) {
        let index = self.module(module);
        code.each(&mut |code| self.want_name(index, code));
    }

    fn module(&mut self, module: &Arc<NodeModule>) -> usize {
        self.modules.iter().position(|known| Arc::ptr_eq(known, module)).unwrap_or_else(|| {
            self.modules.push(module.clone());
            self.modules.len() - 1
        })
    }

    /// Asks for the declaration that an expression names itself, apart from its parts.
    fn want_name(&mut self, module: usize, code: &Code) {
        match code {
            Code::Constant(name)
            | Code::Struct(name, _)
            | Code::Call(Callee::Original(name), _) => {
                self.wanted.insert((module, name.to_string()));
            }
            Code::Call(Callee::Made(made), _) => self.made.push((module, *made)),
            _ => {}
        }
    }

    /// The functions that were written anew and are called, with what they name.
    fn reached(&mut self, functions: &SpecializedFunctions) -> Vec<(usize, usize)> {
        let mut reached = Vec::new();
        let mut seen = HashSet::new();
        while let Some((module, made)) = self.made.pop() {
            if !seen.insert(made) {
                continue;
            }
            reached.push((module, made));
            let function = &functions.made[made];
            each_code(&function.body.lines, &mut |code| self.want_name(module, code));
            let Some(found) = self.modules[module].declaration(&function.name) else { continue };
            let declaration = found.scanned;
            let types = declaration.fields.iter().map(|field| &field.ty);
            let types = types.chain(&declaration.result).chain(function.body.types());
            let names: Vec<String> = types.flat_map(|ty| crate::wgsl::identifiers(ty)).collect();
            self.wanted.extend(names.into_iter().map(|name| (module, name)));
        }
        reached
    }

    /// Everything asked for with all that it uses, in file order; names are given out by `names`.
    pub(super) fn collect(
        mut self,
        names: &mut Names,
        functions: &SpecializedFunctions,
    ) -> CollectedItems {
        let reached = self.reached(functions);
        let mut used: HashSet<(usize, String)> = HashSet::new();
        let mut open: VecDeque<(usize, String)> = self.wanted.into_iter().collect();
        while let Some((module, name)) = open.pop_front() {
            let Some(declaration) = self.modules[module].declaration(&name) else { continue };
            if used.insert((module, name)) {
                open.extend(declaration.scanned.uses.iter().map(|used| (module, used.clone())));
            }
        }
        let mut collected = CollectedItems {
            modules: self.modules.iter().map(|m| Arc::as_ptr(m) as usize).collect(),
            ..CollectedItems::default()
        };
        let mut by_text: HashMap<&str, String> = HashMap::new();
        let mut ordered: Vec<(usize, ModuleDeclaration<'_>, Option<usize>)> = used
            .iter()
            .filter_map(|(module, name)| {
                self.modules[*module].declaration(name).map(|found| (*module, found, None))
            })
            .collect();
        ordered.extend(reached.iter().filter_map(|&(module, made)| {
            let name = &functions.made[made].name;
            Some((module, self.modules[module].declaration(name)?, Some(made)))
        }));
        ordered.sort_by_key(|(module, declaration, made)| (*module, declaration.start, *made));
        let mut printed = Vec::new();
        for (module, ModuleDeclaration { scanned, text, .. }, made) in ordered {
            if let Some(made) = made {
                collected.made.insert(made, names.give_exact(&scanned.name));
                printed.push((module, PrintedItem::Made(scanned, made)));
                continue;
            }
            let key = (module, scanned.name.clone());
            if let Some(name) = by_text.get(text) {
                collected.names.insert(key, name.clone());
                continue;
            }
            let name = names.give_exact(&scanned.name);
            by_text.insert(text, name.clone());
            collected.names.insert(key, name);
            printed.push((module, PrintedItem::Original(scanned, text)));
        }
        for (module, item) in printed {
            let name = match &item {
                PrintedItem::Original(declaration, _) => {
                    collected.names.get(&(module, declaration.name.clone())).cloned()
                }
                PrintedItem::Made(_, made) => collected.made.get(made).cloned(),
            };
            let name = name.unwrap_or_default();
            let text = match item {
                PrintedItem::Original(declaration, text) => {
                    let is_constant = declaration.kind == DeclarationKind::Constant;
                    // A member of a struct keeps its name, by which it is read after a dot, though
                    // a function may have the same.
                    let members: &[Field] = match declaration.kind {
                        DeclarationKind::Struct => &declaration.fields,
                        _ => &[],
                    };
                    let renamed = |name: &str| {
                        if members.iter().any(|member| member.name == name) {
                            return None;
                        }
                        collected.names.get(&(module, name.to_owned())).cloned()
                    };
                    format!(
                        "{}{}{}",
                        short_doc(declaration),
                        rename_identifiers(text, renamed),
                        if is_constant { "\n" } else { "\n\n" }
                    )
                }
                PrintedItem::Made(declaration, made) => {
                    collected.made_text(module, declaration, made, functions)
                }
            };
            collected.items.push((name, text));
        }
        collected
    }
}

impl CollectedItems {
    /// The text of all items.
    pub(super) fn text(&self) -> String {
        self.items.iter().map(|(_, text)| text.as_str()).collect()
    }

    /// The text of those items that others use, or items that these use.
    pub(super) fn text_for(&self, others: &[&str]) -> String {
        let by_name: HashMap<&str, usize> =
            self.items.iter().enumerate().map(|(i, (name, _))| (name.as_str(), i)).collect();
        let mut used = vec![false; self.items.len()];
        let mut open: Vec<&str> = others.to_vec();
        while let Some(text) = open.pop() {
            for word in words(text) {
                if let Some(&index) = by_name.get(word)
                    && !std::mem::replace(&mut used[index], true)
                {
                    open.push(&self.items[index].1);
                }
            }
        }
        let kept = self.items.iter().zip(used).filter(|(_, used)| *used);
        kept.map(|((_, text), _)| text.as_str()).collect()
    }

    /// The name of a declaration in the collected text.
    pub(super) fn name<'n>(&'n self, module: &Arc<NodeModule>, name: &'n str) -> &'n str {
        let index = self.modules.iter().position(|known| *known == Arc::as_ptr(module) as usize);
        index
            .and_then(|index| self.names.get(&(index, name.to_owned())))
            .map_or(name, String::as_str)
    }

    /// The name of a function that was written anew.
    pub(super) fn made(&self, index: usize) -> &str {
        self.made.get(&index).map_or("", String::as_str)
    }

    /// The names in the code of a module's function.
    pub(super) fn code_names<'n>(
        &'n self,
        module: usize,
        parameters: &'n [Field],
        locals: &'n [String],
    ) -> impl CodeNames + 'n {
        let module = self.modules.iter().position(|known| *known == module).unwrap_or_default();
        NamesOfFunction { items: self, module, parameters, locals }
    }

    fn made_text(
        &self,
        module: usize,
        declaration: &Declaration,
        made: usize,
        functions: &SpecializedFunctions,
    ) -> String {
        let body = &functions.made[made].body;
        let names = NamesOfFunction {
            items: self,
            module,
            parameters: &declaration.fields,
            locals: &body.locals,
        };
        let renamed = |ty: &str| rename_identifiers(ty, |name| Some(names.declaration(name)));
        let parameters: Vec<String> = declaration
            .fields
            .iter()
            .map(|field| format!("{}: {}", field.name, renamed(&field.ty)))
            .collect();
        let result = declaration.result.as_deref().map(renamed).unwrap_or_default();
        let mut text = short_doc(declaration);
        let head = format!("fn {}({}) -> {result} {{", self.made(made), parameters.join(", "));
        write_line(&head, 0, &mut text);
        write_lines(&body.lines, 1, &names, &mut text);
        text.push_str("}\n\n");
        text
    }
}

struct NamesOfFunction<'n> {
    items: &'n CollectedItems,
    module: usize,
    parameters: &'n [Field],
    locals: &'n [String],
}

impl CodeNames for NamesOfFunction<'_> {
    fn parameter(&self, index: usize) -> String {
        self.parameters.get(index).map_or_else(String::new, |field| field.name.clone())
    }

    fn local(&self, index: usize) -> String {
        self.locals.get(index).cloned().unwrap_or_default()
    }

    fn declaration(&self, name: &str) -> String {
        let known = self.items.names.get(&(self.module, name.to_owned()));
        known.cloned().unwrap_or_else(|| name.to_owned())
    }

    fn made(&self, index: usize) -> String {
        self.items.made(index).to_owned()
    }
}

/// Names and numbers in code, without those in comments.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.split(|c: char| !c.is_alphanumeric() && c != '_'))
        .filter(|word| !word.is_empty())
}

/// The docs without what only the editor reads.
fn short_doc(declaration: &Declaration) -> String {
    let lines: Vec<&str> = declaration
        .doc
        .iter()
        .map(String::as_str)
        .take_while(|line| !line.starts_with('@'))
        .collect();
    let mut text = String::new();
    let kept = lines.iter().rposition(|line| !line.is_empty()).map_or(0, |last| last + 1);
    for line in &lines[..kept] {
        text.push_str(format!("/// {line}").trim_end());
        text.push('\n');
    }
    text
}
