//! Runs a function of naga IR on ranges: statements, and the states that flow through them.
//!
//! A state says what each expression and each local variable may be on one way through the
//! function. Where a condition is open, both ways are followed with what the condition tells about
//! them, and they stay apart as long as there are few: `if s <= 0.0 || kind == AMBIENT` keeps what
//! either half says. Loops run as often as their condition says; one that is still open after many
//! turns is run once more with everything that it writes unknown, which covers all turns.

use std::rc::Rc;

use naga::{Block, Expression, Function, Handle, Statement, SwitchCase, SwitchValue};

use super::layout::{scalars_of, tops_of};
use super::range::Range;
use super::trace::Trace;
use crate::wgsl::ValidModule;

/// The ranges of a value's scalars, in the order of [`interp`](crate::interp)'s slots.
pub(in crate::compile) type Ranges = Rc<[Range]>;

/// Expressions and statements that one call may evaluate, all its callees' included.
const MOST_STEPS: usize = 60_000;
/// Ways through a function that are told apart.
const MOST_WAYS: usize = 8;
/// Turns of a loop that are followed one by one.
const MOST_TURNS: usize = 256;
/// Calls within calls, and blocks within blocks.
const MOST_DEPTH: usize = 64;

/// The function does something that ranges cannot follow, or takes too long.
#[derive(Debug)]
pub(super) struct NoRanges;

pub(super) type Outcome<T> = Result<T, NoRanges>;

/// The knowledge of an expression: its ranges, or the place that a pointer names.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Knowledge {
    Value(Ranges),
    /// Into a local variable: the scalars that it may point at begin at these places; so many from
    /// there.
    Pointer {
        local: Handle<naga::LocalVariable>,
        at: Rc<[usize]>,
        count: usize,
    },
    /// Into something that is not followed.
    Elsewhere,
}

/// The state on one path through a function.
#[derive(Clone, Debug)]
pub(super) struct PathState {
    pub(super) known: Vec<Option<Knowledge>>,
    pub(super) locals: Vec<Ranges>,
    /// Counts the stores into each local, so that what was loaded before one is not taken for what
    /// is there after it.
    pub(super) versions: Vec<u32>,
    pub(super) loaded: Vec<u32>,
}

/// Targets of states that leave a block early.
#[derive(Default)]
struct Exits {
    breaks: Vec<PathState>,
    continues: Vec<PathState>,
    returned: Option<Vec<Range>>,
}

/// Runs the functions of one module.
pub(super) struct Machine<'m> {
    pub(super) valid: &'m ValidModule,
    pub(super) is_known: &'m dyn Fn(&str) -> bool,
    steps: usize,
    depth: usize,
    trace: Trace,
}

/// A function with its side tables.
#[derive(Clone, Copy)]
pub(super) struct CallFrame<'m> {
    pub(super) function: &'m Function,
    pub(super) info: &'m naga::valid::FunctionInfo,
    pub(super) arguments: &'m [Ranges],
    /// True if the machine keeps a record of what it evaluates.
    pub(super) is_traced: bool,
}

impl<'m> Machine<'m> {
    /// A machine over a module; `is_known` tells whether a function is the shader library's own.
    pub(super) fn new(valid: &'m ValidModule, is_known: &'m dyn Fn(&str) -> bool) -> Self {
        Self { valid, is_known, steps: 0, depth: 0, trace: Trace::default() }
    }

    pub(super) fn step(&mut self) -> Outcome<()> {
        self.steps += 1;
        if self.steps > MOST_STEPS { Err(NoRanges) } else { Ok(()) }
    }

    /// The ranges of a function's result.
    pub(super) fn call(
        &mut self,
        handle: Handle<Function>,
        arguments: &[Ranges],
    ) -> Outcome<Ranges> {
        let module = &self.valid.module;
        let function = &module.functions[handle];
        if let Some(name) = &function.name
            && let Some(result) = super::library::result(name, arguments)
            && (self.is_known)(name)
        {
            return Ok(result);
        }
        self.run(handle, arguments, false)
    }

    /// The record of a function's expressions for these arguments.
    pub(super) fn trace(
        mut self,
        handle: Handle<Function>,
        arguments: &[Ranges],
    ) -> Outcome<Trace> {
        self.run(handle, arguments, true)?;
        Ok(self.trace)
    }

    pub(super) fn record(&mut self, handle: Handle<Expression>, known: &Knowledge) {
        self.trace.record(handle, known);
    }

