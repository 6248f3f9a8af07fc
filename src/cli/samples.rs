//! Samples of `chiaro eval`: JSON to [`EvalSample`]s, with the place of every problem.
//!
//! The JSON is read by hand rather than by a derive: a derive stops at the first problem, and
//! cannot tell its place in the list.

use std::path::Path;

use glam::{DMat3, DQuat, DVec2, DVec3};
use serde_json::{Map, Value as Json};

use crate::diag::{Diagnostic, LineColumn};
use crate::document::Value;
use crate::files::read_text;
use crate::frame::{EvalSample, LightOverride};
use crate::ids::{ObjectId, PortName};
use crate::library::{Context, ContextSample};

/// Largest number of problems that are told; a script that writes one mistake ten thousand times is
/// told often enough.
const MAX_PROBLEMS: usize = 50;

/// Fields of a sample, beside the [contexts](own_contexts) that have numbers of their own.
const FIELDS: [&str; 16] = [
    "normal", "tangent", "mirrored", "view", "position", "camera", "uv", "kappa", "distance",
    "front", "near", "color", "time", "frame", "lights", "values",
];
const LIGHT_FIELDS: [&str; 4] = ["direction", "position", "color", "intensity"];

/// Contexts whose numbers a sample gives under their words, with the default numbers.
pub(super) fn own_contexts() -> impl Iterator<Item = (Context, &'static [f64])> {
    Context::all().filter_map(|context| match context.row().sample {
        ContextSample::Own { default, .. } => Some((context, default)),
        _ => None,
    })
}

/// Reads a file of samples; `-` is standard input.
pub(super) fn read(path: &Path) -> Result<Vec<EvalSample>, Vec<Diagnostic>> {
    let text = if path == Path::new("-") {
        let failed = |error: std::io::Error| format!("standard input cannot be read: {error}");
        std::io::read_to_string(std::io::stdin().lock())
            .map_err(|error| vec![Diagnostic::error("cannot-read", failed(error))])?
    } else {
        read_text(path).map_err(|problem| vec![*problem])?
    };
    parse(&text, &name(path))
}

/// Name of a file of samples in messages.
pub(super) fn name(path: &Path) -> String {
    if path == Path::new("-") { "standard input".to_owned() } else { path.display().to_string() }
}

fn parse(text: &str, file: &str) -> Result<Vec<EvalSample>, Vec<Diagnostic>> {
    let hint = r#"write a list of objects: [{"normal": [0, 0, 1], "view": [0, 0, 1]}, ...]"#;
    let no_list =
        |message: String| Diagnostic::error("bad-samples", message).in_file(file).hint(hint);
    let json: Json = serde_json::from_str(text).map_err(|error| {
        let at =
            LineColumn { line: error.line().max(1) as u32, column: error.column().max(1) as u32 };
        vec![no_list(format!("this is no JSON: {error}")).at(at)]
    })?;
    let Json::Array(items) = json else {
        return Err(vec![no_list(format!(
            "expected a list of samples, found {}",
            describe(&json)
        ))]);
    };
    let mut reader = Reader { file, problems: Vec::new(), left_out: 0 };
    let samples = items
        .iter()
        .enumerate()
        .map(|(index, item)| reader.sample(item, &format!("[{index}]")))
        .collect();
    if reader.problems.is_empty() {
        return Ok(samples);
    }
    if reader.left_out > 0 {
        let more = format!("there are {} more problems in the samples", reader.left_out);
        reader.problems.push(Diagnostic::note("more-problems", more).in_file(file));
    }
    Err(reader.problems)
}

struct Reader<'a> {
    file: &'a str,
    problems: Vec<Diagnostic>,
    left_out: usize,
}

