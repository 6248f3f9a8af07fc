//! Variations of a value, of a color, of a direction, of a choice or of a mesh: what the cells of a
//! sheet stand for.

use std::f64::consts::FRAC_PI_2;
use std::path::Path;

use glam::{DQuat, DVec3};
use indexmap::IndexSet;

use crate::catalog::{Port, values};
use crate::document::{ColorSpace, LightField, SceneEdit, Target, Value};
use crate::examples;
use crate::files::{Files, WalkBounds};
use crate::frame::SHAPE_PREFIX;
use crate::geometry::SHAPES;
use crate::ids::ObjectId;
use crate::library::Type;
use crate::state::hue::around;
use crate::state::keying::Owner;
use crate::state::reading::LookWithLibrary;
use crate::state::scene::{OpenScene, folder_of, mesh_label};

/// Numbers of cells that a sheet of a number may have.
pub(crate) const STEPS: std::ops::RangeInclusive<usize> = 2..=25;
/// Cells along a side of a sheet of colors or directions.
const SIDE: usize = 3;
/// Bounds of the search for meshes in a folder.
const BESIDE: WalkBounds = WalkBounds { depth: 0, entries: 2000 };
/// Most meshes of one folder that a sheet has, and the largest size of their files, in bytes: each
/// is read for its picture.
const MOST_BESIDE: usize = 24;
const LARGEST_BESIDE: u64 = 32 << 20;

/// Subject of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum VariedSubject {
    /// Value of the look, or of a light of the scene around it.
    Value(Owner, Target),
    /// Mesh that the look is on, outside of scenes.
    Mesh,
    /// Mesh of an object of the scene.
    ObjectMesh(ObjectId),
}

/// Variation that a cell stands for.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Variation {
    Value(Value),
    /// Mesh by its name in documents: a built-in shape, a file or an example.
    Mesh(String),
}

/// Kind of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum VariationKind {
    /// Numbers from one to another.
    Number {
        is_whole: bool,
    },
    /// Colors around one: hue across, brightness down.
    Color,
    /// Directions around one: to the sides across, up and down.
    Direction,
    /// Words of a choice, or both states of a switch.
    Choice,
    Mesh,
}

impl VariationKind {
    /// Kind of a sheet of a target; `None` where it cannot be varied.
    pub(crate) fn of(target: &Target, port: &Port) -> Option<Self> {
        let is_direction = target.light_field() == Some(LightField::Direction);
        match port.ty {
            _ if !port.options.is_empty() => Some(Self::Choice),
            Type::Float | Type::Angle => Some(Self::Number { is_whole: false }),
            Type::Int => Some(Self::Number { is_whole: true }),
            Type::Bool => Some(Self::Choice),
            Type::Color => Some(Self::Color),
            Type::Vec3 if is_direction => Some(Self::Direction),
            _ => None,
        }
    }
}

/// Sheet of variations.
#[derive(Clone, Debug)]
pub(crate) struct VariationSheet {
    pub(crate) subject: VariedSubject,
    pub(crate) kind: VariationKind,
    /// The value that the others are around.
    center: Value,
    port: Option<Port>,
    /// Meshes of a sheet of meshes.
    meshes: Vec<String>,
    /// The first number and the last one.
    pub(crate) range: [f64; 2],
    /// Number of cells of a sheet of numbers.
    pub(crate) steps: usize,
    /// Distance of colors and directions from the one in the middle, 0 to 1.
    pub(crate) spread: f64,
}

impl PartialEq for VariationSheet {
    fn eq(&self, other: &Self) -> bool {
        // The port is the subject's.
        let of = |sheet: &Self| (sheet.kind, sheet.range, sheet.steps, sheet.spread);
        of(self) == of(other)
            && (&self.subject, &self.center, &self.meshes)
                == (&other.subject, &other.center, &other.meshes)
    }
}

