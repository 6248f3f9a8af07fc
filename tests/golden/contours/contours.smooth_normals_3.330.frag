#version 330 core
// Contours: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Smooths normals further, from neighbors eight steps away.
// Uniform blocks (std140): CurvatureBlock 0.
// Textures: u_normals 0, u_depths 1.
// contours.json says what to put there and how to draw.
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
const ivec2 RING[8] = ivec2[8](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1), ivec2(-1, -1));
const float WEIGHTS[3] = float[3](1.0, 0.85, 0.5);

uniform sampler2D u_normals;

uniform sampler2D u_depths;

layout(std140) uniform CurvatureBlock { Curvature u_curvature; };

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

vec3 pair_of(Texel center_1, ivec2 at_2, ivec2 offset_1, float weight) {
    float _e6 = u_curvature.rows_up;
    int up = ((_e6 > 0.5) ? 1 : -1);
    ivec2 by = ivec2(offset_1.x, (up * offset_1.y));
    vec2 away = vec2(offset_1);
    vec3 _e18 = neighbor(center_1, (at_2 + by), away);
    vec3 _e22 = neighbor(center_1, (at_2 - by), -(away));
    float share = min(_e18.z, _e22.z);
    Texel _e26 = texel((at_2 + by));
    Texel _e29 = texel((at_2 - by));
    vec3 both = (_e26.normal + _e29.normal);
    return (weight * ((share * both) + (((1.0 - share) * 2.0) * center_1.normal)));
}

vec4 smoothed_at(ivec2 pixel_1, int step_) {
    ivec2 at_3 = ivec2(0);
    Texel center_2 = Texel(vec3(0.0), 0.0, 0.0);
    vec3 sum = vec3(0.0);
    at_3 = pixel_1;
    ivec2 _e3 = at_3;
    Texel _e4 = texel(_e3);
    center_2 = _e4;
    float object = center_2.object;
    float _e9 = center_2.object;
    if ((_e9 == 0.0)) {
        float _e14 = u_curvature.samples;
        if ((_e14 < 2.0)) {
            return vec4(0.0);
        }
        ivec2 _e19 = covered_near(pixel_1);
        at_3 = _e19;
        ivec2 _e20 = at_3;
        Texel _e21 = texel(_e20);
        center_2 = _e21;
        float _e23 = center_2.object;
        if ((_e23 == 0.0)) {
            return vec4(0.0);
        }
    }
    float _e30 = u_curvature.viewport_height;
    int reach = (step_ * max(int(roundEven((_e30 / 800.0))), 1));
    vec3 _e39 = center_2.normal;
    sum = (4.0 * _e39);
    vec3 _e43 = sum;
    Texel _e44 = center_2;
    ivec2 _e45 = at_3;
    vec3 _e49 = pair_of(_e44, _e45, ivec2(reach, 0), 2.0);
    sum = (_e43 + _e49);
    vec3 _e51 = sum;
    Texel _e52 = center_2;
    ivec2 _e53 = at_3;
    vec3 _e57 = pair_of(_e52, _e53, ivec2(0, reach), 2.0);
    sum = (_e51 + _e57);
    vec3 _e59 = sum;
    Texel _e60 = center_2;
    ivec2 _e61 = at_3;
    vec3 _e64 = pair_of(_e60, _e61, ivec2(reach, reach), 1.0);
    sum = (_e59 + _e64);
    vec3 _e66 = sum;
    Texel _e67 = center_2;
    ivec2 _e68 = at_3;
    vec3 _e72 = pair_of(_e67, _e68, ivec2(reach, -(reach)), 1.0);
    sum = (_e66 + _e72);
    vec3 _e74 = sum;
    float size_1 = length(_e74);
    vec3 _e77 = center_2.normal;
    vec3 _e78 = sum;
    return vec4(((size_1 > 1e-6) ? (_e78 / vec3(max(size_1, 1e-6))) : _e77), object);
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 _e4 = smoothed_at(ivec2(position.xy), 8);
    out_color = _e4;
    return;
}

