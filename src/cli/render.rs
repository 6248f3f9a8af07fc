//! `chiaro render`: a look or a scene as a PNG.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use glam::{DQuat, DVec3};

use super::output::Output;
use crate::compile::Live;
use crate::diag::Diagnostic;
use crate::document::{Projection, Scene, parse_hex, write_atomic};
use crate::frame::{Assets, PlanOptions, Planner, open};
use crate::library::Library;
use crate::render::{Gpu, Picture, Renderer, block_on};

const EXAMPLES: &str = "\
Examples:
  chiaro render look.json -o look.png
  chiaro render look.json -o look.png --mesh shape:knot --size 1920x1080 --samples 4
  chiaro render look.json -o turned.png --turn-lights 90 --camera orbit=30,15
  chiaro render scene.json -o frame.png --time 1.5 --backdrop none";

/// What `chiaro render` is given.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look or a scene
    document: PathBuf,
    /// The PNG to write
    #[arg(short, long)]
    output: PathBuf,
    /// A mesh (OBJ, PLY, STL, glTF, GLB) or an own shape (shape:creature) in place of the document's
    #[arg(short, long)]
    mesh: Option<String>,
    /// Width and height in pixels
    #[arg(short, long, default_value = "800x800")]
    size: Size,
    /// Samples a pixel
    #[arg(long, default_value_t = 4, value_parser = parse_samples)]
    samples: u32,
    /// Where the picture is taken from: `orbit=YAW,PITCH` in degrees around the target, `distance=D`, `ortho=HEIGHT`,
    /// `fov=DEGREES`; joined by `;`
    #[arg(short, long)]
    camera: Option<String>,
    /// Turns the illumination frame, and every light in it: degrees around the vertical axis, or `YAW,PITCH`
    #[arg(long, allow_hyphen_values = true)]
    turn_lights: Option<String>,
    /// What is behind the objects: `none` for transparent, or a colour such as `#202428`
    #[arg(long)]
    backdrop: Option<String>,
    /// The time in seconds
    #[arg(long, default_value_t = 0.0)]
    time: f64,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Fold nothing and remove nothing: what pruning is held against
    #[arg(long, hide = true)]
    live: bool,
}

#[derive(Clone, Copy, Debug)]
struct Size([u32; 2]);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse = |side: &str| side.trim().parse::<u32>().ok().filter(|side| (1..=32_768).contains(side));
        let sides = text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some([parse(width)?, parse(height)?]));
        sides.map(Self).ok_or_else(|| "write it as 800x600, each side from 1 to 32768".to_owned())
    }
}

fn parse_samples(text: &str) -> Result<u32, String> {
    match text {
        "1" => Ok(1),
        "4" => Ok(4),
        _ => Err("it is 1 or 4".to_owned()),
    }
}

/// The built-in library with the project's own nodes.
pub(super) fn library_for(document: &Path, nodes: Option<&Path>) -> Library {
    let beside = document.parent().unwrap_or(Path::new("")).join("nodes");
    match nodes {
        Some(folder) => Library::built_in().with_project(folder),
        None if beside.is_dir() => Library::built_in().with_project(&beside),
        None => Library::built_in().clone(),
    }
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let library = library_for(&arguments.document, arguments.nodes.as_deref());
    output.diagnostics(&library.problems);
    let mut assets = Assets::default();
    let (mut setup, warnings) = open(&arguments.document, arguments.mesh.as_deref(), &mut assets)?;
    output.diagnostics(&warnings);
    adjust(&mut setup.scene, arguments).map_err(one)?;
    let mut planner = Planner::new(assets);
    let options = PlanOptions { size: arguments.size.0, samples: arguments.samples, time: arguments.time };
    let live = if arguments.live { Live::All } else { Live::Keyed };
    let plan = planner.plan(&setup, &library, &live, &options)?;
    output.diagnostics(&planner.warnings);
    let gpu = block_on(Gpu::headless()).map_err(|error| one(error.into()))?;
    let mut renderer = Renderer::new(gpu);
    let picture = block_on(renderer.picture(&plan)).map_err(|error| one(error.into()))?;
    write_png(&arguments.output, &picture).map_err(one)?;
    let [width, height] = picture.size;
    output.message(&format!("{}: {width}x{height}, on {}", arguments.output.display(), renderer.gpu().name()));
    Ok(())
}

