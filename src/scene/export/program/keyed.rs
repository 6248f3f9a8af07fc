//! Keys as a function of the program: settings to the settings that hold in the surroundings.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::super::modules::Host;
use super::literal::{literal, number, vec3};
use super::modules::Steps;
use super::settings::{LightSetting, ParameterSetting, Settings};
use super::{identifier, problem, templates, typed};
use crate::compile::TypedGraph;
use crate::diag::Diagnostic;
use crate::directions::{KeyWeights, SolvedKernel, SolvedWeights, SumKernel, appendix_b_series};
use crate::document::{
    DirectionKeys, Driver, Interpolation, KeyDirection, KeyScheme, LightQuantity, Look, Target,
    TimeKeys, Value,
};
use crate::ids::ObjectId;

/// Other objects whose distances drive keys, with their members of the surroundings.
pub(super) fn near_objects(look: &Look) -> Vec<(String, String)> {
    let mut ids: BTreeSet<&ObjectId> = BTreeSet::new();
    for keys in &look.direction_keys {
        if let KeyDirection::Drivers(drivers) = &keys.by {
            ids.extend(drivers.iter().filter_map(|driver| match driver {
                Driver::Near(id) => Some(id),
                _ => None,
            }));
        }
    }
    ids.into_iter().map(|id| (id.to_string(), near_member(id))).collect()
}

fn near_member(id: &ObjectId) -> String {
    identifier(&format!("near_{id}"), &[])
}

/// A place of the settings that keys move.
enum Place<'a> {
    Parameter(&'a ParameterSetting),
    Light(String, LightQuantity),
}

impl Place<'_> {
    /// The expression in `settings` or another variable of the type.
    fn of(&self, variable: &str) -> String {
        match self {
            Self::Parameter(setting) => format!("{variable}.{}", setting.member),
            Self::Light(member, _) => format!("{variable}.{member}"),
        }
    }

    fn is_direction(&self) -> bool {
        matches!(self, Self::Light(_, LightQuantity::Direction))
    }

    /// A value as a literal of the place's type.
    fn literal(&self, value: &Value) -> Option<String> {
        match self {
            Self::Parameter(setting) => literal(&typed(value, &setting.ty)?),
            Self::Light(..) => match value {
                Value::Number(x) => Some(number(*x)),
                _ => {
                    let numbers = match value {
                        Value::Vector(v) => v.clone(),
                        _ => value.color()?.to_vec(),
                    };
                    Some(vec3(numbers.get(..3)?.try_into().ok()?))
                }
            },
        }
    }
}

/// Writer of the keys' functions.
struct KeyWriter<'a> {
    look: &'a Look,
    typed: &'a TypedGraph,
    settings: &'a Settings,
    /// Functions that stand before `keyed`.
    functions: String,
    body: String,
}

/// Writes `keyed`; `None` where the look has no keys that move anything.
pub(super) fn write(
    look: &Look,
    typed: &TypedGraph,
    host: &Host,
    settings: &Settings,
) -> Result<Option<String>, Diagnostic> {
    if look.time_keys.is_empty() && look.direction_keys.is_empty() {
        return Ok(None);
    }
    let mut writer =
        KeyWriter { look, typed, settings, functions: String::new(), body: String::new() };
    for (index, track) in look.time_keys.iter().enumerate() {
        writer.track(index, track);
    }
    if !look.direction_keys.is_empty() {
        // Lights as they are before the sets decide about them.
        writer.body += "    let before = moved;\n";
    }
    let known = &host.shader.host.key_order;
    let order = if known.len() == look.direction_keys.len() {
        known.clone()
    } else {
        (0..look.direction_keys.len()).collect()
    };
    for index in order {
        writer.set(index, &look.direction_keys[index], host)?;
    }
    let KeyWriter { functions, body, .. } = writer;
    if body.trim() == "let before = moved;" || body.is_empty() {
        return Ok(None);
    }
    Ok(Some(format!(
        "{functions}/// The settings that hold in the surroundings: keys move them.\n\
         fn keyed(settings: Settings, around: Surroundings) -> Settings {{\n    \
         var moved = settings;\n{body}    return moved;\n}}\n\n"
    )))
}