    fn run(
        &mut self,
        handle: Handle<Function>,
        arguments: &[Ranges],
        is_traced: bool,
    ) -> Outcome<Ranges> {
        let module = &self.valid.module;
        let function = &module.functions[handle];
        let result = function.result.as_ref().ok_or(NoRanges)?;
        for (argument, given) in function.arguments.iter().zip(arguments) {
            // Images and samplers have no numbers.
            if scalars_of(module, &module.types[argument.ty].inner).unwrap_or(0) != given.len() {
                return Err(NoRanges);
            }
        }
        self.depth += 1;
        if self.depth > MOST_DEPTH {
            return Err(NoRanges);
        }
        let frame = CallFrame { function, info: &self.valid.info[handle], arguments, is_traced };
        let state = self.entry(frame)?;
        let mut exits = Exits::default();
        self.block(frame, &function.body, vec![state], &mut exits)?;
        self.depth -= 1;
        match exits.returned {
            Some(ranges) => Ok(ranges.into()),
            // No way through it ends, on these arguments.
            None => tops_of(module, &module.types[result.ty].inner).map(Into::into).ok_or(NoRanges),
        }
    }

    fn entry(&mut self, frame: CallFrame<'_>) -> Outcome<PathState> {
        let function = frame.function;
        let mut state = PathState {
            known: vec![None; function.expressions.len()],
            locals: Vec::with_capacity(function.local_variables.len()),
            versions: vec![0; function.local_variables.len()],
            loaded: vec![0; function.expressions.len()],
        };
        for (handle, expression) in function.expressions.iter() {
            if let Expression::FunctionArgument(index) = expression {
                let given = frame.arguments.get(*index as usize).ok_or(NoRanges)?;
                state.known[handle.index()] = Some(Knowledge::Value(given.clone()));
            }
        }
        for (_, local) in function.local_variables.iter() {
            let init = match local.init {
                Some(init) => self.value(frame, &mut state, init)?,
                None => super::layout::zeros_of(
                    &self.valid.module,
                    &self.valid.module.types[local.ty].inner,
                )
                .ok_or(NoRanges)?
                .into(),
            };
            state.locals.push(init);
        }
        Ok(state)
    }

    fn block(
        &mut self,
        frame: CallFrame<'_>,
        block: &Block,
        mut states: Vec<PathState>,
        exits: &mut Exits,
    ) -> Outcome<Vec<PathState>> {
        self.depth += 1;
        if self.depth > 4 * MOST_DEPTH {
            return Err(NoRanges);
        }
        for statement in block {
            if states.is_empty() {
                break;
            }
            states = self.statement(frame, statement, states, exits)?;
            if states.len() > MOST_WAYS {
                states = vec![joined(states)];
            }
        }
        self.depth -= 1;
        Ok(states)
    }

    fn statement(
        &mut self,
        frame: CallFrame<'_>,
        statement: &Statement,
        mut states: Vec<PathState>,
        exits: &mut Exits,
    ) -> Outcome<Vec<PathState>> {
        self.step()?;
        match statement {
            Statement::Emit(range) => {
                for state in &mut states {
                    for handle in range.clone() {
                        // A range known before belongs to an earlier turn of a loop.
                        state.known[handle.index()] = None;
                        self.expression(frame, state, handle)?;
                    }
                }
                Ok(states)
            }
            Statement::Block(inner) => self.block(frame, inner, states, exits),
            Statement::If { condition, accept, reject } => {
                let (mut on, mut off) = (Vec::new(), Vec::new());
                for state in states {
                    self.branch(frame, state, *condition, &mut on, &mut off)?;
                }
                let mut ends = self.block(frame, accept, on, exits)?;
                ends.extend(self.block(frame, reject, off, exits)?);
                Ok(ends)
            }
            Statement::Switch { selector, cases } => {
                self.switch(frame, *selector, cases, states, exits)
            }
            Statement::Loop { body, continuing, break_if } => {
                self.turns(frame, (body, continuing, *break_if), states, exits)
            }
            Statement::Break => {
                exits.breaks.append(&mut states);
                Ok(Vec::new())
            }
            Statement::Continue => {
                exits.continues.append(&mut states);
                Ok(Vec::new())
            }
            Statement::Return { value } => {
                for state in &mut states {
                    let Some(value) = value else { return Err(NoRanges) };
                    let value = self.value(frame, state, *value)?;
                    exits.returned = Some(match exits.returned.take() {
                        Some(known) => joined_ranges(&known, &value)?,
                        None => value.to_vec(),
                    });
                }
                Ok(Vec::new())
            }
            Statement::Kill => Ok(Vec::new()),
            Statement::Store { pointer, value } => {
                for state in &mut states {
                    self.store(frame, state, *pointer, *value)?;
                }
                Ok(states)
            }
            Statement::Call { function, arguments, result } => {
                for state in &mut states {
                    let mut given = Vec::with_capacity(arguments.len());
                    for &argument in arguments {
                        given.push(self.value(frame, state, argument)?);
                    }
                    let value = self.call(*function, &given)?;
                    if let (Some(result), true) = (result, frame.is_traced) {
                        self.trace.record_call(*result, &given);
                        self.trace.record(*result, &Knowledge::Value(value.clone()));
                    }
                    if let Some(result) = result {
                        state.known[result.index()] = Some(Knowledge::Value(value));
                    }
                }
                Ok(states)
            }
            _ => Err(NoRanges),
        }
    }