/// Writes a picture as PNG: straight alpha, 8 bits a channel.
pub(super) fn write_png(path: &Path, picture: &Picture) -> Result<(), Diagnostic> {
    let mut bytes = Vec::new();
    let encoder = image::codecs::png::PngEncoder::new(&mut bytes);
    let [width, height] = picture.size;
    let encoded =
        image::ImageEncoder::write_image(encoder, &picture.to_rgba8(), width, height, image::ExtendedColorType::Rgba8);
    encoded.map_err(|error| Diagnostic::error("png", format!("the picture cannot be encoded: {error}")))?;
    write_atomic(path, &bytes).map_err(|problem| *problem)
}

fn adjust(scene: &mut Scene, arguments: &Arguments) -> Result<(), Diagnostic> {
    if let Some(text) = &arguments.camera {
        adjust_camera(scene, text)?;
    }
    if let Some(text) = &arguments.turn_lights {
        let angles = numbers(text)
            .filter(|n| (1..=2).contains(&n.len()))
            .ok_or_else(|| bad_argument("--turn-lights", text, "degrees around the vertical axis, or YAW,PITCH"))?;
        let yaw = DQuat::from_rotation_y(angles[0].to_radians());
        let pitch = DQuat::from_rotation_x(-angles.get(1).copied().unwrap_or(0.0).to_radians());
        let turned = yaw * pitch * DQuat::from_array(scene.illumination);
        scene.illumination = turned.normalize().to_array();
    }
    if let Some(text) = &arguments.backdrop {
        scene.backdrop = match text.as_str() {
            "none" => None,
            color => Some(
                parse_hex(color)
                    .ok_or_else(|| bad_argument("--backdrop", color, "`none` or a colour such as #202428"))?,
            ),
        };
    }
    Ok(())
}

fn adjust_camera(scene: &mut Scene, text: &str) -> Result<(), Diagnostic> {
    let bad = || {
        let wanted = "orbit=YAW,PITCH, distance=D, ortho=HEIGHT or fov=DEGREES, joined by `;`";
        bad_argument("--camera", text, wanted)
    };
    for part in text.split(';').filter(|part| !part.trim().is_empty()) {
        let (key, value) = part.trim().split_once('=').ok_or_else(bad)?;
        let values = numbers(value).filter(|numbers| !numbers.is_empty()).ok_or_else(bad)?;
        let camera = &mut scene.camera;
        let target = DVec3::from(camera.target);
        let offset = DVec3::from(camera.eye) - target;
        match key.trim() {
            "orbit" if values.len() == 2 => {
                let yaw = DQuat::from_rotation_y(values[0].to_radians());
                let pitch = DQuat::from_rotation_x(-values[1].to_radians());
                camera.eye = (target + yaw * pitch * DVec3::Z * offset.length()).to_array();
            }
            "distance" if values[0] > 0.0 => {
                camera.eye = (target + offset.normalize_or(DVec3::Z) * values[0]).to_array();
            }
            "ortho" if values[0] > 0.0 => {
                camera.projection = Projection::Orthographic;
                camera.height = values[0];
            }
            "fov" if values[0] > 0.0 && values[0] < 180.0 => {
                camera.projection = Projection::Perspective;
                camera.fov = values[0].to_radians();
            }
            _ => return Err(bad()),
        }
    }
    Ok(())
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|part| part.trim().parse::<f64>().ok().filter(|x| x.is_finite())).collect()
}

fn bad_argument(option: &str, found: &str, wanted: &str) -> Diagnostic {
    Diagnostic::error("bad-argument", format!("{option} cannot be `{found}`")).hint(format!("write {wanted}"))
}
