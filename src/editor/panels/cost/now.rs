//! Cost of the picture as it was just drawn: its time, its passes with their causes, and the shares
//! of its nodes.

use std::sync::Arc;

use chiaro_locale::{Text, text, tr, trn};
use eframe::egui::{Label, ProgressBar, RichText, Role, TextWrapMode, Ui, WidgetInfo};

use super::Cost;
use super::causes::{CauseRequest, CauseValue, PassCause};
use crate::catalog::values;
use crate::commands::Command;
use crate::progress::Progress;
use crate::state::picture_cost::PictureCost;
use crate::state::session::Session;
use crate::state::stack::owners::{LayerOwner, LayerOwners, LayerShare};
use crate::widgets::theme;

/// Most layers whose shares are listed, and most nodes that are named for one.
const MOST_LAYERS: usize = 8;
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

/// Shows the passes of the picture with their reasons, and the shares of its layers.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    (cost, owners): (&PictureCost, &LayerOwners),
    out: &mut Vec<Command>,
) {
    ui.spacing_mut().item_spacing.y = 3.0;
    let dim = theme::of(ui).dim;
    for pass in cost.passes_before() {
        let text = format!("{}: {}", pass.label(), pass.words());
        ui.add(Label::new(RichText::new(text).small().color(dim)).wrap());
    }
    shares(ui, session, (cost, owners), out);
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

/// Shows the share of each layer, as an estimate.
fn shares(
    ui: &mut Ui,
    session: &Session,
    (cost, owners): (&PictureCost, &LayerOwners),
    out: &mut Vec<Command>,
) {
    let shares =
        owners.shares(&cost.operations).into_iter().filter(|share| share.share >= LEAST_SHARE);
    let shares: Vec<LayerShare> = shares.take(MOST_LAYERS).collect();
    if shares.is_empty() {
        return;
    }
    let text = RichText::new(tr!("By layer, estimated")).small().color(theme::of(ui).dim);
    ui.label(text).on_hover_text(tr!(
        "The operations that are counted in the code of a layer and of the nodes that feed it \
         alone, as a share of the picture's time: textures and passes are not in it. Measure \
         draws the look with each node and without."
    ));
    let look = session.look_with_library();
    for share in shares {
        let (title, shown) = match &share.owner {
            LayerOwner::One(id) => (look.title(id), Some(id)),
            LayerOwner::Several => {
                (tr!("Shared by several layers").to_owned(), share.nodes.first())
            }
        };
        let text = cost.share_text(share.share);
        ui.horizontal(|ui| {
            // The bar has room for its words, and the name is shortened.
            let width = (ui.available_width() * 0.4).clamp(SHARE, 160.0);
            ui.style_mut().wrap_mode = Some(TextWrapMode::Truncate);
            let bar = ProgressBar::new(share.share as f32).desired_width(width);
            ui.add(bar.text(RichText::new(text).small()));
            let own: Vec<String> =
                share.nodes.iter().take(MOST_LAYERS).map(|id| look.title(id)).collect();
            let nodes = own.join(", ");
            let help = format!("{title}\n{nodes}\n{}", tr!("Selects it and brings it into view"));
            let link = ui.link(title).on_hover_text(help);
            if let Some(id) = shown.filter(|_| link.clicked()) {
                out.push(Command::Reveal(id.clone()));
            }
        });
    }
}
