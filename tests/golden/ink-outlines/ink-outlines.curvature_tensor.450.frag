#version 450 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds curvature by direction from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0.
// ink-outlines.json says what to put there and how to draw.
struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};
struct SeenPixel {
    ivec2 at;
    vec4 texel;
};
struct Plane {
    float object;
    float depth;
    vec2 rise;
    float tolerance;
};
struct Center {
    ivec2 at;
    vec2 slope;
    Plane plane;
};
struct Ring {
    vec4 x;
    vec4 y;
    vec4 weights;
};
layout(binding = 0) uniform sampler2D u_surface;

layout(std140, binding = 0) uniform CurvatureBlock { Curvature u_curvature; };

layout(location = 0) out vec4 out_color;

vec3 normal_of(vec4 texel) {
    vec2 aside = (0.2 * texel.xy);
    float rest = sqrt(max((1.0 - dot(aside, aside)), 0.0));
    float nz = ((texel.w < 0.0) ? -(rest) : rest);
    vec3 facing = (vec3(texel.xy, 1.0) / vec3(sqrt((1.0 + dot(texel.xy, texel.xy)))));
    return ((nz >= 0.2) ? facing : vec3(aside, nz));
}

int step_pixels() {
    float _e2 = u_curvature.viewport_height;
    return max(int(roundEven((_e2 / 800.0))), 1);
}

float row_direction() {
    float _e2 = u_curvature.rows_up;
    return ((_e2 > 0.5) ? 1.0 : -1.0);
}

ivec2 around(int index) {
    int side = (1 - (2 * (index & 1)));
    ivec2 straight = ((index < 2) ? ivec2(side, 0) : ivec2(0, side));
    return ((index > 3) ? ivec2(side, (1 - (index & 2))) : straight);
}

SeenPixel seen_pixel(ivec2 pixel) {
    SeenPixel seen = SeenPixel(ivec2(0), vec4(0.0));
    bool local = false;
    int index_1 = 0;
    vec4 _e3 = texelFetch(u_surface, pixel, 0);
    seen = SeenPixel(pixel, _e3);
    ivec2 last = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    float _e14 = u_curvature.samples;
    if ((_e14 >= 2.0)) {
        float _e21 = seen.texel.w;
        local = (_e21 == 0.0);
    } else {
        local = false;
    }
    bool may_be_missed = local;
    index_1 = (may_be_missed ? 7 : -1);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e47 = index_1;
            index_1 = (_e47 - 1);
        }
        loop_init = false;
        int _e30 = index_1;
        if ((_e30 >= 0)) {
        } else {
            break;
        }
        {
            int _e33 = index_1;
            ivec2 _e34 = around(_e33);
            ivec2 near = min(max((pixel + _e34), ivec2(0)), last);
            vec4 texel_1 = texelFetch(u_surface, near, 0);
            if ((texel_1.w != 0.0)) {
                seen = SeenPixel(near, texel_1);
            }
        }
    }
    SeenPixel _e49 = seen;
    return _e49;
}

Plane plane_of(float object, float depth, vec3 normal) {
    float _e5 = u_curvature.pixel;
    float _e8 = u_curvature.perspective;
    float pixel_2 = (_e5 * mix(1.0, depth, _e8));
    vec2 gradient = (normal.xy / vec2(max(normal.z, 0.02)));
    float _e19 = row_direction();
    return Plane(object, depth, ((pixel_2 * gradient) * vec2(1.0, _e19)), ((2.0 * pixel_2) * (1.0 + length(gradient))));
}

vec4 neighbor_weights(Plane plane, vec4 objects, vec4 depths, vec4 rises, float distance_) {
    vec4 error = abs(((depths - vec4(plane.depth)) - rises));
    float scale = (1.0 / max((plane.tolerance * distance_), 1e-30));
    vec4 weights_1 = clamp((vec4(2.0) - (error * scale)), vec4(0.0), vec4(1.0));
    return mix(vec4(0.0), weights_1, equal(objects, vec4(plane.object)));
}

