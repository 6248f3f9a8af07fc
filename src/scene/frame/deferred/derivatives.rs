//! Derivatives of a look that is drawn over the picture.
//!
//! Beside a pixel another triangle may be seen, so that differences between neighboring pixels are
//! not the differences along the pixel's own triangle that a rasterizer takes. So a module is run
//! at a pixel three times: at the places of its two neighbors in the quad of 2x2 pixels, on the
//! same triangle, where every argument of a derivative is noted; then at the pixel itself, where a
//! derivative is the difference from the noted argument. A compiler leaves out of the first two
//! runs whatever no derivative asks for.
//!
//! Notes are counted, so that each run must come by the same derivatives in the same order: none
//! may stand under a condition. And a derivative of something that another derivative decides would
//! ask for the neighbor's neighbor.

use std::collections::HashSet;
use std::fmt::Write as _;

use chiaro_locale::{Text, text, tr};
use naga::{Block, Expression, Function, Handle, SampleLevel, Statement, TypeInner};

use crate::wgsl::ValidModule;

/// Reason why a module cannot be run over the picture.
pub(super) type Refusal = &'static str;

const CONDITION: Text = text!("it takes a derivative under a condition");
const NESTED: Text = text!("it takes a derivative of what another derivative decides");
const SAMPLING: Text = text!("it samples an image in a way that is not foreseen");

/// Kinds of expressions that ask for differences between pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Difference {
    AlongX,
    AlongY,
    Width,
    /// The level of an image of two dimensions.
    Level,
}

impl Difference {
    /// Name of the builtin function.
    fn builtin(self) -> &'static str {
        match self {
            Self::AlongX => "dpdx",
            Self::AlongY => "dpdy",
            Self::Width => "fwidth",
            Self::Level => "textureSample",
        }
    }
}

/// Derivative in the text of a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Site {
    /// Byte at which the call of the builtin begins.
    at: usize,
    kind: Difference,
    /// Number of components of the argument, from 1 to 4.
    components: usize,
}

/// Number of arguments that a run notes, by their number of components less 1.
type Notes = [usize; 4];

/// All derivatives of a module.
#[derive(Debug, Default)]
pub(super) struct Derivatives {
    sites: Vec<Site>,
    notes: Notes,
}

impl Derivatives {
    /// The derivatives of a module, which begin at functions that its fragment stage calls.
    ///
    /// # Errors
    /// The reason why they cannot be taken on one triangle.
    pub(super) fn of(valid: &ValidModule) -> Result<Self, Refusal> {
        let module = &valid.module;
        let mut found = Self::default();
        let mut notes: Vec<Notes> = Vec::with_capacity(module.functions.len());
        for (handle, function) in module.functions.iter() {
            let walk = FunctionWalk::new(module, function, &valid.info[handle], &notes);
            notes.push(walk.run(&mut found.sites)?);
        }
        for (index, point) in module.entry_points.iter().enumerate() {
            let info = valid.info.get_entry_point(index);
            let walk = FunctionWalk::new(module, &point.function, info, &notes);
            let own = walk.run(&mut found.sites)?;
            (0..4).for_each(|index| found.notes[index] += own[index]);
        }
        found.sites.sort_unstable();
        found.sites.dedup();
        Ok(found)
    }

