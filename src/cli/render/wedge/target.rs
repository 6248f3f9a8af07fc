//! Values that vary, found by their names among lights, objects, exposed parameters and nodes.

use indexmap::IndexSet;

use super::inputs::inputs;
use super::values;
use crate::compile::check;
use crate::diag::Diagnostic;
use crate::document::{
    ColorSpace, Light, LightField, LightQuantity, Look, Target, Value, parse_hex, srgb_to_linear,
};
use crate::frame::Setup;
use crate::ids::{DefinitionId, LightId, NodePath, PortName};
use crate::library::Library;

/// Uses of a group that a note names.
const NAMED_USES: usize = 3;

/// Places that have a value of one name: all are set together.
pub(super) struct VariedTarget {
    name: String,
    places: Vec<Place>,
}

/// A place that has a value.
pub(super) enum Place {
    /// A field of a light of the scene.
    SceneLight { light: LightId, field: LightField },
    /// A field of a light of a look, by the look's index.
    LookLight { look: usize, light: LightId, field: LightField },
    /// A parameter that an object sets, by the object's index.
    Object { object: usize, name: PortName },
    /// An input of a node of a look, by the look's index; within a group, of that use of it.
    Input { look: usize, node: NodePath, port: PortName },
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

    /// The note that a value within a group, which is used several times, varies in one use alone.
    pub(super) fn note(&self, setup: &Setup) -> Option<Diagnostic> {
        let others = |place: &Place| {
            let Place::Input { look, node, .. } = place else { return None };
            let (look, group) = (&setup.looks[*look].look, node.parent()?);
            let definition = DefinitionId::from(look.find(&group)?.node.kind.as_str());
            let others = look.uses_of(&definition).into_iter().filter(|path| *path != group);
            let others: Vec<String> = others.map(|path| format!("`{path}`")).collect();
            (!others.is_empty()).then_some((group, others))
        };
        let (group, others) = self.places.iter().find_map(others)?;
        let more = if others.len() > NAMED_USES { ", ..." } else { "" };
        let named = others[..others.len().min(NAMED_USES)].join(", ");
        let message = format!("`{}` varies in `{group}` alone", self.name);
        Some(Diagnostic::note("one-use", message).hint(format!(
            "the group is used by {named}{more} too; make the value an input of the group, wired \
             or exposed, to vary it in all"
        )))
    }

    /// Sets all places, and takes out the keys, of looks, scenes and shots, that would say
    /// otherwise.
    pub(super) fn set(&self, setup: &mut Setup, library: &Library, value: &Value) {
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
                    unkey(look, |target| is_field(target, light, *field));
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
                    let keyed = Target::Input { node: node.clone(), port: port.clone() };
                    unkey(look, |target| *target == keyed);
                    if let Some(node) = library.node_of_one_use(look, node) {
                        node.values.insert(port.clone(), value.clone());
                    }
                }
            }
        }
    }
}

/// Takes out the keys of a look that would move a value.
fn unkey(look: &mut Look, is_it: impl Fn(&Target) -> bool) {
    look.time_keys.retain(|keys| !is_it(&keys.target));
    for key in look.direction_keys.iter_mut().flat_map(|set| &mut set.keys) {
        key.values.retain(|target, _| !is_it(target));
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
        // A look with problems is told of by what draws it.
        let typed = check(&worn.look, library, None);
        let params = typed.iter().flat_map(|typed| typed.value.params.iter());
        known.extend(params.map(|param| format!("{}.{}", param.path, param.port)));
    }
    known.into_iter().collect()
}
