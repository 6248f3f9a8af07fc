//! Parameters, lights and host work of a look as modules of a crate.

use std::fmt::Write as _;

use super::super::super::ExportFile;
use super::super::super::exposed::ExposedParameter;
use super::super::super::host_code::{RUST, translate};
use super::super::super::program::{LightSetting, ParameterSetting};
use super::super::PackageRequest;
use super::{Template, member, plain, structure, wrapped};
use crate::diag::Diagnostic;
use crate::document::{Light, LightKind, LightSpace, Target};
use crate::interp::Value;
use crate::library::Type;

/// The header of the host work's file.
const HOST: &str = include_str!("template/host.rs.in");

/// Number of parameters that a README of one screen lists.
const LISTED: usize = 12;

/// Numbers that Rust has names for.
const CONSTANTS: [(f32, &str); 4] = [
    (std::f32::consts::PI, "PI"),
    (std::f32::consts::TAU, "TAU"),
    (std::f32::consts::FRAC_PI_2, "FRAC_PI_2"),
    (std::f32::consts::FRAC_PI_4, "FRAC_PI_4"),
];

/// A number as Rust writes a float that a struct holds in 32 bits.
pub(in super::super) fn float(x: f64) -> String {
    let single = x.clamp(f32::MIN.into(), f32::MAX.into()) as f32;
    let known = CONSTANTS.iter().find(|(value, _)| *value == single);
    known.map_or_else(|| format!("{single:?}"), |(_, name)| format!("std::f32::consts::{name}"))
}

fn floats(numbers: impl IntoIterator<Item = f64>) -> String {
    let numbers: Vec<String> = numbers.into_iter().map(float).collect();
    let is_even = numbers.len() > 1 && numbers.iter().all(|number| *number == numbers[0]);
    if is_even {
        return format!("[{}; {}]", numbers[0], numbers.len());
    }
    format!("[{}]", numbers.join(", "))
}

/// The parameters that may be set, as members of a struct.
pub(in super::super) struct Parameters<'a> {
    list: Vec<(&'a ExposedParameter, &'a ParameterSetting)>,
}

impl<'a> Parameters<'a> {
    /// The parameters of a request that change the picture.
    pub(in super::super) fn of(request: &PackageRequest<'a>) -> Self {
        let described = request.description.parameters.iter().enumerate();
        let settings = &request.work.parameters;
        let found = described.filter(|(_, parameter)| parameter.name.is_some());
        let list = found.filter_map(|(index, parameter)| {
            let setting = settings.iter().find(|setting| setting.index == index)?;
            Some((parameter, setting))
        });
        Self { list: list.collect() }
    }

