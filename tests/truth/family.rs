//! Nodes of the techniques that the two sources build on: the GPU against f64, by the papers' own
//! formulas.
#![cfg(feature = "gpu")]

use crate::support;
use std::f64::consts::{PI, TAU};

use crate::support::badf::{angle, held, mirrored};
use crate::support::color::{to_linear, to_srgb};
use crate::support::held::{SampleInputs, library, numeric, run_at, width, words};
use crate::support::paint::painted;
use crate::support::random::Random;
use crate::support::report::Errors;
use chiaro::frame::{EvalSample, LightOverride};
use chiaro::library::{Library, NodeDef, Type};
use glam::{DVec2, DVec3};

/// The surface, the eye and the light at a sample.
struct Place {
    l: DVec3,
    v: DVec3,
    /// The surface's normal; nodes that have an input for a normal get another one there.
    n: DVec3,
    depth: f64,
}

/// The truth of a shading node: the numbers of one output after another.
type ShadingFormula = fn(SampleInputs<'_>, &Place) -> Vec<f64>;

fn v3(numbers: &[f64]) -> DVec3 {
    DVec3::from_slice(numbers)
}

fn list(v: DVec3) -> Vec<f64> {
    v.to_array().to_vec()
}

fn half(l: DVec3, v: DVec3) -> DVec3 {
    (l + v).normalize()
}

/// Direction and unit axes, from the first three inputs.
fn bent(i: SampleInputs<'_>) -> [DVec3; 3] {
    [0, 1, 2].map(|k| v3(&i[k]).normalize())
}

/// Radius of a star within a circle of radius 1, found by intersecting a ray with the line between
/// two corners.
fn star(turn: f64, rays: f64, inner: f64, round: f64) -> f64 {
    let sector = TAU / rays;
    let theta = turn.rem_euclid(sector);
    let (a, b) = if theta < 0.5 * sector {
        (DVec2::X, inner * DVec2::from_angle(0.5 * sector))
    } else {
        (inner * DVec2::from_angle(0.5 * sector), DVec2::from_angle(sector))
    };
    let ray = DVec2::from_angle(theta);
    (1.0 - round) * a.perp_dot(b) / ray.perp_dot(b - a) + round
}

fn oklab(rgb: [f64; 3]) -> [f64; 3] {
    let [r, g, b] = rgb;
    let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
    let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
    let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
    [
        0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
        1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
        0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
    ]
}

/// Inverse of `oklab` by Newton's method, so that no second matrix is trusted.
fn rgb_of_oklab(lab: [f64; 3]) -> [f64; 3] {
    let mut rgb = DVec3::splat(0.5);
    for _ in 0..200 {
        let f = |c: DVec3| DVec3::from_array(oklab(c.to_array()));
        let off = DVec3::from_array(lab) - f(rgb);
        let h = 1e-7;
        let columns = [DVec3::X, DVec3::Y, DVec3::Z]
            .map(|axis| (f(rgb + h * axis) - f(rgb - h * axis)) / (2.0 * h));
        let step = glam::DMat3::from_cols(columns[0], columns[1], columns[2]).inverse() * off;
        rgb += step.clamp_length_max(0.2);
    }
    rgb.to_array()
}

fn three(i: &[f64]) -> [f64; 3] {
    [i[0], i[1], i[2]]
}

fn mixed(i: SampleInputs<'_>, blended: [f64; 3]) -> Vec<f64> {
    let t = i[2][0].clamp(0.0, 1.0);
    (0..3).map(|k| (1.0 - t) * i[0][k] + t * blended[k]).chain([i[0][3]]).collect()
}

fn steps(x: f64, count: f64) -> f64 {
    let n = count.max(2.0);
    (x * n).floor().min(n - 1.0) / (n - 1.0)
}

/// [`steps`] with a ramp around each edge, which takes the share `softness` of a step.
fn soft_steps(x: f64, count: f64, softness: f64) -> f64 {
    let n = count.max(2.0);
    let risen =
        (1..n as i32).map(|edge| (0.5 + (x * n - f64::from(edge)) / softness).clamp(0.0, 1.0));
    risen.sum::<f64>() / (n - 1.0)
}

fn unit(x: f64) -> f64 {
    x.clamp(0.0, 1.0)
}

/// Width of a highlight, by its roughness.
fn wide(roughness: f64) -> f64 {
    unit(roughness).powi(2).max(0.001)
}

#[expect(clippy::too_many_lines, reason = "a table: a few lines a node")]
fn truth(kind: &str, word: &str) -> Option<ShadingFormula> {
    Some(match (kind, word) {
        ("half_vector", _) => |_, p| list(half(p.l, p.v)),
        ("axes", _) => |i, _| {
            let (z, up) = (v3(&i[0]).normalize(), v3(&i[1]).normalize());
            let x = up.cross(z).normalize();
            [x.to_array(), z.cross(x).to_array()].concat()
        },
        ("shift_direction", _) => |i, _| {
            let [d, x, y] = bent(i);
            list((d + i[3][0] * x + i[4][0] * y).normalize())
        },
        ("stretch_direction", _) => |i, _| {
            let [d, x, y] = bent(i);
            list(
                (d - i[3][0].min(1.0) * d.dot(x) * x - i[4][0].min(1.0) * d.dot(y) * y).normalize(),
            )
        },
        ("split_direction", _) => |i, _| {
            let [d, x, y] = bent(i);
            let by = |amount: f64, cosine: f64| amount.max(0.0) * cosine.signum();
            list((d - by(i[3][0], d.dot(x)) * x - by(i[4][0], d.dot(y)) * y).normalize())
        },
        ("square_direction", _) => |i, _| {
            let [d, x, y] = bent(i);
            // Anjyo and Hiramitsu measure the angle of the place within the axes from the nearer
            // axis.
            let (a, b) = (d.dot(x), d.dot(y));
            let theta = b.abs().atan2(a.abs());
            let corner = (2.0 * theta.min(0.5 * PI - theta)).sin().powf(i[4][0].clamp(1.0, 1024.0));
            list((d - unit(i[3][0]) * corner * (a * x + b * y)).normalize())
        },
        ("angle_between_directions", _) => |i, _| vec![angle(v3(&i[0]), v3(&i[1]))],
        ("star_angle", _) => |i, _| {
            let [d, m, x, y] = [0, 1, 2, 3].map(|k| v3(&i[k]).normalize());
            let turn = d.dot(y).atan2(d.dot(x)) - i[7][0];
            let reach =
                star(turn, i[4][0].clamp(2.0, 64.0), i[5][0].clamp(0.01, 1.0), unit(i[6][0]));
            vec![(angle(d, m) / reach).min(PI)]
        },
        ("polar_place", _) => |i, _| {
            let [d, m, x, y] = [0, 1, 2, 3].map(|k| v3(&i[k]).normalize());
            vec![angle(d, m), (d.dot(y).atan2(d.dot(x)) / TAU).rem_euclid(1.0)]
        },
        ("scale_angle", _) => |i, p| vec![(angle(p.n, p.l) * i[0][0].max(0.0)).min(PI)],
        ("combine_tones", "union") => |i, _| vec![unit(i[0][0]).max(unit(i[1][0]))],
        ("combine_tones", "intersection") => |i, _| vec![unit(i[0][0]).min(unit(i[1][0]))],
        ("combine_tones", "difference") => |i, _| vec![unit(i[0][0]).min(1.0 - unit(i[1][0]))],
        ("combine_tones", "exclusion") => |i, _| vec![(unit(i[0][0]) - unit(i[1][0])).abs()],
        ("reflectance", "lambert") => |i, p| vec![v3(&i[0]).normalize().dot(p.l).max(0.0)],
        ("reflectance", "half_lambert") => {
            |i, p| vec![(0.5 * v3(&i[0]).normalize().dot(p.l) + 0.5).powi(2)]
        }
        ("reflectance", "wrap") => |i, p| {
            let w = unit(i[5][0]);
            vec![((v3(&i[0]).normalize().dot(p.l) + w) / (1.0 + w)).max(0.0)]
        },
        ("reflectance", "oren_nayar") => |i, p| {
            let n = v3(&i[0]).normalize();
            let (to_light, to_eye) = (angle(n, p.l), angle(n, p.v));
            let flat = |v: DVec3| (v - v.dot(n) * n).normalize();
            let s2 = unit(i[2][0]).powi(2);
            let (a, b) = (1.0 - 0.5 * s2 / (s2 + 0.33), 0.45 * s2 / (s2 + 0.09));
            let rough = flat(p.l).dot(flat(p.v)).max(0.0)
                * to_light.max(to_eye).sin()
                * to_light.min(to_eye).tan();
            vec![if n.dot(p.l) <= 0.0 { 0.0 } else { n.dot(p.l) * (a + b * rough) }]
        },
        ("reflectance", "phong") => |i, p| {
            let (n, e) = (v3(&i[0]).normalize(), (2.0 / wide(i[2][0]).powi(2) - 2.0).max(0.0));
            let lit = n.dot(p.l).max(0.0);
            vec![((e + 2.0) / 2.0 * mirrored(n, p.v).dot(p.l).max(0.0).powf(e) * lit).min(1e6)]
        },
        ("reflectance", "blinn_phong") => |i, p| {
            let (n, e) = (v3(&i[0]).normalize(), (2.0 / wide(i[2][0]).powi(2) - 2.0).max(0.0));
            vec![
                ((e + 8.0) / 8.0 * n.dot(half(p.l, p.v)).max(0.0).powf(e) * n.dot(p.l).max(0.0))
                    .min(1e6),
            ]
        },
        ("reflectance", "ggx") => |i, p| {
            let (n, h) = (v3(&i[0]).normalize(), half(p.l, p.v));
            let a2 = wide(i[2][0]).powi(2);
            let (theta_l, theta_v, theta_h) = (angle(n, p.l), angle(n, p.v), angle(n, h));
            if theta_l >= 0.5 * PI || theta_v >= 0.5 * PI {
                return vec![0.0];
            }
            // Walter et al. 2007, eq. 33, and Heitz 2014, eq. 72 and 99.
            let d = a2 / (PI * theta_h.cos().powi(4) * (a2 + theta_h.tan().powi(2)).powi(2));
            let lambda = |theta: f64| 0.5 * ((1.0 + a2 * theta.tan().powi(2)).sqrt() - 1.0);
            let g = 1.0 / (1.0 + lambda(theta_l) + lambda(theta_v));
            let f0 = unit(i[4][0]);
            let f = f0 + (1.0 - f0) * (1.0 - p.v.dot(h)).powi(5);
            vec![(PI * d * g * f / (4.0 * theta_v.cos())).min(1e6)]
        },
        ("reflectance", "ward") => |i, p| {
            let n = v3(&i[0]).normalize();
            let along = v3(&i[1]);
            let x = (along - along.dot(n) * n).normalize();
            let y = n.cross(x);
            let (cl, cv) = (n.dot(p.l), n.dot(p.v));
            if cl <= 0.0 || cv <= 0.0 {
                return vec![0.0];
            }
            let (ax, ay) = (wide(i[2][0]).max(0.0025), wide(i[3][0]).max(0.0025));
            let h = half(p.l, p.v);
            let (theta, phi) = (angle(n, h), h.dot(y).atan2(h.dot(x)));
            let spread = (phi.cos() / ax).powi(2) + (phi.sin() / ay).powi(2);
            vec![cl * (-theta.tan().powi(2) * spread).exp() / (4.0 * ax * ay * (cl * cv).sqrt())]
        },
        ("fresnel", _) => |i, p| {
            let cosine = v3(&i[1]).normalize().dot(p.v).max(0.0);
            vec![unit(i[0][0]) + (1.0 - unit(i[0][0])) * (1.0 - cosine).powi(5)]
        },
        ("rim", _) => |i, p| {
            let n = v3(&i[0]).normalize();
            let (reach, soft, follow) = (unit(i[1][0]), unit(i[2][0]), unit(i[3][0]));
            let inside = n.dot(p.v).clamp(0.0, 1.0);
            let line = if soft > 0.0 {
                unit((reach - inside) / (reach * soft))
            } else {
                f64::from(inside < reach)
            };
            let across = (p.l - p.l.dot(p.v) * p.v).normalize();
            let side = unit(n.dot(across) / 0.5);
            let side = side * side * (3.0 - 2.0 * side);
            vec![if reach == 0.0 { 0.0 } else { line * (1.0 - follow + follow * side) }]
        },
        ("thin_film", _) => |i, p| {
            let n = i[1][0].clamp(1.0, 3.0);
            let outside = angle(v3(&i[2]), p.v).min(0.5 * PI);
            let inside = (outside.sin() / n).asin();
            let path = 2.0 * n * i[0][0].clamp(0.0, 2000.0) * inside.cos();
            [650.0, 532.0, 450.0]
                .map(|wave| 0.5 - 0.5 * (TAU * path / wave).cos())
                .into_iter()
                .chain([1.0])
                .collect()
        },
        ("gooch", _) => |i, p| {
            let t = 0.5 * (1.0 + v3(&i[0]).normalize().dot(p.l));
            let mix = |k: usize| {
                let cool = i[2][k] + unit(i[4][0]) * i[1][k];
                let warm = i[3][k] + unit(i[5][0]) * i[1][k];
                (1.0 - t) * cool + t * warm
            };
            vec![mix(0), mix(1), mix(2), i[1][3]]
        },
        ("detail", "depth") => |i, p| {
            let (near, far) = (i[0][0].max(1.2e-38), i[1][0].max(1.2e-38));
            vec![1.0 - unit((p.depth.max(1.2e-38) / near).ln() / (far / near).ln())]
        },
        ("detail", "focus") => |i, p| {
            let (near, far) = (i[0][0].max(1.2e-38), i[1][0].max(1.2e-38));
            vec![1.0 - unit((p.depth.max(1.2e-38) / near).ln().abs() / (far / near).ln().abs())]
        },
        ("detail", "orientation") => {
            |i, p| vec![v3(&i[4]).normalize().dot(p.v).abs().powf(i[2][0].max(0.0))]
        }
        ("detail", "place") => |i, p| {
            let (near, far) = (i[0][0].max(1.2e-38), i[1][0].max(1.2e-38));
            vec![
                1.0 - unit(
                    (v3(&i[3]).distance(DVec3::new(0.0, 0.0, -p.depth)) / near).ln()
                        / (far / near).ln(),
                ),
            ]
        },
        ("detail", "highlight") => |i, p| {
            vec![
                mirrored(v3(&i[4]).normalize(), p.v)
                    .dot(p.l)
                    .max(0.0)
                    .powf(i[2][0].max(0.0))
                    .min(1.0),
            ]
        },
        ("nearby", _) => |i, _| vec![near(&i[0], &i[1], i[2][0], i[3][0])],
        ("local_tone", _) => |i, _| {
            vec![unit(
                unit(i[0][0]) + i[1][0].clamp(-1.0, 1.0) * near(&i[5], &i[2], i[3][0], i[4][0]),
            )]
        },
        ("mix_colors", "exclusion") => {
            |i, _| mixed(i, painted("exclusion", three(&i[0]), three(&i[1])))
        }
        ("mix_colors", "color_dodge") => {
            |i, _| mixed(i, painted("color_dodge", three(&i[0]), three(&i[1])))
        }
        ("mix_colors", "color_burn") => {
            |i, _| mixed(i, painted("color_burn", three(&i[0]), three(&i[1])))
        }
        ("mix_colors", "hue") => |i, _| mixed(i, painted("hue", three(&i[0]), three(&i[1]))),
        ("mix_colors", "saturation") => {
            |i, _| mixed(i, painted("saturation", three(&i[0]), three(&i[1])))
        }
        ("mix_colors", "color") => |i, _| mixed(i, painted("color", three(&i[0]), three(&i[1]))),
        ("mix_colors", "luminosity") => {
            |i, _| mixed(i, painted("luminosity", three(&i[0]), three(&i[1])))
        }
        ("color_space", "srgb_to_oklab") => {
            |i, _| oklab(three(&i[0]).map(to_linear)).into_iter().chain([i[0][3]]).collect()
        }
        ("posterize", "channel") => |i, _| {
            three(&i[0])
                .map(|c| soft_steps(unit(c), i[1][0], i[2][0]))
                .into_iter()
                .chain([i[0][3]])
                .collect()
        },
        ("mix_evenly", "linear") => |i, _| {
            let t = unit(i[2][0]);
            let mix = |k: usize| to_srgb((1.0 - t) * to_linear(i[0][k]) + t * to_linear(i[1][k]));
            vec![mix(0), mix(1), mix(2), (1.0 - t) * i[0][3] + t * i[1][3]]
        },
        ("mix_evenly", "oklab") => |i, _| {
            let t = unit(i[2][0]);
            let (a, b) = (oklab(three(&i[0]).map(to_linear)), oklab(three(&i[1]).map(to_linear)));
            let rgb = rgb_of_oklab([0, 1, 2].map(|k| (1.0 - t) * a[k] + t * b[k])).map(to_srgb);
            rgb.into_iter().chain([(1.0 - t) * i[0][3] + t * i[1][3]]).collect()
        },
        ("smooth_normal", _) => |_, p| list(p.n.normalize()),
        ("exaggerated", "two") => |i, p| vec![exaggerated(i, p.l, 2)],
        ("exaggerated", "three") => |i, p| vec![exaggerated(i, p.l, 3)],
        ("exaggerated", "four") => |i, p| vec![exaggerated(i, p.l, 4)],
        ("relief", _) => |i, _| {
            let [greatest, least] = eigenvalues(&i[0]);
            let shape = 2.0 / PI * ((greatest + least) / (greatest - least)).atan();
            let curvedness = (0.5 * (greatest.powi(2) + least.powi(2))).sqrt();
            vec![0.5 + 0.5 * shape, (i[1][0].max(0.0) * curvedness).tanh(), greatest, least]
        },
        ("radiance_scaling", _) => |i, _| {
            // Vergne et al. 2010, eq. 5.
            let (delta, alpha) = (unit(i[0][0]), i[4][0].clamp(0.001, 0.999));
            let e = (i[2][0] * (i[1][0] * i[3][0]).tanh()).exp();
            let scale = (alpha * e + delta * (1.0 - alpha * (1.0 + e)))
                / (alpha + delta * (e - alpha * (1.0 + e)));
            vec![unit(delta * scale)]
        },
        ("inner_contour", "valleys") => |i, p| vec![lined(-eigenvalues(&i[3])[1], i, p)],
        ("inner_contour", "ridges") => |i, p| vec![lined(eigenvalues(&i[3])[0], i, p)],
        _ => return None,
    })
}

/// Weight of a position: 1 near a center, 0 from the radius on, by the cubic that is level at both
/// ends.
fn near(position: &[f64], center: &[f64], radius: f64, hardness: f64) -> f64 {
    let (far, reach) = (v3(position).distance(v3(center)), radius.max(0.0));
    let inner = reach * unit(hardness);
    if inner >= reach {
        return f64::from(far < reach);
    }
    let t = unit((far - inner) / (reach - inner));
    1.0 - t * t * (3.0 - 2.0 * t)
}

/// The tone of Rusinkiewicz et al. 2006, section 3: detail at each scale, and the smoothest normal
/// under the light itself.
fn exaggerated(i: SampleInputs<'_>, l: DVec3, scales: usize) -> f64 {
    let (contrast, detail) = (i[1][0].max(0.0), i[2][0]);
    let normals: Vec<DVec3> = std::iter::once(&i[0])
        .chain(&i[3..3 + scales])
        .map(|numbers| v3(numbers).normalize())
        .collect();
    let mut lit: Vec<f64> = normals
        .windows(2)
        .map(|pair| {
            let raking = pair[1].cross(l.cross(pair[1]));
            let raking = raking / raking.length().max(0.05);
            (contrast * pair[0].dot(raking)).clamp(-1.0, 1.0)
        })
        .collect();
    lit.push(normals[scales].dot(l));
    let weights: Vec<f64> = (0..=scales).map(|scale| 2f64.powf(-detail * scale as f64)).collect();
    let sum: f64 = lit.iter().zip(&weights).map(|(lit, weight)| lit * weight).sum();
    unit(0.5 + 0.5 * sum / weights.iter().sum::<f64>())
}

/// The largest and the smallest eigenvalue of a tensor (xx, xy, yy), as roots of the characteristic
/// polynomial.
fn eigenvalues(tensor: &[f64]) -> [f64; 2] {
    let (trace, determinant) =
        (tensor[0] + tensor[2], tensor[0] * tensor[2] - tensor[1] * tensor[1]);
    let root = (trace * trace - 4.0 * determinant).max(0.0).sqrt();
    [0.5 * (trace + root), 0.5 * (trace - root)]
}

/// Ink of a line where x is above the limit, fading at the outline.
fn lined(x: f64, i: SampleInputs<'_>, p: &Place) -> f64 {
    let (limit, soft) = (i[1][0].max(0.0), unit(i[2][0]));
    let width = limit * soft;
    let above = if width > 0.0 { unit(0.5 + (x - limit) / width) } else { f64::from(x >= limit) };
    let seen = unit((p.n.normalize().dot(p.v) - 0.05) / 0.25);
    above * seen * seen * (3.0 - 2.0 * seen)
}

/// Random numbers in the range of an input of a node.
fn random_value(def: &NodeDef, name: &str, ty: &Type, random: &mut Random) -> Vec<f64> {
    let f32_of = |x: f64| f64::from(x as f32);
    let number = |random: &mut Random| match (def.kind.as_str(), name) {
        (_, "rays") => 2.0 + random.index(9) as f64,
        (_, "steps") => 2.0 + random.index(6) as f64,
        (_, "softness") if def.kind == "posterize" => random.between(0.2, 1.0),
        (_, "roughness" | "across") => random.between(0.3, 1.1),
        (_, "thickness") => random.between(0.0, 1500.0),
        (_, "index") => random.between(1.0, 2.5),
        (_, "radius") => random.between(0.5, 5.0),
        (_, "near") => random.between(0.5, 3.0),
        (_, "far") => random.between(3.5, 9.0),
        ("mix_colors" | "color_space" | "posterize" | "mix_evenly", _) => {
            random.between(0.01, 0.99)
        }
        (_, "turn") => random.between(-7.0, 7.0),
        (_, "inner") => random.between(0.1, 1.0),
        (_, "factor") => random.between(-0.2, 3.0),
        _ => random.between(-0.3, 1.3),
    };
    match ty {
        Type::Vec3 => held(random.direction()).to_array().map(|x| f32_of(2.0 * x)).to_vec(),
        Type::Bool => vec![f64::from(u8::from(random.chance(0.5)))],
        _ => (0..width(ty)).map(|_| f32_of(number(random))).collect(),
    }
}

fn place(random: &mut Random) -> (Place, EvalSample) {
    let (n, l, v) = (held(random.direction()), held(random.direction()), held(random.direction()));
    let position = DVec3::new(0.0, 0.0, -f64::from(random.between(0.2, 12.0) as f32));
    let light = LightOverride { direction: Some(l), ..LightOverride::default() };
    let lights = [("key".into(), light)].into_iter().collect();
    let sample = EvalSample { normal: n, view: v, position, lights, ..EvalSample::default() };
    (Place { l: l.normalize(), v: v.normalize(), n, depth: -position.z }, sample)
}

/// Tolerance of a node's outputs; a highlight's power multiplies rounding by its exponent.
fn tolerance(kind: &str, word: &str) -> f64 {
    match (kind, word) {
        ("reflectance", "phong" | "blinn_phong") => 6e-5,
        ("reflectance", "ggx" | "ward") => 2e-5,
        ("star_angle" | "polar_place" | "thin_film", _) | ("detail", "highlight") => 1e-5,
        // Near black the sRGB curve is 13 times as steep as linear light.
        ("mix_evenly", _) => 2e-5,
        _ => 2e-6,
    }
}

#[test]
fn every_technique_is_its_papers_formula() {
    let library = library();
    for def in Library::built_in().nodes.values() {
        for (port, word) in words(def) {
            let Some(truth) = truth(&def.kind, &word) else { continue };
            let choice: &[(&str, &str)] = if word.is_empty() { &[] } else { &[(&port, &word)] };
            let types: Vec<Type> = numeric(def).iter().map(|input| input.ty.clone()).collect();
            let mut random = Random::new(500);
            let (mut rows, mut places, mut samples) = (Vec::new(), Vec::new(), Vec::new());
            for _ in 0..500 {
                let inputs = numeric(def);
                let value = |(input, ty): (&&chiaro::library::Input, &Type)| {
                    random_value(def, input.name.as_str(), ty, &mut random)
                };
                rows.push(inputs.iter().zip(&types).map(value).collect::<Vec<_>>());
                let (place, sample) = place(&mut random);
                places.push(place);
                samples.push(sample);
            }
            let mut errors =
                Errors::new(format!("{} {word}", def.kind), tolerance(&def.kind, &word));
            let mut left_out = 0;
            for ((got, row), place) in run_at(def, choice, &types, &rows, &samples, &library)
                .iter()
                .zip(&rows)
                .zip(&places)
            {
                let wanted = truth(row, place);
                assert_eq!(got.len(), wanted.len(), "{} {word}", def.kind);
                assert!(
                    got.iter().all(|x| x.is_finite()),
                    "{} {word}: {got:?} of {row:?}",
                    def.kind
                );
                // Where the last digit of an input changes much, a jump is near, and both sides are
                // right.
                let moved: Vec<Vec<f64>> = row
                    .iter()
                    .map(|v| v.iter().map(|x| x * (1.0 + 3e-7) + 1e-7).collect())
                    .collect();
                let other = truth(&moved, place);
                for ((got, wanted), other) in got.iter().zip(&wanted).zip(&other) {
                    let scale = wanted.abs().max(1.0);
                    if (wanted - other).abs() > 3e-5 * scale {
                        left_out += 1;
                        continue;
                    }
                    errors.note(got / scale, wanted / scale, || format!("{row:?} {:?}", place.l));
                }
            }
            assert!(
                left_out < 60,
                "{} {word}: {left_out} samples are too near to a jump",
                def.kind
            );
            errors.finish();
        }
    }
}

/// Outputs of a node for rows of inputs, at default samples.
fn results(kind: &str, choice: &[(&str, &str)], rows: &[Vec<Vec<f64>>]) -> Vec<Vec<f64>> {
    let def = &Library::built_in().nodes[kind];
    let types: Vec<Type> = numeric(def).iter().map(|input| input.ty.clone()).collect();
    run_at(def, choice, &types, rows, &vec![EvalSample::default(); rows.len()], &library())
}

fn colors(count: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| (0..4).map(|_| f64::from(random.between(0.02, 0.98) as f32)).collect())
        .collect()
}

