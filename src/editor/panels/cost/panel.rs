//! Table of measured figures.

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use eframe::egui::{FontId, Rect, RichText, ScrollArea, Sense, Ui, pos2, vec2};

use super::{Cost, adopt, now, plot};
use crate::accuracy::{BenchReport, MeasuredTier, MeasurementRow, MeasurementSubject};
use crate::commands::{Command, PanelId};
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::picture_cost::PictureCost;
use crate::state::problem_text::sentence;
use crate::state::reading::tier_word;
use crate::state::session::Session;
use crate::tools::probe::picture_size;
use crate::viewport::picture::ViewportPicture;
use crate::widgets::text::{cell, hint};
use crate::widgets::theme;

pub(in crate::panels) const PANEL: PanelRow = PanelRow::new(
    PanelId::COST,
    text!("Cost and accuracy"),
    text!(
        "What the picture costs, why it needs its passes, and what each tier costs and how far it \
         is from the truth"
    ),
    PanelPlace::BELOW_PICTURE,
    |bench, ui, context| {
        let rect = bench.viewport.rect();
        let size = rect.map_or([0, 0], |rect| picture_size(rect, ui.pixels_per_point()));
        let cost = bench.picture.as_ref().map(ViewportPicture::cost);
        bench.cost.show(ui, context.session, size, cost)
    },
)
.with_jobs(|bench| &bench.cost);

const ROW: f32 = 20.0;
/// Left ends of the columns, as parts of the width.
const COLUMNS: [f32; 5] = [0.0, 0.22, 0.56, 0.7, 0.84];

impl Cost {
    /// Shows the button, the cost of the picture, the plot and the table. `size` is the picture's,
    /// in pixels.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        size: [u32; 2],
        cost: Option<&PictureCost>,
    ) -> Vec<Command> {
        self.update(session);
        if self.worker.is_none() {
            hint(ui, tr!("This window has no GPU, so that there is nothing to measure"));
            return Vec::new();
        }
        let mut out = Vec::new();
        self.head(ui, session, size, cost);
        self.causes(ui, session, &mut out);
        let mut picked = None;
        let area = ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            let row = self.measured(ui, session, &mut picked);
            if let Some(cost) = cost {
                now::show(ui, session, (cost, &self.owners), &mut out);
            }
            row
        });
        if let Some(subject) = picked {
            self.subject = subject;
        }
        out.extend(area.inner.and_then(|row| adopt(session.look(), &row)).map(Command::Edit));
        out
    }

    /// Shows the plot and the table of the last measurement. Returns the row whose tier is to be
    /// adopted.
    fn measured(
        &self,
        ui: &mut Ui,
        session: &Session,
        picked: &mut Option<MeasurementSubject>,
    ) -> Option<MeasurementRow> {
        let Some(done) = &self.done else {
            hint(
                ui,
                tr!("Measure tells time and error of the look and of each node in each tier: the \
                     look within seconds, all of it after a while."),
            );
            return None;
        };
        let report = match &done.result {
            Ok(report) => report,
            Err(found) => {
                for problem in found.iter().take(3) {
                    ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
                }
                return None;
            }
        };
        let rows: Vec<&MeasurementRow> = report
            .rows
            .iter()
            .filter(|row| row.subject == self.subject && row.error.is_some())
            .collect();
        let plotted = match rows.is_empty() {
            true => None,
            false => plot::show(ui, &rows, name(&self.subject), |row| in_use(session, row)),
        };
        ui.add_space(6.0);
        ui.spacing_mut().item_spacing.y = 0.0;
        table(ui, session, report, &self.subject, picked).or(plotted)
    }

    fn head(&mut self, ui: &mut Ui, session: &Session, size: [u32; 2], cost: Option<&PictureCost>) {
        ui.horizontal_wrapped(|ui| {
            if self.is_measuring() {
                let [done, total] = self.progress.steps();
                let share = self.progress.share() as f32;
                let text =
                    if total == 0 { tr!("starting").to_owned() } else { tr!("{done} of {total}") };
                ui.add(egui::ProgressBar::new(share).desired_width(160.0).text(text));
                if ui.button(tr!("Stop")).clicked() {
                    self.stop();
                }
                return this_picture(ui, cost);
            }
            let help =
                tr!("Draws the look and each of its nodes in each tier, and holds them against \
                     the truth in f64");
            if ui.button(tr!("Measure")).on_hover_text(help).clicked() {
                self.start(session, size);
            }
            this_picture(ui, cost);
            let Some(report) = self.report() else { return };
            if !self.is_current.1 {
                let help = tr!("The look was changed since, by more than its tiers");
                ui.label(RichText::new(tr!("of before")).color(theme::of(ui).warning))
                    .on_hover_text(help);
            }
            let [width, height] = report.size;
            let clock = if report.has_timestamps {
                tr!("GPU timestamps")
            } else {
                tr!("the clock on the wall")
            };
            let text = tr!("{width}×{height} on {adapter}", adapter = report.adapter);
            let rounds = trn!(rounds = report.rounds, "{rounds} round", "{rounds} rounds");
            let mut told = format!("{text}\n{rounds}, {clock}");
            if report.is_software {
                told = tr!("{told}; software, not a GPU");
            }
            ui.add(egui::Label::new(RichText::new(&text).color(theme::of(ui).dim)).truncate())
                .on_hover_text(told);
        });
        ui.add_space(2.0);
    }
}

