#version 450 core
// Ink outlines: made by Chiaro 0.1.0, GLSL 4.50.
// The fragment shader. Finds where surfaces end, fold and meet.
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
struct Facet {
    vec3 normal;
    vec3 toward;
    float depth;
    float number;
    vec2 rise;
    vec2 gentle_rise;
};
struct Edge {
    int kind;
    vec2 normal;
    float offset;
    float trust;
};
struct Course {
    float place;
    float slope;
    float trust;
};
struct CourseSums {
    float count;
    float x;
    float y;
    float xx;
    float xy;
    float yy;
    float xxy;
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

float row_direction() {
    float _e2 = u_curvature.rows_up;
    return ((_e2 > 0.5) ? 1.0 : -1.0);
}

ivec2 around(int index) {
    int side_1 = (1 - (2 * (index & 1)));
    ivec2 straight = ((index < 2) ? ivec2(side_1, 0) : ivec2(0, side_1));
    return ((index > 3) ? ivec2(side_1, (1 - (index & 2))) : straight);
}

float object_in(float number) {
    return floor(abs(number));
}

float edge_code(vec2 normal, float offset) {
    float share = (normal.x / max((abs(normal.x) + abs(normal.y)), 1e-20));
    float turn = ((normal.y >= 0.0) ? (1.0 - share) : (3.0 + share));
    float direction = min(floor((turn * 1024.0)), 4095.0);
    float place = floor(((clamp(offset, -1.99, 1.99) + 2.0) * 1024.0));
    return ((place * 4096.0) + direction);
}

float pixel_size_at(float depth) {
    float _e3 = u_curvature.pixel;
    float _e6 = u_curvature.perspective;
    return (_e3 * mix(1.0, depth, _e6));
}

Facet facet_at(ivec2 at) {
    vec4 texel_1 = texelFetch(u_surface, at, 0);
    vec3 _e4 = normal_of(texel_1);
    vec2 middle = (0.5 * vec2(uvec2(textureSize(u_surface, 0).xy)));
    float _e15 = row_direction();
    vec2 from_middle = (((vec2(at) + vec2(0.5)) - middle) * vec2(1.0, _e15));
    float _e21 = u_curvature.pixel;
    float _e25 = u_curvature.perspective;
    vec3 toward_2 = vec3(((-(_e21) * _e25) * from_middle), 1.0);
    float facing_1 = dot(_e4, toward_2);
    float _e32 = pixel_size_at(texel_1.z);
    float _e35 = row_direction();
    vec2 change_1 = ((_e32 * _e4.xy) * vec2(1.0, _e35));
    return Facet(_e4, toward_2, texel_1.z, abs(texel_1.w), (change_1 / vec2(max(facing_1, 0.02))), (change_1 / vec2(max(facing_1, 0.2))));
}

bool meets(Facet own, Facet other, vec2 step_) {
    bool local = false;
    bool is_nearer = (own.depth <= other.depth);
    float rise = dot((is_nearer ? own.gentle_rise : own.rise), step_);
    float other_rise = dot((is_nearer ? other.rise : other.gentle_rise), step_);
    float here = (own.depth - (other.depth - other_rise));
    float there = ((own.depth + rise) - other.depth);
    float steepness = min(length(own.gentle_rise), length(other.gentle_rise));
    float _e30 = pixel_size_at(min(own.depth, other.depth));
    float tolerance = (_e30 + steepness);
    if (!(((here * there) <= 0.0))) {
        local = (min(abs(here), abs(there)) <= tolerance);
    } else {
        local = true;
    }
    bool _e43 = local;
    return _e43;
}

bool shows(ivec2 at_1, float number_1, float limit) {
    bool local_1 = false;
    ivec2 last = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    vec4 texel_2 = texelFetch(u_surface, min(max(at_1, ivec2(0)), last), 0);
    if ((abs(texel_2.w) == number_1)) {
        local_1 = (texel_2.z < limit);
    } else {
        local_1 = false;
    }
    bool _e23 = local_1;
    return _e23;
}

Course fitted_course(CourseSums sums, bool is_arc) {
    float trust_1 = (sums.count / 11.0);
    float spread = ((sums.count * sums.xx) - (sums.x * sums.x));
    float slope_1 = (((sums.count * sums.xy) - (sums.x * sums.y)) / spread);
    float straight_1 = ((sums.y - (slope_1 * sums.x)) / sums.count);
    if ((trust_1 < 1.0)) {
        return Course(clamp(straight_1, 0.0, 1.0), slope_1, trust_1);
    }
    float bent = (((1958.0 * sums.y) - (sums.xx * sums.xxy)) / ((sums.count * 1958.0) - (sums.xx * sums.xx)));
    float left_1 = (((sums.yy - (straight_1 * sums.y)) - (slope_1 * sums.xy)) / sums.count);
    float share_1 = clamp(((left_1 - 0.09) / 0.05), 0.0, 1.0);
    return Course(clamp(mix(straight_1, bent, (is_arc ? 1.0 : share_1)), 0.0, 1.0), slope_1, trust_1);
}

Course course_at(ivec2 pixel, ivec2 step_1, float number_2, float limit_1) {
    vec2 ends[2] = vec2[2](vec2(0.0), vec2(0.0));
    int changes = 0;
    CourseSums sums_1 = CourseSums(1.0, 0.0, 0.5, 0.0, 0.0, 0.25, 0.0);
    int side = 0;
    int height = 0;
    bool is_open = false;
    int row = 0;
    bool local_2 = false;
    bool local_3 = false;
    int change = 0;
    bool local_4 = false;
    bool local_5 = false;
    bool local_6 = false;
    bool local_7 = false;
    bool local_8 = false;
    bool local_9 = false;
    ivec2 along = abs(step_1.yx);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e177 = side;
            side = (_e177 + 1);
        }
        loop_init = false;
        int _e25 = side;
        if ((_e25 < 2)) {
        } else {
            break;
        }
        {
            int _e28 = side;
            ivec2 way = (along * (1 - (2 * _e28)));
            height = 0;
            is_open = true;
            row = 1;
            while(true) {
                int _e40 = row;
                if ((_e40 <= 12)) {
                    bool _e45 = is_open;
                    if (!(_e45)) {
                        int _e49 = row;
                        local_3 = (_e49 <= 5);
                    } else {
                        local_3 = true;
                    }
                    bool _e53 = local_3;
                    local_2 = _e53;
                } else {
                    local_2 = false;
                }
                bool _e55 = local_2;
                if (_e55) {
                } else {
                    break;
                }
                {
                    int _e56 = row;
                    int _e59 = height;
                    ivec2 at_2 = ((pixel + (way * _e56)) + (step_1 * _e59));
                    change = 0;
                    bool _e64 = shows(at_2, number_2, limit_1);
                    if (_e64) {
                        bool _e66 = shows((at_2 + step_1), number_2, limit_1);
                        if (_e66) {
                            change = 1;
                        }
                    } else {
                        change = -1;
                    }
                    int _e69 = change;
                    if ((_e69 > 0)) {
                        bool _e77 = shows((at_2 + (2 * step_1)), number_2, limit_1);
                        local_4 = _e77;
                    } else {
                        local_4 = false;
                    }
                    bool _e79 = local_4;
                    if (_e79) {
                        break;
                    }
                    int _e80 = change;
                    if ((_e80 < 0)) {
                        bool _e86 = shows((at_2 - step_1), number_2, limit_1);
                        local_5 = !(_e86);
                    } else {
                        local_5 = false;
                    }
                    bool _e89 = local_5;
                    if (_e89) {
                        break;
                    }
                    int _e90 = change;
                    if ((_e90 != 0)) {
                        bool _e93 = is_open;
                        if (_e93) {
                            int _e94 = side;
                            int _e96 = row;
                            int _e100 = height;
                            int _e101 = height;
                            int _e102 = change;
                            ends[_e94] = vec2((float(_e96) - 0.5), float(max(_e100, (_e101 + _e102))));
                            is_open = false;
                        }
                        int _e108 = changes;
                        int _e109 = row;
                        changes = (_e108 + ((_e109 <= 5) ? 1 : 0));
                        int _e116 = height;
                        int _e117 = change;
                        height = (_e116 + _e117);
                    }
                    int _e119 = row;
                    if ((_e119 <= 5)) {
                        int _e122 = row;
                        int _e123 = side;
                        float x = float((_e122 * (1 - (2 * _e123))));
                        int _e130 = height;
                        float y = (float(_e130) + 0.5);
                        float _e135 = sums_1.count;
                        sums_1.count = (_e135 + 1.0);
                        float _e139 = sums_1.x;
                        sums_1.x = (_e139 + x);
                        float _e142 = sums_1.y;
                        sums_1.y = (_e142 + y);
                        float _e145 = sums_1.xx;
                        sums_1.xx = (_e145 + (x * x));
                        float _e149 = sums_1.xy;
                        sums_1.xy = (_e149 + (x * y));
                        float _e153 = sums_1.yy;
                        sums_1.yy = (_e153 + (y * y));
                        float _e157 = sums_1.xxy;
                        sums_1.xxy = (_e157 + ((x * x) * y));
                    }
                    int _e162 = row;
                    row = (_e162 + 1);
                }
            }
            bool _e164 = is_open;
            if (_e164) {
                int _e165 = side;
                int _e167 = row;
                int _e171 = height;
                ends[_e165] = vec2((float(_e167) - 0.5), (float(_e171) + 0.5));
            }
        }
    }
    float _e181 = ends[0].x;
    float _e184 = ends[1].x;
    float length_ = (_e181 + _e184);
    float _e188 = ends[0].y;
    float _e191 = ends[1].y;
    float slope_2 = ((_e188 - _e191) / length_);
    float _e196 = ends[1].y;
    float _e199 = ends[1].x;
    float place_1 = (_e196 + (slope_2 * _e199));
    float _e204 = ends[0].y;
    float _e207 = ends[1].y;
    if ((_e204 == _e207)) {
        local_6 = (place_1 != 0.5);
    } else {
        local_6 = false;
    }
    bool is_arc_1 = local_6;
    int _e215 = changes;
    if (!((_e215 >= 3))) {
        if (is_arc_1) {
            int _e223 = changes;
            local_8 = (_e223 >= 2);
        } else {
            local_8 = false;
        }
        bool _e227 = local_8;
        local_7 = _e227;
    } else {
        local_7 = true;
    }
    bool _e229 = local_7;
    if (_e229) {
        float _e233 = sums_1.count;
        local_9 = (_e233 >= 7.0);
    } else {
        local_9 = false;
    }
    bool _e237 = local_9;
    if (_e237) {
        CourseSums _e238 = sums_1;
        Course _e239 = fitted_course(_e238, is_arc_1);
        return _e239;
    }
    float _e242 = ends[0].x;
    float _e247 = ends[1].x;
    float rise_1 = (is_arc_1 ? (((4.0 * _e242) * _e247) / (length_ * length_)) : 0.0);
    float _e254 = sums_1.count;
    float trust_2 = (_e254 / 11.0);
    return Course(clamp(mix(place_1, 0.5, rise_1), 0.0, 1.0), slope_2, trust_2);
}