#[test]
fn oklab_comes_back() {
    let wanted = colors(400, 501);
    let coded = |c: &Vec<f64>| {
        oklab(three(c).map(to_linear))
            .map(|x| f64::from(x as f32))
            .into_iter()
            .chain([c[3]])
            .collect()
    };
    let rows: Vec<Vec<Vec<f64>>> = wanted.iter().map(|c| vec![coded(c)]).collect();
    let mut errors = Errors::new("color_space oklab_to_srgb", 1e-5);
    for (got, wanted) in
        results("color_space", &[("conversion", "oklab_to_srgb")], &rows).iter().zip(&wanted)
    {
        (0..4).for_each(|k| errors.note(got[k], wanted[k], || format!("{wanted:?}")));
    }
    errors.finish();
}

/// Posterized colors have even steps in lightness, and keep their hue.
#[test]
fn posters_keep_their_hues() {
    let rows: Vec<Vec<Vec<f64>>> =
        colors(600, 502).into_iter().map(|c| vec![c, vec![4.0], vec![0.0]]).collect();
    let mut lightness = Errors::new("posterize lightness", 1e-4);
    let mut hue = Errors::new("posterize lightness, hue", 1e-3);
    for (got, row) in results("posterize", &[("by", "lightness")], &rows).iter().zip(&rows) {
        let [was, is] = [&row[0], got].map(|c| oklab(three(c).map(to_linear)));
        let step = steps(was[0], 4.0);
        // Beside a step both values are right; and a color outside of the screen's colors is
        // replaced by the nearest one within.
        let is_near = ((was[0] * 4.0).round() - was[0] * 4.0).abs() < 1e-4;
        let is_outside = three(got).into_iter().any(|c| c <= 1e-6 || c >= 1.0 - 1e-6);
        if is_near || is_outside {
            continue;
        }
        lightness.note(is[0], step, || format!("{row:?}"));
        let cross = was[1] * is[2] - was[2] * is[1];
        let sine = cross / (was[1].hypot(was[2]) * is[1].hypot(is[2])).max(1e-3);
        hue.note(sine, 0.0, || format!("{row:?}"));
    }
    lightness.finish();
    hue.finish();
}

