//! Scanner of WGSL text: top-level declarations with their docs, signatures and the names they use.
//!
//! naga drops argument comments, alias names and the spans of whole declarations, and a node's
//! ports are read from exactly these. The scanner knows tokens and brackets, not grammar: naga
//! validates the same text afterwards.

use std::ops::Range;

/// Kind of a top-level declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeclarationKind {
    /// `fn`
    Function,
    /// `struct`
    Struct,
    /// `const` or `override`
    Constant,
    /// `alias`
    Alias,
    /// `var`
    Variable,
}

/// Parameter of a function or member of a struct, with its type as written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Name of the field.
    pub name: String,
    /// Type as written, without spaces: `vec3f`, `texture_2d<f32>`.
    pub ty: String,
    /// Lines of the field's own doc comment (struct members only).
    pub doc: Vec<String>,
}

/// Top-level declaration.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Kind of the declaration.
    pub kind: DeclarationKind,
    /// Name of the declaration.
    pub name: String,
    /// Byte range in the source, from the first doc line to the closing brace or semicolon.
    pub span: Range<usize>,
    /// Byte range without the docs.
    pub body: Range<usize>,
    /// Lines of the doc comment, without `///` and one space.
    pub doc: Vec<String>,
    /// Parameters or members.
    pub fields: Vec<Field>,
    /// Result type of a function as written.
    pub result: Option<String>,
    /// All identifiers in the declaration but its own name; a superset of the declarations it uses.
    pub uses: Vec<String>,
}

/// Import: a line `import chiaro::name;`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    /// Path as written, without spaces: `chiaro::profile`.
    pub path: String,
    /// Byte range in the source.
    pub span: Range<usize>,
}

/// Scanned source.
#[derive(Clone, Debug, Default)]
pub struct Scan {
    /// Lines of the `//!` comment at the top.
    pub doc: Vec<String>,
    /// Imports, in order.
    pub imports: Vec<Import>,
    /// Declarations, in order.
    pub declarations: Vec<Declaration>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TokenKind {
    Word,
    Number,
    Symbol,
    Doc,
    ModuleDoc,
}

#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: TokenKind,
    pub(super) span: Range<usize>,
}

/// Splits `source` into tokens; comments other than docs are dropped.
pub(super) fn tokenize(source: &str) -> Vec<Token> {
    let bytes = source.as_bytes();
    let mut tokens = Vec::with_capacity(bytes.len() / 4);
    let mut at = 0;
    while at < bytes.len() {
        let start = at;
        let byte = bytes[at];
        if byte.is_ascii_whitespace() {
            at += 1;
            continue;
        }
        let kind = if source[at..].starts_with("//") {
            at =
                bytes[at..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |end| start + end);
            let line = &source[start..at];
            if line.starts_with("///") && !line.starts_with("////") {
                TokenKind::Doc
            } else if line.starts_with("//!") {
                TokenKind::ModuleDoc
            } else {
                continue;
            }
        } else if source[at..].starts_with("/*") {
            at = end_of_block_comment(bytes, at);
            continue;
        } else if byte.is_ascii_digit() {
            while at < bytes.len() && (bytes[at].is_ascii_alphanumeric() || bytes[at] == b'.') {
                at += 1;
            }
            TokenKind::Number
        } else if byte.is_ascii_alphabetic() || byte == b'_' || byte >= 0x80 {
            while at < bytes.len()
                && (bytes[at].is_ascii_alphanumeric() || bytes[at] == b'_' || bytes[at] >= 0x80)
            {
                at += 1;
            }
            TokenKind::Word
        } else {
            at += 1;
            TokenKind::Symbol
        };
        tokens.push(Token { kind, span: start..at });
    }
    tokens
}

