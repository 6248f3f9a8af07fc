//! Values that are known before the fragment: computed in f64 on the CPU, read from the `Look`
//! uniform.

use std::collections::{BTreeSet, HashMap};
use std::sync::{Arc, LazyLock};

use glam::DMat3;
use indexmap::IndexMap;

use super::flatten::ParamId;
use super::intervals::{self, Ranges};
use super::layout::{StructLayout, ValueLayout};
use super::specialize::Function;
use super::value::typed_value;
use crate::diag::Diagnostic;
use crate::document::{LightInput, LightValues, OutputPort, Value};
use crate::ids::LightId;
use crate::interp::{self, Precision, Program};
use crate::library::{Context, ContextSource, Conversion, HostSurroundings, Rate, Type};
use crate::wgsl::{self, NamedSource, ValidModule};

/// Everything a host program reads: one object, in one view, at one time.
#[derive(Clone, Copy, Debug)]
pub struct HostInputs<'a> {
    /// Values in place of the document's, by index into
    /// [`CompiledShader::params`](crate::compile::CompiledShader::params).
    pub params: &'a HashMap<ParamId, Value>,
    /// The look's lights, resolved.
    pub lights: &'a IndexMap<LightId, LightValues>,
    /// Rotation from world to camera axes.
    pub camera_from_world: DMat3,
    /// Width and height in pixels.
    pub viewport: [f64; 2],
    /// Seconds.
    pub time: f64,
    /// Frames since the start of the time range.
    pub frame: f64,
    /// Counts objects from 0.
    pub object_id: f64,
}

/// A step of a host program; operands are indices of earlier steps.
#[derive(Clone, Debug)]
pub(super) enum ProgramStep {
    Constant(interp::Value),
    Param { id: ParamId, ty: Type, value: interp::Value },
    Context(Context, Option<LightId>),
    Call { program: Arc<Program>, callee: Callee, arguments: Vec<usize> },
    Member { value: usize, index: usize },
}

impl ProgramStep {
    /// The step's value, from the values of earlier steps.
    fn value<'v>(
        &self,
        inputs: &HostInputs<'_>,
        known: impl Fn(usize) -> &'v interp::Value,
    ) -> Result<interp::Value, Diagnostic> {
        Ok(match self {
            Self::Constant(value) => value.clone(),
            Self::Param { id, ty, value } => {
                let set = inputs.params.get(id).and_then(|value| typed_value(value, ty).ok());
                set.unwrap_or_else(|| value.clone())
            }
            Self::Context(context, light) => inputs.context(*context, light.as_ref()),
            Self::Call { program, arguments, .. } => {
                let arguments: Vec<_> =
                    arguments.iter().map(|&index| known(index).clone()).collect();
                program.call(&arguments, Precision::F64)?
            }
            Self::Member { value, index } => {
                let parts = known(*value).parts();
                parts
                    .and_then(|parts| parts.get(*index))
                    .cloned()
                    .unwrap_or(interp::Value::Float(0.0))
            }
        })
    }
}

/// The function that a step calls, so that its source can be found again.
#[derive(Clone, Debug)]
pub(super) enum Callee {
    Function(Function),
    Conversion { from: Type, to: Type },
}

/// A member of the `Look` uniform.
#[derive(Clone, Debug)]
pub struct UniformMember {
    /// Name in the generated struct.
    pub name: String,
    /// Type, as the graph knows it.
    pub ty: Type,
    /// The node that it belongs to, and what of it.
    pub origin: String,
    /// The step that computes it, as [`HostProgram::source`] lists them.
    pub step: usize,
    /// First byte in the uniform.
    pub offset: u32,
    /// The place in an array, of a member that differs from light to light.
    pub place: Option<ArrayPlace>,
}

/// The place of a member in an array of the uniform.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ArrayPlace {
    /// Name of the array.
    pub array: String,
    /// Name of the struct of its elements.
    pub element: String,
    /// Index of the element.
    pub index: usize,
    /// Number of elements.
    pub count: usize,
    /// Name of the member in the element.
    pub field: String,
}

