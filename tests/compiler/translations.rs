//! Translations: `src/locale/chiaro.pot` lists every text of the window, of the nodes and of the
//! examples, and every catalog beside it has all of them.
//!
//! `CHIARO_BLESS=1` writes the list anew, and the catalogs with what they have already: what is new
//! in them is empty, and this test fails until it is translated.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::{env, fs};

use chiaro_compiler::catalog::values::{context_words, words};
use chiaro_compiler::document::LightKind;
use chiaro_compiler::examples;
use chiaro_compiler::library::{Context, Fallback, Library};
use polib::catalog::Catalog;
use polib::message::{Message, MessageView};
use polib::metadata::CatalogMetadata;
use polib::po_file;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::support::{files, root};

/// Context and English text of a message.
type Key = (String, String);

/// Message as translators are to see it.
#[derive(Default)]
struct ListedMessage {
    /// Text for other numbers than one, of a text that counts.
    many: Option<String>,
    /// Files that the text stands in, from the root.
    sources: BTreeSet<String>,
}

/// Texts of the source, the nodes and the examples.
#[derive(Default)]
struct Texts(BTreeMap<Key, ListedMessage>);

impl Texts {
    fn all() -> Self {
        let mut texts = Self::default();
        for path in files::below(&root().join("src")) {
            let name = path.strip_prefix(root()).expect("it was found there");
            let is_rust = path.extension().is_some_and(|kind| kind == "rs");
            if !is_rust || name.starts_with("src/locale") || name.components().count() < 3 {
                continue;
            }
            let source = fs::read_to_string(&path).expect("a source reads");
            if ["tr!(", "trn!(", "text!(", "described! {"].iter().any(|call| source.contains(call))
            {
                let tokens = source.parse().expect("a source has tokens");
                texts.of_tokens(tokens, &name.to_string_lossy());
            }
        }
        texts.of_nodes();
        texts.of_tables();
        texts.of_parts();
        texts.of_examples();
        texts
    }

    fn add(&mut self, context: &str, text: &str, source: &str) -> &mut ListedMessage {
        let listed = self.0.entry((context.to_owned(), text.to_owned())).or_default();
        listed.sources.insert(source.to_owned());
        listed
    }

    /// Adds a text unless it is empty.
    fn say(&mut self, context: &str, text: &str, source: &str) {
        if !text.trim().is_empty() {
            self.add(context, text, source);
        }
    }

    /// Adds the texts of all calls of the macros, however deep they stand.
    fn of_tokens(&mut self, tokens: TokenStream, source: &str) {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        for (at, tree) in trees.iter().enumerate() {
            let TokenTree::Group(group) = tree else { continue };
            let called = match trees[..at] {
                [.., TokenTree::Ident(ref name), TokenTree::Punct(ref mark)]
                    if mark.as_char() == '!' && group.delimiter() != Delimiter::Bracket =>
                {
                    name.to_string()
                }
                _ => String::new(),
            };
            if called == "described" {
                self.of_described(group.stream(), source);
            }
            if ["tr", "trn", "text"].contains(&called.as_str()) {
                self.of_call(&called, &group.stream(), source);
            }
            self.of_tokens(group.stream(), source);
        }
    }

    fn of_call(&mut self, called: &str, arguments: &TokenStream, source: &str) {
        let literals: Vec<String> = arguments
            .clone()
            .into_iter()
            .filter_map(|tree| match tree {
                TokenTree::Literal(literal) => {
                    syn::parse_str::<syn::LitStr>(&literal.to_string()).ok()
                }
                _ => None,
            })
            .map(|literal| literal.value())
            .collect();
        let has_context = arguments.to_string().split_once("=>").is_some_and(|(before, _)| {
            before.trim_start().starts_with('"') && before.matches('"').count() == 2
        });
        match (called, literals.as_slice()) {
            ("trn", [one, many, ..]) => {
                self.add("", one, source).many = Some(many.clone());
            }
            ("tr" | "text", [context, text, ..]) if has_context => self.say(context, text, source),
            ("tr" | "text", [text, ..]) => self.say("", text, source),
            _ => panic!("{source}: {called}!({arguments}) has no text of its own"),
        }
    }

    fn of_nodes(&mut self) {
        let library = Library::built_in();
        for node in library.nodes.values() {
            let source = format!("nodes/{}", node.file.trim_start_matches("nodes/"));
            for text in [&node.label, &node.help, &node.category] {
                self.say("node", text, &source);
            }
            for input in node.visible_inputs() {
                self.say("node", &input.label, &source);
                self.say("node", &input.help, &source);
                for (_, label) in &input.options {
                    self.say("choice", label, &source);
                }
                if let Fallback::Same(other) = &input.fallback {
                    self.say("node", &words(other.as_str()), &source);
                }
            }
            for output in &node.outputs {
                self.say("node", &output.label, &source);
                self.say("node", &output.help, &source);
            }
            for error in &node.errors {
                self.say("node", &error.help, &source);
            }
            for bypass in &node.bypasses {
                self.say("node", &bypass.reason, &source);
            }
            for preset in &node.presets {
                self.say("node", &preset.label, &source);
            }
        }
        for group in library.groups.values() {
            let source = format!("nodes/{}", group.file.trim_start_matches("nodes/"));
            self.say("node", &group.definition.label, &source);
            self.say("node", &group.definition.help, &source);
            let ports = group.ports(library);
            for input in &ports.inputs {
                self.say("node", &input.label, &source);
                self.say("node", &input.help, &source);
            }
            for output in &ports.outputs {
                self.say("node", &output.label, &source);
                self.say("node", &output.help, &source);
            }
        }
    }

