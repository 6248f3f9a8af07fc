//! Scanner for the paths in Rust source that start at the crate's root.
//!
//! A small lexer, not a parser: it drops comments, strings, characters and lifetimes, keeps words
//! and punctuation with their lines, and follows `::` and braces from there. That reads `use` items
//! and inline paths alike, also inside of macro calls, which a parser would not look into.

/// The target of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A top-level module of this crate.
    Module(String),
    /// The crate's root itself: a glob or a rename.
    WholeCrate,
    /// Another crate, or a local item of that name followed by `::`.
    Crate(String),
}

/// A path and its place in the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundPath {
    /// The target of the path.
    pub reference: Reference,
    /// The path as it would be written out, up to the name of the module or crate.
    pub path: String,
    /// Line of the path, from 1.
    pub line: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum TokenKind {
    Word(String),
    /// `::`
    Separator,
    Mark(char),
}

#[derive(Clone, Debug)]
struct Token {
    kind: TokenKind,
    line: usize,
}

/// Every path in `text` that names a top-level module or another crate. `depth` is the number of
/// modules that the file is deep: 1 for `ids.rs` and `compile/mod.rs`, 2 for `compile/emit.rs`.
pub fn references(text: &str, depth: usize) -> Vec<FoundPath> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    let mut braces = Vec::new();
    for at in 0..tokens.len() {
        match &tokens[at].kind {
            TokenKind::Mark('{') => braces.push(Brace::of(&tokens, at)),
            TokenKind::Mark('}') => {
                braces.pop();
            }
            TokenKind::Word(first)
                if braces.last() != Some(&Brace::Group) && !continues_path(&tokens, at) =>
            {
                let inline = braces.iter().filter(|&&brace| brace == Brace::Module).count();
                start(&tokens, at, first, depth + inline, &mut found);
            }
            _ => {}
        }
    }
    found
}

/// The kind of an opening brace.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Brace {
    /// `mod name {`
    Module,
    /// `path::{`, whose elements continue a path that was followed from its start.
    Group,
    Other,
}

impl Brace {
    fn of(tokens: &[Token], at: usize) -> Self {
        if at >= 1 && tokens[at - 1].kind == TokenKind::Separator {
            Self::Group
        } else if at >= 2 && is_word(tokens, at - 2, "mod") && word(tokens, at - 1).is_some() {
            Self::Module
        } else {
            Self::Other
        }
    }
}

/// Every path in `text` that starts at the crate `name`, as a program outside that crate writes it.
pub fn crate_paths(text: &str, name: &str) -> Vec<FoundPath> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    for at in 0..tokens.len() {
        if is_word(&tokens, at, name) && !continues_path(&tokens, at) {
            below(&tokens, at, 0, name, &mut found);
        }
    }
    found
}

/// Every word in `text` outside of comments and strings, with its line.
pub fn words(text: &str) -> Vec<(String, usize)> {
    let word = |token: Token| match token.kind {
        TokenKind::Word(word) => Some((word, token.line)),
        _ => None,
    };
    tokens(text).into_iter().filter_map(word).collect()
}

/// Every path in `text` that goes through the module `name`, up to the member below it.
pub fn members(text: &str, name: &str) -> Vec<FoundPath> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    for at in 0..tokens.len() {
        if is_word(&tokens, at, name) {
            below(&tokens, at, 0, name, &mut found);
        }
    }
    found
}

/// The literals of a Rust source that are in quotes, as they are written.
pub fn literals(text: &str) -> Vec<&str> {
    let mut lexer = Lexer { rest: text, line: 1 };
    let mut found = Vec::new();
    while let Some(first) = lexer.rest.chars().next() {
        if lexer.skip_comment() {
            continue;
        }
        let before = lexer.rest;
        if lexer.skip_literal() {
            found.push(&before[..before.len() - lexer.rest.len()]);
        } else if first == '_' || first.is_alphanumeric() {
            lexer.take_word();
        } else {
            lexer.advance(first.len_utf8());
        }
    }
    found
}

