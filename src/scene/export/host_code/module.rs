//! Modules: the functions that are asked for, with all that they use.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use chiaro_locale::tr;
use naga::{Handle, Module};

use super::dialect::{Dialect, Helpers, Kind, MemberSource, NameOf, Term, ValueType};
use super::function::{FunctionWriter, Refusal};
use super::names::Names;
use super::types;
use crate::interp::Literals;
use crate::wgsl::{Declaration, DeclarationKind, Scan, ValidModule, scan};

/// Writer of a module: state that the writers of its functions share.
pub(super) struct ModuleWriter<'a> {
    pub(super) module: &'a Module,
    pub(super) dialect: &'a dyn Dialect,
    pub(super) literals: &'a Literals,
    pub(super) helpers: RefCell<Helpers>,
    /// Names that no value of a function can have.
    pub(super) names: Names,
    functions: HashMap<Handle<naga::Function>, String>,
    structures: HashMap<String, String>,
    constants: HashMap<String, String>,
    used_constants: RefCell<BTreeSet<String>>,
    /// Constants whose type naga left open, as the text uses them.
    open_constants: RefCell<BTreeMap<String, (Kind, Term)>>,
}

impl ModuleWriter<'_> {
    /// Name of a function in the language.
    pub(super) fn function(&self, function: Handle<naga::Function>) -> String {
        self.functions[&function].clone()
    }

    /// Name of a struct in the language.
    pub(super) fn structure(&self, name: &str) -> String {
        self.structures.get(name).cloned().unwrap_or_else(|| name.to_owned())
    }

    /// Name of a constant in the language; the text uses it from now on.
    pub(super) fn constant(&self, name: &str) -> Option<String> {
        let found = self.constants.get(name)?;
        self.used_constants.borrow_mut().insert(name.to_owned());
        Some(found.clone())
    }

    /// The constant that the source names at a span, where it names one alone, in the place of a
    /// number of that kind.
    pub(super) fn constant_at(
        &self,
        span: naga::Span,
        kind: Kind,
        number: &Term,
    ) -> Option<String> {
        let text = self.literals.source().get(span.to_range()?)?;
        let name = self.constants.get(text)?;
        let typed = self.module.constants.iter().find(|(_, it)| it.name.as_deref() == Some(text));
        if let Some((_, constant)) = typed {
            let is_same = types::of(self.module, constant.ty) == Some(ValueType::Scalar(kind));
            return self.constant(text).filter(|_| is_same);
        }
        let mut open = self.open_constants.borrow_mut();
        let known = open.entry(text.to_owned()).or_insert_with(|| (kind, number.clone()));
        (known.0 == kind).then(|| name.clone())
    }
}

/// Writes functions of a WGSL module in a language, with helpers, structs, constants and the
/// functions that they call, callees first.
///
/// # Errors
/// What the language cannot express, and the function that uses it.
pub(super) fn write(
    valid: &ValidModule,
    literals: &Literals,
    roots: &[&str],
    dialect: &dyn Dialect,
) -> Result<String, (String, Refusal)> {
    let module = &valid.module;
    let scanned = scan(literals.source());
    let wanted = reachable(module, roots);
    let mut names = Names::default();
    names.reserve(dialect.keywords().iter().map(|word| (*word).to_owned()));
    let declared = |kind: DeclarationKind| {
        scanned.declarations.iter().filter(move |declaration| declaration.kind == kind)
    };
    let mut named = |kind: DeclarationKind, of: NameOf| -> HashMap<String, String> {
        let mut named = |name: &String| (name.clone(), names.give(&dialect.styled(name, of)));
        declared(kind).map(|it| named(&it.name)).collect()
    };
    // Structs come first: where types are written, they are called by their own names.
    let structures = named(DeclarationKind::Struct, NameOf::Structure);
    let constants = named(DeclarationKind::Constant, NameOf::Constant);
    let mut functions = HashMap::new();
    for (handle, function) in module.functions.iter().filter(|(it, _)| wanted.contains(it)) {
        let name = function.name.as_deref().unwrap_or("function");
        functions.insert(handle, names.give(&dialect.styled(name, NameOf::Function)));
    }
    names.reserve(HELPERS.iter().map(|name| (*name).to_owned()));
    let shared = ModuleWriter {
        module,
        dialect,
        literals,
        helpers: RefCell::default(),
        names,
        functions,
        structures,
        constants,
        used_constants: RefCell::default(),
        open_constants: RefCell::default(),
    };
    let mut text = String::new();
    for (handle, function) in module.functions.iter().filter(|(it, _)| wanted.contains(it)) {
        let name = function.name.clone().unwrap_or_default();
        let failed = |refusal: Refusal| (name.clone(), refusal);
        let writer = FunctionWriter::new(&shared, function, &valid.info[handle]).map_err(failed)?;
        let doc = doc_of(&scanned, &name);
        text += &writer.write(&shared.function(handle), &doc).map_err(failed)?;
        text.push('\n');
    }
    let constants = constants_text(&shared, &scanned).map_err(|it| ("constants".to_owned(), it))?;
    let structures = structures_text(&shared, &scanned);
    let helpers = helpers_text(&shared);
    let types = dialect.types_of(&[&*constants, &structures, &helpers, &text].concat());
    let parts = [constants, structures, helpers, text, types];
    let mut whole = String::new();
    for part in parts.iter().filter(|part| !part.is_empty()) {
        if !whole.is_empty() {
            whole.push('\n');
        }
        whole += part.trim_end_matches('\n');
        whole.push('\n');
    }
    Ok(whole)
}