impl VariationSheet {
    /// Sheet around the present value of a target; `None` where it cannot be varied. The look is
    /// that of the target's keys.
    pub(crate) fn of_value(
        (owner, target): (Owner, Target),
        look: LookWithLibrary<'_>,
        now: Option<Value>,
    ) -> Option<Self> {
        let port = look.port_at(&target)?;
        let kind = VariationKind::of(&target, &port)?;
        let space = look.look.color_space;
        let now = now.or_else(|| values::current(&port, None).cloned());
        let center = match (kind, now) {
            (VariationKind::Color, Some(now)) => color_value(now.color_in(space)?),
            (VariationKind::Color, None) => color_value([1.0; 4]),
            (VariationKind::Direction, now) => {
                Value::Vector(now.map_or(vec![0.0, 0.0, 1.0], |now| values::vector(Some(&now), 3)))
            }
            (VariationKind::Number { .. }, now) => Value::Number(values::number(now.as_ref())),
            (_, now) => now.unwrap_or(Value::Bool(false)),
        };
        let range = first_range(values::number(Some(&center)), &port);
        let sheet = Self::with_meshes(VariedSubject::Value(owner, target), Vec::new());
        Some(Self { kind, center, range, port: Some(port), ..sheet })
    }

    /// Sheet of all shapes, for a look outside of scenes.
    pub(crate) fn of_shapes() -> Self {
        Self::with_meshes(VariedSubject::Mesh, shapes().collect())
    }

    /// Sheet of the meshes that an object of a scene could have, each once: its own, those of other
    /// objects, files beside its own and beside the scene, examples, and all shapes. Files of
    /// meshes have one of the `endings`.
    pub(crate) fn of_object(
        open_scene: &OpenScene,
        id: ObjectId,
        files: &dyn Files,
        endings: &[&str],
    ) -> Option<Self> {
        let objects = &open_scene.scene().objects;
        let own = &objects.get(&id)?.mesh;
        let of_others = objects.values().map(|other| &other.mesh);
        let is_mesh = |path: &Path| {
            let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
            endings.iter().any(|known| known.eq_ignore_ascii_case(ending))
        };
        let beside = |file: &Path| {
            let found = files.walk(&folder_of(file), BESIDE, &|_| false).files.into_iter();
            let is_light = |path: &Path| {
                files.metadata(path).is_some_and(|file| file.length <= LARGEST_BESIDE)
            };
            let meshes = found.filter(|path| is_mesh(path) && is_light(path)).take(MOST_BESIDE);
            meshes.map(|path| open_scene.name_of(&path)).collect::<Vec<_>>()
        };
        let is_file = !own.starts_with(SHAPE_PREFIX);
        let own_file = is_file.then(|| open_scene.path_of(own));
        let in_folders = own_file.iter().map(|file| beside(file));
        let in_folders = in_folders.chain(open_scene.path().map(beside)).flatten();
        // Meshes of films are made for their scenes.
        let of_examples = examples::names().filter(|name| name.starts_with("meshes/"));
        let of_examples = of_examples.filter(|name| is_mesh(Path::new(name)));
        let of_examples = of_examples.map(|name| format!("{}{name}", examples::PREFIX));
        let named = std::iter::once(own).chain(of_others).cloned();
        let all: IndexSet<String> =
            named.chain(in_folders).chain(of_examples).chain(shapes()).collect();
        Some(Self::with_meshes(VariedSubject::ObjectMesh(id), all.into_iter().collect()))
    }

    fn with_meshes(subject: VariedSubject, meshes: Vec<String>) -> Self {
        Self {
            subject,
            kind: VariationKind::Mesh,
            center: Value::Bool(false),
            port: None,
            meshes,
            range: [0.0, 1.0],
            steps: SIDE * SIDE,
            spread: 0.3,
        }
    }

    /// Edit of the scene that gives the object of this sheet the mesh of a cell; `None` for other
    /// sheets, and where the object is gone.
    pub(crate) fn edit_of(
        &self,
        open_scene: &OpenScene,
        variation: &Variation,
    ) -> Option<SceneEdit> {
        let (VariedSubject::ObjectMesh(id), Variation::Mesh(mesh)) = (&self.subject, variation)
        else {
            return None;
        };
        open_scene.change(id, |object| object.mesh.clone_from(mesh))
    }

