//! Panel of painted light: the painting, the settings of the fit, and its result.

use chiaro_locale::{tr, trn};
use eframe::egui;
use eframe::egui::{
    Button, Color32, ProgressBar, RichText, Role, ScrollArea, Ui, WidgetInfo, vec2,
};

use super::fit::FitOutcome;
use super::{FitTool, target};
use crate::commands::{Command, FitCommand, FitGoal, Switch};
use crate::document::{Target, parse_hex};
use crate::fit::{FitReport, KnobCounts, LookChange};
use crate::ids::NodePath;
use crate::state::problem_text::sentence;
use crate::state::reading::LookWithLibrary;
use crate::state::session::Session;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::text::hint;
use crate::widgets::theme;

/// Largest number of layers that can be fitted from nothing here.
pub(super) const MOST_LAYERS: usize = 5;
/// Least share of the error whose loss is told as a success, 0 to 1.
const LEAST_SHARE: f64 = 0.2;

impl FitTool {
    /// Shows the panel.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        if !self.is_on {
            let help = tr!("Paint on the picture where it should be lighter or darker (L)");
            if ui.button(tr!("Paint light on the picture")).on_hover_text(help).clicked() {
                out.push(Command::Fit(FitCommand::Turn(Switch::On)));
            }
            hint(
                ui,
                tr!("Paint on the picture where it should be lighter, darker or of a color (L). \
                     The lights, profiles and colors of the look are then fitted to that, and stay \
                     an ordinary look."),
            );
            return out;
        }
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            self.painted_row(ui, session, &mut out);
            ui.separator();
            // A result that waits for a decision comes first, and hides the other choices.
            if !self.awaits() || self.running.is_some() {
                self.fit_row(ui, &mut out);
            }
            if let Some(told) = &self.told {
                ui.label(RichText::new(told).color(theme::of(ui).accent));
            }
            if let Some(outcome) = &self.outcome {
                if outcome.applied.is_some() {
                    ui.separator();
                }
                self.result(ui, outcome, session, &mut out);
            }
        });
        out
    }

    fn painted_row(&mut self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        let is_empty = session.sketchbook.sketch().is_empty();
        ui.horizontal_wrapped(|ui| {
            let ground = self.grounds.latest();
            if let Some(problem) = self.grounds.problem() {
                ui.label(RichText::new(sentence(problem)).color(theme::of(ui).error));
                return;
            }
            let text = match (is_empty, ground) {
                (true, _) => tr!("Nothing is painted yet: drag on the object").to_owned(),
                (false, Some(ground)) => {
                    let off = target::off(self.goals(), |pixel| Some(target::shown(ground, pixel)));
                    trn!(
                        count = self.goals().len(),
                        "{count} pixel painted, off by {off}",
                        "{count} pixels painted, off by {off}",
                        off = steps(off)
                    )
                }
                (false, None) => tr!("Reading the picture").to_owned(),
            };
            let [width, height] = self.size(session);
            let help = tr!(
                "It is fitted at {width} by {height} pixels. Errors are RMS of a channel over what \
                 is painted, as the picture shows it now"
            );
            ui.label(text).on_hover_text(help);
        });
        ui.horizontal_wrapped(|ui| {
            ui.toggle_value(&mut self.shows.strokes, tr!("Strokes"))
                .on_hover_text(tr!("Shows what the strokes wish"));
            let help = tr!("Where the picture is not as painted: black where it is, over red and \
                            yellow to white");
            ui.toggle_value(&mut self.shows.misses, tr!("Misses")).on_hover_text(help);
            let help = tr!("Takes all strokes away; undo brings them back");
            if ui.add_enabled(!is_empty, Button::new(tr!("Clear"))).on_hover_text(help).clicked() {
                out.push(Command::Fit(FitCommand::Clear));
            }
        });
    }

    fn how_rows(&mut self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            ui.label(tr!("Keep"))
                .on_hover_text(tr!("What of this look stays as it is; all else is turned"));
            let keep = &mut self.how.keep;
            for (kept, label, help) in [
                (&mut keep.lights, tr!("Lights"), tr!("Directions of directional lights stay")),
                (&mut keep.profiles, tr!("Profiles"), tr!("Offsets, fall-offs and cut-offs stay")),
                (
                    &mut keep.colors,
                    tr!("Colors"),
                    tr!("Colors stay: of layers, ramps and the base"),
                ),
                (&mut keep.base, tr!("Base"), tr!("The color of the base stays")),
            ] {
                let name = tr!("Keep: {label}");
                let response = ui.checkbox(kept, label).on_hover_text(help);
                response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, *kept, &name));
            }
        });
        ui.horizontal_wrapped(|ui| {
            let help = tr!(
                "How far what is not painted stays as it is: at 0% only strokes count, and the \
                 rest becomes what it will; at 100% it moves only where strokes cannot be met \
                 otherwise"
            );
            let label = ui.label(tr!("Keep the rest")).on_hover_text(help);
            let mut percent = self.how.keep_rest * 100.0;
            let slider = number_slider(ui, &mut percent, 0.0..=100.0).max_decimals(0).suffix("%");
            if ui.add(slider).labelled_by(label.id).on_hover_text(help).changed() {
                self.how.keep_rest = percent / 100.0;
            }
        });
    }

    /// Shows the result of a fit.
    fn result(&self, ui: &mut Ui, outcome: &FitOutcome, session: &Session, out: &mut Vec<Command>) {
        let report = &outcome.report;
        errors(ui, report);
        if outcome.applied.is_none() && report.is_far_off() {
            let advice = self.advice(outcome.what, report);
            let colors = theme::of(ui);
            let (text, ink) = match (percent_nearer(report), outcome.what) {
                (Some(percent), _) => (
                    tr!("{percent} % of the way. Misses shows where it is still off. {advice}"),
                    colors.text,
                ),
                (None, FitGoal::Local) => (
                    tr!(
                        "Layers over the look found nothing nearer: Misses shows where it is off. \
                         {advice}"
                    ),
                    colors.accent,
                ),
                (None, FitGoal::ThisLook | FitGoal::Layers(_)) => (
                    tr!(
                        "Turning {tried} found nothing nearer: Misses shows where it is off. \
                         {advice}",
                        tried = told_of(&report.tried)
                    ),
                    colors.accent,
                ),
            };
            ui.label(RichText::new(text).color(ink));
        }
        choice(ui, outcome, out);
        changes(ui, report, session);
    }

    /// Advice on what else may bring a look nearer to the strokes.
    pub(super) fn advice(&self, what: FitGoal, report: &FitReport) -> String {
        let mut ways = Vec::new();
        if report.kept.told().is_some() && what == FitGoal::ThisLook {
            let kept = told_of(&report.kept);
            ways.push(tr!("keep less ({kept} did not take part)"));
        }
        if self.how.keep_rest > 0.0 && what != FitGoal::Local {
            ways.push(tr!("keep less of the rest").to_owned());
        }
        ways.push(match what {
            FitGoal::Local => tr!("fit the whole look").to_owned(),
            FitGoal::ThisLook => tr!("fit new layers").to_owned(),
            FitGoal::Layers(_) => tr!("allow more layers").to_owned(),
        });
        let last = ways.pop().unwrap_or_default();
        let ways = match ways.is_empty() {
            true => last,
            false => tr!("{ways}, or {last}", ways = ways.join(", ")),
        };
        match what {
            FitGoal::ThisLook => {
                tr!("What may help: {ways}. What is wired or keyed stays as it is.")
            }
            FitGoal::Local | FitGoal::Layers(_) => tr!("What may help: {ways}."),
        }
    }

    fn fit_row(&mut self, ui: &mut Ui, out: &mut Vec<Command>) {
        if let Some(running) = &self.running {
            let share = running.progress.share() as f32;
            ui.horizontal(|ui| {
                let help = tr!("Ends the fit, and shows the best that it has come to (Esc)");
                if ui.button(tr!("Stop")).on_hover_text(help).clicked() {
                    out.push(Command::Fit(FitCommand::Stop));
                }
                let percent = 100.0 * share;
                let text = match self.awaits() {
                    true => tr!("looking for a nearer one, {percent:.0} %"),
                    false => tr!("fitting, {percent:.0} %"),
                };
                ui.add(ProgressBar::new(share).text(text)).on_hover_text(tr!(
                    "It draws the picture in full precision and compiles the look; then it tries \
                     lights, profiles and colors at the painted pixels"
                ));
            });
            return;
        }
        ui.horizontal_wrapped(|ui| {
            let help =
                tr!("Lays new layers over the look, with lights of their own, where you painted \
                     (Ctrl+Enter). All else stays as it is");
            if ui.button(tr!("Light it there")).on_hover_text(help).clicked() {
                out.push(Command::Fit(FitCommand::Fit(FitGoal::Local)));
            }
        });
        ui.separator();
        hint(ui, tr!("Or the whole look is turned, as far as it may be:"));
        self.how_rows(ui);
        ui.horizontal_wrapped(|ui| {
            let help =
                tr!("Turns lights, profiles and colors of this look until it shows what is \
                     painted. Its nodes and wires stay");
            if ui.button(tr!("Fit this look")).on_hover_text(help).clicked() {
                out.push(Command::Fit(FitCommand::Fit(FitGoal::ThisLook)));
            }
            let help =
                tr!("Begins from nothing: light layers over a base, as many as help, in place of \
                     all nodes of this look");
            if ui.button(tr!("Fit new layers")).on_hover_text(help).clicked() {
                out.push(Command::Fit(FitCommand::Fit(FitGoal::Layers(self.how.layers))));
            }
            let label = ui.label(tr!("at most"));
            ui.add(number_field(ui, &mut self.how.layers).range(1..=MOST_LAYERS).speed(0.05))
                .labelled_by(label.id);
        });
    }
}

