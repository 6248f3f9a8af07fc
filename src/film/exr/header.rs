//! Attributes of a file: the frame, the camera, the space of its colors.

use ::exr::meta::attribute::{AttributeValue, Chromaticities, TimeCode};
use ::exr::meta::header::{ImageAttributes, LayerAttributes};
use ::exr::prelude::{Text, Vec2};
use glam::{DMat4, DVec3};

use crate::FrameRate;
use crate::frame::View;

/// Attribute of what Chiaro says of a picture: notes of the form `name=text`, joined by semicolons.
const NOTES: &str = "chiaro";
/// Place of the first attribute: after the number that all files begin with, and the version.
const FIRST_ATTRIBUTE: usize = 8;
/// Note of the hash of the plan that was drawn.
pub(super) const PLAN: &str = "plan";
/// Note of the checksum of all numbers.
pub(super) const SEAL: &str = "seal";
/// Note of the space in which layers were blended.
const BLENDED_IN: &str = "blendedIn";
/// Note of the space that layers of contributions and values of looks are in.
pub(super) const LAYERS_IN: &str = "layersIn";
/// Attribute of the space of the colors, by the names of the Color Interop Forum.
const COLOR_SPACE: &str = "colorInteropID";

/// Number of a frame among others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameStamp {
    /// The frame.
    pub frame: i32,
    /// Frames per second.
    pub rate: FrameRate,
}

impl FrameStamp {
    /// The time on a clock that counts frames and drops none; `None` before frame 0, for more than
    /// 30 frames a second, which codes cannot say, and after a day.
    fn time_code(self) -> Option<TimeCode> {
        let rate = self.rate.nominal();
        let frame = u32::try_from(self.frame).ok().filter(|_| rate <= 30)?;
        let seconds = frame / rate;
        let hours = u8::try_from(seconds / 3600).ok().filter(|hours| *hours < 24)?;
        Some(TimeCode {
            hours,
            minutes: (seconds / 60 % 60) as u8,
            seconds: (seconds % 60) as u8,
            frame: (frame % rate) as u8,
            drop_frame: false,
            color_frame: false,
            field_phase: false,
            binary_group_flags: [false; 3],
            binary_groups: [0; 8],
        })
    }
}

/// Statements of a file about its picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExrHeader {
    /// The camera.
    pub view: Option<View>,
    /// The frame, of a picture among others.
    pub stamp: Option<FrameStamp>,
    /// Hash of the plan that was drawn.
    pub plan: String,
    /// The space in which layers were blended: `display`, `linear`, or both where looks differ;
    /// empty where there is no look.
    pub blended_in: String,
    /// The space of layers that hold contributions, where there are some.
    pub layers_in: String,
    /// Other statements, such as the manifests of mattes.
    pub attributes: Vec<ExrAttribute>,
}

/// Statement in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExrAttribute {
    /// Name of the attribute.
    pub name: String,
    /// Text of the attribute.
    pub text: String,
}

impl ExrHeader {
    /// Sets the attributes that all parts of a file share.
    pub(super) fn mark(&self, attributes: &mut ImageAttributes) {
        attributes.chromaticities = Some(Chromaticities {
            red: Vec2(0.64, 0.33),
            green: Vec2(0.3, 0.6),
            blue: Vec2(0.15, 0.06),
            white: Vec2(0.3127, 0.329),
        });
        attributes.time_code = self.stamp.and_then(FrameStamp::time_code);
        let space = AttributeValue::Text(Text::from("lin_rec709_scene"));
        attributes.other.insert(Text::from(COLOR_SPACE), space);
    }

    /// The attributes of the part.
    pub(super) fn of_layer(&self, size: [u32; 2], seal: &str) -> LayerAttributes {
        let mut attributes = LayerAttributes {
            software_name: Some(Text::from(concat!("Chiaro ", env!("CARGO_PKG_VERSION")))),
            ..LayerAttributes::default()
        };
        let notes = [
            (SEAL, seal),
            (BLENDED_IN, &self.blended_in),
            (LAYERS_IN, &self.layers_in),
            (PLAN, &self.plan),
        ];
        let notes = notes.iter().filter(|(_, text)| !text.is_empty());
        let notes: Vec<String> = notes.map(|(name, text)| format!("{name}={text}")).collect();
        if let Some(text) = Text::new_or_none(notes.join(";")) {
            attributes.other.insert(Text::from(NOTES), AttributeValue::Text(text));
        }
        for ExrAttribute { name, text } in &self.attributes {
            if let (Some(name), Some(text)) = (Text::new_or_none(name), Text::new_or_none(text)) {
                attributes.other.insert(name, AttributeValue::Text(text));
            }
        }
        attributes.frames_per_second =
            self.stamp.map(|FrameStamp { rate, .. }| (rate.frames as i32, rate.seconds));
        if let Some(view) = &self.view {
            attributes.world_to_camera = Some(rows(world_to_camera(view)));
            attributes.world_to_normalized_device = Some(rows(world_to_picture(view)));
            if view.is_perspective {
                let up = view.view_height / 2.0;
                let across = up * f64::from(size[0]) / f64::from(size[1].max(1));
                let angle = |half: f64| (2.0 * half.atan()).to_degrees() as f32;
                attributes.vertical_field_of_view = Some(angle(up));
                attributes.horizontal_field_of_view = Some(angle(across));
            }
        }
        attributes
    }
}

