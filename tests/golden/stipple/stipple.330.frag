#version 330 core
// Stipple: made by Chiaro 0.1.0, GLSL 3.30.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// stipple.json says what to put there and how to draw.
struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    vec4 eye;
    vec4 screen;
};
struct Object {
    mat4x4 world_from_object;
    mat3x3 world_from_normal;
    float id;
    float cutoff;
};
struct Light {
    vec3 direction;
    vec3 own_direction;
    vec3 color;
    float intensity;
};
struct Look {
    vec2 viewport;
    Light key;
};
struct Surface {
    vec3 normal;
    vec3 view;
    vec2 pixel;
    vec3 anchor;
};
struct StretchedPlace {
    vec2 place;
    vec3 stretch;
};
struct SpacedPlace {
    vec2 place;
    vec3 stretch;
};
struct Dots {
    float size;
    float scatter;
    uint seed;
};
struct MarkPlace {
    vec2 place;
    vec3 stretch;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};
const float MOST_ON_SCREEN = 1000000000000000.0;
const uint BLUE_TILE[256] = uint[256](667461202u, 222158680u, 3599544829u, 3400820132u, 1960937795u, 3151603007u, 3761895051u, 3016954793u, 3028509185u, 1370102158u, 1462902626u, 3847357677u, 3003882522u, 276701840u, 231368623u, 2006207090u, 1155071538u, 3687541486u, 3161497478u, 679646994u, 1446404781u, 3813141710u, 2689801524u, 3286574331u, 259137950u, 2016058421u, 3494113793u, 4072945787u, 3187332206u, 1537109014u, 2146407874u, 2252103613u, 3518847723u, 3259693184u, 649323030u, 1163634939u, 1266356881u, 99953797u, 759419764u, 349023492u, 2911980200u, 2478200582u, 1284463928u, 534579558u, 3925975738u, 2990393258u, 1759908999u, 1834015888u, 490397740u, 3894597990u, 450210671u, 780651677u, 3630055399u, 3680670750u, 3097971750u, 200505374u, 3329882762u, 1118013679u, 880871624u, 1370517989u, 882493816u, 4279260018u, 4166634395u, 3063496755u, 2617859282u, 2098278479u, 4082379517u, 4262674112u, 3035961957u, 2092688515u, 2198433333u, 459523542u, 1864745286u, 3764170964u, 2360777576u, 3583509087u, 1208519335u, 1141296937u, 412283055u, 2162906274u, 2397675830u, 3154310974u, 568005963u, 662629447u, 1824806967u, 1737401583u, 3209287968u, 2919246195u, 1689588085u, 2508440857u, 2759315255u, 1320339052u, 2531113449u, 3897891643u, 3881906118u, 3734238779u, 3779853656u, 594649900u, 4195069169u, 2400968242u, 2048396402u, 2142884959u, 2810905498u, 3446256911u, 2030405680u, 1407926991u, 1497467748u, 2741044869u, 2902213326u, 940438317u, 3497589837u, 558138450u, 2562381738u, 3624513114u, 3454479296u, 4047290265u, 1268613673u, 1839237321u, 706533552u, 2635391933u, 473590768u, 2132249590u, 1974537886u, 1809994019u, 131816119u, 367010917u, 1816157632u, 3311532182u, 693207050u, 1030670564u, 359026175u, 243050998u, 3996488734u, 4114970559u, 2783809586u, 1199125766u, 2697125778u, 548751459u, 987862474u, 3593571538u, 376555508u, 2824442290u, 3699183309u, 668184405u, 1962677596u, 3718656769u, 3095473755u, 1453017346u, 1384726958u, 2164275940u, 3259639657u, 3119089951u, 2259435674u, 2373710293u, 1906634250u, 652919904u, 3517252966u, 3583833888u, 4288133099u, 1779514224u, 1461859275u, 1766899984u, 625196569u, 1988368634u, 2117074619u, 1311621987u, 73415959u, 4082016718u, 3102530169u, 4215154833u, 3662992026u, 3476795794u, 2564442129u, 2326557451u, 866745058u, 129139429u, 1867080845u, 2882332575u, 143226423u, 2689655089u, 1488293862u, 263931372u, 2432027222u, 3240843546u, 3490490398u, 58744344u, 3345278498u, 1577938342u, 422996513u, 1811621323u, 3158777762u, 4181778023u, 2096118101u, 2411480113u, 4094931789u, 3388571206u, 1990652296u, 2453243103u, 175452119u, 2541015454u, 3028731363u, 3563649246u, 3210452975u, 766941219u, 1308999746u, 39689649u, 4001738984u, 11478607u, 1335569003u, 254321927u, 1015492467u, 3595895001u, 4183849746u, 1288836910u, 3325977534u, 3129078806u, 492895508u, 3360986485u, 1763434305u, 2844554986u, 2396691176u, 2096263111u, 2497450024u, 1211522983u, 1070377692u, 2192501207u, 3432446392u, 474559661u, 1176713325u, 2721888012u, 827588237u, 2379146864u, 3106697228u, 1580667530u, 240165635u, 3506421341u, 2884483674u, 484660868u, 2109975402u, 1470046212u, 1290966655u, 3508860775u, 4034538350u, 143860869u, 1695776161u, 3375405011u, 3611626218u, 3242325943u, 132266269u, 2478733985u, 398739172u, 812899647u, 734220276u, 1298203644u, 1553540471u, 3983027847u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

float exp2_stable(float x) {
    float whole = roundEven(x);
    float f = (x - whole);
    float twice = (2.0 + (f * (1.3862944 + (f * (0.48045295 + (f * (0.11100665 + (f * (0.019236874 + (f * (0.002679775 + (f * 0.00030706724))))))))))));
    return (twice * uintBitsToFloat((uint((int(whole) + 126)) << 23u)));
}

float log2_stable(float x_1) {
    uint bits = floatBitsToUint(x_1);
    int exponent = (int((bits - 1060439283u)) >> 23u);
    float mantissa = uintBitsToFloat((bits - (uint(exponent) << 23u)));
    float z = ((mantissa - 1.0) / (mantissa + 1.0));
    float z2_ = (z * z);
    return (float(exponent) + (z * (2.88539 + (z2_ * (0.96179885 + (z2_ * (0.57671434 + (z2_ * 0.4317379))))))));
}

vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return ((square > 1e-30) ? (v * inversesqrt(max(square, 1e-30))) : otherwise);
}

