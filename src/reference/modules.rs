//! Generated modules as shaders of the rasterizer: the interpreter runs their stages with the
//! bindings of a plan.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

use chiaro_locale::tr;

use super::executor::{PassImages, ShaderFactory};
use super::probe::PixelWatch;
use super::shader::{
    FragmentStage, LANES, QuadBatch, Shader, ShaderOutputs, Varying, VaryingInterpolation,
    VertexStage,
};
use super::texels::Texels;
use super::uniform;
use crate::diag::Diagnostic;
use crate::frame::{
    BindingKind, Casters, CompiledShader, Draw, FramePlan, Image, ImageShape, ImageUse, LightLayer,
    LightModule, MapCaster, PassId, ScreenModule, ScreenResource, ShadowMaps, VertexAttribute,
};
use crate::interp::{
    self, AddressMode, Bindings, BoundProgram, Filter, LanePort, Lanes, Precision, Program,
    ResourceKind, Sampler, Texture, TextureDimension, TextureLevel,
};
use crate::wgsl::ValidModule;
use chiaro_scene::geometry::Mesh;

/// Instructions that a batch of fragments may take for each texel of the casters, beside those of
/// any module. A pixel that is as wide as the mesh walks past all its triangles, for each light and
/// in each fragment apart: a picture of 2x2 pixels by six lights was measured to take 6,000.
const STEPS_A_CASTER: u64 = 1 << 14;

/// Both stages of a module.
#[derive(Debug)]
struct ModulePrograms {
    vertex: Program,
    fragment: Program,
}

impl ModulePrograms {
    /// `more_steps` are allowed beside those of any stage.
    fn compile(
        valid: &ValidModule,
        source: &str,
        observe: bool,
        more_steps: u64,
    ) -> Result<Self, Diagnostic> {
        let literals = interp::Literals::of(source);
        let stage = interp::FunctionOptions::stage(&literals);
        let step_limit = stage.step_limit.saturating_add(more_steps);
        let options = interp::FunctionOptions { observe, step_limit, ..stage };
        let stage = |name| Program::compile(&valid.module, name, options);
        Ok(Self { vertex: stage("vs_main")?, fragment: stage("fs_main")? })
    }
}

/// Every module of a plan, ready to run.
#[derive(Debug)]
pub struct Modules {
    precision: Precision,
    /// Modules of looks by the address of their shader; the shader is kept alive, so that no other
    /// can take its address.
    looks: HashMap<usize, (Arc<CompiledShader>, ModulePrograms)>,
    /// Modules of passes over the whole picture.
    screens: HashMap<PassId, (ScreenModule, ModulePrograms)>,
    images: HashMap<(u64, bool), Texture>,
    /// Modules of passes that draw what lights see.
    lights: HashMap<PassId, (LightModule, ModulePrograms)>,
    /// Triangles that cast shadows, where a look reads them.
    casters: Option<Texture>,
    /// Pixel whose fragments are watched, if any.
    watch: Option<PixelWatch>,
}

impl Modules {
    /// Compiles the modules that `plan` runs.
    ///
    /// # Errors
    /// Constructs that the interpreter cannot run, with their place in the source.
    pub fn new(plan: &FramePlan, precision: Precision) -> Result<Self, Diagnostic> {
        Self::with(plan, precision, None)
    }

    /// Compiles the modules, watching one pixel: see [`probe`](super::probe).
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(super) fn watching(
        plan: &FramePlan,
        precision: Precision,
        watch: PixelWatch,
    ) -> Result<Self, Diagnostic> {
        Self::with(plan, precision, Some(watch))
    }

