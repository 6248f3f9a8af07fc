//! Values that vary, found by their names among lights, objects, exposed parameters and nodes.

use indexmap::IndexSet;

use super::values;
use crate::diag::Diagnostic;
use crate::document::{
    ColorSpace, Light, LightField, LightQuantity, Look, Target, Value, parse_hex, srgb_to_linear,
};
use crate::frame::Setup;
use crate::ids::{LightId, NodeId, NodePath, PortName};
use crate::library::Library;

/// Places that have a value of one name: all are set together.
pub(super) struct VariedTarget {
    name: String,
    places: Vec<Place>,
}

/// A place that has a value.
enum Place {
    /// A field of a light of the scene.
    SceneLight { light: LightId, field: LightField },
    /// A field of a light of a look, by the look's index.
    LookLight { look: usize, light: LightId, field: LightField },
    /// A parameter that an object sets, by the object's index.
    Object { object: usize, name: PortName },
    /// An input of a node of a look's own graph.
    Input { look: usize, node: NodeId, port: PortName },
    /// A field of the scene, by the address that shots have for it.
    Scene { address: String },
}

/// Parts of a scene whose fields vary by their addresses. Lights and objects have names of their
/// own.
const SCENE_PARTS: [&str; 5] = ["light_groups", "camera", "outlines", "backdrop", "illumination"];

impl VariedTarget {
    /// Finds what a name stands for: a field of the scene before a light's before an object's
    /// parameter before a node's input.
    ///
    /// # Errors
    /// `unknown-target` with the nearest names.
    pub(super) fn find(name: &str, setup: &Setup, library: &Library) -> Result<Self, Diagnostic> {
        if SCENE_PARTS.contains(&name.split('.').next().unwrap_or_default()) {
            setup.scene.value_at(name)?;
            let places = vec![Place::Scene { address: name.to_owned() }];
            return Ok(Self { name: name.to_owned(), places });
        }
        // As shots have it: `objects.hero.values.width` is `hero.width`.
        let of_object = name.strip_prefix("objects.").and_then(|rest| rest.split_once(".values."));
        let short = of_object.map(|(object, value)| format!("{object}.{value}"));
        let places = match short.as_deref().unwrap_or(name).rsplit_once('.') {
            None => exposed(setup, None, name),
            Some((owner, part)) => {
                let light = owner.strip_prefix("lights.").unwrap_or(owner);
                let mut places = lights(setup, light, part);
                if places.is_empty() {
                    places = exposed(setup, Some(owner), part);
                }
                if places.is_empty() {
                    places = inputs(setup, library, owner, part)?;
                }
                places
            }
        };
        if !places.is_empty() {
            return Ok(Self { name: name.to_owned(), places });
        }
        let known = known(setup, library);
        let problem = Diagnostic::error("unknown-target", format!("there is no `{name}` to vary"));
        let problem = problem.suggest(name, known.iter().map(String::as_str));
        Err(if problem.hints.is_empty() {
            problem.hint("a light's field is key.intensity, a node's input lit.offset")
        } else {
            problem
        })
    }

    /// Checks that all places take these values.
    ///
    /// # Errors
    /// `wrong-value` with what a place takes; of a field of the scene, the field's own problem.
    pub(super) fn check_all(&self, all: &[Value], setup: &Setup) -> Result<(), Diagnostic> {
        let wrong = |value: &Value, wanted: &str| {
            let message = format!("`{}` cannot be {}", self.name, values::text(value));
            Diagnostic::error("wrong-value", message).hint(format!("write {wanted}"))
        };
        for place in &self.places {
            let field = match place {
                Place::SceneLight { field, .. } | Place::LookLight { field, .. } => field,
                Place::Scene { address } => {
                    let mut scene = setup.scene.clone();
                    all.iter().try_for_each(|value| scene.set_value(address, value))?;
                    continue;
                }
                Place::Object { .. } | Place::Input { .. } => continue,
            };
            for value in all {
                let numbers = numbers(*field, value, ColorSpace::Display);
                let Some(numbers) = numbers else {
                    return Err(wrong(value, wanted(*field)));
                };
                if let (Some([least, greatest]), [number]) = (field.range(), numbers.as_slice())
                    && !(least..=greatest).contains(number)
                {
                    return Err(wrong(value, &format!("a number from {least} to {greatest}")));
                }
            }
        }
        Ok(())
    }

