//! Reading a scene.

use std::collections::HashSet;

use indexmap::IndexMap;

use super::look::{light, top};
use super::reader::{Fields, Reader};
use crate::diag::Diagnostic;
use crate::document::json::{At, Kind};
use crate::document::shape::{CAMERA, FAR, OBJECT, SCENE, TIME_RANGE, TRANSFORM};
use crate::document::{Camera, Object, Scene, TimeRange, Transform, parse_hex};
use crate::ids::{ObjectId, make_slug};

/// The scene at the top of a document.
pub(super) fn scene(r: &mut Reader<'_>, at: At) -> Option<Scene> {
    let mut fields = r.object(at, &SCENE)?;
    top(r, &mut fields);
    let normal = Scene::default();
    Some(Scene {
        name: r.text(&fields, "name").unwrap_or_default(),
        about: r.text(&fields, "about").unwrap_or_default(),
        objects: objects(r, &mut fields),
        lights: r.map(&mut fields, "lights", light),
        illumination: r.rotation(&mut fields, "illumination").unwrap_or(normal.illumination),
        camera: camera(r, &mut fields).unwrap_or_default(),
        backdrop: r
            .field(&fields, "backdrop", |r, at, _| backdrop(r, at))
            .unwrap_or(normal.backdrop),
        time: time_range(r, &mut fields).unwrap_or_default(),
        unknown: fields.unknown,
    })
}

/// The objects by id; who gives no id gets one from its mesh.
fn objects(r: &mut Reader<'_>, fields: &mut Fields) -> IndexMap<ObjectId, Object> {
    let found =
        r.list(fields, "objects", |r, at| object(r, at).map(|(id, object)| (at, id, object)));
    let mut taken: HashSet<ObjectId> =
        found.iter().filter_map(|(_, (_, id, _))| id.clone()).collect();
    let mut objects = IndexMap::with_capacity(found.len());
    let mut kept = Vec::with_capacity(found.len());
    for (index, (at, id, object)) in found {
        let id = id.unwrap_or_else(|| {
            let made =
                ObjectId::from(make_slug(mesh_name(&object.mesh), |slug| taken.contains(slug)));
            taken.insert(made.clone());
            made
        });
        if objects.contains_key(&id) {
            let free = make_slug(id.as_str(), |slug| taken.contains(slug));
            let message = format!("another object has the id `{id}`; this one is left out");
            let problem = Diagnostic::error("duplicate-id", message)
                .hint(format!("write \"id\": \"{free}\""));
            r.report_item("objects", index, at, problem);
        } else {
            kept.push(index);
            objects.insert(id, object);
        }
    }
    r.keep("objects", kept);
    objects
}

/// `sphere` of `shape:sphere`, `bunny` of `meshes/bunny.obj`.
fn mesh_name(mesh: &str) -> &str {
    let file = mesh.rsplit(['/', '\\', ':']).next().unwrap_or(mesh);
    file.split_once('.').map_or(file, |(stem, _)| stem)
}

fn object(r: &mut Reader<'_>, at: At) -> Option<(Option<ObjectId>, Object)> {
    let mut fields = r.object(at, &OBJECT)?;
    let normal = Object::default();
    let id = r.slug::<ObjectId>(&fields, "id");
    let object = Object {
        mesh: r.text(&fields, "mesh").unwrap_or(normal.mesh),
        transform: transform(r, &mut fields).unwrap_or_default(),
        looks: r.field(&fields, "looks", looks).unwrap_or_default(),
        values: r.values(&mut fields),
        visible: r.bool(&fields, "visible").unwrap_or(normal.visible),
        unknown: fields.unknown,
    };
    Some((id, object))
}

