//! `chiaro render`: a look, a scene or a shot as a picture, or frames of it.

mod format;
mod frames;
mod layers;
mod present;
mod progress;
pub(super) mod wedge;

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;

use serde_json::json;

use format::{PictureFormat, parse_compression, parse_depth};
use frames::{EarlierFrames, Sequence};
pub(super) use present::PresentFrames;
use progress::ProgressLines;

use super::open::{check_nodes_folder, library_of};
use super::output::{Output, once, refuse_warnings};
use super::scene::check_values;
use super::target::{OutputPath, outputs, reads_all};
use super::tier::{self, TierChoice};
use super::used_files::RecordedFiles;
use super::view::ViewArguments;
use crate::clock::Clock;
use crate::compile::Live;
use crate::diag::{Diagnostic, Severity, WithWarnings};
use crate::document::{Camera, ColorSpace, Look, Scene, Tier, read_hex};
use crate::film::exr::{ExrEncoding, ExrHeader, LosslessCompression, SampleType};
use crate::film::{
    AskedLayers, DisplayView, FrameList, FramePattern, FrameRate, LayerNaming, LayeredPlan,
    MatteKind,
};
use crate::frame::{
    self, AssetStore, Assets, Executor, PassId, PlanOptions, PlanStyle, Planner, Setup, ShotStack,
    open,
};
use crate::library::Library;
use crate::milestones;
use crate::reference::Reference;
#[cfg(feature = "gpu")]
use chiaro_render::Gpu;

const EXAMPLES: &str = "\
Examples:
  chiaro render look.json -o look.png
  chiaro render look.json -o look.png --mesh shape:knot --size 1920x1080 --samples 4
  chiaro render look.json -o turned.png --turn-lights 90 --camera orbit=30,15
  chiaro render look.json -o close.png --camera 'eye=1,0.5,3;target=0,0.2,0;fov=20'
  chiaro render scene.json -o frame.png --time 1.5 --backdrop none --json
  chiaro render scene.json -o 'out/####.exr' --frames 1-240x2 --rate 24
  chiaro render shot.json -o 'out/####.exr'        all frames of the shot, at its rate
  chiaro render look.json -o layers.exr --aov layers --aov depth_key=key.tone --matte objects
  chiaro render look.json --list-aovs
  chiaro render shot.json -o aces.png --view 'ACES 2.0 - SDR 100 nits (Rec.709)'
  chiaro render look.json -o truth.png --on reference";