impl ArrayPlace {
    /// First byte in the uniform, and layout.
    fn find(&self, uniform: &StructLayout) -> Option<(u32, ValueLayout)> {
        let (array, layout) = uniform.member(&self.array)?;
        let ValueLayout::Array { stride, element } = layout else { return None };
        let ValueLayout::Struct(element) = element.as_ref() else { return None };
        let (field, layout) = element.member(&self.field)?;
        Some((array + stride * u32::try_from(self.index).ok()? + field, layout.clone()))
    }
}

/// An output that drives keys.
#[derive(Clone, Debug)]
pub struct HostDriver {
    /// Name in the document.
    pub wire: OutputPort,
    /// The step that computes it, as a number.
    pub step: usize,
}

/// Computes the members of the `Look` uniform.
#[derive(Clone, Debug, Default)]
pub struct HostProgram {
    pub(super) steps: Vec<ProgramStep>,
    /// The wired values that drive keys.
    pub drivers: Vec<HostDriver>,
    /// The sets of direction keys in the order in which they take effect.
    pub key_order: Vec<usize>,
    /// The uniform's members, in order; empty where the module has no `Look` uniform.
    pub members: Vec<UniformMember>,
    /// The size of the uniform in bytes, a multiple of 16; 0 where there is none.
    pub size: u32,
    /// By member.
    layouts: Vec<ValueLayout>,
}

impl HostProgram {
    /// Takes offsets from the `Look` struct of a validated module.
    pub(super) fn with_layout(mut self, module: &naga::Module) -> Self {
        if let Some(layout) = StructLayout::of(module, "Look") {
            for member in &mut self.members {
                let found = match &member.place {
                    None => layout.member(&member.name).map(|(at, own)| (at, own.clone())),
                    Some(place) => place.find(&layout),
                };
                let (offset, own) = found.unwrap_or((0, ValueLayout::Scalar));
                member.offset = offset;
                self.layouts.push(own);
            }
            self.size = layout.size.next_multiple_of(16);
        }
        self
    }

    /// The lights of which it reads anything.
    pub fn lights(&self) -> impl Iterator<Item = &LightId> {
        self.steps.iter().filter_map(|step| match step {
            ProgramStep::Context(context, light) if context.light_input().is_some() => {
                light.as_ref()
            }
            _ => None,
        })
    }

    /// The lights whose shadows the module draws: those whose casters or shadow maps it reads.
    pub fn shadowing_lights(&self) -> impl Iterator<Item = &LightId> {
        self.lights_of(LightInput::is_shadow)
    }

    /// The lights whose shadow maps it reads.
    pub fn mapped_lights(&self) -> impl Iterator<Item = &LightId> {
        self.lights_of(LightInput::is_shadow_map)
    }

    /// The lights of which it reads such an input.
    fn lights_of(&self, is_wanted: fn(LightInput) -> bool) -> impl Iterator<Item = &LightId> {
        self.steps.iter().filter_map(move |step| match step {
            ProgramStep::Context(context, light)
                if context.light_input().is_some_and(is_wanted) =>
            {
                light.as_ref()
            }
            _ => None,
        })
    }

    /// True if a step reads anything that differs between objects of the same values and lights.
    pub fn reads_object(&self) -> bool {
        self.steps.iter().any(|step| match step {
            ProgramStep::Context(context, _) => {
                matches!(context.row().source, ContextSource::Host { rate: Rate::Object, .. })
            }
            _ => false,
        })
    }

