//! Card of a relief rule: its pattern, its light, its gloss, and its style of drawing.

use std::ops::RangeInclusive;

use chiaro_locale::{Text, text, tr};
use eframe::egui::{Button, CollapsingHeader, Id, Role, Ui, WidgetInfo};

use super::{LEAD, OpenPainting};
use crate::document::relief::{Channel, Finish, Glint, Illumination, PRESETS, Pattern};
use crate::document::{Address, Relief};
use crate::widgets::number::number_slider;
use crate::widgets::rows::lead;

/// Shows the fields of a relief. Returns the id of the widget that changed one.
pub(super) fn fields(ui: &mut Ui, work: &OpenPainting, relief: &mut Relief) -> Option<Id> {
    let mut fields = Fields { changed: presets(ui, work, relief) };
    let section = |ui: &mut Ui, title: Text, is_open: bool, add: &mut dyn FnMut(&mut Ui)| {
        let header = CollapsingHeader::new(title.tr()).id_salt(title.english());
        header.default_open(is_open).show(ui, |ui| add(ui));
    };
    section(ui, text!("Pattern"), true, &mut |ui| {
        fields.number(
            ui,
            tr!("Depth"),
            tr!("From the lowest to the highest, in tile widths"),
            &mut relief.depth,
            0.0..=0.5,
        );
        let help =
            tr!("Which height stays in place when the eye moves: 0 the lowest, 1 the highest");
        fields.number(ui, tr!("Still height"), help, &mut relief.pivot, 0.0..=1.0);
        fields.count(
            ui,
            tr!("Seed"),
            tr!("Another number scatters anew"),
            &mut relief.seed,
            0..=999,
        );
        fields.pattern(ui, work, &mut relief.pattern);
    });
    section(ui, text!("Light"), false, &mut |ui| fields.light(ui, &mut relief.light));
    section(ui, text!("Glint"), false, &mut |ui| fields.glint(ui, &mut relief.glint));
    section(ui, text!("Finish"), false, &mut |ui| fields.finish(ui, &mut relief.finish));
    fields.changed
}

/// Shows buttons that replace the relief with a preset.
fn presets(ui: &mut Ui, work: &OpenPainting, relief: &mut Relief) -> Option<Id> {
    let mut changed = None;
    ui.horizontal_wrapped(|ui| {
        for (name, preset) in PRESETS {
            let name = name.tr();
            let label = tr!("Make it {name}");
            let button = ui.add(Button::new(name).small());
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
            if button.on_hover_text(tr!("Begins with this relief, all fields anew")).clicked() {
                *relief = preset();
                changed = Some(ui.scope_id().with(name));
            }
        }
        let from = work.at();
        let is_painted = work.hcbtf().painted(from).is_some();
        let button = ui.add_enabled(is_painted, Button::new(tr!("Of this painting")).small());
        let help =
            tr!("Takes heights and colors from the sample at work: what is bright stands high");
        if button
            .on_hover_text(help)
            .on_disabled_hover_text(tr!("The sample at work is not painted"))
            .clicked()
        {
            let channel = Channel::Luminance;
            relief.pattern =
                Pattern::Painted { heights: from, channel, is_inverted: false, colors: from };
            changed = Some(ui.scope_id().with("painting").with(from));
        }
    });
    changed
}

/// Fields one below the other, with the id of the widget that was changed.
struct Fields {
    changed: Option<Id>,
}

impl Fields {
    fn line(
        &mut self,
        ui: &mut Ui,
        label: &str,
        help: &str,
        add: impl FnOnce(&mut Ui, Id) -> Option<Id>,
    ) {
        let changed = ui.horizontal(|ui| {
            let id = lead(ui, label, LEAD).on_hover_text(help).id;
            add(ui, id)
        });
        self.changed = self.changed.or(changed.inner);
    }

    fn number(
        &mut self,
        ui: &mut Ui,
        label: &str,
        help: &str,
        value: &mut f64,
        range: RangeInclusive<f64>,
    ) {
        self.line(ui, label, help, |ui, id| {
            let response = ui
                .add(number_slider(ui, value, range).max_decimals(3))
                .labelled_by(id)
                .on_hover_text(help);
            response.changed().then_some(response.id)
        });
    }

    fn part(&mut self, ui: &mut Ui, label: &str, help: &str, value: &mut f64) {
        self.number(ui, label, help, value, 0.0..=1.0);
    }

    fn degrees(&mut self, ui: &mut Ui, label: &str, help: &str, value: &mut f64, most: f64) {
        let mut shown = value.to_degrees();
        self.line(ui, label, help, |ui, id| {
            let slider =
                number_slider(ui, &mut shown, 0.0..=most.to_degrees()).suffix("°").max_decimals(1);
            let response = ui.add(slider).labelled_by(id).on_hover_text(help);
            if response.changed() {
                *value = shown.to_radians().clamp(0.0, most);
            }
            response.changed().then_some(response.id)
        });
    }

