//! A package's picture as Unity would draw it: on its matrices and depth, with rows from either
//! end.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use glam::{DMat3, DMat4, DQuat, DVec3, DVec4, Vec3};
use image::RgbaImage;
use wgpu::util::DeviceExt as _;

use super::Package;
use super::engine::{Engine, WornLook, wgsl};
use super::textures::{Textures, bound};
use crate::blender::Ring;
use crate::pictures::{SIZE, Trial};
use crate::support::files;
use crate::support::wait::block_on;
use chiaro::files::Disk;
use chiaro::geometry::{Mesh, load};
use chiaro::render::Gpu;

/// The camera of both pictures, in the look's space.
const CAMERA: &str = "eye=0.9,0.8,2.6;target=0,0.02,0;fov=38";

/// End of a target where its rows begin. Unity's targets of textures begin at the bottom where the
/// graphics API has them at the top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FirstRow {
    Top,
    Bottom,
}

/// A trial as all rows of the table have it: every node in the tier that needs no passes, and our
/// own picture by the GPU that the stand-in draws with, whose edges of triangles are the same.
pub(crate) fn in_one_tier(trial: Trial) -> Trial {
    trial.in_tier("fast").here()
}

/// Our own picture of a trial, and that of its package. `set` are statements that set fields of
/// `look`, the component.
pub(super) fn drawn(trial: &Trial, package: &Package, set: &str) -> (RgbaImage, Vec<u8>) {
    drawn_with(trial, package, FirstRow::Top, |scene| Engine::worn(package, &scene.main(set)))
}

/// Our own picture of a trial, and that of its package in a target whose rows begin at the bottom.
pub(super) fn drawn_from_below(trial: &Trial, package: &Package) -> (RgbaImage, Vec<u8>) {
    drawn_with(trial, package, FirstRow::Bottom, |scene| Engine::worn(package, &scene.main("")))
}

/// The picture of a package's shader with the numbers that its properties begin with, which a new
/// material has before any component gives it others.
pub(super) fn drawn_fresh(trial: &Trial, package: &Package) -> Vec<u8> {
    let numbers = package.shader.lines().filter_map(|line| {
        // [HideInInspector] _key_direction ("", Vector) = (0.5, 0, 1, 0)
        let (property, value) =
            line.trim().strip_prefix("[HideInInspector] ")?.split_once(" = ")?;
        let name = property.split(' ').next()?.to_owned();
        let numbers = value.trim_matches(['(', ')']).split(", ");
        Some((name, numbers.map(|number| number.parse().expect("a number")).collect()))
    });
    let worn = WornLook { numbers: numbers.collect(), ..WornLook::default() };
    drawn_with(trial, package, FirstRow::Top, |_| worn.clone()).1
}

/// Our own picture of a trial, and that of a shader with what a component gives the material.
fn drawn_with(
    trial: &Trial,
    package: &Package,
    first: FirstRow,
    worn: impl Fn(&UnityScene) -> WornLook,
) -> (RgbaImage, Vec<u8>) {
    let folder = tempfile::tempdir().expect("a folder");
    let ring = Ring::new();
    let path = folder.path().join("ring.obj");
    fs::write(&path, ring.obj()).expect("a mesh");
    let file = path.display().to_string();
    let ours = trial.ours_with_arguments(&["--mesh", &file, "--camera", CAMERA]);
    let mesh = load(&Disk, &path).expect("a mesh").value;
    let scene = UnityScene::new(&mesh, reads_object(&package.folder));
    (ours, scene.pixels(package, &worn(&scene), first))
}

/// Our own picture of a trial, and that of a text of ShaderLab in a folder, which has textures but
/// no component. It leaves out the backs of triangles unless it `is_two_sided`.
pub(crate) fn drawn_shader(
    trial: &Trial,
    folder: &Path,
    shader: String,
    textures: &Textures,
    is_two_sided: bool,
) -> (RgbaImage, Vec<u8>) {
    let numbers = is_two_sided.then(|| ("_Cull".to_owned(), vec![0.0])).into_iter().collect();
    let worn = WornLook { numbers, textures: textures.clone() };
    let component = PathBuf::new();
    let package = Package { folder: folder.to_owned(), shader, component, class: String::new() };
    drawn_with(trial, &package, FirstRow::Top, |_| worn.clone())
}

/// True if the look's picture depends on the object's own space, which is then to be the mesh's.
fn reads_object(folder: &Path) -> bool {
    files::below(folder).iter().any(|path| {
        let is_look = path.extension().is_some_and(|it| it == "hlsl" || it == "ush");
        if !is_look {
            return false;
        }
        let text = fs::read_to_string(path).expect("a text");
        let fragment = text.split_once(" fs_main(").map_or("", |(_, rest)| rest);
        text.contains("position_object") || fragment.contains("object.")
    })
}

