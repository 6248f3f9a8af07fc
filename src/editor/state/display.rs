//! Display of the picture by a view of OpenColorIO, in place of the curve of sRGB.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::sync::Arc;

use chiaro_locale::tr;
use serde::{Deserialize, Serialize};

use crate::diag::Diagnostic;
use crate::film::{ColorConfig, DisplayView};
use crate::frame::{DisplayModule, Picture};

/// Choice of a view, as the settings remember it.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct DisplayChoice {
    /// Name of the configuration: a file, or one that is built in.
    pub config: String,
    /// Display that the view is of.
    pub display: String,
    /// The view.
    pub view: String,
}

impl DisplayChoice {
    /// The default view of a configuration.
    ///
    /// # Errors
    /// As [`ColorConfig::open`]; `ocio` for a configuration without views.
    pub(crate) fn first_of(config: &str) -> Result<Self, Diagnostic> {
        let opened = ColorConfig::open(config)?;
        let first = opened.displays().into_iter().find_map(|(display, views)| {
            let view = views.into_iter().next()?;
            Some(Self { config: config.to_owned(), display, view })
        });
        first.ok_or_else(|| {
            Diagnostic::error("ocio", tr!("the configuration has no views")).in_file(config)
        })
    }
}

/// View that the picture is shown by.
#[derive(Clone, Debug)]
pub(crate) struct PictureDisplay {
    pub(crate) choice: Arc<DisplayChoice>,
    view: Arc<DisplayView>,
    module: Arc<DisplayModule>,
    /// Number that is another one for a view that shows other colors.
    number: u128,
}

impl PartialEq for PictureDisplay {
    fn eq(&self, other: &Self) -> bool {
        self.choice == other.choice && self.number == other.number
    }
}

impl PictureDisplay {
    /// Opens the view of a choice.
    ///
    /// # Errors
    /// As [`ColorConfig::open`], [`ColorConfig::view`] and [`DisplayView::module`].
    pub(crate) fn open(choice: DisplayChoice) -> Result<Self, Diagnostic> {
        let config = ColorConfig::open(&choice.config)?;
        let view = config.view(Some(&choice.display), &choice.view)?;
        let module = view.module()?;
        let half = |salt: u8| {
            let mut hasher = DefaultHasher::new();
            (salt, view.key()).hash(&mut hasher);
            u128::from(hasher.finish())
        };
        let number = half(0) << 64 | half(1);
        let (view, module) = (Arc::new(view), Arc::new(module));
        Ok(Self { choice: Arc::new(choice), view, module, number })
    }

    /// The view for a GPU.
    pub(crate) fn module(&self) -> &Arc<DisplayModule> {
        &self.module
    }

    /// The picture as the view shows it.
    pub(crate) fn show(&self, picture: &Picture) -> Picture {
        self.view.show(picture)
    }

    /// Number that is another one for a view that shows other colors.
    pub(crate) fn number(&self) -> u128 {
        self.number
    }
}
