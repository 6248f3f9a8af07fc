#version 300 es
// Contours: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Smooths normals from neighbors two steps away.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_normals 1.
// contours.json says what to put there and how to draw.

precision highp float;
precision highp int;

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
struct RoughPixel {
    vec3 normal;
    float object;
    float depth;
};
uniform highp sampler2D u_surface;

layout(std140) uniform CurvatureBlock { Curvature u_curvature; };

uniform highp sampler2D u_normals;

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
    vec4 weights = clamp((vec4(2.0) - (error * scale)), vec4(0.0), vec4(1.0));
    return mix(vec4(0.0), weights, equal(objects, vec4(plane.object)));
}

RoughPixel rough_pixel(ivec2 at, int level) {
    bool local_1 = false;
    ivec2 size = ivec2(uvec2(textureSize(u_surface, 0).xy));
    if (!(any(lessThan(at, ivec2(0))))) {
        local_1 = any(greaterThanEqual(at, size));
    } else {
        local_1 = true;
    }
    bool _e15 = local_1;
    if (_e15) {
        return RoughPixel(vec3(0.0), 0.0, 0.0);
    }
    vec4 texel_2 = texelFetch(u_surface, at, 0);
    if ((level == 1)) {
        vec3 _e26 = normal_of(texel_2);
        return RoughPixel(_e26, abs(texel_2.w), texel_2.z);
    }
    vec4 _e33 = texelFetch(u_normals, at, 0);
    return RoughPixel(_e33.xyz, abs(texel_2.w), texel_2.z);
}

vec3 pairs_of(vec3 normal_1, Plane plane_1, ivec2 at_1, ivec2 first, ivec2 second, int level_1) {
    RoughPixel _e7 = rough_pixel((at_1 + first), level_1);
    RoughPixel _e9 = rough_pixel((at_1 - first), level_1);
    RoughPixel _e11 = rough_pixel((at_1 + second), level_1);
    RoughPixel _e13 = rough_pixel((at_1 - second), level_1);
    vec4 objects_1 = vec4(_e7.object, _e9.object, _e11.object, _e13.object);
    vec4 depths_1 = vec4(_e7.depth, _e9.depth, _e11.depth, _e13.depth);
    vec2 rise = vec2(dot(plane_1.rise, vec2(first)), dot(plane_1.rise, vec2(second)));
    vec4 rises_1 = vec4(rise.x, -(rise.x), rise.y, -(rise.y));
    vec4 _e40 = neighbor_weights(plane_1, objects_1, depths_1, rises_1, length(vec2(first)));
    vec2 share = min(_e40.xz, _e40.yw);
    return ((((share.x * (_e7.normal + _e9.normal)) + (((1.0 - share.x) * 2.0) * normal_1)) + (share.y * (_e11.normal + _e13.normal))) + (((1.0 - share.y) * 2.0) * normal_1));
}

vec4 smoothed_at(ivec2 pixel_1, int level_2) {
    SeenPixel _e2 = seen_pixel(pixel_1);
    ivec2 at_2 = _e2.at;
    RoughPixel _e4 = rough_pixel(at_2, level_2);
    if ((_e4.object == 0.0)) {
        return vec4(0.0);
    }
    Plane _e13 = plane_of(_e4.object, _e4.depth, _e4.normal);
    int _e17 = step_pixels();
    int reach = ((1 << uint(level_2)) * _e17);
    vec3 _e24 = pairs_of(_e4.normal, _e13, at_2, ivec2(reach, 0), ivec2(0, reach), level_2);
    vec3 _e29 = pairs_of(_e4.normal, _e13, at_2, ivec2(reach), ivec2(reach, -(reach)), level_2);
    vec3 sum = (((4.0 * _e4.normal) + (2.0 * _e24)) + _e29);
    float size_1 = length(sum);
    vec3 normal_2 = ((size_1 > 1e-6) ? (sum / vec3(max(size_1, 1e-6))) : _e4.normal);
    return vec4(normal_2, (all(equal(at_2, pixel_1)) ? _e4.object : 0.0));
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 _e4 = smoothed_at(ivec2(position.xy), 1);
    out_color = _e4;
    return;
}