/// A path for everything, or paths by material.
fn looks(
    r: &mut Reader<'_>,
    at: At,
    kind: &'static crate::document::shape::Kind,
) -> Option<IndexMap<String, String>> {
    match r.tree.kind(at) {
        Kind::Text => {
            r.text_at(at, 4096).map(|path| IndexMap::from([("*".to_owned(), path.into_owned())]))
        }
        _ => r.members(at, kind, |r, member, key| {
            r.text_at(member, 4096).map(|path| (key.to_owned(), path.into_owned()))
        }),
    }
}

fn transform(r: &mut Reader<'_>, of: &mut Fields) -> Option<Transform> {
    let (transform, unknown) = r.field(of, "transform", |r, at, _| {
        let mut fields = r.object(at, &TRANSFORM)?;
        let normal = Transform::default();
        let scale = r.field(&fields, "scale", |r, at, _| {
            let scale = r.array_at::<3>(at, FAR)?;
            if scale.iter().any(|s| s.abs() < 1e-9) {
                let problem =
                    Diagnostic::error("out-of-range", "a scale of 0 leaves nothing of the mesh");
                r.report(
                    at,
                    problem
                        .hint("write any other number, or \"visible\": false to hide the object"),
                );
                return None;
            }
            Some(scale)
        });
        let transform = Transform {
            translate: r.array(&fields, "translate").unwrap_or(normal.translate),
            rotate: r.rotation(&mut fields, "rotate").unwrap_or(normal.rotate),
            scale: scale.unwrap_or(normal.scale),
            fit: r.bool(&fields, "fit").unwrap_or(normal.fit),
        };
        Some((transform, fields.unknown))
    })?;
    of.shadow("transform", None, unknown);
    Some(transform)
}

fn camera(r: &mut Reader<'_>, of: &mut Fields) -> Option<Camera> {
    let (camera, unknown) = r.field(of, "camera", |r, at, _| {
        let fields = r.object(at, &CAMERA)?;
        let normal = Camera::default();
        let camera = Camera {
            eye: r.array(&fields, "eye").unwrap_or(normal.eye),
            target: r.array(&fields, "target").unwrap_or(normal.target),
            up: r.array(&fields, "up").unwrap_or(normal.up),
            projection: r.word(&fields, "projection").unwrap_or_default(),
            fov: r.number(&fields, "fov").unwrap_or(normal.fov),
            height: r.number(&fields, "height").unwrap_or(normal.height),
            aspect: r.number(&fields, "aspect").unwrap_or(normal.aspect),
        };
        Some((camera, fields.unknown))
    })?;
    of.shadow("camera", None, unknown);
    Some(camera)
}

fn time_range(r: &mut Reader<'_>, of: &mut Fields) -> Option<TimeRange> {
    let (time, unknown) = r.field(of, "time", |r, at, _| {
        let fields = r.object(at, &TIME_RANGE)?;
        let normal = TimeRange::default();
        let start = r.number(&fields, "start").unwrap_or(normal.start);
        let time = TimeRange {
            start,
            end: r.number(&fields, "end").unwrap_or(normal.end),
            fps: r.number(&fields, "fps").unwrap_or(normal.fps),
        };
        Some((time, fields.unknown))
    })?;
    of.shadow("time", None, unknown);
    Some(time)
}

fn backdrop(r: &mut Reader<'_>, at: At) -> Option<Option<[f64; 4]>> {
    match r.tree.kind(at) {
        Kind::Null => Some(None),
        Kind::Text if r.tree.string(at).as_deref() == Some("none") => Some(None),
        Kind::Text => {
            let hex = r.tree.string(at).and_then(|text| parse_hex(&text));
            if hex.is_none() {
                let problem = Diagnostic::error("bad-color", "this is no color");
                r.report(
                    at,
                    problem.hint(
                        "write \"#rrggbb\", \"#rrggbbaa\", [r, g, b, a], or null for transparent",
                    ),
                );
            }
            hex.map(Some)
        }
        _ => {
            let color = r.color_at(at, true)?;
            Some(Some([color[0], color[1], color[2], color.get(3).copied().unwrap_or(1.0)]))
        }
    }
}