/// Mixing around the hues: chroma goes in a straight line from one color's to the other's, and the
/// hue turns evenly, the shorter way.
#[test]
fn hues_turn_evenly() {
    let (from, to) = (colors(400, 503), colors(400, 504));
    let factor = 0.25;
    let rows: Vec<Vec<Vec<f64>>> =
        from.iter().zip(&to).map(|(a, b)| vec![a.clone(), b.clone(), vec![factor]]).collect();
    let mut errors = Errors::new("mix_evenly hue", 2e-5);
    for (got, row) in results("mix_evenly", &[("space", "hue")], &rows).iter().zip(&rows) {
        let [a, b] = [&row[0], &row[1]].map(|c| oklab(three(c).map(to_linear)));
        let (ca, cb) = (a[1].hypot(a[2]), b[1].hypot(b[2]));
        let apart = angle(DVec3::new(a[1], a[2], 0.0), DVec3::new(b[1], b[2], 0.0));
        if ca < 0.01 || cb < 0.01 || apart > 3.1 {
            continue;
        }
        let side = (a[1] * b[2] - a[2] * b[1]).signum();
        let turned = DVec2::from_angle(side * apart * factor).rotate(DVec2::new(a[1], a[2]) / ca);
        let chroma = ca + factor * (cb - ca);
        let wanted =
            rgb_of_oklab([a[0] + factor * (b[0] - a[0]), chroma * turned.x, chroma * turned.y])
                .map(to_srgb);
        (0..3).for_each(|k| errors.note(got[k], wanted[k], || format!("{row:?}")));
    }
    errors.finish();
    for (kind, space) in [("mix_evenly", "oklab"), ("mix_evenly", "hue"), ("mix_evenly", "linear")]
    {
        for (factor, end) in [(0.0, 0), (1.0, 1)] {
            let row = vec![rows[0][0].clone(), rows[0][1].clone(), vec![factor]];
            let got = &results(kind, &[("space", space)], &[row])[0];
            assert_eq!(got, &rows[0][end], "{space} at {factor} is an end, and exactly that");
        }
    }
}

