//! The numbers of a module's `Look` uniform.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use chiaro_locale::tr;
use naga::{ArraySize, Handle, ScalarKind, TypeInner};

use super::super::modules::{Host, ShaderModule};
use super::literal::{literal, number};
use super::settings::{Settings, light_value, surrounding};
use super::{ModuleNumbers, StructFunction, identifier, problem};
use crate::compile::{HostStep, UniformMember};
use crate::diag::Diagnostic;
use crate::ids::LightId;
use crate::interp;
use crate::wgsl::{self, ValidModule};

/// Writes the function of a module; `None` where the module has no `Look` uniform.
pub(super) fn write(
    module: &ShaderModule,
    settings: &Settings,
    text: &mut String,
) -> Result<Option<ModuleNumbers>, Diagnostic> {
    let Some(host) = module.host().filter(|host| host.shader.host.size > 0) else {
        return Ok(None);
    };
    let words = host.shader.host.size as usize / 4;
    let function = identifier(&format!("{}_numbers", module.name), &[]);
    let wanted = host.shader.host.members.iter().map(|member| member.step);
    let mut steps = Steps::new(host, settings);
    steps.take_names();
    let mut body = steps.write(wanted)?;
    let module_of_look = &host.shader.valid.module;
    let mut writer =
        WordWriter { module: module_of_look, text: String::new(), integers: Vec::new() };
    let mut filled = String::new();
    for member in &host.shader.host.members {
        let mut value = steps.name(member.step);
        if member.ty == crate::library::Type::Bool {
            value = format!("select(0u, 1u, {value})");
        }
        let operand = match steps.undeclared.get(&member.step) {
            Some(known) => Operand::Known(known),
            None => Operand::Named(value.clone()),
        };
        writer.write(member.offset, type_of(host, member)?, &operand)?;
        let place = match &member.place {
            None => member.name.clone(),
            Some(place) => format!("{}[{}].{}", place.array, place.index, place.field),
        };
        let _ = writeln!(filled, "    numbers.{place} = {value};");
    }
    let structure = StructFunction {
        name: identifier(&format!("{}_look", module.name), &[]),
        body: format!("{body}    var numbers: Look;\n{filled}    return numbers;\n"),
    };
    let _ = write!(body, "    var numbers: array<f32, {words}>;\n{}", writer.text);
    let _ = write!(
        text,
        "/// Numbers of the uniform of `{}`, one for each four bytes.\n\
         fn {function}(settings: Settings, around: Surroundings) -> array<f32, {words}> {{\n\
         {body}    return numbers;\n}}\n\n",
        module.name
    );
    let integers = writer.integers;
    Ok(Some(ModuleNumbers { module: module.name, function, integers, structure }))
}

/// Type of a member in the shader's uniform.
fn type_of(host: &Host, member: &UniformMember) -> Result<Handle<naga::Type>, Diagnostic> {
    let module = &host.shader.valid.module;
    let lost = || problem(tr!("the member `{name}` has no place", name = member.name));
    let (look, _) =
        module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some("Look")).ok_or_else(lost)?;
    let named = |ty: Handle<naga::Type>, name: &str| match &module.types[ty].inner {
        TypeInner::Struct { members, .. } => {
            members.iter().find(|it| it.name.as_deref() == Some(name)).map(|it| it.ty)
        }
        _ => None,
    };
    let found = match &member.place {
        None => named(look, &member.name),
        Some(place) => named(look, &place.array).and_then(|array| {
            let TypeInner::Array { base, .. } = module.types[array].inner else { return None };
            named(base, &place.field)
        }),
    };
    found.ok_or_else(lost)
}

/// Writer of the words of values.
struct WordWriter<'a> {
    module: &'a naga::Module,
    text: String,
    integers: Vec<usize>,
}

impl WordWriter<'_> {
    /// Writes a value of a type at a byte.
    fn write(
        &mut self,
        at: u32,
        ty: Handle<naga::Type>,
        value: &Operand<'_>,
    ) -> Result<(), Diagnostic> {
        let module = self.module;
        match &module.types[ty].inner {
            TypeInner::Scalar(scalar) => self.word(at, &value.text(), scalar.kind),
            TypeInner::Vector { size, scalar } => {
                for index in 0..*size as u32 {
                    self.word(at + 4 * index, &value.component(index as usize), scalar.kind);
                }
            }
            TypeInner::Matrix { columns, rows, scalar } => {
                let stride = if *rows as u32 == 2 { 8 } else { 16 };
                for column in 0..*columns as u32 {
                    for row in 0..*rows as u32 {
                        let cell = value.cell([column, row].map(|index| index as usize));
                        self.word(at + column * stride + 4 * row, &cell, scalar.kind);
                    }
                }
            }
            TypeInner::Array { base, size: ArraySize::Constant(count), stride } => {
                for index in 0..count.get() {
                    self.write(at + index * stride, *base, &value.element(index as usize))?;
                }
            }
            TypeInner::Struct { members, .. } => {
                for (index, member) in members.iter().enumerate() {
                    let name = member.name.as_deref().unwrap_or_default();
                    self.write(at + member.offset, member.ty, &value.member(index, name))?;
                }
            }
            _ => {
                return Err(problem(tr!(
                    "`{value}` is none of numbers alone",
                    value = value.text()
                )));
            }
        }
        Ok(())
    }

    fn word(&mut self, at: u32, value: &str, kind: ScalarKind) {
        let at = at as usize / 4;
        let is_zero = matches!(value, "0.0" | "0u" | "-0.0");
        let value = match kind {
            ScalarKind::Float => value.to_owned(),
            _ => {
                self.integers.push(at);
                format!("f32({value})")
            }
        };
        // Numbers are 0 from the start.
        if !is_zero {
            let _ = writeln!(self.text, "    numbers[{at}] = {value};");
        }
    }
}