vec3 normalize_seen(vec3 v_1) {
    vec3 _e5 = normalize_moderate(v_1, vec3(0.0, 0.0, 1.0));
    return _e5;
}

float bounded(float x_2) {
    uint bits_1 = floatBitsToUint(x_2);
    uint magnitude = (bits_1 & 2147483647u);
    float largest = uintBitsToFloat(((bits_1 & 2147483648u) | 2139095039u));
    return ((magnitude < 2139095040u) ? x_2 : ((magnitude == 2139095040u) ? largest : 0.0));
}

float eased(float x_3, float low, float high) {
    float _e3 = bounded(x_3);
    float _e7 = bounded(((_e3 - low) / 0.75));
    float t = clamp(_e7, 0.0, 1.0);
    return ((t * t) * (3.0 - (2.0 * t)));
}

uvec3 hash_pcg3d(uvec3 seed) {
    uvec3 v_2 = uvec3(0u);
    v_2 = ((seed * 1664525u) + uvec3(1013904223u));
    uint _e8 = v_2.x;
    uint _e10 = v_2.y;
    uint _e12 = v_2.z;
    v_2.x = (_e8 + (_e10 * _e12));
    uint _e16 = v_2.y;
    uint _e18 = v_2.z;
    uint _e20 = v_2.x;
    v_2.y = (_e16 + (_e18 * _e20));
    uint _e24 = v_2.z;
    uint _e26 = v_2.x;
    uint _e28 = v_2.y;
    v_2.z = (_e24 + (_e26 * _e28));
    uvec3 _e31 = v_2;
    uvec3 _e32 = v_2;
    v_2 = (_e31 ^ (_e32 >> uvec3(16u)));
    uint _e38 = v_2.x;
    uint _e40 = v_2.y;
    uint _e42 = v_2.z;
    v_2.x = (_e38 + (_e40 * _e42));
    uint _e46 = v_2.y;
    uint _e48 = v_2.z;
    uint _e50 = v_2.x;
    v_2.y = (_e46 + (_e48 * _e50));
    uint _e54 = v_2.z;
    uint _e56 = v_2.x;
    uint _e58 = v_2.y;
    v_2.z = (_e54 + (_e56 * _e58));
    uvec3 _e61 = v_2;
    return _e61;
}

float size_on_screen(float depth, float perspective, float scale) {
    return min(((0.5 * scale) / mix(1.0, max(depth, 1e-6), perspective)), MOST_ON_SCREEN);
}

vec3 anchor_on_screen(vec3 origin, float perspective_1, float scale_1) {
    float _e5 = size_on_screen(-(origin.z), perspective_1, scale_1);
    return clamp(vec3((origin.x * _e5), (-(origin.y) * _e5), _e5), vec3(-1000000000000000.0), vec3(1000000000000000.0));
}

