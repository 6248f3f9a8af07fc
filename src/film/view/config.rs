//! Configurations: those of files and those that are built in, and the views that they have.

use ::ocio::{Config, TransformDirection};
use chiaro_locale::tr;

use super::DisplayView;
use crate::diag::Diagnostic;

/// Configuration that is built in, with the views of ACES 2, where nobody names another.
pub const BUILT_IN: &str = "ocio://cg-config-v4.0.0_aces-v2.0_ocio-v2.5";

/// Environment variable with the name of a configuration, by which all programs find it.
pub const VIEW_VARIABLE: &str = "OCIO";

/// Beginning of the names of configurations that are built in.
const SCHEME: &str = "ocio://";

/// Names by which configurations have linear light with the primaries of Rec. 709, in which our
/// pictures are.
const LINEAR_REC709: [&str; 7] = [
    "lin_rec709_scene",
    "lin_rec709_srgb",
    "lin_rec709",
    "Linear Rec.709 (sRGB)",
    "Linear Rec.709",
    "lin_srgb",
    "Utility - Linear - sRGB",
];

/// The greatest file of a configuration, in bytes; studios' have less than one million.
const MAX_CONFIG_BYTES: u64 = 64 << 20;

/// Configuration of OpenColorIO, opened.
#[derive(Debug)]
pub struct ColorConfig {
    name: String,
    config: Config,
}

impl ColorConfig {
    /// Name of the configuration that is meant where `given` is asked for: that one, or `$OCIO`'s,
    /// or [`BUILT_IN`].
    pub fn name_of(given: Option<&str>) -> String {
        let of_system = || std::env::var(VIEW_VARIABLE).ok().filter(|name| !name.is_empty());
        given.map(str::to_owned).or_else(of_system).unwrap_or_else(|| BUILT_IN.to_owned())
    }

    /// Opens a configuration: a file, or one that is built in (`ocio://...`).
    ///
    /// # Errors
    /// `ocio` with the configuration's name and the reason.
    pub fn open(name: &str) -> Result<Self, Diagnostic> {
        if !name.starts_with(SCHEME) {
            let found = std::fs::metadata(name);
            let length = found.map_err(|error| failure(name, &error.to_string()))?.len();
            if length > MAX_CONFIG_BYTES {
                return Err(failure(name, tr!("it is larger than any configuration")));
            }
        }
        let config =
            Config::create_from_file(name).map_err(|error| failure(name, error.message()))?;
        Ok(Self { name: name.to_owned(), config })
    }

    /// Name of the configuration.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The displays, the default first, each with its views.
    pub fn displays(&self) -> Vec<(String, Vec<String>)> {
        let config = &self.config;
        let default = config.default_display();
        let names = (0..config.num_displays()).map(|at| config.display(at));
        let mut displays: Vec<(String, Vec<String>)> = names
            .map(|name| {
                let views = (0..config.num_views(&name)).map(|at| config.view(&name, at)).collect();
                (name, views)
            })
            .collect();
        displays.sort_by_key(|(name, _)| *name != default);
        displays
    }

    /// Names of the views, as `DISPLAY/VIEW`.
    pub fn names(&self) -> Vec<String> {
        let displays = self.displays().into_iter();
        let names = displays.flat_map(|(display, views)| {
            views.into_iter().map(move |view| format!("{display}/{view}"))
        });
        names.collect()
    }

    /// The view of a name, of this display, or else of the first that has it; a name may be
    /// `DISPLAY/VIEW`. Case does not count, as everywhere in OpenColorIO.
    ///
    /// # Errors
    /// `ocio` with the configuration's name, and the displays, the views or the reason.
    pub fn view(&self, display: Option<&str>, view: &str) -> Result<DisplayView, Diagnostic> {
        let found = self.find(display, view)?;
        let (of_display, of_view) = (found.0.as_str(), found.1.as_str());
        let space = LINEAR_REC709.iter().find(|name| self.config.get_color_space(name).is_some());
        let processor = match space {
            Some(space) => self.config.get_display_view_processor(space, of_display, of_view),
            None => {
                // Light goes by way of ACES's own space, which the configuration may name.
                let ours = Self::open(BUILT_IN)?.config;
                let to = TransformDirection::Forward;
                let space = LINEAR_REC709[0];
                Config::get_processor_from_configs_display_view(
                    &ours,
                    space,
                    &self.config,
                    of_display,
                    of_view,
                    to,
                )
            }
        };
        let processor = processor.map_err(|error| match space {
            Some(_) => failure(&self.name, error.message()),
            None => no_light(&self.name, error.message()),
        })?;
        Ok(DisplayView::new(&self.name, found, processor))
    }

    /// The display and the view of a name.
    fn find(&self, display: Option<&str>, view: &str) -> Result<(String, String), Diagnostic> {
        let displays = self.displays();
        let is_named = |name: &str| display.is_none_or(|wanted| wanted.eq_ignore_ascii_case(name));
        let of: Vec<&(String, Vec<String>)> =
            displays.iter().filter(|(name, _)| is_named(name)).collect();
        let wrong = |message: String, wanted: &str, all: String, names: Vec<&str>| {
            Diagnostic::error("ocio", message).in_file(&self.name).suggest(wanted, names).hint(all)
        };
        if let (Some(display), true) = (display, of.is_empty()) {
            let names: Vec<&str> = displays.iter().map(|(name, _)| name.as_str()).collect();
            let message = tr!("the configuration has no display `{display}`");
            let all = tr!("its displays are {names}", names = names.join("; "));
            return Err(wrong(message, display, all, names));
        }
        let pairs = || of.iter().flat_map(|(name, views)| views.iter().map(move |one| (name, one)));
        let full = |name: &str, one: &str| format!("{name}/{one}").eq_ignore_ascii_case(view);
        let found = pairs().find(|(name, one)| one.eq_ignore_ascii_case(view) || full(name, one));
        found.map(|(name, one)| (name.clone(), one.clone())).ok_or_else(|| {
            let message = match display {
                Some(display) => tr!("the display `{display}` has no view `{view}`"),
                None => tr!("the configuration has no view `{view}`"),
            };
            let mut names: Vec<&str> = Vec::new();
            for (_, name) in pairs() {
                if !names.contains(&name.as_str()) {
                    names.push(name);
                }
            }
            let all = tr!("its views are {names}", names = names.join("; "));
            wrong(message, view, all, names)
        })
    }
}

fn failure(config: &str, reason: &str) -> Diagnostic {
    let message = tr!("the color configuration cannot be used: {reason}", reason = reason.trim());
    Diagnostic::error("ocio", message)
        .in_file(config)
        .hint(tr!("name another by --ocio or $OCIO, such as the one that is built in, {BUILT_IN}"))
}

fn no_light(config: &str, reason: &str) -> Diagnostic {
    let message = tr!(
        "the configuration has no linear light with the primaries of Rec. 709, in which pictures \
         are: {reason}",
        reason = reason.trim()
    );
    Diagnostic::error("ocio", message).in_file(config).hint(tr!(
        "give the alias `lin_rec709_scene` to its color space of linear Rec. 709 (sRGB), or name \
         its ACES2065-1 by the role `aces_interchange`"
    ))
}
