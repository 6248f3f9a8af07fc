//! Uniforms of the shader: the members of the look's uniform block, each by itself, since Godot has
//! no blocks and no structs among uniforms.
//!
//! A member that is a parameter as the artist set it has the parameter's name, range and group; the
//! others are what the look's script computes.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use chiaro_locale::tr;

use super::super::super::description::{ExposedParameter, Member};
use crate::wgsl::identifiers;

/// A uniform: numbers at one place of the block.
#[derive(Clone, Debug)]
pub(super) struct Uniform {
    /// Name in the shader.
    pub(super) name: String,
    /// Names of the members that lead to the number, joined by points.
    path: String,
    /// Type in the shader.
    pub(super) ty: &'static str,
    /// Number of elements of an array.
    pub(super) count: Option<usize>,
    /// Place of the first number, in words of 32 bits.
    pub(super) word: usize,
    /// Words from an element of an array, or a column of a matrix, to the next.
    pub(super) step: usize,
    /// Parameter that the uniform is, by its index in the description.
    pub(super) parameter: Option<usize>,
    /// Group of the uniforms that a script computes: a light, or nothing.
    group: String,
}

impl Uniform {
    /// Number of rows of a matrix or components of a vector; 1 for a number.
    pub(super) fn rows(&self) -> usize {
        self.ty.chars().last().and_then(|last| last.to_digit(10)).map_or(1, |rows| rows as usize)
    }

    pub(super) fn is_matrix(&self) -> bool {
        self.ty.starts_with("mat")
    }

    /// Words of one element.
    pub(super) fn words(&self, element: usize) -> Vec<usize> {
        let first = self.word + if self.count.is_some() { element * self.step } else { 0 };
        let columns = if self.is_matrix() { self.rows() } else { 1 };
        // Columns of a matrix are as far apart as vectors of four numbers are long.
        let stride = 4;
        (0..columns)
            .flat_map(|column| (0..self.rows()).map(move |row| first + column * stride + row))
            .collect()
    }
}

/// A parameter that a member of the block is.
pub(super) struct ParameterUniform<'a> {
    pub(super) index: usize,
    pub(super) name: String,
    pub(super) parameter: &'a ExposedParameter,
    /// True for a color that Godot shows as one.
    pub(super) is_color: bool,
}

/// A texture of the look.
pub(super) struct ImageUniform {
    /// Name in the GLSL.
    pub(super) old: String,
    /// Name in the shader.
    pub(super) name: String,
    /// File beside the shader.
    pub(super) file: String,
    /// Type of the texture in Godot: `Texture2D` or `Texture2DArray`.
    pub(super) ty: &'static str,
    /// Words after the uniform's type.
    pub(super) hints: String,
}

/// All uniforms of the shader.
pub(super) struct Uniforms<'a> {
    members: Vec<Member>,
    pub(super) list: Vec<Uniform>,
    pub(super) images: Vec<ImageUniform>,
    parameters: BTreeMap<String, ParameterUniform<'a>>,
    /// The block's numbers while parameters have their defaults.
    pub(super) numbers: Vec<f64>,
    /// Words of the text, which no function that is added has for its name.
    taken: BTreeSet<String>,
    /// Structs that the text takes whole: the name of a function for each, and its source.
    values: BTreeMap<String, String>,
}

