//! Views of pictures by OpenColorIO's configurations: from light to what a display shows, as film
//! grades and animation studios agree on it, ACES 2 among them.
//!
//! A [`ColorConfig`] is a configuration with its displays, each of which has views. A
//! [`DisplayView`] is one of them, for pictures as they are drawn here: their numbers are shown by
//! the curve of sRGB, so that light with the primaries of Rec. 709 is taken out of them, as in an
//! EXR, and shown anew. On the CPU its numbers are OpenColorIO's to the bit; as a
//! [`DisplayModule`](crate::frame::DisplayModule) a GPU comes near them.

mod config;
mod module;

use ::ocio::{CpuProcessor, Processor};
use chiaro_locale::tr;

pub use config::{BUILT_IN, ColorConfig, VIEW_VARIABLE};

use crate::diag::Diagnostic;
use crate::exr::light_of;
use crate::frame::{DisplayModule, Picture};

/// Number of pixels that are shown at once: their colors lie side by side meanwhile.
const PIXELS: usize = 1 << 14;

/// View of a display, as a configuration describes it.
#[derive(Clone, Debug)]
pub struct DisplayView {
    /// Name of the configuration.
    config: String,
    display: String,
    view: String,
    /// Text that names all that decides on colors.
    key: String,
    processor: Processor,
    cpu: CpuProcessor,
}

impl DisplayView {
    fn new(config: &str, (display, view): (String, String), processor: Processor) -> Self {
        // Equal steps have one id, whatever configuration they come from.
        let key = processor.cache_id();
        let cpu = processor.default_cpu_processor();
        Self { config: config.to_owned(), display, view, key, processor, cpu }
    }

    /// The display and the view, as `DISPLAY/VIEW`.
    pub fn name(&self) -> String {
        format!("{}/{}", self.display, self.view)
    }

    /// Text that is another one for a view that shows other colors.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// True if what the curve of sRGB shows stays as it is, within a step of 8 bits.
    pub fn keeps_shown(&self) -> bool {
        let grays = [0.1, 0.5, 0.95].map(|x| [x, x, x, 1.0]);
        let picture = Picture { size: [3, 1], rgba: grays.to_vec() };
        let shown = self.show(&picture);
        let channels = shown.rgba.iter().flatten().zip(grays.iter().flatten());
        channels.into_iter().all(|(shown, plain)| (shown - plain).abs() < 1.0 / 255.0)
    }

    /// The picture by this view: its numbers are those of the display. Colors are shown by
    /// themselves, without what they lie over.
    #[must_use]
    pub fn show(&self, picture: &Picture) -> Picture {
        let mut rgba = picture.rgba.clone();
        let mut colors = Vec::with_capacity(3 * PIXELS.min(rgba.len()));
        for pixels in rgba.chunks_mut(PIXELS) {
            colors.clear();
            colors.extend(pixels.iter().flat_map(|[r, g, b, _]| [r, g, b].map(|x| light_of(*x))));
            self.cpu.apply_rgb_slice(&mut colors);
            for (pixel, color) in pixels.iter_mut().zip(colors.chunks_exact(3)) {
                pixel[..3].copy_from_slice(color);
            }
        }
        Picture { size: picture.size, rgba }
    }