    /// True if there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.sites.is_empty()
    }

    /// The text with every derivative taken from notes.
    ///
    /// # Errors
    /// A text whose builtins are not where naga has seen them.
    pub(super) fn noted(&self, text: &str) -> Result<String, Refusal> {
        let mut out = String::with_capacity(text.len() + 2048);
        let mut end = 0;
        for Site { at, kind, components } in &self.sites {
            let name = kind.builtin();
            let rest = text.get(*at..).unwrap_or_default();
            if !rest.strip_prefix(name).is_some_and(|after| after.starts_with('(')) {
                return Err(tr!("its derivatives are not where they are looked for"));
            }
            out.push_str(&text[end..*at]);
            let _ = match kind {
                Difference::Level => write!(out, "deferred_sample"),
                _ => write!(out, "deferred_{name}_{components}"),
            };
            end = at + name.len();
        }
        out.push_str(&text[end..]);
        self.write_functions(&mut out);
        Ok(out)
    }

    /// Numbers of components that any derivative has.
    fn components(&self) -> impl Iterator<Item = usize> + '_ {
        (1..=4).filter(|count| self.sites.iter().any(|site| site.components == *count))
    }

    fn write_functions(&self, out: &mut String) {
        if self.is_empty() {
            return;
        }
        out.push_str(
            "\n/// The run of the module: 0 and 1 at the neighbors along x and y, 2 at the pixel.\n\
             var<private> deferred_run: u32;\n\
             /// 1 where the neighbor comes after the pixel, -1 where before.\n\
             var<private> deferred_side: vec2f;\n",
        );
        for components in self.components() {
            // A function that is never called has derivatives, too, and no array is empty.
            let count = self.notes[components - 1].max(1);
            let ty = if components == 1 { "f32".to_owned() } else { format!("vec{components}f") };
            for (run, axis) in ["x", "y"].into_iter().enumerate() {
                let note = format!("deferred_{axis}_{components}");
                let _ = write!(
                    out,
                    "\nvar<private> {note}: array<{ty}, {count}>;\n\
                     var<private> {note}_count: u32;\n\n\
                     fn deferred_dpd{axis}_{components}(v: {ty}) -> {ty} {{\n    \
                     var change = {ty}(0.0);\n    \
                     if deferred_run == {run}u {{\n        \
                     {note}[{note}_count] = v;\n        \
                     {note}_count += 1u;\n    }}\n    \
                     if deferred_run == 2u {{\n        \
                     change = deferred_side.{axis} * ({note}[{note}_count] - v);\n        \
                     {note}_count += 1u;\n    }}\n    \
                     return change;\n}}\n"
                );
            }
            let width = Site { at: 0, kind: Difference::Width, components };
            if self.sites.iter().any(|site| Site { at: 0, ..*site } == width) {
                let _ = write!(
                    out,
                    "\nfn deferred_fwidth_{components}(v: {ty}) -> {ty} {{\n    \
                     return abs(deferred_dpdx_{components}(v)) + \
                     abs(deferred_dpdy_{components}(v));\n}}\n"
                );
            }
        }
        if self.sites.iter().any(|site| site.kind == Difference::Level) {
            out.push_str(
                "\nfn deferred_sample(image: texture_2d<f32>, image_sampler: sampler, at: vec2f) \
                 -> vec4f {\n    \
                 return textureSampleGrad(image, image_sampler, at, deferred_dpdx_2(at), \
                 deferred_dpdy_2(at));\n}\n",
            );
        }
    }

    /// Statements that begin the count of notes anew.
    pub(super) fn rewound(&self) -> String {
        let mut out = String::new();
        for components in self.components() {
            for axis in ["x", "y"] {
                let _ = writeln!(out, "    deferred_{axis}_{components}_count = 0u;");
            }
        }
        out
    }
}

/// Walk through the statements of a function in their order.
struct FunctionWalk<'a> {
    module: &'a naga::Module,
    function: &'a Function,
    info: &'a naga::valid::FunctionInfo,
    /// Notes of all functions before this one, which are those that it may call.
    known: &'a [Notes],
    /// Expressions that depend on a difference.
    decided: HashSet<Handle<Expression>>,
    /// Local variables that hold what depends on one.
    holders: HashSet<Handle<naga::LocalVariable>>,
    notes: Notes,
    sites: Vec<Site>,
}

/// Circumstances under which a statement runs.
#[derive(Clone, Copy, Default)]
struct Circumstances {
    /// True if some fragments pass by.
    is_conditional: bool,
    /// True if a difference decides which.
    is_decided: bool,
}