/// The code of a source: its tokens without comments and the space between them. Sources with the
/// same code are the same program.
pub fn code(source: &str) -> String {
    let tokens = tokenize(source).into_iter();
    let is_code = |token: &Token| !matches!(token.kind, TokenKind::Doc | TokenKind::ModuleDoc);
    tokens.filter(is_code).fold(String::with_capacity(source.len()), |mut code, token| {
        code.push_str(&source[token.span]);
        code.push('\n');
        code
    })
}

fn end_of_block_comment(bytes: &[u8], start: usize) -> usize {
    let mut depth = 0usize;
    let mut at = start;
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" => {
                depth += 1;
                at += 2;
            }
            b"*/" => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return at;
                }
            }
            _ => at += 1,
        }
    }
    bytes.len()
}

/// Scans a whole source. Invalid text gives the declarations that can be made out; naga reports the
/// rest.
pub fn scan(source: &str) -> Scan {
    let tokens = tokenize(source);
    let mut scanner = Scanner { source, tokens: &tokens, at: 0 };
    let mut scan = Scan::default();
    while let Some(token) = scanner.peek() {
        match token.kind {
            TokenKind::ModuleDoc => {
                scan.doc.push(doc_line(source, token));
                scanner.at += 1;
            }
            _ => scanner.item(&mut scan),
        }
    }
    scan
}

/// Identifiers of `text`, in order.
pub fn identifiers(text: &str) -> Vec<String> {
    let words = tokenize(text).into_iter().filter(|token| token.kind == TokenKind::Word);
    words.map(|token| text[token.span].to_owned()).collect()
}

/// Replaces every identifier of `text` that `renamed` knows. Members after a `.` are left alone.
pub fn rename_identifiers(text: &str, renamed: impl Fn(&str) -> Option<String>) -> String {
    let mut result = String::with_capacity(text.len());
    let mut at = 0;
    let mut after_dot = false;
    for token in tokenize(text) {
        let word = &text[token.span.clone()];
        if token.kind == TokenKind::Word
            && !after_dot
            && let Some(name) = renamed(word).filter(|name| name != word)
        {
            result.push_str(&text[at..token.span.start]);
            result.push_str(&name);
            at = token.span.end;
        }
        after_dot = word == ".";
    }
    result.push_str(&text[at..]);
    result
}

fn doc_line(source: &str, token: &Token) -> String {
    let text = &source[token.span.start + 3..token.span.end];
    text.strip_prefix(' ').unwrap_or(text).trim_end().to_owned()
}

struct Scanner<'a> {
    source: &'a str,
    tokens: &'a [Token],
    at: usize,
}

