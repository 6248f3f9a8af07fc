//! Numbers of a look's uniform block while nothing is set: what the shader has before its script
//! runs.

use chiaro_locale::tr;
use serde_json::{Map, Value, json};

use super::super::{PackageRequest, PackageScene, javascript};
use super::script::own_light;
use crate::diag::Diagnostic;
use crate::document::Projection;
use crate::interp::{
    self, FunctionOptions, Literals, Precision, Program, Scalar, ScalarKind, Shape,
};
use crate::wgsl;
use glam::{DMat3, DVec3};

/// The numbers of the picture's block before the camera of the package's scene.
///
/// # Errors
/// Host work that does not run.
pub(in crate::export::package) fn numbers(
    request: &PackageRequest<'_>,
) -> Result<Vec<f64>, Diagnostic> {
    let work = request.work;
    let Some(module) = work.modules.iter().find(|it| it.module == "draw") else {
        return Ok(Vec::new());
    };
    let problem = |error: String| Diagnostic::error("host-code", error);
    let valid = wgsl::parse(&work.wgsl).map_err(|error| problem(error.to_string()))?;
    let literals = Literals::of(&work.wgsl);
    let program = |function: &str| {
        let options = FunctionOptions { literals: Some(&literals), ..FunctionOptions::default() };
        Program::compile(&valid.module, function, options)
    };
    let around = surroundings(request.scene);
    let run = |function: &str, settings: Option<interp::Value>| {
        let program = program(function)?;
        let [first, second] = program.parameters() else {
            return Err(problem(tr!("`{function}` takes other values")));
        };
        let settings = match settings {
            Some(settings) => settings,
            None => typed(&first.shape, &settings_of(request)),
        };
        program.call(&[settings, typed(&second.shape, &around)], Precision::F64)
    };
    let keyed = if work.is_keyed { Some(run("keyed", None)?) } else { None };
    let result = run(&module.function, keyed)?;
    let mut numbers = Vec::new();
    for part in result.parts().into_iter().flatten() {
        numbers.push(part.as_f64().unwrap_or_default());
    }
    Ok(numbers)
}

fn settings_of(request: &PackageRequest<'_>) -> Value {
    let mut members = Map::new();
    for setting in &request.work.parameters {
        members.insert(setting.member.clone(), javascript::value(&setting.default));
    }
    for light in &request.work.lights {
        let mut own = own_light(&light.light);
        own.insert("shadow_map".to_owned(), json!([0.0, 0.0, 1.0, -1.0]));
        members.insert(light.member.clone(), Value::Object(own));
    }
    Value::Object(members)
}

/// The rotation from the world to camera axes, and the eye.
pub(super) fn camera_axes(scene: &PackageScene) -> (DMat3, DVec3) {
    let camera = &scene.camera;
    let (eye, target) = (DVec3::from(camera.eye), DVec3::from(camera.target));
    let back = (eye - target).normalize_or(DVec3::Z);
    let right = DVec3::from(camera.up).cross(back).normalize_or(DVec3::X);
    (DMat3::from_cols(right, back.cross(right), back), eye)
}

fn surroundings(scene: &PackageScene) -> Value {
    let (world_from_camera, eye) = camera_axes(scene);
    let columns = |m: DMat3| json!(m.to_cols_array_2d());
    let is_parallel = scene.camera.projection == Projection::Orthographic;
    let middle = scene.world_from_object.transform_point3(scene.mesh.bounds().center());
    let (_, turn, _) = scene.world_from_object.to_scale_rotation_translation();
    json!({
        "illumination": columns(DMat3::IDENTITY),
        "camera_from_world": columns(world_from_camera.transpose()),
        "eye": eye.to_array(),
        "parallel": if is_parallel { world_from_camera.z_axis } else { DVec3::ZERO }.to_array(),
        "object_axes": columns(DMat3::from_quat(turn)),
        "object_middle": middle.to_array(),
        "object_id": 0.0,
        "viewport": [800.0, 800.0],
        "time": 0.0,
        "frame": 0.0,
    })
}

/// JSON as a value of a shape; what is missing is 0, and another object is far away.
fn typed(shape: &Shape, given: &Value) -> interp::Value {
    let number = |given: &Value| {
        given.as_f64().or_else(|| given.as_bool().map(f64::from)).unwrap_or_default()
    };
    let scalar = |kind: ScalarKind, given: &Value| match kind {
        ScalarKind::Bool => Scalar::Bool(number(given) != 0.0),
        ScalarKind::I32 => Scalar::I32(number(given) as i32),
        ScalarKind::U32 => Scalar::U32(number(given) as u32),
        ScalarKind::Float => Scalar::Float(number(given)),
    };
    match shape {
        Shape::Scalar(kind) => match scalar(*kind, given) {
            Scalar::Bool(x) => interp::Value::Bool(x),
            Scalar::I32(x) => interp::Value::I32(x),
            Scalar::U32(x) => interp::Value::U32(x),
            Scalar::Float(x) => interp::Value::Float(x),
        },
        Shape::Vector { kind, size } => {
            interp::Value::Vector((0..*size).map(|at| scalar(*kind, &given[at])).collect())
        }
        Shape::Matrix { columns, rows } => {
            let places = (0..*columns).flat_map(|column| (0..*rows).map(move |row| (column, row)));
            let components = places.map(|(column, row)| number(&given[column][row])).collect();
            interp::Value::Matrix { columns: *columns, components }
        }
        Shape::Array { element, count } => {
            interp::Value::Array((0..*count).map(|at| typed(element, &given[at])).collect())
        }
        Shape::Struct { members, .. } => {
            let far = json!(1e6);
            let member = |(name, shape): &(String, Shape)| match given.get(name) {
                Some(given) => typed(shape, given),
                None if name.starts_with("near") => typed(shape, &far),
                None => typed(shape, &Value::Null),
            };
            interp::Value::Struct(members.iter().map(member).collect())
        }
    }
}
