#version 450 core
// Clay relief: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds curvature by direction from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_normals 0, u_depths 1.
// clay-relief.json says what to put there and how to draw.
struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};
struct Texel {
    vec3 normal;
    float object;
    float depth;
};
struct SideDifferences {
    float forward;
    float forward_weight;
    float backward;
    float backward_weight;
};
const ivec2 RING[8] = ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1), ivec2(-1, -1));
const float WEIGHTS[3] = float[3](1.0, 0.85, 0.5);

layout(binding = 0) uniform sampler2D u_normals;

layout(binding = 1) uniform sampler2D u_depths;

layout(std140, binding = 0) uniform CurvatureBlock { Curvature u_curvature; };

layout(location = 0) out vec4 out_color;

Texel texel(ivec2 at) {
    bool local = false;
    ivec2 size = ivec2(uvec2(textureSize(u_normals, 0).xy));
    if (!(any(lessThan(at, ivec2(0))))) {
        local = any(greaterThanEqual(at, size));
    } else {
        local = true;
    }
    bool _e14 = local;
    if (_e14) {
        return Texel(vec3(0.0), 0.0, 0.0);
    }
    vec4 normal_1 = texelFetch(u_normals, at, 0);
    vec4 _e27 = texelFetch(u_depths, at, 0);
    return Texel(normal_1.xyz, normal_1.w, _e27.x);
}

vec2 slope(vec3 normal) {
    return (normal.xy / vec2(max(normal.z, 0.2)));
}

vec3 neighbor(Texel center, ivec2 at_1, vec2 offset) {
    Texel _e3 = texel(at_1);
    if ((_e3.object != center.object)) {
        return vec3(0.0);
    }
    float _e11 = u_curvature.pixel;
    float _e15 = u_curvature.perspective;
    float pixel_2 = (_e11 * mix(1.0, center.depth, _e15));
    vec2 gradient = (-(center.normal.xy) / vec2(max(center.normal.z, 0.02)));
    float expected = (dot(gradient, offset) * pixel_2);
    float error = abs(((center.depth - _e3.depth) - expected));
    float tolerance = (((2.0 * pixel_2) * length(offset)) * (1.0 + length(gradient)));
    float weight_1 = clamp((2.0 - (error / max(tolerance, 1e-30))), 0.0, 1.0);
    vec2 _e52 = slope(_e3.normal);
    return vec3(_e52, weight_1);
}

float derivative(SideDifferences sides) {
    float forward_1 = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward_1 = (sides.backward / max(sides.backward_weight, 1e-6));
    vec2 trust = vec2(smoothstep(0.0, 0.5, sides.forward_weight), smoothstep(0.0, 0.5, sides.backward_weight));
    return (((forward_1 * trust.x) + (backward_1 * trust.y)) / max((trust.x + trust.y), 1e-6));
}

ivec2 covered_near(ivec2 pixel) {
    ivec2 found = ivec2(0);
    int k = 7;
    ivec2 most = (ivec2(uvec2(textureSize(u_normals, 0).xy)) - ivec2(1));
    found = pixel;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e27 = k;
            k = (_e27 - 1);
        }
        loop_init = false;
        int _e10 = k;
        if ((_e10 >= 0)) {
        } else {
            break;
        }
        {
            int _e14 = k;
            ivec2 near = min(max((pixel + RING[_e14]), ivec2(0)), most);
            vec4 _e22 = texelFetch(u_normals, near, 0);
            if ((_e22.w != 0.0)) {
                found = near;
            }
        }
    }
    ivec2 _e29 = found;
    return _e29;
}

vec3 slope_change(Texel center_1, vec2 here, ivec2 at_2, vec2 offset_1, float weight) {
    vec3 _e5 = neighbor(center_1, at_2, offset_1);
    float sign_ = (((offset_1.x + offset_1.y) > 0.0) ? 1.0 : -1.0);
    return ((weight * _e5.z) * vec3(((sign_ * (_e5.xy - here)) / vec2(length(offset_1))), 1.0));
}