impl Reader<'_> {
    fn problem(&mut self, path: &str, problem: Diagnostic) {
        if self.problems.len() < MAX_PROBLEMS {
            self.problems.push(problem.in_file(self.file).json_path(path));
        } else {
            self.left_out += 1;
        }
    }

    fn expected(&mut self, path: &str, wanted: &str, found: &Json, example: &str) {
        let message = format!("expected {wanted}, found {}", describe(found));
        self.problem(
            path,
            Diagnostic::error("bad-sample", message).hint(format!("write {example}")),
        );
    }

    /// The object at `path`, whose fields must be among `known`.
    fn object<'j>(
        &mut self,
        json: &'j Json,
        path: &str,
        known: &[&str],
        example: &str,
    ) -> Option<&'j Map<String, Json>> {
        let Some(object) = json.as_object() else {
            self.expected(path, "an object", json, example);
            return None;
        };
        for name in object.keys().filter(|name| !known.contains(&name.as_str())) {
            let problem =
                Diagnostic::error("unknown-field", format!("there is no field `{name}` here"))
                    .suggest(name, known.iter().copied())
                    .hint(format!("the fields are {}", known.join(", ")));
            self.problem(&member(path, name), problem);
        }
        Some(object)
    }

    fn sample(&mut self, json: &Json, path: &str) -> EvalSample {
        let mut sample = EvalSample::default();
        let example = r#"{"normal": [0, 0, 1]}"#;
        let own = own_contexts().map(|(context, _)| context.word());
        let known: Vec<&str> = FIELDS.into_iter().chain(own).collect();
        let Some(fields) = self.object(json, path, &known, example) else { return sample };
        let at = |name: &str| fields.get(name).map(|json| (json, member(path, name)));
        for (name, slot) in [
            ("normal", &mut sample.normal),
            ("view", &mut sample.view),
            ("position", &mut sample.position),
            ("front", &mut sample.front),
        ] {
            if let Some(v) = at(name).and_then(|(json, path)| self.vector(json, &path)) {
                *slot = v;
            }
        }
        sample.tangent = at("tangent").and_then(|(json, path)| self.vector(json, &path));
        if let Some((json, path)) = at("mirrored") {
            match json.as_bool() {
                Some(is_mirrored) => sample.is_mirrored = is_mirrored,
                None => self.expected(&path, "true or false", json, "true"),
            }
        }
        if let Some(rows) = at("camera").and_then(|(json, path)| self.matrix(json, &path)) {
            sample.camera = rows;
        }
        if let Some([u, v]) =
            at("uv").and_then(|(json, path)| self.numbers(json, &path, "[0.5, 0.5]"))
        {
            sample.uv = DVec2::new(u, v);
        }
        if let Some(kappa) = at("kappa").and_then(|(json, path)| self.kappa(json, &path)) {
            sample.kappa = kappa;
        }
        for (context, default) in own_contexts() {
            if let Some((json, path)) = at(context.word())
                && let Some(numbers) = self.own_numbers(json, &path, default)
            {
                sample.contexts.insert(context, numbers);
            }
        }
        if let Some(distance) = at("distance").and_then(|(json, path)| self.number(json, &path)) {
            sample.distance = distance;
        }
        if let Some((json, path)) = at("near") {
            self.near(json, &path, &mut sample);
        }
        if let Some(color) = at("color").and_then(|(json, path)| self.color(json, &path)) {
            sample.vertex_color = color;
        }
        if let Some(time) = at("time").and_then(|(json, path)| self.number(json, &path)) {
            sample.time = time;
        }
        if let Some(frame) = at("frame").and_then(|(json, path)| self.rotation(json, &path)) {
            sample.frame = frame;
        }
        if let Some((json, path)) = at("lights") {
            self.lights(json, &path, &mut sample);
        }
        if let Some((json, path)) = at("values") {
            self.values(json, &path, &mut sample);
        }
        sample
    }

    /// Reads distances of other objects, by id.
    fn near(&mut self, json: &Json, path: &str, sample: &mut EvalSample) {
        let Some(objects) = json.as_object() else {
            self.expected(path, "distances by an object's id", json, r#"{"other": 2.5}"#);
            return;
        };
        for (id, json) in objects {
            if let Some(distance) = self.number(json, &member(path, id)) {
                sample.near.insert(ObjectId::new(id.clone()), distance);
            }
        }
    }

    fn number(&mut self, json: &Json, path: &str) -> Option<f64> {
        let number = json.as_f64().filter(|x| x.is_finite());
        if number.is_none() {
            self.expected(path, "a number", json, "0.5");
        }
        number
    }

    fn numbers<const N: usize>(
        &mut self,
        json: &Json,
        path: &str,
        example: &str,
    ) -> Option<[f64; N]> {
        let numbers: Option<Vec<f64>> =
            json.as_array().and_then(|items| items.iter().map(Json::as_f64).collect());
        let numbers = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
        if numbers.is_none() {
            self.expected(path, &format!("{N} numbers"), json, example);
        }
        numbers
    }

    /// Reads as many numbers as a context has of its own; a single one stands without a list.
    fn own_numbers(&mut self, json: &Json, path: &str, default: &[f64]) -> Option<Vec<f64>> {
        if let [_] = default {
            return self.number(json, path).map(|number| vec![number]);
        }
        let numbers: Option<Vec<f64>> =
            json.as_array().and_then(|items| items.iter().map(Json::as_f64).collect());
        let numbers = numbers.filter(|numbers| numbers.len() == default.len());
        if numbers.is_none() {
            let wanted = format!("{} numbers", default.len());
            self.expected(path, &wanted, json, &format!("{default:?}"));
        }
        numbers
    }

    fn vector(&mut self, json: &Json, path: &str) -> Option<DVec3> {
        self.numbers::<3>(json, path, "[0, 0, 1]").map(DVec3::from)
    }

    /// Reads rows, as a matrix that transforms column vectors.
    fn matrix(&mut self, json: &Json, path: &str) -> Option<DMat3> {
        let example = "three rows: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
        let Some(rows) = json.as_array().filter(|rows| rows.len() == 3) else {
            self.expected(path, "three rows of three numbers", json, example);
            return None;
        };
        let mut read = [[0.0; 3]; 3];
        for (index, row) in rows.iter().enumerate() {
            read[index] = self.numbers::<3>(row, &format!("{path}[{index}]"), "[1, 0, 0]")?;
        }
        Some(DMat3::from_cols_array_2d(&read).transpose())
    }

    /// Reads a number, or a word for one that JSON has no number for.
    fn kappa(&mut self, json: &Json, path: &str) -> Option<f64> {
        let word = json.as_str().map(|word| match word {
            "inf" | "+inf" => Some(f64::INFINITY),
            "-inf" => Some(f64::NEG_INFINITY),
            "nan" => Some(f64::NAN),
            _ => None,
        });
        match word {
            Some(Some(x)) => Some(x),
            None if json.is_number() => self.number(json, path),
            _ => {
                self.expected(path, "a number", json, r#"0.5, or "inf", "-inf" or "nan""#);
                None
            }
        }
    }

    fn color(&mut self, json: &Json, path: &str) -> Option<[f64; 4]> {
        match json.as_array().map(Vec::len) {
            Some(4) => self.numbers(json, path, "[1, 1, 1, 1]"),
            _ => self
                .numbers::<3>(json, path, "[1, 1, 1] or [1, 1, 1, 1]")
                .map(|[r, g, b]| [r, g, b, 1.0]),
        }
    }

    /// Reads a 3x3 matrix by rows, or a quaternion.
    fn rotation(&mut self, json: &Json, path: &str) -> Option<DQuat> {
        let is_matrix = json.as_array().is_some_and(|items| items.iter().any(Json::is_array));
        let example = "a quaternion [x, y, z, w] or three rows [[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
        if !is_matrix {
            let q = DQuat::from_array(self.numbers::<4>(json, path, example)?);
            if q.length_squared() < 1e-18 {
                self.problem(
                    path,
                    Diagnostic::error("bad-sample", "a quaternion of length 0 is no rotation")
                        .hint(format!("write {example}")),
                );
                return None;
            }
            return Some(q.normalize());
        }
        let matrix = self.matrix(json, path)?;
        let off = (matrix * matrix.transpose() - DMat3::IDENTITY).to_cols_array();
        let message = if !off.iter().all(|x| x.abs() <= 1e-3) {
            "this is no rotation: its rows must have length 1 and be at right angles"
        } else if matrix.determinant() < 0.0 {
            "this is no rotation: it mirrors"
        } else {
            return Some(DQuat::from_mat3(&matrix).normalize());
        };
        self.problem(
            path,
            Diagnostic::error("bad-sample", message).hint(format!("write {example}")),
        );
        None
    }

    fn lights(&mut self, json: &Json, path: &str, sample: &mut EvalSample) {
        let example = r#"{"key": {"direction": [0, 1, 1]}}"#;
        let Some(lights) = json.as_object() else {
            return self.expected(path, "an object", json, example);
        };
        for (id, light) in lights {
            let path = member(path, id);
            let Some(fields) =
                self.object(light, &path, &LIGHT_FIELDS, r#"{"direction": [0, 1, 1]}"#)
            else {
                continue;
            };
            let mut set = LightOverride::default();
            let vectors = [
                ("direction", &mut set.direction),
                ("position", &mut set.position),
                ("color", &mut set.color),
            ];
            for (name, slot) in vectors {
                *slot = fields.get(name).and_then(|json| self.vector(json, &member(&path, name)));
            }
            set.intensity = fields
                .get("intensity")
                .and_then(|json| self.number(json, &member(&path, "intensity")));
            if set.direction == Some(DVec3::ZERO) {
                let problem =
                    Diagnostic::error("bad-sample", "a direction of length 0 leads nowhere");
                self.problem(
                    &member(&path, "direction"),
                    problem.hint("write a vector of any length but 0"),
                );
            }
            if set.intensity.is_some_and(|intensity| intensity < 0.0) {
                let problem = Diagnostic::error("bad-sample", "an intensity is 0 or more");
                self.problem(
                    &member(&path, "intensity"),
                    problem.hint("write 0 for a light that is out"),
                );
            }
            sample.lights.insert(id.as_str().into(), set);
        }
    }

    fn values(&mut self, json: &Json, path: &str, sample: &mut EvalSample) {
        let Some(values) = json.as_object() else {
            return self.expected(path, "an object", json, r#"{"width": 0.5}"#);
        };
        for (name, json) in values {
            match serde_json::from_value::<Value>(json.clone()) {
                Ok(value) => drop(sample.values.insert(PortName::from(name.as_str()), value)),
                Err(_) => self.expected(
                    &member(path, name),
                    "a value of the parameter",
                    json,
                    r##"a number, [numbers], true, "a word", "#rrggbb", a curve or a ramp"##,
                ),
            }
        }
    }
}

/// Path of a member: `.key`, or `["key"]` if the key is no plain word.
fn member(path: &str, key: &str) -> String {
    let is_plain =
        !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-');
    if is_plain { format!("{path}.{key}") } else { format!("{path}[{}]", Json::from(key)) }
}

fn describe(json: &Json) -> String {
    match json {
        Json::Null => "null".to_owned(),
        Json::Bool(b) => b.to_string(),
        Json::Number(x) => x.to_string(),
        Json::String(text) if text.len() <= 40 => format!("the text {}", Json::from(text.as_str())),
        Json::String(_) => "a text".to_owned(),
        Json::Array(items) if items.iter().all(Json::is_number) => {
            format!("{} numbers", items.len())
        }
        Json::Array(items) => format!("a list of {}", items.len()),
        Json::Object(_) => "an object".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problems(text: &str) -> Vec<Diagnostic> {
        parse(text, "s.json").unwrap_err()
    }

    #[test]
    fn every_field_is_read() {
        let text = r##"[{
            "normal": [1, 2, 3], "tangent": [1, 0, 0], "mirrored": true, "view": [0, 1, 0],
            "position": [4, 5, 6],
            "camera": [[0, 0, -1], [0, 1, 0], [1, 0, 0]], "uv": [0.25, 0.75], "kappa": "-inf",
            "color": [1, 0, 0],
            "time": 2.5, "frame": [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
            "lights": {"key": {"direction": [0, 2, 0], "color": [1, 1, 0], "intensity": 0.5},
            "b": {"position": [1, 1, 1]}},
            "values": {"width": 1, "tint": "#ff0000", "list": [1, 2], "on": true}
        }, {}]"##;
        let samples = parse(text, "s.json").unwrap();
        let sample = &samples[0];
        assert_eq!((sample.normal, sample.tangent), (DVec3::new(1.0, 2.0, 3.0), Some(DVec3::X)));
        assert!(sample.is_mirrored && !samples[1].is_mirrored);
        assert_eq!((sample.view, sample.position), (DVec3::Y, DVec3::new(4.0, 5.0, 6.0)));
        // The first row is the direction to the right in the picture.
        assert_eq!(sample.camera * DVec3::NEG_Z, DVec3::X);
        assert_eq!((sample.uv, sample.kappa), (DVec2::new(0.25, 0.75), f64::NEG_INFINITY));
        assert_eq!((sample.vertex_color, sample.time), ([1.0, 0.0, 0.0, 1.0], 2.5));
        // The matrix takes z to x: a quarter turn around y.
        assert!((sample.frame * DVec3::Z - DVec3::X).length() < 1e-12);
        assert_eq!(sample.lights["key"].direction, Some(DVec3::new(0.0, 2.0, 0.0)));
        assert_eq!(
            (sample.lights["key"].intensity, sample.lights["b"].position),
            (Some(0.5), Some(DVec3::ONE))
        );
        assert_eq!(sample.values.len(), 4);
        assert_eq!(samples[1], EvalSample::default());
        assert!(parse(r#"[{"kappa": "nan"}]"#, "").unwrap()[0].kappa.is_nan());
        assert_eq!(parse(r#"[{"frame": [0, 0, 0, 2]}]"#, "").unwrap()[0].frame, DQuat::IDENTITY);
        assert_eq!(parse("[]", "").unwrap(), []);
    }

    #[test]
    fn every_problem_is_told_with_its_place() {
        let found = problems(
            r#"[{"normal": [0, 1]}, {}, {"nromal": [0, 0, 1], "lights": {"key": {"direction": "up",
                "colr": [1, 1, 1]}}},
                3, {"kappa": "much", "frame": [[1, 0, 0], [0, 1, 0], [0, 0, -1]],
                "camera": [[1, 0, 0], [0, 1], [0, 0, 1]]}]"#,
        );
        let paths: Vec<&str> =
            found.iter().filter_map(|problem| problem.place.json_path.as_deref()).collect();
        assert_eq!(
            paths,
            [
                "[0].normal",
                "[2].nromal",
                "[2].lights.key.colr",
                "[2].lights.key.direction",
                "[3]",
                "[4].camera[1]",
                "[4].kappa",
                "[4].frame",
            ]
        );
        assert!(
            found.iter().all(|problem| problem.place.file.as_deref() == Some("s.json")
                && !problem.hints.is_empty())
        );
        assert!(found[1].hints[0].contains("`normal`") && found[2].hints[0].contains("`color`"));
        assert!(found[7].message.contains("mirrors"));
    }

    #[test]
    fn what_is_no_list_says_what_to_write() {
        assert!(problems(r#"{"normal": [0, 0, 1]}"#)[0].message.contains("found an object"));
        let broken = &problems("[{]")[0];
        assert_eq!(broken.place.at, Some(LineColumn { line: 1, column: 3 }));
        // The same mistake is made a thousand times.
        let many = problems(&format!("[{}{{}}]", r#"{"time": "now"},"#.repeat(1000)));
        assert_eq!(many.len(), MAX_PROBLEMS + 1);
        assert!(many[MAX_PROBLEMS].message.contains("950 more"));
    }
}