/// Arguments of `chiaro render`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Arguments {
    /// A look, a scene or a shot
    document: PathBuf,
    /// The PNG or EXR to write; `####` stands for the number of each of the --frames, or of the
    /// shot's own
    #[arg(short, long, required_unless_present_any = ["list_aovs", "list_views"])]
    output: Option<OutputPath>,
    /// A mesh (OBJ, PLY, STL, glTF, GLB) or an own shape (shape:creature) in place of the
    /// document's; one that lies on its back wants --z-up
    #[arg(short, long)]
    mesh: Option<String>,
    /// Stands up meshes whose z axis points up, as in many scans
    #[arg(long)]
    z_up: bool,
    /// Width and height in pixels [default: those of the shot; 800x800; 1200x800 of a scene that
    /// has a camera of its own, or as wide for 800 as that says]
    #[arg(short, long)]
    size: Option<Size>,
    /// Samples a pixel: 1, or 4 for smooth edges
    #[arg(long, default_value_t = 4, value_parser = parse_samples)]
    samples: u32,
    /// Camera of the picture: `orbit=YAW,PITCH` from so many degrees to the right of the
    /// front and above it, `distance=D` from so far away in scene units, `fov=DEGREES` with so high
    /// a view, `ortho=HEIGHT` without perspective and so many units high, `eye=X,Y,Z`,
    /// `target=X,Y,Z`, `up=X,Y,Z` outright; joined by `;`, taken in order
    #[arg(short, long)]
    camera: Option<String>,
    /// Turns the illumination frame, and every light in it: degrees around the vertical axis, or
    /// `YAW,PITCH`
    #[arg(long, allow_hyphen_values = true)]
    turn_lights: Option<String>,
    /// Backdrop behind the objects: `none` for transparent, or a color such as `#202428`
    #[arg(long)]
    backdrop: Option<String>,
    /// The time in seconds [default: 0; of a shot its first frame's]
    #[arg(long, value_parser = parse_time, allow_negative_numbers = true)]
    time: Option<f64>,
    /// Draws many frames: 1-240, every second one of them as 1-240x2, several joined by commas.
    /// Frames whose files are whole are kept; those that are equal are drawn once
    #[arg(long, allow_hyphen_values = true, conflicts_with = "time")]
    frames: Option<FrameList>,
    /// Frames per second: 24, 23.976, 24000/1001; frame 0 is at 0 seconds [default: that of the
    /// shot, or 24]
    #[arg(long)]
    rate: Option<FrameRate>,
    /// Numbers of an EXR: half, which has 16 bits, or float, which has 32
    #[arg(long, default_value = "half", value_parser = parse_depth)]
    depth: SampleType,
    /// Compression of an EXR, which loses nothing: zip, zips, piz, rle or none
    #[arg(long, default_value = "zip", value_parser = parse_compression)]
    compression: LosslessCompression,
    /// A layer of an EXR beside the picture: `NAME=NODE.OUTPUT` for an output of a node (of one
    /// look alone `NAME=LOOK:NODE.OUTPUT`), `NAME` for one that looks name, `named` for all of
    /// those, `shadows` for those of each light, or `layers`, `lights`, `groups`,
    /// `lights-by-layer` or `groups-by-layer` for what each of them adds to the picture; may be
    /// given several times
    #[arg(long = "aov", value_name = "NAME=NODE.OUTPUT")]
    aovs: Vec<String>,
    /// Lists the outputs that --aov can name, and ends
    #[arg(long)]
    list_aovs: bool,
    /// Mattes of an EXR as Cryptomatte has them: objects, looks, materials, lights (by their share
    /// of what is seen), several joined by commas
    #[arg(long = "matte", value_delimiter = ',', value_parser = layers::parse_matte)]
    mattes: Vec<MatteKind>,
    /// Names of the layers of what lights and layers add: nuke (light_key), karma (C_key), blender
    /// (Combined_key) or arnold (RGBA_key)
    #[arg(long, default_value = "nuke", value_parser = layers::parse_naming)]
    naming: LayerNaming,
    #[command(flatten)]
    view: ViewArguments,
    /// Lists the views of OpenColorIO's configuration, and ends
    #[arg(long)]
    list_views: bool,
    /// The implementation to run in every node: exact, balanced, fast, or automatic, the cheapest
    /// that nobody can see; the document's without it
    #[arg(long, value_parser = tier::parse)]
    tier: Option<TierChoice>,
    /// A folder of a project's own nodes; `nodes/` beside the document is found without it
    #[arg(long)]
    nodes: Option<PathBuf>,
    /// Executor: the GPU (or software that stands for one), or the reference in f64, which is slow
    /// and exact; without this the GPU, or where there is none the reference
    #[arg(long, value_enum)]
    on: Option<ExecutorChoice>,
    /// Draw as while the look is edited: every value is a uniform, and nothing is folded
    #[arg(long)]
    live: bool,
    /// Refuse to draw while anything is warned about, such as lights that are soloed
    #[arg(long)]
    strict: bool,
    /// Replace a file that Chiaro did not render
    #[arg(long)]
    force: bool,
    /// Lines on standard output that tell a farm how far the frames are: openjd
    #[arg(long, value_enum, requires = "frames")]
    progress: Option<ProgressLines>,
    /// Print what was done as JSON: size, seconds, adapter, passes that ran, tiers, warnings; of
    /// frames a line each, when the frame is on the disk
    #[arg(long)]
    json: bool,
}

/// Scene that is drawn, opened and ready to be planned.
struct Stage {
    setup: Setup,
    library: Library,
    planner: Planner,
    live: Live,
    options: PlanOptions,
    asked: AskedLayers,
    /// The most layers that one draw writes.
    most_layers: usize,
    /// Files that were read.
    files: Arc<RecordedFiles>,
}

impl Stage {
    /// Plans the picture with its layers.
    fn plan(
        &mut self,
        options: &PlanOptions,
    ) -> Result<WithWarnings<LayeredPlan>, Vec<Diagnostic>> {
        let drawn = (&self.setup, &self.library, &self.live);
        LayeredPlan::new(&mut self.planner, drawn, options, &self.asked, self.most_layers)
    }
}

