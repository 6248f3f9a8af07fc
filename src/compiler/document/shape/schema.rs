//! JSON Schemas (draft 2020-12) of the documents, made from the descriptions of their fields.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::{
    F32, FAR, FieldDefault, FieldKind, LINE, LONG, MAX_NUMBERS, NumberBounds, ObjectShape,
    ShapeField,
};
use crate::document::described::DescribedObject as _;
use crate::document::read::AxisAngle;
use crate::document::{Curve, HcbtfManifest, Look, Ramp, Scene, Shot};

const SLUG: &str = "^[A-Za-z_][A-Za-z0-9_-]{0,63}$";
const INPUT: &str = r"^[A-Za-z_][A-Za-z0-9_-]{0,63}\.[A-Za-z_][A-Za-z0-9_-]{0,63}$";
const OUTPUT: &str = r"^[A-Za-z_][A-Za-z0-9_-]{0,63}(\.[A-Za-z_][A-Za-z0-9_-]{0,63})?$";
const OUTPUT_IN_GROUPS: &str = concat!(
    r"^[A-Za-z_][A-Za-z0-9_-]{0,63}(/[A-Za-z_][A-Za-z0-9_-]{0,63})*",
    r"(\.[A-Za-z_][A-Za-z0-9_-]{0,63})?$"
);
const RATE: &str = r"^[0-9.]+(/[0-9]+)?$";
const TARGET: &str = concat!(
    r"^(lights\.[A-Za-z_][A-Za-z0-9_-]{0,63}\.[a-z_]+",
    r"|[A-Za-z_][A-Za-z0-9_/-]*\.[A-Za-z_][A-Za-z0-9_-]{0,63})$"
);

/// JSON Schema of looks, as `docs/look.schema.json` has it.
pub fn look_schema() -> Value {
    schema(Look::shape())
}

/// JSON Schema of scenes, as `docs/scene.schema.json` has it.
pub fn scene_schema() -> Value {
    schema(Scene::shape())
}

/// JSON Schema of shots, as `docs/shot.schema.json` has it.
pub fn shot_schema() -> Value {
    schema(Shot::shape())
}

/// JSON Schema of the manifests of HCBTFs, as `docs/hcbtf.schema.json` has it.
pub fn hcbtf_schema() -> Value {
    schema(HcbtfManifest::shape())
}

fn schema(shape: &'static ObjectShape) -> Value {
    let mut definitions = BTreeMap::new();
    let top = object(shape, &mut definitions);
    let mut schema = Map::new();
    schema.insert("$schema".into(), "https://json-schema.org/draft/2020-12/schema".into());
    schema.insert("title".into(), format!("Chiaro {}", shape.name).into());
    schema.extend(top);
    schema.insert("$defs".into(), definitions.into_iter().collect());
    Value::Object(schema)
}

/// Definitions that a schema refers to, by name.
type Definitions = BTreeMap<String, Value>;

fn object(shape: &'static ObjectShape, definitions: &mut Definitions) -> Map<String, Value> {
    let mut properties = Map::new();
    for field in shape.fields() {
        let mut property = kind(&field.kind, definitions);
        if let Some(property) = property.as_object_mut() {
            property.insert("description".into(), field.help.into());
            if let FieldDefault::Json(default) = field.default {
                let default = serde_json::from_str(&default()).unwrap_or(Value::Null);
                property.insert("default".into(), default);
            }
        }
        properties.insert(field.name.into(), property);
    }
    let is_required = |field: &&'static ShapeField| matches!(field.default, FieldDefault::Required);
    let required: Vec<&str> = shape.fields().filter(is_required).map(|field| field.name).collect();
    let mut object = Map::new();
    object.insert("description".into(), shape.help.into());
    object.insert("type".into(), "object".into());
    object.insert("properties".into(), properties.into());
    if !required.is_empty() {
        object.insert("required".into(), required.into());
    }
    object
}

/// Reference to a definition, which is made where it does not exist yet.
fn refer(
    name: &str,
    definitions: &mut Definitions,
    make: impl FnOnce(&mut Definitions) -> Value,
) -> Value {
    let name = name.replace(' ', "_");
    if !definitions.contains_key(&name) {
        // The name is taken before the definition is made, so that the definition may refer to
        // itself.
        definitions.insert(name.clone(), Value::Null);
        let made = make(definitions);
        definitions.insert(name.clone(), made);
    }
    json!({ "$ref": format!("#/$defs/{name}") })
}

