//! Values that are known before the fragment: computed in f64 on the CPU, read from the `Look`
//! uniform.

use std::collections::{BTreeSet, HashMap};
use std::sync::{Arc, LazyLock};

use glam::{DMat3, DQuat, DVec3};
use indexmap::IndexMap;

use super::flatten::ParamId;
use super::intervals::{self, Ranges};
use super::layout::StructLayout;
use super::specialize::Function;
use super::value::typed_value;
use crate::diag::Diagnostic;
use crate::document::{
    Light, LightField, LightInput, LightKind, LightQuantity, LightSpace, OutputPort, Value,
};
use crate::ids::LightId;
use crate::interp::{self, Precision, Program};
use crate::library::{Context, ContextSource, Conversion, HostSurroundings, Type};
use crate::wgsl::{self, Source, Valid};

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

/// The greatest intensity: finite in f32, whatever a file says.
pub const MAX_INTENSITY: f64 = 1e30;

/// The least half distance and range above 0, in scene units. An f32 has a lesser one as 0 or as a
/// denormal, which a GPU may take for 0; and 0 means no fading and no end, the opposite of what was
/// written.
pub const MIN_LIGHT_DISTANCE: f64 = 1e-30;

/// A light in world space, ready for the shader.
#[derive(Clone, Debug, PartialEq)]
pub struct LightValues {
    /// The fields of the light as shaders take them: directions of length 1 and places in world
    /// space, intensities up to [`MAX_INTENSITY`], distances 0 or [`MIN_LIGHT_DISTANCE`] and more.
    world: Light,
    /// Unit, toward a directional light, in its own frame.
    pub own_direction: DVec3,
    /// Rotation from world space to the light's own frame.
    pub own_from_world: DMat3,
    /// Cosines of the inner and outer half-angles.
    pub cone: [f64; 2],
    /// The kind of light.
    pub kind: LightKind,
}

impl LightValues {
    /// Resolves `light` under the illumination frame (world from illumination) and the camera
    /// (camera from world).
    pub fn new(light: &Light, illumination: DQuat, camera_from_world: DMat3) -> Self {
        let world_from_own = match light.space {
            LightSpace::Illumination => DMat3::from_quat(illumination),
            LightSpace::World => DMat3::IDENTITY,
            LightSpace::Camera => camera_from_world.transpose(),
        };
        let mut world = light.clone();
        for field in LightField::ALL {
            resolve(field.quantity(), field.numbers_mut(&mut world), world_from_own);
        }
        Self {
            own_direction: unit(&light.direction),
            own_from_world: world_from_own.transpose(),
            cone: [world.inner.clamp(0.0, world.outer).cos(), world.outer.cos()],
            kind: light.kind,
            world,
        }
    }

    /// Unit, toward a directional light, world space.
    pub fn direction(&self) -> DVec3 {
        self.world.direction.into()
    }

    /// World space.
    pub fn position(&self) -> DVec3 {
        self.world.position.into()
    }

    /// Unit, from the light outward, world space.
    pub fn aim(&self) -> DVec3 {
        self.world.aim.into()
    }

    /// Straight RGB.
    pub fn color(&self) -> DVec3 {
        self.world.color.into()
    }

    /// 0 to [`MAX_INTENSITY`].
    pub fn intensity(&self) -> f64 {
        self.world.intensity
    }

    /// The distance beyond which nothing of it is left: 0, or [`MIN_LIGHT_DISTANCE`] and more.
    pub fn range(&self) -> f64 {
        self.world.range
    }

    /// Lets it shine from a direction: unit, world space.
    pub fn shine_from(&mut self, direction: DVec3) {
        self.world.direction = direction.into();
        self.own_direction = self.own_from_world * direction;
    }

    /// Puts it at a place, a spot light shining along `aim`: unit, world space.
    pub fn stand_at(&mut self, position: DVec3, aim: DVec3) {
        self.world.position = position.into();
        if self.kind == LightKind::Spot {
            self.world.aim = aim.into();
        }
    }

    fn input(&self, input: LightInput) -> interp::Value {
        match input {
            LightInput::Field(field) => match field.numbers(&self.world) {
                [number] => interp::Value::Float(*number),
                numbers => interp::Value::vec(numbers),
            },
            LightInput::OwnDirection => interp::Value::vec(&self.own_direction.to_array()),
            LightInput::OwnFromWorld => {
                interp::Value::matrix(&self.own_from_world.to_cols_array_2d())
            }
            LightInput::Cone => interp::Value::vec(&self.cone),
            LightInput::Fading => interp::Value::vec(&[self.world.half_distance, self.world.range]),
        }
    }
}

fn unit(direction: &[f64]) -> DVec3 {
    DVec3::from_slice(direction).try_normalize().unwrap_or(DVec3::Z)
}

/// Brings the numbers of a light's field to what shaders take. What is no number counts as 0.
fn resolve(quantity: LightQuantity, numbers: &mut [f64], world_from_own: DMat3) {
    match quantity {
        LightQuantity::Direction => {
            (world_from_own * unit(numbers)).write_to_slice(numbers);
        }
        LightQuantity::Position => {
            (world_from_own * DVec3::from_slice(numbers)).write_to_slice(numbers);
        }
        LightQuantity::Color => {}
        LightQuantity::Factor => numbers.iter_mut().for_each(|x| {
            *x = if x.is_nan() { 0.0 } else { x.clamp(0.0, MAX_INTENSITY) };
        }),
        LightQuantity::Angle => numbers.iter_mut().for_each(|x| {
            *x = if x.is_nan() { 0.0 } else { x.clamp(0.0, std::f64::consts::PI) };
        }),
        LightQuantity::Distance => numbers.iter_mut().for_each(|x| *x = light_distance(*x)),
    }
}