/// A value whose words are written.
enum Operand<'a> {
    /// An expression of the program.
    Named(String),
    /// A value of a type that the program does not declare.
    Known(&'a interp::Value),
}

impl Operand<'_> {
    /// The value as one expression.
    fn text(&self) -> String {
        match self {
            Self::Named(name) => name.clone(),
            Self::Known(value) => literal(value).unwrap_or_default(),
        }
    }

    /// A component of a vector.
    fn component(&self, index: usize) -> String {
        match self {
            Self::Named(name) => format!("{name}.{}", AXES[index]),
            Self::Known(interp::Value::Vector(scalars)) => scalar(scalars.get(index).copied()),
            Self::Known(_) => scalar(None),
        }
    }

    /// The component of a matrix at a column and a row.
    fn cell(&self, [column, row]: [usize; 2]) -> String {
        match self {
            Self::Named(name) => format!("{name}[{column}].{}", AXES[row]),
            Self::Known(interp::Value::Matrix { columns, components }) => {
                let rows = components.len() / (*columns).max(1);
                number(components.get(column * rows + row).copied().unwrap_or_default())
            }
            Self::Known(_) => scalar(None),
        }
    }

    /// An element of an array.
    fn element(&self, index: usize) -> Self {
        match self {
            Self::Named(name) => Self::Named(format!("{name}[{index}]")),
            Self::Known(value) => Self::Known(part(value, index)),
        }
    }

    /// A member of a struct.
    fn member(&self, index: usize, name: &str) -> Self {
        match self {
            Self::Named(value) => Self::Named(format!("{value}.{name}")),
            Self::Known(value) => Self::Known(part(value, index)),
        }
    }
}

/// Names of a vector's components.
const AXES: [&str; 4] = ["x", "y", "z", "w"];

/// A part of an array or a struct; 0 where there is none.
fn part(value: &interp::Value, index: usize) -> &interp::Value {
    let parts = match value {
        interp::Value::Array(parts) | interp::Value::Struct(parts) => parts.get(index),
        _ => None,
    };
    parts.unwrap_or(&interp::Value::Float(0.0))
}

/// A component as WGSL; 0 where there is none.
fn scalar(component: Option<interp::Scalar>) -> String {
    match component {
        Some(interp::Scalar::U32(x)) => format!("{x}u"),
        Some(interp::Scalar::I32(x)) => format!("i32({x})"),
        other => number(other.map_or(0.0, |scalar| scalar.as_f64())),
    }
}

/// Steps of a host program as statements.
pub(super) struct Steps<'a> {
    host: &'a Host,
    settings: &'a Settings,
    functions: Option<ValidModule>,
    /// Expressions of the steps that were written.
    names: BTreeMap<usize, String>,
    /// Names that the results of calls are to have.
    wanted: BTreeMap<usize, String>,
    /// Values that no function of the program takes, such as a ramp that only the shader reads:
    /// their types are declared by the shader alone.
    undeclared: BTreeMap<usize, &'a interp::Value>,
}

impl<'a> Steps<'a> {
    pub(super) fn new(host: &'a Host, settings: &'a Settings) -> Self {
        let functions = wgsl::parse(&host.source.wgsl).ok();
        Self {
            host,
            settings,
            functions,
            names: BTreeMap::new(),
            wanted: BTreeMap::new(),
            undeclared: BTreeMap::new(),
        }
    }

    /// Lets the results of calls have the names of the members that they are for.
    fn take_names(&mut self) {
        let lights = self.settings.lights.iter().map(|light| light.member.clone());
        let mut taken: Vec<String> = lights.collect();
        taken.extend(["settings", "around", "numbers"].map(str::to_owned));
        // A value that is called like a function would hide the function.
        for source in [super::HOST, self.host.source.wgsl.as_str()] {
            taken.extend(wgsl::scan(source).declarations.into_iter().map(|it| it.name));
        }
        for member in &self.host.shader.host.members {
            let names: Vec<&str> = taken.iter().map(String::as_str).collect();
            let name = identifier(&member.name, &names);
            taken.push(name.clone());
            self.wanted.entry(member.step).or_insert(name);
        }
    }