impl<'a> FunctionWalk<'a> {
    fn new(
        module: &'a naga::Module,
        function: &'a Function,
        info: &'a naga::valid::FunctionInfo,
        known: &'a [Notes],
    ) -> Self {
        Self {
            module,
            function,
            info,
            known,
            decided: HashSet::new(),
            holders: HashSet::new(),
            notes: Notes::default(),
            sites: Vec::new(),
        }
    }

    /// The notes of the function; its own derivatives are added to `sites`.
    fn run(mut self, sites: &mut Vec<Site>) -> Result<Notes, Refusal> {
        // What a loop stores late may be read early in its next round.
        loop {
            let before = (self.decided.len(), self.holders.len());
            (self.notes, self.sites) = (Notes::default(), Vec::new());
            self.block(&self.function.body, &mut Circumstances::default())?;
            if before == (self.decided.len(), self.holders.len()) {
                sites.append(&mut self.sites);
                return Ok(self.notes);
            }
        }
    }

    fn block(&mut self, block: &Block, at: &mut Circumstances) -> Result<(), Refusal> {
        for statement in block {
            match statement {
                Statement::Emit(range) => {
                    for handle in range.clone() {
                        self.expression(handle, *at)?;
                    }
                }
                Statement::Call { function, arguments, result } => {
                    let notes = self.known.get(function.index()).copied().unwrap_or_default();
                    let has_notes = notes != Notes::default();
                    let is_decided = arguments.iter().any(|handle| self.is_decided(*handle));
                    if has_notes && at.is_conditional {
                        return Err(CONDITION.tr());
                    }
                    if has_notes && is_decided {
                        return Err(NESTED.tr());
                    }
                    (0..4).for_each(|index| self.notes[index] += notes[index]);
                    let is_decided = is_decided || has_notes || at.is_decided;
                    if is_decided {
                        self.decided.extend(result);
                        // The function may write to what it is given a pointer to.
                        arguments.iter().for_each(|handle| self.hold(*handle));
                    }
                }
                Statement::Store { pointer, value }
                    if at.is_decided || self.is_decided(*value) || self.is_decided(*pointer) =>
                {
                    self.hold(*pointer);
                }
                Statement::Store { .. } => {}
                Statement::Block(inner) => self.block(inner, at)?,
                Statement::If { condition, accept, reject } => {
                    let is_decided = self.is_decided(*condition);
                    self.branches([accept, reject], is_decided, false, at)?;
                }
                Statement::Switch { selector, cases } => {
                    let is_decided = self.is_decided(*selector);
                    let cases = cases.iter().map(|case| &case.body);
                    self.branches(cases, is_decided, true, at)?;
                }
                Statement::Loop { body, continuing, break_if } => {
                    let is_decided = break_if.is_some_and(|handle| self.is_decided(handle));
                    self.branches([body, continuing], is_decided, true, at)?;
                }
                Statement::Return { .. }
                | Statement::Break
                | Statement::Continue
                | Statement::Kill => at.is_conditional = true,
                _ => {}
            }
        }
        Ok(())
    }

