//! The look and its host work as one WGSL module without variables of the module, which OSL does
//! not have: functions that read them take them as arguments.

use std::collections::{BTreeMap, BTreeSet};

use super::super::super::materialx::{rename_clashes, without_attributes};
use super::super::super::{PackageRequest, refusal};
use super::images::ShaderImage;
use crate::diag::Diagnostic;
use crate::export::modules::ShaderModule;
use crate::wgsl::{DeclarationKind, identifiers, scan};

/// Functions of the library in forms without the bits of floats.
const PLAIN: &str = include_str!("plain.wgsl");

/// Name that the look's entry point has as a function.
pub(super) const PICTURE: &str = "look_color";

/// Name of the view, which the picture takes.
pub(super) const VIEWER: &str = "viewer";

/// Values that a point of a surface has, as the look's vertices pass them on.
const SURFACE: &[&str] = &["position", "normal", "position_object", "uv"];

/// The module, and what its functions take.
#[derive(Clone, Debug)]
pub(super) struct Source {
    pub(super) wgsl: String,
    /// Functions that the shader calls.
    pub(super) roots: Vec<String>,
    /// Members of what a vertex passes on.
    pub(super) varyings: Vec<String>,
    /// True if the picture asks which side is seen.
    pub(super) is_told_side: bool,
    /// Function that makes the look's numbers; `None` where there are none.
    pub(super) numbers: Option<String>,
    /// Variables that the picture takes, in the order of its arguments.
    pub(super) variables: Vec<&'static str>,
    /// True if keys move the settings.
    pub(super) is_keyed: bool,
}

impl Source {
    /// The source of a look.
    ///
    /// # Errors
    /// `not-in-package`: what a shader of OSL is not told.
    pub(super) fn of(
        request: &PackageRequest<'_>,
        module: &ShaderModule,
        images: &[ShaderImage],
    ) -> Result<Self, Diagnostic> {
        let mut declarations = Declarations::default();
        for image in images {
            declarations.add(&image.function(), image.wgsl(), None);
        }
        let (mut varyings, mut is_told_side) = (Vec::new(), false);
        let source = module.wgsl();
        for declaration in scan(source).declarations {
            let own = &source[declaration.span.clone()];
            let name = declaration.name.as_str();
            let kept = match name {
                "vs_main" | "Vertex" | "Object" => continue,
                "View" => {
                    "struct View {\n    /// The way back to the eye.\n    eye: vec4f,\n}".to_owned()
                }
                "Varyings" => {
                    let names = declaration.fields.iter().map(|field| field.name.clone());
                    varyings = names.filter(|name| name != "clip").collect();
                    without_attributes(own, |line| !line.trim_start().starts_with("clip:"))
                }
                "fs_main" => {
                    is_told_side = own.contains("@builtin(front_facing)");
                    let text = without_attributes(own, |_| true);
                    let text = text.replacen("fs_main", PICTURE, 1);
                    // What the look leaves out lets through what is behind.
                    let text = text.replace("discard;", "return vec4f(0.0);");
                    format!("/// The look at a point of a surface: straight RGBA.\n{text}")
                }
                _ if declaration.kind == DeclarationKind::Variable => continue,
                _ => own.to_owned(),
            };
            let name = if name == "fs_main" { PICTURE } else { name };
            let kept = images.iter().try_fold(kept, |text, image| image.called_in(&text));
            let kept = kept.ok_or_else(|| refuse("asks for more of an image than its colors"))?;
            declarations.add(name, kept, Some(own));
        }
        if let Some(name) = varyings.iter().find(|name| !SURFACE.contains(&name.as_str())) {
            return Err(refuse(&format!("asks its surface for `{name}`")));
        }
        let mut roots = vec![PICTURE.to_owned()];
        let work = request.work;
        let numbers = work.modules.iter().find(|it| it.module == module.name);
        if let Some(numbers) = numbers {
            let host = format!("{}{}", work.wgsl, numbers.structure.wgsl());
            let host = rename_clashes(&host, &declarations.originals);
            for declaration in scan(&host).declarations {
                if !declarations.texts.contains_key(&declaration.name) {
                    let text = host[declaration.span.clone()].to_owned();
                    declarations.add(&declaration.name, text, None);
                }
            }
            roots.push(numbers.structure.name.clone());
            if work.is_keyed {
                roots.push("keyed".to_owned());
            }
        }
        declarations.plain();
        let mut structs = roots.clone();
        structs.extend(["Varyings", "View"].map(str::to_owned));
        declarations.keep_reached(&structs);
        declarations.refuse_unknown()?;
        declarations.rename_view();
        let mut variables = Vec::new();
        for (variable, ty) in [("look", "Look"), (VIEWER, "View")] {
            if declarations.pass_on(variable, ty) {
                variables.insert(0, variable);
            }
        }
        if !variables.contains(&VIEWER) {
            declarations.leave_out("View");
        }
        let is_keyed = work.is_keyed && numbers.is_some();
        let numbers = numbers.map(|numbers| numbers.structure.name.clone());
        let wgsl = declarations.text();
        Ok(Self { wgsl, roots, varyings, is_told_side, numbers, variables, is_keyed })
    }
}

fn refuse(what: &str) -> Diagnostic {
    refusal(
        format!("the look {what}, which a shader of OSL is not told"),
        "render with the add-on's own `render`",
    )
}

/// Declarations in their order, by name.
#[derive(Debug, Default)]
struct Declarations {
    order: Vec<String>,
    texts: BTreeMap<String, String>,
    /// Functions of the shader as they were.
    originals: BTreeMap<String, String>,
}

impl Declarations {
    fn add(&mut self, name: &str, text: String, original: Option<&str>) {
        self.order.push(name.to_owned());
        self.texts.insert(name.to_owned(), text);
        if let Some(original) = original {
            self.originals.insert(name.to_owned(), original.to_owned());
        }
    }

