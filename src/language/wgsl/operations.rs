//! Number of operations of a function, counted in naga's IR, before any back end reduces them.

use std::ops::Range;

use naga::{Block, Expression, Function, Handle, Module, Statement};

/// Numbers of operations of every function of a module, those of called functions included.
///
/// Each expression that computes or fetches counts once: so do both sides of a branch, and the body
/// of a loop however often it runs. Literals, names, and access to parts of vectors and structs
/// count nothing.
#[derive(Clone, Debug, Default)]
pub struct Operations {
    /// Counts in the order of the module's functions.
    functions: Vec<u64>,
    /// Numbers of loops in the same order.
    loops: Vec<u64>,
}

impl Operations {
    /// Counts all functions of a module.
    pub fn of(module: &Module) -> Self {
        let mut counted = Self::default();
        // naga lists a function after all that it calls.
        for (_, function) in module.functions.iter() {
            let (count, loops) = (counted.within(function), counted.loops_within(&function.body));
            counted.functions.push(count);
            counted.loops.push(loops);
        }
        counted
    }

    /// Number of operations of a function by its name; 0 where there is none.
    pub fn of_function(&self, module: &Module, name: &str) -> u64 {
        let found =
            module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(name));
        found.map_or(0, |(handle, _)| self.called(handle))
    }

    /// Number of operations of a function of the module that was counted.
    pub fn of_handle(&self, function: Handle<Function>) -> u64 {
        self.called(function)
    }

    /// Number of loops of a function of the module that was counted, with those of called
    /// functions, once for each call.
    pub fn loops_of_handle(&self, function: Handle<Function>) -> u64 {
        self.loops.get(function.index()).copied().unwrap_or_default()
    }

    /// Number of operations of a module's entry points.
    pub fn of_entry_points(&self, module: &Module) -> u64 {
        let counts = module.entry_points.iter().map(|entry| self.within(&entry.function));
        counts.fold(0, u64::saturating_add)
    }

    /// Calls `tell` with the source range of every operation of a function or entry point, and with
    /// its number of operations.
    pub fn for_each(&self, module: &Module, mut tell: impl FnMut(Range<usize>, u64)) {
        let entry_points = module.entry_points.iter().map(|entry| &entry.function);
        for function in module.functions.iter().map(|(_, function)| function).chain(entry_points) {
            for (handle, expression) in function.expressions.iter() {
                let count = self.of_expression(expression);
                if let Some(span) =
                    function.expressions.get_span(handle).to_range().filter(|_| count > 0)
                {
                    tell(span, count);
                }
            }
        }
    }

    fn within(&self, function: &Function) -> u64 {
        // The sum saturates: functions that call others twice, and these again, soon exceed the
        // range of numbers.
        let counts =
            function.expressions.iter().map(|(_, expression)| self.of_expression(expression));
        counts.fold(0, u64::saturating_add)
    }

    /// Number of loops of a block. WGSL allows blocks within blocks at most 127 deep.
    fn loops_within(&self, block: &Block) -> u64 {
        let loops = block.iter().map(|statement| match statement {
            Statement::Block(inner) => self.loops_within(inner),
            Statement::If { accept, reject, .. } => {
                self.loops_within(accept).saturating_add(self.loops_within(reject))
            }
            Statement::Switch { cases, .. } => {
                let loops = cases.iter().map(|case| self.loops_within(&case.body));
                loops.fold(0, u64::saturating_add)
            }
            Statement::Loop { body, continuing, .. } => {
                let inner = self.loops_within(body).saturating_add(self.loops_within(continuing));
                inner.saturating_add(1)
            }
            Statement::Call { function, .. } => self.loops_of_handle(*function),
            _ => 0,
        });
        loops.fold(0, u64::saturating_add)
    }

    fn called(&self, function: Handle<Function>) -> u64 {
        self.functions.get(function.index()).copied().unwrap_or_default()
    }

    fn of_expression(&self, expression: &Expression) -> u64 {
        match expression {
            Expression::CallResult(function) => self.called(*function),
            Expression::Binary { .. }
            | Expression::Unary { .. }
            | Expression::Select { .. }
            | Expression::Math { .. }
            | Expression::As { convert: Some(_), .. }
            | Expression::Derivative { .. }
            | Expression::Relational { .. }
            | Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. } => 1,
            _ => 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_count_what_they_call_and_names_nothing() {
        let source = "
            fn inner(x: f32) -> f32 { let y = x; return y * y + 1.0; }
            fn outer(v: vec2f) -> f32 { return inner(v.x) - inner(v.y); }
            @fragment fn main() -> @location(0) vec4f { return vec4f(outer(vec2f(1.0, 2.0))); }";
        let valid = crate::wgsl::parse(source).unwrap();
        let operations = Operations::of(&valid.module);
        assert_eq!(operations.of_function(&valid.module, "inner"), 2);
        assert_eq!(operations.of_function(&valid.module, "outer"), 5);
        assert_eq!(operations.of_function(&valid.module, "nothing"), 0);
        assert_eq!(operations.of_entry_points(&valid.module), 5);
        let mut of_outer = 0;
        let line = source.find("fn outer").unwrap()..source.find("@fragment").unwrap();
        operations.for_each(&valid.module, |span, count| {
            of_outer += if line.contains(&span.start) { count } else { 0 };
        });
        assert_eq!(of_outer, 5);
    }

    #[test]
    fn loops_count_once_for_each_call() {
        let source = "
            fn inner(x: f32) -> f32 {
                var y = x;
                for (var i = 0; i < 3; i++) { while (y > 1.0) { y *= 0.5; } }
                return y;
            }
            fn outer(x: f32) -> f32 {
                if x > 0.0 { return inner(x) + inner(2.0 * x); }
                loop { break; }
                return x;
            }";
        let module = crate::wgsl::parse(source).unwrap().module;
        let operations = Operations::of(&module);
        let loops = module.functions.iter().map(|(handle, _)| operations.loops_of_handle(handle));
        assert_eq!(loops.collect::<Vec<_>>(), [2, 5]);
    }
}
