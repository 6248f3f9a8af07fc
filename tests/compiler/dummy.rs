//! A field of a light that is one row and the WGSL that uses it.

use chiaro_compiler::compile::{Options, compile};
use chiaro_compiler::document::{
    Interpolation, LightField, LightKind, Look, Target, TimeKey, TimeKeys, Unknown, Value,
    look_schema,
};
use chiaro_compiler::library::Library;

use crate::support;

#[test]
fn a_row_reaches_files_schema_keys_and_shaders() {
    let softness = LightField::named("softness").unwrap();
    assert!(softness.is_of(LightKind::Spot) && !softness.is_of(LightKind::Point));
    assert_eq!((softness.label(), softness.range()), ("Softness", Some([0.0, 1.0])));
    assert!(look_schema()["$defs"]["light"]["properties"]["softness"]["maximum"] == 1);
    let path = support::root().join("examples/looks/figure2-diffuse.json");
    let mut look = Look::load(&support::chiaro_files::Disk, &path).value.unwrap();
    for light in look.lights.values_mut() {
        light.kind = LightKind::Spot;
        softness.set(light, &[0.5]);
    }
    let light = look.lights.keys().next().unwrap().clone();
    let target = Target::Light { light, field: "softness".to_owned() };
    let key = |time, value| TimeKey {
        time,
        value: Value::Number(value),
        interpolation: Interpolation::Linear,
        unknown: Unknown::new(),
    };
    let keys = vec![key(0.0, 0.0), key(1.0, 1.0)];
    look.time_keys.push(TimeKeys { target, keys, unknown: Unknown::new() });
    let text = look.to_text();
    assert!(text.contains("\"softness\": 0.5") && text.contains(".softness\""), "{text}");
    let read = Look::read(&text, "look.json");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    assert_eq!(read.value.as_ref(), Some(&look));
    let wrong = Look::read(&text.replace("\"softness\": 0.5", "\"softness\": 2"), "look.json");
    assert_eq!(wrong.diagnostics[0].code, "out-of-range");
    let near = Look::read(&text.replace("\"softness\"", "\"softnes\""), "look.json");
    assert!(near.diagnostics[0].to_string().contains("softness"), "{:?}", near.diagnostics);
    let shader = compile(&look, Library::built_in(), &Options::default()).unwrap();
    assert!(shader.wgsl.contains("softness"), "{}", shader.wgsl);
}