/// Frames to draw, when they are, and their files.
struct FrameFiles {
    frames: FrameList,
    rate: FrameRate,
    pattern: FramePattern,
}

/// Executor of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum ExecutorChoice {
    Gpu,
    Reference,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Size(pub(super) [u32; 2]);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parse =
            |side: &str| side.trim().parse::<u32>().ok().filter(|side| (1..=32_768).contains(side));
        let sides = text
            .split_once(['x', 'X', '×'])
            .and_then(|(width, height)| Some([parse(width)?, parse(height)?]));
        sides.map(Self).ok_or_else(|| "write it as 800x600, each side from 1 to 32768".to_owned())
    }
}

pub(super) fn parse_samples(text: &str) -> Result<u32, String> {
    match text {
        "1" => Ok(1),
        "4" => Ok(4),
        _ => Err("it is 1 or 4".to_owned()),
    }
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    check_nodes_folder(arguments.nodes.as_deref())?;
    let Some(target) = arguments.output.as_ref().filter(|_| !arguments.list_views) else {
        return layers::list(arguments, output);
    };
    let target = target.as_ref();
    let sequence = arguments.sequence(target)?;
    let (format, view) = form_of(arguments, target).map_err(one)?;
    let read = [
        Some(arguments.document.as_path()),
        arguments.mesh.as_deref().map(Path::new),
        arguments.nodes.as_deref(),
    ];
    let mut outputs = outputs(arguments.force, read.into_iter().flatten());
    let mut earlier = EarlierFrames::default();
    match &sequence {
        None => outputs.check(target, format.kind()).map_err(one)?,
        Some(FrameFiles { frames, pattern, .. }) => {
            output.message(&format!("reading {} ...", arguments.document.display()));
            earlier = EarlierFrames::read(frames, pattern, format, &outputs).map_err(one)?;
        }
    }
    let clock = Clock::start();
    let mut warnings = Vec::new();
    let mut stage = arguments.open(&mut warnings)?;
    warnings.extend(warning_of_view(&stage.setup, view.as_ref()));
    let pattern = sequence.as_ref().map(|sequence| &sequence.pattern);
    layers::check_tables(&mut stage.asked, (target, pattern), &outputs).map_err(one)?;
    // How many layers one draw can write is the executor's to say.
    let mut early = None;
    if !stage.asked.is_empty() {
        let executor = arguments.executor(output).await.map_err(one)?;
        stage.most_layers = executor.most_layers();
        early = Some(executor);
    }
    if let Some(FrameFiles { frames, rate, pattern: files }) = &sequence {
        tell_before_series(arguments.strict, warnings, output)?;
        reads_all(&mut outputs, &stage.setup, &stage.planner.assets);
        layers::write_tables(&stage.asked, (target, pattern), &mut outputs).map_err(one)?;
        let mut executor = match early {
            Some(executor) => executor,
            None => arguments.executor(output).await.map_err(one)?,
        };
        let sequence = Sequence {
            frames,
            rate: *rate,
            pattern: files,
            format,
            earlier: &earlier,
            view: view.as_ref(),
            is_strict: arguments.strict,
            has_json: arguments.json,
            progress: arguments.progress,
        };
        return frames::draw(sequence, stage, outputs, executor.as_mut(), output);
    }
    let options = stage.options.clone();
    let plan = stage.plan(&options)?.tell(&mut warnings);
    let Stage { setup, library, planner, asked, .. } = &mut stage;
    milestones::reached("first shaders");
    refuse_warnings(arguments.strict, &mut warnings)?;
    output.diagnostics(&warnings);
    let mut executor = match early {
        Some(executor) => executor,
        None => arguments.executor(output).await.map_err(one)?,
    };
    let of_device = executor.warnings(plan.picture());
    let drawn = output
        .watch_async("drawing", async |progress| plan.draw(executor.as_mut(), progress).await)
        .await
        .map_err(one)?;
    milestones::reached("first picture");
    output.diagnostics(&of_device);
    warnings.extend(of_device);
    let header = header_of(&plan, setup);
    let bytes = format.encode(&drawn, &header, view.as_ref()).map_err(one)?;
    reads_all(&mut outputs, setup, &planner.assets);
    layers::write_tables(asked, (target, pattern), &mut outputs).map_err(one)?;
    outputs.write(target, format.kind(), &bytes).map_err(one)?;
    let [width, height] = drawn.picture.size;
    let (file, adapter) = (target.display().to_string(), executor.name());
    if arguments.json {
        let passes: Vec<PassId> = plan.picture().passes.iter().map(|pass| pass.id).collect();
        let looks = looks_told(setup, library);
        output.json(&json!({
            "file": file, "width": width, "height": height, "samples": arguments.samples,
            "time": options.time,
            "adapter": adapter, "seconds": clock.seconds(), "passes": passes, "looks": looks,
            "warnings": once(warnings),
        }));
    } else {
        output.message(&format!("{file}: {width}x{height}, on {adapter}"));
        let looks = setup.looks.iter().map(|worn| &worn.look);
        tier::told_of_all(looks, library).iter().for_each(|told| output.message(told));
    }
    Ok(())
}