/// Light warping in the tangent plane: the light's stereographic projection is scaled along each
/// principal direction by a power of two, found here from the tensor's eigenvectors.
#[test]
fn warped_lights_are_drawn_along_the_principal_directions() {
    let look = support::eval::look(&serde_json::json!({
        "lights": {"key": {"direction": [0, 0, 1]}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "warp", "kind": "light_warp", "values": {"amount": 1.5, "slope": 0.4}},
            {"id": "tensor", "kind": "vector_value"},
            {"id": "parts", "kind": "light_parts"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "warp.light"},
            {"from": "tensor", "to": "warp.tensor"},
            {"from": "warp", "to": "parts.light"},
            {"from": "parts.color", "to": "output.color"}
        ],
        "exposed": [{"name": "tensor", "target": "tensor.vector"}]
    }));
    let mut random = Random::new(505);
    let mut errors = Errors::new("light_warp", 2e-5);
    let (mut samples, mut wanted) = (Vec::new(), Vec::new());
    while samples.len() < 400 {
        let (place, mut sample) = place(&mut random);
        let camera = glam::DMat3::from_quat(random.rotation());
        let tensor = [(); 3].map(|()| f64::from((6.0 * random.unit() - 3.0) as f32));
        let (n, l, v) = (place.n.normalize(), place.l, place.v);
        // Left out are surfaces that face away, which are not seen; lights opposite the normal,
        // which have no projection; and lines of sight along the picture's axes.
        let right = camera.transpose() * DVec3::X;
        if n.dot(v) < -0.5 || n.dot(l) < -0.95 || right.dot(v).abs() > 0.95 {
            continue;
        }
        let x = (right - right.dot(v) * v).normalize();
        let tilt = glam::DQuat::from_rotation_arc(v, n);
        let axes = [tilt * x, tilt * v.cross(x)];
        let theta = 0.5 * (2.0 * tensor[1]).atan2(tensor[0] - tensor[2]);
        let principal =
            [theta, theta + 0.5 * PI].map(|theta| theta.cos() * axes[0] + theta.sin() * axes[1]);
        let curvatures = [theta, theta + 0.5 * PI].map(|theta| {
            let (s, c) = theta.sin_cos();
            tensor[0] * c * c + 2.0 * tensor[1] * c * s + tensor[2] * s * s
        });
        let seen = unit((n.dot(v) - 0.05) / 0.25);
        let most = 1.5 * seen * seen * (3.0 - 2.0 * seen);
        let scaled = |k: usize| {
            2f64.powf(-most * (0.4 * curvatures[k]).tanh()) * l.dot(principal[k]) / (1.0 + l.dot(n))
        };
        let q = [scaled(0), scaled(1)];
        let square = q[0] * q[0] + q[1] * q[1];
        wanted.push(
            (2.0 * (q[0] * principal[0] + q[1] * principal[1]) + (1.0 - square) * n)
                / (1.0 + square),
        );
        sample.camera = camera;
        sample.values = [("tensor".into(), chiaro::document::Value::Vector(tensor.to_vec()))]
            .into_iter()
            .collect();
        samples.push(sample);
    }
    for (got, wanted) in support::eval::eval(&look, "parts.direction", &samples).iter().zip(&wanted)
    {
        (0..3).for_each(|k| errors.note(got[k], wanted[k], || format!("{wanted}")));
    }
    errors.finish();
}