impl<'a> Scanner<'a> {
    fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.at)
    }

    fn text(&self, token: &Token) -> &'a str {
        &self.source[token.span.clone()]
    }

    fn peek_text(&self) -> &'a str {
        self.peek().map_or("", |token| self.text(token))
    }

    /// Scans one top-level item: docs, attributes, then everything to its closing `}` or `;`.
    fn item(&mut self, scan: &mut Scan) {
        let first = self.at;
        let mut doc = Vec::new();
        while let Some(token) =
            self.peek().filter(|token| matches!(token.kind, TokenKind::Doc | TokenKind::ModuleDoc))
        {
            doc.push(doc_line(self.source, token));
            self.at += 1;
        }
        let body_first = self.at;
        self.skip_attributes();
        let keyword = self.peek_text();
        let start = self.at;
        self.skip_item(keyword);
        let item = &self.tokens[start..self.at];
        let Some(last) = item.last() else { return };
        let end = last.span.end;
        if keyword == "import" {
            let words = item.iter().skip(1).take_while(|token| self.text(token) != ";");
            let path = words.map(|token| self.text(token)).collect();
            scan.imports.push(Import { path, span: self.tokens[start].span.start..end });
            return;
        }
        let Some(kind) = declaration_kind(keyword) else { return };
        let Some(name_at) = self.name_index(start, kind) else { return };
        let name = self.text(&self.tokens[name_at]).to_owned();
        let (fields, result) = self.signature(kind, name_at + 1, start + item.len());
        let uses = self.uses(&self.tokens[body_first..self.at], &name, &fields);
        scan.declarations.push(Declaration {
            kind,
            name,
            span: self.tokens[first].span.start..end,
            body: self.tokens[body_first].span.start..end,
            doc,
            fields,
            result,
            uses,
        });
    }

    /// Identifiers that may name other declarations: not members, and not locals unless they are
    /// called.
    fn uses(&self, tokens: &[Token], name: &str, fields: &[Field]) -> Vec<String> {
        let mut locals: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
        for pair in tokens.windows(2) {
            if matches!(self.text(&pair[0]), "let" | "var" | "const") {
                locals.push(self.text(&pair[1]));
            }
        }
        let mut uses = Vec::new();
        for (index, token) in
            tokens.iter().enumerate().filter(|(_, token)| token.kind == TokenKind::Word)
        {
            let word = self.text(token);
            let is_member = index > 0 && self.text(&tokens[index - 1]) == ".";
            let is_called = tokens.get(index + 1).is_some_and(|next| self.text(next) == "(");
            if word != name && !is_member && (is_called || !locals.contains(&word)) {
                uses.push(word.to_owned());
            }
        }
        uses
    }

    fn skip_attributes(&mut self) {
        while self.peek_text() == "@" {
            self.at += 2;
            if self.peek_text() == "(" {
                self.skip_brackets("(", ")");
            }
        }
    }

    fn skip_brackets(&mut self, open: &str, close: &str) {
        let mut depth = 0usize;
        while let Some(token) = self.peek() {
            self.at += 1;
            let text = self.text(token);
            if text == open {
                depth += 1;
            } else if text == close {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return;
                }
            }
        }
    }

    fn skip_item(&mut self, keyword: &str) {
        let ends_with_braces = matches!(keyword, "fn" | "struct");
        while let Some(token) = self.peek() {
            match self.text(token) {
                "{" => {
                    self.skip_brackets("{", "}");
                    if ends_with_braces {
                        return;
                    }
                }
                ";" => {
                    self.at += 1;
                    return;
                }
                _ => self.at += 1,
            }
        }
    }

    fn name_index(&self, start: usize, kind: DeclarationKind) -> Option<usize> {
        let mut at = start + 1;
        if kind == DeclarationKind::Variable
            && self.tokens.get(at).is_some_and(|token| self.text(token) == "<")
        {
            while self.tokens.get(at).is_some_and(|token| self.text(token) != ">") {
                at += 1;
            }
            at += 1;
        }
        self.tokens.get(at).filter(|token| token.kind == TokenKind::Word).map(|_| at)
    }

    fn signature(
        &self,
        kind: DeclarationKind,
        from: usize,
        to: usize,
    ) -> (Vec<Field>, Option<String>) {
        let (open, close) = match kind {
            DeclarationKind::Function => ("(", ")"),
            DeclarationKind::Struct => ("{", "}"),
            _ => return (Vec::new(), None),
        };
        let tokens = &self.tokens[from..to.max(from)];
        let Some(first) = tokens.iter().position(|token| self.text(token) == open) else {
            return (Vec::new(), None);
        };
        let mut depth = 0usize;
        let mut last = tokens.len();
        let mut fields = Vec::new();
        let mut field: Vec<&Token> = Vec::new();
        for (index, token) in tokens.iter().enumerate().skip(first) {
            let text = self.text(token);
            match text {
                "(" | "{" | "<" | "[" => depth += 1,
                ")" | "}" | ">" | "]" => depth = depth.saturating_sub(1),
                _ => {}
            }
            let is_end = depth == 0 && text == close;
            if is_end || (depth == 1 && text == ",") {
                fields.extend(self.field(&field));
                field.clear();
            } else if index > first {
                field.push(token);
            }
            if is_end {
                last = index;
                break;
            }
        }
        let result = tokens.get(last + 1..).unwrap_or_default();
        let result = match result {
            [dash, angle, rest @ ..] if self.text(dash) == "-" && self.text(angle) == ">" => Some(
                rest.iter().map(|token| self.text(token)).take_while(|text| *text != "{").collect(),
            ),
            _ => None,
        };
        (fields, if kind == DeclarationKind::Function { result } else { None })
    }

    /// Reads a field: `@attr(..) name : type`.
    fn field(&self, tokens: &[&Token]) -> Option<Field> {
        let doc = tokens
            .iter()
            .filter(|token| token.kind == TokenKind::Doc)
            .map(|token| doc_line(self.source, token))
            .collect();
        let tokens: Vec<_> = tokens.iter().filter(|token| token.kind != TokenKind::Doc).collect();
        let colon = tokens.iter().position(|token| self.text(token) == ":")?;
        let name = self.text(tokens.get(colon.checked_sub(1)?)?).to_owned();
        let ty = tokens[colon + 1..].iter().map(|token| self.text(token)).collect();
        Some(Field { name, ty, doc })
    }
}

