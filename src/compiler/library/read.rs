//! Reader of a node file into a [`NodeDef`].

use std::sync::Arc;

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::Context;
use super::docs::{self, Docs, Tag, TagPiece};
use super::module::{NodeModule, refused};
use super::node::{
    ArgumentSource, Bypass, BypassResult, Condition, Fallback, Input, LightFeed, Limit, NodeDef,
    NodeFunction, Output, PrepareFunction, Preset, ShareBound, Test, TierError, Treatment,
};
use super::rules::with_forms;
use super::types::Type;
use crate::diag::{Diagnostic, LineColumn};
use crate::document::{Curve, Interpolation, Ramp, RampStop, Tier, Value};
use crate::ids::PortName;
use crate::wgsl::{
    self, Declaration, DeclarationKind, LinkedSource, NamedSource, Scan, ValidModule,
};

pub(super) fn stem_and_folder(path: &str) -> (String, String) {
    let path = path.replace('\\', "/");
    let mut parts = path.rsplit('/');
    let file = parts.next().unwrap_or_default();
    let stem = file.split('.').next().unwrap_or_default().to_owned();
    let folder = parts.next().filter(|folder| *folder != "nodes").unwrap_or("project").to_owned();
    (stem, folder)
}

/// Links a source, and validates all of it, with the forms of its rules.
fn validated(
    source: NamedSource<'_>,
) -> Result<(LinkedSource, String, ValidModule), Vec<Diagnostic>> {
    let linked = wgsl::link(&[source])?;
    let text = with_forms(&linked)?;
    match wgsl::parse(&text) {
        Ok(valid) => Ok((linked, text, valid)),
        Err(error) => Err(vec![refused(&linked, "invalid-wgsl", &error)]),
    }
}

/// Reads one node file. `kind` names a custom node, whose first function may have any name;
/// otherwise the kind is the file's stem.
///
/// # Errors
/// All errors in the file, with line and column. Those of a custom node's code are given in the
/// message, since the code is no file: the place is the node's, in the look.
pub fn load_node(file: &str, text: &str, kind: Option<&str>) -> Result<NodeDef, Vec<Diagnostic>> {
    let source = NamedSource { name: file, text };
    let node = load_own_module(&source).and_then(|(module, notes)| {
        let node = read_node(&source, &wgsl::scan(text), &Arc::new(module), kind)?;
        Ok(NodeDef { notes, ..node })
    });
    let in_code = |mut problems: Vec<Diagnostic>| {
        let of_code = |problem: &&mut Diagnostic| {
            kind.is_some() && problem.place.file.as_deref() == Some(file)
        };
        problems.iter_mut().filter(of_code).for_each(tell_place_in_code);
        problems
    };
    match node {
        Ok(mut node) => {
            node.notes = in_code(node.notes);
            Ok(node)
        }
        Err(problems) => Err(in_code(problems)),
    }
}

/// Module of code that a person wrote: within bounds before naga sees it, without anything that a
/// look cannot run, and with an end to every loop; and remarks on its loops.
fn load_own_module(
    source: &NamedSource<'_>,
) -> Result<(NodeModule, Vec<Diagnostic>), Vec<Diagnostic>> {
    let in_source = |code: &'static str, error: &wgsl::WgslError| {
        let problem = Diagnostic::error(code, error.message.clone()).in_file(source.name);
        let start = error.span.as_ref().map(|span| span.start);
        start.map_or(problem.clone(), |start| problem.at(LineColumn::of(source.text, start)))
    };
    let beyond = wgsl::beyond_bounds(source.text);
    if !beyond.is_empty() {
        return Err(beyond.iter().map(|error| in_source("code-bound", error)).collect());
    }
    let (linked, text, valid) = validated(*source)?;
    let refusals = wgsl::refusals(&valid, &linked.last_source());
    if !refusals.is_empty() {
        let refused = |error| refused(&linked, "code-not-allowed", error);
        return Err(refusals.iter().map(refused).collect());
    }
    let loops = wgsl::bound_loops(source.text);
    if !loops.beyond.is_empty() {
        return Err(loops.beyond.iter().map(|error| in_source("code-bound", error)).collect());
    }
    if loops.counted.is_empty() {
        return Ok((NodeModule::of_valid(linked, text, valid), Vec::new()));
    }
    let notes = loops.counted.iter().map(|found| counted_loop(source, found)).collect();
    let (linked, text, valid) = validated(NamedSource { text: &loops.text, ..*source })?;
    Ok((NodeModule::of_valid(linked, text, valid), notes))
}