float facing_squared(Facet facet) {
    float facing_2 = dot(facet.normal, facet.toward);
    return ((facing_2 * abs(facing_2)) / dot(facet.toward, facet.toward));
}

vec2 course_normal(Course course, vec2 toward) {
    vec2 along_1 = abs(toward.yx);
    return ((toward - (course.slope * along_1)) / vec2(sqrt((1.0 + (course.slope * course.slope)))));
}

Edge edge_along(int kind, Course course_1, vec2 toward_1, vec2 normal_1) {
    float lean = dot(normal_1, toward_1);
    return Edge(kind, normal_1, (course_1.place * lean), (course_1.trust * lean));
}

Edge silhouette(Facet own_1, ivec2 pixel_1, ivec2 step_2, float limit_2) {
    bool local_10 = false;
    bool local_11 = false;
    bool local_12 = false;
    vec2 toward_3 = vec2(step_2);
    Course _e6 = course_at(pixel_1, step_2, own_1.number, limit_2);
    ivec2 last_1 = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    Facet _e17 = facet_at(min(max((pixel_1 - step_2), ivec2(0)), last_1));
    float _e18 = facing_squared(own_1);
    float _e19 = facing_squared(_e17);
    float change_2 = (_e19 - _e18);
    float _e23 = row_direction();
    vec2 across = (own_1.normal.xy * vec2(1.0, _e23));
    vec2 normal_2 = (across / vec2(max(length(across), 1e-6)));
    if ((_e17.number == own_1.number)) {
        local_10 = (_e18 < 0.36);
    } else {
        local_10 = false;
    }
    bool _e40 = local_10;
    if (_e40) {
        local_11 = (change_2 > 0.0001);
    } else {
        local_11 = false;
    }
    bool _e46 = local_11;
    if (_e46) {
        local_12 = (dot(normal_2, toward_3) > 0.5);
    } else {
        local_12 = false;
    }
    bool is_round = local_12;
    float found = (_e18 / max(change_2, 0.0001));
    float place_2 = clamp(found, 0.0, 1.0);
    float trust_3 = (is_round ? clamp((2.0 - (4.0 * abs((found - place_2)))), 0.0, 1.0) : 0.0);
    Course seen = Course(mix(_e6.place, place_2, trust_3), _e6.slope, mix(_e6.trust, 1.0, trust_3));
    vec2 _e78 = course_normal(_e6, toward_3);
    vec2 turned = mix(_e78, normal_2, trust_3);
    Edge _e84 = edge_along(0, seen, toward_3, (turned / vec2(length(turned))));
    return _e84;
}