/// Shows what the picture cost that was drawn last.
fn this_picture(ui: &mut Ui, cost: Option<&PictureCost>) {
    if let Some(cost) = cost.filter(|cost| !cost.passes.is_empty()) {
        ui.label(tr!("This picture: {cost}", cost = cost.short())).on_hover_text(now::TIMED.tr());
    }
}

fn name(subject: &MeasurementSubject) -> String {
    match subject {
        MeasurementSubject::Whole => tr!("Whole look").to_owned(),
        MeasurementSubject::Pass(kind) => tr!("{name} pass", name = kind.title()),
        MeasurementSubject::Node { name, .. } => name.clone(),
    }
}

/// True if the look has this row's tier now.
fn in_use(session: &Session, row: &MeasurementRow) -> bool {
    row.tier.is_choice() && subject_is_there(session, row) && adopt(session.look(), row).is_none()
}

/// True if the look still has the node that this row measured.
fn subject_is_there(session: &Session, row: &MeasurementRow) -> bool {
    match &row.subject {
        MeasurementSubject::Whole => true,
        MeasurementSubject::Pass(_) => false,
        MeasurementSubject::Node { id, .. } => session.look().graph.nodes.contains_key(id),
    }
}

fn column(rect: Rect, index: usize) -> Rect {
    let x = |part: f32| rect.left() + part * rect.width();
    let end = COLUMNS.get(index + 1).copied().unwrap_or(1.0);
    Rect::from_min_max(pos2(x(COLUMNS[index]), rect.top()), pos2(x(end) - 6.0, rect.bottom()))
}

/// Shows the rows, by subject. A click on a subject plots it; a click on a tier returns the row
/// whose tier is to be adopted.
fn table(
    ui: &mut Ui,
    session: &Session,
    report: &BenchReport,
    plotted: &MeasurementSubject,
    picked: &mut Option<MeasurementSubject>,
) -> Option<MeasurementRow> {
    let (head, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    for (index, title) in
        [tr!("Tier"), tr!("Milliseconds (95%)"), tr!("Max error"), "RMS", "> 1/255"]
            .into_iter()
            .enumerate()
    {
        cell(
            ui,
            column(head, index),
            title,
            FontId::proportional(theme::SMALL_TEXT),
            theme::of(ui).dim,
        );
    }
    let mut chosen = None;
    let mut last: Option<&MeasurementSubject> = None;
    for row in report.rows.iter().filter(|row| !matches!(row.subject, MeasurementSubject::Pass(_)))
    {
        if last != Some(&row.subject) {
            last = Some(&row.subject);
            if subject(ui, &row.subject, row.subject == *plotted) {
                *picked = Some(row.subject.clone());
            }
        }
        if figures(ui, session, row) {
            chosen = Some(row.clone());
        }
    }
    chosen
}

fn subject(ui: &mut Ui, subject: &MeasurementSubject, is_plotted: bool) -> bool {
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), ROW + 2.0), Sense::click());
    let name = name(subject);
    response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, tr!("Plot {name}")));
    let color =
        if is_plotted || response.hovered() { theme::of(ui).accent } else { theme::of(ui).text };
    cell(ui, rect, &name, FontId::proportional(theme::TEXT_SIZE), color);
    ui.painter().hline(
        rect.x_range(),
        rect.bottom() - 1.0,
        egui::Stroke::new(1.0, theme::of(ui).grid),
    );
    response.on_hover_text(tr!("A click plots this one")).clicked()
}