/// True if the word at `at` follows `name::`. A leading `::` starts a path, and so does `self::`.
fn continues_path(tokens: &[Token], at: usize) -> bool {
    let separated = at >= 1 && tokens[at - 1].kind == TokenKind::Separator;
    separated
        && at >= 2
        && matches!(&tokens[at - 2].kind, TokenKind::Word(before) if before != "self")
}

/// Records the path that starts at `at` with the word `first`, in a module `depth` levels under the
/// root.
fn start(tokens: &[Token], at: usize, first: &str, depth: usize, found: &mut Vec<FoundPath>) {
    match first {
        "crate" => below(tokens, at, 0, "crate", found),
        "super" => below(tokens, at, depth.saturating_sub(1), "super", found),
        other if follows(tokens, at, &TokenKind::Separator) => found.push(FoundPath {
            reference: Reference::Crate(other.to_owned()),
            path: other.to_owned(),
            line: tokens[at].line,
        }),
        _ => {}
    }
}

/// Records the elements below the path that ends at `at`, `levels` modules under the root.
fn below(tokens: &[Token], at: usize, levels: usize, path: &str, found: &mut Vec<FoundPath>) {
    if follows(tokens, at, &TokenKind::Separator) {
        element(tokens, at + 2, levels, path, found);
    } else if levels == 0 && is_word(tokens, at + 1, "as") {
        found.push(FoundPath {
            reference: Reference::WholeCrate,
            path: path.to_owned(),
            line: tokens[at].line,
        });
    }
}

/// Records one element of a path, `levels` modules under the root: a name, a glob, or a group of
/// elements in braces.
fn element(tokens: &[Token], at: usize, levels: usize, path: &str, found: &mut Vec<FoundPath>) {
    let Some(token) = tokens.get(at) else { return };
    match &token.kind {
        TokenKind::Mark('{') => {
            for start in group(tokens, at) {
                element(tokens, start, levels, path, found);
            }
        }
        TokenKind::Word(word) if word == "super" => {
            below(tokens, at, levels.saturating_sub(1), &format!("{path}::super"), found);
        }
        // Any other element stays inside of the file's own top-level module.
        _ if levels > 0 => {}
        TokenKind::Word(word) if word != "self" => found.push(FoundPath {
            reference: Reference::Module(word.clone()),
            path: format!("{path}::{word}"),
            line: token.line,
        }),
        TokenKind::Word(_) | TokenKind::Mark('*') => {
            found.push(FoundPath {
                reference: Reference::WholeCrate,
                path: path.to_owned(),
                line: token.line,
            });
        }
        _ => {}
    }
}

/// Starts of the elements of the group that opens at `open`.
fn group(tokens: &[Token], open: usize) -> Vec<usize> {
    let mut starts = Vec::new();
    let mut nesting = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.kind {
            TokenKind::Mark('{') => nesting += 1,
            TokenKind::Mark('}') => nesting -= 1,
            _ => {}
        }
        if nesting == 0 {
            break;
        }
        let begins = matches!(token.kind, TokenKind::Mark('{' | ','));
        if begins && nesting == 1 {
            starts.push(at + 1);
        }
    }
    starts
}

fn word(tokens: &[Token], at: usize) -> Option<&str> {
    match &tokens.get(at)?.kind {
        TokenKind::Word(word) => Some(word),
        _ => None,
    }
}

fn is_word(tokens: &[Token], at: usize, expected: &str) -> bool {
    word(tokens, at) == Some(expected)
}

fn follows(tokens: &[Token], at: usize, kind: &TokenKind) -> bool {
    tokens.get(at + 1).is_some_and(|token| &token.kind == kind)
}