vec2 place_in_picture(vec2 pixel, vec2 viewport) {
    vec2 from_middle = (pixel - (0.5 * viewport));
    return (vec2(from_middle.x, -(from_middle.y)) / vec2(max(viewport.y, 1.0)));
}

float disk_filtered(float d, float r, float w) {
    if ((w < 1e-30)) {
        return (((d <= r) && (r > 0.0)) ? 1.0 : 0.0);
    }
    float square_1 = (r * r);
    float least = ((w * w) / 3.0);
    float inner = sqrt((max(square_1, least) - (0.25 * least)));
    return (clamp((0.5 + ((inner - d) / w)), 0.0, 1.0) * min((square_1 / least), 1.0));
}

uint blue_index(ivec2 cell) {
    uvec2 at_1 = (uvec2(cell) & uvec2(31u));
    return ((8u * at_1.y) + (at_1.x >> 2u));
}

StretchedPlace mark_place_of(vec2 place, vec3 along, vec3 across, float angle) {
    vec2 turn = vec2(0.0, 1.0);
    vec3 x_4 = ((turn.y * along) + (turn.x * across));
    vec3 y = ((turn.y * across) - (turn.x * along));
    vec2 turned = vec2(((turn.y * place.x) + (turn.x * place.y)), ((turn.y * place.y) - (turn.x * place.x)));
    vec3 stretch_4 = vec3(dot(x_4, x_4), dot(x_4, y), dot(y, y));
    return StretchedPlace(turned, stretch_4);
}

SpacedPlace spaced(vec2 place_1, vec3 stretch, vec2 viewport_1, float count) {
    bool is_pixel = !(((stretch.x + stretch.z) > 0.0));
    float scale_2 = (is_pixel ? (count / max(viewport_1.y, 1.0)) : count);
    vec2 p = clamp((place_1 * scale_2), vec2(-4194304.0), vec2(4194304.0));
    return SpacedPlace(p, (is_pixel ? vec3(1.0, 0.0, 1.0) : stretch));
}

float area_square(vec3 stretch_1) {
    float sum_1 = (stretch_1.x + stretch_1.z);
    return max(((stretch_1.x * stretch_1.z) - (stretch_1.y * stretch_1.y)), ((sum_1 * sum_1) / 66.0));
}

float picture_square(vec2 offset, vec3 stretch_2) {
    float _e2 = area_square(stretch_2);
    float area = max(_e2, 1e-30);
    float square_2 = ((((stretch_2.z * offset.x) * offset.x) - (((2.0 * stretch_2.y) * offset.x) * offset.y)) + ((stretch_2.x * offset.y) * offset.y));
    return (max(square_2, 0.0) / area);
}

float dots_of_octave(vec2 place_2, int zoom, float ink, vec3 stretch_3, float w_1, Dots style) {
    int i = 0;
    float sum = 0.0;
    uint tile[256] = BLUE_TILE;
    vec2 p_1 = clamp((place_2 * uintBitsToFloat((uint((zoom + 127)) << 23u))), vec2(-4194304.0), vec2(4194304.0));
    vec2 corner = floor(p_1);
    float reach = (1.0 - (0.5 * style.scatter));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e118 = i;
            i = (_e118 + 1);
        }
        loop_init = false;
        int _e30 = i;
        if (!((_e30 < 9))) {
            break;
        }
        int _e35 = i;
        int _e40 = i;
        ivec2 cell_1 = (ivec2(corner) + ivec2(((_e35 % 3) - 1), ((_e40 / 3) - 1)));
        uvec3 _e54 = hash_pcg3d((uvec3(ivec3(cell_1, zoom)) + uvec3(0u, 0u, 0u)));
        vec3 chance = (vec3((_e54 >> uvec3(8u))) * 5.9604645e-8);
        vec2 middle = ((vec2(cell_1) + vec2(0.5)) + (style.scatter * (chance.xy - vec2(0.5))));
        vec2 offset_1 = (p_1 - middle);
        ivec2 turning = (cell_1 + ivec2(0, (zoom * 7)));
        uint _e78 = blue_index(turning);
        uint _e80 = tile[_e78];
        float turn_1 = (0.96875 * ((float(((_e80 >> (8u * (uint(turning.x) & 3u))) & 255u)) + 0.5) * 0.00390625));
        float grown = clamp(((ink - turn_1) * 32.0), 0.0, 1.0);
        float radius = ((0.5 * style.size) * sqrt(grown));
        float far = (length(offset_1) / reach);
        float _e110 = picture_square(offset_1, stretch_3);
        float d_1 = max(sqrt(_e110), ((far * far) * radius));
        float _e115 = sum;
        float _e116 = disk_filtered(d_1, radius, w_1);
        sum = max(_e115, _e116);
    }
    float _e121 = sum;
    return _e121;
}

