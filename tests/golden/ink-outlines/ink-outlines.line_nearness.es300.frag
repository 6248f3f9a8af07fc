#version 300 es
// Ink outlines: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Finds how near the nearest edges of each kind are.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_surface 0, u_edges 1, u_columns 2.
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

uniform highp sampler2D u_columns;

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

EdgeLines edges_of(vec4 codes, float levels) {
    vec4 place = floor((codes / vec4(levels)));
    vec4 turn = (((codes - (levels * place)) + vec4(0.5)) * (4.0 / levels));
    bvec4 is_back = greaterThanEqual(turn, vec4(2.0));
    vec4 x = mix((vec4(1.0) - turn), (turn - vec4(3.0)), is_back);
    vec4 rest_1 = (vec4(1.0) - abs(x));
    vec4 y = mix(rest_1, -(rest_1), is_back);
    vec4 size = sqrt(((x * x) + (y * y)));
    return EdgeLines((x / size), (y / size), (((place + vec4(0.5)) * (4.0 / levels)) - vec4(2.0)));
}

vec4 middle_distances(EdgeLines edges, vec4 columns, vec4 rows) {
    vec4 x_1 = (columns + (edges.x * edges.offset));
    vec4 y_1 = (rows + (edges.y * edges.offset));
    float inward = ((x_1.x * edges.x.x) + (y_1.x * edges.y.x));
    vec4 distances = sqrt(((x_1 * x_1) + (y_1 * y_1)));
    return vec4(((inward < -1.0) ? 1000000000.0 : distances.x), distances.yzw);
}

vec4 edge_distances(EdgeLines edges_1, vec4 columns_1, vec4 rows_1) {
    vec4 across_1 = ((edges_1.offset + (edges_1.x * columns_1)) + (edges_1.y * rows_1));
    vec4 along = abs(((edges_1.y * columns_1) - (edges_1.x * rows_1)));
    vec4 beyond = max((along - vec4(1.0)), vec4(0.0));
    vec4 side_1 = vec4(max(across_1.x, 0.0), abs(across_1.yzw));
    return sqrt(((side_1 * side_1) + (beyond * beyond)));
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

vec4 nearness_at(ivec2 pixel_1, Plane own_1) {
    vec4 nearest = vec4(1000000000.0);
    vec4 across = vec4(0.0);
    vec4 down = vec4(0.0);
    int column = 0;
    bool local_2 = false;
    ivec2 last_1 = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    float _e10 = u_curvature.viewport_height;
    float _e12 = line_reach(_e10, 16.0);
    int reach = int(_e12);
    column = max(-(reach), -(pixel_1.x));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e95 = column;
            column = (_e95 + 1);
        }
        loop_init_1 = false;
        int _e28 = column;
        if ((_e28 <= min(reach, (last_1.x - pixel_1.x)))) {
        } else {
            break;
        }
        {
            int _e34 = column;
            ivec2 at = (pixel_1 + ivec2(_e34, 0));
            vec4 found = texelFetch(u_columns, at, 0);
            if (all(equal(found, vec4(0.0)))) {
                continue;
            }
            int _e45 = column;
            if ((_e45 != 0)) {
                vec4 _e52 = texelFetch(u_surface, at, 0);
                int _e53 = column;
                bool _e57 = is_same_surface(own_1, _e52, vec2(float(_e53), 0.0));
                local_2 = !(_e57);
            } else {
                local_2 = false;
            }
            bool _e60 = local_2;
            if (_e60) {
                continue;
            }
            vec4 rows_2 = floor((found / vec4(262144.0)));
            EdgeLines _e69 = edges_of((found - (262144.0 * rows_2)), 512.0);
            vec4 places = (rows_2 - vec4(31.0));
            int _e75 = column;
            vec4 _e78 = middle_distances(_e69, vec4(float(_e75)), places);
            vec4 distances_1 = mix(vec4(1000000000.0), _e78, greaterThan(found, vec4(0.0)));
            vec4 _e83 = nearest;
            bvec4 is_nearer = lessThan(distances_1, _e83);
            vec4 _e85 = nearest;
            nearest = mix(_e85, distances_1, is_nearer);
            vec4 _e87 = across;
            int _e88 = column;
            across = mix(_e87, vec4(float(_e88)), is_nearer);
            vec4 _e92 = down;
            down = mix(_e92, places, is_nearer);
        }
    }
    vec4 _e97 = nearest;
    if (all(greaterThanEqual(_e97, vec4(1000000000.0)))) {
        return vec4(0.0);
    }
    vec4 _e105 = across;
    ivec4 x_2 = (ivec4(pixel_1.x) + ivec4(_e105));
    vec4 _e110 = down;
    ivec4 y_2 = (ivec4(pixel_1.y) + ivec4(_e110));
    vec4 _e119 = texelFetch(u_edges, ivec2(x_2.x, y_2.x), 0);
    vec4 _e126 = texelFetch(u_edges, ivec2(x_2.y, y_2.y), 0);
    vec4 _e133 = texelFetch(u_edges, ivec2(x_2.z, y_2.z), 0);
    vec4 _e140 = texelFetch(u_edges, ivec2(x_2.w, y_2.w), 0);
    vec4 codes_1 = vec4(_e119.x, _e126.y, _e133.z, _e140.w);
    EdgeLines _e144 = edges_of(codes_1, 4096.0);
    vec4 _e145 = across;
    vec4 _e146 = down;
    vec4 _e147 = edge_distances(_e144, _e145, _e146);
    vec4 nearness = clamp((vec4(float(reach)) - _e147), vec4(0.0), vec4(float(reach)));
    vec4 _e158 = nearest;
    return mix(vec4(0.0), nearness, lessThan(_e158, vec4(1000000000.0)));
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
    vec3 _e13 = normal_of(seen_1);
    Plane _e14 = plane_of(abs(seen_1.w), seen_1.z, _e13);
    vec4 _e15 = nearness_at(pixel_3, _e14);
    out_color = _e15;
    return;
}

