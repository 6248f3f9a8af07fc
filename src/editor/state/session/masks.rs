//! Masks that are painted on the mesh.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use super::Session;
use crate::diag::Diagnostic;
use crate::document::{Edit, GraphId, Value};
use crate::frame::Assets;
use crate::ids::{NodeId, PortName};
use crate::state::masks::{IMAGE, MaskLaying, MaskPicture, MaskStep, SIDE, file_of, image_of};
use crate::state::pictures::{CarriedPicture, free_name, is_shared};
use crate::state::stack::Stack;

impl Session {
    /// Gives a layer a mask that hides it, in a new file beside the look's, which lies on the mesh
    /// in a way. The mask is selected.
    ///
    /// # Errors
    /// A diagnostic with the reason why there is no mask.
    pub(crate) fn new_mask(
        &mut self,
        layer: &NodeId,
        laying: &MaskLaying,
    ) -> Result<(), Box<Diagnostic>> {
        let name = self.name_of_new_mask()?;
        let black = MaskPicture::filled([SIDE, SIDE], 0).to_png().map_err(Box::new)?;
        let (mask, edit) = Stack::mask_by_picture(self.look(), layer, (&name, laying));
        self.apply_with(vec![CarriedPicture { name, bytes: black }], edit)?;
        self.select(vec![mask]);
        Ok(())
    }

    /// Gives the mask of a layer a picture of its own beside the look, a copy, where another
    /// document may show the picture that it has. Returns the names of both, as the look names
    /// them.
    ///
    /// # Errors
    /// A diagnostic where the copy cannot be written.
    pub(crate) fn own_mask(
        &mut self,
        layer: &NodeId,
    ) -> Result<Option<[String; 2]>, Box<Diagnostic>> {
        let Some((id, before)) = image_of(self.look(), layer) else { return Ok(None) };
        let (id, before) = (id.clone(), before.to_owned());
        if self.path().is_none_or(|path| !is_shared(path, &before)) {
            return Ok(None);
        }
        // A picture that is no mask is not painted either, and the brush says why.
        let image = Assets::of(&self.assets).image(&self.look.folder(), &before);
        let Some(mask) = image.ok().and_then(|image| MaskPicture::of(&image)) else {
            return Ok(None);
        };
        let name = self.name_of_new_mask()?;
        let bytes = mask.to_png().map_err(Box::new)?;
        let edit = Edit::SetValue {
            graph: GraphId::Look,
            id,
            port: PortName::new(IMAGE),
            value: Value::Text(name.clone()),
            index: None,
        };
        self.apply_with(vec![CarriedPicture { name: name.clone(), bytes }], edit)?;
        Ok(Some([before, name]))
    }

    /// Writes pictures beside the look, and applies the edit that names them, as one step.
    ///
    /// # Errors
    /// A diagnostic where a picture cannot be written or the edit is impossible; the look is then
    /// as it was.
    pub(crate) fn apply_with(
        &mut self,
        pictures: Vec<CarriedPicture>,
        edit: Edit,
    ) -> Result<(), Box<Diagnostic>> {
        let folder = self.look.folder();
        let mut pictures = pictures.into_iter();
        let written = pictures
            .try_for_each(|picture| self.pictures.bring(&folder.join(picture.name), picture.bytes));
        let done = written.and_then(|()| self.apply(edit, None));
        if done.is_err() {
            self.bring_pictures_along();
        }
        done
    }

    /// A free name for a mask beside the look's file.
    fn name_of_new_mask(&self) -> Result<String, Box<Diagnostic>> {
        let unsaved = tr!("save the look first: its mask is a picture beside its file");
        let path = self.path().ok_or_else(|| Box::new(Diagnostic::error("no-mask", unsaved)))?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        free_name(&self.look.folder(), (&format!("{stem}-mask"), ".png"), |_| false)
    }

    /// Takes pictures away that a step brought which was taken back, unless a snapshot shows them,
    /// or brings them again. One that cannot be written is told as a problem of the picture.
    pub(super) fn bring_pictures_along(&mut self) {
        let of_shelf = self.shelf.all().map(|snapshot| &*snapshot.look);
        let looks: Vec<_> = std::iter::once(self.look.document()).chain(of_shelf).collect();
        match self.pictures.follow(&looks, &self.look.folder()) {
            Ok(false) => {}
            Ok(true) => self.files_changed(),
            Err(problem) => self.tell_of_picture(*problem),
        }
    }

