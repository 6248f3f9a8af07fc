//! Surfaces that are cut out, lit in linear light, or mirrored, compared with geometry and closed
//! forms. Every picture is made from files as an artist has them, opened and drawn as by `chiaro
//! render`.
#![cfg(feature = "gpu")]

use std::fs;
use std::path::Path;

use crate::support::badf::{Mode, alpha as profile_tone, angle, blend, held};
use crate::support::eval::{renderer, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::diag::Severity;
use chiaro::frame::{Assets, PlanOptions, Planner, open};
use chiaro::interp::Precision;
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::reference::{self, Modules, execute};
use chiaro::render::Picture;
use glam::{DVec3, DVec4};
use image::{Rgba, RgbaImage};
use serde_json::{Value as Json, json};

/// Side of every picture here, in pixels. The camera sees a square of 2 by 2 scene units.
const SIDE: u32 = 64;
/// Largest difference of equal colors, half an 8-bit step: half floats and other arithmetic err by
/// less.
const NEAR: f32 = 0.5 / 255.0;
const BACKDROP: [f32; 4] = [0.25, 0.5, 0.125, 1.0];

/// A folder for one test.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn text(&self, name: &str, text: &str) {
        fs::write(self.path().join(name), text).unwrap();
    }

    fn json(&self, name: &str, json: &Json) {
        self.text(name, &json.to_string());
    }

    /// A PNG of `side` by `side` texels, rows from the top.
    fn image(&self, name: &str, side: u32, texel: impl Fn(u32, u32) -> [u8; 4]) {
        RgbaImage::from_fn(side, side, |x, y| Rgba(texel(x, y)))
            .save(self.path().join(name))
            .unwrap();
    }

    /// Draws a scene of these objects, seen along -z without perspective; `change` may edit the
    /// scene last.
    fn draw_with(&self, objects: &Json, change: impl Fn(&mut Json)) -> Picture {
        self.draw_live(objects, change, &Live::Keyed, 0.0)
    }

    fn draw_live(
        &self,
        objects: &Json,
        change: impl Fn(&mut Json),
        live: &Live,
        time: f64,
    ) -> Picture {
        let mut scene = json!({
            "objects": objects, "backdrop": BACKDROP,
            "camera": {"projection": "orthographic", "height": 2}
        });
        change(&mut scene);
        self.json("scene.json", &scene);
        let mut assets = Assets::default();
        let (setup, odd) = open(&self.path().join("scene.json"), None, &mut assets)
            .unwrap_or_else(|problems| panic!("{}", told(&problems)))
            .into_parts();
        assert!(odd.iter().all(|problem| problem.severity == Severity::Note), "{}", told(&odd));
        let options = PlanOptions { size: [SIDE; 2], samples: 1, time };
        let mut planner = Planner::new(assets);
        let (plan, warnings) = planner
            .plan(&setup, Library::built_in(), live, &options)
            .unwrap_or_else(|problems| panic!("{}", told(&problems)))
            .into_parts();
        assert!(warnings.is_empty(), "{}", told(&warnings));
        block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The scene as the GPU draws it, baked and live, and as the reference draws it.
    fn draw_everywhere(&self, scene: &Json) -> [Picture; 3] {
        self.json("scene.json", scene);
        let mut assets = Assets::default();
        let setup = open(&self.path().join("scene.json"), None, &mut assets)
            .unwrap_or_else(|problems| panic!("{}", told(&problems)))
            .value;
        let options = PlanOptions { size: [SIDE; 2], samples: 1, time: 0.0 };
        let plan = |mut planner: Planner, live: &Live| {
            let plan = planner.plan(&setup, Library::built_in(), live, &options);
            plan.unwrap_or_else(|problems| panic!("{}", told(&problems))).value
        };
        let [baked, edited] = [Live::Keyed, Live::All].map(|live| {
            let plan = plan(Planner::new(assets.clone()), &live);
            block_on(renderer().picture(&plan)).unwrap_or_else(|error| panic!("{error}"))
        });
        let truth = plan(Planner::for_truth(assets.clone()), &Live::All);
        let modules =
            Modules::new(&truth, Precision::F64).unwrap_or_else(|problem| panic!("{problem}"));
        let drawn =
            execute(&truth, &modules, &reference::ReferenceOptions::default(), &Progress::new());
        [baked, edited, drawn.unwrap_or_else(|problem| panic!("{problem}")).to_picture()]
    }

    fn draw(&self, objects: &Json) -> Picture {
        self.draw_with(objects, |_| ())
    }
}

/// JSON of an object.
fn object(mesh: &str, look: &str) -> Json {
    json!({"id": mesh.split('.').next(), "mesh": mesh, "looks": look, "transform": {"fit": false}})
}