fn figures(ui: &mut Ui, session: &Session, row: &MeasurementRow) -> bool {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    let word = tier_name(row.tier);
    let label = tr!("Adopt {tier} for {name}", tier = word, name = name(&row.subject));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, label.clone()));
    let is_used = in_use(session, row);
    if is_used {
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).accent_dim.gamma_multiply(0.4));
    } else if response.hovered() && row.tier.is_choice() {
        ui.painter().rect_filled(rect, 2.0, theme::of(ui).field.gamma_multiply(0.6));
    }
    ui.painter().circle_filled(
        pos2(rect.left() + 7.0, rect.center().y),
        3.5,
        theme::of(ui).of_tier(row.tier),
    );
    let mut first = column(rect, 0);
    first.min.x += 16.0;
    cell(ui, first, word, FontId::proportional(theme::TEXT_SIZE), theme::of(ui).text);
    let time = &row.time;
    let is_noise = matches!(row.subject, MeasurementSubject::Node { .. }) && time.is_noise();
    // Only as many decimals are shown as the interval supports.
    let places = if time.high - time.low > 1.0 {
        0
    } else if time.high - time.low > 0.1 {
        1
    } else {
        2
    };
    let [median, low, high] =
        [time.median, time.low, time.high].map(|time| format!("{time:.places$}"));
    // One drawing has no interval.
    let text =
        if time.high > time.low { tr!("{median}  ({low} to {high})") } else { median.clone() };
    let mono = FontId::monospace(11.0);
    cell(
        ui,
        column(rect, 1),
        &text,
        mono.clone(),
        if is_noise { theme::of(ui).dim } else { theme::of(ui).text },
    );
    if let Some(error) = &row.error {
        let ink = |bad: bool| if bad { theme::of(ui).warning } else { theme::of(ui).text };
        cell(ui, column(rect, 2), &small(error.max), mono.clone(), ink(error.max > 1.0 / 255.0));
        cell(ui, column(rect, 3), &small(error.rms), mono.clone(), theme::of(ui).text);
        cell(ui, column(rect, 4), &error.visible.to_string(), mono, ink(error.visible > 0));
    }
    let clicked = response.clicked() && row.tier.is_choice();
    response.on_hover_text(told(row, is_used));
    clicked
}

/// Description of a row in words.
pub(super) fn told(row: &MeasurementRow, is_used: bool) -> String {
    let mut lines = vec![format!("{}, {}", name(&row.subject), tier_name(row.tier))];
    let time = &row.time;
    let median = time.median;
    lines.push(match time.high > time.low {
        true => {
            tr!("{median:.3} ms, 95% from {low:.3} to {high:.3}", low = time.low, high = time.high)
        }
        false => tr!("{median:.3} ms, drawn once"),
    });
    if matches!(row.subject, MeasurementSubject::Node { .. }) {
        let line = if time.is_noise() {
            tr!("nothing seen beyond noise")
        } else {
            tr!("added by the node")
        };
        lines.push(line.to_owned());
    }
    if let Some(sizes) = &row.sizes {
        let megabytes = sizes.traffic as f64 / f64::from(1 << 20);
        lines.push(tr!(
            "{count} instructions, {megabytes:.1} MiB moved in a frame, as counted",
            count = sizes.instructions
        ));
    }
    if let Some(error) = &row.error {
        let [x, y] = error.worst;
        lines.push(tr!(
            "error max {max} at pixel {x}, {y}; rms {rms}",
            max = small(error.max),
            rms = small(error.rms)
        ));
        lines.push(tr!(
            "{count} of {all} pixels over 1/255",
            count = error.visible,
            all = error.pixels
        ));
    }
    if row.tier.is_choice() {
        let line = if is_used { tr!("In use") } else { tr!("A click adopts it") };
        lines.push(line.to_owned());
    }
    lines.join("\n")
}

/// Name of a tier, as it stands within a sentence.
pub(super) fn tier_name(tier: MeasuredTier) -> &'static str {
    match tier {
        MeasuredTier::Named(tier) => tier_word(tier),
        MeasuredTier::Automatic => tr!("automatic"),
        MeasuredTier::AsSet => tr!("as set"),
    }
}

fn small(number: f64) -> String {
    if number == 0.0 { "0".to_owned() } else { format!("{number:.1e}") }
}