    /// Adds words that tables of the compiler hold.
    fn of_tables(&mut self) {
        for kind in LightKind::ALL {
            self.say("choice", kind.help(), "src/compiler/document/light/mod.rs");
        }
        for context in Context::all() {
            let words = context_words(context);
            self.say("context", &words, "src/compiler/library/context/row.rs");
        }
    }

    /// Adds names, descriptions and tags of the parts that Chiaro ships.
    fn of_parts(&mut self) {
        const FOLDER: &str = "src/editor/state/parts/shipped";
        for path in files::below(&root().join(FOLDER)) {
            let source = path.strip_prefix(root()).expect("it was found there").to_string_lossy();
            let text = fs::read_to_string(&path).expect("a part reads");
            let part: serde_json::Value = serde_json::from_str(&text).expect("JSON");
            for member in ["name", "about", "tags"] {
                self.say("example", part[member].as_str().unwrap_or_default(), &source);
            }
        }
    }

    fn of_examples(&mut self) {
        for subject in examples::subjects() {
            self.say("example", subject.title, "examples/order.txt");
            self.say("example", subject.about, "examples/order.txt");
            for (name, tags) in subject.examples {
                self.say("example", tags, &format!("examples/{name}"));
            }
        }
        for name in examples::documents() {
            let path = format!("{}{name}", examples::PREFIX);
            let text = examples::text(Path::new(&path)).expect("an example has a text");
            let document: serde_json::Value = serde_json::from_str(&text).expect("JSON");
            for member in ["name", "about"] {
                let text = document[member].as_str().unwrap_or_default();
                self.say("example", text, &format!("examples/{name}"));
            }
        }
    }

    /// Adds the names of the parts of documents that a source describes, alone and with an article.
    fn of_described(&mut self, description: TokenStream, source: &str) {
        let mut trees = description.into_iter();
        while let Some(tree) = trees.next() {
            if !matches!(&tree, TokenTree::Ident(word) if *word == "struct") {
                continue;
            }
            let Some(TokenTree::Group(head)) = trees.nth(1) else { continue };
            let name = head.stream().into_iter().next().map(|tree| tree.to_string());
            let name = name.unwrap_or_default().trim_matches('"').to_owned();
            // The reader names it by its capitals.
            if name == "hcbtf" {
                continue;
            }
            let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
            self.say("part", &name, source);
            self.say("part", &format!("{article} {name}"), source);
        }
    }

    /// Catalog of these texts with what `known` has for them, ordered by their files.
    fn catalog(&self, metadata: CatalogMetadata, known: &Catalog) -> Catalog {
        let mut catalog = Catalog::new(metadata);
        let mut ordered: Vec<(&Key, &ListedMessage)> = self.0.iter().collect();
        ordered.sort_by_key(|((context, text), listed)| (listed.sources.first(), context, text));
        for ((context, text), ListedMessage { many, sources }) in ordered {
            let context_or_none = (!context.is_empty()).then_some(context.as_str());
            let old = known.find_message(context_or_none, text, many.as_deref());
            let mut message =
                if many.is_some() { Message::build_plural() } else { Message::build_singular() };
            if let Some(context) = context_or_none {
                message.with_msgctxt(context.to_owned());
            }
            let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
            message.with_msgid(text.clone()).with_source(sources.join("\n"));
            if text.contains('{') {
                message.with_flags("rust-format".parse().expect("a flag"));
            }
            match many {
                Some(many) => {
                    message.with_msgid_plural(many.clone());
                    let count = catalog.metadata.plural_rules.nplurals;
                    let old = old.and_then(|old| old.msgstr_plural().ok());
                    let forms = old.cloned().unwrap_or_else(|| vec![String::new(); count]);
                    message.with_msgstr_plural(forms);
                }
                None => {
                    let old = old.and_then(|old| old.msgstr().ok());
                    message.with_msgstr(old.unwrap_or_default().to_owned());
                }
            }
            catalog.append_or_update(message.done());
        }
        catalog
    }
}

/// Text of a catalog in gettext's PO format.
fn written(catalog: &Catalog) -> String {
    let mut text = std::io::BufWriter::new(Vec::new());
    po_file::write(catalog, &mut text).expect("a catalog is written into memory");
    String::from_utf8(text.into_inner().expect("memory takes it")).expect("texts are UTF-8")
}

