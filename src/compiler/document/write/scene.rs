//! Writing a scene.

use super::look::lights;
use super::value::values;
use super::{part, same, top};
use crate::document::json::{Layout, Writer};
use crate::document::shape::{CAMERA, OBJECT, SCENE, TIME_RANGE, TRANSFORM};
use crate::document::{Camera, Object, Scene, TimeRange, Transform, Unknown};
use crate::ids::ObjectId;

pub(super) fn scene(w: &mut Writer, scene: &Scene) {
    let (unknown, normal) = (&scene.unknown, Scene::default());
    w.shaped(Layout::Lines, &SCENE, Some(unknown), |w| {
        top(w, "scene", unknown);
        w.text_unless_empty("name", &scene.name);
        w.text_unless_empty("about", &scene.about);
        if !scene.objects.is_empty() {
            w.member("objects", |w| {
                w.list(Layout::Lines, &scene.objects, |w, (id, of_id)| object(w, id, of_id));
            });
        }
        lights(w, &scene.lights, unknown);
        w.numbers_unless("illumination", &scene.illumination, &normal.illumination);
        optional(w, "camera", part(Some(unknown), "camera", None), &CAMERA, |w| {
            camera(w, &scene.camera);
        });
        match (&scene.backdrop, &normal.backdrop) {
            (None, _) => w.member("backdrop", Writer::null),
            (Some(color), Some(default)) if same(color, default) => {}
            (Some(color), _) => w.member("backdrop", |w| w.numbers(color)),
        }
        optional(w, "time", part(Some(unknown), "time", None), &TIME_RANGE, |w| {
            time_range(w, &scene.time);
        });
    });
}

/// An object in one line, which is not written where all of it has its default.
fn optional(
    w: &mut Writer,
    name: &str,
    unknown: Option<&Unknown>,
    shape: &crate::document::shape::Shape,
    write: impl Fn(&mut Writer),
) {
    let mut trial = Writer::new();
    trial.shaped(Layout::Inline, shape, unknown, &write);
    if trial.finish() != "{}\n" {
        w.member(name, |w| w.shaped(Layout::Inline, shape, unknown, &write));
    }
}

fn object(w: &mut Writer, id: &ObjectId, object: &Object) {
    let unknown = &object.unknown;
    w.shaped(Layout::Lines, &OBJECT, Some(unknown), |w| {
        w.member("id", |w| w.string(id.as_str()));
        w.member("mesh", |w| w.string(&object.mesh));
        let extras = part(Some(unknown), "transform", None);
        optional(w, "transform", extras, &TRANSFORM, |w| transform(w, &object.transform));
        match object.looks.get("*").filter(|_| object.looks.len() == 1) {
            Some(path) => w.member("looks", |w| w.string(path)),
            None if object.looks.is_empty() => {}
            None => w.member("looks", |w| {
                w.object(Layout::Inline, |w| {
                    for (material, path) in &object.looks {
                        w.member(material, |w| w.string(path));
                    }
                });
            }),
        }
        values(w, &object.values, unknown);
        if !object.visible {
            w.member("visible", |w| w.bool(false));
        }
    });
}

fn transform(w: &mut Writer, transform: &Transform) {
    let normal = Transform::default();
    w.numbers_unless("translate", &transform.translate, &normal.translate);
    w.numbers_unless("rotate", &transform.rotate, &normal.rotate);
    w.numbers_unless("scale", &transform.scale, &normal.scale);
    if transform.fit != normal.fit {
        w.member("fit", |w| w.bool(transform.fit));
    }
}

fn camera(w: &mut Writer, camera: &Camera) {
    let normal = Camera::default();
    w.numbers_unless("eye", &camera.eye, &normal.eye);
    w.numbers_unless("target", &camera.target, &normal.target);
    w.numbers_unless("up", &camera.up, &normal.up);
    w.word_unless("projection", camera.projection, normal.projection);
    w.number_unless("fov", camera.fov, normal.fov);
    w.number_unless("height", camera.height, normal.height);
    w.number_unless("aspect", camera.aspect, normal.aspect);
}

fn time_range(w: &mut Writer, time: &TimeRange) {
    let normal = TimeRange::default();
    w.number_unless("start", time.start, normal.start);
    w.number_unless("end", time.end, normal.end);
    w.number_unless("fps", time.fps, normal.fps);
}
