//! The rules that fill unpainted samples, in their order: each with its fields and with the number
//! of samples it fills.

mod relief;
mod strokes;

use std::f64::consts::PI;

use chiaro_locale::{Text, text, tr};
use eframe::egui::{
    Checkbox, ComboBox, Id, ProgressBar, RichText, Role, ScrollArea, Ui, WidgetInfo,
};

use super::memory::Memory;
use super::moves;
use crate::commands::{Command, PaintCommand};
use crate::document::relief::PRESETS;
use crate::document::{Address, ColorSpace, Directions, HcbtfAngle, HcbtfEdit, Rule, Strokes};
use crate::hcbtf::Provenance;
use crate::state::painting::work::OpenPainting;
use crate::widgets::color;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::rows::lead;
use crate::widgets::theme;

/// Width of labels before fields, in points: the longest label is "Ground ambient".
const LEAD: f32 = 96.0;

/// Interval at which the window is redrawn while rules fill samples, in seconds.
const AGAIN: f32 = 0.1;

/// Angles of an HCBTF with their labels, in the order of the check boxes.
pub(super) const ANGLES: [(HcbtfAngle, Text); 4] = [
    (HcbtfAngle::LightTheta, text!("Light's height")),
    (HcbtfAngle::LightPhi, text!("Light's way around")),
    (HcbtfAngle::ViewTheta, text!("Eye's height")),
    (HcbtfAngle::ViewPhi, text!("Eye's way around")),
];

/// Explanation of a rule for the user.
fn help(rule: &Rule) -> &'static str {
    match rule {
        Rule::Copy { .. } => tr!("Fills everything that is empty with one painting"),
        Rule::Lock { .. } => tr!("What is painted holds for every value of these angles"),
        Rule::Blend { .. } => {
            tr!("Blends the paintings by how near their light and eye are: a few make the whole")
        }
        Rule::Morph { .. } => {
            tr!("Blends the nearest paintings, and moves their strokes from one to the other in \
                 place of fading them")
        }
        Rule::Mirror { .. } => {
            tr!("One color where the light is mirrored to the eye, fading outward")
        }
        Rule::Specular { .. } => tr!("One painting where the light is mirrored to the eye"),
        Rule::Color { .. } => tr!("Fills everything that is empty with one color"),
        Rule::Strokes(_) => {
            tr!("Draws strokes that stand on the tile, as each eye and each light see them")
        }
        Rule::Relief(_) => tr!("Shows a relief of the tile, as each eye and each light see it"),
        Rule::Lambert { .. } => tr!("Darkens what is filled as the light sinks"),
        Rule::Rotate { .. } => tr!("Turns what is filled with the eye, so that it keeps facing it"),
        Rule::Recolor { .. } => {
            tr!("Tints what is filled from one color to another along an angle")
        }
    }
}

/// Name of a rule for the user.
fn label(rule: &Rule) -> &'static str {
    rule.about().label.tr()
}

/// Explanation of a rule, with its name in files.
fn tip(rule: &Rule) -> String {
    let (help, word) = (help(rule), rule.word());
    tr!("{help}\nIn files and at the command line: {word}")
}

/// New rules to add, one of each kind.
fn fresh(work: &OpenPainting) -> Vec<Rule> {
    let from = work.at();
    vec![
        Rule::Blend { sharpness: 4.0 },
        Rule::Morph { sharpness: 2.0 },
        Rule::Copy { from },
        Rule::Lock { angles: vec![HcbtfAngle::ViewPhi] },
        Rule::Specular { from, width: PI / 6.0 },
        Rule::Mirror { color: [255, 250, 235, 255], width: PI / 8.0 },
        Rule::Color { color: [128, 128, 128, 255] },
        Rule::Relief(Box::new(PRESETS[0].1())),
        Rule::Strokes(Box::new(Strokes::preset("Grass"))),
        Rule::Lambert { shadow: [20, 18, 32], amount: 1.0 },
        Rule::Rotate { turns: 1.0 },
        Rule::Recolor { angle: HcbtfAngle::LightTheta, from: [255, 255, 255], to: [255, 170, 110] },
    ]
}

