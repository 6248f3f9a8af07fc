//! Hash of a frame plan: the same hash is the same picture.

use std::collections::HashMap;
use std::hash::Hash as _;
use std::sync::Arc;

use siphasher::sip128::{Hasher128 as _, SipHasher13};

use crate::compile::CompiledShader;
use crate::frame::{Casters, FramePlan};
use crate::geometry::Mesh;
use crate::layers::LayeredPlan;

/// Hasher of frame plans. It keeps what it has read of meshes and modules, for most frames have the
/// same.
#[derive(Debug, Default)]
pub struct PlanHasher {
    /// Hashes of what plans share, by address; what has been hashed is held, so that no address
    /// comes to name another thing, and meshes as long as anybody else holds them.
    meshes: HashMap<usize, (Arc<Mesh>, u128)>,
    modules: HashMap<usize, (Arc<CompiledShader>, u128)>,
    /// The casters of the last plan that had some.
    casters: Option<(Arc<Casters>, u128)>,
}

impl PlanHasher {
    /// The hash of everything that decides on a plan's picture, as 32 hexadecimal digits: it is the
    /// same in every run of this version. Executors differ in last digits, and are not in it.
    pub fn hash(&mut self, plan: &FramePlan) -> String {
        // A mesh that moves is another one in each frame.
        self.meshes.retain(|_, (mesh, _)| Arc::strong_count(mesh) > 1);
        let mut hasher = SipHasher13::new();
        env!("CARGO_PKG_VERSION").hash(&mut hasher);
        (plan.size, plan.samples).hash(&mut hasher);
        plan.backdrop.map(|color| color.map(f64::to_bits)).hash(&mut hasher);
        if let Some(ink) = &plan.ink {
            let numbers = ink.color.iter().chain(&ink.widths);
            numbers.for_each(|number| number.to_bits().hash(&mut hasher));
        }
        plan.view.uniform_bytes().hash(&mut hasher);
        plan.passes.iter().for_each(|pass| pass.id.hash(&mut hasher));
        plan.deferral.is_ok().hash(&mut hasher);
        if !plan.aovs.is_empty() {
            plan.aovs.hash(&mut hasher);
        }
        for draw in &plan.draws {
            self.mesh(&draw.mesh).hash(&mut hasher);
            (&draw.indices, draw.two_sided, draw.is_mirrored).hash(&mut hasher);
            draw.object_uniform.bytes.hash(&mut hasher);
            self.module(&draw.look).hash(&mut hasher);
            for (stage, module) in &draw.before {
                (stage, self.module(module)).hash(&mut hasher);
            }
            let mut uniforms: Vec<_> = draw.look_uniforms.iter().collect();
            uniforms.sort_unstable_by_key(|(stage, _)| **stage);
            for (stage, uniform) in uniforms {
                (stage, &uniform.bytes).hash(&mut hasher);
            }
            let images = draw.images.iter().chain(draw.images_before.values().flatten());
            images.for_each(|image| image.hash.hash(&mut hasher));
        }
        if let Some(casters) = &plan.casters {
            self.casters(casters).hash(&mut hasher);
        }
        if let Some(maps) = &plan.shadow_maps {
            maps.side.hash(&mut hasher);
            for layer in &maps.layers {
                (&layer.uniform.bytes, &layer.casters).hash(&mut hasher);
            }
            for caster in &maps.casters {
                (self.mesh(&caster.mesh), &caster.uniform.bytes).hash(&mut hasher);
            }
        }
        format!("{:032x}", hasher.finish128().as_u128())
    }

    /// The hash of a plan with layers.
    pub fn hash_layered(&mut self, plan: &LayeredPlan) -> String {
        let parts: Vec<String> = plan.plans().map(|plan| self.hash(plan)).collect();
        let mattes = plan.mattes_key();
        if parts.len() == 1 && mattes.is_none() {
            return parts.concat();
        }
        let of_all = hash_of(|hasher| (&parts, &mattes).hash(hasher));
        format!("{of_all:032x}")
    }

    fn mesh(&mut self, mesh: &Arc<Mesh>) -> u128 {
        let of_content = || {
            hash_of(|hasher| {
                mesh.positions.iter().for_each(|x| x.map(f32::to_bits).hash(hasher));
                mesh.normals.iter().for_each(|x| x.map(f32::to_bits).hash(hasher));
                mesh.tangents.iter().for_each(|x| x.map(f32::to_bits).hash(hasher));
                mesh.uvs.iter().for_each(|x| x.map(f32::to_bits).hash(hasher));
                mesh.colors.iter().for_each(|x| x.map(f32::to_bits).hash(hasher));
                mesh.indices.hash(hasher);
                if mesh.is_deformed() {
                    mesh.rest().iter().for_each(|x| x.map(f32::to_bits).hash(hasher));
                }
            })
        };
        let known = self.meshes.entry(Arc::as_ptr(mesh) as usize);
        known.or_insert_with(|| (mesh.clone(), of_content())).1
    }

    fn casters(&mut self, casters: &Arc<Casters>) -> u128 {
        if let Some((last, known)) = &self.casters
            && last.hash() == casters.hash()
        {
            return *known;
        }
        let texels = casters.texels();
        let hash =
            hash_of(|hasher| texels.iter().for_each(|texel| texel.map(f64::to_bits).hash(hasher)));
        self.casters = Some((casters.clone(), hash));
        hash
    }

    fn module(&mut self, module: &Arc<CompiledShader>) -> u128 {
        let known = self.modules.entry(Arc::as_ptr(module) as usize);
        known.or_insert_with(|| (module.clone(), hash_of(|hasher| module.wgsl.hash(hasher)))).1
    }
}

fn hash_of(write: impl FnOnce(&mut SipHasher13)) -> u128 {
    let mut hasher = SipHasher13::new();
    write(&mut hasher);
    hasher.finish128().as_u128()
}
