//! `--view`, `--display` and `--ocio`: how light is shown in files of what a display shows.

use serde_json::json;

use crate::diag::Diagnostic;
use crate::film::{ColorConfig, DisplayView, StoredFrame};
use crate::frame::Picture;
use crate::output::Output;

/// Arguments of commands that write what a display shows.
#[derive(Clone, Debug, clap::Args)]
#[group(skip)]
pub(super) struct ViewArguments {
    /// Shows light by a view of OpenColorIO, such as `ACES 2.0 - SDR 100 nits (Rec.709)`, or
    /// `DISPLAY/VIEW`; `chiaro render --list-views` lists them [default: the curve of sRGB]
    #[arg(long)]
    view: Option<String>,
    /// Display that the view is of [default: the first that has the view]
    #[arg(long, requires = "view")]
    display: Option<String>,
    /// OpenColorIO's configuration: a file, or one that is built in (ocio://...) [default: $OCIO,
    /// or a built-in one with the views of ACES 2]
    #[arg(long, value_name = "CONFIG")]
    ocio: Option<String>,
}

impl ViewArguments {
    /// True if a view was asked for.
    pub(super) fn is_asked(&self) -> bool {
        self.view.is_some()
    }

    /// The view that was asked for; `None` for the curve of sRGB.
    ///
    /// # Errors
    /// As [`ColorConfig::open`] and [`ColorConfig::view`]; `bad-argument` for a configuration
    /// without a view.
    pub(super) fn open(&self) -> Result<Option<DisplayView>, Diagnostic> {
        match (&self.view, &self.ocio) {
            (None, None) => Ok(None),
            (None, Some(_)) => {
                let message = "--ocio names a configuration, and no view of it is asked for";
                let hint = "add --view; chiaro render --list-views --ocio CONFIG lists them";
                Err(Diagnostic::error("bad-argument", message).hint(hint))
            }
            (Some(view), _) => self.config()?.view(self.display.as_deref(), view).map(Some),
        }
    }

    /// Lists the views of the configuration.
    ///
    /// # Errors
    /// As [`ColorConfig::open`].
    pub(super) fn list(&self, output: &Output, has_json: bool) -> Result<(), Diagnostic> {
        let config = self.config()?;
        if has_json {
            let displays = config.displays().into_iter();
            let displays =
                displays.map(|(display, views)| json!({"display": display, "views": views}));
            let displays: Vec<_> = displays.collect();
            output.json(&json!({"config": config.name(), "displays": displays}));
        } else {
            output.message(config.name());
            config.names().iter().for_each(|name| output.result(name));
        }
        Ok(())
    }

    fn config(&self) -> Result<ColorConfig, Diagnostic> {
        ColorConfig::open(&ColorConfig::name_of(self.ocio.as_deref()))
    }
}

/// The picture of a frame as it is shown, over a backdrop.
///
/// # Errors
/// As [`StoredFrame::over`]; `bad-argument` where a view is asked for of what is shown already.
pub(super) fn shown(
    frame: &StoredFrame,
    backdrop: [f64; 3],
    view: Option<&DisplayView>,
) -> Result<Picture, Diagnostic> {
    let picture = frame.over(backdrop)?;
    match view {
        None => Ok(picture),
        Some(view) if frame.is_light() => Ok(view.show(&picture)),
        Some(_) => {
            let message = "a view shows light, and this file has what is shown already";
            let hint = "draw EXRs, or draw the PNGs by the view: chiaro render --view";
            Err(Diagnostic::error("bad-argument", message).hint(hint))
        }
    }
}