vec2 slope_derivative(vec3 forward, vec3 backward) {
    float _e7 = derivative(SideDifferences(forward.x, forward.z, backward.x, backward.z));
    float _e13 = derivative(SideDifferences(forward.y, forward.z, backward.y, backward.z));
    return vec2(_e7, _e13);
}

vec3 tensor_at(ivec2 pixel_1) {
    ivec2 at_3 = ivec2(0);
    Texel center_2 = Texel(vec3(0.0), 0.0, 0.0);
    vec3 right = vec3(0.0);
    vec3 left = vec3(0.0);
    vec3 above = vec3(0.0);
    vec3 below = vec3(0.0);
    int k_1 = 1;
    at_3 = pixel_1;
    ivec2 _e2 = at_3;
    Texel _e3 = texel(_e2);
    center_2 = _e3;
    float _e6 = center_2.object;
    if ((_e6 == 0.0)) {
        float _e11 = u_curvature.samples;
        if ((_e11 < 2.0)) {
            return vec3(0.0);
        }
        ivec2 _e16 = covered_near(pixel_1);
        at_3 = _e16;
        ivec2 _e17 = at_3;
        Texel _e18 = texel(_e17);
        center_2 = _e18;
        float _e20 = center_2.object;
        if ((_e20 == 0.0)) {
            return vec3(0.0);
        }
    }
    vec3 _e26 = center_2.normal;
    vec2 _e27 = slope(_e26);
    float _e30 = u_curvature.rows_up;
    int up = ((_e30 > 0.5) ? 1 : -1);
    float _e38 = u_curvature.viewport_height;
    int stride = max(int(roundEven((_e38 / 800.0))), 1);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e117 = k_1;
            k_1 = (_e117 + 1);
        }
        loop_init_1 = false;
        int _e59 = k_1;
        if ((_e59 <= 3)) {
        } else {
            break;
        }
        {
            int _e62 = k_1;
            int reach = (_e62 * stride);
            float distance_ = float(reach);
            int _e66 = k_1;
            float weight_2 = ((WEIGHTS[(_e66 - 1)] * distance_) * distance_);
            vec3 _e72 = right;
            Texel _e73 = center_2;
            ivec2 _e74 = at_3;
            vec3 _e80 = slope_change(_e73, _e27, (_e74 + ivec2(reach, 0)), vec2(distance_, 0.0), weight_2);
            right = (_e72 + _e80);
            vec3 _e82 = left;
            Texel _e83 = center_2;
            ivec2 _e84 = at_3;
            vec3 _e91 = slope_change(_e83, _e27, (_e84 - ivec2(reach, 0)), vec2(-(distance_), 0.0), weight_2);
            left = (_e82 + _e91);
            vec3 _e93 = above;
            Texel _e94 = center_2;
            ivec2 _e95 = at_3;
            vec3 _e102 = slope_change(_e94, _e27, (_e95 + ivec2(0, (up * reach))), vec2(0.0, distance_), weight_2);
            above = (_e93 + _e102);
            vec3 _e104 = below;
            Texel _e105 = center_2;
            ivec2 _e106 = at_3;
            vec3 _e114 = slope_change(_e105, _e27, (_e106 - ivec2(0, (up * reach))), vec2(0.0, -(distance_)), weight_2);
            below = (_e104 + _e114);
        }
    }
    vec3 _e119 = right;
    vec3 _e120 = left;
    vec2 _e121 = slope_derivative(_e119, _e120);
    vec3 _e122 = above;
    vec3 _e123 = below;
    vec2 _e124 = slope_derivative(_e122, _e123);
    float _e135 = u_curvature.viewport_height;
    vec3 tensor = (vec3(_e121.x, (0.5 * (_e121.y + _e124.x)), _e124.y) * _e135);
    return clamp(tensor, vec3(-10000.0), vec3(10000.0));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 _e3 = tensor_at(ivec2(position.xy));
    out_color = vec4(_e3, 1.0);
    return;
}

