//! Packages as the program exports them, and the pictures that they should show.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::support::color::{to_linear, to_srgb};
use crate::support::{files, root};
use crate::table::{self, Row};
use image::RgbaImage;

/// Size of the pictures, in pixels.
pub(crate) const SIZE: [u32; 2] = [160, 120];

/// Writes a package's picture and our own where `CHIARO_PICTURES` says, for eyes.
pub(crate) fn keep(name: &str, pixels: &[u8], ours: &RgbaImage) {
    let Some(folder) = std::env::var_os("CHIARO_PICTURES").map(PathBuf::from) else { return };
    let theirs = RgbaImage::from_raw(SIZE[0], SIZE[1], pixels.to_vec()).expect("a picture");
    theirs.save(folder.join(format!("{name}.png"))).expect("a file");
    ours.save(folder.join(format!("{name}.ours.png"))).expect("a file");
}

/// A look in a folder of its own, with what was made of it.
pub(crate) struct Trial {
    folder: tempfile::TempDir,
    document: PathBuf,
    /// Arguments of both `chiaro export` and `chiaro render`.
    arguments: &'static [&'static str],
    /// Tier of every node, where it is not the document's.
    tier: Option<&'static str>,
    /// True to export every value of the look as a parameter.
    is_live: bool,
    /// True to draw our own picture by the GPU that the test's environment names, else by that of
    /// Chromium.
    is_here: bool,
    /// Packages that were exported without further arguments, and are still so.
    exported: RefCell<BTreeSet<String>>,
}

impl Trial {
    /// A trial of an example, such as `looks/clay`.
    pub(crate) fn of(example: &str) -> Self {
        let document = root().join("examples").join(example).with_extension("json");
        Self {
            folder: tempfile::tempdir().expect("a folder"),
            document,
            arguments: &[],
            tier: None,
            is_live: false,
            is_here: false,
            exported: RefCell::default(),
        }
    }

    /// A trial of a look in a file of its own.
    pub(crate) fn of_file(document: PathBuf) -> Self {
        Self { document, ..Self::of("") }
    }