float round_bend(Facet own_2, Facet other_1, ivec2 pixel_2, ivec2 step_3) {
    ivec2 last_2 = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    vec4 before = texelFetch(u_surface, min(max((pixel_2 - step_3), ivec2(0)), last_2), 0);
    vec4 after = texelFetch(u_surface, min(max((pixel_2 + (2 * step_3)), ivec2(0)), last_2), 0);
    vec3 _e26 = normal_of(before);
    vec3 _e30 = normal_of(after);
    vec2 bends = vec2(length((_e26 - own_2.normal)), length((_e30 - other_1.normal)));
    vec2 numbers = vec2(abs(before.w), abs(after.w));
    vec2 shares = mix(vec2(0.0), vec2(1.0), equal(numbers, vec2(own_2.number)));
    return (dot(bends, shares) / max((shares.x + shares.y), 1.0));
}

Edge edge_between(Facet own_3, ivec2 pixel_3, ivec2 step_4) {
    bool local_13 = false;
    bool local_14 = false;
    Edge none = Edge(-1, vec2(0.0), 0.0, 0.0);
    ivec2 at_3 = (pixel_3 + step_4);
    if (!(any(lessThan(at_3, ivec2(0))))) {
        local_13 = any(greaterThanEqual(at_3, ivec2(uvec2(textureSize(u_surface, 0).xy))));
    } else {
        local_13 = true;
    }
    bool _e23 = local_13;
    if (_e23) {
        return none;
    }
    Facet _e24 = facet_at(at_3);
    if ((_e24.number == 0.0)) {
        Edge _e29 = silhouette(own_3, pixel_3, step_4, 1000000000.0);
        return _e29;
    }
    vec2 toward_4 = vec2(step_4);
    float _e32 = object_in(own_3.number);
    float _e34 = object_in(_e24.number);
    bool is_same_object = (_e32 == _e34);
    bool _e36 = meets(own_3, _e24, toward_4);
    if (!(_e36)) {
        if ((own_3.depth > _e24.depth)) {
            return none;
        }
        float middle_1 = (0.5 * (own_3.depth + _e24.depth));
        Edge _e48 = silhouette(own_3, pixel_3, step_4, (is_same_object ? middle_1 : 1000000000.0));
        return _e48;
    }
    if (!(is_same_object)) {
        return Edge(2, vec2(0.0), 0.0, 0.0);
    }
    if ((own_3.number != _e24.number)) {
        return Edge(3, vec2(0.0), 0.0, 0.0);
    }
    float bend = length((own_3.normal - _e24.normal));
    if (!((bend < 0.5176381))) {
        float _e74 = round_bend(own_3, _e24, pixel_3, step_4);
        local_14 = ((bend - _e74) < 0.5176381);
    } else {
        local_14 = true;
    }
    bool _e79 = local_14;
    if (_e79) {
        return none;
    }
    return Edge(1, vec2(0.0), 0.0, 0.0);
}

