//! Keys as a function of the program: settings to the settings that hold in the surroundings.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use chiaro_locale::tr;

use super::super::modules::Host;
use super::literal::{literal, number, vec3};
use super::modules::Steps;
use super::settings::{LightSetting, ParameterSetting, Settings};
use super::{identifier, problem, templates, typed};
use crate::compile::TypedGraph;
use crate::diag::Diagnostic;
use crate::directions::{KeyWeights, SolvedKernel, SolvedWeights, SumKernel, appendix_b_series};
use crate::document::{
    DirectionKeys, Driver, Extrapolation, KeyDirection, KeyScheme, LightQuantity, Look, Target,
    TimeInterpolation, TimeKey, TimeKeys, Value,
};
use crate::frame::{BezierSpan, Track};
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

    /// Name of the place's type.
    fn wgsl(&self) -> String {
        match self {
            Self::Parameter(setting) => setting.ty.wgsl().to_owned(),
            Self::Light(_, quantity) => match quantity {
                LightQuantity::Direction | LightQuantity::Position | LightQuantity::Color => {
                    "vec3f".to_owned()
                }
                _ => "f32".to_owned(),
            },
        }
    }

    /// Count of numbers that the place holds, where there are values between two others.
    fn width(&self) -> Option<usize> {
        match self.wgsl().as_str() {
            "f32" => Some(1),
            "vec2f" => Some(2),
            "vec3f" => Some(3),
            "vec4f" => Some(4),
            _ => None,
        }
    }

    /// The type's constructor over as many expressions as the place has numbers; `None` where
    /// their count is another. Colors of three numbers are opaque.
    fn of_numbers(&self, numbers: &[String]) -> Option<String> {
        let width = self.width()?;
        let numbers = match (numbers.len(), width) {
            (3, 4) => [numbers, &["1.0".to_owned()]].concat(),
            (4, 3) => numbers[..3].to_vec(),
            (count, width) if count == width => numbers.to_vec(),
            _ => return None,
        };
        Some(match width {
            1 => numbers[0].clone(),
            _ => format!("{}({})", self.wgsl(), numbers.join(", ")),
        })
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

/// Writer of the function of one track.
struct TrackWriter<'a> {
    track: Track<'a>,
    place: &'a Place<'a>,
    /// Keys with their values as literals.
    keys: &'a [(&'a TimeKey, String)],
}