    /// True where nothing may be set.
    pub(in super::super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Name of the first parameter and its value, as a statement sets it.
    pub(in super::super) fn example(&self) -> Option<(String, String)> {
        self.list.first().map(|(_, setting)| (member(&setting.member), value(setting)))
    }

    /// Name of the parameter that describes a pass's sides, by its index.
    pub(in super::super) fn member_of(
        &self,
        request: &PackageRequest<'_>,
        index: usize,
    ) -> Option<String> {
        let parameter = request.description.parameters.get(index)?;
        let mut list = self.list.iter();
        let (_, setting) = list.find(|(found, _)| std::ptr::eq(*found, parameter))?;
        (setting.ty == Type::Float).then(|| member(&setting.member))
    }

    /// Names with types, a line of Markdown each.
    pub(in super::super) fn listed(&self) -> Vec<String> {
        let line = |(parameter, setting): &(&ExposedParameter, &ParameterSetting)| {
            let about = about(parameter);
            format!("  - `{}`, `{}`: {about}", setting.member, type_of(&setting.ty))
        };
        let mut lines: Vec<String> = self.list.iter().take(LISTED).map(line).collect();
        if self.list.len() > LISTED {
            let more = self.list.len() - LISTED;
            lines.push(format!("  - and {more} more: `cargo doc --open`."));
        }
        lines
    }

    /// Fills the template of the module.
    pub(in super::super) fn fill(&self, template: &mut Template) -> String {
        let (mut members, mut defaults) = (Vec::new(), Vec::new());
        for (parameter, setting) in &self.list {
            let name = member(&setting.member);
            members.extend(wrapped(&about(parameter), "/// ", 4));
            members.push(format!("pub {name}: {},", type_of(&setting.ty)));
            defaults.push(format!("{name}: {}", value(setting)));
        }
        template.lines("members", members);
        template.lines("defaults", structure("Self", &defaults, "", 8));
        template.text(include_str!("template/parameters.rs.in"))
    }

    /// Members of the host work's settings; `owner` is what has the values.
    pub(in super::super) fn settings(
        &self,
        request: &PackageRequest<'_>,
        owner: &str,
    ) -> Vec<String> {
        let line = |setting: &ParameterSetting| {
            let name = member(&setting.member);
            let own = self.list.iter().find(|(_, found)| found.index == setting.index);
            let text = match own.filter(|_| setting.name.is_some()) {
                Some((_, found)) => {
                    let given = format!("{owner}.{}", member(&found.member));
                    converted(&given, &found.ty, &setting.ty)
                }
                None => literal(&setting.default),
            };
            format!("{name}: {text}")
        };
        request.work.parameters.iter().map(line).collect()
    }
}

/// A sentence about a parameter: what it is, its range and its unit.
fn about(parameter: &ExposedParameter) -> String {
    let mut text = plain(&parameter.label);
    if text.is_empty() {
        text = parameter.name.as_ref().map(ToString::to_string).unwrap_or_default();
    }
    if !parameter.group.is_empty() {
        let _infallible = write!(text, " of {}", plain(&parameter.group));
    }
    let short = |x: f64| (1e4 * x).round() / 1e4;
    let ends = match (parameter.min.map(short), parameter.max.map(short)) {
        (Some(min), Some(max)) => format!("{min} to {max}"),
        (Some(min), None) => format!("{min} or more"),
        (None, Some(max)) => format!("at most {max}"),
        (None, None) => String::new(),
    };
    let unit = match parameter.unit.as_str() {
        "" => String::new(),
        "rad" => "in radians".to_owned(),
        unit => format!("in {}", plain(unit)),
    };
    let facts = [ends, unit];
    let facts: Vec<&str> = facts.iter().map(String::as_str).filter(|it| !it.is_empty()).collect();
    if !facts.is_empty() {
        let _infallible = write!(text, ", {}", facts.join(", "));
    }
    text.push('.');
    let help = plain(&parameter.help);
    if !help.is_empty() {
        let _infallible = write!(text, " {}", help.trim_end_matches('.'));
        text.push('.');
    }
    text
}

/// Type of a parameter for those who set it.
fn type_of(ty: &Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int => "i32",
        Type::Vec2 => "[f32; 2]",
        Type::Vec3 => "[f32; 3]",
        Type::Vec4 | Type::Color | Type::Composite => "[f32; 4]",
        Type::Mat3 => "[[f32; 3]; 3]",
        _ => "f32",
    }
}

/// The value that a parameter has in the look.
fn value(setting: &ParameterSetting) -> String {
    match &setting.default {
        Value::Vector(scalars) => floats(scalars.iter().map(|scalar| scalar.as_f64())),
        Value::Matrix { columns, components } => {
            let rows = components.len() / columns.max(&1);
            let columns = components.chunks(rows.max(1));
            let columns: Vec<String> =
                columns.map(|column| floats(column.iter().copied())).collect();
            format!("[{}]", columns.join(", "))
        }
        Value::Bool(x) => x.to_string(),
        Value::I32(x) => x.to_string(),
        Value::U32(x) => x.to_string(),
        other => float(other.as_f64().unwrap_or_default()),
    }
}