/// Names of helpers in any language, which no value of a function has.
pub(super) const HELPERS: &[&str] = &[
    "all",
    "any",
    "cross",
    "distance",
    "dot",
    "fma",
    "fract",
    "length",
    "mix",
    "normalize",
    "pow",
    "radians",
    "degrees",
    "max",
    "min",
    "clamp",
    "reflect",
    "round",
    "saturate",
    "smoothstep",
    "step",
    "transpose",
];

/// Functions that are reached from those of these names.
fn reachable(module: &Module, roots: &[&str]) -> BTreeSet<Handle<naga::Function>> {
    let is_root = |function: &naga::Function| {
        function.name.as_deref().is_some_and(|name| roots.contains(&name))
    };
    let mut open: Vec<_> =
        module.functions.iter().filter(|(_, it)| is_root(it)).map(|(handle, _)| handle).collect();
    let mut found = BTreeSet::new();
    while let Some(handle) = open.pop() {
        if found.insert(handle) {
            callees(&module.functions[handle].body, &mut open);
        }
    }
    found
}

fn callees(block: &naga::Block, found: &mut Vec<Handle<naga::Function>>) {
    for statement in block {
        if let naga::Statement::Call { function, .. } = statement {
            found.push(*function);
        }
        super::uses::each_block(statement, |inner| callees(inner, found));
    }
}

/// Doc of a declaration: its first paragraph, which says what it is.
fn doc_of(scanned: &Scan, name: &str) -> Vec<String> {
    let found = scanned.declarations.iter().find(|declaration| declaration.name == name);
    found.map(paragraph).unwrap_or_default()
}

fn paragraph(declaration: &Declaration) -> Vec<String> {
    let is_text = |line: &&String| !line.trim().is_empty() && !line.starts_with('@');
    declaration.doc.iter().take_while(is_text).cloned().collect()
}

fn constants_text(shared: &ModuleWriter<'_>, scanned: &Scan) -> Result<String, Refusal> {
    let mut text = String::new();
    let used = shared.used_constants.borrow().clone();
    let mut add = |name: &String, ty: &ValueType, value: &Term| {
        for line in shared.dialect.doc(&doc_of(scanned, name)) {
            text += &line;
            text.push('\n');
        }
        text += &shared.dialect.constant(&shared.constants[name], ty, value);
        text.push('\n');
    };
    for (name, (kind, value)) in shared.open_constants.borrow().iter() {
        add(name, &ValueType::Scalar(*kind), value);
    }
    for (_, constant) in shared.module.constants.iter() {
        let Some(name) = constant.name.as_ref().filter(|name| used.contains(*name)) else {
            continue;
        };
        let unknown = || Refusal(tr!("the constant `{name}`"));
        let ty = types::of(shared.module, constant.ty).ok_or_else(unknown)?;
        let value = global(shared, constant.init).ok_or_else(unknown)?;
        add(name, &ty, &value);
    }
    Ok(text)
}

