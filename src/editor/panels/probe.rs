//! Panel of the values that the probe reads.

use chiaro_locale::text;

use super::table::{PanelPlace, PanelRow};
use crate::commands::PanelId;
use crate::tools::probe::Probe;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::PROBE,
    text!("Probe"),
    text!("The value on every wire at a pixel, f32 beside f64 (I)"),
    PanelPlace::BELOW_PICTURE,
    |bench, ui, context| bench.tools.of_mut::<Probe>().show(ui, context.session),
)
.with_jobs(|bench| &bench.tools);
