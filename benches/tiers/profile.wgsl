import chiaro::profile;

fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn angle_here(n: vec3f) -> Angle {
    return Angle(sqrt(0.5 - 0.5 * n.x), sqrt(0.5 + 0.5 * n.x));
}

/// Profile with offset (tau) 0.2, fall-off 0.9 and cut-off 1.8; the compiler knows no value of it.
fn shape_here() -> ProfileShape {
    let zero = f32(repeats.y);
    return ProfileShape(0.99500416 + zero, 0.0998334 + zero, 1.39466 + zero, 2.6 + zero, 0.2 + zero,
        0.75, 0.31, repeats.y);
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    let warped = angle_shifted(angle_here(n), s);
    return profile_filtered(warped, angle_footprint(warped), shape_here());
}

fn power_series(q: f32, exponent: f32) -> f32 {
    return select(clamp(exp2(max(exponent * log2_one_minus(q * q), -126.0)), 0.0, 1.0), 0.0,
        q >= 1.0);
}

fn power_hardware(q: f32, exponent: f32) -> f32 {
    return clamp(pow(max(1.0 - q * q, 0.0), exponent), 0.0, 1.0);
}

fn point_series(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if s <= 0.0 || shape.kind == PROFILE_AMBIENT {
        return 1.0;
    }
    if shape.kind == PROFILE_STEP {
        return select(0.0, 1.0, s <= 4e-7);
    }
    return power_series(s * shape.scale, shape.exponent);
}

fn point_hardware(u: Angle, shape: ProfileShape) -> f32 {
    let s = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    if s <= 0.0 || shape.kind == PROFILE_AMBIENT {
        return 1.0;
    }
    if shape.kind == PROFILE_STEP {
        return select(0.0, 1.0, s <= 4e-7);
    }
    return power_hardware(s * shape.scale, shape.exponent);
}

fn ramp_here(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    return clamp(0.5 + (shape.offset + shape.edge_mean - angle_radians(u)) / width, 0.0, 1.0);
}

