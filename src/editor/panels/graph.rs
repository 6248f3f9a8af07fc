//! Panel of the look's graph, which takes nodes that are dragged onto it. The sheet of a wedge is
//! shown in its place while it is large.

use chiaro_locale::text;

use super::library;
use super::table::{PanelPlace, PanelRow, PanelStack};
use crate::commands::{Command, PanelId};
use crate::tools::probe::Probe;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::GRAPH,
    text!("Graph"),
    text!("The nodes of the look and their wires"),
    PanelPlace { stack: Some(PanelStack::Graph), fills_room: true, ..PanelPlace::CLOSED },
    |bench, ui, context| {
        if bench.wedge.is_large() {
            return bench.wedge.show_large(ui, context.session);
        }
        let rect = ui.max_rect();
        bench.canvas.take_shares(|| bench.cost.shares());
        let (readings, is_current) = bench.tools.of::<Probe>().readings();
        bench.canvas.take_readings(readings, is_current);
        let mut commands = bench.canvas.show(ui, context.session);
        let dropped = library::dropped(ui, rect);
        commands.extend(dropped.map(|(kind, at)| Command::AddNode { kind, at: Some(at) }));
        commands
    },
)
.with_jobs(|bench| &bench.canvas);
