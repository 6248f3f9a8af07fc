//! Masks that are painted on the mesh: pictures beside the look, and the strokes on them that can
//! be taken back.
//!
//! A mask's file has every stroke as soon as it ends. The strokes lie in the window's one order of
//! undo as long as the look is open: its picture shows them, whether the brush is at hand or not.

use std::path::PathBuf;
use std::sync::Arc;

use glam::{DQuat, DVec2, DVec3};

use crate::diag::Diagnostic;
use crate::document::{Look, Node, Value};
use crate::frame::{Image, Picture};
use crate::ids::{NodeId, PortName};
use crate::state::document::times::Times;
use crate::state::revision::StepTime;
use crate::state::stack::mask;

/// Largest number of strokes that can be taken back: each holds a mask of about a megabyte.
const MOST_STEPS: usize = 32;
/// Side of a new mask, in texels.
pub(crate) const SIDE: u32 = 1024;
/// Kind of the node that reads a mask's picture, and the input that names the file.
pub(crate) const IMAGE: &str = "image";

/// A mask's picture: one byte a texel, rows from the top; 0 hides the layer, 255 shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct MaskPicture {
    /// Width and height, in texels.
    pub(crate) size: [u32; 2],
    pub(crate) texels: Vec<u8>,
}

impl MaskPicture {
    /// A mask of one tone.
    pub(crate) fn filled(size: [u32; 2], texel: u8) -> Self {
        Self { size, texels: vec![texel; size[0] as usize * size[1] as usize] }
    }

    /// The mask in an image; `None` where the image has colors, or is transparent anywhere.
    pub(crate) fn of(image: &Image) -> Option<Self> {
        let rgba = image.rgba();
        let (texels, _) = rgba.as_chunks::<4>();
        let gray = texels.iter().map(|[r, g, b, a]| (r == g && g == b && *a == 255).then_some(*r));
        let texels: Vec<u8> = gray.collect::<Option<_>>()?;
        let is_whole = texels.len() == image.size[0] as usize * image.size[1] as usize;
        is_whole.then_some(Self { size: image.size, texels })
    }

    /// The mask as PNG.
    ///
    /// # Errors
    /// `png`: the reason why the picture cannot be encoded.
    pub(crate) fn to_png(&self) -> Result<Vec<u8>, Diagnostic> {
        let pixel = |texel: &u8| {
            let tone = f32::from(*texel) / 255.0;
            [tone, tone, tone, 1.0]
        };
        Picture { size: self.size, rgba: self.texels.iter().map(pixel).collect() }.to_png()
    }

    /// The mask after a stroke that covers each texel by a share from 0 to 1, and shows the layer
    /// there or hides it.
    pub(crate) fn painted(&self, cover: &[f32], shows: bool) -> Self {
        let goal = if shows { 255.0 } else { 0.0 };
        let texel = |(texel, share): (&u8, &f32)| {
            let tone = f32::from(*texel);
            (tone + (goal - tone) * share.clamp(0.0, 1.0)).round() as u8
        };
        let texels = self.texels.iter().zip(cover).map(texel).collect();
        Self { size: self.size, texels }
    }

    /// The mask with shown and hidden exchanged.
    pub(crate) fn inverted(&self) -> Self {
        Self { size: self.size, texels: self.texels.iter().map(|texel| 255 - texel).collect() }
    }
}

/// Way in which a mask's picture lies on the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum MaskLaying {
    /// By the mesh's UVs.
    Uvs,
    /// Straight through the mesh.
    Straight(StraightLaying),
}

/// Picture that lies straight through a mesh: u and v are even over space.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StraightLaying {
    /// True if places are the object's own, and not the world's.
    pub(crate) is_of_object: bool,
    /// Turn of the places, after which x runs along u and y along v.
    pub(crate) turn: DQuat,
    /// Factor and shift from turned places to UVs.
    pub(crate) scale: DVec2,
    pub(crate) offset: DVec2,
}

impl StraightLaying {
    /// A picture over a sphere of object space, as it is seen after a turn.
    pub(crate) fn around(center: DVec3, radius: f64, turn: DQuat) -> Self {
        let scale = 0.5 / if radius > 0.0 { radius } else { 1.0 };
        let offset = DVec2::splat(0.5) - (turn * center).truncate() * scale;
        Self { is_of_object: true, turn, scale: DVec2::splat(scale), offset }
    }