fn counted_loop(source: &NamedSource<'_>, found: &wgsl::CountedLoop) -> Diagnostic {
    let most = wgsl::MAX_ROUNDS;
    let message = match found.rounds {
        Some(rounds) => tr!("this loop would take {rounds} rounds, and ends after {most}"),
        None => {
            tr!("the end of this loop cannot be seen: it ends after {most} rounds at the latest")
        }
    };
    Diagnostic::note("counted-loop", message)
        .in_file(source.name)
        .at(LineColumn::of(source.text, found.span.start))
        .hint(tr!(
            "a `for` that counts whole numbers is left as it is: `for (var i = 0; i < 64; i++)`"
        ))
}

fn tell_place_in_code(problem: &mut Diagnostic) {
    problem.place.file = None;
    if let Some(LineColumn { line, column }) = problem.place.at.take() {
        problem.message =
            tr!("line {line}, column {column} of the code: {message}", message = problem.message);
    }
}

/// Reads a node from the scan of its file.
pub(super) fn read_node(
    source: &NamedSource<'_>,
    scan: &Scan,
    module: &Arc<NodeModule>,
    custom: Option<&str>,
) -> Result<NodeDef, Vec<Diagnostic>> {
    let (stem, category) = stem_and_folder(source.name);
    let mut reader = Reader { source, scan, problems: Vec::new() };
    let node = reader.node(custom, &stem, category, module);
    match node {
        Some(node) if reader.problems.is_empty() => Ok(node),
        _ => Err(reader.problems),
    }
}