/// The scene as Unity has it: left-handed, x mirrored, the object turned and moved away from where
/// its mesh was made.
struct UnityScene {
    /// Vertices of the mesh, in the object's space.
    vertices: Vec<UnityVertex>,
    indices: Vec<u32>,
    world_from_object: DMat4,
    camera_from_world: DMat4,
    clip_from_camera: DMat4,
    eye: DVec3,
}

/// A vertex with the attributes that looks read.
struct UnityVertex {
    position: [f32; 3],
    normal: [f32; 3],
    tangent: [f32; 4],
    uv: [f32; 2],
}

impl UnityVertex {
    /// The numbers of an attribute.
    fn attribute(&self, name: &str) -> &[f32] {
        match name {
            "position" => &self.position,
            "normal" => &self.normal,
            "tangent" => &self.tangent,
            "uv" => &self.uv,
            // White.
            _ => &[1.0; 4],
        }
    }
}

/// Names of the attributes that a vertex function in WGSL takes, by their locations.
fn attributes(wgsl: &str) -> Vec<String> {
    let (_, rest) = wgsl.split_once("struct vertexInput").expect("attributes");
    let (list, _) = rest.split_once('}').expect("their end");
    // `    @location(0) position_4 : vec3<f32>,`
    let name = |line: &str| {
        let (_, rest) = line.split_once("@location(")?.1.split_once(") ")?;
        Some(rest.split_once(" : ")?.0.rsplit_once('_')?.0.to_owned())
    };
    list.lines().filter_map(name).collect()
}

impl UnityScene {
    /// The scene with a mesh, whose own places stay as they are if `is_kept`.
    fn new(mesh: &Mesh, is_kept: bool) -> Self {
        let mirror = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
        let fit = mesh.fit();
        let world_from_object = if is_kept {
            let middle = mirror.transform_point3(fit.center);
            DMat4::from_scale(DVec3::splat(fit.scale)) * DMat4::from_translation(-middle)
        } else {
            DMat4::from_scale_rotation_translation(
                DVec3::splat(0.7),
                DQuat::from_rotation_y(0.8) * DQuat::from_rotation_x(-0.5),
                DVec3::new(0.3, -0.2, 0.6),
            )
        };
        let object_from_world = world_from_object.inverse();
        let normals = DMat3::from_mat4(world_from_object).transpose();
        let direction = |v: [f32; 3]| {
            let mirrored = mirror.transform_vector3(Vec3::from(v).as_dvec3());
            (normals * mirrored).normalize().as_vec3()
        };
        let vertex = |index: usize| {
            let seen = (Vec3::from(mesh.positions[index]).as_dvec3() - fit.center) * fit.scale;
            let position = object_from_world.transform_point3(mirror.transform_point3(seen));
            let [x, y, z, side] = mesh.tangents[index];
            UnityVertex {
                position: position.as_vec3().to_array(),
                normal: direction(mesh.normals[index]).to_array(),
                // Mirrored, the third axis is on the other side.
                tangent: direction([x, y, z]).extend(-side).to_array(),
                uv: mesh.uvs[index],
            }
        };
        let (eye, target) = (DVec3::new(0.9, 0.8, 2.6), DVec3::new(0.0, 0.02, 0.0));
        let aspect = f64::from(SIZE[0]) / f64::from(SIZE[1]);
        // Axes of the camera: x to the right, y up, z toward the viewer.
        let z = (eye - target).normalize();
        let x = DVec3::Y.cross(z).normalize();
        let turn = DMat4::from_mat3(DMat3::from_cols(x, z.cross(x), z).transpose());
        // OpenGL's projection, which Unity's cameras have: depth from -1 to 1.
        let (near, far, scale) = (0.1, 20.0, 1.0 / 19_f64.to_radians().tan());
        let clip_from_camera = DMat4::from_cols(
            DVec4::new(scale / aspect, 0.0, 0.0, 0.0),
            DVec4::new(0.0, scale, 0.0, 0.0),
            DVec4::new(0.0, 0.0, (far + near) / (near - far), -1.0),
            DVec4::new(0.0, 0.0, 2.0 * far * near / (near - far), 0.0),
        );
        Self {
            vertices: (0..mesh.positions.len()).map(vertex).collect(),
            indices: mesh.indices.clone(),
            world_from_object,
            camera_from_world: turn * DMat4::from_translation(-eye) * mirror,
            clip_from_camera,
            eye: mirror.transform_point3(eye),
        }
    }