    /// The place in the picture: u to the right, v up.
    pub(crate) fn uv(&self, place: DVec3) -> DVec2 {
        (self.turn * place).truncate() * self.scale + self.offset
    }
}

/// Step of a mask's painting.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MaskStep {
    pub(crate) label: &'static str,
    /// File of the mask.
    pub(crate) file: PathBuf,
    pub(crate) before: Arc<MaskPicture>,
    pub(crate) after: Arc<MaskPicture>,
}

/// Steps of painted masks.
#[derive(Debug, Default)]
pub(crate) struct MaskSteps {
    done: Vec<MaskStep>,
    /// Undone steps, the next to redo last.
    undone: Vec<MaskStep>,
    pub(crate) times: Times,
}

impl MaskSteps {
    /// Notes a step that was done.
    pub(crate) fn did(&mut self, step: MaskStep, now: StepTime) {
        if self.done.len() >= MOST_STEPS {
            self.done.remove(0);
            self.times.fit((self.done.len(), self.undone.len()));
        }
        self.done.push(step);
        self.undone.clear();
        self.times.did((self.done.len(), 0), now);
    }

    /// Takes the last step back. Returns the file, and what is in it from now on.
    pub(crate) fn undo(&mut self) -> Option<(PathBuf, Arc<MaskPicture>)> {
        let step = self.done.pop()?;
        let found = (step.file.clone(), step.before.clone());
        self.undone.push(step);
        self.times.undid();
        Some(found)
    }

    /// Repeats the step that was taken back last. Returns the file, and what is in it from now on.
    pub(crate) fn redo(&mut self, now: StepTime) -> Option<(PathBuf, Arc<MaskPicture>)> {
        let step = self.undone.pop()?;
        let found = (step.file.clone(), step.after.clone());
        self.done.push(step);
        self.times.redid(now);
        Some(found)
    }

    pub(crate) fn undo_label(&self) -> Option<&'static str> {
        self.done.last().map(|step| step.label)
    }

    pub(crate) fn redo_label(&self) -> Option<&'static str> {
        self.undone.last().map(|step| step.label)
    }

    /// Number of done steps.
    pub(crate) fn place(&self) -> usize {
        self.done.len()
    }

    /// Labels of all steps: the done ones, then the undone ones, the next to redo first.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &'static str> {
        self.done.iter().chain(self.undone.iter().rev()).map(|step| step.label)
    }
}

/// Name of the file of a layer's mask, as the look names it: where the mask is an image of its own
/// that can be painted.
pub(crate) fn file_of<'l>(look: &'l Look, layer: &NodeId) -> Option<&'l str> {
    painted_of(look, layer).map(|(name, _)| name)
}

/// The name of the file of a layer's mask, as the look names it, and the way in which the picture
/// lies: where it can be painted.
pub(crate) fn painted_of<'l>(look: &'l Look, layer: &NodeId) -> Option<(&'l str, MaskLaying)> {
    let (id, name) = image_of(look, layer)?;
    Some((name, laying_of(look, id, look.graph.nodes.get(id)?)?))
}

/// The node that reads the picture of a layer's mask, and the picture's name as the look has it.
pub(crate) fn image_of<'l>(look: &'l Look, layer: &NodeId) -> Option<(&'l NodeId, &'l str)> {
    let (mask, _) = mask::of(look, layer)?;
    let (id, image) = feeder(look, mask, mask::SHOWN).filter(|(_, node)| node.kind == IMAGE)?;
    let Value::Text(name) = image.values.get(IMAGE)? else { return None };
    let is_file = name.to_lowercase().ends_with(".png") && !name.contains([':', '#']);
    is_file.then_some((id, name.as_str()))
}