struct Reader<'a> {
    source: &'a NamedSource<'a>,
    scan: &'a Scan,
    problems: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn problem(&mut self, at: &Declaration, message: impl Into<String>) -> &mut Diagnostic {
        let place = LineColumn::of(self.source.text, at.body.start);
        let problem =
            Diagnostic::error("bad-node-file", message).in_file(self.source.name).at(place);
        self.problems.push(problem);
        self.problems.last_mut().expect("just pushed")
    }

    fn node(
        &mut self,
        custom: Option<&str>,
        stem: &str,
        category: String,
        module: &Arc<NodeModule>,
    ) -> Option<NodeDef> {
        let scan = self.scan;
        let functions = || scan.declarations.iter().filter(|d| d.kind == DeclarationKind::Function);
        let stem = match custom {
            Some(_) => {
                functions().find(|d| !d.name.ends_with("_prepare")).map_or("", |d| d.name.as_str())
            }
            None => stem,
        };
        let own: Vec<_> = functions().filter(|d| suffix_of(&d.name, stem).is_some()).collect();
        let Some(head) = own.iter().find(|d| suffix_of(&d.name, stem) != Some("prepare")).copied()
        else {
            self.problems.push(
                Diagnostic::error(
                    "bad-node-file",
                    tr!("there is no function `{stem}` in this file"),
                )
                .in_file(self.source.name)
                .hint(tr!(
                    "a node file holds a function with the file's name: `fn {stem}(...) -> f32`"
                )),
            );
            return None;
        };
        let docs = docs::parse(&head.doc);
        let mut node = NodeDef {
            kind: custom.unwrap_or(stem).to_owned(),
            label: if docs.label.is_empty() { stem.replace('_', " ") } else { docs.label.clone() },
            category,
            help: docs.help.clone(),
            sources: docs.tags.iter().filter(|tag| tag.word == "source").map(source_text).collect(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            variants: Vec::new(),
            prepare: None,
            bypasses: Vec::new(),
            bounds: Vec::new(),
            unit_when: None,
            has_unit_alpha: false,
            keeps_opaque: false,
            errors: Vec::new(),
            presets: Vec::new(),
            notes: Vec::new(),
            special: match (custom, stem) {
                (None, "output") => Treatment::Output,
                (None, "light" | "light_details") => Treatment::Light,
                (None, "reroute") => Treatment::Reroute,
                (None, _) if suffix_of(&head.name, stem) == Some("directional") => {
                    Treatment::OfLight
                }
                _ => Treatment::None,
            },
            module: module.clone(),
            file: self.source.name.to_owned(),
        };
        self.inputs(&mut node, &docs, head, &own, stem);
        self.prepare(&mut node, &own, stem);
        self.variants(&mut node, &own, stem);
        self.outputs(&mut node, &docs, head);
        self.feeds(&node, head);
        self.rules(&mut node, &docs, head);
        Some(node)
    }

    /// Reads the inputs: documented ones in the order of the docs, then all others that the
    /// functions take.
    fn inputs(
        &mut self,
        node: &mut NodeDef,
        docs: &Docs,
        head: &Declaration,
        own: &[&Declaration],
        stem: &str,
    ) {
        let prepared = own
            .iter()
            .find(|d| suffix_of(&d.name, stem) == Some("prepare"))
            .and_then(|d| d.result.clone());
        let mut types: IndexMap<&str, Type> = IndexMap::new();
        for field in own.iter().flat_map(|d| &d.fields) {
            if Some(&field.ty) != prepared.as_ref() && field.ty != "sampler" {
                types.entry(&field.name).or_insert_with(|| Type::from_wgsl(&field.ty));
            }
        }
        for tag in &docs.tags {
            let Some(TagPiece::Word(name)) = tag.pieces.first() else { continue };
            match tag.word.as_str() {
                "choice" => {
                    types.shift_remove(name.as_str());
                    let input = self.choice(name, tag, head);
                    node.inputs.push(input);
                }
                "param" => {
                    let ty = match types.shift_remove(name.as_str()) {
                        Some(ty) => ty,
                        None if has_word(tag, "light_name") => Type::LightName,
                        None if has_word(tag, "text") => Type::Text,
                        None => {
                            self.problem(
                                head,
                                tr!("`@param {name}` documents a parameter that no function has"),
                            );
                            continue;
                        }
                    };
                    let input = self.documented_input(name, ty, tag, head);
                    node.inputs.push(input);
                }
                _ => {}
            }
        }
        for (name, ty) in types {
            let fallback = neutral(&ty).map_or(Fallback::Wire, Fallback::Value);
            node.inputs.push(plain_input(name, ty, fallback));
        }
        for index in 0..node.inputs.len() {
            if let Fallback::Same(other) = &node.inputs[index].fallback {
                let (other, own) = (other.clone(), node.inputs[index].name.clone());
                // The other input must have a value of its own, so that no ring of inputs can form.
                let has_own = |input: &Input| !matches!(input.fallback, Fallback::Same(_));
                if node.input(other.as_str()).is_none_or(|other| !has_own(&node.inputs[other])) {
                    let message = tr!(
                        "`@param {own}` is the same as `{other}`, which is no input with a value \
                         of its own"
                    );
                    self.problem(head, message);
                }
            }
            if let Type::Prepared(name) = &node.inputs[index].ty {
                let (name, input) = (name.clone(), node.inputs[index].name.clone());
                self.problem(
                    head,
                    tr!("the parameter `{input}` has type `{name}`, which no wire carries"),
                );
            }
        }
    }

    fn choice(&mut self, name: &str, tag: &Tag, head: &Declaration) -> Input {
        let mut input = plain_input(name, Type::Choice, Fallback::Wire);
        input.help = tag.help.clone();
        let mut default = None;
        for piece in &tag.pieces[1..] {
            match piece {
                TagPiece::Quoted(label) => input.label = label.clone(),
                TagPiece::Pair(key, value) if key == "default" => default = Some(value.clone()),
                TagPiece::Pair(word, label) => input.options.push((word.clone(), label.clone())),
                TagPiece::Word(word) => input.options.push((word.clone(), word.replace('_', " "))),
            }
        }
        let default = default
            .or_else(|| input.options.first().map(|option| option.0.clone()))
            .unwrap_or_default();
        if !input.options.iter().any(|option| option.0 == default) {
            self.problem(head, tr!("`@choice {name}` has no option `{default}` for its default"));
        }
        input.fallback = Fallback::Value(Value::Text(default));
        input
    }

    fn documented_input(&mut self, name: &str, ty: Type, tag: &Tag, head: &Declaration) -> Input {
        let fallback = neutral(&ty).map_or(Fallback::Wire, Fallback::Value);
        let mut input = plain_input(name, ty, fallback);
        input.help = tag.help.clone();
        for piece in &tag.pieces[1..] {
            let ok = match piece {
                TagPiece::Quoted(label) => {
                    input.label = label.clone();
                    true
                }
                TagPiece::Word(word) => match word.as_str() {
                    "wire" => {
                        input.fallback = Fallback::Wire;
                        true
                    }
                    "hidden" => {
                        input.hidden = true;
                        true
                    }
                    "reach" | "index" | "count" | "number" => {
                        input.hidden = true;
                        input.light_feed = Some(match word.as_str() {
                            "reach" => LightFeed::Reach,
                            "index" => LightFeed::Index,
                            "number" => LightFeed::Number,
                            _ => LightFeed::Count,
                        });
                        true
                    }
                    "light_name" | "text" => true,
                    _ => false,
                },
                TagPiece::Pair(key, value) => set_attribute(&mut input, key, value),
            };
            if !ok {
                self.problem(
                    head,
                    tr!("`@param {name}` has a piece that means nothing: `{piece}`"),
                );
            }
        }
        input
    }

    fn prepare(&mut self, node: &mut NodeDef, own: &[&Declaration], stem: &str) {
        let Some(function) = own.iter().find(|d| suffix_of(&d.name, stem) == Some("prepare"))
        else {
            return;
        };
        let mut parameters = Vec::new();
        for field in &function.fields {
            match node.input(&field.name) {
                Some(index) => parameters.push((index, Type::from_wgsl(&field.ty))),
                None => {
                    self.problem(
                        function,
                        tr!("`{name}` is not an input of the node", name = field.name),
                    );
                }
            }
        }
        let result = function.result.clone().unwrap_or_default();
        node.prepare = Some(PrepareFunction {
            function: function.name.clone(),
            parameters,
            result: Type::from_wgsl(&result),
        });
    }

    fn variants(&mut self, node: &mut NodeDef, own: &[&Declaration], stem: &str) {
        for function in own {
            let suffix = suffix_of(&function.name, stem).unwrap_or_default();
            if suffix == "prepare" {
                continue;
            }
            let Some((choice, width, tier)) = self.meaning(node, suffix, function) else {
                continue;
            };
            let parameters = self.parameters(node, function);
            let Some(result) = function.result.clone() else {
                self.problem(function, tr!("a node's function must return something").to_owned());
                continue;
            };
            let is_struct =
                |d: &&Declaration| d.kind == DeclarationKind::Struct && d.name == result;
            let result_is_struct = self.scan.declarations.iter().any(|d| is_struct(&d));
            let result = Type::from_wgsl(&result);
            let function = function.name.clone();
            node.variants.push(NodeFunction {
                function,
                choice,
                width,
                tier,
                parameters,
                result,
                result_is_struct,
            });
        }
    }

    /// Meaning of a function name's words after the kind: choice, width and tier.
    #[expect(
        clippy::type_complexity,
        reason = "three answers to one question, taken apart at once"
    )]
    fn meaning(
        &mut self,
        node: &NodeDef,
        suffix: &str,
        function: &Declaration,
    ) -> Option<(Option<(usize, String)>, Option<Type>, Tier)> {
        let mut rest = suffix;
        let mut choice = None;
        let mut width = None;
        let mut tier = Tier::Exact;
        if node.has_light_types() || (node.special == Treatment::Output && !suffix.is_empty()) {
            // A light's type and the Output's second function are no choices that a document makes.
            return Some((Some((usize::MAX, suffix.to_owned())), None, tier));
        }
        while !rest.is_empty() {
            let options = node
                .inputs
                .iter()
                .enumerate()
                .flat_map(|(i, input)| input.options.iter().map(move |o| (i, o)));
            let matching = options.filter(|(_, option)| begins_with_word(rest, &option.0));
            if let (None, Some((input, option))) =
                (&choice, matching.max_by_key(|(_, option)| option.0.len()))
            {
                choice = Some((input, option.0.clone()));
                rest = rest[option.0.len()..].trim_start_matches('_');
                continue;
            }
            let (word, after) = rest.split_once('_').unwrap_or((rest, ""));
            match word {
                "vec2" => width = Some(Type::Vec2),
                "vec3" => width = Some(Type::Vec3),
                "vec4" => width = Some(Type::Vec4),
                "color" => width = Some(Type::Color),
                "balanced" => tier = Tier::Balanced,
                "fast" => tier = Tier::Fast,
                _ => {
                    self.problem(
                        function,
                        tr!(
                            "`{word}` in `{name}` is no choice, width or tier",
                            name = function.name
                        ),
                    )
                    .hints
                    .push(
                        tr!("name helper functions so that they do not begin with the node's kind")
                            .to_owned(),
                    );
                    return None;
                }
            }
            rest = after;
        }
        Some((choice, width, tier))
    }

    fn parameters(&mut self, node: &NodeDef, function: &Declaration) -> Vec<ArgumentSource> {
        let prepared = node.prepare.as_ref().map(|prepare| prepare.result.wgsl().to_owned());
        let mut parameters = Vec::new();
        let mut image = None;
        for field in &function.fields {
            if Some(&field.ty) == prepared.as_ref() {
                parameters.push(ArgumentSource::Prepared);
            } else if field.ty == "sampler" {
                match image {
                    Some(image) => parameters.push(ArgumentSource::Sampler(image)),
                    None => {
                        self.problem(
                            function,
                            tr!("a sampler must follow the image that it samples").to_owned(),
                        );
                    }
                }
            } else if let Some(index) = node.input(&field.name) {
                let ty = Type::from_wgsl(&field.ty);
                if node.inputs[index].ty == Type::Choice {
                    if ty != Type::Int {
                        let message = tr!("the choice `{name}` is an `i32`", name = field.name);
                        self.problem(function, message);
                    }
                    parameters.push(ArgumentSource::Choice(index));
                    continue;
                }
                if ty.is_texture() {
                    image = Some(index);
                }
                parameters.push(ArgumentSource::Input(index, ty));
            }
        }
        parameters
    }

    fn outputs(&mut self, node: &mut NodeDef, docs: &Docs, head: &Declaration) {
        let Some(variant) = node.variants.first() else { return };
        if variant.result_is_struct {
            let name = variant.result.wgsl().to_owned();
            let members = self
                .scan
                .declarations
                .iter()
                .find(|d| d.name == name)
                .map_or(&[][..], |d| &d.fields);
            for member in members {
                node.outputs.push(Output {
                    name: PortName::new(member.name.as_str()),
                    label: sentence(&member.name),
                    help: member.doc.join(" "),
                    ty: Type::from_wgsl(&member.ty),
                });
            }
        } else {
            let tag = docs.tags.iter().find(|tag| tag.word == "return");
            let name = match tag.and_then(|tag| tag.pieces.first()) {
                Some(TagPiece::Word(name)) => name.clone(),
                _ => "value".to_owned(),
            };
            let label = tag
                .and_then(|tag| tag.pieces.iter().find_map(quoted))
                .unwrap_or_else(|| sentence(&name));
            let help = tag.map(|tag| tag.help.clone()).unwrap_or_default();
            node.outputs.push(Output {
                name: PortName::new(name),
                label,
                help,
                ty: variant.result.clone(),
            });
        }
        for output in &node.outputs {
            if matches!(output.ty, Type::Prepared(_)) || output.ty.is_setting() {
                let message =
                    tr!("the output `{name}` has a type that no wire carries", name = output.name);
                self.problem(head, message);
            }
        }
    }

    /// A node that joins lights takes every output of its own again, so that a light that does not
    /// arrive leaves all of them as they are.
    fn feeds(&mut self, node: &NodeDef, head: &Declaration) {
        if !node.joins_lights() {
            return;
        }
        let is_fed = |output: &Output| {
            node.inputs.iter().any(|input| {
                let feed = LightFeed::Before(output.name.clone());
                input.light_feed == Some(feed) && input.ty == output.ty
            })
        };
        for output in node.outputs.iter().filter(|output| !is_fed(output)) {
            let message = tr!(
                "the node joins lights, and no input of the type {ty} is `before={name}`",
                ty = output.ty,
                name = output.name
            );
            self.problem(head, message);
        }
    }

    fn rules(&mut self, node: &mut NodeDef, docs: &Docs, head: &Declaration) {
        for tag in &docs.tags {
            match tag.word.as_str() {
                "preset" => match preset(node, tag) {
                    Some(preset) => node.presets.push(preset),
                    None => {
                        self.problem(
                            head,
                            tr!("a `@preset` names an input that there is not, or no number")
                                .to_owned(),
                        );
                    }
                },
                "bypass" => match bypass(node, tag) {
                    Some(bypass) => node.bypasses.push(bypass),
                    None => {
                        self.problem(
                            head,
                            tr!("a `@bypass` is not of the form `input when other = value`")
                                .to_owned(),
                        );
                    }
                },
                "bound" => match bound(node, tag) {
                    Some(bound) => node.bounds.push(bound),
                    None => {
                        let form = tr!(
                            "`input` or `input when choice = word`, with a float or color input"
                        );
                        self.problem(head, tr!("a `@bound` is not of the form {form}"));
                    }
                },
                "unit" if words(tag) == ["alpha"] => node.has_unit_alpha = true,
                "opaque" => node.keeps_opaque = true,
                "unit" => {
                    node.unit_when = unit_conditions(node, tag);
                    if node.unit_when.is_none() {
                        self.problem(
                            head,
                            tr!("a `@unit` is not of the form `when input = value` or `alpha`")
                                .to_owned(),
                        );
                    }
                }
                "error" => {
                    match tier_error(tag).filter(|error| node.tiers().contains(&error.tier)) {
                        Some(error) => node.errors.push(error),
                        None => {
                            self.problem(
                                head,
                                tr!("an `@error` is not of the form `tier number`, with \
                                                a tier of the node"),
                            );
                        }
                    }
                }
                "param" | "choice" | "return" | "source" => {}
                other => {
                    self.problem(head, tr!("`@{other}` means nothing here")).hints.push(
                        tr!("the tags are @param, @choice, @return, @preset, @bypass, @bound, \
                         @unit, @opaque, @error and @source")
                        .to_owned(),
                    );
                }
            }
        }
    }
}