    /// True if the numbers are angles in radians.
    pub(crate) fn is_angle(&self) -> bool {
        self.port.as_ref().is_some_and(|port| port.unit == "rad")
    }

    /// Least and greatest number that may be set.
    pub(crate) fn bounds(&self) -> [f64; 2] {
        let port = self.port.as_ref();
        let least = port.and_then(|port| port.min).unwrap_or(f64::from(f32::MIN));
        [least, port.and_then(|port| port.max).unwrap_or(f64::from(f32::MAX))]
    }

    /// Words on a variation.
    pub(crate) fn label(&self, variation: &Variation) -> String {
        match variation {
            Variation::Mesh(name) => mesh_label(name),
            Variation::Value(value) => match (self.kind, value.color_in(ColorSpace::Display)) {
                (VariationKind::Color, Some(color)) => values::hex(color),
                _ => self.port.as_ref().map(|port| values::short(port, value)).unwrap_or_default(),
            },
        }
    }

    /// The variations, in the order of the cells.
    pub(crate) fn cells(&self) -> Vec<Variation> {
        let mut cells: Vec<Variation> = match self.kind {
            VariationKind::Mesh => self.meshes.iter().cloned().map(Variation::Mesh).collect(),
            VariationKind::Choice => self.choices().into_iter().map(Variation::Value).collect(),
            VariationKind::Number { is_whole } => {
                let count = self.steps.clamp(*STEPS.start(), *STEPS.end());
                let [from, to] = self.range;
                let at = |step: usize| from + (to - from) * step as f64 / (count - 1) as f64;
                let number = |step| if is_whole { at(step).round() } else { rounded(at(step)) };
                (0..count).map(|step| Variation::Value(Value::Number(number(step)))).collect()
            }
            VariationKind::Color => self.around_each(color_around),
            VariationKind::Direction => self.around_each(direction_around),
        };
        cells.dedup();
        cells
    }

    fn choices(&self) -> Vec<Value> {
        let words = self.port.iter().flat_map(|port| &port.options);
        let words: Vec<Value> = words.map(|(word, _)| Value::Text(word.clone())).collect();
        if words.is_empty() { vec![Value::Bool(false), Value::Bool(true)] } else { words }
    }

    /// A grid of variations around the one in the middle.
    fn around_each(&self, make: impl Fn(&Value, [f64; 2], f64) -> Value) -> Vec<Variation> {
        let cell = |index: usize| {
            let across = (index % SIDE) as f64 - 1.0;
            let down = (index / SIDE) as f64 - 1.0;
            match (across, down) {
                (0.0, 0.0) => self.center.clone(),
                _ => make(&self.center, [across, -down], self.spread),
            }
        };
        (0..SIDE * SIDE).map(|index| Variation::Value(cell(index))).collect()
    }

    /// The sheet around one of its cells, with finer steps.
    pub(crate) fn again_around(&mut self, variation: &Variation) {
        let Variation::Value(value) = variation else { return };
        if let VariationKind::Number { is_whole } = self.kind {
            let [from, to] = self.range;
            let step = ((to - from).abs() / (self.steps.max(2) - 1) as f64).max(1e-9);
            let step = if is_whole { step.max(1.0) } else { step };
            let (number, [least, most]) = (values::number(Some(value)), self.bounds());
            let range = [number - step, number + step];
            self.range = range.map(|number| number.clamp(least, most));
        }
        self.center = value.clone();
        self.spread = (0.5 * self.spread).max(0.01);
    }
}

/// Names of all built-in shapes.
fn shapes() -> impl Iterator<Item = String> {
    SHAPES.iter().map(|shape| format!("{SHAPE_PREFIX}{}", shape.name))
}