impl TrackWriter<'_> {
    /// Statements that return the value before the last key.
    fn spans(&self) -> Result<String, Diagnostic> {
        let can_mix = !matches!(self.place.wgsl().as_str(), "bool" | "i32");
        let mut text = String::new();
        for (index, pair) in self.keys.windows(2).enumerate() {
            let [(key, a), (next, b)] = pair else { continue };
            let _ = writeln!(text, "    if time < {} {{", number(next.time));
            let span = next.time - key.time;
            let share = if span > 0.0 {
                format!("(time - {}) / {}", number(key.time), number(span))
            } else {
                "0.0".to_owned()
            };
            let plain = format!("clamp({share}, 0.0, 1.0)");
            let between = |share: &str| match self.place.is_direction() {
                true => format!("turned({a}, {b}, {share})"),
                false => format!("mix({a}, {b}, {share})"),
            };
            let value = match key.interpolation {
                TimeInterpolation::Linear if can_mix => between(&plain),
                TimeInterpolation::Smooth if can_mix => between(&format!("eased({share})")),
                TimeInterpolation::Bezier if can_mix => match self.track.spans(index) {
                    Some(spans) => {
                        let cubic = self.cubic(&spans)?;
                        let _ = writeln!(text, "        let share = {plain};");
                        match self.place.is_direction() {
                            true => format!("unit_or({cubic}, {})", between("share")),
                            false => cubic,
                        }
                    }
                    None => between(&plain),
                },
                _ => a.clone(),
            };
            let _ = writeln!(text, "        return {value};\n    }}");
        }
        Ok(text)
    }

    /// A cubic at `share`.
    fn cubic(&self, spans: &[BezierSpan]) -> Result<String, Diagnostic> {
        let numbers: Vec<String> = spans
            .iter()
            .map(|span| {
                format!("bezier_between(share, {}, {})", list(&span.times), list(&span.values))
            })
            .collect();
        self.place.of_numbers(&numbers).ok_or_else(|| self.unfit())
    }

    /// Error of keys that have another count of numbers than their place.
    fn unfit(&self) -> Diagnostic {
        problem(tr!(
            "keys of `{place}` have another count of numbers than it",
            place = self.place.of("look")
        ))
    }

    /// Statements that return the values beyond the keys, where these do not hold; `within` names
    /// the function of the values between them.
    fn beyond(&self, within: &str) -> Result<String, Diagnostic> {
        let (first, last) = (&self.keys[0], &self.keys[self.keys.len() - 1]);
        let (start, length) = (first.0.time, last.0.time - first.0.time);
        let mut text = String::new();
        let has_length = length > 0.0;
        for (side, is_first) in [(self.track.ends.before, true), (self.track.ends.after, false)] {
            let value = match side {
                Extrapolation::Hold => None,
                _ if !has_length => None,
                Extrapolation::Linear => self.straight_on(is_first)?,
                Extrapolation::Cycle | Extrapolation::CycleOffset => {
                    let range = format!("time, {}, {}", number(start), number(length));
                    let again = format!("{within}(cycled({range}))");
                    let rounds = format!("rounds_of_keys({range})");
                    let moved = side == Extrapolation::CycleOffset;
                    Some(if moved { self.moved_on(&again, &rounds)? } else { again })
                }
                Extrapolation::Mirror => {
                    Some(format!("{within}(mirrored(time, {}, {}))", number(start), number(length)))
                }
            };
            let Some(value) = value else { continue };
            let test = match is_first {
                true => format!("time < {}", number(start)),
                false => format!("time > {}", number(last.0.time)),
            };
            let _ = writeln!(text, "    if {test} {{\n        return {value};\n    }}");
        }
        Ok(text)
    }

    /// The value beyond an end, on its slope; `None` where it holds.
    fn straight_on(&self, is_first: bool) -> Result<Option<String>, Diagnostic> {
        let Some(slopes) = self.track.end_slope(is_first).filter(|_| self.place.width().is_some())
        else {
            return Ok(None);
        };
        let (key, value) = &self.keys[if is_first { 0 } else { self.keys.len() - 1 }];
        let beyond = format!("(time - {})", number(key.time));
        if self.place.is_direction() {
            let turn = self.track.end_turn(is_first);
            return Ok(turn.map(|(own, across, speed)| {
                let (own, across) = (vec3(own.to_array()), vec3(across.to_array()));
                format!("turned_on({own}, {across}, {} * {beyond})", number(speed))
            }));
        }
        // Numbers that are added to a color's opacity of 1 are none.
        let slopes: Vec<String> = slopes.iter().map(|slope| number(*slope)).collect();
        let slopes = match (slopes.len(), self.place.width()) {
            (3, Some(4)) => [slopes, vec!["0.0".to_owned()]].concat(),
            _ => slopes,
        };
        let slope = self.place.of_numbers(&slopes).ok_or_else(|| self.unfit())?;
        Ok(Some(self.in_range(&format!("{value} + {beyond} * {slope}"))))
    }

    /// A value of an earlier round, some rounds later.
    fn moved_on(&self, value: &str, rounds: &str) -> Result<String, Diagnostic> {
        if self.place.is_direction() {
            return Ok(match self.track.turn() {
                Some((axis, angle)) => {
                    let axis = vec3(axis.to_array());
                    format!("turned_around({value}, {axis}, {} * {rounds})", number(angle))
                }
                None => value.to_owned(),
            });
        }
        let Some(change) = self.track.change().filter(|_| self.place.width().is_some()) else {
            return Ok(value.to_owned());
        };
        let change: Vec<String> = change.iter().map(|change| number(*change)).collect();
        let change = match (change.len(), self.place.width()) {
            (3, Some(4)) => [change, vec!["0.0".to_owned()]].concat(),
            _ => change,
        };
        let change = self.place.of_numbers(&change).ok_or_else(|| self.unfit())?;
        Ok(self.in_range(&format!("{value} + {rounds} * {change}")))
    }

    /// An expression within the numbers of 32 bits.
    fn in_range(&self, value: &str) -> String {
        let most = number(f64::from(f32::MAX));
        match self.place.width() {
            Some(1) => format!("clamp({value}, -{most}, {most})"),
            _ => {
                let ty = self.place.wgsl();
                format!("clamp({value}, {ty}(-{most}), {ty}({most}))")
            }
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
        writer.track(index, track)?;
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
    fn track(&mut self, index: usize, track: &TimeKeys) -> Result<(), Diagnostic> {
        let mut track = track.clone();
        for key in &mut track.keys {
            key.value = self.in_space(&key.value);
        }
        for place in self.places(&track.target) {
            let keys: Option<Vec<_>> =
                track.keys.iter().map(|key| Some((key, place.literal(&key.value)?))).collect();
            let Some(keys) = keys.filter(|keys| !keys.is_empty()) else { continue };
            let target = place.of("moved");
            let name = format!("track_{index}");
            let ty = place.wgsl();
            let writer = TrackWriter { track: Track::of(&track), place: &place, keys: &keys };
            let text = writer.spans()?;
            let last = keys.last().map(|(_, value)| value.clone()).unwrap_or_default();
            let beyond = writer.beyond(&format!("{name}_between"))?;
            let within = if beyond.is_empty() { name.clone() } else { format!("{name}_between") };
            let _ = write!(
                self.functions,
                "/// `{}` over time.\nfn {within}(time: f32) -> {ty} {{\n{text}    \
                 return {last};\n}}\n\n",
                track.target
            );
            if !beyond.is_empty() {
                let _ = write!(
                    self.functions,
                    "/// `{}` over time, also beyond its keys.\n\
                     fn {name}(time: f32) -> {ty} {{\n{beyond}    return {within}(time);\n}}\n\n",
                    track.target
                );
            }
            let _ = writeln!(self.body, "    {target} = {name}(around.time);");
            self.helpers(&(text + &beyond), place.is_direction());
        }
        Ok(())
    }

    /// Functions that the text of a track calls, each once.
    fn helpers(&mut self, text: &str, is_direction: bool) {
        for (name, function) in templates::OF_TRACKS {
            let is_called = text.contains(&format!("{name}("));
            let is_needed = is_called || *name == "turned" && is_direction;
            if is_needed && !self.functions.contains(&format!("fn {name}(")) {
                self.functions += function;
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
        let solved = solved.ok_or_else(|| problem(tr!("keys without weights")))?;
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