    /// Runs every step.
    ///
    /// # Errors
    /// A node of the project that runs without end.
    pub fn run(&self, inputs: &HostInputs<'_>) -> Result<Vec<interp::Value>, Diagnostic> {
        let mut values: Vec<interp::Value> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            values.push(step.value(inputs, |index| &values[index])?);
        }
        Ok(self.members.iter().map(|member| values[member.step].clone()).collect())
    }

    /// The value of an output that drives keys, by the values and lights of a frame; NaN
    /// counts as 0.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn driver(&self, driver: &HostDriver, inputs: &HostInputs<'_>) -> Result<f64, Diagnostic> {
        let mut values: HashMap<usize, interp::Value> = HashMap::new();
        for index in self.steps_of(driver) {
            let value = self.steps[index].value(inputs, |index| &values[&index])?;
            values.insert(index, value);
        }
        let value = values.get(&driver.step).and_then(interp::Value::as_f64).unwrap_or(0.0);
        Ok(if value.is_nan() { 0.0 } else { value })
    }

    /// The inputs that an output depends on.
    pub fn params_of(&self, driver: &HostDriver) -> Vec<ParamId> {
        let param = |index: usize| {
            if let ProgramStep::Param { id, .. } = &self.steps[index] { Some(*id) } else { None }
        };
        self.steps_of(driver).into_iter().filter_map(param).collect()
    }

    /// The steps that an output depends on, in order.
    fn steps_of(&self, driver: &HostDriver) -> BTreeSet<usize> {
        let (mut found, mut open) = (BTreeSet::new(), vec![driver.step]);
        while let Some(index) = open.pop() {
            if !found.insert(index) {
                continue;
            }
            match &self.steps[index] {
                ProgramStep::Call { arguments, .. } => open.extend(arguments),
                ProgramStep::Member { value, .. } => open.push(*value),
                ProgramStep::Constant(_) | ProgramStep::Param { .. } | ProgramStep::Context(..) => {
                }
            }
        }
        found
    }

    /// The `Look` uniform.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn uniform(&self, inputs: &HostInputs<'_>) -> Result<Uniform, Diagnostic> {
        let mut uniform = Uniform { bytes: vec![0; self.size as usize], numbers: Vec::new() };
        self.write(inputs, 0, &mut uniform)?;
        Ok(uniform)
    }

    /// Writes the `Look` struct at byte `at`, and its numbers after those that are there.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn write(
        &self,
        inputs: &HostInputs<'_>,
        at: usize,
        uniform: &mut Uniform,
    ) -> Result<(), Diagnostic> {
        let places = self.members.iter().zip(&self.layouts);
        for (value, (member, layout)) in self.run(inputs)?.iter().zip(places) {
            layout.write(value, at + member.offset as usize, &mut uniform.bytes);
            push_numbers(value, &mut uniform.numbers);
        }
        Ok(())
    }
}

/// The content of a uniform, as a GPU takes it and as it is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uniform {
    /// Bytes as WGSL lays them out, in f32.
    pub bytes: Vec<u8>,
    /// Every scalar in order, matrices by columns, without padding, in f64: what the reference
    /// reads.
    pub numbers: Vec<f64>,
}

/// Every scalar of a value, within what an f32 can hold; NaN, which only a project's own node may
/// give, becomes 0, as it does in the bytes.
pub fn push_numbers(value: &interp::Value, numbers: &mut Vec<f64>) {
    match value.parts() {
        Some(parts) => parts.iter().for_each(|part| push_numbers(part, numbers)),
        None => {
            let finite = |x: &f64| {
                if x.is_nan() { 0.0 } else { x.clamp(f64::from(f32::MIN), f64::from(f32::MAX)) }
            };
            numbers.extend(value.components().unwrap_or_default().iter().map(finite));
        }
    }
}

impl HostInputs<'_> {
    /// A number that the host knows, as shaders are promised it.
    fn context(&self, context: Context, light: Option<&LightId>) -> interp::Value {
        let row = context.row();
        let value = match row.source {
            ContextSource::Host { value, .. } => value(&self.surroundings()),
            ContextSource::Light(input) => {
                let light = light.and_then(|id| self.lights.get(id));
                light.map_or_else(|| input.value(&LightValues::default()), |l| input.value(l))
            }
            // Of fragment rate, and so never a step of the host.
            ContextSource::Fragment { .. }
            | ContextSource::Pass { .. }
            | ContextSource::Scene { .. } => interp::Value::Float(0.0),
        };
        row.bounds.kept_value(value)
    }

    fn surroundings(&self) -> HostSurroundings {
        HostSurroundings {
            camera_from_world: self.camera_from_world,
            viewport: self.viewport,
            time: self.time,
            frame: self.frame,
            object_id: self.object_id,
        }
    }
}