    fn with(
        plan: &FramePlan,
        precision: Precision,
        watch: Option<PixelWatch>,
    ) -> Result<Self, Diagnostic> {
        let mut modules = Self {
            precision,
            looks: HashMap::new(),
            screens: HashMap::new(),
            lights: HashMap::new(),
            images: HashMap::new(),
            casters: plan.casters.as_deref().map(casters_texture).transpose()?,
            watch,
        };
        for draw in &plan.draws {
            for shader in draw.modules() {
                modules.add(shader, plan.casters.as_deref())?;
                for (image, used) in draw.images_of(shader.stage).iter().zip(&shader.needs.images) {
                    if let Entry::Vacant(place) =
                        modules.images.entry((image.hash, used.is_decoded))
                    {
                        place.insert(texture_of(image, used)?);
                    }
                }
            }
        }
        for pass in plan.passes.iter().map(|pass| pass.id) {
            if let Some(module) = ScreenModule::of(pass).map_err(first)? {
                let stages = ModulePrograms::compile(&module.valid, &module.text, false, 0)?;
                modules.screens.insert(pass, (module, stages));
            }
            if let Some(module) = LightModule::of(pass).map_err(first)? {
                let stages = ModulePrograms::compile(&module.valid, &module.text, false, 0)?;
                modules.lights.insert(pass, (module, stages));
            }
        }
        Ok(modules)
    }

    /// The values that were probed at the watched pixel.
    pub(super) fn into_found(self) -> Option<super::probe::ProbedFragment> {
        self.watch.and_then(PixelWatch::into_found)
    }

    fn add(
        &mut self,
        shader: &Arc<CompiledShader>,
        casters: Option<&Casters>,
    ) -> Result<(), Diagnostic> {
        if let Entry::Vacant(place) = self.looks.entry(address(shader)) {
            let observe = self.watch.is_some();
            let more_steps = steps_past(casters.filter(|_| reads_casters(shader)));
            let stages = ModulePrograms::compile(&shader.valid, &shader.wgsl, observe, more_steps)?;
            place.insert((shader.clone(), stages));
        }
        Ok(())
    }

    fn stages(&self, shader: &Arc<CompiledShader>) -> Result<&ModulePrograms, Diagnostic> {
        self.looks
            .get(&address(shader))
            .map(|(_, stages)| stages)
            .ok_or_else(|| missing(tr!("a module of another plan")))
    }

    /// Bindings of a draw's look, with the values of the plan.
    pub(super) fn bindings_of(
        &self,
        plan: &FramePlan,
        draw: &Draw,
        images: &PassImages,
    ) -> Result<Bindings, Diagnostic> {
        self.bindings_for(plan, draw, &draw.look, images)
    }

    /// The look of a draw with its [bindings](Self::bindings_of), but for `numbers` in the look's
    /// own uniform.
    pub(super) fn with_look<'a>(
        &'a self,
        draw: &'a Draw,
        mut bindings: Bindings,
        numbers: &[f64],
    ) -> Result<impl Shader + 'a, Diagnostic> {
        let stages = self.stages(&draw.look)?;
        for binding in
            draw.look.bindings.iter().filter(|binding| matches!(binding.kind, BindingKind::Look))
        {
            buffer(&mut bindings, stages, binding.binding, numbers);
        }
        BoundModule::new(stages, &bindings, self.precision, Some(&draw.mesh))
    }

    fn bindings_for(
        &self,
        plan: &FramePlan,
        draw: &Draw,
        shader: &Arc<CompiledShader>,
        images: &PassImages,
    ) -> Result<Bindings, Diagnostic> {
        let stages = self.stages(shader)?;
        let mut bindings = Bindings::new();
        for binding in &shader.bindings {
            let at = binding.binding;
            match &binding.kind {
                BindingKind::View => {
                    buffer(&mut bindings, stages, at, &plan.view.uniform_numbers());
                }
                BindingKind::Object => {
                    buffer(&mut bindings, stages, at, &draw.object_uniform.numbers);
                }
                BindingKind::Look => {
                    let numbers = draw
                        .look_uniforms
                        .get(&shader.stage)
                        .map(|uniform| uniform.numbers.as_slice());
                    buffer(&mut bindings, stages, at, numbers.unwrap_or_default());
                }
                BindingKind::Image(index) | BindingKind::Hcbtf(index) => {
                    let key = draw
                        .images_of(shader.stage)
                        .get(*index)
                        .zip(shader.needs.images.get(*index));
                    let texture = key
                        .and_then(|(image, used)| self.images.get(&(image.hash, used.is_decoded)));
                    bindings.texture(
                        0,
                        at,
                        texture.ok_or_else(|| missing(tr!("an image")))?.clone(),
                    );
                }
                BindingKind::Sampler(index) => {
                    let used =
                        shader.needs.images.get(*index).ok_or_else(|| missing(tr!("an image")))?;
                    bindings.sampler(0, at, sampler_of(used));
                }
                BindingKind::Pass(pass) if pass.is_of_lights() => {
                    let texels =
                        images.first(*pass).ok_or_else(|| missing(tr!("what lights see")))?;
                    bindings.texture(0, at, layers(texels)?);
                }
                BindingKind::Pass(pass) => {
                    bindings.texture(0, at, map(images.first(*pass), plan.size)?);
                }
                BindingKind::Casters => {
                    let texture =
                        self.casters.clone().ok_or_else(|| missing(tr!("type" => "casters")))?;
                    bindings.texture(0, at, texture);
                }
                BindingKind::Samples => {}
            }
        }
        Ok(bindings)
    }
}

