//! Following: a look's statements are carried out with symbols, so that what they would calculate
//! becomes terms. Both branches of an open condition are followed, and the condition chooses.

use std::collections::HashMap;

use naga::{Arena, Block, Expression, Function, Handle, Module, Statement, SwitchValue};

use super::intrinsics;
use super::symbols::{Symbol, choose_truth};
use super::terms::{Terms, Truth};

/// Most statements that are followed, so that no look takes long.
const MAX_STEPS: usize = 400_000;

/// Deepest call of functions.
const MAX_DEPTH: usize = 60;

/// The reason why a look has no graph, as the end of a sentence about the function that stands in
/// front.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Unfit(pub(super) String);

/// Continuation after a block of statements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flow {
    Next,
    Break,
    Continue,
    Returned,
}

/// A function that is followed.
pub(super) struct Frame<'m> {
    pub(super) arena: &'m Arena<Expression>,
    pub(super) function: &'m Function,
    pub(super) values: HashMap<Handle<Expression>, Symbol>,
    pub(super) arguments: Vec<Symbol>,
    /// Slot of the first variable.
    pub(super) locals: usize,
    /// The function has returned.
    done: Truth,
    result: Option<Symbol>,
    /// Names of values in the order of their expressions, in functions whose statements are the
    /// artist's nodes.
    nodes: Vec<(usize, &'m str)>,
}

/// A look that is followed.
pub(super) struct Follower<'m> {
    pub(super) module: &'m Module,
    pub(super) terms: Terms,
    pub(super) memory: Vec<Symbol>,
    /// Names of functions whose statements are the artist's nodes.
    pub(super) of_nodes: Vec<String>,
    steps: usize,
    depth: usize,
    empty: &'m Function,
}

impl<'m> Follower<'m> {
    /// A follower whose memory begins with the module's variables, at zero.
    pub(super) fn new(module: &'m Module, empty: &'m Function, of_nodes: Vec<String>) -> Self {
        let mut terms = Terms::default();
        let variables = module.global_variables.iter();
        let memory = variables.map(|(_, it)| Symbol::zero(module, it.ty, &mut terms)).collect();
        Self { module, terms, memory, of_nodes, steps: 0, depth: 0, empty }
    }

    /// The result of a function by its name.
    pub(super) fn call_named(
        &mut self,
        name: &str,
        arguments: Vec<Symbol>,
    ) -> Result<Symbol, Unfit> {
        let mut functions = self.module.functions.iter();
        let found = functions.find(|(_, function)| function.name.as_deref() == Some(name));
        let (handle, _) = found.ok_or_else(|| Unfit(format!("`{name}` is not there")))?;
        self.call(handle, arguments)
    }

    fn call(&mut self, handle: Handle<Function>, args: Vec<Symbol>) -> Result<Symbol, Unfit> {
        let function = &self.module.functions[handle];
        let name = function.name.as_deref().unwrap_or_default();
        if let Some(result) = intrinsics::result_of(&mut self.terms, plain_name(name), &args) {
            return Ok(result);
        }
        let unfit = |reason: &str| Unfit(format!("`{}` {reason}", plain_name(name)));
        if self.depth >= MAX_DEPTH {
            return Err(unfit("calls too many functions"));
        }
        let mut nodes = Vec::new();
        if self.of_nodes.iter().any(|it| it == name) {
            let named = function.named_expressions.iter();
            nodes = named.map(|(handle, name)| (handle.index(), name.as_str())).collect();
            nodes.sort_unstable();
        }
        let mut frame = Frame {
            arena: &function.expressions,
            function,
            values: HashMap::new(),
            arguments: args,
            locals: self.memory.len(),
            done: Truth::Known(false),
            result: None,
            nodes,
        };
        self.depth += 1;
        for (_, local) in function.local_variables.iter() {
            let value = match local.init {
                Some(init) => self.value(&mut frame, init)?,
                None => Symbol::zero(self.module, local.ty, &mut self.terms),
            };
            self.memory.push(value);
        }
        self.block(&mut frame, &function.body).map_err(|Unfit(reason)| {
            // The innermost function is named.
            if reason.starts_with('`') { Unfit(reason) } else { unfit(&reason) }
        })?;
        self.memory.truncate(frame.locals);
        self.depth -= 1;
        Ok(frame.result.unwrap_or(Symbol::Foreign))
    }

    fn block(&mut self, frame: &mut Frame<'m>, block: &'m Block) -> Result<Flow, Unfit> {
        for statement in block {
            self.steps += 1;
            if self.steps > MAX_STEPS || self.terms.is_full() {
                return Err(Unfit("makes more nodes than a graph should have".to_owned()));
            }
            let flow = self.statement(frame, statement)?;
            if flow != Flow::Next {
                return Ok(flow);
            }
        }
        Ok(Flow::Next)
    }

