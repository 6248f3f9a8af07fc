//! The library declarations that a module needs: functions, structs and constants, taken whole from
//! their files.

use std::collections::{HashMap, HashSet, VecDeque};
use std::sync::Arc;

use super::names::Names;
use super::specialize::Function;
use crate::library::{ModuleDeclaration, NodeModule};
use crate::wgsl::{Declaration, DeclarationKind, rename_identifiers};

/// Collects declarations from node modules and gives each a name of its own.
///
/// Modules of a project's own nodes carry their own copies of what they import; equal text is taken
/// once. Two custom nodes may each have a `fn tint`; then the second becomes `tint_2`, with every
/// mention of it.
#[derive(Debug, Default)]
pub(super) struct Items {
    modules: Vec<Arc<NodeModule>>,
    wanted: HashSet<(usize, String)>,
}

/// The text of all items, and what functions and types are called in it.
#[derive(Debug, Default)]
pub(super) struct CollectedItems {
    pub(super) text: String,
    names: HashMap<(usize, String), String>,
    modules: Vec<usize>,
}

impl Items {
    /// Asks for a function.
    pub(super) fn want_function(&mut self, function: &Function) {
        self.want(&function.module, &function.name);
    }

    /// Asks for a declaration by name, if the module has it.
    pub(super) fn want(&mut self, module: &Arc<NodeModule>, name: &str) {
        let index =
            self.modules.iter().position(|known| Arc::ptr_eq(known, module)).unwrap_or_else(|| {
                self.modules.push(module.clone());
                self.modules.len() - 1
            });
        self.wanted.insert((index, name.to_owned()));
    }

    /// Everything asked for with all that it uses, in file order; names are given out by `names`.
    pub(super) fn collect(self, names: &mut Names) -> CollectedItems {
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
        let mut ordered: Vec<(usize, ModuleDeclaration<'_>)> = used
            .iter()
            .filter_map(|(module, name)| {
                self.modules[*module].declaration(name).map(|found| (*module, found))
            })
            .collect();
        ordered.sort_by_key(|(module, declaration)| (*module, declaration.start));
        let mut printed = Vec::new();
        for (module, ModuleDeclaration { scanned, text, .. }) in ordered {
            let key = (module, scanned.name.clone());
            if let Some(name) = by_text.get(text) {
                collected.names.insert(key, name.clone());
                continue;
            }
            let name = names.give_exact(&scanned.name);
            by_text.insert(text, name.clone());
            collected.names.insert(key, name);
            printed.push((module, scanned, text));
        }
        for (module, declaration, text) in printed {
            let renamed = |name: &str| {
                let name = collected.names.get(&(module, name.to_owned()))?;
                Some(name.clone())
            };
            collected.text.push_str(&short_doc(declaration));
            collected.text.push_str(&rename_identifiers(text, renamed));
            collected.text.push_str(if declaration.kind == DeclarationKind::Constant {
                "\n"
            } else {
                "\n\n"
            });
        }
        collected
    }
}

impl CollectedItems {
    /// The name of a declaration in the collected text.
    pub(super) fn name<'n>(&'n self, module: &Arc<NodeModule>, name: &'n str) -> &'n str {
        let index = self.modules.iter().position(|known| *known == Arc::as_ptr(module) as usize);
        index
            .and_then(|index| self.names.get(&(index, name.to_owned())))
            .map_or(name, String::as_str)
    }
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