/// Address of a shader, as a number and no pointer, so that modules may be shared by threads.
fn address(shader: &Arc<CompiledShader>) -> usize {
    Arc::as_ptr(shader).addr()
}

#[cold]
fn missing(what: &str) -> Diagnostic {
    Diagnostic::error("reference-plan", tr!("the plan lacks {what}"))
}

impl ShaderFactory for Modules {
    fn draw<'a>(
        &'a self,
        plan: &'a FramePlan,
        draw: &'a Draw,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        let stage = pass.stage().ok_or_else(|| missing(tr!("the module of a pass")))?;
        let shader = draw.module(stage).ok_or_else(|| missing(tr!("a module of a draw")))?;
        let stages = self.stages(shader)?;
        let bindings = self.bindings_for(plan, draw, shader, images)?;
        let mut bindable = BoundModule::new(stages, &bindings, self.precision, Some(&draw.mesh))?;
        let place = plan.draws.iter().position(|other| std::ptr::eq(other, draw));
        bindable.watch = self.watch.as_ref().zip(place).filter(|_| pass.writes_picture());
        Ok(Box::new(bindable))
    }

    fn screen<'a>(
        &'a self,
        plan: &'a FramePlan,
        pass: PassId,
        images: &'a PassImages,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        let (module, stages) =
            self.screens.get(&pass).ok_or_else(|| missing(tr!("the module of a pass")))?;
        let mut bindings = Bindings::new();
        for binding in &module.bindings {
            match &binding.holds {
                ScreenResource::Image(image) => {
                    let texels = images.get(*image).ok_or_else(|| misplaced(pass, image.pass))?;
                    bindings.texture(0, binding.binding, texture(texels)?);
                }
                ScreenResource::Numbers(numbers) => {
                    let numbers = plan.numbers(numbers);
                    buffer(&mut bindings, stages, binding.binding, &numbers);
                }
            }
        }
        Ok(Box::new(BoundModule::new(stages, &bindings, self.precision, None)?))
    }

    fn layer<'a>(
        &'a self,
        maps: &'a ShadowMaps,
        pass: PassId,
        layer: usize,
        images: &'a PassImages,
    ) -> Result<Vec<Box<dyn Shader + 'a>>, Diagnostic> {
        let read = self.lights.get(&pass).and_then(|(module, _)| module.reads);
        let first = match read {
            Some(read) => Some(layers(images.first(read).ok_or_else(|| misplaced(pass, read))?)?),
            None => None,
        };
        let layer = &maps.layers[layer];
        let shader = |number: &usize| {
            self.seen_by_light(pass, layer, &maps.casters[*number], first.as_ref())
        };
        layer.casters.iter().map(shader).collect()
    }
}

impl Modules {
    /// The shader of an object in a layer of a pass that draws what lights see.
    fn seen_by_light<'a>(
        &'a self,
        pass: PassId,
        layer: &LightLayer,
        caster: &'a MapCaster,
        first: Option<&Texture>,
    ) -> Result<Box<dyn Shader + 'a>, Diagnostic> {
        let (_, stages) =
            self.lights.get(&pass).ok_or_else(|| missing(tr!("the module of a pass")))?;
        let mut bindings = Bindings::new();
        buffer(&mut bindings, stages, 0, &layer.uniform.numbers);
        buffer(&mut bindings, stages, 1, &caster.uniform.numbers);
        if let Some(first) = first {
            bindings.texture(0, 2, first.clone());
        }
        Ok(Box::new(BoundModule::new(stages, &bindings, self.precision, Some(&caster.mesh))?))
    }
}

