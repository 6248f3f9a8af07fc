//! Meshes of deferred looks on the GPU: vertices in the order that numbers triangles, and the same
//! mesh as textures, which software Vulkan reads several times as fast as buffers.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use wgpu::util::{DeviceExt as _, TextureDataOrder};

use crate::compile::VertexAttribute;
use crate::frame::{MESH_TEXELS_PER_ROW, NumberedMesh};
use crate::geometry::Mesh;
use crate::gpu::Gpu;

/// Bytes of a texel: four numbers.
const TEXEL: usize = 16;

/// Buffers and textures of a mesh. Clones share them.
#[derive(Clone, Debug)]
pub(super) struct NumberedBuffers {
    pub(super) indices: wgpu::Buffer,
    pub(super) attributes: HashMap<VertexAttribute, wgpu::Buffer>,
    pub(super) corners: wgpu::TextureView,
    pub(super) texels: HashMap<VertexAttribute, wgpu::TextureView>,
    order: Arc<NumberedMesh>,
}

/// Buffers of meshes, by the address of each, with the mesh as long as somebody holds it.
type BuffersByMesh = HashMap<usize, (Weak<Mesh>, NumberedBuffers)>;

/// Meshes in use. Clones share them.
#[derive(Clone, Debug, Default)]
pub(crate) struct NumberedMeshes(Arc<Mutex<BuffersByMesh>>);

impl NumberedMeshes {
    /// The buffers of a mesh with the attributes that are drawn, and textures of those that are
    /// read.
    pub(super) fn get(
        &self,
        gpu: &Gpu,
        mesh: &Arc<Mesh>,
        drawn: &[VertexAttribute],
        read: &[VertexAttribute],
    ) -> NumberedBuffers {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|_, (mesh, _)| mesh.strong_count() > 0);
        let made = || (Arc::downgrade(mesh), NumberedBuffers::new(gpu, mesh));
        let (_, buffers) = known.entry(Arc::as_ptr(mesh) as usize).or_insert_with(made);
        for attribute in drawn {
            let NumberedBuffers { attributes, order, .. } = &mut *buffers;
            attributes.entry(*attribute).or_insert_with(|| {
                let (numbers, count) = numbers_of(mesh, *attribute);
                let vertex = |at: &u32| &numbers[*at as usize * count..][..count];
                let contents: Vec<f32> = order.vertices.iter().flat_map(vertex).copied().collect();
                buffer(gpu, bytemuck::cast_slice(&contents), wgpu::BufferUsages::VERTEX)
            });
        }
        for attribute in read {
            buffers.texels.entry(*attribute).or_insert_with(|| {
                let (numbers, count) = numbers_of(mesh, *attribute);
                texture(gpu, bytemuck::cast_slice(numbers), count, wgpu::TextureFormat::Rgba32Float)
            });
        }
        buffers.clone()
    }

    /// Drops the buffers of meshes that have no holder any more.
    pub(crate) fn keep_recent(&self) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|_, (mesh, _)| mesh.strong_count() > 0);
    }

    /// Drops all buffers.
    pub(crate) fn clear(&self) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }
}

impl NumberedBuffers {
    fn new(gpu: &Gpu, mesh: &Mesh) -> Self {
        let order = NumberedMesh::new(&mesh.indices);
        let indices = buffer(gpu, bytemuck::cast_slice(&order.indices), wgpu::BufferUsages::INDEX);
        let corners = bytemuck::cast_slice(&mesh.indices);
        let corners = texture(gpu, corners, 3, wgpu::TextureFormat::Rgba32Uint);
        let (attributes, texels) = (HashMap::new(), HashMap::new());
        Self { indices, attributes, corners, texels, order: Arc::new(order) }
    }
}

/// True if the device has textures that hold a mesh.
pub(super) fn fits(gpu: &Gpu, mesh: &Mesh) -> bool {
    let most = gpu.device.limits().max_texture_dimension_2d;
    let texels = mesh.positions.len().max(mesh.indices.len() / 3);
    most >= MESH_TEXELS_PER_ROW && rows(texels) <= most as usize
}

fn rows(texels: usize) -> usize {
    texels.div_ceil(MESH_TEXELS_PER_ROW as usize).max(1)
}

/// All numbers of an attribute, and how many of them a vertex has.
fn numbers_of(mesh: &Mesh, attribute: VertexAttribute) -> (&[f32], usize) {
    match attribute {
        VertexAttribute::Position => (mesh.positions.as_flattened(), 3),
        VertexAttribute::Rest => (mesh.rest().as_flattened(), 3),
        VertexAttribute::Normal => (mesh.normals.as_flattened(), 3),
        VertexAttribute::Tangent => (mesh.tangents.as_flattened(), 4),
        VertexAttribute::Uv => (mesh.uvs.as_flattened(), 2),
        VertexAttribute::Color => (mesh.colors.as_flattened(), 4),
    }
}

fn buffer(gpu: &Gpu, contents: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("numbered mesh"),
        contents,
        usage,
    })
}

/// A texture with one texel for every `count` numbers of four bytes.
fn texture(
    gpu: &Gpu,
    numbers: &[u8],
    count: usize,
    format: wgpu::TextureFormat,
) -> wgpu::TextureView {
    let of_item = 4 * count;
    let rows = rows(numbers.len() / of_item);
    let mut texels = vec![0; rows * MESH_TEXELS_PER_ROW as usize * TEXEL];
    for (texel, item) in texels.chunks_exact_mut(TEXEL).zip(numbers.chunks_exact(of_item)) {
        texel[..of_item].copy_from_slice(item);
    }
    let descriptor = wgpu::TextureDescriptor {
        label: Some("numbered mesh"),
        size: wgpu::Extent3d {
            width: MESH_TEXELS_PER_ROW,
            height: rows as u32,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let order = TextureDataOrder::LayerMajor;
    gpu.device
        .create_texture_with_data(&gpu.queue, &descriptor, order, &texels)
        .create_view(&wgpu::TextureViewDescriptor::default())
}