/// The format of the pictures, and the view that they are shown by.
///
/// # Errors
/// A file that cannot be written in the format, or not with the layers that are asked for.
fn form_of(
    arguments: &Arguments,
    target: &Path,
) -> Result<(PictureFormat, Option<DisplayView>), Diagnostic> {
    let format = check_target(target, arguments.encoding())?;
    layers::check(arguments, format, target)?;
    Ok((format, arguments.view_of(format)?))
}

/// Prepares the first frame as rendering into `target` would, and draws nothing: for who hands the
/// arguments on.
///
/// # Errors
/// What would keep frames from being drawn.
pub(super) fn rehearse(
    arguments: &Arguments,
    target: &Path,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    let (_, view) = form_of(arguments, target).map_err(|problem| vec![problem])?;
    let mut warnings = Vec::new();
    let mut stage = arguments.open(&mut warnings)?;
    warnings.extend(warning_of_view(&stage.setup, view.as_ref()));
    let options = stage.options.clone();
    stage.plan(&options)?.tell(&mut warnings);
    refuse_warnings(arguments.strict, &mut warnings)?;
    output.diagnostics(&warnings);
    Ok(())
}

/// The looks' names and tiers, as JSON.
fn looks_told(setup: &Setup, library: &Library) -> Vec<serde_json::Value> {
    let looks = setup.looks.iter().map(|worn| &worn.look);
    looks.map(|look| json!({"name": look.name, "tiers": tier::counts(look, library)})).collect()
}

/// Tells, before a series of pictures, warnings and that looks are compiled now, but not what is
/// noted about meshes: who draws one series after another of a scene has that from `chiaro check`,
/// `chiaro mesh` and each single picture.
///
/// # Errors
/// As [`refuse_warnings`].
fn tell_before_series(
    is_strict: bool,
    mut warnings: Vec<Diagnostic>,
    output: &Output,
) -> Result<(), Vec<Diagnostic>> {
    refuse_warnings(is_strict, &mut warnings)?;
    warnings.retain(|told| told.severity != Severity::Note || !told.code.starts_with("mesh-"));
    output.diagnostics(&warnings);
    // Seconds go by before the first picture.
    output.message("compiling ...");
    Ok(())
}

/// The warning about looks that chose themselves what is shown, where a view shows them anew.
fn warning_of_view(setup: &Setup, view: Option<&DisplayView>) -> Option<Diagnostic> {
    let view = view.filter(|view| !view.keeps_shown())?;
    let mut looks = setup.looks.iter().map(|worn| &worn.look);
    let look = looks.find(|look| look.color_space == ColorSpace::Display)?;
    let message = format!(
        "the look `{}` is display-referred: what it shows is taken for light, and `{}` changes its \
         colors",
        look.name,
        view.name()
    );
    let hint = "give the look the color space `linear`, or show it by a view that maps no tones, \
                such as Un-tone-mapped";
    Some(Diagnostic::warning("view-of-display", message).hint(hint))
}

