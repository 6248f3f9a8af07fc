// Ink outlines: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds curvature by direction from normals and depth.
// Registers of space 0: surface t0, curvature b0.
// ink-outlines.json says what to put there and how to draw.
// UNVERIFIED: no compiler of HLSL, shader model 5.1 has seen this file.

struct Curvature {
    float pixel;
    float perspective;
    float viewport_height;
    float rows_up;
    float samples;
};

struct SeenPixel {
    int2 at;
    int _pad1_0;
    int _pad1_1;
    float4 texel;
};

struct Plane {
    float object;
    float depth;
    float2 rise;
    float tolerance;
    int _end_pad_0;
};

struct Center {
    int2 at;
    float2 slope;
    Plane plane;
};

struct Ring {
    float4 x;
    float4 y;
    float4 weights;
};

Texture2D<float4> surface : register(t0);
cbuffer curvature : register(b0) { Curvature curvature; }

struct FragmentInput_fs_main {
    float4 position_1 : SV_Position;
};

float2 slope_of(float3 normal)
{
    return (normal.xy / (max(normal.z, 0.2)).xx);
}

float4 surface_texel(float3 normal_1, float depth, float number)
{
    const float2 _e3 = slope_of(normal_1);
    return float4(_e3, depth, ((normal_1.z < 0.0) ? -(number) : number));
}

float3 normal_of(float4 texel)
{
    float2 aside = (0.2 * texel.xy);
    float rest = sqrt(max((1.0 - dot(aside, aside)), 0.0));
    float nz = ((texel.w < 0.0) ? -(rest) : rest);
    float3 facing = (float3(texel.xy, 1.0) / (sqrt((1.0 + dot(texel.xy, texel.xy)))).xxx);
    return ((nz >= 0.2) ? facing : float3(aside, nz));
}

float4 whole_picture(uint index_1)
{
    return float4(((float((index_1 & 1u)) * 4.0) - 1.0), ((float((index_1 >> 1u)) * 4.0) - 1.0), 0.0, 1.0);
}

int naga_f2i32(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

int step_pixels()
{
    float _e2 = curvature.viewport_height;
    return max(naga_f2i32(round((_e2 / 800.0))), int(1));
}

float row_direction()
{
    float _e2 = curvature.rows_up;
    return ((_e2 > 0.5) ? 1.0 : -1.0);
}

int2 around(int index_2)
{
    int side = asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint((index_2 & int(1))))));
    int2 straight = ((index_2 < int(2)) ? int2(side, int(0)) : int2(int(0), side));
    return ((index_2 > int(3)) ? int2(side, asint(asuint(int(1)) - asuint((index_2 & int(2))))) : straight);
}

SeenPixel ConstructSeenPixel(int2 arg0, float4 arg1) {
    SeenPixel ret = (SeenPixel)0;
    ret.at = arg0;
    ret.texel = arg1;
    return ret;
}

uint2 NagaDimensions2D(Texture2D<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z);
    return ret.xy;
}

SeenPixel seen_pixel(int2 pixel)
{
    SeenPixel seen = (SeenPixel)0;
    bool local = (bool)0;
    int index_3 = (int)0;

    float4 _e3 = surface.Load(int3(pixel, int(0)));
    seen = ConstructSeenPixel(pixel, _e3);
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float _e14 = curvature.samples;
    if ((_e14 >= 2.0)) {
        float _e21 = seen.texel.w;
        local = (_e21 == 0.0);
    } else {
        local = false;
    }
    bool may_be_missed = local;
    index_3 = (may_be_missed ? int(7) : int(-1));
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            int _e47 = index_3;
            index_3 = asint(asuint(_e47) - asuint(int(1)));
        }
        loop_init = false;
        int _e30 = index_3;
        if ((_e30 >= int(0))) {
        } else {
            break;
        }
        {
            int _e33 = index_3;
            const int2 _e34 = around(_e33);
            int2 near = clamp(asint(asuint(pixel) + asuint(_e34)), (int(0)).xx, last);
            float4 texel_1 = surface.Load(int3(near, int(0)));
            if ((texel_1.w != 0.0)) {
                seen = ConstructSeenPixel(near, texel_1);
            }
        }
    }
    SeenPixel _e49 = seen;
    const SeenPixel seenpixel = _e49;
    return seenpixel;
}

Plane ConstructPlane(float arg0, float arg1, float2 arg2, float arg3) {
    Plane ret = (Plane)0;
    ret.object = arg0;
    ret.depth = arg1;
    ret.rise = arg2;
    ret.tolerance = arg3;
    return ret;
}

Plane plane_of(float object, float depth_1, float3 normal_2)
{
    float _e5 = curvature.pixel;
    float _e8 = curvature.perspective;
    float pixel_2 = (_e5 * lerp(1.0, depth_1, _e8));
    float2 gradient = (normal_2.xy / (max(normal_2.z, 0.02)).xx);
    const float _e19 = row_direction();
    const Plane plane_1 = ConstructPlane(object, depth_1, ((pixel_2 * gradient) * float2(1.0, _e19)), ((2.0 * pixel_2) * (1.0 + length(gradient))));
    return plane_1;
}