    /// The matrix to the clip space of a target: depth from 1 to 0.
    fn clip_from_world(&self, first: FirstRow) -> DMat4 {
        let target = DMat4::from_cols(
            DVec4::X,
            if first == FirstRow::Top { DVec4::Y } else { -DVec4::Y },
            DVec4::new(0.0, 0.0, -0.5, 0.0),
            DVec4::new(0.0, 0.0, 0.5, 1.0),
        );
        target * self.clip_from_camera * self.camera_from_world
    }

    /// Statements of C# that set the scene.
    fn main(&self, set: &str) -> String {
        let vector = |v: DVec3| format!("new Vector3({}f, {}f, {}f)", v.x, v.y, v.z);
        let axes = format!(
            "right = {}, up = {}, forward = {}",
            vector(DVec3::X),
            vector(DVec3::Y),
            vector(DVec3::Z)
        );
        let cells: String = (0..16)
            .map(|at| {
                let (row, column) = (at / 4, at % 4);
                format!("m{row}{column} = {}f, ", self.camera_from_world.col(column)[row])
            })
            .collect();
        let back = self.camera_from_world.row(2).truncate();
        format!(
            "wearer.bounds.center = {};\nlook.transform = new Transform {{ {axes} }};\n\
             camera.transform = new Transform {{ position = {}, forward = {} }};\n\
             camera.worldToCameraMatrix = new Matrix4x4 {{ {cells} }};\n\
             camera.pixelWidth = {};\ncamera.pixelHeight = {};\n{set}\n",
            vector(DVec3::ZERO),
            vector(self.eye),
            vector(-back),
            SIZE[0],
            SIZE[1],
        )
    }

    /// The numbers of the stand-in's block.
    fn surroundings(&self, first: FirstRow) -> Vec<u8> {
        let matrices = [
            self.world_from_object,
            self.world_from_object.inverse(),
            self.camera_from_world,
            self.clip_from_world(first),
            self.clip_from_camera,
        ];
        // Rows, as the stand-in takes them.
        let mut numbers: Vec<f32> = Vec::new();
        for matrix in matrices {
            numbers.extend(matrix.transpose().as_mat4().to_cols_array());
        }
        numbers.extend(self.eye.as_vec3().to_array());
        let [width, height] = SIZE.map(|size| size as f32);
        numbers.extend([1.0, width, height, 1.0 + 1.0 / width, 1.0 + 1.0 / height]);
        numbers.extend([0.0; 4]);
        numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
    }