Center center_at(ivec2 pixel_1) {
    SeenPixel _e1 = seen_pixel(pixel_1);
    vec4 texel_2 = _e1.texel;
    vec3 _e8 = normal_of(texel_2);
    Plane _e9 = plane_of(abs(texel_2.w), texel_2.z, _e8);
    return Center(_e1.at, texel_2.xy, _e9);
}

Ring ring_at(Center center, int steps, float weight) {
    int _e3 = step_pixels();
    int reach = (steps * _e3);
    float distance_1 = float(reach);
    ivec2 at = center.at;
    ivec2 last_1 = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    vec4 a_1 = texelFetch(u_surface, ivec2(min((at.x + reach), last_1.x), at.y), 0);
    vec4 b_1 = texelFetch(u_surface, ivec2(max((at.x - reach), 0), at.y), 0);
    vec4 c = texelFetch(u_surface, ivec2(at.x, min((at.y + reach), last_1.y)), 0);
    vec4 d = texelFetch(u_surface, ivec2(at.x, max((at.y - reach), 0)), 0);
    bvec4 is_inside = greaterThanEqual(ivec4((last_1.x - at.x), at.x, (last_1.y - at.y), at.y), ivec4(reach));
    vec4 objects_1 = mix(vec4(0.0), abs(vec4(a_1.w, b_1.w, c.w, d.w)), is_inside);
    vec2 rise = (distance_1 * center.plane.rise);
    vec4 rises_1 = vec4(rise.x, -(rise.x), rise.y, -(rise.y));
    vec4 _e86 = neighbor_weights(center.plane, objects_1, vec4(a_1.z, b_1.z, c.z, d.z), rises_1, distance_1);
    vec4 shares = ((weight * distance_1) * _e86);
    return Ring((shares * (vec4(a_1.x, b_1.x, c.x, d.x) - vec4(center.slope.x))), (shares * (vec4(a_1.y, b_1.y, c.y, d.y) - vec4(center.slope.y))), (shares * distance_1));
}

Ring joined(Ring a, Ring b) {
    return Ring((a.x + b.x), (a.y + b.y), (a.weights + b.weights));
}

Ring rings_at(Center center_1) {
    Ring _e3 = ring_at(center_1, 1, 1.0);
    Ring _e6 = ring_at(center_1, 2, 0.85);
    Ring _e7 = joined(_e3, _e6);
    Ring _e10 = ring_at(center_1, 3, 0.5);
    Ring _e11 = joined(_e7, _e10);
    return _e11;
}

vec2 derivatives(vec4 changes, vec4 weights) {
    vec4 trust = smoothstep(vec4(0.0), vec4(0.5), weights);
    vec4 sides = ((changes / max(weights, vec4(1e-6))) * trust);
    vec2 along = ((sides.xz - sides.yw) / max((trust.xz + trust.yw), vec2(1e-6)));
    float _e22 = row_direction();
    return (along * vec2(1.0, _e22));
}

vec3 curvature_tensor(Ring ring) {
    vec2 _e3 = derivatives(ring.x, ring.weights);
    vec2 _e6 = derivatives(ring.y, ring.weights);
    float _e17 = u_curvature.viewport_height;
    vec3 tensor = (vec3(_e3.x, (0.5 * (_e6.x + _e3.y)), _e6.y) * _e17);
    return clamp(tensor, vec3(-10000.0), vec3(10000.0));
}

void main() {
    vec4 position = gl_FragCoord;
    Center _e3 = center_at(ivec2(position.xy));
    if ((_e3.plane.object == 0.0)) {
        out_color = vec4(0.0);
        return;
    }
    Ring _e10 = rings_at(_e3);
    vec3 _e11 = curvature_tensor(_e10);
    out_color = vec4(_e11, 1.0);
    return;
}