impl<'a> Uniforms<'a> {
    /// The uniforms of a block. `parameters` are those that members are, by the members' names;
    /// `lights` names the light that a member depends on.
    ///
    /// # Errors
    /// A type that Godot has no uniforms of.
    pub(super) fn of(
        members: Vec<Member>,
        parameters: BTreeMap<String, ParameterUniform<'a>>,
        lights: &BTreeMap<String, String>,
        images: Vec<ImageUniform>,
        numbers: Vec<f64>,
    ) -> Result<Self, String> {
        let mut list = Vec::new();
        for member in &members {
            let group = lights.get(&member.name).cloned().unwrap_or_default();
            let parameter = parameters.get(&member.name);
            let name = parameter.map_or(&member.name, |it| &it.name);
            let parameter = parameter.map(|it| it.index);
            let path = member.name.clone();
            let place = Place { name, path, word: member.offset / 4, array: None, parameter };
            flatten(member, &place, &group, &mut list)?;
        }
        // A member of a struct may be called as one of the block is.
        let mut taken = BTreeSet::new();
        for uniform in &mut list {
            while !taken.insert(uniform.name.clone()) {
                uniform.name.push_str("_2");
            }
        }
        Ok(Self {
            members,
            list,
            images,
            parameters,
            numbers,
            taken: BTreeSet::new(),
            values: BTreeMap::new(),
        })
    }

    /// Names of all uniforms, those of textures last.
    pub(super) fn names(&self) -> Vec<String> {
        let values = self.list.iter().map(|uniform| &uniform.name);
        values.chain(self.images.iter().map(|image| &image.name)).cloned().collect()
    }

    /// Gives a uniform another name.
    pub(super) fn rename(&mut self, old: &str, new: &str) {
        for uniform in self.list.iter_mut().filter(|uniform| uniform.name == old) {
            new.clone_into(&mut uniform.name);
        }
        for parameter in self.parameters.values_mut().filter(|parameter| parameter.name == old) {
            new.clone_into(&mut parameter.name);
        }
        for image in self.images.iter_mut().filter(|image| image.name == old) {
            new.clone_into(&mut image.name);
        }
    }

    /// Names of the text that no function that is added may have.
    pub(super) fn take(&mut self, words: &BTreeSet<String>) {
        self.taken.clone_from(words);
    }

    /// The name of the uniform that members lead to.
    fn name_of(&self, path: &str) -> String {
        let found = self.list.iter().find(|uniform| uniform.path == path);
        found.map_or_else(|| path.replace('.', "_"), |uniform| uniform.name.clone())
    }

    /// The name of a function that makes a struct.
    fn function_name(&self, path: &str, end: &str) -> String {
        let mut name = format!("{}_{end}", path.replace('.', "_"));
        let is_taken = |name: &String| {
            self.taken.contains(name) || self.list.iter().any(|uniform| uniform.name == *name)
        };
        while is_taken(&name) {
            name.push('_');
        }
        name
    }

