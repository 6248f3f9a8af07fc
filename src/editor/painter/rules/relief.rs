//! Card of a relief rule: its pattern, its light, its gloss, and its style of drawing.

use std::ops::RangeInclusive;

use chiaro_locale::tr;
use eframe::egui::{Button, CollapsingHeader, Id, Role, Slider, Ui, WidgetInfo};

use super::{LEAD, OpenPainting};
use crate::document::relief::{Channel, Finish, Glint, Illumination, PRESETS, Pattern};
use crate::document::{Address, Relief};
use crate::widgets::rows::lead;

/// Shows the fields of a relief. Returns the id of the widget that changed one.
pub(super) fn fields(ui: &mut Ui, work: &OpenPainting, relief: &mut Relief) -> Option<Id> {
    let mut fields = Fields { changed: presets(ui, work, relief) };
    let section = |ui: &mut Ui, title: &str, is_open: bool, add: &mut dyn FnMut(&mut Ui)| {
        CollapsingHeader::new(title).default_open(is_open).show(ui, |ui| add(ui));
    };
    section(ui, "Pattern", true, &mut |ui| {
        fields.number(
            ui,
            "Depth",
            "From the lowest to the highest, in tile widths",
            &mut relief.depth,
            0.0..=0.5,
        );
        let help = "Which height stays in place when the eye moves: 0 the lowest, 1 the highest";
        fields.number(ui, "Still height", help, &mut relief.pivot, 0.0..=1.0);
        fields.count(ui, "Seed", "Another number scatters anew", &mut relief.seed, 0..=999);
        fields.pattern(ui, work, &mut relief.pattern);
    });
    section(ui, "Light", false, &mut |ui| fields.light(ui, &mut relief.light));
    section(ui, "Glint", false, &mut |ui| fields.glint(ui, &mut relief.glint));
    section(ui, "Finish", false, &mut |ui| fields.finish(ui, &mut relief.finish));
    fields.changed
}