    fn tell_of_picture(&mut self, problem: Diagnostic) {
        self.picture_problems.push(problem);
        self.revisions.problems.advance();
    }

    /// File of a layer's painted mask; `None` where the layer has none, or the look no file.
    pub(crate) fn mask_file(&self, layer: &NodeId) -> Option<PathBuf> {
        self.path()?;
        file_of(self.look(), layer).map(|name| self.look.folder().join(name))
    }

    /// Writes what a step made of a mask, and notes the step.
    ///
    /// # Errors
    /// A diagnostic that names the file; nothing is changed then.
    pub(crate) fn paint_mask(&mut self, step: MaskStep) -> Result<(), Box<Diagnostic>> {
        self.write_mask(&step.file, &step.after)?;
        self.revisions.step.advance();
        self.masks.did(step, self.revisions.step);
        self.look.end_gesture();
        if let Some(open_scene) = &mut self.open_scene {
            open_scene.end_gesture();
        }
        Ok(())
    }

    /// Writes a mask, and draws again with it.
    ///
    /// # Errors
    /// A diagnostic that names the file; the old file is then as it was.
    pub(crate) fn write_mask(
        &mut self,
        file: &Path,
        mask: &MaskPicture,
    ) -> Result<(), Box<Diagnostic>> {
        self.pictures.write(file, &mask.to_png().map_err(Box::new)?)?;
        self.files_changed();
        Ok(())
    }

