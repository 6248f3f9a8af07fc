//! Objects that lights are aimed at: where they are, and warnings of those that there are not.

use std::collections::BTreeSet;
use std::sync::Arc;

use chiaro_locale::tr;
use glam::DVec3;

use super::links::located;
use super::setup::Setup;
use crate::diag::Diagnostic;
use crate::document::{AimPlaces, Light};
use crate::ids::{LightId, ObjectId};

impl Setup {
    /// Places of objects that lights are aimed at.
    pub fn aims(&self) -> Arc<AimPlaces> {
        self.aim_places(|number| self.objects[number].center())
    }

    /// Places of objects that lights are aimed at: the middles of their boxes, as `center_of` gives
    /// them by the objects' numbers.
    ///
    /// The middle is what one sees as the place of an object, wherever the origin of its mesh is:
    /// at the feet of a figure, or far off in a scan. An object that is hidden, as a mark for
    /// lights may be, has no mesh here; its place is that which its transform moves it to, the
    /// middle of every mesh that is fitted.
    pub(super) fn aim_places(&self, center_of: impl Fn(usize) -> DVec3) -> Arc<AimPlaces> {
        let mut places = AimPlaces::new();
        for id in self.aimed_lights().filter_map(|(_, _, light)| light.aimed_at.as_ref()) {
            if places.contains_key(id) {
                continue;
            }
            let number = self.objects.iter().position(|object| object.id == *id);
            let hidden = || self.scene.objects.get(id).map(|it| it.transform.translate.into());
            places.extend(number.map(&center_of).or_else(hidden).map(|at| (id.clone(), at)));
        }
        Arc::new(places)
    }

    /// Lights that are aimed at objects, each with the look that has it, or `None` for the scene's.
    fn aimed_lights(&self) -> impl Iterator<Item = (Option<usize>, &LightId, &Light)> {
        let of_scene = self.scene.lights.iter().map(|(id, light)| (None, id, light));
        let of_looks = self.looks.iter().enumerate().flat_map(|(number, look)| {
            let own = look.look.lights.iter();
            let own = own.filter(|(id, _)| !self.scene.lights.contains_key(*id));
            own.map(move |(id, light)| (Some(number), id, light))
        });
        of_scene.chain(of_looks).filter(|(_, _, light)| light.aimed_at.is_some())
    }

    /// Warnings of lights that are aimed at objects which there are not.
    pub(super) fn aim_warnings(&self) -> Vec<Diagnostic> {
        let placed = self.objects.iter().map(|object| &object.id);
        let ids: BTreeSet<&str> =
            placed.chain(self.scene.objects.keys()).map(ObjectId::as_str).collect();
        let mut found = Vec::new();
        for (look, id, light) in self.aimed_lights() {
            let Some(wanted) = &light.aimed_at else { continue };
            if ids.contains(wanted.as_str()) {
                continue;
            }
            let message =
                tr!("the light `{id}` is aimed at the object `{wanted}`, which there is not");
            let problem = Diagnostic::warning("unknown-object", message)
                .suggest(wanted.as_str(), ids.iter().copied())
                .hint(tr!("until there is, it shines as if it were aimed at nothing"));
            let path = format!("lights.{id}.aimed_at");
            found.push(match look {
                None => located(self, problem, path),
                Some(look) => {
                    let mut problem = problem.json_path(path);
                    self.looks[look].source.locate(&mut problem);
                    problem
                }
            });
        }
        found
    }
}
