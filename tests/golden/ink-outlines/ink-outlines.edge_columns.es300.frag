#version 300 es
// Ink outlines: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Finds the nearest edges in each pixel's column.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_edges 1.
// ink-outlines.json says what to put there and how to draw.

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
struct EdgeLines {
    vec4 x;
    vec4 y;
    vec4 offset;
};
const float PI = 3.1415927;
const float HALF_PI = 1.5707964;
const float LN_2_ = 0.6931472;
const float LOG2_E = 1.442695;
const float SMALLEST_NORMAL = 1.1754944e-38;

uniform highp sampler2D u_surface;

layout(std140) uniform CurvatureBlock { Curvature u_curvature; };

uniform highp sampler2D u_edges;

layout(location = 0) out vec4 out_color;

vec3 normal_of(vec4 texel) {
    vec2 aside = (0.2 * texel.xy);
    float rest = sqrt(max((1.0 - dot(aside, aside)), 0.0));
    float nz = ((texel.w < 0.0) ? -(rest) : rest);
    vec3 facing = (vec3(texel.xy, 1.0) / vec3(sqrt((1.0 + dot(texel.xy, texel.xy)))));
    return ((nz >= 0.2) ? facing : vec3(aside, nz));
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
            vec4 texel_2 = texelFetch(u_surface, near, 0);
            if ((texel_2.w != 0.0)) {
                seen = SeenPixel(near, texel_2);
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

float object_in(float number) {
    return floor(abs(number));
}

vec4 coarse_codes(vec4 codes) {
    vec4 place = floor((codes / vec4(4096.0)));
    vec4 direction = (codes - (4096.0 * place));
    return ((floor((place * 0.125)) * 512.0) + floor((direction * 0.125)));
}

EdgeLines edges_of(vec4 codes_1, float levels) {
    vec4 place_1 = floor((codes_1 / vec4(levels)));
    vec4 turn = (((codes_1 - (levels * place_1)) + vec4(0.5)) * (4.0 / levels));
    bvec4 is_back = greaterThanEqual(turn, vec4(2.0));
    vec4 x = mix((vec4(1.0) - turn), (turn - vec4(3.0)), is_back);
    vec4 rest_1 = (vec4(1.0) - abs(x));
    vec4 y = mix(rest_1, -(rest_1), is_back);
    vec4 size = sqrt(((x * x) + (y * y)));
    return EdgeLines((x / size), (y / size), (((place_1 + vec4(0.5)) * (4.0 / levels)) - vec4(2.0)));
}

vec4 middle_distances(EdgeLines edges, vec4 columns, vec4 rows) {
    vec4 x_1 = (columns + (edges.x * edges.offset));
    vec4 y_1 = (rows + (edges.y * edges.offset));
    float inward = ((x_1.x * edges.x.x) + (y_1.x * edges.y.x));
    vec4 distances = sqrt(((x_1 * x_1) + (y_1 * y_1)));
    return vec4(((inward < -1.0) ? 1000000000.0 : distances.x), distances.yzw);
}

float line_reach(float viewport_height, float steps) {
    return min((steps * max(roundEven((viewport_height / 800.0)), 1.0)), 31.0);
}

bool is_same_surface(Plane own, vec4 texel_1, vec2 offset) {
    bool local_1 = false;
    float error = abs(((texel_1.z - own.depth) - dot(own.rise, offset)));
    float _e11 = object_in(texel_1.w);
    float _e13 = object_in(own.object);
    if ((_e11 == _e13)) {
        local_1 = (error <= ((3.0 * own.tolerance) * max(length(offset), 1.0)));
    } else {
        local_1 = false;
    }
    bool _e26 = local_1;
    return _e26;
}

vec4 nearest_in_column(ivec2 pixel_1, Plane own_1, int reach) {
    vec4 nearest = vec4(1000000000.0);
    vec4 codes_2 = vec4(0.0);
    int row = 0;
    ivec2 last_1 = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    row = max(-(reach), -(pixel_1.y));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e76 = row;
            row = (_e76 + 1);
        }
        loop_init_1 = false;
        int _e20 = row;
        if ((_e20 <= min(reach, (last_1.y - pixel_1.y)))) {
        } else {
            break;
        }
        {
            int _e26 = row;
            ivec2 at = (pixel_1 + ivec2(0, _e26));
            vec4 found = texelFetch(u_edges, at, 0);
            if (all(equal(found, vec4(0.0)))) {
                continue;
            }
            vec4 _e39 = texelFetch(u_surface, at, 0);
            int _e40 = row;
            bool _e44 = is_same_surface(own_1, _e39, vec2(0.0, float(_e40)));
            if (!(_e44)) {
                continue;
            }
            EdgeLines _e49 = edges_of(found, 4096.0);
            int _e52 = row;
            vec4 _e55 = middle_distances(_e49, vec4(0.0), vec4(float(_e52)));
            vec4 distances_1 = mix(vec4(1000000000.0), _e55, greaterThan(found, vec4(0.0)));
            vec4 _e60 = nearest;
            bvec4 is_nearer = lessThan(distances_1, _e60);
            vec4 _e62 = nearest;
            nearest = mix(_e62, distances_1, is_nearer);
            vec4 _e64 = codes_2;
            vec4 _e65 = coarse_codes(found);
            int _e66 = row;
            codes_2 = mix(_e64, (_e65 + vec4((262144.0 * (float(_e66) + 31.0)))), is_nearer);
        }
    }
    vec4 _e78 = codes_2;
    return _e78;
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel_3 = ivec2(position.xy);
    SeenPixel _e3 = seen_pixel(pixel_3);
    vec4 seen_1 = _e3.texel;
    if ((seen_1.w == 0.0)) {
        out_color = vec4(0.0);
        return;
    }
    float _e12 = u_curvature.viewport_height;
    float _e14 = line_reach(_e12, 16.0);
    vec3 _e18 = normal_of(seen_1);
    Plane _e19 = plane_of(abs(seen_1.w), seen_1.z, _e18);
    vec4 _e21 = nearest_in_column(pixel_3, _e19, int(_e14));
    out_color = _e21;
    return;
}