/// The value of a constant.
fn global(shared: &ModuleWriter<'_>, handle: Handle<naga::Expression>) -> Option<Term> {
    use naga::{Expression, Literal};
    let expressions = &shared.module.global_expressions;
    let dialect = shared.dialect;
    Some(match &expressions[handle] {
        Expression::Literal(Literal::F32(single)) => {
            let wide = shared.literals.wide(expressions.get_span(handle), *single);
            dialect.float(wide.unwrap_or_else(|| f64::from(*single)))
        }
        Expression::Literal(Literal::AbstractFloat(x)) => dialect.float(*x),
        Expression::Literal(Literal::U32(x)) => dialect.integer(i64::from(*x), Kind::Unsigned),
        Expression::Literal(Literal::I32(x)) => dialect.integer(i64::from(*x), Kind::Signed),
        Expression::Literal(Literal::AbstractInt(x)) => dialect.integer(*x, Kind::Signed),
        Expression::Literal(Literal::Bool(x)) => dialect.truth(*x),
        Expression::Compose { ty, components } => {
            let items: Option<Vec<_>> = components.iter().map(|&it| global(shared, it)).collect();
            match types::of(shared.module, *ty)? {
                ValueType::Struct(name) => {
                    let names = types::members(shared.module, *ty)?.into_iter().map(|it| it.0);
                    let names = names.map(|name| dialect.styled(&name, NameOf::Member));
                    let members: Vec<_> = names.zip(items?).collect();
                    dialect.structure(&shared.structure(&name), &members)
                }
                ty => dialect.list(&items?, &ty),
            }
        }
        Expression::Splat { size, value } => {
            let item = global(shared, *value)?;
            let kind = match &expressions[*value] {
                Expression::Literal(Literal::U32(_)) => Kind::Unsigned,
                Expression::Literal(Literal::I32(_)) => Kind::Signed,
                Expression::Literal(Literal::Bool(_)) => Kind::Bool,
                _ => Kind::Float,
            };
            let ty = ValueType::Vector(*size as usize, kind);
            dialect.list(&vec![item; *size as usize], &ty)
        }
        _ => return None,
    })
}

fn structures_text(shared: &ModuleWriter<'_>, scanned: &Scan) -> String {
    let mut text = String::new();
    for (handle, ty) in shared.module.types.iter() {
        let Some(name) = &ty.name else { continue };
        let Some(members) = types::members(shared.module, handle) else { continue };
        let declaration = scanned.declarations.iter().find(|it| it.name == *name);
        let doc = |member: &str| {
            let fields = declaration.map(|it| it.fields.as_slice()).unwrap_or_default();
            fields.iter().find(|it| it.name == member).map(|it| it.doc.clone()).unwrap_or_default()
        };
        let members: Vec<MemberSource> = members
            .into_iter()
            .map(|(name, ty)| MemberSource {
                doc: doc(&name),
                name: shared.dialect.styled(&name, NameOf::Member),
                ty,
            })
            .collect();
        let about = declaration.map(paragraph).unwrap_or_default();
        text += &shared.dialect.declare_structure(&shared.structure(name), &about, &members);
    }
    text
}

fn helpers_text(shared: &ModuleWriter<'_>) -> String {
    let helpers = shared.helpers.borrow();
    let mut order: Vec<&str> = Vec::new();
    fn visit<'n>(dialect: &dyn Dialect, name: &'n str, order: &mut Vec<&'n str>)
    where
        'static: 'n,
    {
        if order.contains(&name) {
            return;
        }
        let Some((_, calls)) = dialect.helper(name) else { return };
        for &callee in calls {
            visit(dialect, callee, order);
        }
        order.push(name);
    }
    for &name in &helpers.called {
        visit(shared.dialect, name, &mut order);
    }
    let mut text = String::new();
    for name in order {
        if let Some((source, _)) = shared.dialect.helper(name) {
            text += source;
        }
    }
    helpers.made.values().for_each(|source| text += source);
    text
}
