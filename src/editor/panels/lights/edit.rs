//! Fields of a light: its type, its frame, and the fields that lights of its type have.

use chiaro_locale::{Text, text, tr};
use eframe::egui;
use eframe::egui::{Color32, ComboBox, Id, Pos2, Role, Sense, Stroke, Ui, WidgetInfo, vec2};

use crate::commands::Command;
use crate::document::{ColorSpace, Light, LightField, LightKind, LightQuantity, LightSpace, Value};
use crate::fields::lighting::{OwnedKeys, OwnedLight};
use crate::fields::marks::FieldTarget;
use crate::fields::row::{self, labelled};
use crate::ids::{LightGroup, ObjectId, is_slug, make_slug};
use crate::library::Type;
use crate::state::session::Session;
use crate::widgets::color;
use crate::widgets::number::{self, number_field, number_field_as, number_slider};
use crate::widgets::text;
use crate::widgets::theme;

const BALL: f32 = 84.0;

/// Least side of it in a narrow panel, and the room that the numbers beside it take, in points.
const LEAST_BALL: f32 = 44.0;
const BESIDE_BALL: f32 = 54.0;
/// Least value set by hand for a number that must be above 0, such as the angle of a cone in
/// radians: a cone of no width gives no light.
const LEAST_ABOVE: f64 = 1e-3;
/// Largest factor on a slider; larger ones can be typed.
const MOST_BY_SLIDER: f64 = 4.0;
/// Text for a light that is aimed at no object.
const NOTHING: Text = text!("Nothing");
const AIM_HELP: Text = text!(
    "An object that it shines at from its position, wherever either goes. Point lights shine \
     everywhere"
);
/// Text for a distance of 0.
const OFF: Text = text!("Off");

/// Shows all fields of a light but its name.
pub(crate) fn edit(
    ui: &mut Ui,
    session: &Session,
    owned_light: &OwnedLight<'_>,
    out: &mut Vec<Command>,
) {
    ui.push_id((owned_light.owner, owned_light.id), |ui| {
        // Keyed fields are shown, and set, at the current direction key or at the playhead.
        let light = &owned_light.as_set(session);
        let mut new = light.clone();
        let mut widget = None;
        let mut asked = Vec::new();
        labelled(
            ui,
            tr!("Type"),
            tr!("Directional lights are as far away as the sun"),
            |ui, label| {
                widget = widget.or(kind(ui, label, &mut new));
            },
        );
        labelled(ui, tr!("light" => "Frame"), tr!("What its direction turns with"), |ui, label| {
            widget = widget.or(space(ui, label, &mut new));
        });
        if session.open_scene().is_some() || light.aimed_at.is_some() {
            labelled(ui, tr!("Aim at"), AIM_HELP.tr(), |ui, label| {
                widget = widget.or(aimed_at(ui, label, session, &mut new));
            });
        }
        let fields: Vec<LightField> = new.fields().collect();
        for field in fields {
            let ty = Type::of_light_field(field);
            let target = owned_light.target(field.name());
            let label = field.label();
            let owned = OwnedKeys::of(session, owned_light.owner);
            let marked = owned.map(|owned| {
                let target = target.clone();
                FieldTarget { owned, target, ty: &ty, label, reset: None }
            });
            let text = egui::RichText::new(label).color(theme::of(ui).text);
            let help = marked.as_ref().map(FieldTarget::help).unwrap_or_default();
            let help = format!("{}\n{help}", field.help());
            row::marked(ui, text, help.trim_end(), marked.as_ref(), &mut asked, |ui, label, _| {
                widget = widget.or(value(ui, label, field, &mut new, session.look().color_space));
            });
        }
        let help =
            tr!("Groups that it belongs to, with commas between them; sets of lights name them");
        labelled(ui, tr!("Groups"), help, |ui, label| {
            let found =
                text::formed(ui, label, &light.groups, |groups| groups_text(groups), read_groups);
            if let Some((changed, groups)) = found {
                new.groups = groups;
                widget = widget.or(Some(changed));
            }
        });
        out.append(&mut asked);
        if let Some(widget) = widget.filter(|_| new != *light) {
            out.push(owned_light.changed(session, light, &new).held(widget));
        }
    });
}

