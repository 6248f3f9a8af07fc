//! Many objects of few looks, against few objects of as many triangles in the same places.

use std::sync::Arc;

use chiaro::clock::Clock;
use chiaro::compile::Live;
use chiaro::document::{Look, Transform, Values};
use chiaro::frame::{PlanOptions, Planner, Setup, SetupLook, SetupObject, object_matrix};
use chiaro::geometry::{Mesh, MeshPart, shape};
use chiaro::library::Library;
use chiaro::render::Renderer;
use chiaro_test_drawing::wait::block_on;
use glam::{DMat4, DQuat, DVec3, Vec3};
use serde_json::json;

/// Number of objects along the picture's width and height.
const GRID: [usize; 2] = [40, 25];
/// Number of looks that the objects wear in turns.
const LOOKS: usize = 10;
/// Frames before the first that counts.
const WARM_UP: usize = 2;

/// Times of one frame, in milliseconds.
#[derive(Clone, Copy, Default)]
struct FrameTimes {
    /// Time on the clock of planning.
    planning: f64,
    /// Time on the clock until the frame is handed to the driver.
    recording: f64,
    /// Time on the clock from there until the picture is drawn.
    drawing: f64,
    /// Time on the clock of all.
    wall: f64,
    /// CPU time of all, of all threads.
    processor: f64,
}

impl FrameTimes {
    fn numbers(self) -> [f64; 5] {
        [self.planning, self.recording, self.drawing, self.wall, self.processor]
    }
}

/// CPU time of this process's threads so far, in milliseconds; NaN where the system does not tell.
fn processor_time() -> f64 {
    let Ok(tasks) = std::fs::read_dir("/proc/self/task") else { return f64::NAN };
    let of_task = |task: std::fs::DirEntry| -> Option<f64> {
        let text = std::fs::read_to_string(task.path().join("schedstat")).ok()?;
        text.split(' ').next()?.parse().ok()
    };
    tasks.flatten().filter_map(of_task).sum::<f64>() * 1e-6
}

/// A look of four layers in a color of its own.
fn look(number: usize) -> SetupLook {
    let shade = number as f64 / LOOKS as f64;
    let layer = |id: &str, offset: f64| {
        json!({"id": id, "kind": "light_layer", "values": {
            "light": "key", "slope": 0.2, "offset": offset, "falloff": offset + 0.5,
            "cutoff": offset + 1.0,
            "convex": [shade, 0.4, 0.6], "concave": [0.2, shade, 0.1], "blend": "add"}})
    };
    let text = json!({"name": format!("look {number}"), "lights": {"key": {"direction": [1, 2, 3]}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.1, 0.15]}},
            layer("one", 0.0), layer("two", 0.2), layer("three", 0.4), layer("four", 0.6),
            {"id": "output", "kind": "output"}],
        "wires": [{"from": "base", "to": "one.below"}, {"from": "one", "to": "two.below"},
            {"from": "two", "to": "three.below"}, {"from": "three", "to": "four.below"},
            {"from": "four", "to": "output.color"}]});
    let loaded = Look::read(&text.to_string(), "bench.json");
    let problems: Vec<String> = loaded.diagnostics.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    SetupLook {
        look: loaded.value.expect("a look"),
        source: loaded.source.into(),
        folder: "".into(),
    }
}

/// Matrices of objects that stand side by side in a grid that fills the picture.
fn places() -> Vec<DMat4> {
    let [columns, rows] = GRID;
    let step = 2.6 / columns as f64;
    let place = |index: usize| {
        let at = DVec3::new((index % columns) as f64, (index / columns) as f64, 0.0);
        let middle = 0.5 * DVec3::new(columns as f64 - 1.0, rows as f64 - 1.0, 0.0);
        DMat4::from_translation(step * (at - middle)) * DMat4::from_scale(DVec3::splat(0.48 * step))
    };
    (0..columns * rows).map(place).collect()
}

/// One mesh of copies of `mesh` in several places.
fn joined(mesh: &Mesh, places: &[DMat4]) -> Mesh {
    let mut all = Mesh { name: "joined".to_owned(), ..Mesh::default() };
    for place in places {
        let first = all.positions.len() as u32;
        let moved = |position: &[f32; 3]| {
            place.transform_point3(Vec3::from(*position).as_dvec3()).as_vec3().to_array()
        };
        all.positions.extend(mesh.positions.iter().map(moved));
        all.normals.extend(&mesh.normals);
        all.tangents.extend(&mesh.tangents);
        all.uvs.extend(&mesh.uvs);
        all.colors.extend(&mesh.colors);
        all.indices.extend(mesh.indices.iter().map(|index| index + first));
    }
    let indices = 0..all.indices.len() as u32;
    all.parts = vec![MeshPart { indices, ..mesh.parts[0].clone() }];
    Mesh { has_uvs: mesh.has_uvs, has_colors: mesh.has_colors, has_normals: true, ..all }
}