/// Sorts the attributes of a file of one part by their names, for the library writes those that it
/// does not know in no order, and equal pictures are equal files. `None` for what is no whole
/// header.
pub(super) fn sort_attributes(bytes: &mut [u8]) -> Option<()> {
    let text = |from: usize| Some(from + bytes.get(from..)?.iter().position(|byte| *byte == 0)?);
    let mut attributes = Vec::new();
    let mut at = FIRST_ATTRIBUTE;
    while *bytes.get(at)? != 0 {
        let name = text(at)?;
        let kind = text(name + 1)?;
        let length = bytes.get(kind + 1..kind + 5)?.try_into().ok()?;
        let end = kind + 5 + usize::try_from(i32::from_le_bytes(length)).ok()?;
        attributes.push((bytes.get(at..name)?.to_vec(), bytes.get(at..end)?.to_vec()));
        at = end;
    }
    attributes.sort();
    let sorted: Vec<u8> = attributes.into_iter().flat_map(|(_, bytes)| bytes).collect();
    bytes.get_mut(FIRST_ATTRIBUTE..at)?.copy_from_slice(&sorted);
    Some(())
}

/// From the world to the camera as EXR has it: x right, y up, z away from the viewer.
fn world_to_camera(view: &View) -> DMat4 {
    DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0)) * view.camera_from_world
}

/// From the world to the picture as EXR has it: (0, 0) is its upper left corner, (1, 1) its lower
/// right one.
fn world_to_picture(view: &View) -> DMat4 {
    let place = DMat4::from_translation(DVec3::new(0.5, 0.5, 0.0));
    place * DMat4::from_scale(DVec3::new(0.5, -0.5, 1.0)) * view.clip_from_world
}

/// A matrix as EXR has it: for rows on its left, row by row, which is a matrix for columns on its
/// right, column by column.
fn rows(matrix: DMat4) -> [f32; 16] {
    matrix.to_cols_array().map(|x| x as f32)
}

/// The frames per second, where they are said and are some.
pub(super) fn rate_of(attributes: &LayerAttributes) -> Option<FrameRate> {
    let (frames, seconds) = attributes.frames_per_second?;
    let frames = u32::try_from(frames).ok()?;
    (frames > 0 && seconds > 0).then_some(FrameRate { frames, seconds })
}

/// A note of Chiaro's.
pub(super) fn note_of(attributes: &LayerAttributes, name: &str) -> Option<String> {
    let AttributeValue::Text(notes) = attributes.other.get(&Text::from(NOTES))? else {
        return None;
    };
    let notes = notes.to_string();
    let mut notes = notes.split(';').filter_map(|note| note.split_once('='));
    notes.find_map(|(found, text)| (found == name).then(|| text.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Camera;

    #[test]
    fn clocks_count_frames() {
        let code = |frame, frames, seconds| {
            let rate = FrameRate { frames, seconds };
            let code = FrameStamp { frame, rate }.time_code()?;
            Some([code.hours, code.minutes, code.seconds, code.frame])
        };
        assert_eq!(code(0, 24, 1), Some([0, 0, 0, 0]));
        assert_eq!(code(24 * 3661 + 5, 24, 1), Some([1, 1, 1, 5]));
        assert_eq!(code(30, 30_000, 1001), Some([0, 0, 1, 0]));
        assert_eq!((code(-1, 24, 1), code(1, 60, 1), code(24 * 86_400, 24, 1)), (None, None, None));
    }

    #[test]
    fn the_camera_is_where_compositors_look_for_it() {
        let camera = Camera { eye: [1.0, 2.0, 5.0], target: [1.0, 2.0, 0.0], ..Camera::default() };
        let view = View::new(&camera, [200, 100], DVec3::ZERO, 3.0);
        let ahead = world_to_camera(&view).transform_point3(DVec3::new(1.5, 2.25, 1.0));
        assert!((ahead - DVec3::new(0.5, 0.25, 4.0)).length() < 1e-12, "{ahead}");
        let seen = world_to_picture(&view).project_point3(DVec3::new(1.0, 2.0, 0.0));
        assert!((seen.truncate() - 0.5).length() < 1e-12, "{seen}");
        let higher = world_to_picture(&view).project_point3(DVec3::new(1.0, 2.5, 0.0));
        assert!(higher.y < 0.5 && (higher.x - 0.5).abs() < 1e-12, "{higher}");
        // Rows on the left: what moves stands in the last row.
        let moved = rows(DMat4::from_translation(DVec3::new(7.0, 8.0, 9.0)));
        assert_eq!(moved[12..15], [7.0, 8.0, 9.0]);
    }
}
