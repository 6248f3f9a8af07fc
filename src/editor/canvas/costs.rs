//! Costs of nodes, shown above them on request: operations at each fragment in the tier that a node
//! has and in the others, and the share of the time that was measured.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Align2, Context, FontId, Ui, vec2};

use super::Canvas;
use super::draw::SOCKETS;
use crate::diag::Diagnostic;
use crate::document::{Look, Tier};
use crate::frame::{TierCosts, TierOperations, tier_costs};
use crate::ids::NodeId;
use crate::library::Library;
use crate::state::revision::{DocumentNumber, MeaningRevision};
use crate::state::session::Session;
use crate::state::worker::Worker;
use crate::widgets::theme;

/// Size of the text, in points of the graph.
const TEXT: f32 = 13.0;

/// Version of a look, as far as its picture goes.
type Version = (DocumentNumber, MeaningRevision);

struct Request {
    version: Version,
    look: Arc<Look>,
    library: Arc<Library>,
}

struct Answer {
    version: Version,
    costs: Result<Vec<TierCosts>, Vec<Diagnostic>>,
}

/// Costs of the open look's nodes.
#[derive(Default)]
pub(super) struct Costs {
    is_shown: bool,
    worker: Option<Worker<Request, Answer>>,
    asked: Option<Version>,
    /// By path, so that what a group holds stands together.
    known: BTreeMap<String, TierCosts>,
    /// Share of the picture's time that each node takes, where that was measured.
    shares: HashMap<NodeId, f64>,
}

impl Costs {
    /// Shows the costs, or hides them.
    pub(super) fn toggle(&mut self) {
        self.is_shown = !self.is_shown;
    }

    pub(super) fn is_shown(&self) -> bool {
        self.is_shown
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    pub(super) fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
    }

    /// Takes finished counts, and asks for those of a look that has changed.
    fn update(&mut self, ctx: &Context, session: &Session) {
        let version = (session.revisions().document, session.revisions().meaning);
        for answer in self.worker.iter().flat_map(Worker::answers) {
            // The costs of a look with errors are those of the last one without.
            if let (true, Ok(costs)) = (answer.version.0 == version.0, answer.costs) {
                self.known = costs.into_iter().map(|costs| (costs.node.clone(), costs)).collect();
            }
        }
        if self.asked == Some(version) || session.journals.held().is_some() {
            return;
        }
        if self.asked.is_some_and(|(document, _)| document != version.0) {
            self.known.clear();
        }
        self.asked = Some(version);
        let request = Request {
            version,
            look: Arc::new(session.look().clone()),
            library: session.project.library.clone(),
        };
        let worker = self.worker.get_or_insert_with(|| {
            let ctx = ctx.clone();
            Worker::new(
                "costs",
                move || ctx.request_repaint(),
                |Request { version, look, library }| Answer {
                    version,
                    costs: tier_costs(&look, &library),
                },
            )
        });
        worker.request(|_| request);
    }

    /// Costs of a node of the graph that is open through these groups, all that a group holds
    /// together; `None` for a node that does nothing at fragments.
    fn of(&self, groups: &[NodeId], node: &NodeId) -> Option<String> {
        let mut path: Vec<&str> = groups.iter().map(AsRef::as_ref).collect();
        path.push(node.as_ref());
        let path = path.join("/");
        let inside = format!("{path}/");
        let held = self.known.range(inside.clone()..);
        let held = held.take_while(|(other, _)| other.starts_with(&inside));
        let held = held.map(|(_, costs)| costs);
        let parts: Vec<&TierCosts> = self.known.get(&path).into_iter().chain(held).collect();
        let own: u64 = parts.iter().map(|costs| costs.operations.of(costs.tier)).sum();
        if parts.iter().all(|costs| costs.operations == TierOperations::default()) {
            return None;
        }
        let mut told = vec![tr!("{own} ops")];
        for other in [Tier::Exact, Tier::Balanced, Tier::Fast] {
            let there: u64 = parts.iter().map(|costs| costs.operations.of(other)).sum();
            if there != own {
                told.push(match other {
                    Tier::Exact => tr!("exact {there}"),
                    Tier::Balanced => tr!("balanced {there}"),
                    Tier::Fast => tr!("fast {there}"),
                });
            }
        }
        if let Some(share) = self.shares.get(node).filter(|_| groups.is_empty()) {
            told.push(tr!("{share:.0}% of the time when exact", share = 100.0 * share));
        }
        Some(told.join(", "))
    }
}

impl Canvas {
    /// Takes the measured share that each node of the look has in the picture's time, which is
    /// asked for while costs are shown.
    pub(crate) fn take_shares(&mut self, shares: impl FnOnce() -> HashMap<NodeId, f64>) {
        if self.costs.is_shown() {
            self.costs.shares = shares();
        }
    }

    /// Shows what each node in view costs, above the node.
    pub(super) fn draw_costs(&mut self, ui: &Ui, session: &Session) {
        if !self.costs.is_shown() {
            return;
        }
        self.costs.update(ui.ctx(), session);
        if self.view.zoom <= SOCKETS {
            return;
        }
        let visible = self.view.visible();
        let painter = ui.painter_at(self.view.screen);
        let (font, color) = (FontId::proportional(TEXT * self.view.zoom), theme::of(ui).text);
        for row in self.table.nodes.iter().filter(|row| row.rect.intersects(visible)) {
            if let Some(text) = self.costs.of(session.selection.open_groups(), &row.id) {
                let corner = self.view.to_screen(row.rect.min);
                let at = corner + vec2(4.0, -3.0) * self.view.zoom;
                painter.text(at, Align2::LEFT_BOTTOM, text, font.clone(), color);
            }
        }
    }

    /// The cost that is shown above a node, for tests.
    pub fn cost_text(&self, id: &str) -> Option<String> {
        self.costs.of(&self.place, &NodeId::from(id))
    }
}