    fn statement(
        &mut self,
        frame: &mut Frame<'m>,
        statement: &'m Statement,
    ) -> Result<Flow, Unfit> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    self.enter_node(frame, handle);
                    let start = self.terms.list.len();
                    let value = self.expression(frame, handle)?;
                    self.keep(frame, handle, value, start);
                }
            }
            Statement::Block(block) => return self.block(frame, block),
            Statement::If { condition, accept, reject } => {
                let condition = self.truth(frame, *condition)?;
                return match condition {
                    Truth::Known(true) => self.block(frame, accept),
                    Truth::Known(false) => self.block(frame, reject),
                    open => self.branches(frame, &open, &[accept], &[reject]),
                };
            }
            Statement::Switch { selector, cases } => {
                let selector = self.value(frame, *selector)?;
                return self.switch(frame, &selector, cases);
            }
            Statement::Loop { body, continuing, break_if } => {
                return self.repeat(frame, body, continuing, *break_if);
            }
            Statement::Break => return Ok(Flow::Break),
            Statement::Continue => return Ok(Flow::Continue),
            Statement::Return { value } => {
                let value = match value {
                    Some(value) => self.value(frame, *value)?,
                    None => Symbol::Foreign,
                };
                frame.result = Some(match frame.result.take() {
                    None => value,
                    Some(before) => self.chosen(&frame.done.clone(), &before, &value)?,
                });
                frame.done = Truth::Known(true);
                return Ok(Flow::Returned);
            }
            Statement::Store { pointer, value } => {
                let value = self.value(frame, *value)?;
                let Symbol::Pointer(slot, way) = self.value(frame, *pointer)? else {
                    return Err(Unfit("stores in memory that graphs do not have".to_owned()));
                };
                let before = self.memory[slot].clone();
                let after = before.with(&way, value, &mut self.terms);
                let after = after.ok_or_else(|| Unfit("stores a part of a value".to_owned()))?;
                // What is stored after a return must not be seen outside.
                let is_open = slot < frame.locals && !matches!(frame.done, Truth::Known(_));
                self.memory[slot] = match is_open {
                    true => self.chosen(&frame.done.clone(), &before, &after)?,
                    false => after,
                };
            }
            Statement::Call { function, arguments, result } => {
                if let Some(result) = result {
                    self.enter_node(frame, *result);
                }
                let arguments: Result<Vec<Symbol>, Unfit> =
                    arguments.iter().map(|it| self.value(frame, *it)).collect();
                let start = self.terms.list.len();
                let value = self.call(*function, arguments?)?;
                if let Some(result) = result {
                    self.keep(frame, *result, value, start);
                }
            }
            Statement::Kill => return Err(Unfit("leaves pixels out".to_owned())),
            _ => return Err(Unfit("does what only programs of a GPU can".to_owned())),
        }
        Ok(Flow::Next)
    }

    /// Says which of the artist's nodes an expression belongs to: the next that has a name.
    fn enter_node(&mut self, frame: &Frame<'m>, handle: Handle<Expression>) {
        let next = frame.nodes.iter().find(|(index, _)| *index >= handle.index());
        if let Some((_, name)) = next {
            (*name).clone_into(&mut self.terms.group);
        }
    }

    /// Keeps the value of an expression, and its name.
    fn keep(
        &mut self,
        frame: &mut Frame<'m>,
        handle: Handle<Expression>,
        value: Symbol,
        start: usize,
    ) {
        if let Symbol::Number(id) = value
            && id.0 >= start
            && let Some(name) = frame.function.named_expressions.get(&handle)
        {
            name.clone_into(&mut self.terms.names[id.0]);
        }
        frame.values.insert(handle, value);
    }

    /// Follows both branches of an open condition.
    fn branches(
        &mut self,
        frame: &mut Frame<'m>,
        open: &Truth,
        on: &[&'m Block],
        off: &[&'m Block],
    ) -> Result<Flow, Unfit> {
        let memory = self.memory.clone();
        let (done, result) = (frame.done.clone(), frame.result.clone());
        self.all_of(frame, on)?;
        let memory_on = std::mem::replace(&mut self.memory, memory);
        let done_on = std::mem::replace(&mut frame.done, done);
        let result_on = std::mem::replace(&mut frame.result, result);
        self.all_of(frame, off)?;
        for (slot, on) in memory_on.into_iter().enumerate() {
            if on != self.memory[slot] {
                let off = self.memory[slot].clone();
                self.memory[slot] = self.chosen(open, &on, &off)?;
            }
        }
        frame.result = match (result_on, frame.result.take()) {
            (Some(on), Some(off)) => Some(self.chosen(open, &on, &off)?),
            (one, other) => one.or(other),
        };
        frame.done = choose_truth(open, &done_on, &frame.done);
        Ok(if frame.done == Truth::Known(true) { Flow::Returned } else { Flow::Next })
    }

    /// Follows blocks one after the other; none may leave a loop.
    fn all_of(&mut self, frame: &mut Frame<'m>, blocks: &[&'m Block]) -> Result<(), Unfit> {
        for block in blocks {
            match self.block(frame, block)? {
                Flow::Next => {}
                Flow::Returned => break,
                Flow::Break | Flow::Continue => {
                    return Err(Unfit("ends a loop by what the picture shows".to_owned()));
                }
            }
        }
        Ok(())
    }

    fn switch(
        &mut self,
        frame: &mut Frame<'m>,
        selector: &Symbol,
        cases: &'m [naga::SwitchCase],
    ) -> Result<Flow, Unfit> {
        let number = |case: &naga::SwitchCase| match case.value {
            SwitchValue::I32(x) => Some(i64::from(x)),
            SwitchValue::U32(x) => Some(i64::from(x)),
            SwitchValue::Default => None,
        };
        let from = |first: usize| {
            let mut blocks = Vec::new();
            for case in &cases[first..] {
                blocks.push(&case.body);
                if !case.fall_through {
                    break;
                }
            }
            blocks
        };
        let default = cases.iter().position(|case| case.value == SwitchValue::Default);
        if let Some(known) = selector.whole(&self.terms) {
            let chosen = cases.iter().position(|case| number(case) == Some(known)).or(default);
            for block in chosen.map(from).unwrap_or_default() {
                match self.block(frame, block)? {
                    Flow::Next => {}
                    Flow::Break => return Ok(Flow::Next),
                    other => return Ok(other),
                }
            }
            return Ok(Flow::Next);
        }
        Err(Unfit("takes one of many ways by what the picture shows".to_owned()))
    }

    fn repeat(
        &mut self,
        frame: &mut Frame<'m>,
        body: &'m Block,
        continuing: &'m Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<Flow, Unfit> {
        loop {
            match self.block(frame, body)? {
                Flow::Break => return Ok(Flow::Next),
                Flow::Returned => return Ok(Flow::Returned),
                Flow::Next | Flow::Continue => {}
            }
            self.block(frame, continuing)?;
            if let Some(condition) = break_if {
                match self.truth(frame, condition)? {
                    Truth::Known(true) => return Ok(Flow::Next),
                    Truth::Known(false) => {}
                    _ => {
                        return Err(Unfit("ends a loop by what the picture shows".to_owned()));
                    }
                }
            }
            self.steps += 1;
            if self.steps > MAX_STEPS {
                return Err(Unfit("makes more nodes than a graph should have".to_owned()));
            }
        }
    }

    /// One of two by a condition.
    pub(super) fn chosen(
        &mut self,
        truth: &Truth,
        on: &Symbol,
        off: &Symbol,
    ) -> Result<Symbol, Unfit> {
        let chosen = Symbol::choose(truth, on, off, &mut self.terms);
        chosen.ok_or_else(|| Unfit("chooses between what no node holds".to_owned()))
    }

    fn truth(&mut self, frame: &mut Frame<'m>, handle: Handle<Expression>) -> Result<Truth, Unfit> {
        match self.value(frame, handle)? {
            Symbol::Truth(truth) => Ok(truth),
            _ => Err(Unfit("asks what is no question".to_owned())),
        }
    }

    /// The value of an expression.
    pub(super) fn value(
        &mut self,
        frame: &mut Frame<'m>,
        handle: Handle<Expression>,
    ) -> Result<Symbol, Unfit> {
        if let Some(known) = frame.values.get(&handle) {
            return Ok(known.clone());
        }
        let value = self.expression(frame, handle)?;
        frame.values.insert(handle, value.clone());
        Ok(value)
    }

    /// The value of a constant of the module.
    pub(super) fn constant(&mut self, init: Handle<Expression>) -> Result<Symbol, Unfit> {
        let mut frame = Frame {
            arena: &self.module.global_expressions,
            function: self.empty,
            values: HashMap::new(),
            arguments: Vec::new(),
            locals: self.memory.len(),
            done: Truth::Known(false),
            result: None,
            nodes: Vec::new(),
        };
        self.value(&mut frame, init)
    }
}

/// Name of a function without the number that the compiler gives further forms of it.
fn plain_name(name: &str) -> &str {
    let name = name.strip_suffix("_before").unwrap_or(name);
    let plain = name.trim_end_matches(|c: char| c.is_ascii_digit());
    match plain.strip_suffix('_') {
        Some(plain) if plain.len() + 1 < name.len() => plain,
        _ => name,
    }
}

#[cfg(test)]
mod tests {
    use super::plain_name;

    #[test]
    fn further_forms_of_functions_have_the_same_name() {
        assert_eq!(plain_name("profile_2"), "profile");
        assert_eq!(plain_name("finite_vec4"), "finite_vec4");
        assert_eq!(plain_name("normalize_or_before"), "normalize_or");
    }
}
