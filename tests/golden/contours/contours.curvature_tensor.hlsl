// Contours: made by Chiaro 0.1.0, HLSL, shader model 5.1.
// Finds curvature by direction from normals and depth.
// Registers of space 0: surface t0, curvature b0.
// contours.json says what to put there and how to draw.

struct Curvature {
    /// The size of a pixel in scene units: at depth 1 for perspective, at every depth for parallel
    /// projection.
    float pixel;
    /// 1 for perspective, 0 for parallel projection.
    float perspective;
    /// Height of the picture, in pixels.
    float viewport_height;
    /// 1 where the first row of an image is at the bottom of the picture (OpenGL), 0 where it is at
    /// the top.
    float rows_up;
    /// Samples per pixel of the picture.
    float samples;
};

/// A pixel and its texel of the surface.
struct SeenPixel {
    int2 at;
    float4 texel;
};

/// The plane of the surface at a pixel: it tells which neighbors lie on the same surface. Changes
/// of depth are along columns and rows of the image.
struct Plane {
    float object;
    float depth;
    /// Change of depth from a pixel to the next.
    float2 rise;
    /// Tolerated difference of a neighbor's depth, for each pixel that the neighbor is away.
    float tolerance;
};

/// A pixel whose curvature is measured.
struct Center {
    int2 at;
    float2 slope;
    Plane plane;
};

/// Neighbors on the four sides of a center: in the column after it, in the column before it, in the
/// row after it, and in the row before it.
struct Ring {
    /// Weighted changes of slope.x from the center.
    float4 x;
    /// Weighted changes of slope.y from the center.
    float4 y;
    float4 weights;
};

Texture2D<float4> surface : register(t0);
cbuffer curvature : register(b0) { Curvature curvature; }

struct FragmentInput {
    float4 position_1 : SV_Position;
};

/// `accept` where the condition holds, else `reject`, component by component.
float4 choose(bool4 condition, float4 accept, float4 reject)
{
    return float4(condition.x ? accept.x : reject.x, condition.y ? accept.y : reject.y,
        condition.z ? accept.z : reject.z, condition.w ? accept.w : reject.w);
}

/// The slope n.xy / n.z of a normal in camera axes.
float2 slope_of(float3 normal)
{
    return normal.xy / (max(normal.z, 0.2)).xx;
}

/// The surface that a pixel shows, in one texel: its slope in xy, its depth in z, and in w the
/// object's number, from 1 on, negative where the normal points away from the viewer. `normal` is
/// unit, in camera axes.
float4 surface_texel(float3 normal, float depth, float number)
{
    const float2 slope_of_value = slope_of(normal);
    return float4(slope_of_value, depth, normal.z < 0.0 ? -number : number);
}

/// The number of an object in texels, from 1 on.
float object_number(float object)
{
    return object - 4096.0 * floor(object / 4096.0) + 1.0;
}

/// The number of a facet for [`surface_texel`]: the object's, from 1 on, and what materials and
/// ids add, less than 1. `id` is rounded to a whole number; what is none, or beyond a million, is
/// 0.
float facet_number(float object, float material, float id)
{
    float whole = round(abs(id) <= 1000000.0 ? id : 0.0);
    float parts = 128.0 * (material - 32.0 * floor(material / 32.0)) + whole - 128.0
        * floor(whole / 128.0);
    return object_number(object) + parts / 4096.0;
}

/// The normal that a texel was made from.
float3 normal_of(float4 texel)
{
    // Below LEAST_NZ the slope is n.xy by a constant, and n.z is what is left of the length 1;
    // elsewhere that is no less than LEAST_NZ, and the normal points along the slope and 1.
    float2 aside = 0.2 * texel.xy;
    float rest = sqrt(max(1.0 - dot(aside, aside), 0.0));
    float nz = texel.w < 0.0 ? -rest : rest;
    float3 facing = float3(texel.xy, 1.0) / (sqrt(1.0 + dot(texel.xy, texel.xy))).xxx;
    return nz >= 0.2 ? facing : float3(aside, nz);
}