/// Range of a number's first sheet: all that it may be, or around it where that is unbounded.
fn first_range(now: f64, port: &Port) -> [f64; 2] {
    if let (Some(least), Some(most)) = (port.min, port.max)
        && (most - least).is_finite()
        && most - least < 1e4
    {
        return [least, most];
    }
    let reach = if now == 0.0 { 1.0 } else { now.abs() };
    let [least, most] = [port.min.unwrap_or(f64::MIN), port.max.unwrap_or(f64::MAX)];
    [(now - reach).max(least), (now + reach).min(most)]
}

/// A number that reads well in a file.
fn rounded(number: f64) -> f64 {
    let digits = 4.0 - number.abs().max(1e-9).log10().ceil();
    let factor = 10.0_f64.powf(digits.clamp(-6.0, 12.0));
    (number * factor).round() / factor
}

fn color_value([r, g, b, a]: [f64; 4]) -> Value {
    Value::Vector(if a == 1.0 { vec![r, g, b] } else { vec![r, g, b, a] })
}

/// A color with another hue, and another brightness, each by a part of `spread`; alpha stays.
fn color_around(center: &Value, offset: [f64; 2], spread: f64) -> Value {
    let numbers = values::vector(Some(center), 4);
    let [r, g, b] = around([numbers[0], numbers[1], numbers[2]], offset, spread).map(rounded);
    let alpha = match center {
        Value::Vector(numbers) if numbers.len() > 3 => numbers[3],
        _ => 1.0,
    };
    color_value([r, g, b, alpha])
}