/// Share of the error that a fit took away, in percent; `None` for one that is hardly seen.
pub(super) fn percent_nearer(report: &FitReport) -> Option<u32> {
    let share = 1.0 - report.after / report.before.max(f64::MIN_POSITIVE);
    (share >= LEAST_SHARE).then(|| (100.0 * share).floor() as u32)
}

/// Shows the errors before and after the fit.
fn errors(ui: &mut Ui, report: &FitReport) {
    ui.horizontal_wrapped(|ui| {
        let text = tr!(
            "Off by {after}, before {before}",
            after = steps(report.after),
            before = steps(report.before)
        );
        let help = tr!("RMS of a channel over what is painted, in steps of eight bits");
        ui.label(RichText::new(text).strong()).on_hover_text(help);
        if let Some(rest) = report.rest {
            let help = tr!("How far what is not painted went off, though it was to stay");
            ui.label(
                RichText::new(tr!("the rest moved by {error}", error = steps(rest)))
                    .color(theme::of(ui).dim),
            )
            .on_hover_text(help);
        }
    });
}

/// Shows the buttons that apply or discard a result.
fn choice(ui: &mut Ui, outcome: &FitOutcome, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        if outcome.applied.is_some() {
            ui.label(RichText::new(tr!("Applied; undo takes it back")).color(theme::of(ui).dim));
            return;
        }
        if ui.button(tr!("Apply")).on_hover_text(tr!("Changes the look, as one step")).clicked() {
            out.push(Command::Fit(FitCommand::Apply));
        }
        if ui.button(tr!("Discard")).on_hover_text(tr!("Leaves the look as it is (Esc)")).clicked()
        {
            out.push(Command::Fit(FitCommand::Discard));
        }
        if let FitGoal::Layers(_) = outcome.what {
            ui.label(
                RichText::new(tr!("New layers take the place of all nodes"))
                    .color(theme::of(ui).dim),
            );
        }
    });
}