/// Groups in a line, with commas between them.
pub(crate) fn groups_text(groups: &[LightGroup]) -> String {
    groups.iter().map(LightGroup::as_str).collect::<Vec<_>>().join(", ")
}

/// Groups of a line, each once.
///
/// # Errors
/// The word that is no group, and what to write.
pub(crate) fn read_groups(text: &str) -> Result<Vec<LightGroup>, String> {
    let mut groups: Vec<LightGroup> = Vec::new();
    for word in text.split(',').map(str::trim).filter(|word| !word.is_empty()) {
        if !is_slug(word) {
            return Err(tr!(
                "`{word}` is no group: write {slug}",
                slug = make_slug(word, |_| false)
            ));
        }
        if !groups.iter().any(|group| group.as_str() == word) {
            groups.push(LightGroup::new(word));
        }
    }
    Ok(groups)
}

/// Shows one field. Returns the id of the widget that changed it.
fn value(
    ui: &mut Ui,
    label: Id,
    field: LightField,
    light: &mut Light,
    space: ColorSpace,
) -> Option<Id> {
    if let Ok(vector) = <&mut [f64; 3]>::try_from(field.numbers_mut(light)) {
        return match field.quantity() {
            LightQuantity::Color => rgb(ui, label, vector, space),
            _ if field == LightField::Direction => {
                let on_ball = ball(ui, vector);
                on_ball.or(ui.vertical(|ui| xyz(ui, label, vector)).inner)
            }
            _ => xyz(ui, label, vector),
        };
    }
    let most = match field.within() {
        Some(around) => around.numbers(light).first().copied(),
        None => field.range().map(|[_, most]| most),
    };
    let most = most.unwrap_or(f64::MAX);
    let normal = field.numbers(&Light::default()).first().copied().unwrap_or_default();
    let number = field.numbers_mut(light).first_mut()?;
    let widget = match field.quantity() {
        LightQuantity::Angle => angle(ui, label, number, most),
        LightQuantity::Distance => distance(ui, label, field, number),
        _ => factor(ui, label, number, most, normal),
    };
    if widget.is_some() {
        keep_within(field, light);
    }
    widget
}

/// Keeps a field that was set above its least value, and the fields bounded by it within the new
/// value.
pub(crate) fn keep_within(field: LightField, light: &mut Light) {
    let Some(number) = field.numbers_mut(light).first_mut() else { return };
    if field.is_above_range() {
        *number = number.max(LEAST_ABOVE);
    }
    let most = *number;
    for inner in LightField::ALL.into_iter().filter(|inner| inner.within() == Some(field)) {
        inner.numbers_mut(light).iter_mut().for_each(|number| *number = number.min(most));
    }
}

fn rgb(ui: &mut Ui, label: Id, color: &mut [f64; 3], space: ColorSpace) -> Option<Id> {
    let [r, g, b] = *color;
    let (id, [r, g, b, _]) = color::edit(ui, label, [r, g, b, 1.0], space, false)?;
    *color = [r, g, b];
    Some(id)
}

/// Shows a factor from 0 on; a factor that is not finite becomes that of a new light.
fn factor(ui: &mut Ui, label: Id, factor: &mut f64, most: f64, normal: f64) -> Option<Id> {
    ui.spacing_mut().slider_width = (ui.available_width() - 66.0).max(40.0);
    let slider = number_slider(ui, factor, 0.0..=most.min(MOST_BY_SLIDER));
    let slider = slider.unbounded().max_decimals(3);
    let response = ui.add(slider).labelled_by(label);
    *factor = if factor.is_finite() { factor.max(0.0) } else { normal };
    response.changed().then_some(response.id)
}