/// A direction turned to a side and up, by parts of a right angle.
fn direction_around(center: &Value, [across, up]: [f64; 2], spread: f64) -> Value {
    let toward = DVec3::from_slice(&values::vector(Some(center), 3));
    let toward = toward.try_normalize().unwrap_or(DVec3::Z);
    let side = DVec3::Y.cross(toward).try_normalize().unwrap_or(DVec3::X);
    let angle = FRAC_PI_2 * spread;
    let turned = DQuat::from_axis_angle(DVec3::Y, across * angle)
        * DQuat::from_axis_angle(side, -up * angle)
        * toward;
    Value::Vector(turned.to_array().map(rounded).to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;
    use crate::document::{Look, Scene};
    use crate::files::MemoryFiles;
    use crate::library::Library;
    use crate::state::revision::StepTime;

    fn sheet(target: &str) -> Option<VariationSheet> {
        let text = r#"{"lights": {"key": {"direction": [0, 0, 1]}}, "nodes": [
            {"id": "layer", "kind": "light_layer", "values": {"convex": [0.8, 0.4, 0.2]}},
            {"id": "blend", "kind": "blend"}]}"#;
        let look = Look::read(text, "test").value.unwrap();
        let library = Library::built_in();
        let mut catalog = Catalog::new(library);
        catalog.sync(&look, library);
        let look = LookWithLibrary { look: &look, catalog: &catalog, library };
        let target = Target::parse(target).unwrap();
        let now = look.own_value(&target);
        VariationSheet::of_value((Owner::Look, target), look, now)
    }

    fn numbers(sheet: &VariationSheet) -> Vec<f64> {
        let number = |cell: &Variation| match cell {
            Variation::Value(Value::Number(number)) => *number,
            other => panic!("{other:?}"),
        };
        sheet.cells().iter().map(number).collect()
    }

    #[test]
    fn numbers_go_from_one_to_another_and_finer_around_one() {
        let mut sheet = sheet("layer.opacity").unwrap();
        sheet.steps = 5;
        assert_eq!(numbers(&sheet), [0.0, 0.25, 0.5, 0.75, 1.0]);
        sheet.again_around(&Variation::Value(Value::Number(1.0)));
        assert_eq!((sheet.range, numbers(&sheet).len()), ([0.75, 1.0], 5));
        sheet.range = [1.0, 1.0];
        assert_eq!(numbers(&sheet), [1.0], "equal cells are one");
        sheet.steps = 1000;
        sheet.range = [0.0, 1.0];
        assert_eq!(numbers(&sheet).len(), 25);
    }

    #[test]
    fn colors_and_directions_lie_around_the_present_one() {
        let colors = sheet("layer.convex").unwrap();
        let cells = colors.cells();
        assert_eq!((cells.len(), &cells[4]), (9, &Variation::Value(colors.center.clone())));
        let of = |cell: &Variation| match cell {
            Variation::Value(value) => values::vector(Some(value), 3),
            Variation::Mesh(_) => panic!(),
        };
        assert!(cells.iter().flat_map(of).all(|channel| (0.0..=1.0).contains(&channel)));
        assert!(of(&cells[1])[1] > of(&cells[4])[1] && of(&cells[7])[1] < of(&cells[4])[1]);
        assert!(of(&cells[3])[0] > of(&cells[3])[2], "the hue turns a little");
        let lights = sheet("lights.key.direction").unwrap();
        let cells = lights.cells();
        assert!(of(&cells[1])[1] > 0.3 && of(&cells[3])[0] < -0.3 && of(&cells[5])[0] > 0.3);
        let length = |cell: &Variation| DVec3::from_slice(&of(cell)).length();
        assert!(cells.iter().all(|cell| (length(cell) - 1.0).abs() < 1e-3));
    }

    #[test]
    fn choices_are_all_and_what_is_no_value_has_none() {
        let blend = sheet("blend.mode").unwrap();
        assert!(blend.cells().len() > 4 && !blend.label(&blend.cells()[0]).is_empty());
        assert!(sheet("blend.nothing").is_none() && sheet("layer.below").is_none());
    }

    #[test]
    fn an_object_of_a_scene_tries_meshes_and_takes_one_as_one_step() {
        let text = r#"{"chiaro": "scene", "objects": [
            {"id": "hero", "mesh": "meshes/hero.glb", "looks": "look:open"},
            {"id": "prop", "mesh": "shape:torus", "looks": "look:open"},
            {"id": "twin", "mesh": "shape:torus", "looks": "look:open"}]}"#;
        let mut files = MemoryFiles::default();
        for path in ["meshes/hero.glb", "meshes/other.OBJ", "meshes/skin.png", "meshes/in/far.ply"]
        {
            files.add(Path::new("/film").join(path), "");
        }
        files.add("/film/stage.stl", "");
        let path = Path::new("/film/scene.json");
        let mut open_scene = OpenScene::opened(path, Scene::read(text, "")).ok().unwrap();
        let names = |open_scene: &OpenScene, id: &str, endings: &[&str]| -> Vec<String> {
            let sheet = VariationSheet::of_object(open_scene, id.into(), &files, endings);
            let name = |cell: Variation| match cell {
                Variation::Mesh(name) => name,
                Variation::Value(value) => panic!("{value:?}"),
            };
            sheet.expect("the object is there").cells().into_iter().map(name).collect()
        };
        let prop = names(&open_scene, "prop", &[]);
        assert_eq!(prop[..2], ["shape:torus", "meshes/hero.glb"]);
        assert_eq!(prop.len(), SHAPES.len() + 1, "each once");
        let hero = names(&open_scene, "hero", &["glb", "obj", "stl"]);
        let wanted = ["meshes/hero.glb", "shape:torus", "meshes/other.OBJ", "stage.stl"];
        assert_eq!(hero[..4], wanted);
        assert!(hero[4].starts_with(examples::PREFIX) && hero.len() > SHAPES.len() + 3);

        let sheet =
            VariationSheet::of_object(&open_scene, "hero".into(), &files, &["stl"]).unwrap();
        let before = open_scene.scene().clone();
        let edit = sheet.edit_of(&open_scene, &Variation::Mesh("stage.stl".to_owned())).unwrap();
        assert!(open_scene.apply(edit, None, StepTime(1)).unwrap());
        assert_eq!(open_scene.scene().objects["hero"].mesh, "stage.stl");
        assert!(open_scene.undo());
        assert_eq!(*open_scene.scene(), before);
        assert!(VariationSheet::of_object(&open_scene, "gone".into(), &files, &[]).is_none());
    }
}