/// A local light is bent and stronger around its center, and unchanged elsewhere.
#[test]
fn local_lights_change_around_their_place() {
    let look = support::eval::look(&serde_json::json!({
        "lights": {"key": {"direction": [0, 0, 1], "intensity": 0.5}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "local", "kind": "local_light", "values":
                {
                    "bend": [1, -0.5, 0], "strength": 3, "center": [0.2, 0, 0], "radius": 0.8,
                    "hardness": 0.25
                }},
            {"id": "parts", "kind": "light_parts"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "local.light"},
            {"from": "local", "to": "parts.light"},
            {"from": "parts.color", "to": "output.color"}
        ]
    }));
    let mut random = Random::new(506);
    let samples: Vec<EvalSample> = (0..300)
        .map(|_| EvalSample {
            position: random.direction() * random.unit(),
            ..EvalSample::default()
        })
        .collect();
    let [directions, intensities] = ["direction", "intensity"]
        .map(|port| support::eval::eval(&look, &format!("parts.{port}"), &samples));
    let mut errors = Errors::new("local_light", 2e-6);
    for ((direction, intensity), sample) in directions.iter().zip(&intensities).zip(&samples) {
        let weight = near(&list(sample.position), &[0.2, 0.0, 0.0], 0.8, 0.25);
        let wanted = (DVec3::Z + weight * DVec3::new(1.0, -0.5, 0.0)).normalize();
        (0..3)
            .for_each(|k| errors.note(direction[k], wanted[k], || format!("{}", sample.position)));
        errors.note(intensity[0], 0.5 * (1.0 + 2.0 * weight), || format!("{}", sample.position));
    }
    errors.finish();
}