/// Shows a length in scene units; 0 stands for no bound.
fn distance(ui: &mut Ui, label: Id, field: LightField, length: &mut f64) -> Option<Id> {
    let [least, most] = field.range().unwrap_or([0.0, f64::MAX]);
    let mut new = *length;
    let write = |length, decimals| match length {
        0.0 => OFF.tr().to_owned(),
        _ => egui::emath::format_with_decimals_in_range(length, decimals),
    };
    let read = |text: &str| match text.trim() {
        text if text.eq_ignore_ascii_case(OFF.english()) => Some(0.0),
        text if text.to_lowercase() == OFF.tr().to_lowercase() => Some(0.0),
        text => number::read(text),
    };
    let drag = number_field_as(ui, &mut new, write, read)
        .range(least..=most)
        .clamp_existing_to_range(false)
        .speed(0.02)
        .max_decimals(3);
    let response = ui.add_sized([66.0, ui.spacing().interact_size.y], drag).labelled_by(label);
    let is_changed = response.changed() && new.is_finite();
    if is_changed {
        *length = new;
    }
    is_changed.then_some(response.id)
}

fn kind(ui: &mut Ui, label: Id, light: &mut Light) -> Option<Id> {
    let before = light.kind;
    let combo =
        ComboBox::from_id_salt("kind").selected_text(kind_name(light.kind)).show_ui(ui, |ui| {
            for &kind in LightKind::ALL {
                ui.selectable_value(&mut light.kind, kind, kind_name(kind));
            }
        });
    let id = combo.response.labelled_by(label).id;
    (light.kind != before).then_some(id)
}

/// Display name of a type of lights.
pub(crate) fn kind_name(kind: LightKind) -> &'static str {
    match kind {
        LightKind::Directional => tr!("light" => "Directional"),
        LightKind::Point => tr!("light" => "Point"),
        LightKind::Spot => tr!("light" => "Spot"),
    }
}

/// Display name of a frame.
pub(crate) fn space_name(space: LightSpace) -> &'static str {
    match space {
        LightSpace::Illumination => tr!("Illumination frame"),
        LightSpace::World => tr!("World"),
        LightSpace::Camera => tr!("Camera"),
        LightSpace::Object => tr!("Object"),
    }
}

fn space(ui: &mut Ui, label: Id, light: &mut Light) -> Option<Id> {
    let before = light.space;
    let combo =
        ComboBox::from_id_salt("space").selected_text(space_name(light.space)).show_ui(ui, |ui| {
            for &space in LightSpace::ALL {
                ui.selectable_value(&mut light.space, space, space_name(space));
            }
        });
    let id = combo.response.labelled_by(label).id;
    (light.space != before).then_some(id)
}

/// Shows the object that a light is aimed at, among those of the scene.
fn aimed_at(ui: &mut Ui, label: Id, session: &Session, light: &mut Light) -> Option<Id> {
    let name = |id: Option<&ObjectId>| id.map_or(NOTHING.tr(), ObjectId::as_str).to_owned();
    let before = light.aimed_at.clone();
    let combo =
        ComboBox::from_id_salt("aim").selected_text(name(before.as_ref())).show_ui(ui, |ui| {
            ui.selectable_value(&mut light.aimed_at, None, NOTHING.tr());
            let objects = session.open_scene().into_iter().flat_map(|open| &open.scene().objects);
            for (id, _) in objects {
                ui.selectable_value(&mut light.aimed_at, Some(id.clone()), id.as_str());
            }
        });
    let id = combo.response.labelled_by(label).id;
    (light.aimed_at != before).then_some(id)
}

fn xyz(ui: &mut Ui, label: Id, numbers: &mut [f64; 3]) -> Option<Id> {
    let mut widget = None;
    let before = *numbers;
    // Three numbers side by side fit a narrow panel, or the whole panel would become wider.
    ui.spacing_mut().item_spacing.x = 3.0;
    ui.spacing_mut().button_padding.x = 3.0;
    for (number, axis) in numbers.iter_mut().zip(["x ", "y ", "z "]) {
        let drag = number_field(ui, number).speed(0.01).max_decimals(3).prefix(axis);
        let response = ui.add(drag).labelled_by(label);
        if response.changed() {
            widget = Some(response.id);
        }
    }
    if numbers.iter().any(|x| !x.is_finite()) {
        *numbers = before;
    }
    widget
}