/// Shows buttons that replace the relief with a preset.
fn presets(ui: &mut Ui, work: &OpenPainting, relief: &mut Relief) -> Option<Id> {
    let mut changed = None;
    ui.horizontal_wrapped(|ui| {
        for (name, preset) in PRESETS.map(|(name, preset)| (name.tr(), preset)) {
            let label = format!("Make it {name}");
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
        let help = "Takes heights and colors from the sample at work: what is bright stands high";
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
                .add(Slider::new(value, range).max_decimals(3))
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
                Slider::new(&mut shown, 0.0..=most.to_degrees()).suffix("°").max_decimals(1);
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
            let response = ui.add(Slider::new(value, range)).labelled_by(id).on_hover_text(help);
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

    fn sample(&mut self, ui: &mut Ui, work: &OpenPainting, label: &str, from: &mut Address) {
        ui.label(label);
        let changed = ui.push_id(label, |ui| super::sample(ui, work, from)).inner;
        self.changed = self.changed.or(changed);
    }

    fn size(&mut self, ui: &mut Ui, what: &str, size: &mut [f64; 2]) {
        let [width, height] = size;
        self.number(ui, &format!("{what} width"), "In parts of its bay", width, 0.05..=0.95);
        self.number(ui, &format!("{what} height"), "In parts of its bay", height, 0.05..=0.95);
    }

    fn pattern(&mut self, ui: &mut Ui, work: &OpenPainting, pattern: &mut Pattern) {
        match pattern {
            Pattern::Painted { heights, channel, is_inverted, colors } => {
                self.sample(ui, work, "Heights from", heights);
                let mut is_alpha = *channel == Channel::Alpha;
                self.check(
                    ui,
                    "Heights by opacity",
                    "What is opaque stands high; else what is bright",
                    &mut is_alpha,
                );
                *channel = if is_alpha { Channel::Alpha } else { Channel::Luminance };
                self.check(ui, "Upside down", "High and low change places", is_inverted);
                self.sample(ui, work, "Colors from", colors);
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
                self.count(ui, "Columns", "Bricks in a course", columns, 1..=24);
                self.count(ui, "Rows", "Courses", rows, 1..=24);
                self.part(
                    ui,
                    "Shift",
                    "By which part of a brick every second course is moved",
                    shift,
                );
                self.part(ui, "Joint", "In parts of a course's height", joint);
                self.part(ui, "Bevel", "How far edges are rounded", bevel);
                self.part(ui, "Unevenness", "How much bricks differ in height", unevenness);
                self.part(ui, "Roughness", "Of bricks and mortar", roughness);
                self.color(ui, "Brick", first);
                self.color(ui, "Other brick", second);
                self.color(ui, "Mortar", joint_color);
            }
            Pattern::Stones { count, share, grit, roundness, colors: [first, second], binder } => {
                self.count(ui, "Stones", "Large stones along the tile", count, 1..=32);
                self.part(ui, "Share", "How many of the large stones there are", share);
                self.part(ui, "Grit", "How many small stones lie between them", grit);
                self.part(ui, "Roundness", "0 is flat with steep sides, 1 is round", roundness);
                self.color(ui, "Stone", first);
                self.color(ui, "Other stone", second);
                self.color(ui, "Binder", binder);
            }
            Pattern::Facade { .. } | Pattern::Arches { .. } => self.building(ui, pattern),
            Pattern::Ripples { count, bend, roughness, colors: [low, high] } => {
                self.count(ui, "Ripples", "From top to bottom; without any, hills", count, 0..=32);
                self.number(ui, "Bend", "How much they bend", bend, 0.0..=4.0);
                self.part(ui, "Roughness", "Between the ripples", roughness);
                self.color(ui, "Low", low);
                self.color(ui, "High", high);
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
                self.count(ui, "Columns", "Windows on a floor", columns, 1..=16);
                self.count(ui, "Floors", "One above the other", floors, 1..=16);
                self.size(ui, "Window", window);
                self.number(ui, "Frame", "In parts of the window's width", frame, 0.0..=0.45);
                self.part(ui, "Sills", "How far sills and bands stand out", sill);
                self.part(ui, "Roughness", "Of the wall", roughness);
                self.part(
                    ui,
                    "Lit windows",
                    "How many are lit from within when the sun is low",
                    lit,
                );
                self.color(ui, "Wall", wall);
                self.color(ui, "Trim", trim);
                self.color(ui, "Glass", glass);
                self.color(ui, "Light within", lit_color);
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
                self.count(ui, "Columns", "Arches side by side", columns, 1..=16);
                self.count(ui, "Rows", "Of arches", rows, 1..=16);
                self.size(ui, "Opening", opening);
                self.part(
                    ui,
                    "Ring",
                    "The width of the ring of stones, in parts of the opening's",
                    ring,
                );
                self.count(ui, "Courses", "Of the wall in a bay", courses, 1..=32);
                self.part(ui, "Roughness", "Of the stone", roughness);
                self.color(ui, "Wall", wall);
                self.color(ui, "Ring stones", trim);
                self.color(ui, "Inside", inside);
            }
            _ => {}
        }
    }

    fn light(&mut self, ui: &mut Ui, light: &mut Illumination) {
        self.color(ui, "Sun", &mut light.sun);
        self.color(ui, "Low sun", &mut light.low_sun);
        let help = "1 shows a surface that faces the sun in its own color";
        self.number(ui, "Sun amount", help, &mut light.sun_amount, 0.0..=3.0);
        self.color(ui, "Sky", &mut light.sky);
        self.color(ui, "Sky at low sun", &mut light.low_sky);
        let help = "1 shows an open surface under the sky alone in its own color";
        self.number(ui, "Sky amount", help, &mut light.sky_amount, 0.0..=3.0);
        let help = "The sun is low where it is level with the tile, as on a wall, not where it is \
                    near the tile's horizon";
        self.check(ui, "The tile stands upright", help, &mut light.is_upright);
        self.degrees(ui, "Soft shadows", "Half the width of their edges", &mut light.softness, 0.5);
        self.count(
            ui,
            "Bounces",
            "How often light goes on from place to place",
            &mut light.bounces,
            0..=8,
        );
    }

    fn glint(&mut self, ui: &mut Ui, glint: &mut Glint) {
        let help = "How bright it shines where the sun is mirrored to the eye";
        self.number(ui, "Glint amount", help, &mut glint.amount, 0.0..=4.0);
        self.line(ui, "Sharpness", "1 is broad, 500 a spark", |ui, id| {
            let slider =
                Slider::new(&mut glint.sharpness, 1.0..=500.0).logarithmic(true).max_decimals(0);
            let response = ui.add(slider).labelled_by(id);
            response.changed().then_some(response.id)
        });
        self.part(ui, "Glint share", "Which part of the grains shines", &mut glint.share);
        self.degrees(
            ui,
            "Lean",
            "How far grains lean, so that not all shine at once",
            &mut glint.lean,
            1.0,
        );
    }

    fn finish(&mut self, ui: &mut Ui, finish: &mut Finish) {
        self.count(ui, "Bands", "Steps of light; 0 for all", &mut finish.bands, 0..=16);
        self.part(ui, "Ink", "Edges, where one thing stands before another", &mut finish.ink);
        self.number(ui, "Ink width", "In texels", &mut finish.ink_width, 0.25..=4.0);
        self.color(ui, "Ink color", &mut finish.ink_color);
        self.part(ui, "Hatching", "Lines in the dark", &mut finish.hatch);
        self.count(ui, "Hatching lines", "Across the tile", &mut finish.hatch_lines, 1..=64);
        self.number(
            ui,
            "Wobble",
            "How far lines stray, in tile widths",
            &mut finish.wobble,
            0.0..=0.05,
        );
        self.part(ui, "Paper", "How much paper shows", &mut finish.grain);
    }
}