impl<'a> KeyWriter<'a> {
    /// Places of the settings that a target names: one for each type that it is taken as.
    fn places(&self, target: &Target) -> Vec<Place<'a>> {
        match target {
            Target::Input { node, port } => {
                let mut params = self.typed.params.iter();
                let id = params.position(|it| it.path == *node && it.port == *port);
                id.into_iter()
                    .flat_map(|id| self.settings.of_param(id))
                    .map(Place::Parameter)
                    .collect()
            }
            Target::Light { .. } => {
                let quantity = target.light_field().map(|field| field.quantity());
                let found = self.settings.light_field(target).zip(quantity);
                found.map(|((member, _), it)| Place::Light(member, it)).into_iter().collect()
            }
        }
    }

    fn in_space(&self, value: &Value) -> Value {
        value.clone().in_space(self.look.color_space)
    }

    /// A track over time.
    fn track(&mut self, index: usize, track: &TimeKeys) {
        for place in self.places(&track.target) {
            let keys: Option<Vec<_>> = track
                .keys
                .iter()
                .map(|key| Some((key, place.literal(&self.in_space(&key.value))?)))
                .collect();
            let Some(keys) = keys.filter(|keys| !keys.is_empty()) else { continue };
            let target = place.of("moved");
            let name = format!("track_{index}");
            let ty = match &place {
                Place::Parameter(setting) => setting.ty.wgsl().to_owned(),
                Place::Light(_, quantity) => match quantity {
                    LightQuantity::Direction | LightQuantity::Position | LightQuantity::Color => {
                        "vec3f".to_owned()
                    }
                    _ => "f32".to_owned(),
                },
            };
            let can_mix = !matches!(ty.as_str(), "bool" | "i32");
            let mut text = String::new();
            for pair in keys.windows(2) {
                let [(key, a), (next, b)] = pair else { continue };
                let _ = writeln!(text, "    if time < {} {{", number(next.time));
                let span = next.time - key.time;
                let share = if span > 0.0 {
                    format!("(time - {}) / {}", number(key.time), number(span))
                } else {
                    "0.0".to_owned()
                };
                let share = match key.interpolation {
                    Interpolation::Stepped => None,
                    Interpolation::Linear => Some(format!("clamp({share}, 0.0, 1.0)")),
                    Interpolation::Smooth => Some(format!("eased({share})")),
                };
                let value = match share.filter(|_| can_mix) {
                    None => a.clone(),
                    Some(share) if place.is_direction() => {
                        format!("turned({a}, {b}, {share})")
                    }
                    Some(share) => format!("mix({a}, {b}, {share})"),
                };
                let _ = writeln!(text, "        return {value};\n    }}");
            }
            let last = keys.last().map(|(_, value)| value.clone()).unwrap_or_default();
            let _ = write!(
                self.functions,
                "/// `{}` over time.\nfn {name}(time: f32) -> {ty} {{\n{text}    \
                 return {last};\n}}\n\n",
                track.target
            );
            let _ = writeln!(self.body, "    {target} = {name}(around.time);");
            if place.is_direction() && !self.functions.contains("fn turned(") {
                self.functions += templates::TURNED;
            }
        }
    }

    /// A set of keys among directions or drivers.
    fn set(&mut self, index: usize, keys: &DirectionKeys, host: &Host) -> Result<(), Diagnostic> {
        let places: Vec<glam::DVec3> = keys.keys.iter().map(|key| key.direction.into()).collect();
        let weights = match keys.by {
            KeyDirection::Drivers(_) => KeyWeights::at_places(&places).value,
            KeyDirection::Light(_) | KeyDirection::View => {
                KeyWeights::new(&places, keys.scheme).value
            }
        };
        if !weights.has_weight() {
            return Ok(());
        }
        // Weights on a mesh have a closed form that differs by less than anyone sees.
        let solved = weights
            .solved()
            .or_else(|| KeyWeights::new(&places, KeyScheme::AppendixB).value.solved());
        let solved = solved.ok_or_else(|| problem("keys without weights"))?;
        self.weights(index, &solved);
        let place = self.decider(index, &keys.by, host)?;
        let _ = writeln!(self.body, "    let own_{index} = moved;");
        let _ = writeln!(self.body, "    let weights_{index} = key_weights_{index}({place});");
        let mut targets: Vec<&Target> =
            keys.keys.iter().flat_map(|key| key.values.keys()).collect();
        targets.sort_by_cached_key(|target| target.to_string());
        targets.dedup();
        for target in targets {
            for place in self.places(target) {
                self.blend(index, keys, target, &place);
            }
        }
        Ok(())
    }

    /// The value of a target under the weights of a set.
    fn blend(&mut self, index: usize, keys: &DirectionKeys, target: &Target, place: &Place<'_>) {
        let own = format!("own_{index}");
        let mut values = Vec::new();
        for key in &keys.keys {
            values.push(match self.profile_part(target, place, key, &own) {
                Some(value) => value,
                None => match key.values.get(target) {
                    Some(value) => match place.literal(&self.in_space(value)) {
                        Some(value) => value,
                        // A word or a switch has no values between.
                        None => return,
                    },
                    None => place.of(&own),
                },
            });
        }
        let moved = place.of("moved");
        if place.is_direction() {
            let count = values.len();
            let name = format!("turned_{count}");
            if !self.functions.contains(&format!("fn {name}(")) {
                let words = [("COUNT", count.to_string())];
                let words = words.each_ref().map(|(word, with)| (*word, with.as_str()));
                self.functions += &filled(templates::TURNED_OF, &words);
            }
            let list = values.join(", ");
            let _ = writeln!(
                self.body,
                "    {moved} = {name}(weights_{index}, array<vec3f, {count}>({list}));"
            );
            return;
        }
        let is_number = match place {
            Place::Parameter(setting) => {
                !matches!(setting.ty, crate::library::Type::Bool | crate::library::Type::Int)
            }
            Place::Light(..) => true,
        };
        if !is_number {
            return;
        }
        let terms: Vec<String> = values
            .iter()
            .enumerate()
            .map(|(key, value)| format!("weights_{index}[{key}] * {value}"))
            .collect();
        let _ = writeln!(self.body, "    {moved} = {};", terms.join("\n        + "));
    }

    /// The part of a profile at a key, brought into order with the other parts (docs/math.md 5);
    /// `None` for other targets.
    fn profile_part(
        &self,
        target: &Target,
        place: &Place<'_>,
        key: &crate::document::DirectionKey,
        own: &str,
    ) -> Option<String> {
        let Target::Input { node, port } = target else { return None };
        let Place::Parameter(_) = place else { return None };
        if !matches!(port.as_str(), "offset" | "falloff" | "cutoff") {
            return None;
        }
        let part = |name: &str, otherwise: f64| -> String {
            let target = Target::Input { node: node.clone(), port: name.into() };
            if let Some(Value::Number(x)) = key.values.get(&target) {
                return number(*x);
            }
            if let Some(place) = self.places(&target).first() {
                return place.of(own);
            }
            let mut params = self.typed.params.iter();
            let base = params.find(|it| it.path == *node && it.port.as_str() == name);
            match base.and_then(|it| it.value.as_ref()) {
                Some(Value::Number(x)) => number(*x),
                _ => number(otherwise),
            }
        };
        let half_turn = std::f64::consts::FRAC_PI_2;
        let (offset, cutoff) = (part("offset", 0.0), part("cutoff", half_turn));
        Some(match port.as_str() {
            "offset" => format!("profile_offset({offset})"),
            "cutoff" => format!("profile_cutoff({offset}, {cutoff})"),
            _ => format!("profile_falloff({offset}, {}, {cutoff})", part("falloff", half_turn)),
        })
    }

    /// The expression of the direction or place that decides between keys.
    fn decider(
        &mut self,
        index: usize,
        by: &KeyDirection,
        host: &Host,
    ) -> Result<String, Diagnostic> {
        let world = |light: &LightSetting| light.in_world().replace("settings.", "before.");
        Ok(match by {
            KeyDirection::View => "toward_viewer(around)".to_owned(),
            KeyDirection::Light(id) => match self.settings.light(id) {
                Some(light) => format!(
                    "around.camera_from_world * toward_light({}, around, {})",
                    world(light),
                    light.kind()
                ),
                None => "vec3f(0.0, 0.0, 1.0)".to_owned(),
            },
            KeyDirection::Drivers(drivers) => {
                let mut values = Vec::new();
                for (axis, driver) in drivers.iter().enumerate() {
                    values.push(match driver {
                        Driver::Distance => "distance_to_eye(around)".to_owned(),
                        Driver::Facing => "facing_angle(around)".to_owned(),
                        Driver::Height(id) => match self.settings.light(id) {
                            Some(light) => format!(
                                "height_angle(toward_light({}, around, {}))",
                                world(light),
                                light.kind()
                            ),
                            None => "0.0".to_owned(),
                        },
                        Driver::Near(id) => format!(
                            "bounded_number(around.{}, 0.0, FAR_AWAY_HOST)",
                            near_member(id)
                        ),
                        Driver::Wire(wire) => {
                            self.wire(&format!("driver_{index}_{axis}"), wire, host)?
                        }
                    });
                }
                values.resize(3, "0.0".to_owned());
                format!("vec3f({})", values.join(", "))
            }
        })
    }

    /// A function that computes a wire, and the call of it.
    fn wire(
        &mut self,
        name: &str,
        wire: &crate::document::OutputPort,
        host: &Host,
    ) -> Result<String, Diagnostic> {
        let found = host.shader.host.drivers.iter().find(|driver| driver.wire == *wire);
        let Some(driver) = found else { return Ok("0.0".to_owned()) };
        let mut steps = Steps::new(host, self.settings);
        let body = steps.write([driver.step])?;
        let value = steps.name(driver.step);
        let _ = write!(
            self.functions,
            "/// The wire `{wire}`, which drives keys.\n\
             fn {name}(settings: Settings, around: Surroundings) -> f32 {{\n\
             {body}    return driving_number({value});\n}}\n\n"
        );
        Ok(format!("{name}(moved, around)"))
    }

    /// The function of the weights of a set.
    fn weights(&mut self, index: usize, solved: &SolvedWeights) {
        let (keys, groups) = (solved.groups.len(), solved.centers.len());
        let centers: Vec<String> =
            solved.centers.iter().map(|center| vec3(center.to_array())).collect();
        let place = match solved.places {
            None => templates::DIRECTION.to_owned(),
            Some([origin, scale]) => filled(
                templates::PLACE,
                &[("ORIGIN", &vec3(origin.to_array())), ("SCALE", &vec3(scale.to_array()))],
            ),
        };
        let raw = match &solved.kernel {
            SolvedKernel::Whole => templates::WHOLE.to_owned(),
            SolvedKernel::InverseDistance => templates::INVERSE_DISTANCE.to_owned(),
            SolvedKernel::Sum { kernel, constants, coefficients } => {
                let function = match kernel {
                    SumKernel::Biharmonic => "biharmonic_kernel",
                    SumKernel::Distance => "distance_kernel",
                    SumKernel::AppendixB => {
                        self.appendix_b();
                        "appendix_b_kernel"
                    }
                };
                filled(
                    templates::SUM,
                    &[
                        ("TERMS", &coefficients.len().to_string()),
                        ("COEFFICIENTS", &list(coefficients)),
                        ("CONSTANTS", &list(constants)),
                        ("KERNEL", function),
                    ],
                )
            }
        };
        let size = |group: usize| solved.groups.iter().filter(|it| **it == Some(group)).count();
        let share = |group: &Option<usize>| match *group {
            None => "0.0".to_owned(),
            Some(group) if size(group) == 1 => format!("raw[{group}] / sum"),
            Some(group) => format!("raw[{group}] / sum / {}", number(size(group) as f64)),
        };
        let shares: Vec<String> = solved.groups.iter().map(share).collect();
        self.functions += &filled(
            templates::WEIGHTS,
            &[
                ("FIND_PLACE", &place),
                ("FIND_RAW", &raw),
                ("INDEX", &index.to_string()),
                ("CENTERS", &centers.join(", ")),
                ("GROUPS", &groups.to_string()),
                ("KEYS", &keys.to_string()),
                ("EVEN", &number(1.0 / groups as f64)),
                ("SHARES", &shares.join(", ")),
            ],
        );
    }

    /// The kernel of the paper's Appendix B, once.
    fn appendix_b(&mut self) {
        if self.functions.contains("fn appendix_b_kernel(") {
            return;
        }
        let ([series, with_psi], [factor, at_zero]) = appendix_b_series();
        self.functions += &filled(
            templates::APPENDIX_B,
            &[
                ("COUNT", &series.len().to_string()),
                ("LAST", &(series.len() - 1).to_string()),
                ("SERIES", &list(series)),
                ("WITH_PSI", &list(with_psi)),
                ("FACTOR", &number(factor)),
                ("AT_ZERO", &number(at_zero)),
            ],
        );
    }
}

/// Numbers with commas.
fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", ")
}

/// A template with texts in the place of its words, one after another.
fn filled(template: &str, words: &[(&str, &str)]) -> String {
    words.iter().fold(template.to_owned(), |text, (word, with)| text.replace(word, with))
}
