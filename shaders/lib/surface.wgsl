// Tangent frames, normal maps, bump maps and LitSpheres.
import chiaro::numeric;
import chiaro::total;

/// Unit tangent, bitangent and normal as columns: a mesh's tangent and bitangent stood upright on a
/// normal (Gram and Schmidt), with the handedness of the mesh. Where the tangent is missing or lies
/// along the normal, another one takes its place.
fn world_from_tangent(tangent: vec3f, bitangent: vec3f, normal: vec3f) -> mat3x3f {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let t = normalize_or(tangent, vec3f(0.0));
    let leaning = t - dot(t, n) * n;
    // Below this length the tangent's part across the normal has no direction but rounding's.
    let is_usable = dot(leaning, leaning) > 1e-8;
    let rough = normalize_or(select(any_orthogonal(n), leaning, is_usable), vec3f(1.0, 0.0, 0.0));
    // Orthogonal once more: where tangent and normal are close, the part that is left of the
    // tangent still leans along the normal.
    let upright = normalize_or(rough - dot(rough, n) * n, vec3f(1.0, 0.0, 0.0));
    let b = cross(n, upright);
    return mat3x3f(upright, select(b, -b, dot(b, bitangent) < 0.0), n);
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// A normal map's vector (x along u, y along v, z outward) as a world-space normal. A z that is not
/// positive, which no proper map has, counts as nearly flat on the surface.
fn mapped_normal(vector: vec3f, strength: f32, normal: vec3f, tangent: vec3f,
    bitangent: vec3f) -> vec3f {
    if strength == 0.0 {
        return bounded_vec3(normal);
    }
    let frame = world_from_tangent(tangent, bitangent, normal);
    let v = bounded_vec3(vector);
    let flat = bounded_vec2(v.xy * bounded(strength));
    let local = normalize_or(vec3f(flat, max(v.z, 1e-3)), vec3f(0.0, 0.0, 1.0));
    return normalize_or(frame * local, frame[2]);
}

/// The normal of a surface that is raised by a height (Mikkelsen 2010): `along_x` and `along_y`
/// hold how position (xyz) and height (w) change from pixel to pixel. Where position does not
/// change, or the surface is seen edge-on, the normal stays as it is. Slopes end at 10, which is 84
/// degrees, so that silhouettes do not sparkle.
fn bumped_normal(along_x: vec4f, along_y: vec4f, normal: vec3f) -> vec3f {
    let n = normalize_or(normal, vec3f(0.0, 0.0, 1.0));
    let x = bounded_vec4(along_x);
    let y = bounded_vec4(along_y);
    let largest = max(length_of(x.xyz), length_of(y.xyz));
    if (largest < 1e-18) | (largest > 1e18) {
        return n;
    }
    // Derivatives are measured in the larger one, so that neither tiny nor huge scenes under- or
    // overflow.
    let s = x.xyz / largest;
    let t = y.xyz / largest;
    let rise = clamp(vec2f(x.w, y.w) / largest, vec2f(-1e6), vec2f(1e6));
    let right = cross(t, n);
    let up = cross(n, s);
    let area = dot(s, right);
    if abs(area) < 1e-6 {
        return n;
    }
    let slope = (rise.x * right + rise.y * up) / area;
    let steepness = length(slope);
    let limited = slope * (min(steepness, 10.0) / max(steepness, 1e-20));
    return normalize_or(n - limited, n);
}

/// Texture coordinates at which a LitSphere picture shows the normal `n` as seen along `v` (both
/// unit, in camera axes; v toward the eye); `radius` is that of the painted ball, in texture
/// coordinates. Normals that point away fall on the rim. The second coordinate goes down.
fn litsphere_place(n: vec3f, v: vec3f, radius: f32) -> vec2f {
    let right = normalize_or(vec3f(v.z, 0.0, -v.x), vec3f(1.0, 0.0, 0.0));
    let up = cross(v, right);
    let seen = vec2f(dot(n, right), dot(n, up));
    let rim = normalize_or(vec3f(seen, 0.0), vec3f(0.0, 1.0, 0.0)).xy;
    let place = select(seen, rim, dot(n, v) < 0.0) * clamp(bounded(radius), 0.0, 0.5);
    return vec2f(0.5 + place.x, 0.5 - place.y);
}
