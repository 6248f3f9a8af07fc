//! Content of a plan as bytes, for hashes under which drawn pictures and proofs are kept.

use super::assets::Image;
use super::plan::{Draw, FramePlan};
use super::screen::ScreenModule;
use crate::compile::Uniform;
use crate::geometry::Mesh;
use crate::wgsl::code;

/// Receiver of bytes; the caller marks where one part ends and the next begins.
type Sink<'a> = &'a mut dyn FnMut(&[u8]);

impl FramePlan {
    /// Hands over everything that decides on the picture, modules (without comments), numbers,
    /// meshes and images, always in the same order. Plans with the same content make the same
    /// picture on one device.
    pub fn content(&self, sink: Sink<'_>) {
        sink(format!("{:?} {} {:?}", self.size, self.samples, self.backdrop).as_bytes());
        if let Some(ink) = &self.ink {
            sink(format!("{ink:?}").as_bytes());
        }
        sink(&self.view.uniform_bytes());
        for pass in &self.passes {
            sink(pass.id.label().as_bytes());
            if let Ok(Some(module)) = ScreenModule::of(pass.id) {
                sink(code(&module.text).as_bytes());
            }
        }
        self.draws.iter().for_each(|draw| draw.content(sink));
    }
}

impl Draw {
    fn content(&self, sink: Sink<'_>) {
        let how = (&self.indices, self.two_sided, self.is_mirrored, self.distance);
        sink(format!("{how:?}").as_bytes());
        sink(code(&self.look.wgsl).as_bytes());
        uniform(&self.object_uniform, sink);
        for stage in std::iter::once(self.look.stage).chain(self.before.keys().copied()) {
            if let Some(values) = self.look_uniforms.get(&stage) {
                uniform(values, sink);
            }
            if let Some(shader) = self.before.get(&stage) {
                sink(code(&shader.wgsl).as_bytes());
            }
            self.images_of(stage).iter().for_each(|one| image(one, sink));
        }
        mesh(&self.mesh, sink);
    }
}

fn uniform(values: &Uniform, sink: Sink<'_>) {
    let bytes: Vec<u8> = values.numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    sink(&bytes);
}

fn image(image: &Image, sink: Sink<'_>) {
    sink(format!("{:?} {} {:?}", image.size, image.layers, image.coding).as_bytes());
    sink(&image.bytes);
}

fn mesh(mesh: &Mesh, sink: Sink<'_>) {
    fn floats<const N: usize>(rows: &[[f32; N]]) -> Vec<u8> {
        rows.iter().flatten().flat_map(|number| number.to_le_bytes()).collect()
    }
    sink(&floats(&mesh.positions));
    sink(&floats(&mesh.normals));
    sink(&floats(&mesh.tangents));
    if mesh.is_deformed() {
        sink(&floats(mesh.rest()));
    }
    sink(&floats(&mesh.uvs));
    sink(&floats(&mesh.all_colors()));
    let indices: Vec<u8> = mesh.indices.iter().flat_map(|index| index.to_le_bytes()).collect();
    sink(&indices);
}