/// A triangle over the whole picture.
float4 whole_picture(uint index)
{
    return float4(float(index & 1u) * 4.0 - 1.0, float(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

int to_int(float value) {
    return int(clamp(value, -2147483600.0, 2147483500.0));
}

/// A step in pixels: a share of the picture's height, so that a larger picture measures the same
/// curvature, not a finer one.
int step_pixels()
{
    return max(to_int(round(curvature.viewport_height / 800.0)), int(1));
}

/// 1 where a row of the image lies above the row before it, -1 where it lies below.
float row_direction()
{
    return curvature.rows_up > 0.5 ? 1.0 : -1.0;
}

/// Offset to one of the eight pixels around a pixel, by an index from 0 to 7; the nearest first.
int2 around(int index)
{
    int side = asint(asuint(int(1)) - asuint(asint(asuint(int(2)) * asuint(index & int(1)))));
    int2 straight = index < int(2) ? int2(side, int(0)) : int2(int(0), side);
    return index > int(3) ? int2(side, asint(asuint(int(1)) - asuint(index & int(2)))) : straight;
}

SeenPixel ConstructSeenPixel(int2 at, float4 texel) {
    SeenPixel ret = (SeenPixel)0;
    ret.at = at;
    ret.texel = texel;
    return ret;
}

uint2 NagaDimensions2D(Texture2D<float4> tex)
{
    uint4 ret;
    tex.GetDimensions(0, ret.x, ret.y, ret.z);
    return ret.xy;
}

/// The pixel whose surface a pixel has: its own, or that of a neighbor.
///
/// With several samples a pixel, a look also shades pixels whose middle the object just misses:
/// they have the surface of the nearest of the eight pixels around that shows one.
SeenPixel seen_pixel(int2 pixel)
{
    SeenPixel seen = (SeenPixel)0;
    bool local = (bool)0;

    seen = ConstructSeenPixel(pixel, surface.Load(int3(pixel, int(0))));
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    if (curvature.samples >= 2.0) {
        local = seen.texel.w == 0.0;
    } else {
        local = false;
    }
    bool may_be_missed = local;
    for (int index = may_be_missed ? 7 : -1; index >= 0; index--) {
        int2 near = clamp(asint(asuint(pixel) + asuint(around(index))), (int(0)).xx, last);
        float4 texel = surface.Load(int3(near, int(0)));
        if (texel.w != 0.0) {
            seen = ConstructSeenPixel(near, texel);
        }
    }
    return seen;
}

Plane ConstructPlane(float object, float depth, float2 rise, float tolerance) {
    Plane ret = (Plane)0;
    ret.object = object;
    ret.depth = depth;
    ret.rise = rise;
    ret.tolerance = tolerance;
    return ret;
}

Plane plane_of(float object, float depth, float3 normal)
{
    float pixel = curvature.pixel * lerp(1.0, depth, curvature.perspective);
    float2 gradient = normal.xy / (max(normal.z, 0.02)).xx;
    const float row_direction_value = row_direction();
    return ConstructPlane(object, depth, pixel * gradient * float2(1.0, row_direction_value), 2.0
        * pixel * (1.0 + length(gradient)));
}

/// Weights of four neighbors that are `distance` pixels away, 0 to 1, by their objects, their
/// depths, and the rises of depth to them on the plane.
float4 neighbor_weights(Plane plane, float4 objects, float4 depths, float4 rises, float distance_)
{
    float4 error = abs(depths - (plane.depth).xxxx - rises);
    float scale = 1.0 / max(plane.tolerance * distance_, 1e-30);
    // The weight fades, so that the last bit of a depth does not decide between all and nothing.
    float4 weights = clamp((2.0).xxxx - error * scale, (0.0).xxxx, (1.0).xxxx);
    return choose(objects == (plane.object).xxxx, weights, (0.0).xxxx);
}

Center ConstructCenter(int2 at, float2 slope, Plane plane) {
    Center ret = (Center)0;
    ret.at = at;
    ret.slope = slope;
    ret.plane = plane;
    return ret;
}

/// The center for a pixel; its object is 0 where there is none.
Center center_at(int2 pixel)
{
    const SeenPixel seen = seen_pixel(pixel);
    float4 texel = seen.texel;
    return ConstructCenter(seen.at, texel.xy, plane_of(abs(texel.w), texel.z, normal_of(texel)));
}

Ring ConstructRing(float4 x, float4 y, float4 weights) {
    Ring ret = (Ring)0;
    ret.x = x;
    ret.y = y;
    ret.weights = weights;
    return ret;
}

/// The ring that is so many steps away, with its weight.
Ring ring_at(Center center_, int steps, float weight)
{
    int reach = asint(asuint(steps) * asuint(step_pixels()));
    float distance_ = float(reach);
    int2 at = center_.at;
    int2 last = asint(asuint(int2(NagaDimensions2D(surface))) - asuint((int(1)).xx));
    float4 a = surface.Load(int3(int2(min(asint(asuint(at.x) + asuint(reach)), last.x), at.y),
        int(0)));
    float4 b = surface.Load(int3(int2(max(asint(asuint(at.x) - asuint(reach)), int(0)), at.y),
        int(0)));
    float4 c = surface.Load(int3(int2(at.x, min(asint(asuint(at.y) + asuint(reach)), last.y)),
        int(0)));
    float4 d = surface.Load(int3(int2(at.x, max(asint(asuint(at.y) - asuint(reach)), int(0))),
        int(0)));
    // Beyond the image nothing is.
    bool4 is_inside = int4(asint(asuint(last.x) - asuint(at.x)), at.x,
        asint(asuint(last.y) - asuint(at.y)), at.y) >= (reach).xxxx;
    const float4 objects = choose(is_inside, abs(float4(a.w, b.w, c.w, d.w)), (0.0).xxxx);
    float2 rise = distance_ * center_.plane.rise;
    float4 rises = float4(rise.x, -rise.x, rise.y, -rise.y);
    const float4 neighbor_weights_value = neighbor_weights(center_.plane, objects,
        float4(a.z, b.z, c.z, d.z), rises, distance_);
    float4 shares = weight * distance_ * neighbor_weights_value;
    return ConstructRing(shares * (float4(a.x, b.x, c.x, d.x) - (center_.slope.x).xxxx), shares
        * (float4(a.y, b.y, c.y, d.y) - (center_.slope.y).xxxx), shares * distance_);
}

/// Two rings as one.
Ring joined(Ring a, Ring b)
{
    return ConstructRing(a.x + b.x, a.y + b.y, a.weights + b.weights);
}

/// The twelve neighbors one, two and three steps away.
Ring rings_at(Center center_)
{
    const Ring near = joined(ring_at(center_, int(1), 1.0), ring_at(center_, int(2), 0.85));
    return joined(near, ring_at(center_, int(3), 0.5));
}

/// The derivatives along x and y, camera axes, from weighted changes to the four sides, as far as
/// each side counts; 0 where none does.
float2 derivatives(float4 changes, float4 weights)
{
    // A side that hardly counts any more is left to the other one, gradually.
    float4 trust = smoothstep((0.0).xxxx, (0.5).xxxx, weights);
    float4 sides = changes / max(weights, (1e-6).xxxx) * trust;
    float2 along = (sides.xz - sides.yw) / max(trust.xz + trust.yw, (1e-6).xx);
    return along * float2(1.0, row_direction());
}

/// Mean curvature from the neighbors.
float mean_curvature(Ring ring)
{
    const float2 along = derivatives(float4(ring.x.xy, ring.y.zw), ring.weights);
    return clamp(0.5 * (along.x + along.y) * curvature.viewport_height, -10000.0, 10000.0);
}

/// The tensor from the neighbors, in 1/viewport-height, camera axes, convex positive: xx, xy, yy.
float3 curvature_tensor(Ring ring)
{
    const float2 of_x = derivatives(ring.x, ring.weights);
    const float2 of_y = derivatives(ring.y, ring.weights);
    // A surface's own tensor is symmetric; that of interpolated normals is not quite.
    float3 tensor = float3(of_x.x, 0.5 * (of_y.x + of_x.y), of_y.y) * curvature.viewport_height;
    return clamp(tensor, (-10000.0).xxx, (10000.0).xxx);
}

float4 vs_main(uint index : SV_VertexID) : SV_Position
{
    return whole_picture(index);
}

int2 to_int(float2 value) {
    return int2(clamp(value, -2147483600.0, 2147483500.0));
}

float4 fs_main(FragmentInput input) : SV_Target0
{
    float4 position = input.position_1;
    const Center center_ = center_at(to_int(position.xy));
    if (center_.plane.object == 0.0) {
        return (0.0).xxxx;
    }
    return float4(curvature_tensor(rings_at(center_)), 1.0);
}
