//! Counters for the loops of code that people write, so that every loop ends.
//!
//! A GPU that loops forever hangs the whole machine, and Mesa's software Vulkan ends the loops of a
//! shader after 65,535 rounds in all, without a word. So a loop whose end cannot be proved gets a
//! counter, in the text itself: the shader, every export, the interpreter and the reference then
//! agree about the last round.
//!
//! The end of a `for` is proved where it counts with whole numbers that are written in the code,
//! and its body leaves the counted variable alone. The counter of a function counts the rounds of
//! all its other loops together, nested ones included:
//!
//! ```wgsl
//! fn escape(x: f32) -> f32 {
//!     var rounds = 0u;
//!     var y = x;
//!     while y < 100.0 {
//!         if rounds == 4096u { break; } rounds += 1u;
//!         y *= 1.5;
//!     }
//!     return y;
//! }
//! ```

use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::LazyLock;

use chiaro_locale::tr;

use super::link::library_scans;
use super::scan::{DeclarationKind, Scan, Token, TokenKind, scan, tokenize};
use super::validate::WgslError;

/// Greatest number of rounds of all loops of one call of a function whose ends are not proved.
///
/// Even where eight or sixteen fragments loop in step, each as long as the longest, one such call
/// stays within the limit of software Vulkan.
pub const MAX_ROUNDS: u64 = 4096;
/// Greatest number of rounds of one call of a function, with those of the functions that it calls.
pub const MAX_CALL_ROUNDS: u64 = 1 << 20;
/// Number of rounds assumed for a call of the library's own functions: eight octaves of eight
/// corners.
const LIBRARY_ROUNDS: u64 = 64;

/// Functions that may be imported.
static LIBRARY_FUNCTIONS: LazyLock<HashSet<String>> = LazyLock::new(|| {
    let declarations = library_scans().flat_map(|(_, scan)| &scan.declarations);
    declarations
        .filter(|found| found.kind == DeclarationKind::Function)
        .map(|found| found.name.clone())
        .collect()
});

/// Code whose loops all end.
#[derive(Clone, Debug, Default)]
pub struct BoundedLoops {
    /// Code with counters; unchanged where all ends are proved.
    pub text: String,
    /// Loops that are counted, in order.
    pub counted: Vec<CountedLoop>,
    /// Errors of functions that loop too long in each round of a loop.
    pub beyond: Vec<WgslError>,
}

/// Loop that a counter ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CountedLoop {
    /// Byte range of the loop's keyword in the code.
    pub span: Range<usize>,
    /// Number of rounds, where it is proved and too large.
    pub rounds: Option<u64>,
}

/// Adds a counter to every loop of `source` whose end is not proved.
pub fn bound_loops(source: &str) -> BoundedLoops {
    let mut bounded = BoundedLoops { text: source.to_owned(), ..BoundedLoops::default() };
    let code = Code::new(source);
    let functions: Vec<FunctionLoops> = code.functions();
    for function in &functions {
        let is_counted = |found: &&Loop| found.is_counted();
        let counted = function.loops.iter().filter(is_counted);
        bounded.counted.extend(
            counted.map(|found| CountedLoop { span: found.span.clone(), rounds: found.rounds }),
        );
    }
    let mut rounds = Rounds { functions: &functions, known: HashMap::new(), open: HashSet::new() };
    for (index, function) in functions.iter().enumerate() {
        let total = rounds.of(index);
        if total > MAX_CALL_ROUNDS {
            let message = tr!(
                "the loops of `{name}` may take {total} rounds, one within the other and in what \
                 they call, \
                 and one call at most {MAX_CALL_ROUNDS}: write inner ones as `for` with whole \
                 numbers in \
                 place of variables",
                name = function.name
            );
            bounded.beyond.push(WgslError { message, span: Some(function.span.clone()) });
        }
    }
    if !bounded.counted.is_empty() {
        bounded.text = code.with_counters(&functions);
    }
    bounded
}

/// Loop, as read from its tokens.
#[derive(Debug)]
struct Loop {
    /// Byte range of the keyword.
    span: Range<usize>,
    /// Byte after the brace that opens the body.
    body: usize,
    /// Index of the loop around this one.
    parent: Option<usize>,
    /// Number of rounds that the head gives, if it does.
    rounds: Option<u64>,
    /// Functions that the loop calls, but not in loops within it.
    calls: Vec<usize>,
    /// Number of calls of imported functions.
    library_calls: u64,
}

impl Loop {
    fn is_counted(&self) -> bool {
        self.rounds.is_none_or(|rounds| rounds > MAX_ROUNDS)
    }
}