/// Reads `@error`: `fast 1e-3 : of what`.
fn tier_error(tag: &Tag) -> Option<TierError> {
    let [TagPiece::Word(tier), TagPiece::Word(bound)] = tag.pieces.as_slice() else { return None };
    let tier = match tier.as_str() {
        "balanced" => Tier::Balanced,
        "fast" => Tier::Fast,
        _ => return None,
    };
    let bound = docs::number(bound).filter(|bound| *bound >= 0.0)?;
    Some(TierError { tier, bound, help: tag.help.clone() })
}

/// Part of `name` after `stem`; empty for the stem itself.
fn suffix_of<'n>(name: &'n str, stem: &str) -> Option<&'n str> {
    let rest = name.strip_prefix(stem)?;
    if rest.is_empty() { Some("") } else { rest.strip_prefix('_') }
}

fn begins_with_word(text: &str, word: &str) -> bool {
    text.strip_prefix(word).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
}

fn has_word(tag: &Tag, word: &str) -> bool {
    tag.pieces.iter().any(|piece| matches!(piece, TagPiece::Word(found) if found == word))
}

fn quoted(piece: &TagPiece) -> Option<String> {
    match piece {
        TagPiece::Quoted(text) => Some(text.clone()),
        _ => None,
    }
}

fn source_text(tag: &Tag) -> String {
    let piece_text = |piece: &TagPiece| match piece {
        TagPiece::Word(word) | TagPiece::Quoted(word) => word.clone(),
        TagPiece::Pair(key, value) => format!("{key}={value}"),
    };
    tag.pieces.iter().map(piece_text).collect::<Vec<_>>().join(" ")
}

