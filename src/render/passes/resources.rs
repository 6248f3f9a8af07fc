//! Resources that the module of a look reads besides its uniforms: images of files and of earlier
//! passes, what lights see, and the triangles that cast shadows.

use crate::casters::CastersTexture;
use crate::compile::{BindingKind, CompiledShader};
use crate::frame::{Draw, PassId, PassImage};
use crate::image::SampledImage;
use crate::target::Targets;
use crate::{RenderError, Renderer};

/// Resources of a module of a draw.
struct LookResources<'r> {
    images: Vec<SampledImage>,
    /// Layers of what lights see, by the pass that draws them.
    light_layers: Vec<(PassId, wgpu::TextureView)>,
    targets: &'r Targets,
    casters: Option<&'r CastersTexture>,
}

impl LookResources<'_> {
    /// The resource of a binding; `None` for uniforms, and where it was not made.
    fn get(&self, kind: &BindingKind) -> Option<wgpu::BindingResource<'_>> {
        match kind {
            BindingKind::Image(index) | BindingKind::Hcbtf(index) => {
                self.images.get(*index).map(SampledImage::texture)
            }
            BindingKind::Sampler(index) => self.images.get(*index).map(SampledImage::sampler),
            BindingKind::Pass(pass) => self.pass(*pass).map(wgpu::BindingResource::TextureView),
            BindingKind::Casters => self.casters.map(CastersTexture::resource),
            BindingKind::View | BindingKind::Object | BindingKind::Look | BindingKind::Samples => {
                None
            }
        }
    }

    /// The result of a pass: the layers of lights, or an image as large as the picture.
    fn pass(&self, pass: PassId) -> Option<&wgpu::TextureView> {
        let layers = self.light_layers.iter().find(|(known, _)| *known == pass);
        let image = || self.targets.image(PassImage { pass, output: 0 });
        layers.map(|(_, view)| view).or_else(image)
    }
}

impl Renderer {
    /// The bind group of a module of a draw, with the uniforms that `uniform_of` gives to bindings
    /// of the view, the object and the look.
    ///
    /// # Errors
    /// Images that cannot be uploaded, and bindings of which nothing was made.
    pub(crate) fn look_group<'u>(
        &self,
        (shader, draw): (&CompiledShader, &Draw),
        layout: &wgpu::BindGroupLayout,
        uniform_of: impl Fn(&BindingKind) -> Option<wgpu::BindingResource<'u>>,
    ) -> Result<wgpu::BindGroup, RenderError> {
        let images = draw.images_of(shader.stage);
        let resources = LookResources {
            images: self.images.of(&self.gpu, images, &shader.needs.images)?,
            light_layers: self.lights.views(&shader.needs),
            targets: &self.targets,
            casters: self.casters.as_ref(),
        };
        let mut entries = Vec::with_capacity(shader.bindings.len());
        for binding in &shader.bindings {
            let missing = || RenderError::unbound(&binding.name);
            let found = uniform_of(&binding.kind).or_else(|| resources.get(&binding.kind));
            let resource = found.ok_or_else(missing)?;
            entries.push(wgpu::BindGroupEntry { binding: binding.binding, resource });
        }
        let descriptor =
            wgpu::BindGroupDescriptor { label: Some("look"), layout, entries: &entries };
        Ok(self.gpu.device.create_bind_group(&descriptor))
    }
}