fn object(number: usize, mesh: &Arc<Mesh>, look: usize, matrix: DMat4) -> SetupObject {
    SetupObject {
        id: format!("object{number}").as_str().into(),
        mesh: mesh.clone(),
        world_from_object: matrix,
        looks: vec![Some(look)],
        values: Values::new(),
        light_link: Default::default(),
        shadow_link: Default::default(),
        layers: Default::default(),
        animation: None,
    }
}

/// The same spheres as a thousand objects with ten looks, as ten objects with ten looks, and as one
/// object with one look.
fn scenes() -> [(&'static str, Setup); 3] {
    let ball = Arc::new(shape("ball").expect("a shape"));
    let fit = object_matrix(&Transform::default(), &ball);
    let places: Vec<DMat4> = places().into_iter().map(|place| place * fit).collect();
    let many = places.iter().enumerate();
    let many = many.map(|(number, place)| object(number, &ball, number % LOOKS, *place)).collect();
    let of_look = |look: usize| {
        let places: Vec<DMat4> = places.iter().copied().skip(look).step_by(LOOKS).collect();
        object(look, &Arc::new(joined(&ball, &places)), look, DMat4::IDENTITY)
    };
    let ten = (0..LOOKS).map(of_look).collect();
    let one = vec![object(0, &Arc::new(joined(&ball, &places)), 0, DMat4::IDENTITY)];
    let setup = |looks: usize, objects: Vec<SetupObject>| Setup {
        looks: (0..looks).map(look).collect(),
        objects,
        ..Setup::default()
    };
    [
        ("1,000 objects, 10 looks", setup(LOOKS, many)),
        ("10 objects, 10 looks", setup(LOOKS, ten)),
        ("1 object, 1 look", setup(1, one)),
    ]
}

/// Plans and draws one frame.
fn frame(
    renderer: &mut Renderer,
    planner: &mut Planner,
    setup: &Setup,
    options: &PlanOptions,
) -> FrameTimes {
    let (clock, begin) = (Clock::start(), processor_time());
    let planned = planner.plan(setup, Library::built_in(), &Live::Keyed, options);
    let plan = planned.unwrap_or_else(|problems| panic!("{problems:?}")).value;
    let planned = clock.seconds();
    block_on(renderer.draw(&plan)).expect("it draws");
    let recorded = clock.seconds();
    let device = &renderer.gpu().device;
    device.poll(wgpu::PollType::wait_indefinitely()).expect("a device that answers");
    let wall = clock.seconds();
    let [planning, recording, drawing, wall] =
        [planned, recorded - planned, wall - recorded, wall].map(|seconds| 1e3 * seconds);
    FrameTimes { planning, recording, drawing, wall, processor: processor_time() - begin }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Prints the times of all scenes, in turns, under a camera that turns from frame to frame.
pub(crate) fn run(renderer: &mut Renderer, size: [u32; 2], rounds: usize) {
    let [width, height] = size;
    println!("\n400,000 triangles in the same places, {width}x{height}, ms a frame (medians)");
    let mut scenes = scenes();
    let mut planners: Vec<Planner> = scenes.iter().map(|_| Planner::default()).collect();
    let mut times: Vec<Vec<FrameTimes>> = vec![Vec::new(); scenes.len()];
    let mut first = vec![FrameTimes::default(); scenes.len()];
    let options = PlanOptions { size, samples: 1, time: 0.0 };
    for round in 0..WARM_UP + rounds {
        for turn in 0..scenes.len() {
            let index = if round % 2 == 0 { turn } else { scenes.len() - 1 - turn };
            let setup = &mut scenes[index].1;
            let turned = DQuat::from_rotation_y(1e-3 * round as f64);
            setup.scene.camera.eye = (turned * DVec3::new(0.0, 0.0, 4.0)).to_array();
            setup.scene.camera.target = [0.0; 3];
            let time = frame(renderer, &mut planners[index], setup, &options);
            match round {
                0 => first[index] = time,
                1 => {}
                _ => times[index].push(time),
            }
        }
    }
    println!("\n| scene | planning | recording | drawing | frame | frame, CPU | first frame |");
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: |");
    let medians: Vec<[f64; 5]> = times
        .iter()
        .map(|times| {
            [0, 1, 2, 3, 4].map(|i| median(times.iter().map(|t| t.numbers()[i]).collect()))
        })
        .collect();
    for (((name, _), numbers), first) in scenes.iter().zip(&medians).zip(&first) {
        let cells = numbers.map(|number| format!("{number:.1}")).join(" | ");
        println!("| {name} | {cells} | {:.0} |", first.wall);
    }
    let ratio = |a: usize, b: usize| {
        let of = |part: usize| {
            let pairs = times[a].iter().zip(&times[b]);
            median(pairs.map(|(a, b)| a.numbers()[part] / b.numbers()[part]).collect())
        };
        format!("{:.2} on the clock, {:.2} in CPU time", of(3), of(4))
    };
    println!("\n1,000 objects to one: {}", ratio(0, 2));
    println!("1,000 objects to ten: {}", ratio(0, 1));
}