    /// The text with members of the block as uniforms.
    pub(super) fn rewrite(&mut self, text: &str) -> String {
        let mut result = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(at) = rest.find("u_look.") {
            let is_word = rest[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
            result.push_str(&rest[..at]);
            rest = &rest[at + "u_look.".len()..];
            if is_word {
                result.push_str("u_look.");
                continue;
            }
            let (replaced, used) = self.access(&self.members.clone(), "", "", rest);
            result += &replaced;
            rest = &rest[used..];
        }
        result += rest;
        for image in &self.images {
            result = crate::wgsl::rename_identifiers(&result, |word| {
                (word == image.old).then(|| image.name.clone())
            });
        }
        result
    }

    /// Text of a member's name and all that follows, and the length of it.
    fn access(
        &mut self,
        members: &[Member],
        prefix: &str,
        index: &str,
        text: &str,
    ) -> (String, usize) {
        let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let mut used = end.unwrap_or(text.len());
        let word = &text[..used];
        let named = |name: &str| members.iter().find(|member| member.name == name);
        // GLSL has a `_` behind names that end with a digit, where a value has the name, too.
        let found = named(word).or_else(|| named(word.strip_suffix('_')?));
        let Some(member) = found else { return (word.to_owned(), used) };
        let name = &member.name;
        let path = if prefix.is_empty() { name.clone() } else { format!("{prefix}.{name}") };
        if self.parameters.get(&path).is_some_and(|it| it.is_color) {
            return (format!("as_shown({})", self.name_of(&path)), used);
        }
        let mut index = index.to_owned();
        if member.ty.starts_with("array")
            && text[used..].starts_with('[')
            && let Some(close) = closing(&text[used..])
        {
            let inner = text[used + 1..used + close].to_owned();
            index = format!("[{}]", self.rewrite(&inner));
            used += close + 1;
        }
        if member.members.is_empty() {
            return (format!("{}{index}", self.name_of(&path)), used);
        }
        if text[used..].starts_with('.') {
            let (inner, more) = self.access(&member.members, &path, &index, &text[used + 1..]);
            return (inner, used + 1 + more);
        }
        let (call, argument) = match index.is_empty() {
            true => (self.function_name(&path, "value"), String::new()),
            false => (self.function_name(&path, "at"), index[1..index.len() - 1].to_owned()),
        };
        let is_array = !index.is_empty();
        let place = if is_array { "[i]" } else { "" };
        let source = self.whole(member, &path, place);
        let ty = element_type(&member.ty);
        let parameters = if is_array { "int i" } else { "" };
        let source = format!("{ty} {call}({parameters}) {{\n    return {source};\n}}\n\n");
        self.values.insert(call.clone(), source);
        (format!("{call}({argument})"), used)
    }

    /// A struct of uniforms.
    fn whole(&self, member: &Member, path: &str, index: &str) -> String {
        let part = |inner: &Member| {
            let path = format!("{path}.{}", inner.name);
            match inner.members.is_empty() {
                true => format!("{}{index}", self.name_of(&path)),
                false => self.whole(inner, &path, index),
            }
        };
        let parts: Vec<String> = member.members.iter().map(part).collect();
        format!("{}({})", element_type(&member.ty), parts.join(", "))
    }

    /// Functions that make structs of uniforms.
    pub(super) fn values_text(&self) -> String {
        self.values.values().map(String::as_str).collect()
    }

    /// The uniforms that a text reads.
    pub(super) fn read<'s>(&'s self, text: &str) -> Vec<&'s Uniform> {
        let words: BTreeSet<String> = identifiers(text).into_iter().collect();
        self.list.iter().filter(|uniform| words.contains(&uniform.name)).collect()
    }

    /// The parameter of a uniform.
    pub(super) fn parameter(&self, uniform: &Uniform) -> Option<&ParameterUniform<'a>> {
        self.parameters.values().find(|it| Some(it.index) == uniform.parameter)
    }

    /// Declarations of the uniforms that a text reads: parameters in the artist's order and groups,
    /// then what the script computes, then textures.
    pub(super) fn declarations(&self, text: &str) -> String {
        let read = self.read(text);
        let (mut own, computed): (Vec<_>, Vec<_>) =
            read.into_iter().partition(|uniform| uniform.parameter.is_some());
        own.sort_by_key(|uniform| uniform.parameter);
        let mut lines = String::new();
        let mut open = String::new();
        for uniform in own {
            let Some(found) = self.parameter(uniform) else { continue };
            group(&mut lines, &mut open, &group_name(&found.parameter.group));
            if let Some(line) = help_of(found.parameter) {
                let _infallible = writeln!(lines, "/** {line} */");
            }
            let _infallible = writeln!(
                lines,
                "uniform {} {}{}{};",
                uniform.ty,
                uniform.name,
                hint(found),
                self.default(uniform)
            );
        }
        for uniform in computed {
            let light = match uniform.group.is_empty() {
                true => "Computed".to_owned(),
                false => format!("Lights.{}", group_name(&uniform.group)),
            };
            group(&mut lines, &mut open, &light);
            let count = uniform.count.map(|count| format!("[{count}]")).unwrap_or_default();
            let _infallible = writeln!(
                lines,
                "uniform {} {}{count}{};",
                uniform.ty,
                uniform.name,
                self.default(uniform)
            );
        }
        group(&mut lines, &mut open, "");
        for image in &self.images {
            let sampler = image.ty.replace("Texture", "sampler");
            let _infallible =
                writeln!(lines, "uniform {sampler} {} : {};", image.name, image.hints);
        }
        if !lines.is_empty() {
            lines.push('\n');
        }
        lines
    }

    /// The function that reads colors, where a text calls it.
    pub(super) fn encoding(&self, text: &str) -> &'static str {
        if text.contains("as_shown(") { include_str!("color.gdshaderinc") } else { "" }
    }

    /// The elements of an array as a resource has them.
    pub(super) fn list_of(&self, uniform: &Uniform) -> String {
        let numbers = |element: usize| {
            let words = uniform.words(element).into_iter();
            let words =
                words.map(|word| float(self.numbers.get(word).copied().unwrap_or_default()));
            words.collect::<Vec<_>>().join(", ")
        };
        let elements: Vec<String> = (0..uniform.count.unwrap_or_default())
            .map(|element| match uniform.ty {
                // Godot writes a basis by its rows, and the words are columns.
                "mat3" => {
                    let words = uniform.words(element);
                    let rows = (0..9).map(|at| words[at % 3 * 3 + at / 3]);
                    let rows =
                        rows.map(|word| float(self.numbers.get(word).copied().unwrap_or_default()));
                    format!("Basis({})", rows.collect::<Vec<_>>().join(", "))
                }
                _ => numbers(element),
            })
            .collect();
        let all = elements.join(", ");
        match uniform.ty {
            "float" => format!("PackedFloat32Array({all})"),
            "vec2" => format!("PackedVector2Array({all})"),
            "vec3" => format!("PackedVector3Array({all})"),
            "vec4" => format!("PackedVector4Array({all})"),
            "int" | "uint" => format!("PackedInt32Array({})", all.replace(".0", "")),
            _ => format!("[{all}]"),
        }
    }

    /// The default of a uniform; arrays have none in Godot.
    fn default(&self, uniform: &Uniform) -> String {
        if uniform.count.is_some() {
            return String::new();
        }
        let number = |word: usize| self.numbers.get(word).copied().unwrap_or_default();
        let words = uniform.words(0);
        match uniform.ty {
            "int" => format!(" = {}", number(words[0]) as i64),
            "uint" => format!(" = {}u", number(words[0]) as i64),
            "float" => format!(" = {}", float(number(words[0]))),
            ty if uniform.is_matrix() => {
                let rows = uniform.rows();
                let column = |column: &[usize]| {
                    let numbers: Vec<String> = column.iter().map(|it| float(number(*it))).collect();
                    format!("vec{rows}({})", numbers.join(", "))
                };
                let columns: Vec<String> = words.chunks(rows).map(column).collect();
                format!(" = {ty}({})", columns.join(", "))
            }
            ty => {
                let numbers: Vec<String> = words.into_iter().map(|it| float(number(it))).collect();
                format!(" = {ty}({})", numbers.join(", "))
            }
        }
    }
}

