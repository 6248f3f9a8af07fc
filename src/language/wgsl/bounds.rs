//! Bounds of the code that people write, counted in its tokens before naga sees it.
//!
//! naga lowers expressions and chains of `else` by recursion, and takes a time that grows with the
//! square of a function's length. Tokens tell enough of both: every operator, bracket and member of
//! an expression can make its tree deeper by one, so their number bounds the depth without a
//! grammar.

use std::ops::Range;

use chiaro_locale::tr;

use super::scan::{Token, TokenKind, tokenize};
use super::validate::WgslError;

/// Greatest length of a node's code, in bytes; the longest shipped node has a twentieth of this.
pub const MAX_CODE_BYTES: usize = 128 * 1024;
/// Greatest number of functions, structs, constants and variables of a node's code.
pub const MAX_DECLARATIONS: usize = 500;
/// Greatest number of statements of one function. 2,000 take naga 0.03 s, 4,000 0.2 s and 40,000
/// minutes.
pub const MAX_STATEMENTS: usize = 2_000;
/// Greatest number of operators, brackets and members within one expression.
///
/// naga needs 2 MiB of stack, the least that any thread of Chiaro has, for a sum of somewhat more
/// than 4,000 terms, and the same for as many minus signs (measured on x86-64, optimized).
pub const MAX_OPERATORS: usize = 1_000;
/// Greatest number of `else` and `case` of one function. naga needs 2 MiB of stack for a chain of
/// 1,000 to 2,000 `else if`.
pub const MAX_BRANCHES: usize = 256;

/// Errors of every bound that `source` exceeds, with their places.
pub fn beyond_bounds(source: &str) -> Vec<WgslError> {
    if source.len() > MAX_CODE_BYTES {
        let message = tr!(
            "the code has {bytes} bytes, and a node's code at most {MAX_CODE_BYTES}",
            bytes = source.len()
        );
        return vec![WgslError { message, span: Some(0..0) }];
    }
    let mut counter = Counter {
        source,
        levels: vec![Level::default()],
        beyond: Vec::new(),
        ..Counter::default()
    };
    let tokens = tokenize(source);
    let mut before: Option<&Token> = None;
    for token in
        tokens.iter().filter(|token| !matches!(token.kind, TokenKind::Doc | TokenKind::ModuleDoc))
    {
        counter.token(token, before);
        before = Some(token);
    }
    counter.beyond
}

/// Counts within a pair of brackets.
#[derive(Clone, Copy, Debug, Default)]
struct Level {
    /// Number of operators since the last comma.
    operators: usize,
    /// Greatest number of operators between two commas.
    most: usize,
    /// Number of `<` that no `>` has closed since the last comma: the comma may part the arguments
    /// of a type, not expressions.
    angles: usize,
    is_block: bool,
}

#[derive(Debug, Default)]
struct Counter<'a> {
    source: &'a str,
    levels: Vec<Level>,
    declarations: usize,
    statements: usize,
    branches: usize,
    /// True if the current expression was reported.
    is_told: bool,
    /// True within a `case`, up to its `{` or `:`.
    is_case: bool,
    beyond: Vec<WgslError>,
}

