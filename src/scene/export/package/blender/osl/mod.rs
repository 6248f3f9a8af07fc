//! The look as a shader of the Open Shading Language, for Cycles.
//!
//! The look's WGSL and its host work become one module ([`source`]) that `host_code` writes as OSL.
//! The shader around takes the exposed parameters and the fields of lights ([`parameters`]), fills
//! the settings, and emits the color that the look has at the point. Renderers fold what their
//! parameters decide, so the host work costs nothing there.

mod images;
mod parameters;
mod source;

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::super::{PackageRequest, refusal};
use crate::compile::write_line;
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use crate::export::header;
use crate::export::host_code::{OSL, translate, with_osl_preamble};
use images::ShaderImage;
use parameters::Parameters;
use source::{PICTURE, Source, VIEWER};

/// Parameters and outputs of every shader.
const OUTPUTS: &str = r#"    point middle = point(0.0)
        [[ string label = "Middle", string help = "Middle of what wears the look." ]],
    float radius = 1.0
        [[ string label = "Radius", string help = "Its radius, which looks take for 1." ]],
    output closure color BSDF = 0,
    output color Color = 0,
    output float Alpha = 1.0)
{
"#;

/// Statements for the axes of the camera.
const CAMERA: &str = r#"    // Cycles looks along z; the look's cameras look along -z.
    vector right = to_y_up(transform("camera", "world", vector(1.0, 0.0, 0.0)));
    vector up = to_y_up(transform("camera", "world", vector(0.0, 1.0, 0.0)));
    vector toward = to_y_up(transform("camera", "world", vector(0.0, 0.0, -1.0)));
    Matrix3 camera_from_world = Matrix3(
        vector(right[0], up[0], toward[0]),
        vector(right[1], up[1], toward[1]),
        vector(right[2], up[2], toward[2]));
"#;

/// Statements for the axes of the object.
const OBJECT: &str = r#"    Matrix3 object_axes = Matrix3(
        to_y_up(normalize(transform("object", "world", vector(1.0, 0.0, 0.0)))),
        to_y_up(normalize(transform("object", "world", vector(0.0, 0.0, 1.0)))),
        to_y_up(normalize(transform("object", "world", vector(0.0, -1.0, 0.0)))));
"#;

/// Statements for the view. Renderers do not agree on the direction of `I`.
const BACK: &str = "    \
    // The way back along the ray: parallel cameras and mirrors see the look too.
    vector back = to_y_up(dot(I, Ng) < 0.0 ? -I : I);
    View viewer = View(vector4(back[0], back[1], back[2], 0.0));
";

/// A look's shader.
#[derive(Clone, Debug)]
pub(super) struct OslShader {
    /// The file's text.
    pub(super) text: String,
    /// Facts of the shader for the add-on: names of parameters.
    pub(super) about: Value,
}

/// Names that the shader takes for itself.
const OWN_NAMES: &[&str] = &[
    "BSDF",
    "Color",
    "Alpha",
    "UV",
    "middle",
    "radius",
    "seconds",
    "frame",
    "settings",
    "around",
    "look",
    "viewer",
    "seen",
    "picture",
    "back",
    "same",
    "right",
    "up",
    "toward",
    "camera_from_world",
    "object_axes",
];

impl OslShader {
    /// The shader of a look.
    ///
    /// # Errors
    /// `not-in-package`: what a shader of OSL cannot do, with the reason, for the README.
    pub(super) fn of(request: &PackageRequest<'_>) -> Result<Self, Diagnostic> {
        request.refuse_passes(|pass| {
            format!(
                "the look draws passes before the picture (the first is `{pass}`), which a shader \
                 of OSL has no place for"
            )
        })?;
        let module = request.modules.modules.iter().find(|module| module.is_draw());
        let module = module.ok_or_else(|| refusal("the look has no picture", "add an output"))?;
        let images = ShaderImage::all(request, module)?;
        let source = Source::of(request, module, &images)?;
        let roots: Vec<&str> = source.roots.iter().map(String::as_str).collect();
        let functions = translate(&source.wgsl, &roots, &OSL)
            .map_err(|problem| refusal(problem.message, "render with the add-on's own `render`"))?;
        let functions = images.iter().fold(functions, |text, image| image.written_in(&text));
        let parameters = Parameters::of(request, OWN_NAMES);
        let shader = shader(request, &source, &parameters);
        let lines = [
            format!("{}: made by Chiaro {}, OSL.", request.title, env!("CARGO_PKG_VERSION")),
            "The surface emits the look's color, and takes no light of the scene.".to_owned(),
        ];
        let body = format!("{functions}\n{shader}");
        let body = with_osl_preamble(&body);
        let text = format!("{}\n{}", header::comment(&lines), body.trim_start());
        // oslc cannot take a list as an argument.
        if ["({", ", {"].iter().any(|list| text.contains(list)) {
            let message = "the look has a list within a value, which OSL cannot express";
            return Err(refusal(message, "render with the add-on's own `render`"));
        }
        let mut about = parameters.names;
        about["file"] = json!(format!("{}.osl", request.stem));
        about["reads_uv"] = json!(source.varyings.iter().any(|name| name == "uv"));
        about["reads_time"] = json!(reads_time(&source));
        Ok(Self { text: broken(&text), about })
    }
}