#[cold]
fn misplaced(pass: PassId, read: PassId) -> Diagnostic {
    let (pass, read) = (pass.label(), read.label());
    Diagnostic::error(
        "reference-plan",
        tr!("the plan has the pass `{pass}` before `{read}`, which it reads"),
    )
}

/// Binds a buffer in the shape that either stage asks for.
fn buffer(bindings: &mut Bindings, stages: &ModulePrograms, binding: u32, numbers: &[f64]) {
    let resources = stages.vertex.resources().iter().chain(stages.fragment.resources());
    for resource in resources.filter(|resource| (resource.group, resource.binding) == (0, binding))
    {
        if let ResourceKind::Buffer(shape) = &resource.kind {
            bindings.buffer(0, binding, uniform::value(shape, &mut numbers.iter().copied()));
        }
    }
}

/// Texture of the passes over normals for looks to read; flat if no pass ran.
fn map(curvature: Option<&Texels>, size: [u32; 2]) -> Result<Texture, Diagnostic> {
    match curvature {
        Some(curvature) => texture(curvature),
        None => texture(&Texels::new(size, 1)),
    }
}

fn texture(texels: &Texels) -> Result<Texture, Diagnostic> {
    // Missing channels read as 0 and a missing alpha as 1, as on a GPU.
    let pixels = texels.values.chunks_exact(texels.channels.max(1)).map(|pixel| {
        let channel =
            |index: usize| pixel.get(index).copied().unwrap_or(if index == 3 { 1.0 } else { 0.0 });
        [channel(0), channel(1), channel(2), channel(3)]
    });
    Texture::new(
        TextureDimension::D2,
        vec![TextureLevel::f64([texels.size[0], texels.size[1], 1], pixels.collect())],
    )
}

/// Layers, square and one below the other, as an array.
fn layers(texels: &Texels) -> Result<Texture, Diagnostic> {
    let [side, rows] = texels.size;
    let pixels =
        texels.values.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]);
    let size = [side, side, rows / side.max(1)];
    Texture::new(TextureDimension::D2, vec![TextureLevel::f64(size, pixels.collect())])
}

/// Layers that hold nothing, for looks that are evaluated without a scene.
pub(super) fn unseen() -> Result<Texture, Diagnostic> {
    layers(&Texels::new([1, 1], 4))
}

/// Triangles that cast shadows, with the objects' places in f64.
pub(super) fn casters_texture(casters: &Casters) -> Result<Texture, Diagnostic> {
    let [width, height] = casters.size();
    let level = TextureLevel::f64([width, height, 1], casters.texels());
    Texture::new(TextureDimension::D2, vec![level])
}

/// An image as the GPU samples it: colors are decoded before filtering if the look asks for that.
pub(super) fn texture_of(image: &Image, used: &ImageUse) -> Result<Texture, Diagnostic> {
    let size = [image.size[0], image.size[1], image.layers];
    let is_decoded = used.is_decoded && used.shape == ImageShape::Flat;
    if !is_decoded {
        return Texture::new(
            TextureDimension::D2,
            vec![TextureLevel::rgba8(size, image.rgba().into_owned())],
        );
    }
    let color = |byte: u8| crate::document::srgb_to_linear(f64::from(byte) / 255.0);
    let rgba = image.rgba();
    let texels = rgba.chunks_exact(4).map(|texel| {
        [color(texel[0]), color(texel[1]), color(texel[2]), f64::from(texel[3]) / 255.0]
    });
    Texture::new(TextureDimension::D2, vec![TextureLevel::f64(size, texels.collect())])
}