    /// Sends a state down the ways that a condition leaves open.
    fn branch(
        &mut self,
        frame: CallFrame<'_>,
        mut state: PathState,
        condition: Handle<Expression>,
        on: &mut Vec<PathState>,
        off: &mut Vec<PathState>,
    ) -> Outcome<()> {
        match *self.value(frame, &mut state, condition)? {
            [Range::Bool(known)] => {
                let is_open = known.point().is_none();
                for (is_on, ways) in [(true, on), (false, off)] {
                    let may_be = if is_on { known.may_be_true } else { known.may_be_false };
                    if !may_be {
                        continue;
                    }
                    let mut way = state.clone();
                    if !is_open || self.assume(frame, &mut way, condition, is_on)? {
                        ways.push(way);
                    }
                }
                Ok(())
            }
            _ => Err(NoRanges),
        }
    }

    fn switch(
        &mut self,
        frame: CallFrame<'_>,
        selector: Handle<Expression>,
        cases: &[SwitchCase],
        mut states: Vec<PathState>,
        exits: &mut Exits,
    ) -> Outcome<Vec<PathState>> {
        let mut ends = Vec::new();
        // A break leaves the switch; a continue goes on to the loop outside.
        let outer = std::mem::take(&mut exits.breaks);
        let mut starts: Vec<Vec<PathState>> = vec![Vec::new(); cases.len()];
        for state in &mut states {
            let value = self.value(frame, state, selector)?;
            let [Range::Int(selected)] = *value else { return Err(NoRanges) };
            let number = |case: &SwitchCase| match case.value {
                SwitchValue::I32(x) => Some(i64::from(x)),
                SwitchValue::U32(x) => Some(i64::from(x)),
                SwitchValue::Default => None,
            };
            let is_told =
                selected.point().is_some_and(|x| cases.iter().any(|case| number(case) == Some(x)));
            for (case, starts) in cases.iter().zip(&mut starts) {
                let may_be = match number(case) {
                    Some(x) => selected.low <= x && x <= selected.high,
                    None => !is_told,
                };
                if may_be {
                    starts.push(state.clone());
                }
            }
        }
        let mut falling = Vec::new();
        for (case, start) in cases.iter().zip(starts) {
            let start = [std::mem::take(&mut falling), start].concat();
            let end = self.block(frame, &case.body, start, exits)?;
            if case.fall_through { falling = end } else { ends.extend(end) }
        }
        ends.extend(falling);
        ends.append(&mut exits.breaks);
        exits.breaks = outer;
        Ok(ends)
    }

    fn turns(
        &mut self,
        frame: CallFrame<'_>,
        parts: (&Block, &Block, Option<Handle<Expression>>),
        mut states: Vec<PathState>,
        exits: &mut Exits,
    ) -> Outcome<Vec<PathState>> {
        let mut inner = Exits { returned: exits.returned.take(), ..Exits::default() };
        let mut ends: Vec<PathState> = Vec::new();
        for _ in 0..MOST_TURNS {
            if states.is_empty() {
                break;
            }
            states = self.turn(frame, parts, states, &mut inner)?;
            ends.append(&mut inner.breaks);
            if ends.len() > MOST_WAYS {
                ends = vec![joined(ends)];
            }
        }
        if !states.is_empty() {
            let mut any = joined(states);
            for local in written(parts.0, parts.1, frame.function) {
                let ty = frame.function.local_variables[local].ty;
                let tops = tops_of(&self.valid.module, &self.valid.module.types[ty].inner)
                    .ok_or(NoRanges)?;
                any.locals[local.index()] = tops.into();
                any.versions[local.index()] += 1;
            }
            self.turn(frame, parts, vec![any], &mut inner)?;
            ends.append(&mut inner.breaks);
        }
        exits.returned = inner.returned;
        Ok(ends)
    }