/// Shows everything that the fit has changed.
fn changes(ui: &mut Ui, report: &FitReport, session: &Session) {
    let mut last = None;
    for change in &report.changed {
        let (whose, what) = named(change, session);
        if last.as_ref() != Some(&whose) {
            ui.label(RichText::new(&whose).strong());
            last = Some(whose);
        }
        ui.horizontal(|ui| {
            ui.add_space(10.0);
            ui.label(what);
            if change.what == "light" {
                ui.label(turned(change))
                    .on_hover_text(tr!("Toward {direction}", direction = change.to));
            } else {
                value(ui, &change.from);
                if !change.from.is_empty() {
                    ui.label(RichText::new(tr!("to")).color(theme::of(ui).dim));
                }
                value(ui, &change.to);
            }
        });
    }
}

/// Owner and name of a changed value, as shown to the user.
fn named(change: &LookChange, session: &Session) -> (String, String) {
    if change.what == "light" {
        let light = session.look().lights.get(change.place.as_str());
        let name = light.map(|light| light.name.clone()).filter(|name| !name.is_empty());
        return (
            tr!("Light {name}", name = name.unwrap_or_else(|| change.place.clone())),
            tr!("direction").to_owned(),
        );
    }
    let place = change.place.as_str();
    let (node, port) = place.rsplit_once('.').unwrap_or((place, ""));
    let (port, stop) = match port.strip_suffix(']').and_then(|port| port.split_once('[')) {
        Some((ramp, index)) => (ramp, index.parse::<usize>().ok()),
        None => (port, None),
    };
    // New layers are not in the open look yet, only in the preview.
    let open = session.look_with_library();
    let fitted = session.sketchbook.preview().map(|look| LookWithLibrary { look, ..open });
    let path = NodePath::parse(node);
    let look = fitted.filter(|fitted| fitted.node_at(&path).is_some()).unwrap_or(open);
    let title = path.ids().first().map_or_else(String::new, |id| look.title(id));
    if port.is_empty() {
        return (title, tr!("profile").to_owned());
    }
    let [_, label] = look.names_of(&Target::Input { node: path, port: port.into() });
    (
        title,
        stop.map_or(label.clone(), |stop| {
            tr!("{ramp}, stop {number}", ramp = label, number = stop + 1)
        }),
    )
}