    /// Writes what undo or redo made of a mask. A mask that cannot be written is told as a problem
    /// of the picture.
    pub(super) fn bring_mask_back(&mut self, found: Option<(PathBuf, Arc<MaskPicture>)>) -> bool {
        let Some((file, mask)) = found else { return false };
        match self.write_mask(&file, &mask) {
            Ok(()) => true,
            Err(problem) => {
                self.tell_of_picture(*problem);
                false
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;
    use crate::state::session::saving::OwnFiles;
    use crate::state::stack::tree::LayerTree;

    /// A session with a look in a file, and the look's uppermost layer.
    fn saved(file: &Path) -> (Session, NodeId) {
        let mut session = Session::new(Arc::new(Library::built_in().clone()), || {});
        session.save_named(file, OwnFiles::Linked).unwrap();
        let tree = LayerTree::of(session.look(), &session.project.catalog);
        let layer = tree.rows(|_| false)[0].id.clone();
        (session, layer)
    }

    /// Fills the mask of a layer with a tone, as a stroke over all of it does.
    fn fill(session: &mut Session, layer: &NodeId, [before, after]: [u8; 2]) {
        let of = |tone| Arc::new(MaskPicture::filled([SIDE, SIDE], tone));
        let file = session.mask_file(layer).unwrap();
        let (before, after) = (of(before), of(after));
        session.paint_mask(MaskStep { label: "stroke", file, before, after }).unwrap();
    }

    #[test]
    fn strokes_are_taken_back_in_the_order_of_all_steps() {
        let folder = tempfile::tempdir().unwrap();
        let (mut session, layer) = saved(&folder.path().join("a.json"));
        session.new_mask(&layer, &MaskLaying::Uvs).unwrap();
        let file = session.mask_file(&layer).unwrap();
        let png = |tone| MaskPicture::filled([SIDE, SIDE], tone).to_png().unwrap();
        let known = [0, 128, 255].map(|tone| (png(tone), tone));
        let tone = || {
            let bytes = std::fs::read(&file).unwrap();
            known.iter().find(|(png, _)| *png == bytes).map(|(_, tone)| *tone).unwrap()
        };
        fill(&mut session, &layer, [0, 255]);
        let edit =
            Stack::of(session.look(), &session.project.catalog).unmask(session.look(), &layer);
        session.apply(edit.unwrap(), None).unwrap();
        session.undo();
        assert!(session.mask_file(&layer).is_some(), "the last step is the look's");
        fill(&mut session, &layer, [255, 128]);
        assert_eq!((session.steps().undo_label(), tone()), (Some("stroke"), 128));
        session.undo();
        assert_eq!(tone(), 255);
        session.undo();
        assert_eq!(tone(), 0);
        session.undo();
        assert!(!file.exists() && session.mask_file(&layer).is_none(), "the mask itself");
        while session.redo() {}
        assert_eq!(tone(), 128, "the mask and both strokes");

        // Under another name, undo leaves the first look's mask as it is.
        session.save_as(&folder.path().join("b.json")).unwrap();
        while session.undo() {}
        assert_eq!(tone(), 128);
    }

    /// A mask that another look shows is copied before it is painted, in a step of its own.
    #[test]
    fn a_mask_that_others_show_is_painted_in_a_copy() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let (mut session, layer) = saved(&path("a.json"));
        session.new_mask(&layer, &MaskLaying::Uvs).unwrap();
        session.save_as(&path("a.json")).unwrap();
        assert_eq!(session.own_mask(&layer).unwrap(), None, "it is the look's own");
        session.save_as(&path("b.json")).unwrap();
        let copied = session.own_mask(&layer).unwrap();
        assert_eq!(copied, Some(["a-mask.png".to_owned(), "b-mask.png".to_owned()]));
        assert_eq!(session.mask_file(&layer), Some(path("b-mask.png")));
        assert_eq!(session.own_mask(&layer).unwrap(), None, "once is enough");
        let first = std::fs::read(path("a-mask.png")).unwrap();
        assert_eq!(std::fs::read(path("b-mask.png")).unwrap(), first);
        fill(&mut session, &layer, [0, 255]);
        assert_eq!(std::fs::read(path("a-mask.png")).unwrap(), first);
        session.undo();
        session.undo();
        assert_eq!(session.mask_file(&layer), Some(path("a-mask.png")));
        assert!(!path("b-mask.png").exists(), "nothing is left of the copy");

        // An edit that is impossible leaves no picture behind.
        let impossible = Edit::RemoveNode { graph: GraphId::Look, id: "none".into() };
        let picture = CarriedPicture { name: "x.png".to_owned(), bytes: vec![1] };
        session.apply_with(vec![picture], impossible).unwrap_err();
        assert!(!path("x.png").exists());

        // One that lies elsewhere is another's in any case.
        std::fs::create_dir(path("c")).unwrap();
        session.save_as(&path("c/c.json")).unwrap();
        let (image, _) = image_of(session.look(), &layer).unwrap();
        let edit = Edit::SetValue {
            graph: GraphId::Look,
            id: image.clone(),
            port: PortName::new(IMAGE),
            value: Value::Text("../a-mask.png".to_owned()),
            index: None,
        };
        session.apply(edit, None).unwrap();
        let copied = session.own_mask(&layer).unwrap().unwrap();
        assert_eq!(copied, ["../a-mask.png".to_owned(), "c-mask.png".to_owned()]);
    }

    #[test]
    fn a_mask_that_a_file_names_or_that_was_painted_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.json");
        let (mut session, layer) = saved(&path);
        session.new_mask(&layer, &MaskLaying::Uvs).unwrap();
        let file = session.mask_file(&layer).unwrap();
        session.undo();
        assert!(!file.exists());
        session.redo();
        assert!(file.exists());
        // A snapshot shows it when the look does not.
        session.take_snapshot().unwrap();
        let stack = Stack::of(session.look(), &session.project.catalog);
        let edit = stack.unmask(session.look(), &layer).unwrap();
        session.apply(edit, None).unwrap();
        let edit = Edit::RemoveNode { graph: GraphId::Look, id: layer.clone() };
        session.apply(edit, None).unwrap();
        session.undo();
        assert!(session.mask_file(&layer).is_none() && file.exists());
        session.undo();
        session.undo();
        assert!(session.shelf().is_empty() && session.mask_file(&layer).is_some());
        std::fs::write(&file, "painted elsewhere").unwrap();
        session.undo();
        assert_eq!(std::fs::read(&file).unwrap(), b"painted elsewhere");
        session.redo();
        session.write_mask(&file, &MaskPicture::filled([SIDE, SIDE], 0)).unwrap();
        session.save_as(&path).unwrap();
        session.undo();
        assert!(session.mask_file(&layer).is_none() && file.exists(), "the saved look names it");
    }
}