    /// A turn of a loop: the states that begin the next one.
    fn turn(
        &mut self,
        frame: CallFrame<'_>,
        (body, continuing, break_if): (&Block, &Block, Option<Handle<Expression>>),
        states: Vec<PathState>,
        exits: &mut Exits,
    ) -> Outcome<Vec<PathState>> {
        let mut ends = self.block(frame, body, states, exits)?;
        ends.append(&mut exits.continues);
        if ends.len() > MOST_WAYS {
            ends = vec![joined(ends)];
        }
        let mut ends = self.block(frame, continuing, ends, exits)?;
        if let Some(condition) = break_if {
            let mut on = Vec::new();
            let mut off = Vec::new();
            for state in ends {
                self.branch(frame, state, condition, &mut on, &mut off)?;
            }
            exits.breaks.extend(on);
            ends = off;
        }
        Ok(ends)
    }

    fn store(
        &mut self,
        frame: CallFrame<'_>,
        state: &mut PathState,
        pointer: Handle<Expression>,
        value: Handle<Expression>,
    ) -> Outcome<()> {
        let value = self.value(frame, state, value)?;
        match self.expression(frame, state, pointer)? {
            Knowledge::Pointer { local, at, count } if count == value.len() => {
                let mut scalars = state.locals[local.index()].to_vec();
                // A vector with one component set anew has any length.
                if count == 1 && scalars.len() > 1 {
                    scalars.iter_mut().for_each(|range| *range = range.alone());
                }
                for &start in at.iter() {
                    let slots = scalars.get_mut(start..start + count).ok_or(NoRanges)?;
                    if at.len() == 1 {
                        slots.copy_from_slice(&value);
                    } else {
                        // A write to one of several places: each keeps its value, or takes the new
                        // one.
                        let either = joined_ranges(slots, &value)?;
                        slots.copy_from_slice(&either);
                    }
                }
                state.locals[local.index()] = scalars.into();
                state.versions[local.index()] += 1;
                Ok(())
            }
            // A place that is not followed is read as anything.
            Knowledge::Elsewhere => Ok(()),
            _ => Err(NoRanges),
        }
    }
}

/// The locals that a loop may write.
fn written(
    body: &Block,
    continuing: &Block,
    function: &Function,
) -> Vec<Handle<naga::LocalVariable>> {
    let mut locals = Vec::new();
    let mut blocks = vec![body, continuing];
    while let Some(block) = blocks.pop() {
        for statement in block {
            match statement {
                Statement::Store { pointer, .. } => locals.extend(root_of(*pointer, function)),
                Statement::Block(inner) => blocks.push(inner),
                Statement::If { accept, reject, .. } => blocks.extend([accept, reject]),
                Statement::Switch { cases, .. } => {
                    blocks.extend(cases.iter().map(|case| &case.body));
                }
                Statement::Loop { body, continuing, .. } => blocks.extend([body, continuing]),
                _ => {}
            }
        }
    }
    locals
}

fn root_of(
    mut pointer: Handle<Expression>,
    function: &Function,
) -> Option<Handle<naga::LocalVariable>> {
    loop {
        match function.expressions[pointer] {
            Expression::LocalVariable(local) => return Some(local),
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => {
                pointer = base;
            }
            _ => return None,
        }
    }
}

/// The union of two lists of ranges.
pub(super) fn joined_ranges(a: &[Range], b: &[Range]) -> Outcome<Vec<Range>> {
    if a.len() != b.len() {
        return Err(NoRanges);
    }
    a.iter().zip(b).map(|(a, b)| a.join(*b).ok_or(NoRanges)).collect()
}

/// The union of states, of which there must be one.
fn joined(states: Vec<PathState>) -> PathState {
    let mut states = states.into_iter();
    let mut all = states.next().unwrap_or(PathState {
        known: Vec::new(),
        locals: Vec::new(),
        versions: Vec::new(),
        loaded: Vec::new(),
    });
    for state in states {
        for (known, other) in all.known.iter_mut().zip(&state.known) {
            *known = match (known.take(), other) {
                (Some(Knowledge::Value(a)), Some(Knowledge::Value(b))) => {
                    joined_ranges(&a, b).ok().map(|ranges| Knowledge::Value(ranges.into()))
                }
                (Some(a), Some(b)) if a == *b => Some(a),
                // Evaluated again where it is asked for.
                _ => None,
            };
        }
        for (local, other) in all.locals.iter_mut().zip(&state.locals) {
            if let Ok(ranges) = joined_ranges(local, other) {
                *local = ranges.into();
            }
        }
        for (version, other) in all.versions.iter_mut().zip(&state.versions) {
            *version = (*version).max(*other) + 1;
        }
    }
    all
}
