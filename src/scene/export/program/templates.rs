//! Functions of keys, in WGSL, with words in capitals where a look's numbers belong.

/// Weights of the keys of a set.
pub(super) const WEIGHTS: &str = "\
/// Weights of the keys of set INDEX, which sum to 1.
fn key_weights_INDEX(x: vec3f) -> array<f32, KEYS> {
FIND_PLACEFIND_RAW    var sum = 0.0;
    for (var i = 0; i < GROUPS; i++) {
        raw[i] = select(EVEN, eased(raw[i]), is_known);
        sum = sum + raw[i];
    }
    return array<f32, KEYS>(SHARES);
}

";

/// Place among directions; one without length gives all keys the same weight.
pub(super) const DIRECTION: &str = "    \
    let place = unit_or(x, vec3f(0.0));
    let is_known = dot(place, place) > 0.5;
";

/// Place among the values of drivers.
pub(super) const PLACE: &str = "    \
    let place = clamp((x - ORIGIN) * SCALE, vec3f(-1e6), vec3f(1e6));
    let is_known = true;
";

/// Raw weight of an only key.
pub(super) const WHOLE: &str = "    \
    var raw = array<f32, 1>(1.0);
";

/// Raw weights by distance alone.
pub(super) const INVERSE_DISTANCE: &str = "    \
    var centers = array<vec3f, GROUPS>(CENTERS);
    var raw: array<f32, GROUPS>;
    var all = 0.0;
    for (var i = 0; i < GROUPS; i++) {
        let way = place - centers[i];
        raw[i] = 1.0 / max(dot(way, way), 1e-30);
        all = all + raw[i];
    }
    for (var i = 0; i < GROUPS; i++) {
        raw[i] = raw[i] / all;
    }
";

/// Raw weights as sums of kernels.
pub(super) const SUM: &str = "    \
    var centers = array<vec3f, GROUPS>(CENTERS);
    var coefficients = array<f32, TERMS>(COEFFICIENTS);
    var raw = array<f32, GROUPS>(CONSTANTS);
    for (var i = 0; i < GROUPS; i++) {
        let kernel = KERNEL(place, centers[i]);
        for (var j = 0; j < GROUPS; j++) {
            raw[j] = raw[j] + coefficients[i * GROUPS + j] * kernel;
        }
    }
";

/// Direction between two.
pub(super) const TURNED: &str = "\
/// The direction between two, by a share of the way.
fn turned(a: vec3f, b: vec3f, share: f32) -> vec3f {
    let sum = (1.0 - share) * unit_or(a, vec3f(0.0)) + share * unit_or(b, vec3f(0.0));
    let nearest = select(a, b, share > 0.5);
    let has_length = length(sum) > 1e-9 * max(share, 1.0 - share);
    return select(unit_or(nearest, b), unit_or(sum, a), has_length);
}

";

/// Direction among several.
pub(super) const TURNED_OF: &str = "\
/// The direction among COUNT of those weights; of opposite ones the heaviest.
fn turned_COUNT(weights: array<f32, COUNT>, directions: array<vec3f, COUNT>) -> vec3f {
    var shares = weights;
    var ways = directions;
    var sum = vec3f(0.0);
    var most = 0.0;
    var strongest = vec3f(0.0, 0.0, 1.0);
    for (var i = 0; i < COUNT; i++) {
        let way = unit_or(ways[i], vec3f(0.0));
        if dot(way, way) > 0.5 && shares[i] > 0.0 {
            sum = sum + shares[i] * way;
            if shares[i] > most {
                most = shares[i];
                strongest = way;
            }
        }
    }
    if length(sum) > 1e-9 * most {
        return unit_or(sum, strongest);
    }
    return strongest;
}

";

/// Kernel of the paper's Appendix B, by its two series.
pub(super) const APPENDIX_B: &str = "\
/// The kernel of BADF Appendix B between two unit directions, by its series.
fn appendix_b_kernel(a: vec3f, b: vec3f) -> f32 {
    var series = array<f32, COUNT>(SERIES);
    var with_psi = array<f32, COUNT>(WITH_PSI);
    let near = 0.25 * dot(a - b, a - b);
    if near <= 0.0 {
        return 0.0;
    }
    var plain = 0.0;
    var other = 0.0;
    if near <= 0.5 {
        for (var i = LAST; i > 0; i--) {
            plain = plain * near + series[i];
            other = other * near + with_psi[i];
        }
        return 0.25 * near * (other - log(near) * plain);
    }
    let far = clamp(0.25 * dot(a + b, a + b), 0.0, 0.5);
    for (var i = LAST; i >= 0; i--) {
        plain = plain * far + series[i];
    }
    return 0.25 * (1.0 + log(1.0 - far) - FACTOR * plain) - AT_ZERO;
}

";

/// Functions that tracks over time call, by name.
pub(super) const OF_TRACKS: &[(&str, &str)] = &[
    ("turned", TURNED),
    (
        "bezier_between",
        "\
/// A number between two keys: a cubic of four values, whose inner two lie at `first` and `second`
/// of the way in time.
fn bezier_between(share: f32, first: f32, second: f32, a: f32, b: f32, c: f32, d: f32) -> f32 {
    let cube = 1.0 + 3.0 * (first - second);
    let square = 3.0 * second - 6.0 * first;
    let line = 3.0 * first;
    var low = 0.0;
    var high = 1.0;
    var s = share;
    for (var i = 0; i < 40; i++) {
        let off = ((cube * s + square) * s + line) * s - share;
        if off < 0.0 {
            low = s;
        } else {
            high = s;
        }
        let slope = (3.0 * cube * s + 2.0 * square) * s + line;
        var next = 0.5 * (low + high);
        if slope > 1e-6 {
            let newton = s - off / slope;
            if newton >= low && newton <= high {
                next = newton;
            }
        }
        s = next;
    }
    let r = 1.0 - s;
    return r * r * (r * a + 3.0 * s * b) + s * s * (3.0 * r * c + s * d);
}

",
    ),
    (
        "cycled",
        "\
/// The time between keys that come again.
fn cycled(time: f32, start: f32, length: f32) -> f32 {
    let since = time - start;
    return start + clamp(since - length * floor(since / length), 0.0, length);
}

",
    ),
    (
        "rounds_of_keys",
        "\
/// The count of rounds since the first one of keys that come again.
fn rounds_of_keys(time: f32, start: f32, length: f32) -> f32 {
    return floor((time - start) / length);
}

",
    ),
    (
        "mirrored",
        "\
/// The time between keys that come to and fro.
fn mirrored(time: f32, start: f32, length: f32) -> f32 {
    let since = time - start;
    let local = clamp(since - 2.0 * length * floor(since / (2.0 * length)), 0.0, 2.0 * length);
    return start + min(local, 2.0 * length - local);
}

",
    ),
    (
        "turned_on",
        "\
/// A direction that turns toward another one across it.
fn turned_on(own: vec3f, across: vec3f, angle: f32) -> vec3f {
    return cos(angle) * own + sin(angle) * across;
}

",
    ),
    (
        "turned_around",
        "\
/// A direction turned around an axis of length 1.
fn turned_around(v: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let along = dot(axis, v) * axis;
    return along + cos(angle) * (v - along) + sin(angle) * cross(axis, v);
}

",
    ),
];