    /// Sets all places, and takes out the keys, of looks, scenes and shots, that would say
    /// otherwise.
    pub(super) fn set(&self, setup: &mut Setup, value: &Value) {
        for place in &self.places {
            match place {
                Place::SceneLight { light, field } => {
                    let is_it = |target: &Target| is_field(target, light, *field);
                    setup.scene.time_keys.retain(|keys| !is_it(&keys.target));
                    if let Some(found) = setup.scene.lights.get_mut(light) {
                        set_field(found, *field, value, ColorSpace::Display);
                    }
                }
                Place::LookLight { look, light, field } => {
                    let look = &mut setup.looks[*look].look;
                    let is_it = |target: &Target| is_field(target, light, *field);
                    look.time_keys.retain(|keys| !is_it(&keys.target));
                    let space = look.color_space;
                    if let Some(found) = look.lights.get_mut(light) {
                        set_field(found, *field, value, space);
                    }
                }
                Place::Object { object, name } => {
                    let object = &mut setup.objects[*object];
                    object.values.insert(name.clone(), value.clone());
                    // What the scene says is what an object that a shot moves takes again.
                    if let Some(own) = setup.scene.objects.get_mut(&object.id) {
                        own.values.insert(name.clone(), value.clone());
                    }
                    let address = format!("objects.{}.values.{name}", object.id);
                    setup.hold(&address);
                }
                Place::Scene { address } => {
                    setup.hold(address);
                    // `check_all` has tried the value.
                    let _ = setup.scene.set_value(address, value);
                }
                Place::Input { look, node, port } => {
                    let look = &mut setup.looks[*look].look;
                    let path = NodePath::root(node.clone());
                    let keyed = Target::Input { node: path, port: port.clone() };
                    look.time_keys.retain(|keys| keys.target != keyed);
                    if let Some(node) = look.graph.nodes.get_mut(node) {
                        node.values.insert(port.clone(), value.clone());
                    }
                }
            }
        }
    }
}

fn is_field(target: &Target, light: &LightId, field: LightField) -> bool {
    let Target::Light { light: id, field: name } = target else { return false };
    id == light && name == field.name()
}

fn set_field(light: &mut Light, field: LightField, value: &Value, space: ColorSpace) {
    if let Some(numbers) = numbers(field, value, space) {
        field.set(light, &numbers);
    }
}

/// The numbers of a field; a color as text is one as shown. `None` for a value of another type.
fn numbers(field: LightField, value: &Value, space: ColorSpace) -> Option<Vec<f64>> {
    let count = field.numbers(&Light::default()).len();
    let numbers = match value {
        Value::Number(number) => vec![*number],
        Value::Vector(numbers) => numbers.clone(),
        Value::Text(text) if field.quantity() == LightQuantity::Color => {
            let channel = |x: f64| if space == ColorSpace::Linear { srgb_to_linear(x) } else { x };
            parse_hex(text)?[..3].iter().map(|x| channel(*x)).collect()
        }
        _ => return None,
    };
    (numbers.len() == count).then_some(numbers)
}

/// Value that a field takes, for people.
fn wanted(field: LightField) -> &'static str {
    match field.quantity() {
        LightQuantity::Direction | LightQuantity::Position => "three numbers: [0,1,0.5]",
        LightQuantity::Color => "a color: #8af, or [1,0.5,0]",
        LightQuantity::Factor | LightQuantity::Distance => "a number",
        LightQuantity::Angle => "a number, in radians",
    }
}