    fn count(
        &mut self,
        ui: &mut Ui,
        label: &str,
        help: &str,
        value: &mut u32,
        range: RangeInclusive<u32>,
    ) {
        self.line(ui, label, help, |ui, id| {
            let response =
                ui.add(number_slider(ui, value, range)).labelled_by(id).on_hover_text(help);
            response.changed().then_some(response.id)
        });
    }

    fn check(&mut self, ui: &mut Ui, label: &str, help: &str, value: &mut bool) {
        let response = ui.checkbox(value, label).on_hover_text(help);
        self.changed = self.changed.or_else(|| response.changed().then_some(response.id));
    }

    fn color(&mut self, ui: &mut Ui, label: &str, color: &mut [u8; 3]) {
        let changed = super::rgb(ui, label, color);
        self.changed = self.changed.or(changed);
    }

    fn sample(&mut self, ui: &mut Ui, work: &OpenPainting, label: Text, from: &mut Address) {
        ui.label(label.tr());
        let changed = ui.push_id(label.english(), |ui| super::sample(ui, work, from)).inner;
        self.changed = self.changed.or(changed);
    }

    fn size(&mut self, ui: &mut Ui, labels: [&str; 2], size: &mut [f64; 2]) {
        for (label, value) in labels.into_iter().zip(size) {
            self.number(ui, label, tr!("In parts of its bay"), value, 0.05..=0.95);
        }
    }

    fn pattern(&mut self, ui: &mut Ui, work: &OpenPainting, pattern: &mut Pattern) {
        match pattern {
            Pattern::Painted { heights, channel, is_inverted, colors } => {
                self.sample(ui, work, text!("Heights from"), heights);
                let mut is_alpha = *channel == Channel::Alpha;
                self.check(
                    ui,
                    tr!("Heights by opacity"),
                    tr!("What is opaque stands high; else what is bright"),
                    &mut is_alpha,
                );
                *channel = if is_alpha { Channel::Alpha } else { Channel::Luminance };
                self.check(ui, tr!("Upside down"), tr!("High and low change places"), is_inverted);
                self.sample(ui, work, text!("Colors from"), colors);
            }
            Pattern::Bricks {
                columns,
                rows,
                shift,
                joint,
                bevel,
                unevenness,
                roughness,
                colors: [first, second],
                joint_color,
            } => {
                self.count(ui, tr!("Columns"), tr!("Bricks in a course"), columns, 1..=24);
                self.count(ui, tr!("Rows"), tr!("Courses"), rows, 1..=24);
                self.part(
                    ui,
                    tr!("relief" => "Shift"),
                    tr!("By which part of a brick every second course is moved"),
                    shift,
                );
                self.part(ui, tr!("Joint"), tr!("In parts of a course's height"), joint);
                self.part(ui, tr!("Bevel"), tr!("How far edges are rounded"), bevel);
                self.part(
                    ui,
                    tr!("Unevenness"),
                    tr!("How much bricks differ in height"),
                    unevenness,
                );
                self.part(ui, tr!("Roughness"), tr!("Of bricks and mortar"), roughness);
                self.color(ui, tr!("Brick"), first);
                self.color(ui, tr!("Other brick"), second);
                self.color(ui, tr!("Mortar"), joint_color);
            }
            Pattern::Stones { count, share, grit, roundness, colors: [first, second], binder } => {
                self.count(ui, tr!("Stones"), tr!("Large stones along the tile"), count, 1..=32);
                self.part(
                    ui,
                    tr!("relief" => "Share"),
                    tr!("How many of the large stones there are"),
                    share,
                );
                self.part(ui, tr!("Grit"), tr!("How many small stones lie between them"), grit);
                self.part(
                    ui,
                    tr!("Roundness"),
                    tr!("0 is flat with steep sides, 1 is round"),
                    roundness,
                );
                self.color(ui, tr!("Stone"), first);
                self.color(ui, tr!("Other stone"), second);
                self.color(ui, tr!("Binder"), binder);
            }
            Pattern::Facade { .. } | Pattern::Arches { .. } => self.building(ui, pattern),
            Pattern::Ripples { count, bend, roughness, colors: [low, high] } => {
                self.count(
                    ui,
                    tr!("Ripples"),
                    tr!("From top to bottom; without any, hills"),
                    count,
                    0..=32,
                );
                self.number(
                    ui,
                    tr!("relief" => "Bend"),
                    tr!("How much they bend"),
                    bend,
                    0.0..=4.0,
                );
                self.part(ui, tr!("Roughness"), tr!("Between the ripples"), roughness);
                self.color(ui, tr!("relief" => "Low"), low);
                self.color(ui, tr!("relief" => "High"), high);
            }
        }
    }