fn laying_of(look: &Look, id: &NodeId, image: &Node) -> Option<MaskLaying> {
    if look.graph.wire_into(id, &PortName::new("uv")).is_none() {
        return Some(MaskLaying::Uvs);
    }
    let (from, node) = feeder(look, id, "uv")?;
    let (position, turn) = match node.kind.as_str() {
        "rotate_vector" => (feeder(look, from, "vector")?.1, turn_of(look, from, node)?),
        _ => (node, DQuat::IDENTITY),
    };
    let is_of_object = match position.values.get("space") {
        Some(Value::Text(space)) if space == "object" => true,
        Some(Value::Text(space)) if space != "world" => return None,
        _ => false,
    };
    let pair = |port, normal| match own(look, id, image, port)? {
        None => Some(DVec2::splat(normal)),
        Some(Value::Vector(numbers)) => Some(DVec2::new(*numbers.first()?, *numbers.get(1)?)),
        Some(_) => None,
    };
    let (scale, offset) = (pair("scale", 1.0)?, pair("offset", 0.0)?);
    let laying = StraightLaying { is_of_object, turn, scale, offset };
    (position.kind == "position").then_some(MaskLaying::Straight(laying))
}

/// The turn of a node that rotates vectors by values of its own.
fn turn_of(look: &Look, id: &NodeId, node: &Node) -> Option<DQuat> {
    let axis = match own(look, id, node, "axis")? {
        None => DVec3::Y,
        Some(Value::Vector(numbers)) => DVec3::from_slice(numbers.get(..3)?),
        Some(_) => return None,
    };
    let angle = match own(look, id, node, "angle")? {
        None => 0.0,
        Some(Value::Number(angle)) => *angle,
        Some(_) => return None,
    };
    let axis = axis.try_normalize();
    Some(axis.map_or(DQuat::IDENTITY, |axis| DQuat::from_axis_angle(axis, angle)))
}

/// The value that a node gives an input of its own, if it gives one; `None` where a wire gives it.
fn own<'l>(look: &Look, id: &NodeId, node: &'l Node, port: &str) -> Option<Option<&'l Value>> {
    let port = PortName::new(port);
    look.graph.wire_into(id, &port).is_none().then(|| node.values.get(&port))
}

/// The node that feeds an input.
fn feeder<'l>(look: &'l Look, id: &NodeId, port: &str) -> Option<(&'l NodeId, &'l Node)> {
    let wire = look.graph.wire_into(id, &PortName::new(port))?;
    look.graph.nodes.get_key_value(&wire.from.node)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(before: u8, after: u8) -> MaskStep {
        let of = |tone| Arc::new(MaskPicture::filled([2, 2], tone));
        MaskStep { label: "mask", file: "m.png".into(), before: of(before), after: of(after) }
    }

    #[test]
    fn strokes_show_and_hide_by_their_share() {
        let mask = MaskPicture { size: [2, 2], texels: vec![0, 100, 200, 255] };
        let cover = [1.0, 0.5, 0.0, 1.0];
        assert_eq!(mask.painted(&cover, true).texels, [255, 178, 200, 255]);
        assert_eq!(mask.painted(&cover, false).texels, [0, 50, 200, 0]);
        assert_eq!(mask.inverted().inverted(), mask);
    }

    #[test]
    fn a_mask_is_read_back_and_a_picture_with_colors_is_none() {
        let mask = MaskPicture { size: [2, 1], texels: vec![7, 255] };
        let image =
            |rgba: [u8; 8]| Image { size: [2, 1], bytes: rgba.to_vec(), ..Image::single([0; 4]) };
        assert_eq!(MaskPicture::of(&image([7, 7, 7, 255, 255, 255, 255, 255])), Some(mask.clone()));
        assert_eq!(MaskPicture::of(&image([7, 7, 8, 255, 0, 0, 0, 255])), None);
        assert_eq!(MaskPicture::of(&image([7, 7, 7, 9, 0, 0, 0, 255])), None);
        assert!(mask.to_png().unwrap().starts_with(b"\x89PNG"));
    }

    #[test]
    fn strokes_are_taken_back_and_only_so_many_are_kept() {
        let mut steps = MaskSteps::default();
        for tone in 0..60_u8 {
            steps.did(step(tone, tone + 1), StepTime(u64::from(tone)));
        }
        assert_eq!((steps.place(), steps.times.all().count()), (MOST_STEPS, MOST_STEPS));
        assert_eq!(steps.undo().map(|(_, mask)| mask.texels[0]), Some(59));
        assert_eq!((steps.undo_label(), steps.redo_label()), (Some("mask"), Some("mask")));
        assert_eq!(steps.redo(StepTime(61)).map(|(_, mask)| mask.texels[0]), Some(60));
        assert!(steps.redo(StepTime(62)).is_none());
    }
}