    /// Blocks of which some fragments run one and some another. If any of them ends early, what
    /// follows is conditional, too; `holds_breaks` where a break goes no farther than their end.
    fn branches<'b>(
        &mut self,
        blocks: impl IntoIterator<Item = &'b Block>,
        is_decided: bool,
        holds_breaks: bool,
        at: &mut Circumstances,
    ) -> Result<(), Refusal> {
        for block in blocks {
            let is_decided = is_decided || at.is_decided;
            self.block(block, &mut Circumstances { is_conditional: true, is_decided })?;
            if leaves(block, holds_breaks) {
                at.is_conditional = true;
                at.is_decided |= is_decided;
            }
        }
        Ok(())
    }

    fn expression(&mut self, handle: Handle<Expression>, at: Circumstances) -> Result<(), Refusal> {
        let expression = &self.function.expressions[handle];
        let difference = match expression {
            Expression::Derivative { axis, expr, .. } => Some((
                match axis {
                    naga::DerivativeAxis::X => Difference::AlongX,
                    naga::DerivativeAxis::Y => Difference::AlongY,
                    naga::DerivativeAxis::Width => Difference::Width,
                },
                *expr,
            )),
            Expression::ImageSample {
                level: SampleLevel::Auto,
                gather: None,
                array_index: None,
                offset: None,
                depth_ref: None,
                clamp_to_edge: false,
                coordinate,
                ..
            } => Some((Difference::Level, *coordinate)),
            Expression::ImageSample { level: SampleLevel::Auto | SampleLevel::Bias(_), .. } => {
                return Err(SAMPLING.tr());
            }
            _ => None,
        };
        if let Some((kind, of)) = difference {
            if at.is_conditional {
                return Err(CONDITION.tr());
            }
            if self.is_decided(of) {
                return Err(NESTED.tr());
            }
            let components = match self.info[of].ty.inner_with(&self.module.types) {
                TypeInner::Scalar(_) => 1,
                TypeInner::Vector { size, .. } => *size as usize,
                _ => return Err(SAMPLING.tr()),
            };
            if kind == Difference::Level && components != 2 {
                return Err(SAMPLING.tr());
            }
            let span = self.function.expressions.get_span(handle).to_range().unwrap_or_default();
            self.sites.push(Site { at: span.start, kind, components });
            // Each axis has notes of its own: one of the two may ask for all of them.
            self.notes[components - 1] += 1;
            self.decided.insert(handle);
        } else if operands(expression).into_iter().flatten().any(|of| self.is_decided(of))
            || self.is_held(expression)
        {
            self.decided.insert(handle);
        }
        Ok(())
    }

    fn is_decided(&self, handle: Handle<Expression>) -> bool {
        if self.decided.contains(&handle) {
            return true;
        }
        // Expressions that are never emitted, as pointers.
        let expression = &self.function.expressions[handle];
        expression.needs_pre_emit()
            && (self.is_held(expression)
                || operands(expression).into_iter().flatten().any(|of| self.is_decided(of)))
    }

    fn is_held(&self, expression: &Expression) -> bool {
        matches!(expression, Expression::LocalVariable(local) if self.holders.contains(local))
    }

    /// Takes down that a variable holds what depends on a difference.
    fn hold(&mut self, pointer: Handle<Expression>) {
        match &self.function.expressions[pointer] {
            Expression::LocalVariable(local) => drop(self.holders.insert(*local)),
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => {
                self.hold(*base);
            }
            _ => {}
        }
    }
}

/// True if what follows a block is passed by where the block ends early. What ends a round of a
/// loop, or a case, `within` the block is no such end.
fn leaves(block: &Block, within: bool) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Return { .. } | Statement::Kill => true,
        Statement::Break | Statement::Continue => !within,
        Statement::Block(inner) => leaves(inner, within),
        Statement::If { accept, reject, .. } => leaves(accept, within) || leaves(reject, within),
        Statement::Switch { cases, .. } => cases.iter().any(|case| leaves(&case.body, true)),
        Statement::Loop { body, continuing, .. } => leaves(body, true) || leaves(continuing, true),
        _ => false,
    })
}