/// Shows the rules. `share` is the part that is filled, 0 to 1, while filling is under way.
pub(super) fn show(
    ui: &mut Ui,
    work: &OpenPainting,
    share: Option<f64>,
    problem: Option<&str>,
    memory: &mut Memory,
    out: &mut Vec<Command>,
) {
    let hcbtf = work.hcbtf();
    let mut tiling = hcbtf.is_tiling;
    ui.horizontal(|ui| {
        ui.menu_button(tr!("+ Add a rule"), |ui| {
            for rule in fresh(work) {
                let (name, help) = (label(&rule), tip(&rule));
                let button = ui.button(name);
                button.widget_info(|| WidgetInfo::labeled(Role::MenuItem, true, name));
                if button.on_hover_text(help).clicked() {
                    out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::AddRule {
                        rule,
                        index: None,
                        unknown: Default::default(),
                    })));
                    ui.close();
                }
            }
        })
        .response
        .on_hover_text(tr!(
            "Rules fill what nobody painted. They work in order, and paintings always win"
        ));
        if ui
            .checkbox(&mut tiling, tr!("The tile repeats"))
            .on_hover_text(tr!("Strokes go across its edges"))
            .changed()
        {
            out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::SetTiling {
                is_tiling: tiling,
            })));
        }
        let help =
            tr!("Divides it into other texels, lights or views, once it is told what that takes");
        if ui.button(tr!("Grid...")).on_hover_text(help).clicked() {
            out.push(Command::Paint(PaintCommand::AskGrid { changes: true }));
        }
    });
    memory.show(ui, work);
    if let Some(problem) = problem {
        ui.label(RichText::new(problem).color(theme::of(ui).error));
    }
    match share {
        Some(share) => {
            ui.add(ProgressBar::new(share as f32).desired_height(3.0));
            ui.ctx().request_repaint_after_secs(AGAIN);
        }
        None => ui.add_space(3.0 + ui.spacing().item_spacing.y),
    }
    let counts = counts(work);
    if hcbtf.rules.is_empty() {
        let text = tr!(
            "No rules: what is not painted is empty. Add Blend to make a whole of a few paintings."
        );
        ui.label(RichText::new(text).color(theme::of(ui).dim));
    }
    ScrollArea::vertical().id_salt("rules").auto_shrink([false, false]).show(ui, |ui| {
        for (index, rule) in hcbtf.rules.iter().enumerate() {
            ui.push_id(index, |ui| {
                card(ui, work, index, rule, counts.get(index).copied().unwrap_or_default(), out);
            });
        }
    });
}

/// Number of samples that each rule fills or changes.
fn counts(work: &OpenPainting) -> Vec<usize> {
    let mut counts = vec![0; work.hcbtf().rules.len()];
    let Some(filled) = work.filled() else { return counts };
    for (_, _, provenance) in filled.iter() {
        if let Provenance::Filled { by, changed_by } = provenance {
            for rule in std::iter::once(by).chain(changed_by) {
                if let Some(count) = counts.get_mut(*rule) {
                    *count += 1;
                }
            }
        }
    }
    counts
}

fn card(
    ui: &mut Ui,
    work: &OpenPainting,
    index: usize,
    rule: &Rule,
    count: usize,
    out: &mut Vec<Command>,
) {
    let (name, help) = (label(rule), help(rule));
    let (rules, number) = (&work.hcbtf().rules, index + 1);
    let frame =
        eframe::egui::Frame::new().fill(theme::of(ui).node).corner_radius(4.0).inner_margin(8.0);
    frame.show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        ui.horizontal(|ui| {
            ui.strong(format!("{number}. {name}")).on_hover_text(tip(rule));
            let layout = eframe::egui::Layout::right_to_left(eframe::egui::Align::Center);
            ui.with_layout(layout, |ui| {
                let last = rules.len() - 1;
                let moved = |ui: &mut Ui, text: &str, label: String, is_on: bool, help: &str| {
                    let button = ui.add_enabled(is_on, eframe::egui::Button::new(text).small());
                    button.widget_info(|| WidgetInfo::labeled(Role::Button, is_on, &label));
                    button.on_hover_text(help).clicked()
                };
                if moved(
                    ui,
                    "×",
                    tr!("Remove rule {number}"),
                    true,
                    tr!("Takes the rule away; Undo brings it back"),
                ) {
                    out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::RemoveRule { index })));
                }
                if moved(
                    ui,
                    tr!("Down"),
                    tr!("Move rule {number} down"),
                    index < last,
                    tr!("Lets it work later"),
                ) {
                    out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::MoveRule {
                        from: index,
                        to: index + 1,
                    })));
                }
                if moved(
                    ui,
                    tr!("Up"),
                    tr!("Move rule {number} up"),
                    index > 0,
                    tr!("Lets it work earlier"),
                ) {
                    out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::MoveRule {
                        from: index,
                        to: index - 1,
                    })));
                }
            });
        });
        let all = work.grid().sample_count();
        let text = match rule.fills() {
            true => tr!("{help}: fills {count} of {all} samples"),
            false => tr!("{help}: changes {count} of {all} samples"),
        };
        ui.label(RichText::new(text).color(theme::of(ui).dim).small());
        let mut edited = rule.clone();
        if let Some(widget) = fields(ui, work, &mut edited).filter(|_| edited != *rule) {
            out.push(Command::Paint(PaintCommand::EditHeld(
                widget,
                HcbtfEdit::SetRule { index, rule: edited },
            )));
        }
    });
    ui.add_space(2.0);
}