/// Profile by pow in place of the log1p form, filtered as the exact one.
fn hardware_pow(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_shifted(angle_here(n), s);
    let w = angle_footprint(u);
    let shape = shape_here();
    if w >= 3.46410162 * shape.edge_deviation {
        return ramp_here(u, w, shape);
    }
    let point = point_hardware(u, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let before = point_hardware(angle_shifted(u, 0.387298335 * w), shape);
    let after = point_hardware(angle_shifted(u, -0.387298335 * w), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// Profile by the hardware's log2 and exp2 with a series near 0, filtered as the exact one.
fn series(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_shifted(angle_here(n), s);
    let w = angle_footprint(u);
    let shape = shape_here();
    if w >= 3.46410162 * shape.edge_deviation {
        return ramp_here(u, w, shape);
    }
    let point = point_series(u, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let before = point_series(angle_shifted(u, 0.387298335 * w), shape);
    let after = point_series(angle_shifted(u, -0.387298335 * w), shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

/// Profile without quadrature: a ramp if the edge is narrower than the pixel, else the value at the
/// point.
fn series_without_gauss(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_shifted(angle_here(n), s);
    let w = angle_footprint(u);
    let shape = shape_here();
    if w >= 3.46410162 * shape.edge_deviation {
        return ramp_here(u, w, shape);
    }
    return point_series(u, shape);
}

fn hardware_pow_without_gauss(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_shifted(angle_here(n), s);
    let w = angle_footprint(u);
    let shape = shape_here();
    if w >= 3.46410162 * shape.edge_deviation {
        return ramp_here(u, w, shape);
    }
    return point_hardware(u, shape);
}

fn exact_without_gauss(n: vec3f, l: vec3f, s: f32) -> f32 {
    let u = angle_shifted(angle_here(n), s);
    let w = angle_footprint(u);
    let shape = shape_here();
    if w >= 3.46410162 * shape.edge_deviation {
        return ramp_here(u, w, shape);
    }
    return profile_point(u, shape);
}

/// Profile by short polynomials for the rotation and the hardware's power, with hard edges.
fn not_filtered(n: vec3f, l: vec3f, s: f32) -> f32 {
    return point_series(angle_shifted(angle_here(n), s), shape_here());
}

fn short_shift(u: Angle, shift: f32) -> Angle {
    let h = 0.5 * clamp(shift, -PI, PI);
    let h2 = h * h;
    let a = h * (1.0 + h2 * (-0.166666 + h2 * (0.00831 - h2 * 0.000184)));
    let b = 1.0 + h2 * (-0.49999 + h2 * (0.04158 - h2 * 0.0012706));
    return Angle(clamp(u.half_sin * b - u.half_cos * a, 0.0, 1.0),
        clamp(u.half_cos * b + u.half_sin * a, 0.0, 1.0));
}

/// Profile by all short forms, and a step filtered by a ramp in the half-sine alone: no inverse
/// trigonometry anywhere.
fn short_forms(n: vec3f, l: vec3f, s: f32) -> f32 {
    let shape = shape_here();
    let u = short_shift(angle_here(n), s);
    let x = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    let w = 2.0 * (abs(dpdx(x)) + abs(dpdy(x)));
    if shape.kind == PROFILE_SOFT && w < 3.46410162 * shape.edge_deviation {
        return select(power_series(x * shape.scale, shape.exponent), 1.0, x <= 0.0);
    }
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    let edge = clamp(0.5 + (shape.edge_mean - 2.0 * x) / max(width, 1e-6), 0.0, 1.0);
    return select(edge, 1.0, shape.kind == PROFILE_AMBIENT);
}

/// Profile by all short forms, with pow.
fn short_forms_pow(n: vec3f, l: vec3f, s: f32) -> f32 {
    let shape = shape_here();
    let u = short_shift(angle_here(n), s);
    let x = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    let w = 2.0 * (abs(dpdx(x)) + abs(dpdy(x)));
    if shape.kind == PROFILE_SOFT && w < 3.46410162 * shape.edge_deviation {
        return select(power_hardware(x * shape.scale, shape.exponent), 1.0, x <= 0.0);
    }
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    let edge = clamp(0.5 + (shape.edge_mean - 2.0 * x) / max(width, 1e-6), 0.0, 1.0);
    return select(edge, 1.0, shape.kind == PROFILE_AMBIENT);
}

var<private> table: array<vec4f, 16> = array<vec4f, 16>(
    vec4f(1.0, 0.99, 0.98, 0.97), vec4f(0.96, 0.95, 0.94, 0.93), vec4f(0.92, 0.91, 0.9, 0.89),
        vec4f(0.88, 0.87, 0.86, 0.85),
    vec4f(0.84, 0.83, 0.82, 0.81), vec4f(0.8, 0.79, 0.78, 0.77), vec4f(0.76, 0.75, 0.74, 0.73),
        vec4f(0.72, 0.71, 0.7, 0.69),
    vec4f(0.68, 0.67, 0.66, 0.65), vec4f(0.64, 0.63, 0.62, 0.61), vec4f(0.6, 0.59, 0.58, 0.57),
        vec4f(0.56, 0.55, 0.54, 0.53),
    vec4f(0.5, 0.45, 0.4, 0.35), vec4f(0.3, 0.25, 0.2, 0.17), vec4f(0.15, 0.1, 0.08, 0.05),
        vec4f(0.04, 0.02, 0.01, 0.0),
);

/// Profile from a table of 64 values in an array, looked up by the half-sine, with linear
/// interpolation.
fn table_of_64(n: vec3f, l: vec3f, s: f32) -> f32 {
    let shape = shape_here();
    let u = angle_shifted(angle_here(n), s);
    let x = u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset;
    let at = clamp(x * shape.scale, 0.0, 1.0) * 63.0;
    let i = u32(at);
    let j = min(i + 1u, 63u);
    return mix(table[i / 4u][i % 4u], table[j / 4u][j % 4u], at - f32(i));
}

fn kept_balanced(n: vec3f, l: vec3f, s: f32) -> f32 {
    let warped = angle_turned(angle_here(n), sin_cos_quick(0.5 * clamp(s, -PI, PI)));
    return profile_filtered_quick(warped, angle_footprint(warped), shape_here());
}

fn kept_fast(n: vec3f, l: vec3f, s: f32) -> f32 {
    return profile_ramped(angle_turned(angle_here(n), sin_cos_short(0.5 * clamp(s, -PI, PI))),
        shape_here());
}