    /// The view as a module for a GPU.
    ///
    /// # Errors
    /// `ocio` with the configuration's name, for a view that no shader computes.
    pub fn module(&self) -> Result<DisplayModule, Diagnostic> {
        module::module(&self.processor).map_err(|error| {
            let (name, why) = (self.name(), error.message());
            let message = tr!("`{name}` has no shader: {why}", why = why.trim());
            let hint = tr!("files are shown by it all the same: chiaro render --view");
            Diagnostic::error("ocio", message).in_file(&self.config).hint(hint)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ACES: &str = "ACES 2.0 - SDR 100 nits (Rec.709)";

    fn picture(colors: &[[f32; 4]]) -> Picture {
        Picture { size: [colors.len() as u32, 1], rgba: colors.to_vec() }
    }

    fn open(config: &str, view: &str) -> Result<DisplayView, Diagnostic> {
        ColorConfig::open(config)?.view(None, view)
    }

    #[test]
    fn views_of_aces_2_show_what_opencolorio_shows() {
        let view = open(BUILT_IN, ACES).unwrap();
        assert_eq!(view.name(), format!("sRGB - Display/{ACES}"));
        // 0.18, (4, 1, 0.2), (-1, 0.5, 2) and (100, 0, 0) of light by OpenColorIO 2.6.0 itself.
        let light = [[0.18, 0.18, 0.18], [4.0, 1.0, 0.2], [-1.0, 0.5, 2.0], [100.0, 0.0, 0.0]];
        let wanted = [
            [0.349_187_6, 0.349_188_1, 0.349_187_9],
            [1.000_006_7, 0.718_709_65, 0.552_602_3],
            [0.0, 0.551_260_95, 0.819_138_5],
            [1.000_006_7, 0.969_510_73, 0.963_176_55],
        ];
        let shown_of = |x: f64| crate::document::linear_to_srgb(x.abs()).copysign(x) as f32;
        let colors: Vec<[f32; 4]> =
            light.iter().map(|[r, g, b]| [shown_of(*r), shown_of(*g), shown_of(*b), 0.5]).collect();
        let made = view.show(&picture(&colors));
        for (made, wanted) in made.rgba.iter().zip(wanted) {
            assert!(made[..3].iter().zip(wanted).all(|(a, b)| (a - b).abs() < 2e-5), "{made:?}");
            assert_eq!(made[3], 0.5);
        }
    }

    #[test]
    fn a_plain_view_is_the_curve_of_srgb() {
        let view = open(BUILT_IN, "sRGB - Display/Un-tone-mapped").unwrap();
        let plain = picture(&[[0.0, 0.25, 1.0, 1.0], [0.7, 0.01, 0.5, 0.2]]);
        assert!(view.keeps_shown() && !open(BUILT_IN, ACES).unwrap().keeps_shown());
        let made = view.show(&plain);
        for (a, b) in made.rgba.iter().flatten().zip(plain.rgba.iter().flatten()) {
            assert!((a - b).abs() < 1e-4, "{a} {b}");
        }
        assert_ne!(view.key(), open(BUILT_IN, ACES).unwrap().key());
        assert!(view.module().unwrap().text.contains("fn shown_by_view("));
    }

    #[test]
    fn views_are_found_by_display_too() {
        let config = ColorConfig::open(BUILT_IN).unwrap();
        let display = "Rec.1886 Rec.709 - Display";
        let by = |display: Option<&str>, view: &str| config.view(display, view);
        assert_eq!(by(Some(display), ACES).unwrap().name(), format!("{display}/{ACES}"));
        assert_eq!(by(Some("rec.1886 REC.709 - display"), ACES).unwrap().name()[..8], *"Rec.1886");
        let told = by(Some("Rec.1886"), ACES).unwrap_err().to_string();
        assert!(told.contains(display) && told.contains("no display `Rec.1886`"), "{told}");
        let told = by(Some(display), "None").unwrap_err().to_string();
        assert!(told.contains("Un-tone-mapped") && told.contains(BUILT_IN), "{told}");
    }

    #[test]
    fn what_is_wrong_is_told_with_a_way_out() {
        let refused = |config: &str, view: &str| open(config, view).unwrap_err().to_string();
        let told = refused(BUILT_IN, "ACES 2.0 - SDR 100 nits (Rec709)");
        assert!(told.contains(ACES) && told.contains("Un-tone-mapped"), "{told}");
        assert!(refused("ocio://nothing", ACES).contains(BUILT_IN));
        assert!(refused("no/config.ocio", ACES).contains("--ocio"));
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("config.ocio");
        let text = "ocio_profile_version: 2\nroles: {default: a, scene_linear: a}\ndisplays:\n  \
                    d:\n    - !<View> {name: v, colorspace: a}\ncolorspaces:\n  - !<ColorSpace> \
                    {name: a}\n";
        std::fs::write(&path, text).unwrap();
        let path = path.to_str().unwrap();
        assert!(refused(path, "v").contains("lin_rec709_scene"));
        std::fs::write(path, text.replace("name: a}", "name: a, aliases: [lin_rec709_scene]}"))
            .unwrap();
        assert_eq!(ColorConfig::open(path).unwrap().names(), ["d/v"]);
        assert!(open(path, "v").is_ok());
        for cut in [0, 20, 60, text.len() - 3] {
            std::fs::write(path, &text[..cut]).unwrap();
            assert!(open(path, "v").is_err(), "{cut}");
        }
    }

    /// A configuration that knows ACES's own space alone gets its light by way of that.
    #[test]
    fn light_comes_by_way_of_aces_where_rec_709_has_no_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("config.ocio");
        let text = "ocio_profile_version: 2\nroles: {aces_interchange: ap0, default: ap0}\n\
                    displays:\n  d:\n    - !<View> {name: v, colorspace: ap0}\ncolorspaces:\n  - \
                    !<ColorSpace> {name: ap0}\n";
        std::fs::write(&path, text).unwrap();
        let view = open(path.to_str().unwrap(), "v").unwrap();
        let [r, g, b, _] = view.show(&picture(&[[1.0, 0.0, 0.0, 1.0]])).rgba[0];
        // The red of Rec. 709 in ACES2065-1.
        for (made, wanted) in [(r, 0.439_63), (g, 0.089_78), (b, 0.017_54)] {
            assert!((made - wanted).abs() < 1e-4_f32, "{r} {g} {b}");
        }
    }
}