fn pixels(picture: &Picture) -> impl Iterator<Item = (u32, u32, [f32; 4])> + '_ {
    (0..SIDE).flat_map(move |y| (0..SIDE).map(move |x| (x, y, picture.pixel(x, y))))
}

/// Position of a pixel's middle, from -1 to 1, with y up.
fn place(x: u32, y: u32) -> (f64, f64) {
    let step = 2.0 / f64::from(SIDE);
    ((f64::from(x) + 0.5) * step - 1.0, 1.0 - (f64::from(y) + 0.5) * step)
}

/// The texel at a pixel, for an image of `side` texels that covers the picture.
fn texel(side: u32, x: u32, y: u32) -> (u32, u32) {
    (x * side / SIDE, y * side / SIDE)
}

#[track_caller]
fn assert_near(found: [f32; 4], expected: [f32; 4], near: f32, at: (u32, u32)) {
    let far = found.iter().zip(expected).any(|(a, b)| (a - b).abs() > near || a.is_nan());
    assert!(!far, "{found:?} is not {expected:?} at {at:?}");
}

/// A square that covers the picture, with UVs and a look of its own by material.
fn write_square(folder: &Folder, name: &str, material: &Json) {
    let corners = [[-1f32, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let mut bytes: Vec<u8> =
        corners.iter().flat_map(|[x, y]| [*x, *y, 0.0]).flat_map(f32::to_le_bytes).collect();
    // glTF counts v downward.
    bytes.extend(
        corners.iter().flat_map(|[x, y]| [0.5 + 0.5 * x, 0.5 - 0.5 * y]).flat_map(f32::to_le_bytes),
    );
    bytes.extend([0u16, 1, 2, 0, 2, 3].iter().flat_map(|i| i.to_le_bytes()));
    let binary = format!("{name}.bin");
    fs::write(folder.path().join(&binary), &bytes).unwrap();
    folder.json(
        name,
        &json!({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{
                "primitives": [{
                    "attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0
                }]
            }],
            "materials": [material],
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
            "bufferViews": [
                {"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
            "buffers": [{"byteLength": 92, "uri": binary}]
        }),
    );
}

// --- Alpha cut-outs

/// A look that shows an image with its alpha, with values of the output.
fn image_look(image: &str, output: &Json) -> Json {
    json!({
        "nodes": [
            {"id": "leaf", "kind": "image", "values": {"image": image, "filter": "nearest"}},
            {"id": "output", "kind": "output", "values": output}
        ],
        "wires": [{"from": "leaf.color", "to": "output.color"}]
    })
}

fn flat_look(color: [f32; 4]) -> Json {
    json!({
        "nodes": [
            {"id": "paint", "kind": "base", "values": {"color": color}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [{"from": "paint", "to": "output.color"}]
    })
}

const LEAF: [u8; 3] = [204, 51, 102];
/// Alphas of the leaf's texels, in turn: 0 and 127 are below a cutoff of a half, 255 is opaque.
const ALPHAS: [u8; 4] = [0, 255, 127, 255];

fn leaf_alpha(x: u32, y: u32) -> u8 {
    let (column, row) = texel(4, x, y);
    ALPHAS[((column + row) % 4) as usize]
}

fn leaf_folder() -> Folder {
    let folder = Folder::new();
    let [r, g, b] = LEAF;
    folder.image("leaf.png", 4, |x, y| [r, g, b, ALPHAS[((x + y) % 4) as usize]]);
    folder.json("paint.json", &flat_look([0.0, 0.25, 1.0, 1.0]));
    // The wall is behind the upper half. A speck of the near wall lies before the leaf, beyond the
    // picture, and brings the wall's middle before the leaf's too, so that the wall is drawn after
    // the leaf: texels that the leaf cuts out must leave no depth either.
    let speck = "v 3 0 3\nv 3.1 0 3\nv 3 0.1 3\nf 5 6 7\n";
    let wall = "v -1 0 -1\nv 1 0 -1\nv 1 1 -1\nv -1 1 -1\nf 1 2 3 4\n";
    folder.text("wall.obj", wall);
    folder.text("near_wall.obj", &format!("{wall}{speck}"));
    folder
}

/// Asserts that every pixel is the leaf's, the wall's or the backdrop's.
fn assert_cut(picture: &Picture, wall: [f32; 4]) {
    let leaf = LEAF.map(|c| f32::from(c) / 255.0);
    for (x, y, found) in pixels(picture) {
        let behind = if place(x, y).1 > 0.0 { wall } else { BACKDROP };
        let is_leaf = leaf_alpha(x, y) == 255;
        assert_near(
            found,
            if is_leaf { [leaf[0], leaf[1], leaf[2], 1.0] } else { behind },
            NEAR,
            (x, y),
        );
    }
}

#[test]
fn a_material_with_a_mask_is_cut_out() {
    let folder = leaf_folder();
    folder.json("leaf.json", &image_look("leaf.png", &json!({})));
    let masked = json!({
        "name": "leaf", "alphaMode": "MASK", "alphaCutoff": 0.5, "doubleSided": true,
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1]}});
    write_square(&folder, "leaf.gltf", &masked);
    let paint = [0.0, 0.25, 1.0, 1.0];
    let leaf = object("leaf.gltf", "leaf.json");
    assert_cut(&folder.draw(&json!([leaf, object("wall.obj", "paint.json")])), paint);
    assert_cut(&folder.draw(&json!([object("near_wall.obj", "paint.json"), leaf])), paint);

    // The same look on a material without a mask blends by its alpha, and the two do not share a
    // shader.
    write_square(
        &folder,
        "veil.gltf",
        &json!({"name": "leaf", "alphaMode": "OPAQUE", "doubleSided": true}),
    );
    let mut veil = object("veil.gltf", "leaf.json");
    veil["transform"]["translate"] = json!([0, 0, 0.5]);
    let both = folder.draw(&json!([leaf, veil]));
    for (x, y, found) in pixels(&both) {
        let a = f32::from(leaf_alpha(x, y)) / 255.0;
        let over = |c: usize| BACKDROP[c] + a * (f32::from(LEAF[c]) / 255.0 - BACKDROP[c]);
        assert_near(found, [over(0), over(1), over(2), 1.0], NEAR, (x, y));
    }
}

#[test]
fn an_output_with_a_cutoff_is_cut_out() {
    let folder = leaf_folder();
    write_square(&folder, "leaf.gltf", &json!({"name": "leaf", "doubleSided": true}));
    folder.json("leaf.json", &image_look("leaf.png", &json!({"cutoff": 0.5})));
    let paint = [0.0, 0.25, 1.0, 1.0];
    let leaf = object("leaf.gltf", "leaf.json");
    assert_cut(&folder.draw(&json!([leaf, object("wall.obj", "paint.json")])), paint);
    assert_cut(&folder.draw(&json!([object("near_wall.obj", "paint.json"), leaf])), paint);
}

#[test]
fn the_greater_of_both_cutoffs_counts_and_alpha_equal_to_it_is_drawn() {
    let folder = Folder::new();
    let above_half = f64::from(0.5f32.next_up());
    let mask = |cutoff: f64| {
        json!({
            "name": "leaf", "alphaMode": "MASK", "alphaCutoff": cutoff, "doubleSided": true
        })
    };
    let cases = [
        // The look's cutoff, the material's, and true if an alpha of 0.5 is drawn.
        (0.5, None, true),
        (above_half, None, false),
        (0.0, Some(0.5), true),
        (0.0, Some(above_half), false),
        (above_half, Some(0.25), false),
        (0.25, Some(above_half), false),
        (0.5, Some(0.5), true),
        (0.0, Some(0.0), true),
    ];
    for (own, material, is_drawn) in cases {
        let material = material.map_or_else(|| json!({"name": "leaf", "doubleSided": true}), mask);
        write_square(&folder, "leaf.gltf", &material);
        let mut look = flat_look([1.0, 0.5, 0.0, 0.5]);
        look["nodes"][1]["values"] = json!({"cutoff": own});
        folder.json("leaf.json", &look);
        let transparent = |scene: &mut Json| scene["backdrop"] = Json::Null;
        let picture = folder.draw_with(&json!([object("leaf.gltf", "leaf.json")]), transparent);
        for (x, y, found) in pixels(&picture) {
            assert_eq!(found[3] > 0.0, is_drawn, "{own} {material} at {x}, {y}");
            if is_drawn {
                // A mask of the material leaves nothing half transparent; a look's own cutoff
                // leaves alpha unchanged.
                let is_masked = material["alphaCutoff"].as_f64().is_some_and(|cutoff| cutoff > 0.0);
                assert_near(
                    found,
                    [1.0, 0.5, 0.0, if is_masked { 1.0 } else { 0.5 }],
                    NEAR,
                    (x, y),
                );
            }
        }
    }
}

/// The normals and curvature passes are cut, too, by an image that is not the first of the look's.
#[test]
fn what_is_seen_through_a_hole_has_its_own_curvature() {
    let folder = Folder::new();
    folder.image("tint.png", 1, |_, _| [0, 0, 255, 255]);
    // The frame has a hole of half the picture's side.
    let is_hole = |x: u32, y: u32| (2..6).contains(&x) && (2..6).contains(&y);
    folder.image("mask.png", 8, |x, y| [255, 255, 255, if is_hole(x, y) { 0 } else { 255 }]);
    write_square(
        &folder,
        "leaf.gltf",
        &json!({"name": "leaf", "alphaMode": "MASK", "alphaCutoff": 0.5, "doubleSided": true}),
    );
    let image = |id: &str| {
        let file = format!("{id}.png");
        json!({"id": id, "kind": "image", "values": {"image": file, "filter": "nearest"}})
    };
    folder.json(
        "leaf.json",
        &json!({
            "nodes": [image("tint"), image("mask"), {"id": "leaf", "kind": "set_alpha"},
                {"id": "output", "kind": "output"}],
            "wires": [
                {"from": "tint.color", "to": "leaf.color"},
                {"from": "mask.alpha", "to": "leaf.alpha"},
                {"from": "leaf", "to": "output.color"}]
        }),
    );
    folder.json(
        "bulge.json",
        &json!({
            "nodes": [{"id": "bulge", "kind": "transition"}, {"id": "output", "kind": "output"}],
            "wires": [{"from": "bulge", "to": "output.color"}]
        }),
    );
    let mut ball = object("shape:sphere", "bulge.json");
    ball["id"] = json!("ball");
    ball["transform"] = json!({"translate": [0, 0, -2]});
    let alone = folder.draw(&json!([ball]));
    let behind = folder.draw(&json!([object("leaf.gltf", "leaf.json"), ball]));
    let curved = alone.pixel(SIDE / 2, SIDE / 2)[0];
    assert!(curved > 0.53, "a ball is convex, {curved}");
    for (x, y, found) in pixels(&behind) {
        let (column, row) = texel(8, x, y);
        let inside = (2 * 8 + 3..6 * 8 - 3).contains(&x) && (2 * 8 + 3..6 * 8 - 3).contains(&y);
        if inside {
            assert_near(found, alone.pixel(x, y), NEAR, (x, y));
        } else if !is_hole(column, row) {
            assert_near(found, [0.0, 0.0, 1.0, 1.0], NEAR, (x, y));
        }
    }
}

// --- Linear light

/// Linear value of an sRGB-encoded one (IEC 61966-2-1).
fn decoded(coded: f64) -> f64 {
    if coded <= 0.04045 { coded / 12.92 } else { ((coded + 0.055) / 1.055).powf(2.4) }
}

/// sRGB-encoded value of a linear one (IEC 61966-2-1).
fn encoded(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// Each byte once, in 16 by 16 texels.
fn byte_at(x: u32, y: u32) -> u8 {
    let (column, row) = texel(16, x, y);
    (row * 16 + column) as u8
}

#[test]
fn colors_come_through_linear_light_as_they_were_and_data_does_not() {
    let folder = Folder::new();
    folder.image("bytes.png", 16, |x, y| [(y * 16 + x) as u8, 255 - (y * 16 + x) as u8, 128, 255]);
    write_square(&folder, "card.gltf", &json!({"doubleSided": true}));
    for (space, encoding) in
        [("display", "color"), ("display", "data"), ("linear", "color"), ("linear", "data")]
    {
        let mut look = image_look("bytes.png", &json!({}));
        look["color_space"] = json!(space);
        look["nodes"][0]["values"]["encoding"] = json!(encoding);
        folder.json("card.json", &look);
        for (x, y, found) in pixels(&folder.draw(&json!([object("card.gltf", "card.json")]))) {
            let byte = byte_at(x, y);
            let shown = |byte: u8| {
                let number = f64::from(byte) / 255.0;
                (if space == "linear" && encoding == "data" { encoded(number) } else { number })
                    as f32
            };
            assert_near(found, [shown(byte), shown(255 - byte), shown(128), 1.0], NEAR, (x, y));
        }
    }
}

#[test]
fn light_adds_up_in_linear_light_and_is_encoded_once() {
    let folder = Folder::new();
    folder.image("bytes.png", 16, |x, y| [(y * 16 + x) as u8, 60, 200, 255]);
    // The shape is flat with bent normals: the normal at x is (x, 0, 1), normalized.
    folder.text(
        "bent.obj",
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn -1 0 1\nvn 1 0 \
         1\n\
         f 1/1/1 2/2/2 3/3/2 4/4/1\n",
    );
    let look = |space: &str| {
        json!({
            "color_space": space,
            "lights": {
                "key": {
                    "space": "world", "direction": [1, 0, 2], "color": "#80c0ff", "intensity": 0.8
                }
            },
            "nodes": [
                {
                    "id": "image", "kind": "image",
                    "values": {"image": "bytes.png", "filter": "nearest"}
                },
                {"id": "lit", "kind": "light_layer", "values": {"light": "key", "blend": "add",
                    "convex": [1, 0.5, 0.25], "concave": [1, 0.5, 0.25]}},
                {
                    "id": "glaze", "kind": "light_layer",
                    "values": {"light": "key", "blend": "alpha", "opacity": 0.5,
                    "offset": std::f64::consts::PI, "convex": [0.25, 0.5, 0.125],
                    "concave": [0.25, 0.5, 0.125]}},
                {"id": "output", "kind": "output"}
            ],
            "wires": [
                {"from": "image.color", "to": "lit.below"}, {"from": "lit", "to": "glaze.below"},
                {"from": "glaze", "to": "output.color"}]
        })
    };
    for space in ["linear", "display"] {
        folder.json("bent.json", &look(space));
        let light = |coded: f64| if space == "linear" { decoded(coded) } else { coded };
        for (x, y, found) in pixels(&folder.draw(&json!([object("bent.obj", "bent.json")]))) {
            let normal = DVec3::new(place(x, y).0, 0.0, 1.0).normalize();
            let u = angle(normal, held(DVec3::new(1.0, 0.0, 2.0)));
            let pi = std::f64::consts::PI;
            // An intensity of a light below 1 dims the tone.
            let tone = 0.8 * profile_tone(u, 0.0, [0.0, pi / 2.0, pi / 2.0]);
            let tint = DVec3::new(128.0 / 255.0, 192.0 / 255.0, 1.0).map(light);
            let paper = DVec3::new(f64::from(byte_at(x, y)) / 255.0, 60.0 / 255.0, 200.0 / 255.0);
            let shine = DVec3::new(1.0, 0.5, 0.25);
            let base = paper.map(light).extend(1.0);
            let lit = blend(Mode::Add, base, (shine * tint).extend(1.0), tone, 1.0, true);
            let glaze = (DVec3::new(0.25, 0.5, 0.125) * tint).extend(1.0);
            let done: DVec4 = blend(Mode::Alpha, lit, glaze, 0.8, 0.5, true);
            let shown = |c: f64| (if space == "linear" { encoded(c) } else { c }) as f32;
            assert_near(found, [shown(done.x), shown(done.y), shown(done.z), 1.0], NEAR, (x, y));
        }
    }
}

#[test]
fn vertex_colors_and_backdrops_are_display_colors_in_linear_looks_too() {
    let folder = Folder::new();
    let corner = |x: f32, y: f32| format!("v {x} {y} 0 0.25 0.5 0.75\n");
    folder.text(
        "left.obj",
        &format!(
            "{}{}{}{}f 1 2 3 4\n",
            corner(-1.0, -1.0),
            corner(0.0, -1.0),
            corner(0.0, 1.0),
            corner(-1.0, 1.0)
        ),
    );
    let mut look = json!({
        "color_space": "linear",
        "nodes": [{"id": "paint", "kind": "vertex_color"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "paint", "to": "output.color"}]
    });
    for space in ["linear", "display"] {
        look["color_space"] = json!(space);
        folder.json("left.json", &look);
        for (x, y, found) in pixels(&folder.draw(&json!([object("left.obj", "left.json")]))) {
            let expected = if place(x, y).0 < 0.0 { [0.25, 0.5, 0.75, 1.0] } else { BACKDROP };
            assert_near(found, expected, NEAR, (x, y));
        }
    }
}

/// A `#rrggbb` is display-referred, however it comes into a look: a surface of nothing else shows
/// that color, in every color space.
#[test]
fn hex_colors_are_as_shown_in_every_color_space() {
    let folder = Folder::new();
    write_square(&folder, "card.gltf", &json!({"doubleSided": true}));
    let key = |hex: &str| json!({"direction": [0, 0, 1], "values": {"paint.color": hex}});
    let (orange, blue) = ("#ff8040", "#204080");
    let shown = |hex: &str| {
        let byte = |at: usize| f32::from(u8::from_str_radix(&hex[at..at + 2], 16).unwrap()) / 255.0;
        [byte(1), byte(3), byte(5), 1.0]
    };
    for space in ["linear", "display"] {
        for live in [Live::Keyed, Live::Exposed, Live::All] {
            let picture = |more: &Json, values: &Json, time: f64| {
                let mut look = flat_look([0.0; 4]);
                look["color_space"] = json!(space);
                look["nodes"][0]["values"] = json!({"color": orange});
                look.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
                folder.json("paint.json", &look);
                let mut card = object("card.gltf", "paint.json");
                card["values"] = values.clone();
                folder.draw_live(&json!([card]), |_| (), &live, time).pixel(20, 30)
            };
            let near = |found, hex: &str| assert_near(found, shown(hex), NEAR, (20, 30));
            near(picture(&json!({}), &json!({}), 0.0), orange);
            let exposed = json!({"exposed": [{"name": "ink", "target": "paint.color"}]});
            near(picture(&exposed, &json!({}), 0.0), orange);
            near(picture(&exposed, &json!({"ink": blue}), 0.0), blue);
            let by_view = json!({"direction_keys": [{"by": "view", "keys": [key(blue)]}]});
            near(picture(&by_view, &json!({}), 0.0), blue);
            let timed = json!({"time_keys": [{"target": "paint.color", "keys": [
                {"time": 0, "value": orange}, {"time": 2, "value": blue}]}]});
            near(picture(&timed, &json!({}), 0.0), orange);
            near(picture(&timed, &json!({}), 2.0), blue);
            // The value half-way lies between the two in the look's own colors.
            let half = picture(&timed, &json!({}), 1.0);
            for channel in 0..3 {
                let [a, b] = [orange, blue].map(|hex| f64::from(shown(hex)[channel]));
                let expected = if space == "linear" {
                    encoded(0.5 * (decoded(a) + decoded(b)))
                } else {
                    0.5 * (a + b)
                };
                assert!(
                    (f64::from(half[channel]) - expected).abs() < f64::from(NEAR),
                    "{half:?} {expected}"
                );
            }
        }
    }
}

// --- Mirrored objects

/// A crooked tent without symmetry, open below, with UVs; none of its edges passes through the
/// middle of a pixel.
const TENT: &str = "v -0.71 -0.53 -0.31\nv 0.62 -0.41 -0.17\nv 0.33 0.68 -0.23\nv -0.47 0.57 \
                    -0.41\nv 0.11 -0.07 0.49\n\
    vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.6 0.4\n\
    f 1/1 2/2 5/5\nf 2/2 3/3 5/5\nf 3/3 4/4 5/5\nf 4/4 1/1 5/5\n";

/// Diffuse, specular and curved light from the light `key`, over the image `paper.png`.
fn lit_look() -> Json {
    json!({
        "lights": {"key": {"space": "world", "direction": [0.5, 0.8, 1]}},
        "nodes": [
            {"id": "paper", "kind": "image", "values": {"image": "paper.png"}},
            {
                "id": "body", "kind": "light_layer",
                "values": {"light": "key", "blend": "shade", "cutoff": 2.5,
                "convex": [1, 0.8, 0.4], "concave": [0.2, 0.4, 1], "slope": 0.02, "amount": 0.3}},
            {
                "id": "gleam", "kind": "light_layer",
                "values": {"light": "key", "type": "specular", "falloff": 0.5,
                "convex": [0.4, 0.4, 0.2], "concave": [0.4, 0.4, 0.2]}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "paper.color", "to": "body.below"}, {"from": "body", "to": "gleam.below"},
            {"from": "gleam", "to": "output.color"}]
    })
}

/// A way to mirror: a scale, and its effect on the camera and on the picture.
struct Mirror {
    scale: [f64; 3],
    /// -1 if the scene is then looked at from behind, else 1.
    eye: f64,
    flips: [bool; 2],
}

const MIRRORS: [Mirror; 4] = [
    Mirror { scale: [-1.0, 1.0, 1.0], eye: 1.0, flips: [true, false] },
    Mirror { scale: [1.0, -1.0, 1.0], eye: 1.0, flips: [false, true] },
    // From behind, right and left change sides.
    Mirror { scale: [1.0, 1.0, -1.0], eye: -1.0, flips: [true, false] },
    Mirror { scale: [-1.0, -1.0, -1.0], eye: -1.0, flips: [false, true] },
];

/// The picture of `mesh` in `look`, and the picture of its mirror image under mirrored light.
fn mirrored_pair(folder: &Folder, mesh: &str, mirror: &Mirror) -> (Picture, Picture) {
    let picture = |scale: [f64; 3], eye: f64| {
        let mut object = object(mesh, "look.json");
        let moved = DVec3::new(0.053, 0.029, 0.017) * DVec3::from(scale);
        object["transform"] = json!({"fit": false, "scale": scale, "translate": moved.to_array()});
        let light = DVec3::new(0.5, 0.8, 1.0) * DVec3::from(scale);
        folder.draw_with(&json!([object]), |scene| {
            scene["camera"]["eye"] = json!([0, 0, 4 * eye as i64]);
            scene["lights"] = json!({"key": {"space": "world", "direction": light.to_array()}});
        })
    };
    (picture([1.0; 3], 1.0), picture(mirror.scale, mirror.eye))
}

#[track_caller]
fn assert_mirrored(straight: &Picture, mirrored: &Picture, flips: [bool; 2]) {
    let place = |at: u32, flip: bool| if flip { SIDE - 1 - at } else { at };
    for (x, y, found) in pixels(mirrored) {
        assert_near(found, straight.pixel(place(x, flips[0]), place(y, flips[1])), NEAR, (x, y));
    }
}

fn tent_folder(look: &Json) -> Folder {
    let folder = Folder::new();
    folder.image("paper.png", 4, |x, y| {
        [(x * 60 + 40) as u8, (y * 50 + 90) as u8, ((x * y) * 20) as u8, 255]
    });
    folder.text("tent.obj", TENT);
    folder.json("look.json", look);
    folder
}

#[test]
fn a_mirrored_object_gives_the_mirrored_picture() {
    let folder = tent_folder(&lit_look());
    for mirror in &MIRRORS {
        let (straight, mirrored) = mirrored_pair(&folder, "tent.obj", mirror);
        assert_mirrored(&straight, &mirrored, mirror.flips);
    }
    // The picture shows an object, and is not its own mirror image.
    let (straight, mirrored) = mirrored_pair(&folder, "tent.obj", &MIRRORS[0]);
    let differs = pixels(&straight).filter(|&(x, y, pixel)| pixel != mirrored.pixel(x, y)).count();
    assert!(differs > 500, "{differs}");
}

/// The tangent frame is mirrored with its object: a normal map leans the same way along u and along
/// v.
#[test]
fn normal_maps_are_mirrored_with_their_objects() {
    for color in [[0.5, 0.85, 0.8, 1.0], [0.8, 0.5, 0.85, 1.0]] {
        let mut look = lit_look();
        let nodes = look["nodes"].as_array_mut().unwrap();
        nodes.push(json!({"id": "map", "kind": "normal_map", "values": {"color": color}}));
        let wire = json!({"from": "map", "to": "body.normal"});
        look["wires"].as_array_mut().unwrap().push(wire);
        let folder = tent_folder(&look);
        for mirror in &MIRRORS {
            let (straight, mirrored) = mirrored_pair(&folder, "tent.obj", mirror);
            assert_mirrored(&straight, &mirrored, mirror.flips);
        }
    }
}

/// A square with one visible side is drawn from the front and not from behind, mirrored or not.
#[test]
fn one_sided_fronts_stay_fronts() {
    let folder = Folder::new();
    write_square(&folder, "card.gltf", &json!({"doubleSided": false}));
    folder.json("paint.json", &flat_look([1.0, 0.0, 0.5, 1.0]));
    for mirrored in [false, true] {
        for turned in [false, true] {
            let mut card = object("card.gltf", "paint.json");
            card["transform"]["scale"] =
                if mirrored { json!([-1, 1, 1]) } else { json!([1, 1, 1]) };
            if turned {
                card["transform"]["rotate"] =
                    json!({"axis": [0, 1, 0], "angle": std::f64::consts::PI});
            }
            let expected = if turned { BACKDROP } else { [1.0, 0.0, 0.5, 1.0] };
            for (x, y, found) in pixels(&folder.draw(&json!([card]))) {
                assert_near(found, expected, NEAR, (x, y));
            }
        }
    }
    // A mirror along the axis of sight turns the front away.
    let mut card = object("card.gltf", "paint.json");
    card["transform"]["scale"] = json!([1, 1, -1]);
    assert_eq!(folder.draw(&json!([card])).pixel(9, 9), BACKDROP);
}

/// A mirror within a glTF's own nodes acts like one in the scene.
#[test]
fn a_mirror_inside_a_file_is_as_one_in_the_scene() {
    let folder = tent_folder(&lit_look());
    write_square(&folder, "card.gltf", &json!({"doubleSided": false}));
    let text = fs::read_to_string(folder.path().join("card.gltf")).unwrap();
    let mut inner: Json = serde_json::from_str(&text).unwrap();
    inner["nodes"][0]["scale"] = json!([-1, 0.5, 1]);
    folder.json("mirrored.gltf", &inner);
    let mut card = object("card.gltf", "look.json");
    card["transform"]["scale"] = json!([-1, 0.5, 1]);
    let by_scene = folder.draw(&json!([card]));
    let by_file = folder.draw(&json!([object("mirrored.gltf", "look.json")]));
    assert_mirrored(&by_scene, &by_file, [false, false]);
    assert!(
        by_file.pixel(SIDE / 2, SIDE / 2) != BACKDROP && by_file.pixel(SIDE / 2, 2) == BACKDROP
    );
}

/// Smallest difference that cannot come from the arithmetic of the GPU and the reference alone.
const APART: f32 = 1.5 / 255.0;

#[track_caller]
fn assert_alike(pictures: &[Picture; 3], what: &str) {
    let [baked, edited, truth] = pictures;
    for (x, y, expected) in pixels(truth) {
        for (found, which) in [(baked, "baked"), (edited, "edited")] {
            let found = found.pixel(x, y);
            let far = found.iter().zip(expected).any(|(a, b)| (a - b).abs() > APART || a.is_nan());
            assert!(!far, "{what}, {which}: {found:?} is not {expected:?} at {:?}", (x, y));
        }
    }
}

fn shaded_look(light: &Json) -> Json {
    json!({
        "lights": {"key": light},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.2, 0.1, 0.3, 1]}},
            {
                "id": "body", "kind": "light_layer",
                "values": {"light": "key", "falloff": 1.2, "cutoff": 2.4,
                "convex": [1, 0.8, 0.4], "concave": [1, 0.8, 0.4]}},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "base.below", "to": "body.below"}, {"from": "body", "to": "output.color"}
        ]
    })
}