#[derive(Debug)]
struct FunctionLoops {
    name: String,
    /// Byte range of the name.
    span: Range<usize>,
    /// Byte after the brace that opens the body.
    body: usize,
    loops: Vec<Loop>,
    /// Functions that the function calls outside loops.
    calls: Vec<usize>,
}

/// Numbers of rounds of calls, each function computed once.
struct Rounds<'a> {
    functions: &'a [FunctionLoops],
    known: HashMap<usize, u64>,
    open: HashSet<usize>,
}

impl Rounds<'_> {
    /// Greatest number of rounds of one call. The recursion is as deep as functions call one
    /// another, whose number is bounded.
    fn of(&mut self, index: usize) -> u64 {
        if let Some(&known) = self.known.get(&index) {
            return known;
        }
        // naga refuses rings of calls.
        if !self.open.insert(index) {
            return 0;
        }
        let function = &self.functions[index];
        let outside =
            function.calls.iter().fold(0u64, |sum, &callee| sum.saturating_add(self.of(callee)));
        // Loops are listed before those within them.
        let mut within = vec![0u64; function.loops.len()];
        let (mut seen, mut counted) = (outside, 0u64);
        for (at, found) in function.loops.iter().enumerate().rev() {
            let library = found.library_calls.saturating_mul(LIBRARY_ROUNDS);
            let calls = found
                .calls
                .iter()
                .fold(library, |sum, &callee| sum.saturating_add(self.of(callee)));
            let a_round = calls.saturating_add(within[at]).saturating_add(1);
            if found.is_counted() {
                // One counter ends all counted loops, whichever of them takes the rounds.
                counted = counted.max(MAX_ROUNDS.saturating_mul(a_round));
                continue;
            }
            let all = found.rounds.unwrap_or_default().saturating_mul(a_round);
            match found.parent {
                Some(parent) => within[parent] = within[parent].saturating_add(all),
                None => seen = seen.saturating_add(all),
            }
        }
        let total = seen.saturating_add(counted);
        self.open.remove(&index);
        self.known.insert(index, total);
        total
    }
}

/// Code with its tokens.
struct Code<'a> {
    source: &'a str,
    tokens: Vec<Token>,
    scan: Scan,
    /// Values of constants that are whole numbers.
    constants: HashMap<&'a str, WholeNumber>,
}

/// Whole number, and whether its type is unsigned.
#[derive(Clone, Copy, Debug)]
struct WholeNumber {
    value: i64,
    is_unsigned: bool,
}

impl<'a> Code<'a> {
    fn new(source: &'a str) -> Self {
        let is_code = |token: &Token| !matches!(token.kind, TokenKind::Doc | TokenKind::ModuleDoc);
        let tokens = tokenize(source).into_iter().filter(is_code).collect();
        let mut code = Self { source, tokens, scan: scan(source), constants: HashMap::new() };
        code.constants = code.whole_constants();
        code
    }

