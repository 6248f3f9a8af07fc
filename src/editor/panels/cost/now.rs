//! Cost of the picture as it was just drawn: its time, its passes with their causes, and the shares
//! of its nodes.

use std::sync::Arc;

use chiaro_locale::{Text, text, tr, trn};
use eframe::egui::{Label, ProgressBar, RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::Cost;
use super::causes::{CauseRequest, CauseValue, PassCause};
use crate::catalog::values;
use crate::commands::Command;
use crate::ids::NodeId;
use crate::progress::Progress;
use crate::state::picture_cost::{PictureCost, time_text};
use crate::state::session::Session;
use crate::widgets::theme;

/// Most nodes whose shares are listed.
const MOST_NODES: usize = 8;
/// Least width of the bar of a share, in points.
const SHARE: f32 = 112.0;
/// Least share that is listed.
const LEAST_SHARE: f64 = 0.01;

/// Help on the time of the picture.
pub(super) const TIMED: Text = text!(
    "From when the picture was handed to the GPU until the GPU was done, by the clock on the \
     wall: other work of the GPU counts, too. Measure tells more, by the GPU's own clock if there \
     is one."
);

impl Cost {
    /// Shows the values that passes are needed for.
    pub(super) fn causes(&mut self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        self.ask_for_causes(session);
        for cause in &self.causes {
            show_cause(ui, session, cause, out);
        }
    }

    /// Asks for the causes of passes, where the look has changed.
    fn ask_for_causes(&mut self, session: &Session) {
        for (of, causes) in self.causer.answers() {
            if Some(of) == self.causes_of {
                self.causes = causes;
            }
        }
        let revision = (session.revisions().document, session.revision());
        if self.causes_of == Some(revision) || session.is_compiling() {
            return;
        }
        self.causes_of = Some(revision);
        self.cause_search.stop();
        self.causes.clear();
        let look = Arc::new(session.look().clone());
        let library = session.project.library.clone();
        self.cause_search = Progress::new();
        let progress = self.cause_search.clone();
        self.causer.request(|_| (revision, CauseRequest { look, library, progress }));
    }
}

/// Shows the passes of the picture with their reasons, and the shares of its nodes.
pub(super) fn show(ui: &mut Ui, session: &Session, cost: &PictureCost, out: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 3.0;
    let dim = theme::of(ui).dim;
    for pass in cost.passes_before() {
        let text = format!("{}: {}", pass.label(), pass.words());
        ui.add(Label::new(RichText::new(text).small().color(dim)).wrap());
    }
    shares(ui, session, cost, out);
}

/// Shows values that passes are needed for, with the button that takes them away.
fn show_cause(ui: &mut Ui, session: &Session, cause: &PassCause, out: &mut Vec<Command>) {
    let names: Vec<String> = cause.values.iter().map(|value| name(session, value)).collect();
    let passes: Vec<&str> = cause.passes.iter().map(|pass| pass.title()).collect();
    let text = cost_text(&names, &passes);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(&text).color(theme::of(ui).warning));
        let (label, help) = match names.len() {
            1 => (tr!("Set to 0"), tr!("The passes go with it. Undo brings both back.")),
            _ => (tr!("Set all to 0"), tr!("The passes go with them. Undo brings all back.")),
        };
        let button = ui.button(label).on_hover_text(help);
        button.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{label}: {text}")));
        if button.clicked() {
            out.push(Command::Edit(cause.cure()));
        }
    });
}

/// Sentence on values that passes are needed for.
fn cost_text(names: &[String], passes: &[&str]) -> String {
    let count = passes.len();
    let passes = passes.join(", ");
    match names {
        [name] if count == 2 => tr!("{name} costs two passes ({passes})"),
        [name] => {
            trn!(count, "{name} costs a pass ({passes})", "{name} costs {count} passes ({passes})")
        }
        names => {
            let names = names.join(tr!(" and "));
            if count == 2 {
                tr!("{names} together cost two passes ({passes})")
            } else {
                trn!(
                    count,
                    "{names} together cost a pass ({passes})",
                    "{names} together cost {count} passes ({passes})"
                )
            }
        }
    }
}

/// A value in words: "this slope of 0.2" is "Shape slope 0.2 of Rim".
fn name(session: &Session, value: &CauseValue) -> String {
    let look = session.look_with_library();
    let target = value.target();
    let [owner, label] = look.names_of(&target);
    let now = look.port_at(&target).map(|port| values::short(&port, &value.now));
    tr!("{label} {value} of {owner}", value = now.unwrap_or_default())
}

/// Shows the share of each node, as an estimate.
fn shares(ui: &mut Ui, session: &Session, cost: &PictureCost, out: &mut Vec<Command>) {
    let mut nodes: Vec<(&NodeId, f64)> =
        cost.operations.keys().map(|id| (id, cost.share(id))).collect();
    nodes.retain(|(_, share)| *share >= LEAST_SHARE);
    nodes.sort_by(|a, b| b.1.total_cmp(&a.1));
    if nodes.is_empty() {
        return;
    }
    let text = RichText::new(tr!("By layer, estimated")).small().color(theme::of(ui).dim);
    ui.label(text).on_hover_text(tr!(
        "The operations that are counted in each node's code, as a share of the picture's time: \
         textures and passes are not in it. Measure draws the look with each node and without."
    ));
    for (id, share) in nodes.into_iter().take(MOST_NODES) {
        let title = session.look_with_library().title(id);
        let percent = share * 100.0;
        let text = match cost.milliseconds.map(|time| time_text(time * share)) {
            Some(time) => tr!("{percent:.0} %, some {time}"),
            None => format!("{percent:.0} %"),
        };
        ui.horizontal(|ui| {
            // The bar has room for its words, and the name is shortened.
            let width = (ui.available_width() * 0.4).clamp(SHARE, 160.0);
            ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
            let bar = ProgressBar::new(share as f32).desired_width(width);
            ui.add(bar.text(RichText::new(text).small()));
            let help = format!("{title}\n{}", tr!("Selects it and brings it into view"));
            let link = ui.link(title).on_hover_text(help);
            if link.clicked() {
                out.push(Command::Reveal(id.clone()));
            }
        });
    }
}