fn shape_object(shape: &str) -> Json {
    json!({"id": "shape", "mesh": shape, "looks": "look.json", "transform": {"fit": false}})
}

/// Every ray from an eye so near to a sphere, or within it, meets the sphere's surface: the far
/// plane of such an eye's view is the horizon, beyond the corners of the picture. So no backdrop
/// may be seen, neither where the near plane of a scene of that size would cut a hole, nor through
/// that hole.
#[test]
fn a_surface_right_before_the_eye_is_whole_and_the_same_everywhere() {
    let folder = Folder::new();
    folder.json("look.json", &shaded_look(&json!({"space": "world", "direction": [0.5, 0.8, 1]})));
    let fov: f64 = 0.6;
    for eye in [1.01, 1.002, 1.001, 1.0003, 1.0001, 0.9999, 0.999] {
        let corner = (0.5 * fov).tan();
        for x in [-corner, 0.0, corner] {
            let ray = DVec3::new(x, corner, -1.0).normalize();
            // The discriminant of |eye + t ray| = 1 is positive, and the nearest hit is before the
            // eye, if the eye is outside.
            let (half_b, c) = (ray.z * eye, eye * eye - 1.0);
            assert!(half_b * half_b > c && (c < 0.0 || -half_b > 0.0), "a ray misses the sphere");
        }
        let pictures = folder.draw_everywhere(&json!({
            "objects": [shape_object("shape:sphere")], "backdrop": [0.0, 0.0, 1.0, 1.0],
            "camera": {"eye": [0, 0, eye], "target": [0, 0, 0], "fov": fov}
        }));
        for (x, y, found) in pictures.iter().flat_map(pixels) {
            assert!(found[2] < 0.9, "the backdrop is seen at {:?} from {eye}", (x, y));
        }
        assert_alike(&pictures, &format!("from {eye}"));
    }
}

