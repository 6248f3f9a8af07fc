#version 450 core
// Manga, contours: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds curvature from normals and depth.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_normals 0, u_depths 1.
// figure6-manga-contours.json says what to put there and how to draw.
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

layout(location = 0) out float out_color;

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
    float weight = clamp((2.0 - (error / max(tolerance, 1e-30))), 0.0, 1.0);
    vec2 _e52 = slope(_e3.normal);
    return vec3(_e52, weight);
}

float derivative(SideDifferences sides) {
    float forward = (sides.forward / max(sides.forward_weight, 1e-6));
    float backward = (sides.backward / max(sides.backward_weight, 1e-6));
    vec2 trust = vec2(smoothstep(0.0, 0.5, sides.forward_weight), smoothstep(0.0, 0.5, sides.backward_weight));
    return (((forward * trust.x) + (backward * trust.y)) / max((trust.x + trust.y), 1e-6));
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

float curvature_at(ivec2 pixel_1, int first, int last) {
    ivec2 at_2 = ivec2(0);
    Texel center_1 = Texel(vec3(0.0), 0.0, 0.0);
    SideDifferences along_x = SideDifferences(0.0, 0.0, 0.0, 0.0);
    SideDifferences along_y = SideDifferences(0.0, 0.0, 0.0, 0.0);
    int k_1 = 0;
    at_2 = pixel_1;
    ivec2 _e4 = at_2;
    Texel _e5 = texel(_e4);
    center_1 = _e5;
    float _e8 = center_1.object;
    if ((_e8 == 0.0)) {
        float _e13 = u_curvature.samples;
        if ((_e13 < 2.0)) {
            return 0.0;
        }
        ivec2 _e17 = covered_near(pixel_1);
        at_2 = _e17;
        ivec2 _e18 = at_2;
        Texel _e19 = texel(_e18);
        center_1 = _e19;
        float _e21 = center_1.object;
        if ((_e21 == 0.0)) {
            return 0.0;
        }
    }
    vec3 _e26 = center_1.normal;
    vec2 _e27 = slope(_e26);
    float _e42 = u_curvature.rows_up;
    int up = ((_e42 > 0.5) ? 1 : -1);
    float _e50 = u_curvature.viewport_height;
    int stride = max(int(roundEven((_e50 / 800.0))), 1);
    k_1 = first;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e168 = k_1;
            k_1 = (_e168 + 1);
        }
        loop_init_1 = false;
        int _e58 = k_1;
        if ((_e58 <= last)) {
        } else {
            break;
        }
        {
            int _e60 = k_1;
            int reach = (_e60 * stride);
            float distance_ = float(reach);
            int _e64 = k_1;
            float weight_1 = ((WEIGHTS[(_e64 - 1)] * distance_) * distance_);
            Texel _e70 = center_1;
            ivec2 _e71 = at_2;
            vec3 _e79 = neighbor(_e70, (_e71 + ivec2(-(reach), 0)), vec2(-(distance_), 0.0));
            Texel _e80 = center_1;
            ivec2 _e81 = at_2;
            vec3 _e87 = neighbor(_e80, (_e81 + ivec2(reach, 0)), vec2(distance_, 0.0));
            Texel _e88 = center_1;
            ivec2 _e89 = at_2;
            vec3 _e96 = neighbor(_e88, (_e89 + ivec2(0, (up * reach))), vec2(0.0, distance_));
            Texel _e97 = center_1;
            ivec2 _e98 = at_2;
            vec3 _e106 = neighbor(_e97, (_e98 - ivec2(0, (up * reach))), vec2(0.0, -(distance_)));
            float _e108 = along_x.forward;
            along_x.forward = (_e108 + (((weight_1 * _e87.z) * (_e87.x - _e27.x)) / distance_));
            float _e118 = along_x.forward_weight;
            along_x.forward_weight = (_e118 + (weight_1 * _e87.z));
            float _e123 = along_x.backward;
            along_x.backward = (_e123 + (((weight_1 * _e79.z) * (_e27.x - _e79.x)) / distance_));
            float _e133 = along_x.backward_weight;
            along_x.backward_weight = (_e133 + (weight_1 * _e79.z));
            float _e138 = along_y.forward;
            along_y.forward = (_e138 + (((weight_1 * _e96.z) * (_e96.y - _e27.y)) / distance_));
            float _e148 = along_y.forward_weight;
            along_y.forward_weight = (_e148 + (weight_1 * _e96.z));
            float _e153 = along_y.backward;
            along_y.backward = (_e153 + (((weight_1 * _e106.z) * (_e27.y - _e106.y)) / distance_));
            float _e163 = along_y.backward_weight;
            along_y.backward_weight = (_e163 + (weight_1 * _e106.z));
        }
    }
    SideDifferences _e170 = along_x;
    float _e171 = derivative(_e170);
    SideDifferences _e172 = along_y;
    float _e173 = derivative(_e172);
    float _e179 = u_curvature.viewport_height;
    float kappa = ((0.5 * (_e171 + _e173)) * _e179);
    return clamp(kappa, -10000.0, 10000.0);
}

void main() {
    vec4 position = gl_FragCoord;
    float _e5 = curvature_at(ivec2(position.xy), 1, 3);
    out_color = _e5;
    return;
}