fn kind(of: &FieldKind, definitions: &mut Definitions) -> Value {
    match of {
        FieldKind::Bool => json!({ "type": "boolean" }),
        FieldKind::Number(bounds) => number(bounds),
        FieldKind::Numbers(least, most, bounds) => numbers(*least, *most, bounds),
        FieldKind::Direction => refer("direction", definitions, |_| {
            let mut direction = numbers(3, 3, &FAR);
            direction["not"] = json!({ "items": { "const": 0 } });
            direction
        }),
        FieldKind::Color { alpha } => {
            let name = if *alpha { "color with alpha" } else { "color" };
            refer(name, definitions, |_| color(*alpha))
        }
        FieldKind::Backdrop => {
            let mut choices = color(true);
            if let Some(choices) = choices["anyOf"].as_array_mut() {
                choices.extend([json!({ "const": "none" }), json!({ "type": "null" })]);
            }
            choices
        }
        FieldKind::Rotation => refer("rotation", definitions, rotation),
        FieldKind::Text(most) => json!({ "type": "string", "maxLength": most }),
        FieldKind::Slug => json!({ "type": "string", "pattern": SLUG }),
        FieldKind::LightSet | FieldKind::ObjectSet => {
            json!({ "type": "string", "maxLength": LINE })
        }
        FieldKind::Word(words) => choice(words),
        FieldKind::Output => json!({ "type": "string", "pattern": OUTPUT }),
        FieldKind::OutputInGroups => json!({ "type": "string", "pattern": OUTPUT_IN_GROUPS }),
        FieldKind::Input => json!({ "type": "string", "pattern": INPUT }),
        FieldKind::Target => json!({ "type": "string", "pattern": TARGET }),
        FieldKind::KeyDirection => json!({ "anyOf": [
            { "const": "view" },
            {
                "type": "object",
                "properties": { "light": { "type": "string", "pattern": SLUG } },
                "required": ["light"],
                "additionalProperties": false
            },
            {
                "type": "object",
                "properties": {
                    "drivers": { "type": "array", "minItems": 1, "maxItems": 3, "items": driver() }
                },
                "required": ["drivers"],
                "additionalProperties": false
            }
        ] }),
        FieldKind::Rate => json!({ "anyOf": [
            { "type": "number", "exclusiveMinimum": 0, "maximum": 1_000_000 },
            { "type": "string", "pattern": RATE }
        ] }),
        FieldKind::Value => refer("value", definitions, value),
        FieldKind::Looks => {
            json!({ "anyOf": [path(), { "type": "object", "additionalProperties": path() }] })
        }
        FieldKind::Object(shape) => {
            let shape = shape();
            refer(shape.name, definitions, |definitions| object(shape, definitions).into())
        }
        FieldKind::Choice(choice) => {
            let choice = choice();
            refer(choice.name, definitions, |definitions| {
                let objects = choice.objects.iter();
                let objects: Vec<Value> =
                    objects.map(|shape| kind(&FieldKind::Object(*shape), definitions)).collect();
                json!({ "description": choice.help.trim(), "anyOf": objects })
            })
        }
        FieldKind::Pair(item) => json!({
            "type": "array", "items": kind(item, definitions), "minItems": 2, "maxItems": 2
        }),
        FieldKind::List(item, most) => {
            json!({ "type": "array", "items": kind(item, definitions), "maxItems": most })
        }
        FieldKind::Map(item, most) => json!({
            "type": "object",
            "propertyNames": { "pattern": SLUG },
            "additionalProperties": kind(item, definitions),
            "maxProperties": most
        }),
        FieldKind::TargetValues => json!({
            "type": "object",
            "propertyNames": { "pattern": TARGET },
            "additionalProperties": kind(&FieldKind::Value, definitions),
            "maxProperties": 10_000
        }),
    }
}

fn path() -> Value {
    json!({ "type": "string", "maxLength": 4096 })
}

fn number(bounds: &NumberBounds) -> Value {
    let least = if bounds.above { "exclusiveMinimum" } else { "minimum" };
    let what = if bounds.whole { "integer" } else { "number" };
    json!({ "type": what, least: plain(bounds.min), "maximum": plain(bounds.max) })
}

/// JSON number without a needless point.
fn plain(number: f64) -> Value {
    if number.fract() == 0.0 && number.abs() < 1e15 {
        (number as i64).into()
    } else {
        number.into()
    }
}

fn numbers(least: usize, most: usize, bounds: &NumberBounds) -> Value {
    json!({ "type": "array", "items": number(bounds), "minItems": least, "maxItems": most })
}

fn choice(words: &[(&str, &str)]) -> Value {
    let words: Vec<Value> =
        words.iter().map(|(word, help)| json!({ "const": word, "description": help })).collect();
    json!({ "anyOf": words })
}

fn color(alpha: bool) -> Value {
    let pattern = match alpha {
        true => "^#([0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}([0-9a-fA-F]{2})?)$",
        false => "^#([0-9a-fA-F]{3}){1,2}$",
    };
    json!({ "anyOf": [
        numbers(3, if alpha { 4 } else { 3 }, &FAR),
        { "type": "string", "pattern": pattern }
    ] })
}

fn rotation(definitions: &mut Definitions) -> Value {
    json!({ "anyOf": [
        numbers(4, 4, &FAR),
        { "type": "array", "items": numbers(3, 3, &FAR), "minItems": 3, "maxItems": 3 },
        kind(&FieldKind::Object(AxisAngle::shape), definitions)
    ] })
}

/// Schema of the values that [`Reader`](crate::document::read) takes.
fn value(definitions: &mut Definitions) -> Value {
    json!({ "anyOf": [
        { "type": "boolean" },
        number(&F32),
        numbers(1, MAX_NUMBERS, &F32),
        { "type": "string", "maxLength": LONG },
        kind(&FieldKind::Object(Curve::shape), definitions),
        kind(&FieldKind::Object(Ramp::shape), definitions)
    ] })
}

/// Schema of a number that decides between keys.
fn driver() -> Value {
    let named = |kind: &str| {
        json!({
            "type": "object",
            "properties": { kind: { "type": "string", "pattern": SLUG } },
            "required": [kind],
            "additionalProperties": false
        })
    };
    let wire = json!({
        "type": "object",
        "properties": { "wire": { "type": "string", "pattern": OUTPUT_IN_GROUPS } },
        "required": ["wire"],
        "additionalProperties": false
    });
    json!({
        "anyOf": [
            { "const": "distance" }, { "const": "facing" }, named("height"), named("near"), wire
        ]
    })
}