    /// The pixels of the package's picture, rows from the top, straight and as shown.
    #[expect(clippy::too_many_lines, reason = "one draw, of which nothing is done twice")]
    fn pixels(&self, package: &Package, worn: &WornLook, first: FirstRow) -> Vec<u8> {
        let (text, [vertex, fragment]) = package.passes().swap_remove(0);
        let gpu = block_on(Gpu::headless()).expect("an adapter; software Vulkan does");
        let device = &gpu.device;
        let guard = device.push_error_scope(wgpu::ErrorFilter::Validation);
        let sources = [(&vertex, "vertex"), (&fragment, "fragment")]
            .map(|(function, stage)| wgsl(&package.folder, &text, function, stage));
        let [vertex_module, fragment_module] = sources.each_ref().map(|source| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: None,
                source: wgpu::ShaderSource::Wgsl(source.into()),
            })
        });
        let images = bound(&sources[1], &worn.textures, device, &gpu.queue);
        let contents = [self.surroundings(first), material(&text, &worn.numbers)];
        let buffer = |contents: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: None,
                contents,
                usage,
            })
        };
        let uniforms = contents.each_ref().map(|it| buffer(it, wgpu::BufferUsages::UNIFORM));
        let entry = |binding| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let mut layouts = vec![entry(0), entry(1)];
        layouts.extend(images.iter().map(|(binding, image)| image.layout(*binding)));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &layouts,
        });
        let bound_block = |binding: u32| wgpu::BindGroupEntry {
            binding,
            resource: uniforms[binding as usize].as_entire_binding(),
        };
        let mut entries = vec![bound_block(0), bound_block(1)];
        entries.extend(images.iter().map(|(binding, image)| wgpu::BindGroupEntry {
            binding: *binding,
            resource: image.resource(),
        }));
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &entries,
        });
        let names = attributes(&sources[0]);
        let vertices: Vec<f32> = self
            .vertices
            .iter()
            .flat_map(|vertex| names.iter().flat_map(|name| vertex.attribute(name)))
            .copied()
            .collect();
        let mut stride = 0;
        let mut layout_of_vertex = Vec::new();
        for (location, name) in names.iter().enumerate() {
            let count = self.vertices[0].attribute(name).len();
            let format = match count {
                2 => wgpu::VertexFormat::Float32x2,
                3 => wgpu::VertexFormat::Float32x3,
                _ => wgpu::VertexFormat::Float32x4,
            };
            layout_of_vertex.push(wgpu::VertexAttribute {
                format,
                offset: 4 * stride as u64,
                shader_location: location as u32,
            });
            stride += count;
        }
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layout)],
            ..wgpu::PipelineLayoutDescriptor::default()
        });
        // The target encodes, as Unity's do in projects of linear light.
        let (format, depth) =
            (wgpu::TextureFormat::Rgba8UnormSrgb, wgpu::TextureFormat::Depth32Float);
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &vertex_module,
                entry_point: Some(&vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[Some(wgpu::VertexBufferLayout {
                    array_stride: 4 * stride as u64,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &layout_of_vertex,
                })],
            },
            primitive: wgpu::PrimitiveState {
                // Rows upside down turn triangles around.
                front_face: match first {
                    FirstRow::Top => wgpu::FrontFace::Ccw,
                    FirstRow::Bottom => wgpu::FrontFace::Cw,
                },
                cull_mode: worn.left_out(),
                ..wgpu::PrimitiveState::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: depth,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::GreaterEqual),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &fragment_module,
                entry_point: Some(&fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let target = |format, usage| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width: SIZE[0], height: SIZE[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let color = target(format, attachment | wgpu::TextureUsages::COPY_SRC);
        let depth = target(depth, attachment);
        let view = |texture: &wgpu::Texture| texture.create_view(&Default::default());
        let (color_view, depth_view) = (view(&color), view(&depth));
        let bytes: Vec<u8> = vertices.iter().flat_map(|x| x.to_le_bytes()).collect();
        let vertices = buffer(&bytes, wgpu::BufferUsages::VERTEX);
        let bytes: Vec<u8> = self.indices.iter().flat_map(|x| x.to_le_bytes()).collect();
        let indices = buffer(&bytes, wgpu::BufferUsages::INDEX);
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &color_view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth_view,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..wgpu::RenderPassDescriptor::default()
        });
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.indices.len() as u32, 0, 0..1);
        drop(pass);
        // Rows of buffers are multiples of 256 bytes.
        let row = 4 * SIZE[0] as usize;
        let padded = row.next_multiple_of(256);
        let found = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: (padded * SIZE[1] as usize) as u64,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(padded as u32),
            rows_per_image: None,
        };
        let into = wgpu::TexelCopyBufferInfo { buffer: &found, layout };
        encoder.copy_texture_to_buffer(color.as_image_copy(), into, color.size());
        gpu.queue.submit([encoder.finish()]);
        if let Some(problem) = block_on(guard.pop()) {
            panic!("{}: {problem}", package.folder.display());
        }
        found.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.expect("a picture"));
        device.poll(wgpu::PollType::wait_indefinitely()).expect("the device draws");
        let mapped = found.slice(..).get_mapped_range().expect("a picture");
        let bytes = mapped.to_vec();
        let mut rows: Vec<&[u8]> = bytes.chunks_exact(padded).map(|it| &it[..row]).collect();
        if first == FirstRow::Bottom {
            rows.reverse();
        }
        rows.concat()
    }
}

/// The bytes of the material's block, as its declaration in the shader lays it out.
fn material(text: &str, numbers: &BTreeMap<String, Vec<f32>>) -> Vec<u8> {
    let (_, block) = text.split_once("CBUFFER_START(UnityPerMaterial)\n").expect("a block");
    let (block, _) = block.split_once("CBUFFER_END").expect("its end");
    let mut bytes: Vec<u8> = Vec::new();
    for line in block.lines() {
        let Some((ty, name)) = line.trim().trim_end_matches(';').split_once(' ') else { continue };
        let found = numbers.get(name).cloned().unwrap_or_default();
        let count = if ty == "float4" { 4 } else { 1 };
        bytes.resize(bytes.len().next_multiple_of(4 * count), 0);
        for part in 0..count {
            let number = found.get(part).copied().unwrap_or_default();
            bytes.extend(match ty {
                "int" => (number as i32).to_le_bytes(),
                _ => number.to_le_bytes(),
            });
        }
    }
    bytes.resize(bytes.len().next_multiple_of(16), 0);
    bytes
}