fn read(path: &Path) -> Catalog {
    let text = fs::read_to_string(path).unwrap_or_default();
    let catalog = po_file::parse_from_reader(text.as_bytes());
    catalog.unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Header of the list.
const HEADER: &str = "Project-Id-Version: Chiaro
MIME-Version: 1.0
Content-Type: text/plain; charset=UTF-8
Content-Transfer-Encoding: 8bit
Plural-Forms: nplurals=2; plural=(n != 1);";

/// Places of values in a text, sorted; other braces are the text's own.
fn values(text: &str) -> Vec<&str> {
    let is_name = |field: &&str| {
        let name = field.split(':').next().unwrap_or_default();
        !name.is_empty() && name.chars().all(|letter| letter.is_alphanumeric() || letter == '_')
    };
    let fields = text.split('{').skip(1).filter_map(|rest| Some(rest.split_once('}')?.0));
    let mut values: Vec<&str> = fields.filter(is_name).collect();
    values.sort_unstable();
    values
}

/// Faults of a message, for people.
fn faults(message: &dyn MessageView, count: usize) -> Vec<String> {
    let id = message.msgid();
    if !message.is_translated() {
        return vec![format!("not translated: {id:?}")];
    }
    let forms: Vec<&str> = match message.msgstr_plural() {
        Ok(forms) if message.is_plural() => forms.iter().map(String::as_str).collect(),
        _ => message.msgstr().into_iter().collect(),
    };
    let mut faults = Vec::new();
    if message.is_fuzzy() {
        faults.push(format!("in doubt: {id:?}"));
    }
    if message.is_plural() && forms.len() != count {
        faults.push(format!("{} forms for {count} numbers: {id:?}", forms.len()));
    }
    for form in forms {
        // A number may be a word in the form for one.
        let is_singular =
            message.is_plural() && message.msgid_plural().is_ok_and(|many| many != id);
        let same = values(form) == values(id)
            || is_singular && message.msgid_plural().is_ok_and(|many| values(form) == values(many));
        if !same {
            faults.push(format!("other values in {form:?} than in {id:?}"));
        }
        for end in [" ", "\n"] {
            if form.ends_with(end) != id.ends_with(end) && !message.is_plural() {
                faults.push(format!("ends otherwise: {form:?} for {id:?}"));
            }
        }
    }
    faults
}

#[test]
fn every_text_is_listed_and_translated() {
    let texts = Texts::all();
    let folder = root().join("src/locale");
    let is_blessing = env::var_os("CHIARO_BLESS").is_some();
    let header = CatalogMetadata::parse(HEADER).expect("a header of gettext");
    let template = texts.catalog(header, &Catalog::new(CatalogMetadata::new()));
    let template = written(&template);
    let path = folder.join("chiaro.pot");
    if is_blessing {
        fs::write(&path, &template).expect("the list is written");
    }
    let listed = fs::read_to_string(&path).unwrap_or_default();
    assert!(listed == template, "src/locale/chiaro.pot is not what the source has; bless it");

    let mut wrong = Vec::new();
    let catalogs = files::below(&folder).into_iter();
    for path in catalogs.filter(|path| path.extension().is_some_and(|kind| kind == "po")) {
        let known = read(&path);
        let ordered = texts.catalog(known.metadata.clone(), &known);
        if is_blessing {
            fs::write(&path, written(&ordered)).expect("a catalog is written");
        }
        let text = fs::read_to_string(&path).expect("a catalog reads");
        if text != written(&ordered) {
            let name = path.display();
            wrong.push(format!("{name} has other texts than the source; bless it"));
        }
        let count = known.metadata.plural_rules.nplurals;
        for message in read(&path).messages() {
            wrong.extend(faults(message, count));
        }
    }
    let first: Vec<&String> = wrong.iter().take(40).collect();
    assert!(wrong.is_empty(), "{} faults of translations, first {first:#?}", wrong.len());
}

#[test]
fn texts_are_found_in_macros_at_any_depth() {
    let mut texts = Texts::default();
    let source = r##"
        /// tr!("in a comment")
        fn f() { vec![ui.label(tr!("two \
            lines {x:.1}", x = g(tr!("inner"))))]; trn!(n = a(), "{n} one", "{n} many");
            tr!("mode" => "Normal"); other!("no"); const A: Text = text!("row"); }
    "##;
    texts.of_tokens(source.parse().expect("tokens"), "f.rs");
    let found: Vec<(&str, &str)> =
        texts.0.keys().map(|(context, text)| (context.as_str(), text.as_str())).collect();
    let expected =
        [("", "inner"), ("", "row"), ("", "two lines {x:.1}"), ("", "{n} one"), ("mode", "Normal")];
    assert_eq!(found, expected);
    let counted = &texts.0[&(String::new(), "{n} one".to_owned())];
    assert_eq!(counted.many.as_deref(), Some("{n} many"));
}