    /// Puts functions without bits in the places of those with them, and of their variants.
    fn plain(&mut self) {
        for declaration in scan(PLAIN).declarations {
            let name = &declaration.name;
            // Variants have numbers, and those of the host work another name where both differ.
            let is_it = |known: &str| {
                let known = known.strip_suffix("_before").unwrap_or(known);
                let rest = known.strip_prefix(name.as_str());
                let number = |rest: &str| rest.strip_prefix('_')?.parse::<u32>().ok();
                rest.is_some_and(|rest| rest.is_empty() || number(rest).is_some())
            };
            for (known, text) in &mut self.texts {
                if is_it(known) && text.contains("bitcast") {
                    let plain = &PLAIN[declaration.span.clone()];
                    *text = plain.replacen(&format!("fn {name}("), &format!("fn {known}("), 1);
                }
            }
        }
    }

    fn leave_out(&mut self, name: &str) {
        self.order.retain(|known| known != name);
        self.texts.remove(name);
    }

    /// Leaves out what no root uses.
    fn keep_reached(&mut self, roots: &[String]) {
        let mut open = roots.to_vec();
        let mut reached = BTreeSet::new();
        while let Some(name) = open.pop() {
            if let Some(text) = self.texts.get(&name)
                && reached.insert(name)
            {
                let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
                open.extend(code.flat_map(identifiers));
            }
        }
        self.order.retain(|name| reached.contains(name));
        self.texts.retain(|name, _| reached.contains(name));
    }

    fn refuse_unknown(&self) -> Result<(), Diagnostic> {
        if self.texts.contains_key("EachLight") {
            // oslc copies structs within lists of structs in part.
            let message = "the look has more lights than fit but in a list, which no shader of OSL \
                           can hold";
            return Err(refusal(message, "render with the add-on's own `render`"));
        }
        for text in self.texts.values().map(|text| code_of(text)) {
            let asks = |word: &str| !places_of(&text, word).is_empty();
            if asks("in.clip") || asks("around.viewport") || asks("view.screen") {
                return Err(refuse("counts pixels of the picture"));
            }
            if asks("view.clip_from_world") || asks("view.camera_from_world") {
                return Err(refuse("asks for the axes of the camera at each point"));
            }
            if asks("object.") {
                return Err(refuse("asks for the axes of the object at each point"));
            }
            if text.contains("-> array<") {
                let message = "the look has keys whose weights are a list, which no function of \
                               OSL gives back";
                return Err(refusal(message, "render with the add-on's own `render`"));
            }
            if asks("around.near") {
                return Err(refuse("has keys by the distance of another object"));
            }
        }
        Ok(())
    }

    /// Gives the view another name: functions have arguments that are called `view`.
    fn rename_view(&mut self) {
        for text in self.texts.values_mut() {
            for at in places_of(text, "view.eye").into_iter().rev() {
                text.replace_range(at..at + "view".len(), VIEWER);
            }
        }
    }

    /// Gives functions that read a variable of the module an argument of that name; true if the
    /// picture is one of them.
    fn pass_on(&mut self, variable: &str, ty: &str) -> bool {
        let functions: Vec<&String> = self
            .order
            .iter()
            .filter(|name| self.texts[*name].contains(&format!("fn {name}(")))
            .collect();
        let words: BTreeMap<&String, BTreeSet<String>> = functions
            .iter()
            .map(|name| (*name, identifiers(&code_of(&self.texts[*name])).into_iter().collect()))
            .collect();
        let read = format!("{variable}.");
        let mut takers: BTreeSet<String> = words
            .iter()
            .filter(|(name, _)| !places_of(&code_of(&self.texts[**name]), &read).is_empty())
            .map(|(name, _)| (*name).clone())
            .collect();
        if takers.is_empty() {
            return false;
        }
        loop {
            let calls = |(name, words): (&&String, &BTreeSet<String>)| {
                let is_new = !takers.contains(*name) && words.iter().any(|it| takers.contains(it));
                is_new.then(|| (*name).clone())
            };
            let more: Vec<String> = words.iter().filter_map(calls).collect();
            if more.is_empty() {
                break;
            }
            takers.extend(more);
        }
        for (name, text) in &mut self.texts {
            let own = format!("fn {name}(");
            let with_end = |call: &str, rest: &str, argument: &str| {
                let end = if rest.trim_start().starts_with(')') { "" } else { ", " };
                format!("{call}{argument}{end}")
            };
            let mut result = String::new();
            let mut rest = text.as_str();
            while let Some(at) = rest.find('(') {
                let (before, after) = rest.split_at(at + 1);
                let word =
                    before[..at].rsplit(|c: char| !c.is_ascii_alphanumeric() && c != '_').next();
                let is_call = word.is_some_and(|word| takers.contains(word));
                if !is_call {
                    result += before;
                } else if before.ends_with(&own) {
                    result += &with_end(before, after, &format!("{variable}: {ty}"));
                } else {
                    result += &with_end(before, after, variable);
                }
                rest = after;
            }
            *text = result + rest;
        }
        takers.contains(PICTURE)
    }

    fn text(&self) -> String {
        let texts = self.order.iter().map(|name| format!("{}\n\n", self.texts[name]));
        // naga has the alignment of uniforms in its own hands.
        texts.collect::<String>().replace("@align(16) ", "")
    }
}

/// Places of a word that no word or point goes before.
fn places_of(text: &str, word: &str) -> Vec<usize> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let places = text.match_indices(word).map(|(at, _)| at);
    places.filter(|at| !text[..*at].ends_with(is_word)).collect()
}

/// A declaration without its comments.
fn code_of(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}