/// A value as the host work takes it.
fn literal(value: &Value) -> String {
    let wide = |x: f64| format!("{x:?}");
    let list = |numbers: &[f64]| {
        format!("[{}]", numbers.iter().map(|x| wide(*x)).collect::<Vec<_>>().join(", "))
    };
    match value {
        Value::Bool(x) => x.to_string(),
        Value::I32(x) => x.to_string(),
        Value::U32(x) => x.to_string(),
        Value::Vector(scalars) => {
            list(&scalars.iter().map(|scalar| scalar.as_f64()).collect::<Vec<_>>())
        }
        Value::Matrix { columns, components } => {
            let rows = components.len() / columns.max(&1);
            let columns: Vec<String> = components.chunks(rows.max(1)).map(list).collect();
            format!("[{}]", columns.join(", "))
        }
        other => wide(other.as_f64().unwrap_or_default()),
    }
}

/// The expression of a parameter in the type that the host work takes.
fn converted(given: &str, from: &Type, to: &Type) -> String {
    let (own, wanted) = (from.width().unwrap_or(9), to.width().unwrap_or(9));
    match to {
        _ if own > 4 => format!("{given}.map(|column| column.map(f64::from))"),
        Type::Bool | Type::Int if from == to => given.to_owned(),
        _ if own == 1 && wanted == 1 => format!("f64::from({given})"),
        _ if own == wanted => format!("{given}.map(f64::from)"),
        // One value that inputs of several types take.
        _ if own == 1 => format!("[f64::from({given}); {wanted}]"),
        _ if wanted == 1 => format!("f64::from({given}[0])"),
        _ => {
            let part = |index: usize| match index {
                _ if index < own => format!("f64::from({given}[{index}])"),
                _ => "1.0".to_owned(),
            };
            format!("[{}]", (0..wanted).map(part).collect::<Vec<_>>().join(", "))
        }
    }
}

/// The lights that the look reads, as members of a struct.
pub(in super::super) struct Lights<'a> {
    list: &'a [LightSetting],
    names: Vec<String>,
    request: &'a PackageRequest<'a>,
}

impl<'a> Lights<'a> {
    /// The lights of a request.
    pub(in super::super) fn of(request: &'a PackageRequest<'a>) -> Self {
        let list = &request.work.lights;
        // The host work's members end with a word that tells lights from parameters.
        let name = |light: &LightSetting| {
            let short = light.member.strip_suffix("_light").unwrap_or(&light.member);
            if super::syntax_word(short) { light.member.clone() } else { short.to_owned() }
        };
        let mut names: Vec<String> = Vec::new();
        for light in list {
            let short = name(light);
            let is_free = !names.contains(&short);
            names.push(if is_free { short } else { light.member.clone() });
        }
        Self { list, names, request }
    }

    /// True where the look reads no light.
    pub(in super::super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// True if a light of a kind is among them.
    fn has(&self, kind: LightKind) -> bool {
        self.list.iter().any(|light| light.light.kind == kind)
    }

    /// Names of the types of the module.
    pub(in super::super) fn types(&self) -> Vec<&'static str> {
        let kinds = [
            (LightKind::Directional, "DirectionalLight"),
            (LightKind::Point, "PointLight"),
            (LightKind::Spot, "SpotLight"),
        ];
        let own = kinds.into_iter().filter(|(kind, _)| self.has(*kind)).map(|(_, name)| name);
        let mut types: Vec<_> = own.chain(["Lights"]).collect();
        types.sort_unstable();
        types
    }

    /// Names of the lights.
    pub(in super::super) fn names(&self) -> &[String] {
        &self.names
    }

    /// A statement that sets a light of `owner`.
    pub(in super::super) fn example(&self, owner: &str) -> Option<String> {
        let (light, name) = (self.list.first()?, self.names.first()?);
        Some(format!("{owner}.{name}.intensity = {};", float(light.light.intensity)))
    }