/// The header of a single picture.
fn header_of(plan: &LayeredPlan, setup: &Setup) -> ExrHeader {
    let blended_in = blended_in(setup.looks.iter().map(|worn| &worn.look));
    ExrHeader {
        view: Some(plan.picture().view),
        layers_in: layers_in(plan, &blended_in),
        blended_in,
        attributes: plan.attributes(),
        ..ExrHeader::default()
    }
}

impl Arguments {
    fn encoding(&self) -> ExrEncoding {
        ExrEncoding { samples: self.depth, compression: self.compression }
    }

    /// The view by which light is shown; `None` for the curve of sRGB.
    ///
    /// # Errors
    /// `bad-argument` for an EXR, which holds light, and as [`ViewArguments::open`].
    fn view_of(&self, format: PictureFormat) -> Result<Option<DisplayView>, Diagnostic> {
        if format != PictureFormat::Png && self.view.is_asked() {
            let message = "an EXR holds light, and not what a view shows of it";
            return Err(Diagnostic::error("bad-argument", message)
                .hint("write a PNG, or choose the view where the EXR is shown"));
        }
        self.view.open()
    }

    /// The frames that were asked for, or else those of the shot, and their files.
    fn sequence(&self, target: &Path) -> Result<Option<FrameFiles>, Vec<Diagnostic>> {
        let bad =
            |message: &str, hint: &str| vec![Diagnostic::error("bad-argument", message).hint(hint)];
        let pattern = FramePattern::of(target).map_err(|message| {
            bad(&message, "write one place for the number in the name of the file: out/####.exr")
        })?;
        let Some(pattern) = pattern else {
            if self.one_frame().is_some() {
                return Ok(None);
            }
            if self.frames.is_some() {
                let ending = target.extension().unwrap_or_default().to_string_lossy();
                let path = target.with_extension(format!("####.{ending}"));
                let hint = format!("let #### stand for the number: {}", path.display());
                return Err(bad("all frames would be written into one file", &hint));
            }
            if self.rate.is_some() {
                return Err(bad("--rate is the rate of frames", "name them, as --frames 1-48"));
            }
            return Ok(None);
        };
        let shot = ShotStack::load(&crate::files::Disk, &self.document).transpose()?;
        let shot = shot.map(|shot| shot.value);
        let frames = match (&self.frames, &shot) {
            (Some(frames), _) => frames.clone(),
            (None, Some(shot)) if self.time.is_none() => {
                let told = |message: String| bad(&message, "name some of them, as --frames 1-48");
                FrameList::of_range(shot.frames()).map_err(told)?
            }
            (None, _) => {
                let message = "the name of the file has a place for the number of a frame";
                let hint = "name the frames, as --frames 1-48, or write a name without # and %";
                return Err(bad(message, hint));
            }
        };
        let of_shot = shot.map(|shot| shot.rate());
        let rate = self.rate.or(of_shot).unwrap_or(FrameRate::FILM);
        Ok(Some(FrameFiles { frames, rate, pattern }))
    }

    /// The time that is drawn, in seconds, where it is one picture.
    fn time_of(&self, setup: &Setup) -> f64 {
        let of_frame = self.one_frame().map(|frame| self.rate_of(setup).time(frame));
        self.time.or(of_frame).unwrap_or_else(|| setup.first_time())
    }

    /// The frame, where one alone was asked for.
    fn one_frame(&self) -> Option<i32> {
        match self.frames.as_ref()?.frames() {
            [frame] => Some(*frame),
            _ => None,
        }
    }

    /// Frames per second: those asked for, or else those of the shot.
    fn rate_of(&self, setup: &Setup) -> FrameRate {
        let of_shot = setup.shot.as_ref().map(|shot| shot.stack.rate());
        self.rate.or(of_shot).unwrap_or(FrameRate::FILM)
    }

