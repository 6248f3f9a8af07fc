//! `chiaro mesh`: contents of a mesh file.

use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use super::output::Output;
use crate::diag::Diagnostic;
use crate::frame::Assets;
use chiaro_scene::geometry::{CameraLens, MapSource, MaterialMap, Mesh};

const EXAMPLES: &str = "\
Examples:
  chiaro mesh walker.glb           its size, materials and their maps, animations and cameras
  chiaro mesh walker.glb --json
  chiaro mesh shape:creature

A look reads a map of a material as the image \"mesh:base_color\", and so by the names of others; a
picture within a file has the path walker.glb#images/0.

An object of a scene plays an animation by \"animation\": {\"name\": \"walk\"}, and a scene looks \
through a file's camera
by \"file_camera\": {\"object\": \"walker\", \"name\": \"shot\"}.";

/// Arguments of `chiaro mesh`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A mesh file (OBJ, PLY, STL, glTF, GLB), or an own shape (shape:knot)
    mesh: PathBuf,
    /// Print it as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let name = arguments.mesh.display().to_string();
    let (mesh, warnings) = Assets::default().mesh(Path::new(""), &name)?.into_parts();
    output.diagnostics(&warnings);
    let told = report(&mesh);
    if arguments.json {
        output.json(&told);
        return Ok(());
    }
    let bounds = mesh.bounds();
    let size = bounds.size();
    let mut lines = vec![
        format!("{}: {} triangles, {} vertices", name, mesh.triangle_count(), mesh.positions.len()),
        format!("size {:.4} x {:.4} x {:.4}", size.x, size.y, size.z),
    ];
    let has = [(mesh.has_uvs, "UVs"), (mesh.has_normals, "normals"), (mesh.has_colors, "colors")];
    let has: Vec<&str> = has.iter().filter(|(has, _)| *has).map(|(_, what)| *what).collect();
    lines.push(format!(
        "brings {}",
        if has.is_empty() { "none but points".into() } else { has.join(", ") }
    ));
    lines.extend(mesh.parts.iter().map(|part| {
        let maps = part.maps.iter().flat_map(|maps| maps.iter());
        let maps = maps.map(|(map, source)| format!(", {}", map_text(*map, source)));
        let maps: String = maps.collect();
        format!("material `{}`: {} triangles{maps}", part.material, part.indices.len() / 3)
    }));
    if let Some(motion) = &mesh.motion {
        lines.extend(motion.animations().iter().map(|animation| {
            format!("animation `{}`: {:.3} s", animation.name, animation.seconds())
        }));
        lines.extend(motion.cameras().iter().map(|camera| {
            let lens = match camera.lens {
                CameraLens::Perspective { fov, .. } => {
                    format!("{:.1} degrees high", fov.to_degrees())
                }
                CameraLens::Orthographic { half_height, .. } => {
                    format!("parallel, {:.4} high", 2.0 * half_height)
                }
            };
            format!("camera `{}`: {lens}", camera.name)
        }));
    }
    output.result(&lines.join("\n"));
    Ok(())
}

/// Contents of a mesh as JSON.
fn report(mesh: &Mesh) -> Json {
    let (bounds, motion) = (mesh.bounds(), mesh.motion.as_deref());
    let parts = mesh.parts.iter().map(|part| {
        json!({ "material": part.material, "triangles": part.indices.len() / 3,
            "two_sided": part.two_sided, "alpha_cutoff": part.alpha_cutoff,
            "maps": part.maps.iter().flat_map(|maps| maps.iter())
                .map(|(map, source)| (map.name().to_owned(), json!({
                    "image": source.image, "factor": source.factor,
                })))
                .collect::<serde_json::Map<String, Json>>() })
    });
    let animations = motion.map_or(&[][..], |motion| motion.animations()).iter();
    let cameras = motion.map_or(&[][..], |motion| motion.cameras()).iter();
    json!({
        "name": mesh.name,
        "triangles": mesh.triangle_count(),
        "vertices": mesh.positions.len(),
        "least": bounds.min.to_array(),
        "greatest": bounds.max.to_array(),
        "has_uvs": mesh.has_uvs,
        "has_normals": mesh.has_normals,
        "has_colors": mesh.has_colors,
        "parts": parts.collect::<Vec<Json>>(),
        "animations": animations
            .map(|animation| json!({ "name": animation.name, "seconds": animation.seconds() }))
            .collect::<Vec<Json>>(),
        "cameras": cameras
            .map(|camera| match camera.lens {
                CameraLens::Perspective { fov, aspect } => {
                    json!({ "name": camera.name, "fov": fov, "aspect": aspect })
                }
                CameraLens::Orthographic { half_height, .. } => {
                    json!({ "name": camera.name, "height": 2.0 * half_height })
                }
            })
            .collect::<Vec<Json>>(),
    })
}

/// A map of a material in words.
fn map_text(map: MaterialMap, source: &MapSource) -> String {
    let [r, g, b, a] = source.factor;
    let factor = match source.factor {
        [1.0, 1.0, 1.0, 1.0] => String::new(),
        _ => format!(" {r:.3} {g:.3} {b:.3} {a:.3}"),
    };
    let image = source.image.as_ref().map(|image| format!(" `{image}`")).unwrap_or_default();
    format!("{}{image}{factor}", map.name())
}
