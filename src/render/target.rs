//! The textures that passes draw into.

use std::collections::HashMap;

use super::gpu::Gpu;
use crate::frame::{FramePlan, PassKind};

/// The picture's format: half floats, so that nothing is rounded before it is shown or written.
pub(super) const PICTURE: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Normals in camera axes and the object's number.
pub(super) const NORMALS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;
/// Distance in front of the eye, and curvature.
pub(super) const NUMBER: wgpu::TextureFormat = wgpu::TextureFormat::R32Float;
/// The depth buffer.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Normals, depth and curvature of one kind.
#[derive(Debug)]
pub(super) struct SurfaceTargets {
    pub(super) normals: wgpu::TextureView,
    pub(super) depths: wgpu::TextureView,
    pub(super) buffer: wgpu::TextureView,
    /// What passes over them have made.
    made: HashMap<PassKind, wgpu::TextureView>,
}

impl SurfaceTargets {
    /// What a pass over these normals draws into.
    pub(super) fn made(&self, kind: &PassKind) -> Option<&wgpu::TextureView> {
        self.made.get(kind)
    }
}

/// The textures of one picture size.
#[derive(Debug, Default)]
pub(super) struct Targets {
    key: Option<([u32; 2], u32)>,
    picture: Option<wgpu::Texture>,
    pub(super) multisampled: Option<wgpu::TextureView>,
    pub(super) depth: Option<wgpu::TextureView>,
    pub(super) surface: Option<SurfaceTargets>,
    pub(super) detail: Option<SurfaceTargets>,
}

impl Targets {
    /// Makes what `plan` needs and is not there; says whether anything was made anew.
    pub(super) fn fit(&mut self, gpu: &Gpu, plan: &FramePlan) -> bool {
        let key = (plan.size, plan.samples);
        let mut is_new = false;
        if self.key != Some(key) {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC;
            *self = Self {
                key: Some(key),
                picture: Some(texture(gpu, plan.size, gpu.picture, 1, usage)),
                multisampled: (plan.samples > 1)
                    .then(|| view(gpu, plan.size, gpu.picture, plan.samples)),
                depth: Some(view(gpu, plan.size, DEPTH, plan.samples)),
                surface: None,
                detail: None,
            };
            is_new = true;
        }
        let wants = |kind: PassKind| plan.passes.iter().any(|pass| pass.kind == kind);
        let slots =
            [(&mut self.surface, PassKind::Normals), (&mut self.detail, PassKind::DetailNormals)];
        for (slot, kind) in slots {
            if wants(kind) && slot.is_none() {
                *slot = Some(SurfaceTargets {
                    normals: view(gpu, plan.size, NORMALS, 1),
                    depths: view(gpu, plan.size, NUMBER, 1),
                    buffer: view(gpu, plan.size, DEPTH, 1),
                    made: HashMap::new(),
                });
                is_new = true;
            }
        }
        for pass in plan.passes.iter().filter(|pass| pass.kind.shader().is_some()) {
            let targets =
                if is_detail(&pass.kind) { self.detail.as_mut() } else { self.surface.as_mut() };
            if let Some(targets) = targets.filter(|targets| !targets.made.contains_key(&pass.kind))
            {
                targets
                    .made
                    .insert(pass.kind.clone(), view(gpu, plan.size, format_of(&pass.kind), 1));
                is_new = true;
            }
        }
        is_new
    }

    pub(super) fn picture(&self) -> Option<&wgpu::Texture> {
        self.picture.as_ref()
    }

    /// The targets of a normals pass, or of a pass over them.
    pub(super) fn of(&self, kind: &PassKind) -> Option<&SurfaceTargets> {
        if is_detail(kind) { self.detail.as_ref() } else { self.surface.as_ref() }
    }

    /// What a pass over normals draws into.
    pub(super) fn made(&self, kind: &PassKind) -> Option<&wgpu::TextureView> {
        self.of(kind)?.made(kind)
    }
}

fn is_detail(kind: &PassKind) -> bool {
    matches!(
        kind,
        PassKind::DetailNormals | PassKind::DetailCurvature | PassKind::SparseDetailCurvature
    )
}

/// The format of what a pass over normals draws.
pub(super) fn format_of(kind: &PassKind) -> wgpu::TextureFormat {
    if kind.channels() == 1 { NUMBER } else { NORMALS }
}

pub(super) fn texture(
    gpu: &Gpu,
    size: [u32; 2],
    format: wgpu::TextureFormat,
    sample_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("target"),
        size: wgpu::Extent3d {
            width: size[0].max(1),
            height: size[1].max(1),
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

fn view(gpu: &Gpu, size: [u32; 2], format: wgpu::TextureFormat, samples: u32) -> wgpu::TextureView {
    let mut usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    if samples == 1 && format != DEPTH {
        usage |= wgpu::TextureUsages::TEXTURE_BINDING;
    }
    texture(gpu, size, format, samples, usage).create_view(&wgpu::TextureViewDescriptor::default())
}