/// A float of 32 bits as text.
pub(super) fn float(x: f64) -> String {
    let x = if x.is_finite() { x as f32 } else { 0.0 };
    format!("{:?}", if x == 0.0 { 0.0 } else { x })
}

/// Place of a member.
struct Place<'n> {
    name: &'n str,
    path: String,
    word: u32,
    /// Count and words of one element of the array around the member.
    array: Option<(usize, usize)>,
    parameter: Option<usize>,
}

fn flatten(
    member: &Member,
    place: &Place<'_>,
    group: &str,
    list: &mut Vec<Uniform>,
) -> Result<(), String> {
    let mut array = place.array;
    if let Some(count) = array_count(&member.ty) {
        if array.is_some() {
            return Err(tr!("the arrays within arrays of `{name}`", name = member.name));
        }
        array = Some((count, member.stride as usize / 4));
    }
    for inner in &member.members {
        let name = format!("{}_{}", place.name, inner.name);
        let word = place.word + inner.offset / 4;
        let path = format!("{}.{}", place.path, inner.name);
        let place = Place { name: &name, path, word, array, parameter: None };
        flatten(inner, &place, group, list)?;
    }
    if member.members.is_empty() {
        let ty = element_type(&member.ty);
        list.push(Uniform {
            name: place.name.to_owned(),
            path: place.path.clone(),
            ty: godot_type(&ty)
                .ok_or_else(|| tr!("the type `{ty}` of `{name}`", name = member.name))?,
            count: array.map(|it| it.0),
            word: place.word as usize,
            step: array.map_or(member.stride as usize / 4, |it| it.1),
            parameter: place.parameter,
            group: group.to_owned(),
        });
    }
    Ok(())
}