    /// Opens what is drawn.
    fn open(&self, warnings: &mut Vec<Diagnostic>) -> Result<Stage, Vec<Diagnostic>> {
        let files = Arc::new(RecordedFiles::default());
        let mut library = library_of(&*files, &self.document, self.nodes.as_deref());
        let mut assets = Assets::of(&AssetStore::reading_from(files.clone()));
        let (mut setup, of_document) =
            open(&self.document, self.mesh.as_deref(), &mut assets)?.into_parts();
        warnings.append(&mut library.problems);
        warnings.extend(of_document);
        warnings.extend(check_values(&setup, &library)?);
        if self.z_up {
            setup.stand_up();
        }
        // The truth is exact, whatever the looks say.
        let is_truth = self.on == Some(ExecutorChoice::Reference);
        let exact = is_truth.then_some(TierChoice::Every(Tier::Exact));
        if let Some(tier) = self.tier.or(exact) {
            let looks = setup.looks.iter_mut();
            looks.for_each(|worn| tier::set_every_tier(&mut worn.look, &mut library, tier));
        }
        let size = size_of(self.size.as_ref(), &setup);
        adjust(&mut setup, self).map_err(|problem| vec![problem])?;
        let time = self.time_of(&setup);
        // Who asks for the reference by its name asks for the truth; else the reference stands in
        // for a GPU and draws what that would draw.
        let style = if is_truth { PlanStyle::AsWritten } else { PlanStyle::Specialized };
        let options = PlanOptions { size, samples: self.samples, time };
        let live = if self.live { Live::All } else { style.live() };
        let asked = layers::asked(self, &setup, &library)?.tell(warnings);
        let planner = style.planner(assets);
        Ok(Stage { setup, library, planner, live, options, asked, most_layers: 0, files })
    }
}

/// The spaces in which looks blend their layers, each once.
fn blended_in<'l>(looks: impl Iterator<Item = &'l Look>) -> String {
    let mut words: Vec<&str> = Vec::new();
    for look in looks {
        let word = match look.color_space {
            ColorSpace::Display => "display",
            ColorSpace::Linear => "linear",
        };
        if !words.contains(&word) {
            words.push(word);
        }
    }
    words.join(", ")
}

/// The space of layers of values, which is that of the looks; empty where there are none.
fn layers_in(plan: &LayeredPlan, blended_in: &str) -> String {
    if plan.has_values() { blended_in.to_owned() } else { String::new() }
}

/// Size of a picture: the one that was asked for, or that of the shot, or else of the shape that
/// the camera was placed for. A camera without an aspect was usually placed for a picture wider
/// than high, which a square would cut.
pub(super) fn size_of(asked: Option<&Size>, setup: &Setup) -> [u32; 2] {
    const SIDE: f64 = 800.0;
    let of_shot = || setup.shot.as_ref().and_then(|shot| shot.stack.size());
    if let Some(size) = asked.map(|size| size.0).or_else(of_shot) {
        return size;
    }
    let camera = &setup.scene.camera;
    let unsaid = if *camera == Camera::default() { 1.0 } else { 1.5 };
    let aspect = if camera.aspect > 0.0 { camera.aspect.clamp(0.25, 4.0) } else { unsaid };
    [(SIDE * aspect).round() as u32, SIDE as u32]
}

impl Arguments {
    /// The executor of the picture's depth.
    async fn executor(&self, output: &Output) -> Result<Box<dyn Executor>, Diagnostic> {
        let samples = (self.depth == SampleType::Float).then_some(self.samples);
        deep_executor(self.on, samples, output).await
    }
}

/// The executor: a GPU if there is one and the reference was not asked for, else the reference.
pub(super) async fn executor(
    on: Option<ExecutorChoice>,
    output: &Output,
) -> Result<Box<dyn Executor>, Diagnostic> {
    deep_executor(on, None, output).await
}

/// [`executor`] that draws in floats of 32 bits where a number of samples a pixel is given.
async fn deep_executor(
    on: Option<ExecutorChoice>,
    float_samples: Option<u32>,
    output: &Output,
) -> Result<Box<dyn Executor>, Diagnostic> {
    #[cfg(not(feature = "gpu"))]
    let _ = float_samples;
    #[cfg(feature = "gpu")]
    if on != Some(ExecutorChoice::Reference) {
        match Gpu::headless().await {
            Ok(gpu) => {
                let deep = float_samples.map(|samples| gpu.in_floats(samples));
                return Ok(match deep {
                    Some(Ok(deep)) => deep.executor(),
                    Some(Err(warning)) => {
                        output.diagnostics(&[warning]);
                        gpu.executor()
                    }
                    None => gpu.executor(),
                });
            }
            Err(error) if on.is_none() => output.message(&format!(
                "{error}: drawing on the reference, in software, which takes seconds"
            )),
            Err(error) => return Err(error.into()),
        }
    }
    #[cfg(not(feature = "gpu"))]
    if on == Some(ExecutorChoice::Gpu) {
        let problem =
            Diagnostic::error("no-gpu", "this chiaro was built without the `gpu` feature");
        return Err(problem.hint("leave --on out, or build it with the feature"));
    }
    #[cfg(not(feature = "gpu"))]
    let _ = output;
    Ok(Box::new(Reference::default()))
}