/// Expressions that an expression is made of: up to four here, those of a composition apart.
fn operands(expression: &Expression) -> Vec<Option<Handle<Expression>>> {
    match expression {
        Expression::Compose { components, .. } => components.iter().copied().map(Some).collect(),
        Expression::Access { base, index } => vec![Some(*base), Some(*index)],
        Expression::AccessIndex { base, .. } => vec![Some(*base)],
        Expression::Splat { value, .. } => vec![Some(*value)],
        Expression::Swizzle { vector, .. } => vec![Some(*vector)],
        Expression::Load { pointer } => vec![Some(*pointer)],
        Expression::ImageSample { coordinate, array_index, level, .. } => {
            let level = match level {
                SampleLevel::Exact(of) | SampleLevel::Bias(of) => [Some(*of), None],
                SampleLevel::Gradient { x, y } => [Some(*x), Some(*y)],
                SampleLevel::Auto | SampleLevel::Zero => [None; 2],
            };
            vec![Some(*coordinate), *array_index, level[0], level[1]]
        }
        Expression::ImageLoad { coordinate, array_index, level, .. } => {
            vec![Some(*coordinate), *array_index, *level]
        }
        Expression::Unary { expr, .. } | Expression::As { expr, .. } => vec![Some(*expr)],
        Expression::Binary { left, right, .. } => vec![Some(*left), Some(*right)],
        Expression::Select { condition, accept, reject } => {
            vec![Some(*condition), Some(*accept), Some(*reject)]
        }
        Expression::Derivative { expr, .. } => vec![Some(*expr)],
        Expression::Relational { argument, .. } => vec![Some(*argument)],
        Expression::Math { arg, arg1, arg2, arg3, .. } => vec![Some(*arg), *arg1, *arg2, *arg3],
        // Constants, arguments, variables and results of calls: those are told apart elsewhere.
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wgsl::parse;

    fn of(body: &str) -> Result<Notes, Refusal> {
        let text = format!(
            "fn width(v: f32) -> f32 {{ return fwidth(v); }}\n\
             @fragment fn fs_main(@location(0) a: vec2f) -> @location(0) vec4f {{ {body} }}"
        );
        let valid = parse(&text).unwrap_or_else(|problem| panic!("{problem}"));
        let found = Derivatives::of(&valid)?;
        let noted = found.noted(&text)?;
        parse(&noted).unwrap_or_else(|problem| panic!("{problem}\n{noted}"));
        assert!(!noted.contains("= dpdx(") && !noted.contains(" fwidth("), "{noted}");
        Ok(found.notes)
    }

    #[test]
    fn each_derivative_is_counted_along_calls() {
        assert_eq!(of("return vec4f(a, a);"), Ok([0; 4]));
        assert_eq!(of("return vec4f(dpdx(a), dpdy(a));"), Ok([0, 2, 0, 0]));
        assert_eq!(of("return vec4f(width(a.x) + width(a.y));"), Ok([2, 0, 0, 0]));
    }

    #[test]
    fn conditions_are_refused() {
        assert_eq!(of("if a.x > 0.0 { return vec4f(width(a.y)); } return vec4f(0.0);"), {
            Err(CONDITION.tr())
        });
        assert_eq!(of("if a.x > 0.0 { return vec4f(0.0); } return vec4f(dpdx(a.y));"), {
            Err(CONDITION.tr())
        });
        // What comes after a branch that stays is the same for all.
        let stays = "var b = a; if a.x > 0.0 { b.x = 1.0; } return vec4f(dpdx(b.x));";
        assert_eq!(of(stays), Ok([1, 0, 0, 0]));
    }

    #[test]
    fn derivatives_of_derivatives_are_refused() {
        for body in [
            "return vec4f(dpdx(dpdy(a.x)));",
            "let w = width(a.x); return vec4f(width(w + a.y));",
            "var b = a; b.x = width(a.y); return vec4f(dpdx(b.y));",
            "var b = a.x; if width(a.y) > 0.5 { b = 0.0; } return vec4f(dpdx(b));",
            "var b = 0.0; let w = width(a.x); for (var i = 0; i < 3; i++) { if w > b { b += 1.0; } \
             } return vec4f(dpdy(b));",
        ] {
            assert_eq!(of(body), Err(NESTED.tr()), "{body}");
        }
        assert_eq!(of("let w = width(a.x); return vec4f(w, width(a.y), 0.0, 1.0);"), {
            Ok([2, 0, 0, 0])
        });
    }
}