/// A surface with an alpha cutoff of 0, which cuts nothing, has one side if its file says so,
/// whether the value is folded or not.
#[test]
fn a_cutoff_of_nothing_shows_no_other_side() {
    let folder = Folder::new();
    write_square(&folder, "card.gltf", &json!({"doubleSided": false}));
    let mut look = flat_look([1.0, 0.0, 0.5, 1.0]);
    for (cutoff, is_seen) in [(0.0, false), (0.25, true)] {
        look["nodes"][1]["values"] = json!({"cutoff": cutoff});
        folder.json("paint.json", &look);
        let mut card = object("card.gltf", "paint.json");
        card["transform"]["rotate"] = json!({"axis": [0, 1, 0], "angle": std::f64::consts::PI});
        let pictures = folder.draw_everywhere(&json!({
            "objects": [card], "backdrop": BACKDROP,
            "camera": {"projection": "orthographic", "height": 2}
        }));
        let expected = if is_seen { [1.0, 0.0, 0.5, 1.0] } else { BACKDROP };
        for (x, y, found) in pictures.iter().flat_map(pixels) {
            assert_near(found, expected, NEAR, (x, y));
        }
    }
}

/// A distance beyond f32's range is not the same as none: to a GPU it would mean a light that never
/// fades.
#[test]
fn distances_of_lights_that_no_f32_holds_mean_the_same_everywhere() {
    let folder = Folder::new();
    let picture = |half_distance: f64, range: f64, intensity: f64| {
        folder.json(
            "look.json",
            &shaded_look(&json!({
                "type": "point", "space": "world", "position": [1, 1, 3], "intensity": intensity,
                "half_distance": half_distance, "range": range
            })),
        );
        let pictures = folder.draw_everywhere(&json!({
            "objects": [shape_object("shape:torus")], "backdrop": BACKDROP,
            "camera": {"projection": "orthographic", "height": 2}
        }));
        assert_alike(&pictures, &format!("{half_distance}, {range}"));
        pictures
    };
    let [dark, ..] = picture(0.0, 0.0, 0.0);
    for tiny in [1e-300, 5e-324, 1e-40, 1.2e-38, 1e-20] {
        for pictures in [picture(tiny, 0.0, 1.0), picture(0.0, tiny, 1.0)] {
            for (x, y, found) in pictures.iter().flat_map(pixels) {
                assert_near(found, dark.pixel(x, y), APART, (x, y));
            }
        }
    }
    let [lit, ..] = picture(0.0, 0.0, 1.0);
    assert!(lit != dark, "without a distance the light is seen");
    picture(2.0, 5.0, 1.0);
}