fn declaration_kind(keyword: &str) -> Option<DeclarationKind> {
    Some(match keyword {
        "fn" => DeclarationKind::Function,
        "struct" => DeclarationKind::Struct,
        "const" | "override" => DeclarationKind::Constant,
        "alias" => DeclarationKind::Alias,
        "var" => DeclarationKind::Variable,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_found_with_docs_and_signatures() {
        let source = "//! Top.\nimport chiaro::types;\n/// A node.\n/// @param a \"A\"\nfn node(a: \
                      vec3f, t: texture_2d<f32>) -> array<f32, 3> \
                      { if (a.x > 0.0) { return b(a); } }\n\
            /* gone /* nested */ */ @group(0) @binding(1) var<uniform> look: Look;\nconst C: f32 = \
            1.0;\n\
            struct S {\n  /// First.\n  @size(16) x: f32,\n  y: vec2<f32>,\n}\nalias Color = \
            vec4f;";
        let scan = scan(source);
        assert_eq!(scan.doc, ["Top."]);
        assert_eq!(scan.imports[0].path, "chiaro::types");
        let names: Vec<_> = scan.declarations.iter().map(|d| (d.kind, d.name.as_str())).collect();
        use DeclarationKind::*;
        assert_eq!(
            names,
            [
                (Function, "node"),
                (Variable, "look"),
                (Constant, "C"),
                (Struct, "S"),
                (Alias, "Color")
            ]
        );
        let node = &scan.declarations[0];
        assert_eq!(node.doc, ["A node.", "@param a \"A\""]);
        assert_eq!(node.fields[1].ty, "texture_2d<f32>");
        assert_eq!(node.result.as_deref(), Some("array<f32,3>"));
        assert!(node.uses.contains(&"b".to_owned()));
        assert!(
            source[node.body.clone()].starts_with("fn node")
                && source[node.span.clone()].starts_with("/// A")
        );
        assert_eq!(scan.declarations[3].fields[0].doc, ["First."]);
        assert_eq!(scan.declarations[3].fields[1].ty, "vec2<f32>");
    }

    #[test]
    fn identifiers_are_renamed_but_members_are_not() {
        let renamed = |name: &str| (name == "tint").then(|| "tint_2".to_owned());
        let text = "fn tint(x: f32) -> f32 { /* tint */ return tint(a.tint) + tinted; }";
        let expected = "fn tint_2(x: f32) -> f32 { /* tint */ return tint_2(a.tint) + tinted; }";
        assert_eq!(rename_identifiers(text, renamed), expected);
    }

    #[test]
    fn broken_text_never_panics() {
        let source = "fn f(a: vec3f) -> f32 { return g(a, 1.0e-3); } struct S { x: f32 } /* λ */ \
                      var<private> p: S;";
        for end in (0..=source.len()).filter(|&end| source.is_char_boundary(end)) {
            scan(&source[..end]);
            scan(&source[end..]);
        }
    }
}