    /// The trial with arguments of both `chiaro export` and `chiaro render`.
    pub(crate) fn with(self, arguments: &'static [&'static str]) -> Self {
        Self { arguments, ..self }
    }

    /// The trial with every value of the look a parameter of the package.
    pub(crate) fn live(self) -> Self {
        Self { is_live: true, ..self }
    }

    /// The trial with our own pictures drawn by the GPU that the test's environment names.
    pub(crate) fn here(self) -> Self {
        Self { is_here: true, ..self }
    }

    /// The trial with every node in a tier.
    pub(crate) fn in_tier(self, tier: &'static str) -> Self {
        Self { tier: Some(tier), ..self }
    }

    /// True for a trial of an example in a folder of that name.
    pub(crate) fn is_among(&self, folder: &str) -> bool {
        self.document.parent().is_some_and(|of| of.ends_with(folder))
    }

    /// A trial of a changed example. The change is given the document as JSON.
    pub(crate) fn changed(example: &str, change: impl Fn(&mut serde_json::Value)) -> Self {
        let original = Self::of(example);
        let text = std::fs::read_to_string(&original.document).expect("an example");
        let mut look = serde_json::from_str(&text).expect("JSON");
        change(&mut look);
        let document = original.folder.path().join("look.json");
        std::fs::write(&document, look.to_string()).expect("a file");
        Self { document, ..original }
    }

    /// The folder of the package, exported now unless it is there.
    pub(crate) fn package(&self, slug: &str) -> PathBuf {
        if self.exported.borrow().contains(slug) {
            return self.folder.path().join(slug);
        }
        self.package_with(slug, &[])
    }

    /// The folder of the package, exported now with further arguments.
    pub(crate) fn package_with(&self, slug: &str, arguments: &[&str]) -> PathBuf {
        self.export(slug, arguments).unwrap_or_else(|problem| panic!("{problem}"))
    }

    /// The folder of the package, or what the program says where it refuses the look.
    pub(crate) fn export(&self, slug: &str, arguments: &[&str]) -> Result<PathBuf, String> {
        let out = self.folder.path().join(slug);
        let mut command = chiaro();
        command.arg("export").arg(&self.document).args(["--to", slug, "-o"]).arg(&out);
        command.args(self.arguments).args(self.tier_arguments()).args(arguments);
        command.args(self.is_live.then_some("--live"));
        let output = command.output().expect("the program starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        self.exported.borrow_mut().remove(slug);
        if !output.status.success() {
            return Err(said);
        }
        if arguments.is_empty() {
            self.exported.borrow_mut().insert(slug.to_owned());
        }
        Ok(out)
    }

    /// Words of the program about a look that a package does not take.
    pub(crate) fn refusal(&self, slug: &str) -> String {
        self.export(slug, &[]).expect_err("the package is refused")
    }

    fn tier_arguments(&self) -> impl Iterator<Item = &'static str> {
        self.tier.into_iter().flat_map(|tier| ["--tier", tier])
    }

    /// Our own picture of the look: one sample a pixel, without a backdrop, every value a uniform
    /// as in a package.
    pub(crate) fn ours(&self) -> RgbaImage {
        self.drawn(&self.document, SIZE, &[])
    }

    /// Our own picture of the look on another mesh or by another camera: arguments of `chiaro
    /// render`.
    pub(crate) fn ours_with_arguments(&self, arguments: &[&str]) -> RgbaImage {
        self.drawn(&self.document, SIZE, arguments)
    }

    /// Our own picture, each of its pixels the average of `side` by `side`, by their light and
    /// alpha.
    pub(crate) fn ours_averaged(&self, side: u32, arguments: &[&str]) -> RgbaImage {
        let fine = self.drawn(&self.document, SIZE.map(|length| length * side), arguments);
        RgbaImage::from_fn(SIZE[0], SIZE[1], |x, y| {
            let mut sum = [0.0; 4];
            for (down, across) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
                let pixel = fine.get_pixel(x * side + across, y * side + down).0.map(f64::from);
                let alpha = pixel[3] / 255.0;
                for channel in 0..3 {
                    sum[channel] += alpha * to_linear(pixel[channel] / 255.0);
                }
                sum[3] += alpha;
            }
            let [red, green, blue] = [0, 1, 2].map(|channel| match sum[3] > 0.0 {
                true => to_srgb(sum[channel] / sum[3]),
                false => 0.0,
            });
            let alpha = sum[3] / f64::from(side * side);
            #[expect(clippy::cast_possible_truncation, reason = "rounded, within 0 and 255")]
            #[expect(clippy::cast_sign_loss, reason = "rounded, within 0 and 255")]
            image::Rgba([red, green, blue, alpha].map(|share| (255.0 * share).round() as u8))
        })
    }

    /// Our own picture with exposed parameters set, by a scene as people write it.
    pub(crate) fn ours_with(&self, values: &serde_json::Value) -> RgbaImage {
        let scene = self.folder.path().join("scene.json");
        let look = self.document.display().to_string();
        let object = serde_json::json!({
            "mesh": "shape:creature", "looks": look, "values": values,
        });
        let text = serde_json::json!({"chiaro": "scene", "version": 1, "objects": [object]});
        std::fs::write(&scene, text.to_string()).expect("a file");
        self.drawn(&scene, SIZE, &[])
    }

    fn drawn(&self, document: &Path, size: [u32; 2], arguments: &[&str]) -> RgbaImage {
        let picture = self.folder.path().join("ours.png");
        let size = format!("{}x{}", size[0], size[1]);
        let mut command = if self.is_here { chiaro_here() } else { chiaro() };
        command
            .arg("render")
            .arg(document)
            .args(["--samples", "1", "--backdrop", "none", "--live", "--force"])
            .args(["--size", &size, "-o"])
            .arg(&picture)
            .args(self.arguments)
            .args(self.tier_arguments())
            .args(arguments);
        run(&mut command);
        image::open(&picture).expect("a picture").to_rgba8()
    }
}

/// Trials of examples such as `looks/clay`, with their names.
pub(crate) fn examples(places: &[&str]) -> Vec<(String, Trial)> {
    places.iter().map(|place| (name_of(place).to_owned(), Trial::of(place))).collect()
}

/// Name of the example at a place: `clay` of `looks/clay`.
pub(crate) fn name_of(place: &str) -> &str {
    place.rsplit('/').next().unwrap_or_default()
}

/// An example look.
pub(crate) struct ExampleLook {
    /// Name of its file without ending.
    pub(crate) name: String,
    /// Place among the examples, such as `looks/clay`.
    place: String,
}

