//! Values of wires as people read them: angles in degrees, colors by their hexadecimal text, a
//! profile by its three angles, each of several outputs by its name.
//!
//! A value comes as its scalars in order, with its name in the generated source. A name ends with
//! the input whose value it is, and with nothing more where the value is the node's result.

use chiaro_locale::{tr, tr_in, trn};

use super::values::{hex, number_text};
use super::{NodeKind, Port};
use crate::library::Type;

/// End of the name of a profile's constants, and their count: see `shaders/lib/profile.wgsl`.
const PROFILE: (&str, usize) = ("shape", 8);
/// Inputs that a profile's constants are made of.
const PROFILE_ANGLES: [&str; 3] = ["offset", "falloff", "cutoff"];
/// Scalars of a light: two directions, its color, its intensity; see `shaders/lib/types.wgsl`.
const LIGHT: usize = 10;
/// Most points of a curve, and most stops of a ramp.
const POINTS: usize = 16;
/// Scalars of a curve: points of four, their count, the interpolation.
const CURVE: usize = 4 * POINTS + 2;
/// Scalars of a ramp: colors, places, their count, the interpolation.
const RAMP: usize = 5 * POINTS + 2;

/// Part of a node that a value is.
#[derive(Clone, Copy, Debug)]
pub enum WirePart<'k> {
    /// All outputs of the node.
    Result(&'k [Port]),
    /// One of several outputs.
    Output(&'k Port),
    /// Value that an input takes.
    Input(&'k Port),
    /// Constants of a profile.
    Profile,
    /// Constants of another node, or a value of an unknown one.
    Numbers,
}

impl<'k> WirePart<'k> {
    /// Part of a node of `kind` that a value of `count` scalars is, by its name in the source.
    pub fn of(kind: &'k NodeKind, name: &str, count: usize) -> Self {
        let name = without_number(name);
        let ends = |port: &str| name.strip_suffix(port).is_some_and(|rest| rest.ends_with('_'));
        let is_profile = || PROFILE_ANGLES.iter().all(|angle| kind.input(angle).is_some());
        if name.ends_with(PROFILE.0) && count == PROFILE.1 && is_profile() {
            return Self::Profile;
        }
        let takes = |port: &&Port| {
            port.accepts.iter().chain([&port.ty]).any(|ty| scalars(ty) == Some(count))
        };
        let input = kind.inputs.iter().filter(takes).filter(|port| ends(port.name.as_str()));
        if let Some(port) = input.max_by_key(|port| port.name.as_str().len()) {
            return Self::Input(port);
        }
        if kind.outputs.is_empty() {
            // The end of a look gives what it takes.
            let is_color = |port: &&Port| matches!(port.ty, Type::Color | Type::Composite);
            let port = kind.inputs.iter().find(is_color).filter(|_| count == 4);
            return port.map_or(Self::Numbers, Self::Input);
        }
        if sum(&kind.outputs) == Some(count) {
            return Self::Result(&kind.outputs);
        }
        let is_it = |port: &&Port| scalars(&port.ty) == Some(count) && ends(port.name.as_str());
        kind.outputs.iter().find(is_it).map_or(Self::Numbers, Self::Output)
    }

    /// Name of the part beside that of the node; `None` for what the node gives as a whole.
    pub fn label(self) -> Option<String> {
        match self {
            Self::Result(_) | Self::Numbers => None,
            Self::Output(port) | Self::Input(port) => Some(tr_in("node", &port.label).to_owned()),
            Self::Profile => Some(tr!("Angles").to_owned()),
        }
    }

    /// The value in words.
    pub fn text(self, numbers: &[f64]) -> String {
        let told = match self {
            Self::Result([port]) | Self::Output(port) => typed(&port.ty, numbers),
            Self::Result(ports) => Some(by_name(ports, numbers)),
            Self::Input(port) if port.unit == "rad" && numbers.len() == 1 => angle(numbers[0]),
            Self::Input(port) => typed(&port.ty, numbers),
            Self::Profile => profile(numbers),
            Self::Numbers => None,
        };
        told.unwrap_or_else(|| plain(numbers))
    }

    /// Straight RGBA of the first color in the value; `None` where there is none, and where a
    /// number is not finite.
    pub fn color(self, numbers: &[f64]) -> Option<[f64; 4]> {
        let of_type = |ty: &Type, numbers: &[f64]| match (ty, numbers) {
            (Type::Light, [_, _, _, _, _, _, r, g, b, _]) => Some([*r, *g, *b, 1.0]),
            (_, [r, g, b, a]) => Some([*r, *g, *b, *a]),
            _ => None,
        };
        let color = match self {
            Self::Result(ports) => {
                let mut parts = parts(ports, numbers);
                parts.find_map(|(port, numbers)| of_type(&port.ty, numbers))
            }
            Self::Output(port) | Self::Input(port) => of_type(&port.ty, numbers),
            Self::Profile | Self::Numbers => of_type(&Type::Vec4, numbers),
        };
        color.filter(|color| color.iter().all(|x| x.is_finite()))
    }
}

/// A name of the source without the number that keeps it apart from others.
fn without_number(name: &str) -> &str {
    match name.rsplit_once('_') {
        Some((rest, number)) if number.bytes().all(|byte| byte.is_ascii_digit()) => rest,
        _ => name,
    }
}

/// Number of scalars of a type that a wire carries.
fn scalars(ty: &Type) -> Option<usize> {
    match ty {
        Type::Angle => Some(2),
        Type::Mat3 => Some(9),
        Type::Light => Some(LIGHT),
        Type::Curve => Some(CURVE),
        Type::Ramp => Some(RAMP),
        other => other.width(),
    }
}

fn sum(ports: &[Port]) -> Option<usize> {
    ports.iter().map(|port| scalars(&port.ty)).sum()
}

/// The scalars of each output of a whole result.
fn parts<'a>(ports: &'a [Port], numbers: &'a [f64]) -> impl Iterator<Item = (&'a Port, &'a [f64])> {
    let mut rest = numbers;
    ports.iter().map_while(move |port| {
        let (own, others) = rest.split_at_checked(scalars(&port.ty)?)?;
        rest = others;
        Some((port, own))
    })
}

/// Each output by its name.
fn by_name(ports: &[Port], numbers: &[f64]) -> String {
    let part = |(port, numbers): (&Port, &[f64])| {
        let text = typed(&port.ty, numbers).unwrap_or_else(|| plain(numbers));
        format!("{} {text}", tr_in("node", &port.label))
    };
    parts(ports, numbers).map(part).collect::<Vec<_>>().join(" · ")
}

/// A value by what its type means; `None` where that is numbers, or the scalars are others.
fn typed(ty: &Type, numbers: &[f64]) -> Option<String> {
    match (ty, numbers) {
        (Type::Angle, [sine, cosine]) => angle(2.0 * sine.atan2(*cosine)),
        (Type::Color | Type::Composite, [r, g, b, a]) => color([*r, *g, *b, *a]),
        (Type::Light, [_, _, _, _, _, _, r, g, b, intensity]) => {
            let color = color([*r, *g, *b, 1.0])?;
            Some(tr!("{color}, intensity {value}", value = number_text(*intensity, 3)))
        }
        (Type::Curve, _) => curve(numbers),
        (Type::Ramp, _) => ramp(numbers),
        _ => None,
    }
}

/// Text of an angle in radians.
fn angle(radians: f64) -> Option<String> {
    radians.is_finite().then(|| format!("{}°", number_text(radians.to_degrees(), 1)))
}

/// Text of a color that a screen has; `None` for brighter and darker ones.
fn color(color: [f64; 4]) -> Option<String> {
    color.iter().all(|x| (-1e-3..=1.001).contains(x)).then(|| hex(color))
}

/// The angles of a profile, which its constants are made of: the cut-off from 1/sin(c/2), the
/// fall-off from gamma = (1 - cos c cos f) / sin^2 f, both from the offset on (BADF eq. 11).
///
/// Two fall-offs may make the same profile; the lesser is where the tone falls fastest.
fn profile(numbers: &[f64]) -> Option<String> {
    let [_, _, scale, gamma, offset, _, _, kind] = *numbers else { return None };
    if numbers.iter().any(|x| !x.is_finite()) {
        return None;
    }
    if kind == 2.0 {
        return Some(tr!("1 everywhere").to_owned());
    }
    if kind == 1.0 {
        return Some(tr!("hard edge at {angle}", angle = angle(offset)?));
    }
    let cutoff = 2.0 * (1.0 / scale).clamp(-1.0, 1.0).asin();
    let cosine = cutoff.cos();
    let root = (cosine * cosine + 4.0 * gamma * (gamma - 1.0)).max(0.0).sqrt();
    let falloff = ((cosine + root) / (2.0 * gamma)).clamp(-1.0, 1.0).acos();
    Some(tr!(
        "offset {offset}, fall-off {falloff}, cut-off {cutoff}",
        falloff = angle(offset + falloff)?,
        cutoff = angle(offset + cutoff)?,
        offset = angle(offset)?
    ))
}

/// The ends of a curve.
fn curve(numbers: &[f64]) -> Option<String> {
    let count = count_of(numbers, CURVE)?;
    let point = |index: usize| {
        format!(
            "({}, {})",
            number_text(numbers[4 * index], 2),
            number_text(numbers[4 * index + 1], 2)
        )
    };
    let (first, last) = (point(0), point(count - 1));
    Some(trn!(
        count = count,
        "{count} point, {first} to {last}",
        "{count} points, {first} to {last}"
    ))
}

/// The ends of a ramp.
fn ramp(numbers: &[f64]) -> Option<String> {
    let count = count_of(numbers, RAMP)?;
    let stop = |index: usize| {
        let place = 4 * index;
        let own = [0, 1, 2, 3].map(|channel| numbers[place + channel]);
        color(own).unwrap_or_else(|| plain(&own))
    };
    let (first, last) = (stop(0), stop(count - 1));
    Some(trn!(
        count = count,
        "{count} color, {first} to {last}",
        "{count} colors, {first} to {last}"
    ))
}

/// Number of points that count, which stands before the interpolation; `None` for other scalars.
fn count_of(numbers: &[f64], length: usize) -> Option<usize> {
    let count = *numbers.get(length.checked_sub(2)?)?;
    let is_sound = numbers.len() == length && (1.0..=POINTS as f64).contains(&count);
    is_sound.then_some(count as usize)
}

/// Numbers as they are, with fewer digits where there are many; only their count where nobody
/// would read them.
fn plain(numbers: &[f64]) -> String {
    let is_finite = numbers.iter().all(|x| x.is_finite());
    if is_finite && numbers.len() > 9 {
        return trn!(count = numbers.len(), "{count} number", "{count} numbers");
    }
    let text = |x: f64| match numbers.len() {
        _ if x.is_nan() => "NaN".to_owned(),
        _ if x.is_infinite() => if x > 0.0 { "inf" } else { "-inf" }.to_owned(),
        1 => number_text(x, 7),
        2 => number_text(x, 5),
        _ => number_text(x, 2),
    };
    numbers.iter().map(|&x| text(x)).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;
    use crate::library::Library;

    fn told(kind: &str, name: &str, numbers: &[f64]) -> (Option<String>, String) {
        let catalog = Catalog::new(Library::built_in());
        let kind = catalog.get(kind).expect("a kind of the library");
        let part = WirePart::of(kind, name, numbers.len());
        (part.label(), part.text(numbers))
    }

    /// The constants that `profile_prepare` makes of three angles in degrees, by BADF eq. 11.
    fn constants(angles: [f64; 3]) -> [f64; 8] {
        let [offset, falloff, cutoff] = angles.map(f64::to_radians);
        let (f, c) = (falloff - offset, cutoff - offset);
        let gamma = (1.0 - c.cos() * f.cos()) / f.sin().powi(2);
        let (sine, cosine) = (0.5 * offset).sin_cos();
        [cosine, sine, 1.0 / (0.5 * c).sin(), gamma, offset, 0.1, 0.1, 0.0]
    }

    #[test]
    fn a_profile_is_told_by_its_angles_in_degrees() {
        for angles in
            [[0.0, 90.0, 90.0], [0.0, 17.2, 90.0], [20.0, 30.0, 60.0], [10.0, 60.0, 170.0]]
        {
            let [offset, falloff, cutoff] = angles;
            let text = format!("offset {offset}°, fall-off {falloff}°, cut-off {cutoff}°");
            let expected = (Some("Angles".to_owned()), text);
            assert_eq!(told("profile", "rim_tone_shape_2", &constants(angles)), expected);
        }
        let mut half_lambert = constants([0.0, 90.0, 180.0]);
        assert!(told("profile", "a_shape", &half_lambert).1.contains("fall-off 90°"));
        half_lambert[7] = 2.0;
        assert_eq!(told("profile", "a_shape", &half_lambert).1, "1 everywhere");
        let step = [0.9, 0.4, 0.0, 1.0, 45f64.to_radians(), 0.0, 0.0, 1.0];
        assert_eq!(told("profile", "a_shape", &step).1, "hard edge at 45°");
        let broken = [f64::NAN; 8];
        assert!(told("profile", "a_shape", &broken).1.starts_with("NaN NaN"));
    }

    #[test]
    fn angles_are_degrees_and_colors_hexadecimal() {
        let (sine, cosine) = 20f64.to_radians().sin_cos();
        assert_eq!(told("parametrization", "rim_angle", &[sine, cosine]), (None, "40°".to_owned()));
        let shift = told("profile", "rim_tone_shift", &[0.5f64.to_radians()]);
        assert_eq!(shift, (Some("Warp".to_owned()), "0.5°".to_owned()));
        let color = told("base", "base_color", &[1.0, 0.5, 0.0, 1.0]);
        assert_eq!(color, (Some("Color".to_owned()), "#ff8000".to_owned()));
        assert_eq!(told("base", "base_2", &[1.0, 0.5, 0.0, 1.0]), (None, "#ff8000".to_owned()));
        assert_eq!(told("base", "base_2", &[4.0, 0.5, 0.0, 1.0]).1, "4 0.5 0 1", "no screen's");
        let light = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.5];
        assert_eq!(told("light", "key", &light).1, "#ffffff, intensity 2.5");
    }

    #[test]
    fn each_of_several_outputs_has_its_name() {
        let lit = [1.0, 0.5, 0.0, 1.0, 0.25];
        assert_eq!(told("light_apply", "rim_lit", &lit).1, "Color #ff8000 · Tone 0.25");
        let catalog = Catalog::new(Library::built_in());
        let part = WirePart::of(catalog.get("light_apply").unwrap(), "rim_lit", lit.len());
        assert_eq!(part.color(&lit), Some([1.0, 0.5, 0.0, 1.0]));
        assert_eq!(part.color(&[f64::NAN, 0.0, 0.0, 1.0, 0.0]), None);
    }

    #[test]
    fn curves_and_ramps_are_told_by_their_ends() {
        let mut curve = [0.0; CURVE];
        curve[4..6].copy_from_slice(&[1.0, 0.5]);
        curve[CURVE - 2] = 2.0;
        let expected = (Some("Curve".to_owned()), "2 points, (0, 0) to (1, 0.5)".to_owned());
        assert_eq!(told("curve", "own_curve", &curve), expected);
        let mut ramp = [0.0; RAMP];
        ramp[3] = 1.0;
        ramp[4..8].copy_from_slice(&[1.0, 1.0, 1.0, 1.0]);
        ramp[RAMP - 2] = 2.0;
        assert_eq!(told("ramp", "own_ramp", &ramp).1, "2 colors, #000000 to #ffffff");
        ramp[RAMP - 2] = 99.0;
        assert_eq!(told("ramp", "own_ramp", &ramp).1, "82 numbers", "broken");
    }
}