/// A field of a light of the scene, or else of the looks.
fn lights(setup: &Setup, id: &str, field: &str) -> Vec<Place> {
    let Some(field) = LightField::named(field) else { return Vec::new() };
    let light = LightId::from(id);
    if setup.scene.lights.contains_key(&light) {
        return vec![Place::SceneLight { light, field }];
    }
    let looks = setup.looks.iter().enumerate();
    let with = looks.filter(|(_, worn)| worn.look.lights.contains_key(&light));
    with.map(|(look, _)| Place::LookLight { look, light: light.clone(), field }).collect()
}

/// A parameter of one object, or of all that have it.
fn exposed(setup: &Setup, owner: Option<&str>, name: &str) -> Vec<Place> {
    let objects = setup.objects.iter().enumerate();
    let owned = objects.filter(|(_, object)| owner.is_none_or(|id| object.id.as_str() == id));
    let has_it = |look: &Look| look.exposed.iter().any(|exposed| exposed.name.as_str() == name);
    let with =
        owned.filter(|(_, object)| object.worn_looks().any(|look| has_it(&setup.looks[look].look)));
    with.map(|(object, _)| Place::Object { object, name: PortName::from(name) }).collect()
}

/// An input of a node, of all looks that have the node.
fn inputs(
    setup: &Setup,
    library: &Library,
    node: &str,
    port: &str,
) -> Result<Vec<Place>, Diagnostic> {
    let (id, port) = (NodeId::from(node), PortName::from(port));
    let mut places = Vec::new();
    for (look, worn) in setup.looks.iter().enumerate() {
        let graph = &worn.look.graph;
        if !ports(&worn.look, library, &id).contains(&port) {
            continue;
        }
        if let Some(wire) = graph.wire_into(&id, &port) {
            let message = format!("`{node}.{port}` is wired, and has no value to vary");
            let hint = format!("vary what feeds it, `{}`, or take the wire out", wire.from);
            return Err(Diagnostic::error("wired-target", message).hint(hint));
        }
        places.push(Place::Input { look, node: id.clone(), port: port.clone() });
    }
    Ok(places)
}

/// The inputs of a node of a look's own graph.
fn ports(look: &Look, library: &Library, id: &NodeId) -> Vec<PortName> {
    let Some(node) = look.graph.nodes.get(id) else { return Vec::new() };
    let mut names: IndexSet<PortName> = node.values.keys().cloned().collect();
    if let Some(found) = library.nodes.get(&node.kind) {
        names.extend(found.inputs.iter().map(|input| input.name.clone()));
    } else if let Some(found) = library.groups.get(&node.kind) {
        names.extend(found.ports(library).inputs.into_iter().map(|input| input.name));
    }
    let own = look.definitions.iter().find(|(id, _)| id.as_str() == node.kind);
    names.extend(own.iter().flat_map(|(_, own)| own.inputs.iter().map(|port| port.name.clone())));
    names.into_iter().collect()
}

/// All names that could be varied, for suggestions.
fn known(setup: &Setup, library: &Library) -> Vec<String> {
    let mut known: IndexSet<String> = IndexSet::new();
    let of_looks = setup.looks.iter().flat_map(|worn| &worn.look.lights);
    for (id, light) in setup.scene.lights.iter().chain(of_looks) {
        known.extend(LightField::of(light.kind).map(|field| format!("{id}.{}", field.name())));
    }
    for id in setup.scene.light_groups.keys() {
        known.extend(
            ["intensity", "exposure", "tint"].map(|part| format!("light_groups.{id}.{part}")),
        );
    }
    for object in &setup.objects {
        for look in object.worn_looks() {
            for exposed in &setup.looks[look].look.exposed {
                known.insert(exposed.name.to_string());
                known.insert(format!("{}.{}", object.id, exposed.name));
            }
        }
    }
    for worn in &setup.looks {
        for id in worn.look.graph.nodes.keys() {
            let ports = ports(&worn.look, library, id);
            let free = ports.iter().filter(|port| worn.look.graph.wire_into(id, port).is_none());
            known.extend(free.map(|port| format!("{id}.{port}")));
        }
    }
    known.into_iter().collect()
}