/// Outputs of a node that reads a ramp or curves, at 200 values of one exposed input.
fn over(
    node: &serde_json::Value,
    input: &str,
    values: &[chiaro::document::Value],
) -> Vec<[f64; 4]> {
    let look = support::eval::look(&serde_json::json!({
        "nodes": [node, {"id": "output", "kind": "output"}],
        "wires": [{"from": "node", "to": "output.color"}],
        "exposed": [{"name": "held", "target": format!("node.{input}")}]
    }));
    let at = |value: &chiaro::document::Value| EvalSample {
        values: [("held".into(), value.clone())].into_iter().collect(),
        ..EvalSample::default()
    };
    support::eval::eval(&look, "", &values.iter().map(at).collect::<Vec<_>>())
}

/// Between two stops a ramp mixes the two colors in the ramp's space.
#[test]
fn ramps_go_through_their_space() {
    let stops = [[0.9, 0.1, 0.2, 1.0], [0.1, 0.3, 0.8, 0.5], [0.95, 0.9, 0.3, 1.0]];
    let values: Vec<chiaro::document::Value> =
        (0..200).map(|k| chiaro::document::Value::Number(f64::from(k) / 160.0 - 0.1)).collect();
    for space in ["oklab", "light", "hue", "hsv"] {
        let ramp = serde_json::json!({"stops": [
            {"at": 0.0, "color": stops[0]}, {"at": 0.25, "color": stops[1]},
            {"at": 1.0, "color": stops[2]}]});
        let node = serde_json::json!({
            "id": "node", "kind": "ramp", "values": {"space": space, "ramp": ramp}
        });
        let mut errors = Errors::new(format!("ramp {space}"), 3e-5);
        for (got, value) in over(&node, "value", &values).iter().zip(&values) {
            let chiaro::document::Value::Number(x) = value else { continue };
            let x = x.clamp(0.0, 1.0);
            let (a, b, t) = if x < 0.25 {
                (stops[0], stops[1], x / 0.25)
            } else {
                (stops[1], stops[2], (x - 0.25) / 0.75)
            };
            let mix = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] + t * (b[k] - a[k]));
            let (light_a, light_b) = (three(&a).map(to_linear), three(&b).map(to_linear));
            let turned = |one: f64, other: f64, whole: f64| {
                let way = (other - one).rem_euclid(whole);
                one + t * if way > 0.5 * whole { way - whole } else { way }
            };
            let wanted = match space {
                "light" => mix(light_a, light_b).map(to_srgb),
                "oklab" => rgb_of_oklab(mix(oklab(light_a), oklab(light_b))).map(to_srgb),
                "hue" => {
                    let polar =
                        |lab: [f64; 3]| (lab[0], lab[1].hypot(lab[2]), lab[2].atan2(lab[1]));
                    let (one, other) = (polar(oklab(light_a)), polar(oklab(light_b)));
                    let (chroma, hue) =
                        (one.1 + t * (other.1 - one.1), turned(one.2, other.2, TAU));
                    rgb_of_oklab([
                        one.0 + t * (other.0 - one.0),
                        chroma * hue.cos(),
                        chroma * hue.sin(),
                    ])
                    .map(to_srgb)
                }
                _ => {
                    let hsv = |c: [f64; 3]| {
                        let most = c[0].max(c[1]).max(c[2]);
                        let chroma = most - c[0].min(c[1]).min(c[2]);
                        let sextant = if most == c[0] {
                            (c[1] - c[2]) / chroma
                        } else if most == c[1] {
                            2.0 + (c[2] - c[0]) / chroma
                        } else {
                            4.0 + (c[0] - c[1]) / chroma
                        };
                        [sextant.rem_euclid(6.0), chroma / most, most]
                    };
                    let (one, other) = (hsv(three(&a)), hsv(three(&b)));
                    let [_, saturation, most] = mix(one, other);
                    let hue = turned(one[0], other[0], 6.0);
                    [5.0, 3.0, 1.0].map(|n| {
                        let k: f64 = (n + hue).rem_euclid(6.0);
                        most - most * saturation * k.min(4.0 - k).clamp(0.0, 1.0)
                    })
                }
            };
            let alpha = a[3] + t * (b[3] - a[3]);
            // Colors outside of the screen's range are left out, because Newton's method here does
            // not find them.
            if wanted.iter().all(|c| (0.0..=1.0).contains(c)) {
                (0..3).for_each(|k| errors.note(got[k], wanted[k], || format!("{x}")));
            }
            errors.note(got[3], alpha, || format!("{x}"));
        }
        errors.finish();
    }
}