/// Shows the fields of a rule. Returns the id of the widget that changed one.
fn fields(ui: &mut Ui, work: &OpenPainting, rule: &mut Rule) -> Option<Id> {
    match rule {
        Rule::Copy { from } => sample(ui, work, from),
        Rule::Specular { from, width } => {
            sample(ui, work, from).or_else(|| degrees(ui, tr!("Width"), width))
        }
        Rule::Lock { angles } => lock(ui, angles),
        Rule::Blend { sharpness } | Rule::Morph { sharpness } => {
            let help = tr!("1 is soft; at 8 the nearest painting alone is seen, nearly");
            number(ui, tr!("Sharpness"), help, sharpness, 0.0..=16.0)
        }
        Rule::Mirror { color, width } => {
            rgba(ui, tr!("Color"), color).or_else(|| degrees(ui, tr!("Width"), width))
        }
        Rule::Color { color } => rgba(ui, tr!("Color"), color),
        Rule::Lambert { shadow, amount } => {
            let help = tr!("0 leaves everything as it is, 1 is Lambert's law");
            rgb(ui, tr!("Shadow"), shadow)
                .or_else(|| number(ui, tr!("rule" => "Amount"), help, amount, 0.0..=1.0))
        }
        Rule::Strokes(strokes) => strokes::fields(ui, strokes),
        Rule::Relief(relief) => relief::fields(ui, work, relief),
        Rule::Rotate { turns } => number(
            ui,
            tr!("Turns"),
            tr!("How often it turns for one turn of the eye"),
            turns,
            -4.0..=4.0,
        ),
        Rule::Recolor { angle, from, to } => {
            let chosen = along(ui, tr!("Along"), angle);
            chosen.or_else(|| rgb(ui, tr!("From"), from)).or_else(|| rgb(ui, tr!("To"), to))
        }
    }
}

fn line<R>(ui: &mut Ui, label: &str, help: &str, add: impl FnOnce(&mut Ui, Id) -> R) -> R {
    ui.horizontal(|ui| {
        let id = lead(ui, label, LEAD).on_hover_text(help).id;
        add(ui, id)
    })
    .inner
}

fn number(
    ui: &mut Ui,
    label: &str,
    help: &str,
    value: &mut f64,
    range: std::ops::RangeInclusive<f64>,
) -> Option<Id> {
    line(ui, label, help, |ui, id| {
        let response = ui
            .add(number_slider(ui, value, range).max_decimals(2))
            .labelled_by(id)
            .on_hover_text(help);
        response.changed().then_some(response.id)
    })
}

fn degrees(ui: &mut Ui, label: &str, radians: &mut f64) -> Option<Id> {
    let mut shown = radians.to_degrees();
    let help = tr!("How far from the mirrored direction it reaches");
    line(ui, label, help, |ui, id| {
        let slider = number_slider(ui, &mut shown, 0.0..=180.0).suffix("°").max_decimals(0);
        let response = ui.add(slider).labelled_by(id).on_hover_text(help);
        if response.changed() {
            *radians = shown.to_radians().clamp(0.0, PI);
        }
        response.changed().then_some(response.id)
    })
}