/// Angle by which a light was turned, if the light existed before.
fn turned(change: &LookChange) -> String {
    let direction = |text: &str| -> Option<glam::DVec3> {
        let numbers: Vec<f64> = text.split(' ').filter_map(|word| word.parse().ok()).collect();
        <[f64; 3]>::try_from(numbers).ok().map(glam::DVec3::from)?.try_normalize()
    };
    match (direction(&change.from), direction(&change.to)) {
        (Some(from), Some(to)) => {
            tr!("turned by {angle:.0}°", angle = from.angle_between(to).to_degrees())
        }
        _ => tr!("from {direction}", direction = change.to),
    }
}

/// Shows a value; a color as a swatch.
fn value(ui: &mut Ui, text: &str) {
    if let Some([r, g, b, _]) = text.starts_with('#').then(|| parse_hex(text)).flatten() {
        let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
        let (rect, response) = ui.allocate_exact_size(vec2(26.0, 12.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 2.0, Color32::from_rgb(byte(r), byte(g), byte(b)));
        let edge = egui::Stroke::new(1.0, theme::of(ui).swatch_edge);
        ui.painter().rect_stroke(rect, 2.0, edge, egui::StrokeKind::Inside);
        response.on_hover_text(text);
    } else if !text.is_empty() {
        ui.label(text);
    }
}

/// Parts of a look in words: "1 light, 2 profiles and 7 colors".
pub(super) fn told_of(parts: &KnobCounts) -> String {
    let KnobCounts { lights, profiles, colors } = *parts;
    let each = [
        (lights, trn!(lights, "{lights} light", "{lights} lights")),
        (profiles, trn!(profiles, "{profiles} profile", "{profiles} profiles")),
        (colors, trn!(colors, "{colors} color", "{colors} colors")),
    ];
    let each = each.into_iter().filter(|(count, _)| *count > 0);
    let mut named: Vec<String> = each.map(|(_, text)| text).collect();
    match named.pop() {
        Some(last) if named.is_empty() => last,
        Some(last) => tr!("{parts} and {last}", parts = named.join(", ")),
        None => tr!("nothing").to_owned(),
    }
}

/// Error in steps of an eight-bit channel.
fn steps(error: f64) -> String {
    format!("{:.1}/255", 255.0 * error)
}