    fn text(&self, index: usize) -> &'a str {
        self.tokens.get(index).map_or("", |token| &self.source[token.span.clone()])
    }

    /// True if these texts follow one another from a token on.
    fn is(&self, from: usize, texts: &[&str]) -> bool {
        texts.iter().enumerate().all(|(offset, text)| self.text(from + offset) == *text)
    }

    /// Constants outside functions that are whole numbers, and whose names mean nothing else
    /// anywhere.
    fn whole_constants(&self) -> HashMap<&'a str, WholeNumber> {
        let mut declared: HashMap<&str, usize> = HashMap::new();
        for index in 1..self.tokens.len() {
            let is_local = matches!(self.text(index - 1), "const" | "let" | "var");
            let is_parameter =
                matches!(self.text(index - 1), "(" | ",") && self.text(index + 1) == ":";
            if is_local || is_parameter {
                *declared.entry(self.text(index)).or_default() += 1;
            }
        }
        let mut constants = HashMap::new();
        for index in (0..self.tokens.len()).filter(|&index| self.text(index) == "const") {
            let name = self.text(index + 1);
            let (ty, equals) = if self.text(index + 2) == ":" {
                (self.text(index + 3), index + 4)
            } else {
                ("", index + 2)
            };
            if declared.get(name) == Some(&1)
                && self.text(equals) == "="
                && let Some((mut whole, end)) = self.whole(equals + 1)
                && self.text(end) == ";"
            {
                whole.is_unsigned |= ty == "u32";
                constants.insert(name, whole);
            }
        }
        constants
    }

    /// Whole number at a token, and the index of the next token.
    fn whole(&self, at: usize) -> Option<(WholeNumber, usize)> {
        let (sign, at) = if self.text(at) == "-" { (-1, at + 1) } else { (1, at) };
        let text = self.text(at);
        if let Some(&constant) = self.constants.get(text) {
            return Some((WholeNumber { value: sign * constant.value, ..constant }, at + 1));
        }
        let digits = text.strip_suffix(['i', 'u']).unwrap_or(text);
        let value = match digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
            Some(hex) => i64::from_str_radix(hex, 16).ok()?,
            None => digits.parse().ok()?,
        };
        let is_number = self.tokens.get(at).is_some_and(|token| token.kind == TokenKind::Number);
        // WGSL has no whole numbers beyond 32 bits, and within them no sum of two overflows here.
        let is_in_range = value <= i64::from(u32::MAX);
        (is_number && is_in_range).then_some((
            WholeNumber { value: sign * value, is_unsigned: text.ends_with('u') },
            at + 1,
        ))
    }

    fn functions(&self) -> Vec<FunctionLoops> {
        let declared = || {
            self.scan.declarations.iter().filter(|found| found.kind == DeclarationKind::Function)
        };
        let names: HashMap<&str, usize> =
            declared().enumerate().map(|(i, found)| (found.name.as_str(), i)).collect();
        let function = |found: &super::scan::Declaration| {
            let first = self.tokens.partition_point(|token| token.span.start < found.body.start);
            let last = self.tokens.partition_point(|token| token.span.start < found.body.end);
            self.function(&found.name, first..last, &names)
        };
        declared().map(function).collect()
    }

    fn function(
        &self,
        name: &str,
        tokens: Range<usize>,
        names: &HashMap<&str, usize>,
    ) -> FunctionLoops {
        let named = tokens.clone().find(|&index| self.text(index) == name).unwrap_or(tokens.start);
        let open = tokens.clone().find(|&index| self.text(index) == "{").unwrap_or(tokens.start);
        let end_of =
            |index: usize| self.tokens.get(index).map_or(self.source.len(), |token| token.span.end);
        let span = self.tokens.get(named).map_or(0..0, |token| token.span.clone());
        let mut function = FunctionLoops {
            name: name.to_owned(),
            span,
            body: end_of(open),
            loops: Vec::new(),
            calls: Vec::new(),
        };
        // `braces`: the loop that each open brace begins, if it is a loop's. `next`: the loop that
        // the next brace will begin.
        let mut braces: Vec<Option<usize>> = Vec::new();
        let mut next: Option<usize> = None;
        for index in open..tokens.end {
            let around = next.or_else(|| braces.iter().rev().copied().flatten().next());
            match self.text(index) {
                "for" | "while" | "loop" => {
                    let span = self.tokens[index].span.clone();
                    let parent = braces.iter().rev().copied().flatten().next();
                    let body =
                        (index..tokens.end).find(|&at| self.text(at) == "{").unwrap_or(index);
                    let rounds = self.rounds(index, body..tokens.end);
                    next = Some(function.loops.len());
                    let body = end_of(body);
                    function.loops.push(Loop {
                        span,
                        body,
                        parent,
                        rounds,
                        calls: Vec::new(),
                        library_calls: 0,
                    });
                }
                "{" => braces.push(next.take()),
                "}" => drop(braces.pop()),
                word if self.text(index + 1) == "(" => {
                    let callee = names.get(word).copied();
                    match (around, callee) {
                        (Some(found), Some(callee)) => function.loops[found].calls.push(callee),
                        (None, Some(callee)) => function.calls.push(callee),
                        (Some(found), None) => {
                            function.loops[found].library_calls +=
                                u64::from(self.is_imported(word));
                        }
                        (None, None) => {}
                    }
                }
                _ => {}
            }
        }
        function
    }

    /// True for the name of an imported function.
    fn is_imported(&self, word: &str) -> bool {
        !self.scan.imports.is_empty() && LIBRARY_FUNCTIONS.contains(word)
    }

    /// Number of rounds that the head of a `for` gives, if it does; `body` begins with the brace of
    /// its body.
    fn rounds(&self, keyword: usize, body: Range<usize>) -> Option<u64> {
        if !self.is(keyword, &["for", "(", "var"]) {
            return None;
        }
        let name = self.text(keyword + 3);
        let (ty, equals) = if self.text(keyword + 4) == ":" {
            (self.text(keyword + 5), keyword + 6)
        } else {
            ("", keyword + 4)
        };
        if self.text(equals) != "=" || !matches!(ty, "" | "i32" | "u32") {
            return None;
        }
        let (first, at) = self.whole(equals + 1)?;
        if !self.is(at, &[";", name]) {
            return None;
        }
        let (compared, has_end) = (self.text(at + 2), self.text(at + 3) == "=");
        let (last, at) = self.whole(at + 3 + usize::from(has_end))?;
        if !self.is(at, &[";", name]) {
            return None;
        }
        let (step, at) = self.step(at + 2)?;
        if self.text(at) != ")" || self.text(at + 1) != "{" || self.changes(name, body) {
            return None;
        }
        let is_unsigned = ty == "u32" || first.is_unsigned || last.is_unsigned || step.is_unsigned;
        let end = i64::from(has_end);
        let (distance, beyond) = match compared {
            "<" if step.value > 0 => {
                (last.value - first.value + end, last.value + step.value + end - 1)
            }
            ">" if step.value < 0 => {
                (first.value - last.value + end, last.value + step.value - end + 1)
            }
            _ => return None,
        };
        // A variable that wraps around at the end of its type begins anew.
        let least = if is_unsigned { 0 } else { i64::from(i32::MIN) };
        if beyond < least || beyond > i64::from(i32::MAX) {
            return None;
        }
        let rounds = distance.max(0).unsigned_abs().div_ceil(step.value.unsigned_abs());
        Some(rounds)
    }

    /// Number that the third part of a `for` adds, from the token after the name on.
    fn step(&self, at: usize) -> Option<(WholeNumber, usize)> {
        let one = WholeNumber { value: 1, is_unsigned: false };
        match (self.text(at), self.text(at + 1)) {
            ("+", "+") => Some((one, at + 2)),
            ("-", "-") => Some((WholeNumber { value: -1, ..one }, at + 2)),
            ("+", "=") => self.whole(at + 2),
            ("-", "=") => self
                .whole(at + 2)
                .map(|(whole, end)| (WholeNumber { value: -whole.value, ..whole }, end)),
            _ => None,
        }
    }

    /// True if a block, which begins at a brace, may change a variable: by assigning to it, or
    /// through a pointer.
    fn changes(&self, name: &str, block: Range<usize>) -> bool {
        let mut depth = 0usize;
        for index in block {
            match self.text(index) {
                "{" => depth += 1,
                "}" => depth = depth.saturating_sub(1),
                word if word == name => {
                    let after = (self.text(index + 1), self.text(index + 2));
                    let is_assigned = match after {
                        ("=", next) => next != "=",
                        ("+", "+") | ("-", "-") => true,
                        (_, "=") => !matches!(after.0, "<" | ">" | "!"),
                        // `<<=` and `>>=`.
                        ("<", "<") | (">", ">") => self.text(index + 3) == "=",
                        _ => false,
                    };
                    if is_assigned || self.text(index.saturating_sub(1)) == "&" {
                        return true;
                    }
                }
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
        false
    }

    /// Code with a counter in each function that has loops to count.
    fn with_counters(&self, functions: &[FunctionLoops]) -> String {
        let counter = self.unused_name("rounds");
        let mut inserted: Vec<(usize, String)> = Vec::new();
        for function in functions {
            let counted: Vec<&Loop> =
                function.loops.iter().filter(|found| found.is_counted()).collect();
            if counted.is_empty() {
                continue;
            }
            inserted.push((function.body, format!("var {counter} = 0u;")));
            let end = format!("if {counter} == {MAX_ROUNDS}u {{ break; }} {counter} += 1u;");
            inserted.extend(counted.iter().map(|found| (found.body, end.clone())));
        }
        inserted.sort_by_key(|(at, _)| *at);
        let mut text = String::with_capacity(self.source.len() + 64 * inserted.len());
        let mut at = 0;
        for (place, line) in inserted {
            text.push_str(&self.source[at..place]);
            at = place;
            text.push_str(&self.indentation(place));
            text.push_str(&line);
        }
        text.push_str(&self.source[at..]);
        text
    }

    /// White space before a statement that is inserted after a brace: a line of its own where the
    /// others have theirs.
    fn indentation(&self, brace: usize) -> String {
        let rest = &self.source[brace..];
        let after = rest.trim_start_matches([' ', '\t', '\r']);
        let Some(next) = after.strip_prefix('\n') else { return " ".to_owned() };
        let blank = next.len() - next.trim_start_matches([' ', '\t']).len();
        format!("\n{}", &next[..blank])
    }

    /// Name that occurs nowhere in the code.
    fn unused_name(&self, wanted: &str) -> String {
        let words: HashSet<&str> = (0..self.tokens.len()).map(|index| self.text(index)).collect();
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let mut names = std::iter::once(wanted.to_owned()).chain(numbered);
        names.find(|name| !words.contains(name.as_str())).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(body: &str) -> usize {
        let bounded =
            bound_loops(&format!("const STEPS = 64;\nfn f(x: f32) -> f32 {{ {body} return x; }}"));
        assert!(bounded.beyond.is_empty(), "{body}: {:?}", bounded.beyond);
        crate::wgsl::parse(&bounded.text)
            .unwrap_or_else(|error| panic!("{}: {error}", bounded.text));
        bounded.counted.len()
    }

    #[test]
    fn an_end_that_can_be_seen_needs_no_counter() {
        for head in [
            "for (var i = 0; i < 8; i++)",
            "for (var i = 8u; i > 0u; i--)",
            "for (var i: u32 = 0; i <= 100; i += 2u)",
            "for (var i = -3; i < STEPS; i++)",
            "for (var i = 7; i >= 0; i -= 1)",
            "for (var i = 0x1; i < 0x10; i++)",
        ] {
            assert_eq!(
                counted(&format!("{head} {{ let a = i == 3 || i >= 4; if (a) {{ continue; }} }}")),
                0,
                "{head}"
            );
        }
    }

    #[test]
    fn every_other_loop_is_counted() {
        for body in [
            "while (x > 0.5) { }",
            "loop { if (x > 0.5) { break; } }",
            "loop { if (x > 9.0) { continue; } continuing { break if x > 0.5; } }",
            "for (;;) { if (x > 0.5) { break; } }",
            "for (var i = 0; i < i32(x); i++) { }",
            "for (var i = 0.0; i < 1.0; i += 0.1) { }",
            "for (var i = 0; i < 8; i++) { i = 0; }",
            "for (var i = 0; i < 8; i++) { i -= 1; }",
            "for (var i = 0; i < 8; i++) { i--; }",
            "for (var i = 1; i < 8; i++) { i >>= 1u; }",
            "for (var i = 0; i < 8; i++) { let p = &i; *p = 0; }",
            "for (var i = 0; i < 8; i--) { }",
            "for (var i = 0; i < 8; i += 0) { }",
            // An unsigned number is never below 0, and no number is above the largest.
            "for (var i = 7u; i >= 0u; i--) { }",
            "for (var i = 0; i <= 2147483647; i++) { }",
            "for (var i = 0; i < 100000; i++) { }",
            "{ let STEPS = i32(x); for (var i = 0; i < STEPS; i++) { } }",
        ] {
            assert_eq!(counted(body), 1, "{body}");
        }
    }

    #[test]
    fn nested_loops_share_a_counter_and_keep_their_lines() {
        let source = "fn f(x: f32) -> f32 \
                      {\n    var rounds = x;\n    while (rounds > 0.5) {\n        loop { break; \
                      }\n    }\n    return rounds;\n}\n";
        let bounded = bound_loops(source);
        let expected = "fn f(x: f32) -> f32 \
                        {\n    var rounds_2 = 0u;\n    var rounds = x;\n    while (rounds > 0.5) \
                        {\n        \
                        if rounds_2 == 4096u { break; } rounds_2 += 1u;\n        loop \
                        { if rounds_2 == 4096u { break; } rounds_2 += 1u; break; }\n    }\n    \
                        return rounds;\n}\n";
        assert_eq!(bounded.text, expected);
        assert_eq!(bounded.counted.len(), 2);
        crate::wgsl::parse(&bounded.text).unwrap();
    }

    #[test]
    fn loops_within_loops_are_bounded_through_calls_too() {
        let inner = "fn g(x: f32) -> f32 { var y = x; while (y > 0.5) { y *= 0.9; } return y; }\n";
        let few = format!(
            "fn f(x: f32) -> f32 {{ var y = x; for (var i = 0; i < 8; i++) {{ y += g(y); }} return \
             y; }}\n{inner}"
        );
        assert!(bound_loops(&few).beyond.is_empty());
        let many = few.replace("i < 8", "i < 4000");
        assert_eq!(bound_loops(&many).beyond.len(), 1);
        let unseen = few.replace("for (var i = 0; i < 8; i++)", "while (y < 100.0)");
        assert_eq!(bound_loops(&unseen).beyond.len(), 1);
        let nested = "fn f(x: f32) -> f32 \
                      { for (var i = 0; i < 2000; i++) { for (var j = 0; j < 2000; j++) { } } \
                      return x; }";
        assert_eq!(bound_loops(nested).beyond.len(), 1);
    }

    #[test]
    fn broken_text_never_panics() {
        let source = "const N = 3; fn f(x: f32) -> f32 \
                      { for (var i = 0; i < N; i++) { loop { } } while (x > 0.0) { } }";
        for end in 0..=source.len() {
            bound_loops(&source[..end]);
            bound_loops(&source[end..]);
        }
    }
}
