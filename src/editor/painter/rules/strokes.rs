//! Fields of a rule of strokes that stand on the tile.

use std::ops::RangeInclusive;

use chiaro_locale::{Text, text, tr, trn};
use eframe::egui::{Button, CollapsingHeader, ComboBox, Id, RichText, Role, Ui, WidgetInfo};

use super::{line, number, rgb, rgba};
use crate::document::{Bundle, Placement, StrokeShape, StrokeTones, Strokes};
use crate::widgets::number::number_field;
use crate::widgets::theme;

const SHAPES: [(StrokeShape, Text); 3] = [
    (StrokeShape::Thread, text!("Threads: round, they grow from the tile")),
    (StrokeShape::Ribbon, text!("Ribbons: flat")),
    (StrokeShape::Dot, text!("Dots: flat rounds")),
];

/// Shows the fields. Returns the id of the widget that changed one.
pub(super) fn fields(ui: &mut Ui, strokes: &mut Strokes) -> Option<Id> {
    let mut changed = beginning(ui, strokes);
    let mut seed = f64::from(strokes.seed);
    let mut by = |id: Option<Id>| changed = changed.or(id);
    by(drag(ui, tr!("Seed"), tr!("Another number scatters anew"), &mut seed, 0.0..=9999.0, 0.1, 0));
    strokes.seed = seed as u32;
    let ground = &mut strokes.ground;
    by(rgba(ui, tr!("Ground"), &mut ground.color));
    by(number(
        ui,
        tr!("Ground ambient"),
        tr!("How much of the ground's color is there in any light"),
        &mut ground.ambient,
        0.0..=2.0,
    ));
    by(number(
        ui,
        tr!("Ground diffuse"),
        tr!("How much more by Lambert's law"),
        &mut ground.diffuse,
        0.0..=2.0,
    ));
    let shadow = &mut strokes.shadow;
    by(number(
        ui,
        tr!("Shadow"),
        tr!("How much of the light strokes take from what lies behind"),
        &mut shadow.amount,
        0.0..=1.0,
    ));
    by(number(
        ui,
        tr!("Softness"),
        tr!("How far the edges of shadows are blurred"),
        &mut shadow.softness,
        0.0..=1.0,
    ));
    let mut removed = None;
    for (index, bundle) in strokes.bundles.iter_mut().enumerate() {
        let number = index + 1;
        let title = tr!("Bundle {number}: {strokes}", strokes = counted(bundle));
        CollapsingHeader::new(title).id_salt(("bundle", index)).default_open(index == 0).show(
            ui,
            |ui| {
                by(all_of(ui, bundle));
                let button = ui.add(Button::new(tr!("Remove the bundle")).small());
                button.widget_info(|| {
                    WidgetInfo::labeled(Role::Button, true, tr!("Remove bundle {number}"))
                });
                if button
                    .on_hover_text(tr!("Takes its strokes away; Undo brings them back"))
                    .clicked()
                {
                    removed = Some(index);
                }
            },
        );
    }
    if let Some(index) = removed {
        strokes.bundles.remove(index);
        by(Some(ui.scope_id().with(("removed", index))));
    }
    let is_free = strokes.bundles.len() < Strokes::MAX_BUNDLES;
    let add = ui.add_enabled(is_free, Button::new(tr!("+ Add a bundle")).small());
    if add.on_hover_text(tr!("More strokes, like the last ones, over them")).clicked() {
        strokes.bundles.push(strokes.bundles.last().cloned().unwrap_or_default());
        by(Some(ui.scope_id().with(("added", strokes.bundles.len()))));
    }
    if let Err(why) = strokes.check() {
        ui.label(RichText::new(why).color(theme::of(ui).error).small());
    }
    changed
}

/// Shows the menu of presets to begin with.
fn beginning(ui: &mut Ui, strokes: &mut Strokes) -> Option<Id> {
    let mut taken = None;
    let menu = ui.menu_button(tr!("Begin with"), |ui| {
        for name in Strokes::PRESETS {
            let label = preset_label(name);
            let button = ui.button(label);
            button.widget_info(|| WidgetInfo::labeled(Role::MenuItem, true, label));
            if button.clicked() {
                *strokes = Strokes::preset(name);
                taken = Some(name);
                ui.close();
            }
        }
    });
    menu.response.on_hover_text(tr!("Takes other strokes in place of these"));
    taken.map(|name| ui.scope_id().with(name))
}