/// The words and marks of `text`, without comments, literals and lifetimes.
fn tokens(text: &str) -> Vec<Token> {
    let mut lexer = Lexer { rest: text, line: 1 };
    let mut tokens = Vec::new();
    while let Some(first) = lexer.rest.chars().next() {
        let line = lexer.line;
        if lexer.skip_comment() || lexer.skip_literal() {
            continue;
        }
        if first == '_' || first.is_alphanumeric() {
            let name = lexer.take_word();
            if !first.is_numeric() {
                tokens.push(Token { kind: TokenKind::Word(name), line });
            }
        } else if lexer.rest.starts_with("::") {
            lexer.advance(2);
            tokens.push(Token { kind: TokenKind::Separator, line });
        } else {
            lexer.advance(first.len_utf8());
            if !first.is_whitespace() {
                tokens.push(Token { kind: TokenKind::Mark(first), line });
            }
        }
    }
    tokens
}

struct Lexer<'a> {
    rest: &'a str,
    line: usize,
}

impl Lexer<'_> {
    fn advance(&mut self, bytes: usize) {
        let (passed, rest) = self.rest.split_at(bytes.min(self.rest.len()));
        self.line += passed.matches('\n').count();
        self.rest = rest;
    }

    fn advance_past(&mut self, from: usize, end: &str) {
        let length =
            self.rest[from..].find(end).map_or(self.rest.len(), |found| from + found + end.len());
        self.advance(length);
    }

    fn take_word(&mut self) -> String {
        let end =
            self.rest.find(|c: char| c != '_' && !c.is_alphanumeric()).unwrap_or(self.rest.len());
        let word = self.rest[..end].to_owned();
        self.advance(end);
        word
    }

    /// Skips a line comment, or a block comment, which may nest.
    fn skip_comment(&mut self) -> bool {
        if self.rest.starts_with("//") {
            self.advance(self.rest.find('\n').unwrap_or(self.rest.len()));
            return true;
        }
        if !self.rest.starts_with("/*") {
            return false;
        }
        let mut nesting = 0_usize;
        while !self.rest.is_empty() {
            if self.rest.starts_with("/*") {
                nesting += 1;
                self.advance(2);
            } else if self.rest.starts_with("*/") {
                nesting -= 1;
                self.advance(2);
                if nesting == 0 {
                    break;
                }
            } else {
                self.advance(self.rest.chars().next().map_or(1, char::len_utf8));
            }
        }
        true
    }

    /// Skips a string of any kind, a character or a lifetime, with its prefix.
    fn skip_literal(&mut self) -> bool {
        let prefix = ["br", "cr", "r", "b", "c", ""].into_iter().find(|prefix| {
            let after = self.rest.strip_prefix(prefix).map(|rest| rest.trim_start_matches('#'));
            after.is_some_and(|rest| rest.starts_with('"'))
                && (prefix.ends_with('r') || !self.rest[prefix.len()..].starts_with('#'))
        });
        if let Some(prefix) = prefix {
            self.skip_string(prefix);
            return true;
        }
        if !self.rest.starts_with('\'') {
            return false;
        }
        let mut after = self.rest[1..].chars();
        match (after.next(), after.next()) {
            // `'\''`: an escaped character never closes the literal.
            (Some('\\'), Some(escaped)) => self.advance_past(2 + escaped.len_utf8(), "'"),
            (Some(one), Some('\'')) => self.advance(2 + one.len_utf8()),
            // A lifetime or a label.
            _ => {
                self.advance(1);
                self.take_word();
            }
        }
        true
    }

    fn skip_string(&mut self, prefix: &str) {
        self.advance(prefix.len());
        if prefix.ends_with('r') {
            let hashes = self.rest.len() - self.rest.trim_start_matches('#').len();
            self.advance_past(hashes + 1, &format!("\"{}", "#".repeat(hashes)));
            return;
        }
        let mut end = 1;
        let bytes = self.rest.as_bytes();
        while end < bytes.len() && bytes[end] != b'"' {
            end += if bytes[end] == b'\\' { 2 } else { 1 };
        }
        self.advance(end + 1);
    }
}