/// All conversions as WGSL functions, so that the CPU runs the same text that the shader inlines.
struct Conversions {
    valid: Option<ValidModule>,
    functions: HashMap<(Type, Type), (String, Arc<Program>)>,
}

static CONVERSIONS: LazyLock<Conversions> = LazyLock::new(|| {
    use Type::{Angle, Bool, Color, Composite, Float, Int, Vec2, Vec3, Vec4};
    let types = [Float, Int, Bool, Vec2, Vec3, Vec4, Color, Composite, Angle];
    let mut text = "import chiaro::convert;\n".to_owned();
    let mut pairs = Vec::new();
    for from in &types {
        for to in &types {
            if let Some(conversion @ Conversion::Template(_)) = from.convert_to(to) {
                let body = conversion.apply("value");
                let name = format!("conversion_{}", pairs.len());
                text += &format!(
                    "fn {name}(value: {}) -> {} {{ return {body}; }}\n",
                    from.wgsl(),
                    to.wgsl()
                );
                pairs.push((from.clone(), to.clone(), name));
            }
        }
    }
    let linked = wgsl::link(&[NamedSource { name: "conversions", text: &text }]).ok();
    let valid = linked.as_ref().and_then(|linked| wgsl::parse(&linked.text).ok());
    let literals = linked.map(|linked| interp::Literals::of(linked.text));
    let compiled = |(from, to, name): (Type, Type, String)| {
        let options = interp::FunctionOptions {
            literals: literals.as_ref(),
            ..interp::FunctionOptions::default()
        };
        let program = Program::compile(&valid.as_ref()?.module, &name, options).ok()?;
        Some(((from, to), (name, Arc::new(program))))
    };
    let functions = pairs.into_iter().filter_map(compiled).collect();
    Conversions { valid, functions }
});

/// The program that runs a conversion on the CPU.
pub(super) fn conversion_program(from: &Type, to: &Type) -> Option<Arc<Program>> {
    CONVERSIONS.functions.get(&(from.clone(), to.clone())).map(|(_, program)| program.clone())
}

/// The range of a conversion's result.
pub(super) fn conversion_ranges(from: &Type, to: &Type, ranges: &Ranges) -> Option<Ranges> {
    let Some((name, _)) = CONVERSIONS.functions.get(&(from.clone(), to.clone())) else {
        // Between two names of one type.
        return (from.width().is_some() && from.width() == to.width()).then(|| ranges.clone());
    };
    intervals::call_plain(CONVERSIONS.valid.as_ref()?, name, std::slice::from_ref(ranges))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_conversion_runs_on_the_cpu() {
        let color = conversion_program(&Type::Float, &Type::Color).unwrap();
        let value = color.call(&[interp::Value::Float(0.25)], Precision::F64).unwrap();
        assert_eq!(value, interp::Value::vec(&[0.25, 0.25, 0.25, 1.0]));
        let types = [
            Type::Float,
            Type::Int,
            Type::Bool,
            Type::Vec3,
            Type::Color,
            Type::Composite,
            Type::Angle,
        ];
        for from in &types {
            for to in &types {
                let is_template = matches!(from.convert_to(to), Some(Conversion::Template(_)));
                assert_eq!(is_template, conversion_program(from, to).is_some(), "{from} to {to}");
            }
        }
    }

    #[test]
    fn constants_of_the_library_are_read_at_f64() {
        let module = &crate::library::Library::built_in().nodes["color_luminance"].module;
        let program = module.program("color_luminance").unwrap();
        let green =
            program.call(&[interp::Value::vec(&[0.0, 1.0, 0.0, 1.0])], Precision::F64).unwrap();
        assert_eq!(green, interp::Value::Float(0.7152), "and not the nearest f32");
        assert_ne!(f64::from(0.7152_f32), 0.7152);
    }
}