Edge meeting(Facet own_4, ivec2 pixel_4, ivec2 step_5, int kind_1) {
    bool local_15 = false;
    Facet _e5 = facet_at((pixel_4 + step_5));
    vec2 toward_5 = vec2(step_5);
    vec2 slope_3 = (own_4.rise - _e5.rise);
    float steepness_1 = length(slope_3);
    float here_1 = (own_4.depth - (_e5.depth - dot(_e5.rise, toward_5)));
    float side_2 = dot(slope_3, toward_5);
    float _e20 = pixel_size_at(own_4.depth);
    if ((abs(side_2) > (0.1 * _e20))) {
        local_15 = (abs(side_2) > (0.3 * steepness_1));
    } else {
        local_15 = false;
    }
    bool _e31 = local_15;
    if (_e31) {
        float share_2 = clamp((-(here_1) / side_2), 0.0, 1.0);
        vec2 normal_3 = (slope_3 / vec2(((side_2 > 0.0) ? steepness_1 : -(steepness_1))));
        float lean_1 = dot(normal_3, toward_5);
        return Edge(kind_1, normal_3, (share_2 * lean_1), lean_1);
    }
    if ((kind_1 == 1)) {
        return Edge(kind_1, toward_5, 0.5, 0.0);
    }
    Course _e53 = course_at(pixel_4, step_5, own_4.number, 1000000000.0);
    vec2 _e54 = course_normal(_e53, toward_5);
    Edge _e55 = edge_along(kind_1, _e53, toward_5, _e54);
    return _e55;
}