fn angle(ui: &mut Ui, label: Id, radians: &mut f64, max: f64) -> Option<Id> {
    let mut degrees = radians.to_degrees();
    ui.spacing_mut().slider_width = (ui.available_width() - 66.0).max(40.0);
    // Without the pointer on it a slider must not touch the value, not even to round it.
    let slider = number_slider(ui, &mut degrees, 0.0..=max.to_degrees());
    let response = ui.add(slider.suffix("°").max_decimals(1)).labelled_by(label);
    if response.changed() {
        *radians = degrees.to_radians();
    }
    response.changed().then_some(response.id)
}

/// Shows all directions on a disc: the distance from its center is the angle from the viewer.
fn ball(ui: &mut Ui, direction: &mut [f64; 3]) -> Option<Id> {
    let side = (ui.available_width() - BESIDE_BALL).clamp(LEAST_BALL, BALL);
    let (rect, response) = ui.allocate_exact_size(vec2(side, side), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr!("Direction of the light")));
    let (center, radius) = (rect.center(), side / 2.0 - 3.0);
    let painter = ui.painter_at(rect);
    painter.circle(center, radius, theme::of(ui).canvas, Stroke::new(1.0, theme::of(ui).grid));
    painter.circle_filled(center, radius / 2.0, theme::of(ui).node);
    let at = to_disc(*direction, center, radius);
    painter.line_segment([center, at], Stroke::new(1.5, theme::of(ui).accent.gamma_multiply(0.6)));
    painter.circle_filled(at, 4.5, theme::of(ui).accent);
    let p = response.interact_pointer_pos().filter(|_| response.dragged() || response.clicked())?;
    *direction = from_disc(p, center, radius);
    Some(response.id)
}

fn to_disc(direction: [f64; 3], center: Pos2, radius: f32) -> Pos2 {
    let d = glam::DVec3::from(direction).try_normalize().unwrap_or(glam::DVec3::Z);
    let side = d.x.hypot(d.y);
    let angle = side.atan2(d.z) / std::f64::consts::PI;
    let (x, y) = if side > 1e-12 { (d.x / side, d.y / side) } else { (1.0, 0.0) };
    center + vec2((x * angle) as f32, -(y * angle) as f32) * radius
}

fn from_disc(p: Pos2, center: Pos2, radius: f32) -> [f64; 3] {
    let d = (p - center) / radius;
    let distance = f64::from(d.length()).min(1.0);
    let (sin, cos) = (distance * std::f64::consts::PI).sin_cos();
    let (x, y) = if distance > 1e-6 { (f64::from(d.x), f64::from(-d.y)) } else { (0.0, 0.0) };
    let scale = sin / x.hypot(y).max(1e-6);
    [x * scale, y * scale, cos].map(|x| (x * 1e3).round() / 1e3)
}

/// Color of a light as shown on the screen.
pub(crate) fn swatch(light: &Light, space: ColorSpace) -> Color32 {
    let value = Value::Vector(light.color.to_vec());
    let [r, g, b, _] = match space {
        ColorSpace::Display => value.color().unwrap_or([0.0, 0.0, 0.0, 1.0]),
        ColorSpace::Linear => {
            let encode =
                |x: f64| f64::from(egui::ecolor::gamma_from_linear(x.clamp(0.0, 1.0) as f32));
            let [r, g, b] = light.color.map(encode);
            [r, g, b, 1.0]
        }
    };
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    Color32::from_rgb(byte(r), byte(g), byte(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    #[test]
    fn the_disc_holds_every_direction() {
        let center = pos2(40.0, 40.0);
        for direction in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -1.0, 0.0], [-0.48, 0.64, -0.6]] {
            let back = from_disc(to_disc(direction, center, 39.0), center, 39.0);
            for (a, b) in direction.iter().zip(back) {
                assert!((a - b).abs() < 2e-3, "{direction:?} {back:?}");
            }
        }
        assert!(from_disc(pos2(79.0, 40.0), center, 39.0)[2] < -0.99, "the rim is behind");
    }
}