impl Counter<'_> {
    fn token(&mut self, token: &Token, before: Option<&Token>) {
        let text = &self.source[token.span.clone()];
        match text {
            "(" | "[" => {
                self.operator(&token.span);
                self.levels.push(Level::default());
            }
            "{" => {
                self.is_case = false;
                self.end_expression();
                self.levels.push(Level { is_block: true, ..Level::default() });
            }
            ")" | "]" => self.close(&token.span),
            "}" => self.close_block(),
            ";" => {
                self.end_expression();
                self.statement(&token.span);
            }
            "," => self.comma(&token.span),
            ":" => self.is_case = false,
            "else" | "case" => {
                self.is_case = text == "case";
                self.branch(&token.span);
            }
            "fn" | "struct" | "const" | "var" | "alias" | "override" if self.levels.len() == 1 => {
                self.declaration(&token.span);
            }
            // `&&`, `||`, `<<` and `>>` are one operator each, and an operator with `=` is the
            // operator.
            "&" | "|" | "<" | ">"
                if before.is_some_and(|before| self.follows(before, token, text)) =>
            {
                self.angle(text);
            }
            "+" | "-" | "*" | "/" | "%" | "&" | "|" | "^" | "!" | "~" | "<" | ">" | "." => {
                self.angle(text);
                self.operator(&token.span);
            }
            _ => {}
        }
    }

    /// True if `before` is the same sign, right before this one.
    fn follows(&self, before: &Token, token: &Token, text: &str) -> bool {
        before.span.end == token.span.start && &self.source[before.span.clone()] == text
    }

    fn angle(&mut self, text: &str) {
        let level = self.level();
        match text {
            "<" => level.angles += 1,
            ">" => level.angles = level.angles.saturating_sub(1),
            _ => {}
        }
    }

    fn level(&mut self) -> &mut Level {
        if self.levels.is_empty() {
            self.levels.push(Level::default());
        }
        let last = self.levels.len() - 1;
        &mut self.levels[last]
    }

    /// Counts an operator, and reports the first one that is too many in its expression.
    fn operator(&mut self, span: &Range<usize>) {
        self.deepen(1, span);
    }

    fn deepen(&mut self, by: usize, span: &Range<usize>) {
        let level = self.level();
        level.operators += by;
        if level.operators > MAX_OPERATORS && !std::mem::replace(&mut self.is_told, true) {
            self.tell(
                tr!("operators, brackets and members in one expression"),
                MAX_OPERATORS,
                span,
                tr!("give parts of it names with `let`"),
            );
        }
    }

    fn comma(&mut self, span: &Range<usize>) {
        if self.is_case {
            self.branch(span);
        }
        let level = self.level();
        if level.angles == 0 {
            level.most = level.most.max(level.operators);
            level.operators = 0;
        }
    }

    /// Closes a bracket: its content adds the depth of its longest part to the expression around
    /// it.
    fn close(&mut self, span: &Range<usize>) {
        if self.levels.len() < 2 || self.level().is_block {
            return;
        }
        let closed = self.levels.pop().unwrap_or_default();
        self.deepen(closed.most.max(closed.operators), span);
    }

    fn close_block(&mut self) {
        // Brackets that nothing closed end with the block: naga reports them.
        while self.levels.len() > 1 && !self.level().is_block {
            self.levels.pop();
        }
        if self.levels.len() > 1 {
            self.levels.pop();
        }
        self.end_expression();
        if self.levels.len() == 1 {
            (self.statements, self.branches) = (0, 0);
        }
    }

    fn end_expression(&mut self) {
        let level = self.level();
        *level = Level { is_block: level.is_block, ..Level::default() };
        // An expression that ends within brackets, as the parts of a `for` do, is a part of the
        // same statement.
        let is_statement = level.is_block || self.levels.len() == 1;
        self.is_told &= !is_statement;
    }

    fn statement(&mut self, span: &Range<usize>) {
        if self.levels.len() > 1 {
            self.statements += 1;
            if self.statements == MAX_STATEMENTS + 1 {
                self.tell(
                    tr!("statements in one function"),
                    MAX_STATEMENTS,
                    span,
                    tr!("split it into several functions"),
                );
            }
        }
    }

    fn branch(&mut self, span: &Range<usize>) {
        self.branches += 1;
        if self.branches == MAX_BRANCHES + 1 {
            let hint = tr!("look values up in a `const` array, or split it into several functions");
            self.tell(tr!("`else` and `case` in one function"), MAX_BRANCHES, span, hint);
        }
    }

    fn declaration(&mut self, span: &Range<usize>) {
        self.declarations += 1;
        if self.declarations == MAX_DECLARATIONS + 1 {
            self.tell(
                tr!("declarations"),
                MAX_DECLARATIONS,
                span,
                tr!("split it into several nodes"),
            );
        }
    }

    fn tell(&mut self, what: &str, most: usize, span: &Range<usize>, hint: &str) {
        let message = tr!("there are more than {most} {what}: {hint}");
        self.beyond.push(WgslError { message, span: Some(span.clone()) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(body: &str) -> Vec<String> {
        let errors = beyond_bounds(&format!("fn f(x: f32) -> f32 {{ {body} }}"));
        errors.into_iter().map(|error| error.message).collect()
    }

    #[test]
    fn every_way_to_nest_an_expression_is_bounded() {
        let deep = 2 * MAX_OPERATORS;
        let expressions = [
            vec!["x"; deep].join("+"),
            vec!["x"; deep].join(" && "),
            format!("{}x", "- ".repeat(deep)),
            format!("{}x", "!".repeat(deep)),
            format!("{}x{}", "(".repeat(deep), ")".repeat(deep)),
            format!("{}x{}", "sin(".repeat(deep), ")".repeat(deep)),
            format!("x{}", ".x".repeat(deep)),
            format!("x{}", "[0]".repeat(deep)),
            // A comma of a type parts no expressions.
            vec!["array<f32, 2>(x, x)[0]"; deep / 3].join(" + "),
            format!("x > {}", vec!["array<f32, 2>(x, x)[0]"; deep / 3].join(" + ")),
            // The longest argument counts, with everything around it.
            format!("({}) {}", vec!["x"; deep / 3].join("+"), "+ x".repeat(2 * deep / 3)),
        ];
        for expression in expressions {
            assert_eq!(told(&format!("return {expression};")).len(), 1, "{}", &expression[..40]);
        }
    }

    #[test]
    fn what_people_write_is_within_bounds() {
        let table = vec!["-0.5, vec3f(1.0, -2.0, 3.0).x"; 2000].join(", ");
        assert_eq!(told(&format!("let t = array({table}); return t[0];")), [""; 0]);
        assert_eq!(told(&"let a = x * 2.0 + 1.0; ".repeat(MAX_STATEMENTS)), [""; 0]);
        assert_eq!(told(&format!("return {};", vec!["x"; MAX_OPERATORS].join("+"))), [""; 0]);
        let library = crate::wgsl::SHADER_LIBRARY
            .iter()
            .map(|&(path, text)| (path.to_owned(), text.to_owned()));
        for (path, text) in library.chain(crate::wgsl::shipped_nodes()) {
            assert_eq!(beyond_bounds(&text), [], "{path}");
        }
    }

    #[test]
    fn statements_branches_declarations_and_bytes_are_bounded() {
        assert_eq!(told(&"x;".repeat(50_000)).len(), 1);
        assert_eq!(told(&"if (x > 0.0) { } else { }".repeat(MAX_BRANCHES + 9)).len(), 1);
        assert_eq!(
            told(&format!("switch i32(x) {{ case {} {{ }} }}", "1,".repeat(MAX_BRANCHES + 9)))
                .len(),
            1
        );
        assert_eq!(beyond_bounds(&"const a = 1;".repeat(MAX_DECLARATIONS + 9)).len(), 1);
        assert_eq!(beyond_bounds(&" ".repeat(MAX_CODE_BYTES + 1)).len(), 1);
    }

    #[test]
    fn broken_text_never_panics() {
        for text in [")", "}", "]}{)(", "f(a < b, {[}", "case 1, 2", ";;}}}}((", "> > <,<"] {
            beyond_bounds(text);
        }
    }
}