float stippled(SpacedPlace at, float ink_1, Dots style_1) {
    float dots = 0.0;
    vec2 dx = dFdx(at.place);
    vec2 dy = dFdy(at.place);
    float _e8 = picture_square(dx, at.stretch);
    float _e10 = picture_square(dy, at.stretch);
    float _e13 = bounded(sqrt(max(_e8, _e10)));
    float _e15 = area_square(at.stretch);
    float _e19 = log2_stable(max(sqrt(_e15), 1e-30));
    float level = clamp((-0.5 * _e19), -16.0, 16.0);
    float zoom_1 = floor(level);
    float f_1 = (level - zoom_1);
    float _e29 = exp2_stable((-2.0 * f_1));
    float coarse = (1.0 - f_1);
    float fine = ((1.0 - (coarse * _e29)) / (4.0 * _e29));
    float _e44 = exp2_stable((2.0 * zoom_1));
    float _e46 = dots_of_octave(at.place, int(zoom_1), (ink_1 * coarse), (at.stretch * _e44), _e13, style_1);
    dots = _e46;
    if ((fine > 0.0)) {
        float _e60 = exp2_stable(((2.0 * zoom_1) + 2.0));
        float _e62 = dots_of_octave(at.place, (int(zoom_1) + 1), (ink_1 * fine), (at.stretch * _e60), _e13, style_1);
        float _e63 = dots;
        dots = max(_e63, _e62);
    }
    float mean = (ink_1 * ((0.7853982 * style_1.size) * style_1.size));
    float _e71 = dots;
    float _e74 = eased(_e13, 0.75, 1.5);
    return mix(_e71, mean, _e74);
}

MarkPlace mark_place_object(float angle_1, vec3 anchor, vec2 pixel_1, vec2 viewport_2) {
    float size = clamp(anchor.z, 1e-6, 1000000.0);
    vec2 _e8 = place_in_picture(pixel_1, viewport_2);
    vec2 place_3 = ((_e8 - vec2(anchor.x, -(anchor.y))) / vec2(size));
    StretchedPlace _e26 = mark_place_of(place_3, vec3((1.0 / size), 0.0, 0.0), vec3(0.0, (1.0 / size), 0.0), angle_1);
    return MarkPlace(_e26.place, _e26.stretch);
}

vec4 shade(Surface surface) {
    vec3 _e5 = u_look.key.direction;
    float light_and_shade = max(((dot(surface.normal, _e5) + 0.3) / 1.3), 0.0);
    float facing = clamp(dot(surface.normal, surface.view), 0.0, 1.0);
    float darker_at_the_rim = min(((facing - 0.0) / 0.55), 1.0);
    float tone_to_draw = min((((light_and_shade * darker_at_the_rim) - 0.0) / 0.85), 1.0);
    vec2 _e37 = u_look.viewport;
    MarkPlace _e38 = mark_place_object(0.0, surface.anchor, surface.pixel, _e37);
    vec2 _e43 = u_look.viewport;
    SpacedPlace _e45 = spaced(_e38.place, _e38.stretch, _e43, 210.0);
    float _e52 = stippled(_e45, (1.0 - tone_to_draw), Dots(0.85, 0.8, 0u));
    vec4 ink_on_paper = mix(vec4(0.965, 0.95, 0.915, 1.0), vec4(0.09, 0.12, 0.22, 1.0), _e52);
    return ink_on_paper;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 _e3 = normalize_seen(in_.normal);
    vec3 normal = (is_front ? _e3 : -(_e3));
    vec4 _e8 = u_view.eye;
    float _e13 = u_view.eye.w;
    vec4 _e22 = u_view.screen;
    vec4 _e27 = u_view.screen;
    mat4x4 _e32 = u_view.camera_from_world;
    vec4 _e36 = u_object.world_from_object[3];
    float _e45 = u_view.eye.w;
    float _e50 = u_view.clip_from_world[0][1];
    float _e55 = u_view.clip_from_world[1][1];
    float _e60 = u_view.clip_from_world[2][1];
    vec3 _e63 = anchor_on_screen((_e32 * vec4(_e36.xyz, 1.0)).xyz, _e45, length(vec3(_e50, _e55, _e60)));
    Surface surface_1 = Surface(normal, normalize((_e8.xyz - (_e13 * in_.position))), ((in_.clip.xy * _e22.xy) + _e27.zw), _e63);
    vec4 _e65 = shade(surface_1);
    out_color = _e65;
    return;
}

