#version 300 es
// Curvature in the extent: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Finds curvature from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_normals 0, u_depths 1.
// figure4-extent.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
};
struct Texel {
    vec3 normal;
    float object;
    float depth;
};
struct Sides {
    float forward;
    float forward_weight;
    float backward;
    float backward_weight;
};
const ivec2 RING[8] = ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1), ivec2(-1, -1));
const float WEIGHTS[3] = float[3](1.0, 0.85, 0.5);

uniform highp sampler2D u_normals;

uniform highp sampler2D u_depths;

layout(std140) uniform CurvatureBlock { Curvature u_curvature; };

layout(location = 0) out float out_color;

Texel texel(ivec2 at_1) {
    bool local_1 = false;
    ivec2 size = ivec2(uvec2(textureSize(u_normals, 0).xy));
    if (!(any(lessThan(at_1, ivec2(0))))) {
        local_1 = any(greaterThanEqual(at_1, size));
    } else {
        local_1 = true;
    }
    bool _e14 = local_1;
    if (_e14) {
        return Texel(vec3(0.0), 0.0, 0.0);
    }
    vec4 normal_1 = texelFetch(u_normals, at_1, 0);
    vec4 _e27 = texelFetch(u_depths, at_1, 0);
    return Texel(normal_1.xyz, normal_1.w, _e27.x);
}

vec2 slope(vec3 normal) {
    return (normal.xy / vec2(max(normal.z, 0.2)));
}

vec3 neighbour(Texel center_1, ivec2 at_2, vec2 offset) {
    Texel _e3 = texel(at_2);
    if ((_e3.object != center_1.object)) {
        return vec3(0.0);
    }
    float _e11 = u_curvature.pixel;
    float _e15 = u_curvature.perspective;
    float pixel = (_e11 * mix(1.0, center_1.depth, _e15));
    vec2 gradient = (-(center_1.normal.xy) / vec2(max(center_1.normal.z, 0.02)));
    float expected = (dot(gradient, offset) * pixel);
    float error = abs(((center_1.depth - _e3.depth) - expected));
    float tolerance = (((2.0 * pixel) * length(offset)) * (1.0 + length(gradient)));
    float weight = clamp((2.0 - (error / max(tolerance, 1e-30))), 0.0, 1.0);
    vec2 _e52 = slope(_e3.normal);
    return vec3(_e52, weight);
}

float derivative(Sides sides) {
    float forward = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward = (sides.backward / max(sides.backward_weight, 1e-6));
    vec2 trust = vec2(smoothstep(0.0, 0.5, sides.forward_weight), smoothstep(0.0, 0.5, sides.backward_weight));
    return (((forward * trust.x) + (backward * trust.y)) / max((trust.x + trust.y), 1e-6));
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 at = ivec2(0);
    Texel center = Texel(vec3(0.0), 0.0, 0.0);
    int k = 0;
    bool local = false;
    Sides along_x = Sides(0.0, 0.0, 0.0, 0.0);
    Sides along_y = Sides(0.0, 0.0, 0.0, 0.0);
    int k_1 = 1;
    at = ivec2(position.xy);
    ivec2 _e4 = at;
    Texel _e5 = texel(_e4);
    center = _e5;
    float _e8 = center.object;
    if ((_e8 == 0.0)) {
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                int _e33 = k;
                k = (_e33 + 1);
            }
            loop_init = false;
            int _e13 = k;
            if ((_e13 < 8)) {
                float _e19 = center.object;
                local = (_e19 == 0.0);
            } else {
                local = false;
            }
            bool _e23 = local;
            if (_e23) {
            } else {
                break;
            }
            {
                int _e27 = k;
                at = (ivec2(position.xy) + RING[_e27]);
                ivec2 _e30 = at;
                Texel _e31 = texel(_e30);
                center = _e31;
            }
        }
        float _e36 = center.object;
        if ((_e36 == 0.0)) {
            out_color = 0.0;
            return;
        }
    }
    vec3 _e41 = center.normal;
    vec2 _e42 = slope(_e41);
    float _e57 = u_curvature.rows_up;
    int up = ((_e57 > 0.5) ? 1 : -1);
    float _e65 = u_curvature.viewport_height;
    int stride = max(int(roundEven((_e65 / 800.0))), 1);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e185 = k_1;
            k_1 = (_e185 + 1);
        }
        loop_init_1 = false;
        int _e74 = k_1;
        if ((_e74 <= 3)) {
        } else {
            break;
        }
        {
            int _e77 = k_1;
            int reach = (_e77 * stride);
            float distance_ = float(reach);
            int _e81 = k_1;
            float weight_1 = ((WEIGHTS[(_e81 - 1)] * distance_) * distance_);
            Texel _e87 = center;
            ivec2 _e88 = at;
            vec3 _e96 = neighbour(_e87, (_e88 + ivec2(-(reach), 0)), vec2(-(distance_), 0.0));
            Texel _e97 = center;
            ivec2 _e98 = at;
            vec3 _e104 = neighbour(_e97, (_e98 + ivec2(reach, 0)), vec2(distance_, 0.0));
            Texel _e105 = center;
            ivec2 _e106 = at;
            vec3 _e113 = neighbour(_e105, (_e106 + ivec2(0, (up * reach))), vec2(0.0, distance_));
            Texel _e114 = center;
            ivec2 _e115 = at;
            vec3 _e123 = neighbour(_e114, (_e115 - ivec2(0, (up * reach))), vec2(0.0, -(distance_)));
            float _e125 = along_x.forward;
            along_x.forward = (_e125 + (((weight_1 * _e104.z) * (_e104.x - _e42.x)) / distance_));
            float _e135 = along_x.forward_weight;
            along_x.forward_weight = (_e135 + (weight_1 * _e104.z));
            float _e140 = along_x.backward;
            along_x.backward = (_e140 + (((weight_1 * _e96.z) * (_e42.x - _e96.x)) / distance_));
            float _e150 = along_x.backward_weight;
            along_x.backward_weight = (_e150 + (weight_1 * _e96.z));
            float _e155 = along_y.forward;
            along_y.forward = (_e155 + (((weight_1 * _e113.z) * (_e113.y - _e42.y)) / distance_));
            float _e165 = along_y.forward_weight;
            along_y.forward_weight = (_e165 + (weight_1 * _e113.z));
            float _e170 = along_y.backward;
            along_y.backward = (_e170 + (((weight_1 * _e123.z) * (_e42.y - _e123.y)) / distance_));
            float _e180 = along_y.backward_weight;
            along_y.backward_weight = (_e180 + (weight_1 * _e123.z));
        }
    }
    Sides _e187 = along_x;
    float _e188 = derivative(_e187);
    Sides _e189 = along_y;
    float _e190 = derivative(_e189);
    float _e196 = u_curvature.viewport_height;
    float kappa = ((0.5 * (_e188 + _e190)) * _e196);
    out_color = clamp(kappa, -10000.0, 10000.0);
    return;
}