pub(super) fn sampler_of(used: &ImageUse) -> Sampler {
    let address = match used.wrap.as_str() {
        "clamp" => AddressMode::ClampToEdge,
        "mirror" => AddressMode::MirrorRepeat,
        _ => AddressMode::Repeat,
    };
    Sampler::new(address, if used.filter == "nearest" { Filter::Nearest } else { Filter::Linear })
}

fn reads_casters(shader: &CompiledShader) -> bool {
    shader.bindings.iter().any(|binding| matches!(binding.kind, BindingKind::Casters))
}

/// Instructions that walks past casters may take.
fn steps_past(casters: Option<&Casters>) -> u64 {
    let texels = casters.map_or(0, |casters| casters.size().into_iter().map(u64::from).product());
    STEPS_A_CASTER.saturating_mul(texels)
}

/// A module with all its bindings.
struct BoundModule<'a> {
    vertex: BoundProgram<'a>,
    fragment: BoundProgram<'a>,
    varyings: Vec<Varying>,
    mesh: Option<&'a Mesh>,
    /// The watch, with the index of the draw.
    watch: Option<(&'a PixelWatch, usize)>,
}

impl<'a> BoundModule<'a> {
    fn new(
        stages: &'a ModulePrograms,
        bindings: &Bindings,
        precision: Precision,
        mesh: Option<&'a Arc<Mesh>>,
    ) -> Result<Self, Diagnostic> {
        let bind = |program: &'a Program| program.bind(bindings, precision).map_err(first);
        let locations = by_location(stages.vertex.outputs());
        let varyings = locations
            .iter()
            .map(|port| Varying { components: port.size, interpolation: interpolation(port) });
        Ok(Self {
            vertex: bind(&stages.vertex)?,
            fragment: bind(&stages.fragment)?,
            varyings: varyings.collect(),
            mesh: mesh.map(Arc::as_ref),
            watch: None,
        })
    }
}

#[cold]
fn first(problems: Vec<Diagnostic>) -> Diagnostic {
    problems.into_iter().next().unwrap_or_else(|| missing(tr!("what a module reads")))
}

fn by_location(ports: &[LanePort]) -> Vec<&LanePort> {
    let mut ports: Vec<&LanePort> = ports.iter().filter(|port| port.location().is_some()).collect();
    ports.sort_by_key(|port| port.location());
    ports
}

fn interpolation(port: &LanePort) -> VaryingInterpolation {
    match &port.binding {
        Some(naga::Binding::Location {
            interpolation: Some(naga::Interpolation::Flat), ..
        }) => VaryingInterpolation::Flat,
        _ => VaryingInterpolation::Perspective,
    }
}

impl Shader for BoundModule<'_> {
    fn varyings(&self) -> &[Varying] {
        &self.varyings
    }

    fn vertices(&self) -> Box<dyn VertexStage + '_> {
        Box::new(Vertices { shader: self, lanes: None })
    }

    fn fragments(&self) -> Box<dyn FragmentStage + '_> {
        Box::new(Fragments { shader: self, lanes: None })
    }
}

struct Vertices<'a> {
    shader: &'a BoundModule<'a>,
    lanes: Option<Lanes<'a>>,
}

impl VertexStage for Vertices<'_> {
    fn shade(&mut self, vertices: &[u32], out: &mut [f64]) -> Result<(), Diagnostic> {
        let program = self.shader.vertex.program();
        let Some(mesh) = self.shader.mesh else { return Ok(()) };
        let lanes = match &mut self.lanes {
            Some(lanes) => lanes,
            none => none.insert(self.shader.vertex.lanes()?),
        };
        let clip = program
            .outputs()
            .iter()
            .find(|port| matches!(port.builtin(), Some(naga::BuiltIn::Position { .. })));
        let clip = clip.ok_or_else(|| missing(tr!("the position of a vertex")))?;
        let written: Vec<&LanePort> =
            std::iter::once(clip).chain(by_location(program.outputs())).collect();
        let stride: usize = written.iter().map(|port| port.size).sum();
        let mut row = [0.0; LANES];
        for (chunk, out) in vertices.chunks(LANES).zip(out.chunks_mut(LANES * stride)) {
            for port in program.inputs() {
                for component in 0..port.size {
                    for (cell, &vertex) in row.iter_mut().zip(chunk) {
                        *cell = attribute(mesh, port.location(), vertex as usize, component);
                    }
                    lanes.write(port, component, &row[..chunk.len()]);
                }
            }
            lanes.run(chunk.len())?;
            let components = written
                .iter()
                .flat_map(|port| (0..port.size).map(move |component| (*port, component)));
            for (place, (port, component)) in components.enumerate() {
                lanes.read(port, component, &mut row[..chunk.len()]);
                for (vertex, number) in row[..chunk.len()].iter().enumerate() {
                    out[vertex * stride + place] = *number;
                }
            }
        }
        Ok(())
    }
}