/// All example looks, folder after folder.
pub(crate) fn example_looks() -> Vec<ExampleLook> {
    let examples = root().join("examples");
    let folders = ["looks", "images", "hcbtf", "shadows"].map(|name| examples.join(name));
    let documents = folders.iter().flat_map(|folder| files::below(folder));
    let documents = documents.filter(|path| path.extension().is_some_and(|it| it == "json"));
    let look = |path: PathBuf| {
        let place = path.strip_prefix(&examples).expect("an example").with_extension("");
        let place = place.to_string_lossy().into_owned();
        let name = name_of(&place).to_owned();
        ExampleLook { name, place }
    };
    documents.map(look).collect()
}

/// Trials of all example looks that a package takes, each made fit by `fit`; the reasons of those
/// that it refuses are compared with the table, or written there. Shadows are read from maps, for
/// no package traces them. `CHIARO_LOOKS` names a few, joined by commas, to be tried alone.
pub(crate) fn soak_trials(slug: &str, fit: impl Fn(Trial) -> Trial) -> Vec<(String, Trial)> {
    let mut refused = BTreeMap::new();
    let mut taken = Vec::new();
    let few = std::env::var("CHIARO_LOOKS").ok();
    let is_wanted = |look: &ExampleLook| {
        few.as_ref().is_none_or(|few| few.split(',').any(|name| name == look.name))
    };
    for look in example_looks().into_iter().filter(is_wanted) {
        let mut trial = fit(Trial::of(&look.place));
        if look.place.starts_with("shadows") {
            trial = trial.in_tier("balanced");
        }
        match trial.export(slug, &[]) {
            Ok(_) => taken.push((look.name, trial)),
            Err(said) => {
                let reason = said.lines().find_map(|it| it.split_once("error[not-in-package]: "));
                let (_, reason) = reason.unwrap_or_else(|| panic!("{}: {said}", look.name));
                let row = Row::Refused(reason.trim().to_owned());
                refused.insert(format!("{slug} - {}", look.name), row);
            }
        }
    }
    table::check_rows(&refused);
    taken
}

/// The folder of what is kept between runs of the program, such as the mesh.
fn cache() -> &'static Path {
    static FOLDER: OnceLock<tempfile::TempDir> = OnceLock::new();
    FOLDER.get_or_init(|| tempfile::tempdir().expect("a folder")).path()
}

/// The program, drawing with the GPU that the environment names.
fn chiaro_here() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
    command.env("NODEVICE_SELECT", "1").env("CHIARO_CACHE_DIR", cache());
    command
}

/// The program, drawing with the software GPU that Chromium brings along.
fn chiaro() -> Command {
    let mut command = chiaro_here();
    let driver = Path::new("/usr/lib/chromium/vk_swiftshader_icd.json");
    if driver.is_file() {
        command.env("VK_DRIVER_FILES", driver);
    }
    command
}

/// Runs the program with arguments.
pub(crate) fn run_chiaro(arguments: &[&std::ffi::OsStr]) {
    run(chiaro_here().args(arguments));
}

fn run(command: &mut Command) {
    let output = command.output().expect("the program starts");
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// Difference of two pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Difference {
    /// Greatest difference of a channel, of 255.
    pub(crate) greatest: u8,
    /// Number of pixels that differ by more than 1 in a channel.
    pub(crate) beyond: usize,
}

impl Difference {
    /// The difference of a picture, rows from the top, from our own.
    pub(crate) fn of(pixels: &[u8], ours: &RgbaImage) -> Self {
        assert_eq!(pixels.len(), ours.as_raw().len(), "a picture of the same size");
        let mut found = Self::default();
        for (theirs, own) in pixels.chunks_exact(4).zip(ours.as_raw().chunks_exact(4)) {
            let worst = theirs.iter().zip(own).map(|(a, b)| a.abs_diff(*b)).max();
            let worst = worst.unwrap_or_default();
            found.greatest = found.greatest.max(worst);
            found.beyond += usize::from(worst > 1);
        }
        found
    }
}

/// The colors of a picture times their alpha, as over black.
pub(crate) fn over_black(pixels: &[u8]) -> Vec<u8> {
    let times = |color: u8, alpha: u8| (u16::from(color) * u16::from(alpha) + 127) / 255;
    let of_pixel = |pixel: &[u8]| {
        let [red, green, blue] = [0, 1, 2].map(|channel| times(pixel[channel], pixel[3]));
        #[expect(clippy::cast_possible_truncation, reason = "no product is above 255")]
        [red as u8, green as u8, blue as u8, pixel[3]]
    };
    pixels.chunks_exact(4).flat_map(of_pixel).collect()
}