float4 neighbor_weights(Plane plane, float4 objects, float4 depths, float4 rises, float distance_)
{
    float4 error = abs(((depths - (plane.depth).xxxx) - rises));
    float scale = (1.0 / max((plane.tolerance * distance_), 1e-30));
    float4 weights_1 = clamp(((2.0).xxxx - (error * scale)), (0.0).xxxx, (1.0).xxxx);
    return ((objects == (plane.object).xxxx) ? weights_1 : (0.0).xxxx);
}

Center ConstructCenter(int2 arg0, float2 arg1, Plane arg2) {
    Center ret = (Center)0;
    ret.at = arg0;
    ret.slope = arg1;
    ret.plane = arg2;
    return ret;
}

Center center_at(int2 pixel_1)
{
    const SeenPixel _e1 = seen_pixel(pixel_1);
    float4 texel_2 = _e1.texel;
    const float3 _e8 = normal_of(texel_2);
    const Plane _e9 = plane_of(abs(texel_2.w), texel_2.z, _e8);
    const Center center_2 = ConstructCenter(_e1.at, texel_2.xy, _e9);
    return center_2;
}

Ring ConstructRing(float4 arg0, float4 arg1, float4 arg2) {
    Ring ret = (Ring)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.weights = arg2;
    return ret;
}

Ring ring_at(Center center_, int steps, float weight)
{
    const int _e3 = step_pixels();
    int reach = asint(asuint(steps) * asuint(_e3));
    float distance_1 = float(reach);
    int2 at = center_.at;
    int2 last_1 = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 a_1 = surface.Load(int3(int2(min(asint(asuint(at.x) + asuint(reach)), last_1.x), at.y), int(0)));
    float4 b_1 = surface.Load(int3(int2(max(asint(asuint(at.x) - asuint(reach)), int(0)), at.y), int(0)));
    float4 c = surface.Load(int3(int2(at.x, min(asint(asuint(at.y) + asuint(reach)), last_1.y)), int(0)));
    float4 d = surface.Load(int3(int2(at.x, max(asint(asuint(at.y) - asuint(reach)), int(0))), int(0)));
    bool4 is_inside = (int4(asint(asuint(last_1.x) - asuint(at.x)), at.x, asint(asuint(last_1.y) - asuint(at.y)), at.y) >= (reach).xxxx);
    float4 objects_1 = (is_inside ? abs(float4(a_1.w, b_1.w, c.w, d.w)) : (0.0).xxxx);
    float2 rise = (distance_1 * center_.plane.rise);
    float4 rises_1 = float4(rise.x, -(rise.x), rise.y, -(rise.y));
    const float4 _e86 = neighbor_weights(center_.plane, objects_1, float4(a_1.z, b_1.z, c.z, d.z), rises_1, distance_1);
    float4 shares = ((weight * distance_1) * _e86);
    const Ring ring_2 = ConstructRing((shares * (float4(a_1.x, b_1.x, c.x, d.x) - (center_.slope.x).xxxx)), (shares * (float4(a_1.y, b_1.y, c.y, d.y) - (center_.slope.y).xxxx)), (shares * distance_1));
    return ring_2;
}

Ring joined(Ring a, Ring b)
{
    const Ring ring_3 = ConstructRing((a.x + b.x), (a.y + b.y), (a.weights + b.weights));
    return ring_3;
}

Ring rings_at(Center center_1)
{
    const Ring _e3 = ring_at(center_1, int(1), 1.0);
    const Ring _e6 = ring_at(center_1, int(2), 0.85);
    const Ring _e7 = joined(_e3, _e6);
    const Ring _e10 = ring_at(center_1, int(3), 0.5);
    const Ring _e11 = joined(_e7, _e10);
    const Ring ring_4 = _e11;
    return ring_4;
}

float2 derivatives(float4 changes, float4 weights)
{
    float4 trust = smoothstep((0.0).xxxx, (0.5).xxxx, weights);
    float4 sides = ((changes / max(weights, (1e-6).xxxx)) * trust);
    float2 along = ((sides.xz - sides.yw) / max((trust.xz + trust.yw), (1e-6).xx));
    const float _e22 = row_direction();
    return (along * float2(1.0, _e22));
}

float mean_curvature(Ring ring)
{
    const float2 _e7 = derivatives(float4(ring.x.xy, ring.y.zw), ring.weights);
    float _e15 = curvature.viewport_height;
    return clamp(((0.5 * (_e7.x + _e7.y)) * _e15), -10000.0, 10000.0);
}

float3 curvature_tensor(Ring ring_1)
{
    const float2 _e3 = derivatives(ring_1.x, ring_1.weights);
    const float2 _e6 = derivatives(ring_1.y, ring_1.weights);
    float _e17 = curvature.viewport_height;
    float3 tensor = (float3(_e3.x, (0.5 * (_e6.x + _e3.y)), _e6.y) * _e17);
    return clamp(tensor, (-10000.0).xxx, (10000.0).xxx);
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    const float4 _e1 = whole_picture(index);
    return _e1;
}

int2 naga_f2i32(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput_fs_main fragmentinput_fs_main) : SV_Target0
{
    float4 position = fragmentinput_fs_main.position_1;
    const Center _e3 = center_at(naga_f2i32(position.xy));
    if ((_e3.plane.object == 0.0)) {
        return (0.0).xxxx;
    }
    const Ring _e10 = rings_at(_e3);
    const float3 _e11 = curvature_tensor(_e10);
    return float4(_e11, 1.0);
}