fn rgba(ui: &mut Ui, label: &str, color: &mut [u8; 4]) -> Option<Id> {
    let shown = color.map(|channel| f64::from(channel) / 255.0);
    line(ui, label, tr!("Click to choose"), |ui, _| {
        let (id, found) = color::named_swatch(ui, label, shown, ColorSpace::Display, true)?;
        *color = found.map(|channel| (channel * 255.0).round() as u8);
        Some(id)
    })
}

pub(super) fn rgb(ui: &mut Ui, label: &str, color: &mut [u8; 3]) -> Option<Id> {
    let [r, g, b] = color.map(|channel| f64::from(channel) / 255.0);
    line(ui, label, tr!("Click to choose"), |ui, _| {
        let (id, found) =
            color::named_swatch(ui, label, [r, g, b, 1.0], ColorSpace::Display, false)?;
        let [r, g, b, _] = found.map(|channel| (channel * 255.0).round() as u8);
        *color = [r, g, b];
        Some(id)
    })
}

fn lock(ui: &mut Ui, angles: &mut Vec<HcbtfAngle>) -> Option<Id> {
    let mut changed = None;
    ui.horizontal_wrapped(|ui| {
        for (angle, label) in ANGLES {
            let mut is_on = angles.contains(&angle);
            // At least one angle stays locked: a rule that locks none does nothing.
            let is_last = is_on && angles.len() == 1;
            let response = ui.add_enabled(!is_last, Checkbox::new(&mut is_on, label.tr()));
            let help = tr!("Where this angle alone differs, the painting is the same");
            if response.changed() {
                match is_on {
                    true => angles.push(angle),
                    false => angles.retain(|other| *other != angle),
                }
                changed = Some(response.id.with(is_on));
            }
            response.on_hover_text(help);
        }
    });
    changed
}

/// Shows the choice of an angle.
pub(super) fn along(ui: &mut Ui, label: &str, angle: &mut HcbtfAngle) -> Option<Id> {
    let before = *angle;
    let name = |angle: HcbtfAngle| {
        ANGLES.iter().find(|(known, _)| *known == angle).map_or("", |(_, label)| label.tr())
    };
    line(ui, label, tr!("Which angle"), |ui, id| {
        let combo = ComboBox::from_id_salt("angle").width(130.0).selected_text(name(before));
        let response = combo.show_ui(ui, |ui| {
            for (known, label) in ANGLES {
                ui.selectable_value(angle, known, label.tr());
            }
        });
        let response = response.response.labelled_by(id);
        (*angle != before).then(|| response.id.with(format!("{angle:?}")))
    })
}

/// Shows the fields for the sample that a rule copies.
pub(super) fn sample(ui: &mut Ui, work: &OpenPainting, from: &mut Address) -> Option<Id> {
    let mut changed = None;
    let before = *from;
    let grid = work.grid();
    let parts: [(_, _, Directions, &mut crate::document::Direction); 2] = [
        (tr!("Light"), [tr!("Light ring"), tr!("Light step")], grid.light, &mut from.light),
        (tr!("Eye"), [tr!("Eye ring"), tr!("Eye step")], grid.view, &mut from.view),
    ];
    for (label, [ring, step], directions, direction) in parts {
        line(ui, label, tr!("The ring from the normal, and the step around it"), |ui, _| {
            let mut field = |ui: &mut Ui, name: &str, value: &mut u32, count: u32| {
                let drag = ui.add(number_field(ui, value).range(0..=count.max(1) - 1).speed(0.05));
                drag.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
                if drag.changed() {
                    changed = Some(drag.id);
                }
            };
            field(ui, ring, &mut direction.theta, directions.theta);
            field(ui, step, &mut direction.phi, directions.phi);
            ui.label(
                RichText::new(moves::name(directions, *direction)).color(theme::of(ui).dim).small(),
            );
        });
    }
    let at = work.at();
    let help = tr!("Lets the rule copy the sample that you are working at");
    let button = ui.add_enabled(
        before.canonical() != at,
        eframe::egui::Button::new(tr!("Take the sample at work")).small(),
    );
    if button.on_hover_text(help).clicked() {
        *from = at;
        changed = Some(ui.scope_id().with("at work").with(at));
    }
    *from = from.canonical();
    if work.hcbtf().painted(*from).is_none() {
        ui.label(
            RichText::new(tr!("Nothing is painted there yet")).color(theme::of(ui).warning).small(),
        );
    }
    changed
}