    /// The expression of a step that was written.
    pub(super) fn name(&self, step: usize) -> String {
        self.names.get(&step).cloned().unwrap_or_else(|| "0.0".to_owned())
    }

    /// Statements that compute steps and those that they need.
    pub(super) fn write(
        &mut self,
        wanted: impl IntoIterator<Item = usize>,
    ) -> Result<String, Diagnostic> {
        let steps = &self.host.source.steps;
        let (mut needed, mut open) = (BTreeSet::new(), Vec::from_iter(wanted));
        while let Some(index) = open.pop() {
            if needed.insert(index) {
                match &steps[index] {
                    HostStep::Call { arguments, .. } => open.extend(arguments),
                    HostStep::Member { value, .. } => open.push(*value),
                    _ => {}
                }
            }
        }
        let mut text = String::new();
        let mut lights: BTreeMap<LightId, String> = BTreeMap::new();
        for index in needed {
            let value = match &steps[index] {
                HostStep::Constant(value) => literal(value).unwrap_or_default(),
                HostStep::Param { id, ty, value } => match self.settings.parameter(*id, ty) {
                    Some(setting) => format!("settings.{}", setting.member),
                    None => self.fixed(index, ty, value)?,
                },
                HostStep::Context(context, None) => surrounding(*context)?.to_owned(),
                HostStep::Context(context, Some(id)) => {
                    let light = self.settings.light(id);
                    let light = light.ok_or_else(|| problem(tr!("no light `{id}`")))?;
                    if !lights.contains_key(id) {
                        let _ = writeln!(text, "    let {} = {};", light.member, light.in_world());
                        lights.insert(id.clone(), light.member.clone());
                    }
                    light_value(*context, &lights[id], light.light.kind)?
                }
                HostStep::Call { function, arguments } => {
                    let arguments: Vec<String> =
                        arguments.iter().map(|&argument| self.name(argument)).collect();
                    let call = format!("{function}({})", arguments.join(", "));
                    let wanted = self.wanted.get(&index).cloned();
                    let name = wanted.unwrap_or_else(|| format!("value_{index}"));
                    let _ = writeln!(text, "    let {name} = {call};");
                    name
                }
                HostStep::Member { value, index } => {
                    format!("{}.{}", self.name(*value), self.member(*value, *index)?)
                }
            };
            self.names.insert(index, value);
        }
        Ok(text)
    }

    /// A value that is not set from outside: a ramp, a curve.
    fn fixed(
        &mut self,
        index: usize,
        ty: &crate::library::Type,
        value: &'a interp::Value,
    ) -> Result<String, Diagnostic> {
        if let Some(text) = literal(value) {
            return Ok(text);
        }
        let of_type = |module: &naga::Module| {
            let mut types = module.types.iter();
            let (handle, _) = types.find(|(_, it)| it.name.as_deref() == Some(ty.wgsl()))?;
            composite(module, handle, value)
        };
        if let Some(text) = self.functions.as_ref().and_then(|it| of_type(&it.module)) {
            return Ok(text);
        }
        self.undeclared.insert(index, value);
        of_type(&self.host.shader.valid.module)
            .ok_or_else(|| problem(tr!("the value of step {index} cannot be written")))
    }

    /// Name of a member of the struct that a step gives.
    fn member(&self, step: usize, index: usize) -> Result<String, Diagnostic> {
        let lost = || problem(tr!("step {step} is no struct"));
        let HostStep::Call { function, .. } = &self.host.source.steps[step] else {
            return Err(lost());
        };
        let module = &self.functions.as_ref().ok_or_else(lost)?.module;
        let mut functions = module.functions.iter();
        let (_, found) =
            functions.find(|(_, it)| it.name.as_ref() == Some(function)).ok_or_else(lost)?;
        let result = found.result.as_ref().ok_or_else(lost)?;
        let TypeInner::Struct { members, .. } = &module.types[result.ty].inner else {
            return Err(lost());
        };
        members.get(index).and_then(|member| member.name.clone()).ok_or_else(lost)
    }
}

/// A value of a type as WGSL.
fn composite(
    module: &naga::Module,
    ty: Handle<naga::Type>,
    value: &interp::Value,
) -> Option<String> {
    let found = &module.types[ty];
    Some(match (&found.inner, value) {
        (TypeInner::Struct { members, .. }, interp::Value::Struct(parts)) => {
            let parts: Option<Vec<String>> = members
                .iter()
                .zip(parts)
                .map(|(member, part)| composite(module, member.ty, part))
                .collect();
            format!("{}({})", found.name.as_ref()?, parts?.join(", "))
        }
        (TypeInner::Array { base, .. }, interp::Value::Array(parts)) => {
            let parts: Option<Vec<String>> =
                parts.iter().map(|part| composite(module, *base, part)).collect();
            format!("array({})", parts?.join(", "))
        }
        _ => literal(value)?,
    })
}