/// True if the look asks for the time or the frame.
fn reads_time(source: &Source) -> bool {
    ["around.time", "around.frame"].iter().any(|word| source.wgsl.contains(word))
}

/// The shader around the look's functions.
fn shader(request: &PackageRequest<'_>, source: &Source, parameters: &Parameters) -> String {
    let name = super::module_name(request.stem);
    let mut text = format!("shader {name}(\n{}", parameters.text);
    if source.varyings.iter().any(|name| name == "uv") {
        text += "    point UV = point(0.0)\n        [[ string label = \"UV\" ]],\n";
    }
    if reads_time(source) {
        text += "    float seconds = 0.0\n        \
                 [[ string label = \"Time\", string units = \"s\" ]],\n    \
                 float frame = 0.0\n        [[ string label = \"Frame\" ]],\n";
    }
    text += OUTPUTS;
    if let Some(numbers) = &source.numbers {
        text += &parameters.settings;
        text += &surroundings(source);
        if source.is_keyed {
            text += "    settings = keyed(settings, around);\n";
        }
        let _ = writeln!(text, "    Look look = {numbers}(settings, around);");
    }
    if source.variables.contains(&VIEWER) {
        text += BACK;
    }
    let members: Vec<&str> = source.varyings.iter().map(|name| surface(name)).collect();
    let _ = writeln!(text, "    Varyings seen = Varyings({});", members.join(", "));
    let mut arguments: Vec<&str> = source.variables.clone();
    arguments.push("seen");
    if source.is_told_side {
        arguments.push("!backfacing()");
    }
    let light = match request.look.color_space {
        ColorSpace::Display => "light_of_shown(xyz(picture))",
        ColorSpace::Linear => "xyz(picture)",
    };
    let _ = write!(
        text,
        "    vector4 picture = {PICTURE}({});\n    \
         Color = (color){light};\n    \
         Alpha = picture.w;\n    \
         BSDF = Alpha * Color * emission() + (1.0 - Alpha) * transparent();\n}}\n",
        arguments.join(", ")
    );
    text
}

/// Statements that fill the surroundings, as far as the look asks for them.
fn surroundings(source: &Source) -> String {
    let asks = |word: &str| source.wgsl.contains(&format!("around.{word}"));
    let same = "Matrix3(vector(1.0, 0.0, 0.0), vector(0.0, 1.0, 0.0), vector(0.0, 0.0, 1.0))";
    let mut text = format!("    Matrix3 same = {same};\n");
    let (mut camera, mut object) = ("same", "same");
    if asks("camera_from_world") {
        text += CAMERA;
        camera = "camera_from_world";
    }
    if asks("object_axes") {
        text += OBJECT;
        object = "object_axes";
    }
    let eye = match asks("eye") {
        true => "to_y_up(transform(\"camera\", \"world\", point(0.0)) - middle) / radius",
        false => "vector(0.0)",
    };
    let time = |word: &str, name: &'static str| if asks(word) { name } else { "0.0" };
    let (seconds, frame) = (time("time", "seconds"), time("frame", "frame"));
    let _ = write!(
        text,
        "    Surroundings around = Surroundings(\n        \
             same, // illumination\n        \
             {camera}, // camera from world\n        \
             {eye}, // eye\n        \
             vector(0.0), // the view is no parallel one\n        \
             {object}, // axes of the object\n        \
             vector(0.0), // middle of the object\n        \
             0.0, // id of the object\n        \
             vector2(1.0, 1.0), // viewport\n        \
             {seconds}, // time\n        \
             {frame}); // frame\n"
    );
    text
}

/// A value of a surface that the look's vertices pass on.
fn surface(member: &str) -> &'static str {
    match member {
        "position" => "to_y_up(P - middle) / radius",
        // Cycles turns normals toward the eye.
        "normal" => "to_y_up(backfacing() ? -N : N)",
        "uv" => "vector2(UV[0], UV[1])",
        _ => "to_y_up(transform(\"world\", \"object\", P))",
    }
}

/// The text with its long lines broken.
fn broken(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    for line in text.lines() {
        let statement = line.trim_start();
        let indent = line.len() - statement.len();
        if line.len() <= 100
            || ["//", "#", "string ", "[[ "].iter().any(|start| statement.starts_with(start))
        {
            let _ = writeln!(result, "{line}");
        } else {
            write_line(statement, indent / 4, &mut result);
        }
    }
    result
}