/// Number of elements of `array<T, N>`.
fn array_count(ty: &str) -> Option<usize> {
    ty.strip_prefix("array<")?.strip_suffix('>')?.rsplit(", ").next()?.parse().ok()
}

/// `T` of `array<T, N>`, or the type itself.
fn element_type(ty: &str) -> String {
    let inner = ty.strip_prefix("array<").and_then(|it| it.rsplit_once(", "));
    inner.map_or(ty, |it| it.0).to_owned()
}

/// A type of WGSL as a uniform of Godot.
fn godot_type(ty: &str) -> Option<&'static str> {
    Some(match ty {
        "f32" => "float",
        "i32" => "int",
        "u32" => "uint",
        "vec2f" => "vec2",
        "vec3f" => "vec3",
        "vec4f" => "vec4",
        "mat3x3f" => "mat3",
        _ => return None,
    })
}

/// The place of the bracket that closes the one at the beginning.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0_i32;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '[') - i32::from(c == ']');
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// Opens a group of uniforms, where another one is open.
fn group(lines: &mut String, open: &mut String, wanted: &str) {
    if open == wanted {
        return;
    }
    if !lines.is_empty() {
        lines.push('\n');
    }
    let _infallible =
        writeln!(lines, "group_uniforms{}{wanted};", if wanted.is_empty() { "" } else { " " });
    wanted.clone_into(open);
}

/// A name for a group: a word of letters, which Godot shows with spaces.
fn group_name(name: &str) -> String {
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = name.chars().map(kept).collect();
    let name = name.trim_matches('_');
    match name.chars().next() {
        None => "Look".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("Group_{name}"),
        Some(_) => name.to_owned(),
    }
}

/// The help of a parameter, fit for a comment.
pub(super) fn help_of(parameter: &ExposedParameter) -> Option<String> {
    let help = if parameter.help.is_empty() { &parameter.label } else { &parameter.help };
    let help = help.replace("*/", "").replace(char::is_control, " ");
    (!help.trim().is_empty()).then(|| help.trim().to_owned())
}

/// The hint of a parameter's uniform.
fn hint(found: &ParameterUniform<'_>) -> String {
    if found.is_color {
        return " : source_color".to_owned();
    }
    let ExposedParameter { min, max, ty, .. } = found.parameter;
    match (min, max) {
        (Some(min), Some(max)) if ty == "float" => {
            format!(" : hint_range({}, {}, 0.001)", float(*min), float(*max))
        }
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_are_found_by_the_names_that_glsl_has() {
        let member = |name: &str| Member {
            name: name.to_owned(),
            ty: "vec2f".to_owned(),
            offset: 0,
            size: 8,
            stride: 0,
            members: Vec::new(),
        };
        let members = vec![member("shade_2"), member("tone")];
        let lights = BTreeMap::new();
        let uniforms = Uniforms::of(members, BTreeMap::new(), &lights, Vec::new(), Vec::new());
        let text = "f(u_look.shade_2_.x, u_look.tone, shade_2_)";
        assert_eq!(uniforms.expect("vectors").rewrite(text), "f(shade_2.x, tone, shade_2_)");
    }
}