/// A palette gives the nearest color in Oklab, nearly equally near colors blended there, or the
/// color of a number.
#[test]
fn palettes_judge_as_eyes_do() {
    let inks = colors(7, 507);
    let at = |k: usize| 0.1 * k as f64;
    let stops: Vec<_> = inks
        .iter()
        .enumerate()
        .map(|(k, c)| serde_json::json!({"at": at(k), "color": c}))
        .collect();
    let node = |values: serde_json::Value| {
        let mut values = values;
        values["palette"] = serde_json::json!({"stops": stops});
        serde_json::json!({"id": "node", "kind": "palette", "values": values})
    };
    let asked = colors(300, 508);
    let values: Vec<_> = asked.iter().map(|c| chiaro::document::Value::Vector(c.clone())).collect();
    let labs: Vec<DVec3> = inks.iter().map(|c| oklab(three(c).map(to_linear)).into()).collect();
    let nearest = over(&node(serde_json::json!({"by": "nearest"})), "color", &values);
    let blended =
        over(&node(serde_json::json!({"by": "blended", "softness": 0.2})), "color", &values);
    let mut errors = Errors::new("palette", 3e-5);
    for ((row, nearest), blended) in asked.iter().zip(&nearest).zip(&blended) {
        let lab = DVec3::from(oklab(three(row).map(to_linear)));
        let far: Vec<f64> = labs.iter().map(|ink| ink.distance(lab)).collect();
        let least = far.iter().copied().fold(f64::MAX, f64::min);
        let found = far.iter().position(|far| *far == least).expect("one of them");
        let runner_up = far
            .iter()
            .enumerate()
            .filter(|(k, _)| *k != found)
            .map(|(_, far)| *far)
            .fold(f64::MAX, f64::min);
        if runner_up - least > 1e-5 {
            (0..3).for_each(|k| errors.note(nearest[k], inks[found][k], || format!("{row:?}")));
        }
        let weights: Vec<f64> =
            far.iter().map(|far| unit(1.0 - (far - least) / 0.2).powi(2)).collect();
        let sum: DVec3 = labs.iter().zip(&weights).map(|(lab, weight)| *lab * *weight).sum();
        let wanted = rgb_of_oklab((sum / weights.iter().sum::<f64>()).to_array());
        if wanted.iter().all(|c| (0.0..=1.0).contains(c)) {
            (0..3).for_each(|k| errors.note(blended[k], to_srgb(wanted[k]), || format!("{row:?}")));
        }
        errors.note(nearest[3], row[3], || format!("{row:?}"));
    }
    errors.finish();
    let numbers: Vec<_> = (-8..15).map(|k| chiaro::document::Value::Number(f64::from(k))).collect();
    let picked = over(&node(serde_json::json!({"by": "number"})), "number", &numbers);
    for (got, number) in picked.iter().zip(-8_i32..) {
        let wanted = &inks[number.rem_euclid(7) as usize];
        assert!((0..4).all(|k| (got[k] - wanted[k]).abs() < 1e-6), "{number}: {got:?} {wanted:?}");
    }
}