pub(super) fn parse_time(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|time: &f64| time.is_finite())
        .ok_or_else(|| "it is a number of seconds".to_owned())
}

/// Checks that a PNG can be written to a path, before the work is done.
pub(super) fn check_png(path: &Path) -> Result<(), Diagnostic> {
    let found = check_target(path, ExrEncoding::default())?;
    if found == PictureFormat::Png { Ok(()) } else { Err(other_ending(path, "PNG")) }
}

/// Checks that a picture can be written to a path, before the work is done, and gives its format.
fn check_target(path: &Path, encoding: ExrEncoding) -> Result<PictureFormat, Diagnostic> {
    let problem = |message: String| {
        Diagnostic::error("cannot-write", message)
            .in_file(path.display().to_string())
            .hint("choose another file with -o, in a folder that is there and may be written to")
    };
    if path.is_dir() {
        return Err(problem("this is a folder".to_owned()));
    }
    let format =
        PictureFormat::of(path, encoding).ok_or_else(|| other_ending(path, "PNG or EXR"))?;
    let folder =
        path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if !folder.is_dir() {
        let message = format!("there is no folder `{}`", folder.display());
        let problem = Diagnostic::error("cannot-write", message);
        return Err(problem
            .in_file(path.display().to_string())
            .hint(format!("make it: mkdir -p {}; or choose another -o", folder.display())));
    }
    // The file has no name, and is gone as soon as it is closed.
    let tried = tempfile::tempfile_in(folder);
    tried.map(|_| format).map_err(|error| {
        problem(format!("nothing can be written into `{}`: {error}", folder.display()))
    })
}

fn other_ending(path: &Path, formats: &str) -> Diagnostic {
    let message = format!("pictures are written as {formats} and in no other format");
    let hint = format!("let its name end in .png: -o {}", path.with_extension("png").display());
    Diagnostic::error("cannot-write", message).in_file(path.display().to_string()).hint(hint)
}

/// Changes a scene as the command line says, which stands over keys of a shot.
fn adjust(setup: &mut Setup, arguments: &Arguments) -> Result<(), Diagnostic> {
    let options = [
        (&arguments.camera, "camera"),
        (&arguments.turn_lights, "illumination"),
        (&arguments.backdrop, "backdrop"),
    ];
    for (_, address) in options.into_iter().filter(|(option, _)| option.is_some()) {
        setup.hold(address);
    }
    let scene = &mut setup.scene;
    if let Some(text) = &arguments.camera {
        adjust_camera(scene, text)?;
    }
    if let Some(text) = &arguments.turn_lights {
        turn_lights(scene, text)?;
    }
    if let Some(text) = &arguments.backdrop {
        scene.backdrop = match text.as_str() {
            "none" => None,
            color => Some(read_hex(color).ok_or_else(|| {
                bad_argument("--backdrop", color, "`none` or a color such as #202428")
            })?),
        };
    }
    Ok(())
}

/// Turns the illumination frame as `--turn-lights` says.
pub(super) fn turn_lights(scene: &mut Scene, text: &str) -> Result<(), Diagnostic> {
    frame::turn_lights(scene, text)
        .map_err(|wrong| bad_argument("--turn-lights", &wrong.found, wrong.wanted))
}

/// Places the camera as `--camera` says.
pub(super) fn adjust_camera(scene: &mut Scene, text: &str) -> Result<(), Diagnostic> {
    scene.file_camera = None;
    frame::place_camera(&mut scene.camera, text)
        .map_err(|wrong| bad_argument("--camera", &wrong.found, wrong.wanted))
}

fn bad_argument(option: &str, found: &str, wanted: &str) -> Diagnostic {
    Diagnostic::error("bad-argument", format!("{option} cannot be `{found}`"))
        .hint(format!("write {wanted}"))
}
