//! Panel of the look's fit to the light that is painted on the picture.

use chiaro_locale::text;

use super::table::{PanelPlace, PanelRow};
use crate::commands::PanelId;
use crate::tools::fitting::FitTool;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::FIT,
    text!("Paint light"),
    text!(
        "Paint on the picture where it should be lighter or darker: the look is fitted to that (L)"
    ),
    PanelPlace::BELOW_PICTURE.closed(),
    |bench, ui, context| bench.tools.of_mut::<FitTool>().show(ui, context.session),
);
