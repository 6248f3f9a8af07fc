//! Mark of a keyed value: a diamond, hollow where nothing moves the value, in the key's color where
//! a direction does, in the accent where time does.

use chiaro_locale::tr;
use eframe::egui::{
    Color32, Pos2, Response, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, vec2,
};

use crate::document::Target;
use crate::ids::LightId;
use crate::state::keying::{KeyedBy, KeyedLook};
use crate::widgets::theme;

/// Colors of a target's mark: within it, and along its edge.
pub(crate) fn inks(ui: &Ui, keys: KeyedLook<'_>, target: &Target) -> (Color32, Color32) {
    let colors = theme::of(ui);
    match keys.keyed_by(target) {
        KeyedBy::Nothing => (Color32::TRANSPARENT, colors.dim.gamma_multiply(0.7)),
        KeyedBy::Direction(set) => {
            let key = keys.key_at(set);
            (colors.hue(key), colors.hue(key))
        }
        KeyedBy::Time(track) => {
            let track = keys.base.look.time_keys.get(track);
            let of_track = track.map(|track| track.keys.as_slice()).unwrap_or_default();
            let is_here = of_track.iter().any(|key| (key.time - keys.view.time).abs() < 1e-6);
            (if is_here { colors.accent } else { Color32::TRANSPARENT }, colors.accent)
        }
    }
}

/// Shows the mark of a target, to be pressed.
pub(crate) fn of(ui: &mut Ui, keys: KeyedLook<'_>, target: &Target, name: &str) -> Response {
    let (fill, edge) = inks(ui, keys, target);
    let (rect, response) =
        ui.allocate_exact_size(vec2(16.0, ui.spacing().interact_size.y), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), name));
    let is_at = response.hovered() || response.has_focus();
    let edge = if is_at { theme::of(ui).text } else { edge };
    diamond(ui, rect.center(), 4.5, fill, edge);
    response
}

/// Explanation of what moves a target.
pub(crate) fn help(keys: KeyedLook<'_>, target: &Target) -> String {
    match keys.keyed_by(target) {
        KeyedBy::Nothing => {
            tr!("Nothing moves this value. Press to key it by a direction or in time.").to_owned()
        }
        KeyedBy::Direction(set) => {
            let of_set = keys.base.look.direction_keys.get(set);
            let name = of_set.map(|keys| keys.name.as_str()).unwrap_or_default();
            let key = keys.key_at(set) + 1;
            tr!("Moved by the direction keys \"{name}\": this is its value at key {key}.")
        }
        KeyedBy::Time(_) => {
            tr!("Changes with time: this is its value at the playhead; setting it keys it there.")
                .to_owned()
        }
    }
}

/// Fields of a light that keys move, in words; `None` where none do.
pub(crate) fn keyed_fields(keys: KeyedLook<'_>, light: &LightId) -> Option<String> {
    let is_of_light =
        |target: &&Target| matches!(target, Target::Light { light: of, .. } if of == light);
    let look = keys.base.look;
    let in_time = look.time_keys.iter().map(|track| &track.target);
    let by_direction = look.direction_keys.iter().flat_map(|set| &set.keys);
    let by_direction = by_direction.flat_map(|key| key.values.keys());
    let mut fields: Vec<String> = in_time
        .chain(by_direction)
        .filter(is_of_light)
        .map(|target| keys.base.names_of(target)[1].clone())
        .collect();
    fields.sort_unstable();
    fields.dedup();
    (!fields.is_empty()).then(|| fields.join(", "))
}

/// Paints a diamond.
pub(crate) fn diamond(ui: &Ui, at: Pos2, radius: f32, fill: Color32, edge: Color32) {
    let corners = [vec2(0.0, -radius), vec2(radius, 0.0), vec2(0.0, radius), vec2(-radius, 0.0)];
    let points = corners.map(|corner: Vec2| at + corner).to_vec();
    ui.painter().add(Shape::convex_polygon(points, fill, Stroke::new(1.3, edge)));
}