/// Label made from a name: `half_distance` becomes `Half distance`.
fn sentence(name: &str) -> String {
    let spaced = name.replace('_', " ");
    let mut characters = spaced.chars();
    characters
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

/// Input of which only name, type and fallback are known.
pub(super) fn plain_input(name: &str, ty: Type, fallback: Fallback) -> Input {
    Input {
        name: PortName::new(name),
        label: sentence(name),
        help: String::new(),
        ty,
        fallback,
        min: None,
        max: None,
        unit: String::new(),
        widget: String::new(),
        options: Vec::new(),
        hidden: false,
        light_feed: None,
    }
}

/// Value of an input for which the file gives none.
fn neutral(ty: &Type) -> Option<Value> {
    Some(match ty {
        Type::Float | Type::Int => Value::Number(0.0),
        Type::Bool => Value::Bool(false),
        Type::Vec2 => Value::Vector(vec![0.0; 2]),
        Type::Vec3 => Value::Vector(vec![0.0; 3]),
        Type::Vec4 => Value::Vector(vec![0.0; 4]),
        Type::Color | Type::Composite => Value::Vector(vec![0.0, 0.0, 0.0, 1.0]),
        Type::Curve => Value::Curve(Curve {
            points: vec![[0.0, 0.0], [1.0, 1.0]],
            interpolation: Interpolation::Smooth,
        }),
        Type::Ramp => Value::Ramp(Ramp {
            stops: vec![
                RampStop { at: 0.0, color: vec![0.0, 0.0, 0.0, 1.0] },
                RampStop { at: 1.0, color: vec![1.0, 1.0, 1.0, 1.0] },
            ],
            interpolation: Interpolation::Linear,
        }),
        Type::Image | Type::Hcbtf | Type::LightName | Type::Text => Value::Text(String::new()),
        Type::Angle
        | Type::Light
        | Type::Mat3
        | Type::Casters
        | Type::ShadowMaps
        | Type::Choice
        | Type::Prepared(_) => return None,
    })
}

fn set_attribute(input: &mut Input, key: &str, value: &str) -> bool {
    match key {
        "default" => match value_of(&input.ty, value) {
            Some(value) => input.fallback = Fallback::Value(value),
            None => return false,
        },
        "from" => match Context::from_word(value) {
            Some(context) => input.fallback = Fallback::Context(context),
            None => return false,
        },
        "before" => {
            input.hidden = true;
            input.light_feed = Some(LightFeed::Before(value.into()));
        }
        "member" => {
            input.hidden = true;
            input.light_feed = Some(LightFeed::Member(value.into()));
        }
        "same" => input.fallback = Fallback::Same(value.into()),
        "min" | "max" => {
            let Some(number) = docs::number(value) else { return false };
            let bound = if key == "min" { &mut input.min } else { &mut input.max };
            *bound = Some(number);
        }
        "unit" => value.clone_into(&mut input.unit),
        "widget" => value.clone_into(&mut input.widget),
        _ => return false,
    }
    true
}

fn value_of(ty: &Type, text: &str) -> Option<Value> {
    Some(match ty {
        Type::Bool => Value::Bool(text.parse().ok()?),
        Type::Float | Type::Int => Value::Number(docs::number(text)?),
        Type::Choice | Type::Text | Type::LightName | Type::Image | Type::Hcbtf => {
            Value::Text(text.to_owned())
        }
        _ => {
            let numbers = docs::numbers(text)?;
            (Some(numbers.len()) == ty.width()).then_some(Value::Vector(numbers))?
        }
    })
}

fn preset(node: &NodeDef, tag: &Tag) -> Option<Preset> {
    let mut preset = Preset { label: tag.pieces.iter().find_map(quoted)?, values: Vec::new() };
    for piece in &tag.pieces {
        if let TagPiece::Pair(port, value) = piece {
            let input = &node.inputs[node.input(port)?];
            preset.values.push((input.name.clone(), value_of(&input.ty, value)?));
        }
    }
    Some(preset)
}

fn words(tag: &Tag) -> Vec<&str> {
    tag.pieces
        .iter()
        .map(|piece| if let TagPiece::Word(word) = piece { word.as_str() } else { "" })
        .collect()
}

/// Reads `@bound`: `tone when mode = alpha|shade`.
fn bound(node: &NodeDef, tag: &Tag) -> Option<ShareBound> {
    let words = words(tag);
    let (name, conditions) = words.split_first()?;
    let input = node.input(name)?;
    let conditions = conditions_after_when(node, conditions)?;
    let is_choice = |condition: &Condition| matches!(condition.test, Test::Word(_));
    let is_share = matches!(node.inputs[input].ty, Type::Float | Type::Color);
    (is_share && conditions.iter().all(is_choice)).then_some(ShareBound { input, conditions })
}

fn unit_conditions(node: &NodeDef, tag: &Tag) -> Option<Vec<Condition>> {
    conditions_after_when(node, &words(tag))
}

/// Reads `when` and conditions; without words, no condition, which always holds.
fn conditions_after_when(node: &NodeDef, words: &[&str]) -> Option<Vec<Condition>> {
    match words {
        [] => Some(Vec::new()),
        ["when", rest @ ..] => {
            rest.split(|word| *word == "and").map(|words| condition(node, words)).collect()
        }
        _ => None,
    }
}

/// Reads `@bypass`: `below when opacity = 0 and mode = add|alpha`, or `mode != multiply`.
fn bypass(node: &NodeDef, tag: &Tag) -> Option<Bypass> {
    let words = words(tag);
    let [result, "when", conditions @ ..] = words.as_slice() else { return None };
    let result = match docs::number(result) {
        Some(number) => BypassResult::Number(number),
        None => BypassResult::Input(node.input(result)?),
    };
    let conditions = conditions.split(|word| *word == "and").map(|words| condition(node, words));
    Some(Bypass {
        result,
        conditions: conditions.collect::<Option<_>>()?,
        reason: tag.help.clone(),
    })
}

fn condition(node: &NodeDef, words: &[&str]) -> Option<Condition> {
    let [input, sign, value] = words else { return None };
    let input = node.input(input)?;
    if matches!(*sign, "<=" | ">=") {
        let limit = match docs::number(value) {
            Some(number) => Limit::Number(number),
            None => Limit::Input(node.input(value)?),
        };
        let test = if *sign == "<=" { Test::AtMost(limit) } else { Test::AtLeast(limit) };
        return Some(Condition { input, test });
    }
    let is_choice = node.inputs[input].ty == Type::Choice;
    if *sign == "!=" && is_choice {
        let named: Vec<&str> = value.split('|').collect();
        let words = node.inputs[input].options.iter().map(|option| option.0.clone());
        let others = words.filter(|word| !named.contains(&word.as_ref()));
        return Some(Condition { input, test: Test::Word(others.collect()) });
    }
    if *sign != "=" {
        return None;
    }
    let test = if is_choice {
        Test::Word(value.split('|').map(str::to_owned).collect())
    } else if *value == "black" {
        Test::Black
    } else if *value == "unit" {
        Test::Unit
    } else if *value == "unit_alpha" {
        Test::UnitAlpha
    } else if let Some(number) = docs::number(value) {
        Test::Is(number)
    } else {
        Test::Same(node.input(value)?)
    };
    Some(Condition { input, test })
}