/// A distance of a light as the f32 of a shader and the f64 of the reference both hold it; what is
/// no number counts as 0.
fn light_distance(distance: f64) -> f64 {
    if distance > 0.0 { distance.clamp(MIN_LIGHT_DISTANCE, f64::from(f32::MAX)) } else { 0.0 }
}

/// A step of a host program; operands are indices of earlier steps.
#[derive(Clone, Debug)]
pub(super) enum Step {
    Constant(interp::Value),
    Param { id: ParamId, ty: Type, value: interp::Value },
    Context(Context, Option<LightId>),
    Call { program: Arc<Program>, callee: Callee, arguments: Vec<usize> },
    Member { value: usize, index: usize },
}

impl Step {
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
    /// Its name in the generated struct.
    pub name: String,
    /// Its type, as the graph knows it.
    pub ty: Type,
    /// The node that it belongs to, and what of it.
    pub origin: String,
    /// The step that computes it, as [`HostProgram::source`] lists them.
    pub step: usize,
    /// Its first byte in the uniform.
    pub offset: u32,
}

/// An output that drives keys.
#[derive(Clone, Debug)]
pub struct HostDriver {
    /// As the document names it.
    pub wire: OutputPort,
    /// The step that computes it, as a number.
    pub step: usize,
}

/// Computes the members of the `Look` uniform.
#[derive(Clone, Debug, Default)]
pub struct HostProgram {
    pub(super) steps: Vec<Step>,
    /// The wired values that drive keys.
    pub drivers: Vec<HostDriver>,
    /// The sets of direction keys in the order in which they take effect.
    pub key_order: Vec<usize>,
    /// The uniform's members, in order; empty where the module has no `Look` uniform.
    pub members: Vec<UniformMember>,
    /// The size of the uniform in bytes, a multiple of 16; 0 where there is none.
    pub size: u32,
    layout: StructLayout,
}

impl HostProgram {
    /// Takes offsets from the `Look` struct of a validated module.
    pub(super) fn with_layout(mut self, module: &naga::Module) -> Self {
        if let Some(layout) = StructLayout::of(module, "Look") {
            for (member, (_, offset, _)) in self.members.iter_mut().zip(&layout.members) {
                member.offset = *offset;
            }
            self.size = layout.size.next_multiple_of(16);
            self.layout = layout;
        }
        self
    }

    /// The lights of which it reads anything.
    pub fn lights(&self) -> impl Iterator<Item = &LightId> {
        self.steps.iter().filter_map(|step| match step {
            Step::Context(context, light) if context.light_input().is_some() => light.as_ref(),
            _ => None,
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
            if let Step::Param { id, .. } = &self.steps[index] { Some(*id) } else { None }
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
                Step::Call { arguments, .. } => open.extend(arguments),
                Step::Member { value, .. } => open.push(*value),
                Step::Constant(_) | Step::Param { .. } | Step::Context(..) => {}
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
        for (value, (_, offset, layout)) in self.run(inputs)?.iter().zip(&self.layout.members) {
            layout.write(value, at + *offset as usize, &mut uniform.bytes);
            push_numbers(value, &mut uniform.numbers);
        }
        Ok(())
    }
}

/// The content of a uniform, as a GPU takes it and as it is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uniform {
    /// As WGSL lays it out, in f32.
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
    fn context(&self, context: Context, light: Option<&LightId>) -> interp::Value {
        match context.row().source {
            ContextSource::Host { value, .. } => value(&self.surroundings()),
            ContextSource::Light(input) => light.and_then(|id| self.lights.get(id)).map_or_else(
                || {
                    LightValues::new(&Light::default(), DQuat::IDENTITY, DMat3::IDENTITY)
                        .input(input)
                },
                |l| l.input(input),
            ),
            // Of fragment rate, and so never a step of the host.
            ContextSource::Fragment { .. } | ContextSource::Pass { .. } => {
                interp::Value::Float(0.0)
            }
        }
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
    valid: Option<Valid>,
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
    let linked = wgsl::link(&[Source { name: "conversions", text: &text }]).ok();
    let valid = linked.as_ref().and_then(|linked| wgsl::parse(&linked.text).ok());
    let compiled = |(from, to, name): (Type, Type, String)| {
        let options =
            interp::Options { source: Some(&linked.as_ref()?.text), ..interp::Options::default() };
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
    fn distances_of_lights_mean_the_same_in_f32_and_f64() {
        let fading = |half_distance, range| {
            let light = Light { half_distance, range, ..Light::default() };
            let world = LightValues::new(&light, DQuat::IDENTITY, DMat3::IDENTITY).world;
            [world.half_distance, world.range]
        };
        for tiny in [1e-300, f64::MIN_POSITIVE, 5e-324, 1e-40, f64::from(f32::MIN_POSITIVE)] {
            for distance in [fading(tiny, 0.0)[0], fading(0.0, tiny)[1]] {
                assert!(
                    (distance as f32).is_normal() && distance == MIN_LIGHT_DISTANCE,
                    "{tiny}: {distance}"
                );
                // The quotient in `light_fading` stays a number in f32, across all distances that a
                // scene may hold.
                assert!((4e6_f32 / distance as f32).is_finite());
            }
        }
        assert_eq!(fading(0.0, -1.0), [0.0; 2], "no fading and no end");
        assert_eq!(fading(f64::NAN, 2.5), [0.0, 2.5]);
        assert_eq!(fading(f64::INFINITY, 1e-30), [f64::from(f32::MAX), 1e-30]);
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