bool goes_on(Facet own_5, vec2 slope, float size, ivec2 pixel_5, ivec2 step_6) {
    bool local_16 = false;
    bool local_17 = false;
    ivec2 last_3 = (ivec2(uvec2(textureSize(u_surface, 0).xy)) - ivec2(1));
    vec4 texel_3 = texelFetch(u_surface, min(max((pixel_5 + step_6), ivec2(0)), last_3), 0);
    vec2 change_3 = abs((texel_3.xy - slope));
    float error = abs(((texel_3.z - own_5.depth) - dot(own_5.gentle_rise, vec2(step_6))));
    if ((abs(texel_3.w) == own_5.number)) {
        local_16 = (error <= size);
    } else {
        local_16 = false;
    }
    bool _e37 = local_16;
    if (_e37) {
        local_17 = (max(change_3.x, change_3.y) < 0.35);
    } else {
        local_17 = false;
    }
    bool _e46 = local_17;
    return _e46;
}

vec4 edges_at(ivec2 pixel_6) {
    uint left = 0u;
    int index_1 = 0;
    vec4 codes = vec4(0.0);
    vec4 trust = vec4(-1.0);
    int index_2 = 0;
    Edge edge = Edge(0, vec2(0.0), 0.0, 0.0);
    Facet _e1 = facet_at(pixel_6);
    if ((_e1.number == 0.0)) {
        return vec4(0.0);
    }
    vec4 _e9 = texelFetch(u_surface, pixel_6, 0);
    vec2 slope_4 = _e9.xy;
    float _e12 = pixel_size_at(_e1.depth);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e32 = index_1;
            index_1 = (_e32 + 1);
        }
        loop_init_1 = false;
        int _e17 = index_1;
        if ((_e17 < 4)) {
        } else {
            break;
        }
        {
            uint _e20 = left;
            int _e22 = index_1;
            int _e26 = index_1;
            ivec2 _e27 = around(_e26);
            bool _e28 = goes_on(_e1, slope_4, _e12, pixel_6, _e27);
            left = (_e20 | (_e28 ? 0u : (1u << uint(_e22))));
        }
    }
    uint _e40 = left;
    index_2 = ((_e40 == 0u) ? 4 : 0);
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e102 = index_2;
            index_2 = (_e102 + 1);
        }
        loop_init_2 = false;
        int _e47 = index_2;
        if ((_e47 < 4)) {
        } else {
            break;
        }
        {
            uint _e50 = left;
            int _e51 = index_2;
            if ((((_e50 >> uint(_e51)) & 1u) == 0u)) {
                continue;
            }
            int _e58 = index_2;
            ivec2 _e59 = around(_e58);
            Edge _e60 = edge_between(_e1, pixel_6, _e59);
            edge = _e60;
            int _e63 = edge.kind;
            if ((_e63 == -1)) {
                continue;
            }
            int _e67 = edge.kind;
            if ((_e67 != 0)) {
                int _e71 = edge.kind;
                Edge _e72 = meeting(_e1, pixel_6, _e59, _e71);
                edge = _e72;
            }
            int _e74 = edge.kind;
            bvec4 is_kind = equal(ivec4(_e74), ivec4(0, 1, 2, 3));
            float _e83 = edge.trust;
            vec4 _e85 = trust;
            bvec4 is_better = bvec4(is_kind.x && greaterThan(vec4(_e83), _e85).x, is_kind.y && greaterThan(vec4(_e83), _e85).y, is_kind.z && greaterThan(vec4(_e83), _e85).z, is_kind.w && greaterThan(vec4(_e83), _e85).w);
            vec4 _e88 = trust;
            float _e90 = edge.trust;
            trust = mix(_e88, vec4(_e90), is_better);
            vec4 _e93 = codes;
            vec2 _e95 = edge.normal;
            float _e97 = edge.offset;
            float _e98 = edge_code(_e95, _e97);
            codes = mix(_e93, vec4(_e98), is_better);
        }
    }
    vec4 _e104 = codes;
    return _e104;
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 _e3 = edges_at(ivec2(position.xy));
    out_color = _e3;
    return;
}

