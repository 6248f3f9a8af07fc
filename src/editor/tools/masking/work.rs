//! Strokes on a mask, carried out on the tool's thread.

use std::path::PathBuf;
use std::sync::Arc;

use chiaro_locale::tr;
use glam::DVec3;

use super::project::{MaskObject, MaskStroke, cover};
use crate::frame::{Assets, View};
use crate::state::masks::{MaskLaying, MaskPicture, MaskStep};
use crate::state::problem_text::sentence;
use crate::state::snapshot::RenderSnapshot;

/// Change of a mask.
#[derive(Clone, Debug)]
pub(super) enum MaskChange {
    Stroke(MaskStroke),
    /// The whole mask shows the layer, or hides it.
    Fill(bool),
    Invert,
}

impl MaskChange {
    fn label(&self) -> &'static str {
        match self {
            Self::Stroke(stroke) if stroke.shows => tr!("paint the mask"),
            Self::Stroke(_) => tr!("erase the mask"),
            Self::Fill(true) => tr!("fill the mask"),
            Self::Fill(false) => tr!("clear the mask"),
            Self::Invert => tr!("invert the mask"),
        }
    }
}

pub(super) struct MaskRequest {
    /// File of the mask, and its name as the look has it.
    pub(super) file: PathBuf,
    pub(super) name: String,
    pub(super) laying: MaskLaying,
    pub(super) change: MaskChange,
    /// Size of the picture, in pixels.
    pub(super) size: [u32; 2],
    pub(super) snapshot: RenderSnapshot,
}

/// The way in which a new mask lies on the picture that a snapshot shows. Without a picture, and
/// where its meshes have UVs, that is by them.
pub(crate) fn laying(snapshot: &RenderSnapshot) -> MaskLaying {
    let Ok(setup) = snapshot.setup(&mut Assets::of(&snapshot.assets)) else {
        return MaskLaying::Uvs;
    };
    // Only directions count, so that any size will do.
    let view = View::new(&setup.value.scene.camera, [64, 64], DVec3::ZERO, 1.0);
    MaskObject::laying(&MaskObject::of(&setup.value), &view)
}

/// True if no mesh that the open look is on has vertex colors; false without a picture.
pub(crate) fn lacks_colors(snapshot: &RenderSnapshot) -> bool {
    let setup = snapshot.setup(&mut Assets::of(&snapshot.assets));
    setup.is_ok_and(|setup| {
        let objects = MaskObject::of(&setup.value);
        let mut worn = objects.iter().filter(|object| !object.worn.is_empty());
        worn.all(|object| !object.mesh.has_colors)
    })
}

/// Result of a request: the step, or the reason why there is none, as a sentence without its end.
pub(super) type MaskAnswer = Result<MaskStep, String>;

/// Carries out a request.
pub(super) fn carry_out(assets: &mut Assets, request: MaskRequest) -> MaskAnswer {
    let MaskRequest { file, name, laying, change, size, snapshot } = request;
    let setup = snapshot.setup(assets).map_err(|problems| {
        problems.first().map_or_else(|| tr!("There is no picture to paint on").to_owned(), sentence)
    })?;
    let image = assets.image(&snapshot.folder, &name).map_err(|problem| sentence(&problem))?;
    let before = MaskPicture::of(&image).ok_or_else(|| {
        tr!("{name} has colors or is transparent: it is no mask to be painted, and stays as it is")
    })?;
    let after = match &change {
        MaskChange::Fill(shows) => MaskPicture::filled(before.size, if *shows { 255 } else { 0 }),
        MaskChange::Invert => before.inverted(),
        MaskChange::Stroke(stroke) => {
            let objects = MaskObject::of(&setup.value);
            let mut worn = objects.iter().filter(|object| !object.worn.is_empty());
            if laying == MaskLaying::Uvs && worn.all(|object| !object.mesh.has_uvs) {
                return Err(tr!(
                    "This mesh has no UVs, and this mask lies by them: remove it, and mask by \
                     painting anew"
                )
                .to_owned());
            }
            let view = View::new(&setup.value.scene.camera, size, DVec3::ZERO, 1.0);
            let shares = cover(&view, &objects, stroke, (before.size, &laying));
            if shares.iter().all(|share| *share <= 0.0) {
                return Err(tr!("Nothing of the look is there: paint on the model").to_owned());
            }
            before.painted(&shares, stroke.shows)
        }
    };
    if after == before {
        return Err(tr!("The mask is like that already").to_owned());
    }
    let (before, after) = (Arc::new(before), Arc::new(after));
    Ok(MaskStep { label: change.label(), file, before, after })
}