/// Name of a preset as it is shown.
fn preset_label(name: &'static str) -> &'static str {
    match name {
        "Grass" => tr!("Grass"),
        "Pencil" => tr!("strokes" => "Pencil"),
        "Stripes" => tr!("strokes" => "Stripes"),
        "Half-tone dots" => tr!("Half-tone dots"),
        other => other,
    }
}

/// Number of a bundle's strokes, in words.
fn counted(bundle: &Bundle) -> String {
    let n = match &bundle.place {
        Placement::Scatter(count) | Placement::Lattice(count) => *count,
        Placement::Paths(paths) => return trn!(n = paths.len(), "{n} path", "{n} paths"),
    };
    match bundle.shape {
        StrokeShape::Thread => trn!(n, "{n} thread", "{n} threads"),
        StrokeShape::Ribbon => trn!(n, "{n} ribbon", "{n} ribbons"),
        StrokeShape::Dot => trn!(n, "{n} dot", "{n} dots"),
    }
}

/// Shows all fields of a bundle.
fn all_of(ui: &mut Ui, bundle: &mut Bundle) -> Option<Id> {
    let placed = placement(ui, bundle);
    let formed = form(ui, bundle);
    let colored = colors(ui, bundle);
    let toned = tones(ui, &mut bundle.tones);
    let help = tr!("How much the grain of the paper shows through");
    let grained = number(ui, tr!("Grain"), help, &mut bundle.grain, 0.0..=1.0);
    placed.or(formed).or(colored).or(toned).or(grained)
}

fn placement(ui: &mut Ui, bundle: &mut Bundle) -> Option<Id> {
    let mut changed = None;
    let before = bundle.shape;
    let name = |shape: StrokeShape| {
        SHAPES.iter().find(|(known, _)| *known == shape).map_or("", |(_, name)| name.tr())
    };
    line(ui, tr!("Shape"), tr!("What a stroke is"), |ui, id| {
        // The long names are for the menu: the card is no wider than its panel.
        let width = ui.available_width().clamp(60.0, 150.0);
        let combo = ComboBox::from_id_salt("shape").width(width).truncate();
        let combo = combo.selected_text(name(before));
        let response = combo.show_ui(ui, |ui| {
            for (shape, name) in SHAPES {
                ui.selectable_value(&mut bundle.shape, shape, name.tr());
            }
        });
        let response = response.response.labelled_by(id);
        changed = (bundle.shape != before).then(|| response.id.with(format!("{:?}", bundle.shape)));
    });
    let (count, is_lattice) = match &bundle.place {
        Placement::Scatter(count) => (*count, false),
        Placement::Lattice(count) => (*count, true),
        Placement::Paths(_) => {
            let text =
                tr!("They are where their points are; `chiaro hcbtf rules` shows and sets those");
            ui.label(RichText::new(text).color(theme::of(ui).dim).small());
            return changed;
        }
    };
    let (mut value, mut rows) = (f64::from(count), is_lattice);
    let most = f64::from(Strokes::MAX_COUNT);
    let counted =
        drag(ui, tr!("Count"), tr!("How many there are in a tile"), &mut value, 0.0..=most, 1.0, 0);
    let help = tr!("In shifted rows, as the dots of a half-tone, in place of scattered");
    let response = ui.checkbox(&mut rows, tr!("In rows")).on_hover_text(help);
    let rowed = response.changed().then_some(response.id);
    if counted.is_some() || rowed.is_some() {
        bundle.place =
            if rows { Placement::Lattice(value as u32) } else { Placement::Scatter(value as u32) };
    }
    changed.or(counted).or(rowed)
}

fn form(ui: &mut Ui, bundle: &mut Bundle) -> Option<Id> {
    let length = tr!("From the shortest to the longest, in widths of the tile");
    let width = tr!("From the narrowest to the widest, in widths of the tile");
    let taper =
        tr!("How much narrower they become toward the root and toward the tip: 1 is a point");
    let lift = tr!("How high the roots are over the tile, from the lowest to the highest");
    let mut changed = pair(ui, tr!("Length"), length, &mut bundle.length, 4.0);
    let mut by = |id: Option<Id>| changed = changed.or(id);
    by(pair(ui, tr!("Width"), width, &mut bundle.width, 1.0));
    by(pair(ui, tr!("Taper"), taper, &mut bundle.taper, 1.0));
    by(pair(ui, tr!("Lift"), lift, &mut bundle.lift, 2.0));
    by(angle(ui, tr!("Lean"), tr!("0 stands, 90 lies"), &mut bundle.lean, 0.0..=180.0));
    by(angle(
        ui,
        tr!("strokes" => "Bend"),
        tr!("How much more it leans at the tip"),
        &mut bundle.bend,
        -180.0..=180.0,
    ));
    by(angle(
        ui,
        tr!("Direction"),
        tr!("Where they lean to: 0 is up the tile, 90 to the right"),
        &mut bundle.direction,
        -360.0..=360.0,
    ));
    by(angle(
        ui,
        tr!("Spread"),
        tr!("How far they stray to either side: 180 is everywhere"),
        &mut bundle.spread,
        0.0..=180.0,
    ));
    by(angle(
        ui,
        tr!("Curl"),
        tr!("How much they turn sideways up to the tip"),
        &mut bundle.curl,
        -360.0..=360.0,
    ));
    let help = tr!("How often they turn while the eye goes once around: 1 keeps facing it");
    by(number(ui, tr!("Turns"), help, &mut bundle.turns, -4.0..=4.0));
    changed
}

fn colors(ui: &mut Ui, bundle: &mut Bundle) -> Option<Id> {
    let mut changed = None;
    let mut by = |id: Option<Id>| changed = changed.or(id);
    let [[root, other_root], [tip, other_tip]] = [&mut bundle.root, &mut bundle.tip];
    by(rgb(ui, tr!("Root"), root));
    by(rgb(ui, tr!("Other root"), other_root));
    by(rgb(ui, tr!("Tip"), tip));
    by(rgb(ui, tr!("Other tip"), other_tip));
    by(number(
        ui,
        tr!("Variation"),
        tr!("How much lighter or darker a stroke may be"),
        &mut bundle.variation,
        0.0..=1.0,
    ));
    by(number(
        ui,
        tr!("Ambient"),
        tr!("How much of its color is there in any light"),
        &mut bundle.ambient,
        0.0..=2.0,
    ));
    by(number(
        ui,
        tr!("Diffuse"),
        tr!("How much more where it faces the light"),
        &mut bundle.diffuse,
        0.0..=2.0,
    ));
    let help = tr!("How much more where the light shines through from behind");
    by(number(ui, tr!("Translucent"), help, &mut bundle.translucent, 0.0..=2.0));
    let highlight = &mut bundle.highlight;
    by(number(
        ui,
        tr!("Highlight"),
        tr!("How much of a highlight it has"),
        &mut highlight.amount,
        0.0..=2.0,
    ));
    if highlight.amount > 0.0 {
        by(rgb(ui, tr!("Its color"), &mut highlight.color));
        by(number(
            ui,
            tr!("Sharpness"),
            tr!("How small the highlight is"),
            &mut highlight.sharpness,
            1.0..=200.0,
        ));
    }
    changed
}

fn tones(ui: &mut Ui, tones: &mut Option<StrokeTones>) -> Option<Id> {
    let mut is_on = tones.is_some();
    let help =
        tr!("The darker or the lighter the light leaves the surface, the more of them there are");
    let response = ui.checkbox(&mut is_on, tr!("More of them by tone")).on_hover_text(help);
    if response.changed() {
        *tones = is_on.then_some(StrokeTones { first: 1.0, all: 0.0, growth: 0.0 });
    }
    let mut changed = response.changed().then_some(response.id);
    if let Some(tones) = tones {
        let mut by = |id: Option<Id>| changed = changed.or(id);
        let was = *tones;
        by(number(
            ui,
            tr!("First at"),
            tr!("The tone at which the first appears: 1 is full light"),
            &mut tones.first,
            0.0..=1.0,
        ));
        by(number(
            ui,
            tr!("All at"),
            tr!("The tone at which all are there"),
            &mut tones.all,
            0.0..=1.0,
        ));
        by(number(
            ui,
            tr!("Growth"),
            tr!("0: they appear whole, one by one; 1: all grow at once"),
            &mut tones.growth,
            0.0..=1.0,
        ));
        // The tones must differ, as there is no range between equal ones.
        if (tones.first - tones.all).abs() < 0.01 {
            let is_dark = was.first >= was.all;
            tones.all = if is_dark { tones.first - 0.01 } else { tones.first + 0.01 };
        }
    }
    changed
}

fn drag(
    ui: &mut Ui,
    label: &str,
    help: &str,
    value: &mut f64,
    range: RangeInclusive<f64>,
    speed: f64,
    decimals: usize,
) -> Option<Id> {
    line(ui, label, help, |ui, id| {
        let drag = number_field(ui, value).range(range).speed(speed).max_decimals(decimals);
        let response = ui.add(drag).labelled_by(id).on_hover_text(help);
        response.changed().then_some(response.id)
    })
}

/// Shows the two fields of a range of numbers.
fn pair(ui: &mut Ui, label: &str, help: &str, values: &mut [f64; 2], most: f64) -> Option<Id> {
    let mut changed = None;
    line(ui, label, help, |ui, _| {
        let names = [tr!("{label} from"), tr!("{label} to")];
        for (value, name) in values.iter_mut().zip(names) {
            let response =
                ui.add(number_field(ui, value).range(0.0..=most).speed(0.005).max_decimals(3));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, &name));
            if response.changed() {
                changed = Some(response.id);
            }
            response.on_hover_text(help);
        }
    });
    changed
}

/// Shows a field for an angle, in degrees; the value is in radians.
fn angle(
    ui: &mut Ui,
    label: &str,
    help: &str,
    radians: &mut f64,
    range: RangeInclusive<f64>,
) -> Option<Id> {
    let mut shown = radians.to_degrees();
    let most = range.end().to_radians();
    let changed = line(ui, label, help, |ui, id| {
        let drag = number_field(ui, &mut shown).range(range).speed(0.5).max_decimals(1).suffix("°");
        let response = ui.add(drag).labelled_by(id).on_hover_text(help);
        response.changed().then_some(response.id)
    });
    if changed.is_some() {
        *radians = shown.to_radians().clamp(-most, most);
    }
    changed
}
