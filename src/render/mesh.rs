//! Meshes on the GPU: one buffer an attribute, so that a look binds only those that it reads.
//! Shared by all renderers of a device.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use wgpu::util::DeviceExt as _;

use super::gpu::Gpu;
use crate::compile::VertexAttribute;
use crate::geometry::Mesh;

/// Number of bytes that are uploaded at a time.
const UPLOAD: usize = 32 << 20;

/// A buffer of these contents, whose length is a multiple of 4. Long ones go piece by piece: what
/// is on its way to a GPU lies in the memory of the program once more.
fn upload(gpu: &Gpu, label: &str, contents: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    if contents.len() <= UPLOAD {
        let label = Some(label);
        let described = wgpu::util::BufferInitDescriptor { label, contents, usage };
        return gpu.device.create_buffer_init(&described);
    }
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: contents.len() as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    for (piece, place) in contents.chunks(UPLOAD).zip((0..).step_by(UPLOAD)) {
        gpu.queue.write_buffer(&buffer, place, piece);
        gpu.queue.submit([]);
        // Whoever draws next is told where the device is lost.
        gpu.wait().ok();
    }
    buffer
}

/// Buffers of a mesh.
#[derive(Debug)]
struct MeshBuffers {
    mesh: Weak<Mesh>,
    attributes: HashMap<VertexAttribute, wgpu::Buffer>,
    indices: wgpu::Buffer,
}

/// Meshes in use. Clones share them.
#[derive(Clone, Debug, Default)]
pub(super) struct Meshes(Arc<Mutex<MeshTable>>);

#[derive(Debug, Default)]
struct MeshTable {
    known: HashMap<usize, MeshBuffers>,
    uploads: u64,
}

impl Meshes {
    fn lock(&self) -> MutexGuard<'_, MeshTable> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Number of meshes that were uploaded so far.
    pub(super) fn uploads(&self) -> u64 {
        self.lock().uploads
    }

    /// Uploads the indices and the attributes of a mesh that are not on the GPU yet.
    pub(super) fn prepare(&self, gpu: &Gpu, mesh: &Arc<Mesh>, attributes: &[VertexAttribute]) {
        let buffer = |label: &str, contents: &[u8], usage| upload(gpu, label, contents, usage);
        let key = Arc::as_ptr(mesh) as usize;
        let mut table = self.lock();
        let MeshTable { known, uploads } = &mut *table;
        if known.get(&key).is_some_and(|known| known.mesh.strong_count() == 0) {
            // Another mesh now has the address of a mesh that was freed.
            known.remove(&key);
        }
        let buffers = known.entry(key).or_insert_with(|| {
            *uploads += 1;
            MeshBuffers {
                mesh: Arc::downgrade(mesh),
                attributes: HashMap::new(),
                indices: buffer(
                    "indices",
                    bytemuck::cast_slice(&mesh.indices),
                    wgpu::BufferUsages::INDEX,
                ),
            }
        });
        for &attribute in attributes {
            let colors;
            let contents: &[u8] = match attribute {
                VertexAttribute::Position => bytemuck::cast_slice(&mesh.positions),
                VertexAttribute::Rest => bytemuck::cast_slice(mesh.rest()),
                VertexAttribute::Normal => bytemuck::cast_slice(&mesh.normals),
                VertexAttribute::Tangent => bytemuck::cast_slice(&mesh.tangents),
                VertexAttribute::Uv => bytemuck::cast_slice(&mesh.uvs),
                VertexAttribute::Color => {
                    colors = mesh.all_colors();
                    bytemuck::cast_slice(&colors)
                }
            };
            let made = || buffer(attribute.name(), contents, wgpu::BufferUsages::VERTEX);
            buffers.attributes.entry(attribute).or_insert_with(made);
        }
    }

    /// Binds a prepared mesh.
    pub(super) fn bind(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        mesh: &Arc<Mesh>,
        attributes: &[VertexAttribute],
    ) {
        let table = self.lock();
        let Some(buffers) = table.known.get(&(Arc::as_ptr(mesh) as usize)) else { return };
        for (slot, attribute) in (0u32..).zip(attributes) {
            if let Some(buffer) = buffers.attributes.get(attribute) {
                pass.set_vertex_buffer(slot, buffer.slice(..));
            }
        }
        pass.set_index_buffer(buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
    }

    /// Drops the buffers of meshes that have no holder any more.
    pub(super) fn keep_recent(&self) {
        self.lock().known.retain(|_, buffers| buffers.mesh.strong_count() > 0);
    }

    /// Drops all buffers: some may have been created while the device had no room for them.
    pub(super) fn clear(&self) {
        self.lock().known.clear();
    }
}