    /// Shows the rows of a pattern with windows or arches, and no rows for other patterns.
    fn building(&mut self, ui: &mut Ui, pattern: &mut Pattern) {
        match pattern {
            Pattern::Facade {
                columns,
                floors,
                window,
                frame,
                sill,
                roughness,
                wall,
                trim,
                glass,
                lit,
                lit_color,
            } => {
                self.count(ui, tr!("Columns"), tr!("Windows on a floor"), columns, 1..=16);
                self.count(ui, tr!("Floors"), tr!("One above the other"), floors, 1..=16);
                self.size(ui, [tr!("Window width"), tr!("Window height")], window);
                self.number(
                    ui,
                    tr!("window" => "Frame"),
                    tr!("In parts of the window's width"),
                    frame,
                    0.0..=0.45,
                );
                self.part(ui, tr!("Sills"), tr!("How far sills and bands stand out"), sill);
                self.part(ui, tr!("Roughness"), tr!("Of the wall"), roughness);
                self.part(
                    ui,
                    tr!("Lit windows"),
                    tr!("How many are lit from within when the sun is low"),
                    lit,
                );
                self.color(ui, tr!("Wall"), wall);
                self.color(ui, tr!("relief" => "Trim"), trim);
                self.color(ui, tr!("Glass"), glass);
                self.color(ui, tr!("Light within"), lit_color);
            }
            Pattern::Arches {
                columns,
                rows,
                opening,
                ring,
                courses,
                roughness,
                wall,
                trim,
                inside,
            } => {
                self.count(ui, tr!("Columns"), tr!("Arches side by side"), columns, 1..=16);
                self.count(ui, tr!("Rows"), tr!("Of arches"), rows, 1..=16);
                self.size(ui, [tr!("Opening width"), tr!("Opening height")], opening);
                self.part(
                    ui,
                    tr!("Ring"),
                    tr!("The width of the ring of stones, in parts of the opening's"),
                    ring,
                );
                self.count(ui, tr!("Courses"), tr!("Of the wall in a bay"), courses, 1..=32);
                self.part(ui, tr!("Roughness"), tr!("Of the stone"), roughness);
                self.color(ui, tr!("Wall"), wall);
                self.color(ui, tr!("Ring stones"), trim);
                self.color(ui, tr!("relief" => "Inside"), inside);
            }
            _ => {}
        }
    }

    fn light(&mut self, ui: &mut Ui, light: &mut Illumination) {
        self.color(ui, tr!("Sun"), &mut light.sun);
        self.color(ui, tr!("Low sun"), &mut light.low_sun);
        let help = tr!("1 shows a surface that faces the sun in its own color");
        self.number(ui, tr!("Sun amount"), help, &mut light.sun_amount, 0.0..=3.0);
        self.color(ui, tr!("Sky"), &mut light.sky);
        self.color(ui, tr!("Sky at low sun"), &mut light.low_sky);
        let help = tr!("1 shows an open surface under the sky alone in its own color");
        self.number(ui, tr!("Sky amount"), help, &mut light.sky_amount, 0.0..=3.0);
        let help = tr!(
            "The sun is low where it is level with the tile, as on a wall, not where it is near \
             the tile's horizon"
        );
        self.check(ui, tr!("The tile stands upright"), help, &mut light.is_upright);
        self.degrees(
            ui,
            tr!("Soft shadows"),
            tr!("Half the width of their edges"),
            &mut light.softness,
            0.5,
        );
        self.count(
            ui,
            tr!("Bounces"),
            tr!("How often light goes on from place to place"),
            &mut light.bounces,
            0..=8,
        );
    }

    fn glint(&mut self, ui: &mut Ui, glint: &mut Glint) {
        let help = tr!("How bright it shines where the sun is mirrored to the eye");
        self.number(ui, tr!("Glint amount"), help, &mut glint.amount, 0.0..=4.0);
        self.line(ui, tr!("Sharpness"), tr!("1 is broad, 500 a spark"), |ui, id| {
            let slider = number_slider(ui, &mut glint.sharpness, 1.0..=500.0)
                .logarithmic(true)
                .max_decimals(0);
            let response = ui.add(slider).labelled_by(id);
            response.changed().then_some(response.id)
        });
        self.part(ui, tr!("Glint share"), tr!("Which part of the grains shines"), &mut glint.share);
        self.degrees(
            ui,
            tr!("Lean"),
            tr!("How far grains lean, so that not all shine at once"),
            &mut glint.lean,
            1.0,
        );
    }

    fn finish(&mut self, ui: &mut Ui, finish: &mut Finish) {
        self.count(ui, tr!("Bands"), tr!("Steps of light; 0 for all"), &mut finish.bands, 0..=16);
        self.part(
            ui,
            tr!("Ink"),
            tr!("Edges, where one thing stands before another"),
            &mut finish.ink,
        );
        self.number(ui, tr!("Ink width"), tr!("In texels"), &mut finish.ink_width, 0.25..=4.0);
        self.color(ui, tr!("Ink color"), &mut finish.ink_color);
        self.part(ui, tr!("Hatching"), tr!("Lines in the dark"), &mut finish.hatch);
        self.count(
            ui,
            tr!("Hatching lines"),
            tr!("Across the tile"),
            &mut finish.hatch_lines,
            1..=64,
        );
        self.number(
            ui,
            tr!("Wobble"),
            tr!("How far lines stray, in tile widths"),
            &mut finish.wobble,
            0.0..=0.05,
        );
        self.part(ui, tr!("Paper"), tr!("How much paper shows"), &mut finish.grain);
    }
}