/// A component of a vertex's attribute, as the mesh holds it.
fn attribute(mesh: &Mesh, location: Option<u32>, vertex: usize, component: usize) -> f64 {
    let Some(attribute) = location.and_then(|at| VertexAttribute::ALL.get(at as usize)) else {
        return 0.0;
    };
    let component_of = |numbers: Option<&[f32]>| {
        numbers.and_then(|n| n.get(component)).copied().map_or(0.0, f64::from)
    };
    component_of(match attribute {
        VertexAttribute::Position => mesh.positions.get(vertex).map(|v| v.as_slice()),
        VertexAttribute::Rest => mesh.rest().get(vertex).map(|v| v.as_slice()),
        VertexAttribute::Normal => mesh.normals.get(vertex).map(|v| v.as_slice()),
        VertexAttribute::Tangent => mesh.tangents.get(vertex).map(|v| v.as_slice()),
        VertexAttribute::Uv => mesh.uvs.get(vertex).map(|v| v.as_slice()),
        VertexAttribute::Color => Some(mesh.colors.get(vertex).unwrap_or(&Mesh::WHITE).as_slice()),
    })
}

struct Fragments<'a> {
    shader: &'a BoundModule<'a>,
    lanes: Option<Lanes<'a>>,
}

impl FragmentStage for Fragments<'_> {
    fn shade(&mut self, batch: &QuadBatch, out: &mut ShaderOutputs) -> Result<(), Diagnostic> {
        let program = self.shader.fragment.program();
        let lanes = match &mut self.lanes {
            Some(lanes) => lanes,
            none => none.insert(self.shader.fragment.lanes()?),
        };
        let count = batch.lanes();
        let front: [f64; LANES] =
            std::array::from_fn(|lane| f64::from(u8::from(batch.front() >> lane & 1 == 1)));
        let starts = first_components(&self.shader.varyings);
        for port in program.inputs() {
            let start = port.location().and_then(|location| starts.get(location as usize));
            for component in 0..port.size {
                let row = match (port.builtin(), start) {
                    (Some(naga::BuiltIn::Position { .. }), _) => batch.position(component),
                    (Some(naga::BuiltIn::FrontFacing), _) => &front[..],
                    (_, Some(start)) => batch.varying(start + component),
                    _ => return Err(missing(tr!("what a fragment reads"))),
                };
                lanes.write(port, component, &row[..count]);
            }
        }
        let ran = lanes.run(count)?;
        out.discarded |= ran.discarded;
        if let Some((watch, draw)) = self.shader.watch {
            watch.look(batch, out.discarded, draw, lanes, program);
        }
        let components = by_location(program.outputs());
        let components = components
            .into_iter()
            .flat_map(|port| (0..port.size).map(move |component| (port, component)));
        for (channel, (port, component)) in components.enumerate().take(out.channels()) {
            lanes.read(port, component, &mut out.channel_mut(channel)[..count]);
        }
        Ok(())
    }
}

/// Index of each varying's first number among the numbers of all varyings.
fn first_components(varyings: &[Varying]) -> Vec<usize> {
    let begin =
        |at: &mut usize, varying: &Varying| Some(std::mem::replace(at, *at + varying.components));
    varyings.iter().scan(0, begin).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn walks_past_more_casters_may_take_longer() {
        assert_eq!(steps_past(None), 0, "others are given up as soon as ever");
        let [width, height] = Casters::default().size().map(u64::from);
        assert_eq!(steps_past(Some(&Casters::default())), width * height * STEPS_A_CASTER);
    }
}