/// Curves move each channel along the common curve and then along the channel's own.
#[test]
fn curves_redraw_channels() {
    let points = |rows: &[[f64; 2]]| serde_json::json!({"points": rows});
    let (all, red, blue) =
        ([[0.0, 0.1], [0.5, 0.7], [1.0, 0.9]], [[0.0, 1.0], [1.0, 0.0]], [[0.2, 0.0], [0.6, 0.5]]);
    let node = serde_json::json!({"id": "node", "kind": "color_curves", "values":
        {"all": points(&all), "red": points(&red), "blue": points(&blue)}});
    let asked = colors(200, 509);
    let values: Vec<_> = asked.iter().map(|c| chiaro::document::Value::Vector(c.clone())).collect();
    let along = |rows: &[[f64; 2]], x: f64| {
        let x = x.clamp(rows[0][0], rows[rows.len() - 1][0]);
        let next = rows.iter().position(|row| row[0] >= x).expect("x lies within").max(1);
        let ([x0, y0], [x1, y1]) = (rows[next - 1], rows[next]);
        y0 + (x - x0) / (x1 - x0) * (y1 - y0)
    };
    let mut errors = Errors::new("color_curves", 2e-6);
    for (got, row) in over(&node, "color", &values).iter().zip(&asked) {
        let wanted = [
            along(&red, along(&all, row[0])),
            along(&all, row[1]),
            along(&blue, along(&all, row[2])),
            row[3],
        ];
        (0..4).for_each(|k| errors.note(got[k], wanted[k], || format!("{row:?}")));
    }
    errors.finish();
}

/// A bent light arrives from its new direction.
#[test]
fn a_bent_light_arrives_from_there() {
    let look = support::eval::look(&serde_json::json!({
        "lights": {"key": {"direction": [0, 0, 1], "color": [0.5, 0.25, 1.0], "intensity": 0.5}},
        "nodes": [
            {"id": "light", "kind": "light", "values": {"light": "key"}},
            {"id": "place", "kind": "position"},
            {"id": "bent", "kind": "light_toward"},
            {"id": "parts", "kind": "light_parts"},
            {"id": "output", "kind": "output"}
        ],
        "wires": [
            {"from": "light", "to": "bent.light"},
            {"from": "place", "to": "bent.direction"},
            {"from": "bent", "to": "parts.light"},
            {"from": "parts.color", "to": "output.color"}
        ]
    }));
    let at = |position: DVec3| EvalSample { position, ..EvalSample::default() };
    let places = [
        DVec3::new(3.0, 0.0, 4.0),
        DVec3::ZERO,
        DVec3::new(0.0, -1e-3, 0.0),
        DVec3::new(1e12, 0.0, 0.0),
    ];
    let got = support::eval::eval(&look, "parts.direction", &places.map(at));
    for (got, place) in got.iter().zip(places) {
        let wanted = if place == DVec3::ZERO { DVec3::Z } else { place.normalize() };
        assert!((DVec3::from_slice(got) - wanted).length() < 1e-6, "{place}: {got:?}");
    }
    let color = support::eval::eval(&look, "parts.color", &[at(DVec3::X)])[0];
    assert!((DVec3::from_slice(&color) - DVec3::new(0.5, 0.25, 1.0)).length() < 1e-6);
}