    /// Fills the template of the module.
    pub(in super::super) fn fill(&self, template: &mut Template) -> String {
        template.section("directional", self.has(LightKind::Directional));
        template.section("point", self.has(LightKind::Point));
        template.section("spot", self.has(LightKind::Spot));
        let (mut members, mut defaults) = (Vec::new(), Vec::new());
        for (light, name) in self.list.iter().zip(&self.names) {
            members.extend(wrapped(&self.about(light), "/// ", 4));
            members.push(format!("pub {name}: {},", type_name(light.light.kind)));
            let start = format!("{name}: {}", type_name(light.light.kind));
            let fields: Vec<String> = fields(&light.light).collect();
            defaults.extend(structure(&start, &fields, ",", 12));
        }
        template.lines("members", members);
        template.lines("defaults", defaults);
        template.text(include_str!("template/lights.rs.in"))
    }

    /// A sentence about a light.
    fn about(&self, setting: &LightSetting) -> String {
        let own = plain(&setting.light.name);
        let name = if own.is_empty() { plain(setting.id.as_str()) } else { own };
        let frame = match setting.light.space {
            LightSpace::Illumination => "the illumination's",
            LightSpace::World => "the world's",
            LightSpace::Camera => "the camera's",
            LightSpace::Object => "the object's",
        };
        let mut text = format!("The light {name}, in {frame} frame.");
        for exposed in &self.request.look.exposed {
            if let Target::Light { light, field } = &exposed.target
                && *light == setting.id
            {
                let _infallible =
                    write!(text, " Its `{field}` is what the artist calls {}.", exposed.name);
            }
        }
        text
    }

    /// Members of the host work's settings.
    pub(in super::super) fn settings(&self, owner: &str) -> Vec<String> {
        let line = |(light, name): (&LightSetting, &String)| {
            format!("{}: {owner}.{name}.settings()", member(&light.member))
        };
        self.list.iter().zip(&self.names).map(line).collect()
    }
}

fn type_name(kind: LightKind) -> &'static str {
    match kind {
        LightKind::Directional => "DirectionalLight",
        LightKind::Point => "PointLight",
        LightKind::Spot => "SpotLight",
    }
}

/// Fields of a light of its kind, with their values.
fn fields(light: &Light) -> impl Iterator<Item = String> {
    let vector = |name: &str, numbers: [f64; 3]| format!("{name}: {}", floats(numbers));
    let number = |name: &str, x: f64| format!("{name}: {}", float(x));
    let is_directional = light.kind == LightKind::Directional;
    let mut fields = Vec::new();
    if is_directional {
        fields.push(vector("direction", light.direction));
    } else {
        fields.push(vector("position", light.position));
    }
    if light.kind == LightKind::Spot {
        fields.push(vector("aim", light.aim));
        fields.push(number("inner", light.inner));
        fields.push(number("outer", light.outer));
    }
    fields.push(vector("color", light.color));
    fields.push(number("intensity", light.intensity));
    if !is_directional {
        fields.push(number("half_distance", light.half_distance));
        fields.push(number("range", light.range));
    }
    fields.into_iter()
}

/// The module of the host's work.
pub(in super::super) struct HostModule {
    text: String,
}

impl HostModule {
    /// Translates the host work of a request; `None` where the look has none.
    ///
    /// # Errors
    /// Host work that Rust cannot express.
    pub(in super::super) fn of(request: &PackageRequest<'_>) -> Result<Option<Self>, Diagnostic> {
        let work = request.work;
        let mut functions: Vec<&str> = work.modules.iter().map(|it| it.function.as_str()).collect();
        if work.is_keyed {
            functions.push("keyed");
        }
        if functions.is_empty() {
            return Ok(None);
        }
        let text = translate(&work.wgsl, &functions, &RUST)?;
        Ok(Some(Self { text: format!("{HOST}{text}") }))
    }

    /// True if the work reads a surrounding.
    pub(in super::super) fn reads(&self, surrounding: &str) -> bool {
        self.text.contains(&format!("around.{surrounding}"))
    }

    /// The file of the module.
    pub(in super::super) fn file(&self, name: &str) -> ExportFile {
        ExportFile::text(name.to_owned(), self.text.clone())
    }
}
