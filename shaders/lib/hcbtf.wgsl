// Lookup of hand-painted 6D textures (thesis 10.3; layout as docs/math.md 6, thesis A.3, one layer
// of the texture a view).
//
// A layer holds one view. Every texel of the tile is a small block of its lights, thetas along x
// and phis along y, with the last phi again above the first and the first again below the last, so
// that one bilinear tap blends four lights. Smaller levels of the tile, where there are any, stand
// to the right of it, each below the one before. The last layer's first two texels hold the grid.
// Where views share layers, the texels after those hold the layer of each view.
//
// The compact storage is a row of words instead, a texel each: after the two of the grid, where the
// record of each sample's tile begins; in a record, for each level, where its texels begin and
// where its palette does, or 0; then palettes, a color a word, and texels, a color or four indices
// a word. Every function below that is given the grid reads this storage as well.
//
// The block storage is a row of compressed blocks of four by four texels: two whose first texels
// hold the grid, one for each sample whose first texel holds where the blocks of its tile begin,
// and the tiles, their levels one after the other.
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::surface;
import chiaro::convert;
import chiaro::antialias;

/// Division of an HCBTF, as its texture tells.
struct HcbtfGrid {
    /// Size of the tile, in texels.
    size: vec2i,
    /// Numbers of rings and steps of the lights.
    light: vec2i,
    /// Numbers of rings and steps of the views.
    view: vec2i,
    /// True if smaller levels of the tile are stored.
    has_levels: bool,
    /// True if colors are decoded to linear light after the blend.
    is_decoded: bool,
    /// True if views share layers.
    is_shared: bool,
    /// True if the storage is the compact one or that of blocks.
    is_compact: bool,
    /// True if the storage is that of blocks.
    has_blocks: bool,
    /// True if no texel is transparent.
    is_opaque: bool,
}

/// A direction among those of a grid: the two rings and the two steps around it, with the weight of
/// the second of each.
struct HcbtfPlace {
    theta: vec2i,
    phi: vec2i,
    weight: vec2f,
}

/// The four views around a direction, with their weights.
struct HcbtfViews {
    layer: vec4i,
    weight: vec4f,
}

/// The grid in a texture whose node asks for a storage: 0 for quick, 1 for compact, 2 for blocks. A
/// texture that is being painted is quick whatever its node asks for; what asks for quick is, so
/// that its shader need not hold the others.
fn hcbtf_grid(sheet: texture_2d_array<f32>, storage: i32) -> HcbtfGrid {
    let last = i32(textureNumLayers(sheet)) - 1;
    let first = vec4i(round(255.0 * textureLoad(sheet, vec2i(0, 0), last, 0)));
    let has_blocks = (storage == 2) & ((first.w & 16) != 0);
    let second = vec4i(round(255.0 * textureLoad(sheet, vec2i(select(1, 4, has_blocks), 0), last,
        0)));
    let size = vec2i(first.x + 256 * (first.z & 15), first.y + 256 * (first.z >> 4u));
    let flags = (vec4i(first.w) & vec4i(1, 2, 4, 8)) != vec4i(0);
    let is_compact = (storage != 0) & flags.w;
    return HcbtfGrid(size, second.xy, second.zw, flags.x, flags.y, flags.z, is_compact, has_blocks,
        (first.w & 32) != 0);
}

/// A world-space direction in the axes of a surface: x along u, y along v, z along the normal;
/// unit.
fn hcbtf_local(direction: vec3f, frame: mat3x3f) -> vec3f {
    return normalize_or(normalize_or(direction, frame[2]) * frame, vec3f(0.0, 0.0, 1.0));
}

/// Place of a direction between rings and steps: theta in [0, rings - 1], phi in [0, steps). A
/// direction below the horizon counts as on it, straight down too. Straight up and down there is no
/// phi, and 0 is taken; all samples of the first ring are the same.
fn hcbtf_place(local: vec3f, directions: vec2i) -> vec2f {
    let across = length_of(vec3f(local.xy, 0.0));
    // The GPU's own atan2 may be off by a thousandth.
    let theta = select(angle_of_point(across, max(local.z, 0.0)), HALF_PI, local.z < 0.0);
    let around = select(0.0, angle_of_point(local.x, local.y), across > 1e-12);
    let steps = f32(directions.y);
    let phi = around * (0.159154943091895336 * steps);
    let turned = select(phi, phi + steps, phi < 0.0);
    let rings = f32(directions.x - 1);
    // Rounding may reach the number of steps from below; that is the first step.
    return vec2f(clamp(theta * 0.636619772367581343 * rings, 0.0, rings),
        select(turned, 0.0, turned >= steps));
}

/// The samples around a place, with the weight of the second of each pair.
fn hcbtf_around(place: vec2f, directions: vec2i) -> HcbtfPlace {
    let low = vec2i(floor(place));
    let theta = vec2i(low.x, min(low.x + 1, directions.x - 1));
    // Divisions of whole numbers are dear where a GPU has none.
    let next = low.y + 1;
    let phi = vec2i(low.y, select(next, 0, next >= directions.y));
    return HcbtfPlace(theta, phi, place - floor(place));
}

/// Ring and step of the nearest sample.
fn hcbtf_near(place: vec2f, directions: vec2i) -> vec2i {
    let near = vec2i(floor(place + 0.5));
    return vec2i(min(near.x, directions.x - 1), select(near.y, 0, near.y >= directions.y));
}

fn hcbtf_views(place: vec2f, directions: vec2i) -> HcbtfViews {
    let around = hcbtf_around(place, directions);
    let layer = vec4i(around.theta.x, around.theta.y, around.theta.x, around.theta.y) * directions.y
        + vec4i(around.phi.x, around.phi.x, around.phi.y, around.phi.y);
    let w = around.weight;
    let weight = vec4f((1.0 - w.x) * (1.0 - w.y), w.x * (1.0 - w.y), (1.0 - w.x) * w.y, w.x * w.y);
    return HcbtfViews(layer, weight);
}

/// The number in a word, below 2^31.
fn hcbtf_number(word: vec4f) -> i32 {
    let bytes = vec4i(round(255.0 * word));
    return bytes.x + 256 * bytes.y + 65536 * bytes.z + 16777216 * bytes.w;
}

/// The views with the layers that store them; some views may share a layer.
fn hcbtf_stored(sheet: texture_2d_array<f32>, grid: HcbtfGrid, views: HcbtfViews) -> HcbtfViews {
    if !grid.is_shared {
        return views;
    }
    var layer = views.layer;
    for (var i = 0; i < 4; i++) {
        layer[i] = hcbtf_layer(sheet, grid, layer[i]);
    }
    return HcbtfViews(layer, views.weight);
}

/// The layer that stores a view.
fn hcbtf_layer(sheet: texture_2d_array<f32>, grid: HcbtfGrid, view: i32) -> i32 {
    if !grid.is_shared {
        return view;
    }
    let width = i32(textureDimensions(sheet).x);
    let last = i32(textureNumLayers(sheet)) - 1;
    let at = view + 2;
    let row = at / width;
    return hcbtf_number(textureLoad(sheet, vec2i(at - row * width, row), last, 0));
}

/// The texel of the tile at a texture coordinate, on which the tile repeats; v points up, rows go
/// down.
fn hcbtf_texel(uv: vec2f, size: vec2i) -> vec2i {
    let p = bounded_vec2(vec2f(uv.x, -uv.y));
    let inside = p - floor(p);
    return min(vec2i(inside * vec2f(size)), size - 1);
}

/// Origin of the block of a texel's lights, in texels of the layer, for a level that begins at
/// `origin`.
fn hcbtf_block(texel: vec2i, light: vec2i, origin: vec2i) -> vec2i {
    return origin + texel * vec2i(light.x, light.y + 2);
}

/// `sum` and a straight color with a weight, premultiplied so that transparent colors do not tint.
fn hcbtf_add(sum: vec4f, color: vec4f, weight: f32) -> vec4f {
    return sum + vec4f(color.xyz * color.w, color.w) * weight;
}

/// The straight color of a sum by [`hcbtf_add`]; transparent black where nothing was painted.
fn hcbtf_straight(sum: vec4f) -> vec4f {
    return select(vec4f(0.0), vec4f(clamp(sum.xyz / max(sum.w, 1e-20), vec3f(0.0), vec3f(1.0)),
        min(sum.w, 1.0)), sum.w > 0.0);
}

/// Four lights of one view at one texel, loaded and blended; premultiplied. They stand beside each
/// other in the block, as the last phi is there again.
fn hcbtf_lights(sheet: texture_2d_array<f32>, block: vec2i, layer: i32,
    light: HcbtfPlace) -> vec4f {
    let w = light.weight;
    let first = block + vec2i(light.theta.x, light.phi.x + 1);
    let right = vec2i(light.theta.y - light.theta.x, 0);
    let down = vec2i(0, 1);
    var sum = vec4f(0.0);
    sum = hcbtf_add(sum, textureLoad(sheet, first, layer, 0), (1.0 - w.x) * (1.0 - w.y));
    sum = hcbtf_add(sum, textureLoad(sheet, first + right, layer, 0), w.x * (1.0 - w.y));
    sum = hcbtf_add(sum, textureLoad(sheet, first + down, layer, 0), (1.0 - w.x) * w.y);
    return hcbtf_add(sum, textureLoad(sheet, first + right + down, layer, 0), w.x * w.y);
}

/// All sixteen samples around a light and a view at one texel; premultiplied.
fn hcbtf_sixteen(sheet: texture_2d_array<f32>, block: vec2i, light: HcbtfPlace,
    views: HcbtfViews) -> vec4f {
    return views.weight.x * hcbtf_lights(sheet, block, views.layer.x, light)
        + views.weight.y * hcbtf_lights(sheet, block, views.layer.y, light)
        + views.weight.z * hcbtf_lights(sheet, block, views.layer.z, light)
        + views.weight.w * hcbtf_lights(sheet, block, views.layer.w, light);
}

/// One bilinear tap of a view at a place in its layer, in texels; straight.
fn hcbtf_tap(sheet: texture_2d_array<f32>, sheet_sampler: sampler, at: vec2f, layer: i32) -> vec4f {
    return textureSampleLevel(sheet, sheet_sampler, at / vec2f(textureDimensions(sheet)), layer,
        0.0);
}

/// The place in its layer of a light's place in the block of a texel.
fn hcbtf_tap_place(block: vec2i, light: vec2f) -> vec2f {
    return vec2f(block) + light + vec2f(0.5, 1.5);
}

/// [`hcbtf_tap`] for the four views around a direction, blended; premultiplied.
fn hcbtf_taps(sheet: texture_2d_array<f32>, sheet_sampler: sampler, at: vec2f,
    views: HcbtfViews) -> vec4f {
    var sum = vec4f(0.0);
    sum = hcbtf_add(sum, hcbtf_tap(sheet, sheet_sampler, at, views.layer.x), views.weight.x);
    sum = hcbtf_add(sum, hcbtf_tap(sheet, sheet_sampler, at, views.layer.y), views.weight.y);
    sum = hcbtf_add(sum, hcbtf_tap(sheet, sheet_sampler, at, views.layer.z), views.weight.z);
    return hcbtf_add(sum, hcbtf_tap(sheet, sheet_sampler, at, views.layer.w), views.weight.w);
}

/// A light's place at which a tap blends in whole steps of a GPU's weights, a 256th each: it then
/// makes no difference whether the GPU rounds them or cuts them off.
///
/// Half a step of both weights adds up to a whole one where the four lights have nothing in common
/// and both make more, or both less, of one of them. There the weight that is farther from its step
/// takes the step on its other side.
fn hcbtf_stepped(place: vec2f) -> vec2f {
    let steps = 256.0 * place;
    let near = floor(steps + 0.5);
    let off = near - steps;
    let side = place - floor(place) - 0.5;
    let adds = (off.x * off.y * side.x * side.y > 0.0) & (abs(off.x) + abs(off.y) > 0.75);
    let is_first = abs(off.x) > abs(off.y);
    let turned = vec2f(select(0.0, sign(off.x), adds & is_first),
        select(0.0, sign(off.y), adds & !is_first));
    // Beyond the step by less than the rounding of a coordinate could take away.
    return (near - turned) * 0.00390625 + 0.000244140625;
}

/// Lights whose taps are blended one after the other.
struct HcbtfTurns {
    /// Place of the first.
    place: vec2f,
    /// Weights of the second of each pair; of no use for one light.
    weight: vec2f,
    /// Number of lights: 1 where the tap itself blends four, 4 where paint is transparent and each
    /// color counts as much as its alpha.
    count: i32,
}

fn hcbtf_turns(light: vec2f, grid: HcbtfGrid) -> HcbtfTurns {
    let low = floor(light);
    return HcbtfTurns(select(low + 0.000244140625, hcbtf_stepped(light), grid.is_opaque),
        light - low, select(4, 1, grid.is_opaque));
}

/// The place of a light in x and y and its weight in z.
fn hcbtf_turn(turns: HcbtfTurns, index: i32) -> vec3f {
    let corner = vec2f(f32(index & 1), f32(index >> 1u));
    let weight = mix(1.0 - turns.weight, turns.weight, corner);
    return vec3f(turns.place + corner, select(weight.x * weight.y, 1.0, turns.count == 1));
}

/// The four texels around a place of a level, with their weights, wrapped around the tile.
struct HcbtfTexels {
    /// Left, top, right, bottom.
    at: vec4i,
    weight: vec2f,
    /// Origin of the level, in texels of the layer.
    origin: vec2i,
    /// Number of texels in a row of the level.
    width: i32,
    /// Number of times that the tile was halved.
    level: i32,
    /// Number of blocks in the levels before.
    before: i32,
}

/// The blocks of lights of four texels.
struct HcbtfBlocks {
    left_top: vec2i,
    right_top: vec2i,
    left_bottom: vec2i,
    right_bottom: vec2i,
}

fn hcbtf_blocks(texels: HcbtfTexels, light: vec2i) -> HcbtfBlocks {
    let at = texels.at;
    return HcbtfBlocks(
        hcbtf_block(at.xy, light, texels.origin),
        hcbtf_block(at.zy, light, texels.origin),
        hcbtf_block(at.xw, light, texels.origin),
        hcbtf_block(at.zw, light, texels.origin),
    );
}

fn hcbtf_texels(uv: vec2f, grid: HcbtfGrid, level: i32) -> HcbtfTexels {
    var size = grid.size;
    var origin = vec2i(0);
    var before = 0;
    for (var i = 0; i < level; i++) {
        before += hcbtf_blocks_of(size);
        // The first smaller level stands beside the tile, the next ones below each other.
        origin = vec2i(grid.size.x * grid.light.x,
            select(origin.y + size.y * (grid.light.y + 2), 0, i == 0));
        size = max(size >> vec2u(1u), vec2i(1));
    }
    let p = bounded_vec2(vec2f(uv.x, -uv.y));
    let place = (p - floor(p)) * vec2f(size) - 0.5;
    let low = vec2i(floor(place));
    // Not by selections: GLSL ES 3.00 has none of whole numbers.
    let first = low + size * vec2i(low < vec2i(0));
    let next = first + 1;
    return HcbtfTexels(vec4i(first, next * vec2i(next < size)), place - floor(place),
        origin, size.x, level, before);
}

/// The texel at a texture coordinate alone, in the form of four texels that are the same.
fn hcbtf_crisp_texel(uv: vec2f, grid: HcbtfGrid) -> HcbtfTexels {
    let texel = hcbtf_texel(uv, grid.size);
    return HcbtfTexels(vec4i(texel, texel), vec2f(0.0), vec2i(0), grid.size.x, 0, 0);
}

/// A word of the compact storage: 2048 a row, 2048 rows a layer, the last layer first.
fn hcbtf_word(sheet: texture_2d_array<f32>, index: i32) -> vec4f {
    let last = i32(textureNumLayers(sheet)) - 1;
    return textureLoad(sheet, vec2i(index & 2047, (index >> 11u) & 2047), last - (index >> 22u), 0);
}

/// A texel of a block of the block storage: 512 blocks a row, 512 rows a layer, the last layer
/// first.
fn hcbtf_block_texel(sheet: texture_2d_array<f32>, index: i32, texel: vec2i) -> vec4f {
    let last = i32(textureNumLayers(sheet)) - 1;
    return textureLoad(sheet, 4 * vec2i(index & 511, (index >> 9u) & 511) + texel, last
        - (index >> 18u), 0);
}

/// Number of blocks along a row of texels.
fn hcbtf_blocks_along(texels: i32) -> i32 {
    return (texels + 3) >> 2u;
}

/// Number of blocks of a level.
fn hcbtf_blocks_of(size: vec2i) -> i32 {
    return hcbtf_blocks_along(size.x) * hcbtf_blocks_along(size.y);
}

/// Beginning of the texels of a sample's tile in x and of its palette in y, 0 for none; compact
/// storage. In the block storage there are no palettes, and `before` is the number of blocks in the
/// levels before.
fn hcbtf_piece(sheet: texture_2d_array<f32>, grid: HcbtfGrid, view: i32, light: i32, level: i32,
    before: i32) -> vec2i {
    let sample = 2 + view * grid.light.x * grid.light.y + light;
    if grid.has_blocks {
        return vec2i(hcbtf_number(hcbtf_block_texel(sheet, sample, vec2i(0))) + before, 0);
    }
    let record = hcbtf_number(hcbtf_word(sheet, sample)) + 2 * level;
    return vec2i(hcbtf_number(hcbtf_word(sheet, record)),
        hcbtf_number(hcbtf_word(sheet, record + 1)));
}

/// A texel of a tile found by [`hcbtf_piece`], whose rows have `width` texels; straight.
fn hcbtf_piece_texel(sheet: texture_2d_array<f32>, grid: HcbtfGrid, piece: vec2i, at: vec2i,
    width: i32) -> vec4f {
    if grid.has_blocks {
        let block = at >> vec2u(2u);
        return hcbtf_block_texel(sheet, piece.x + block.y * hcbtf_blocks_along(width) + block.x,
            at & vec2i(3));
    }
    let index = width * at.y + at.x;
    if piece.y == 0 {
        return hcbtf_word(sheet, piece.x + index);
    }
    let four = hcbtf_word(sheet, piece.x + (index >> 2u));
    return hcbtf_word(sheet, piece.y + i32(round(255.0 * four[index & 3])));
}

/// Four texels of a tile found by [`hcbtf_piece`], blended; premultiplied. Texels of weight 0 are
/// not read.
fn hcbtf_piece_blend(sheet: texture_2d_array<f32>, grid: HcbtfGrid, piece: vec2i,
    texels: HcbtfTexels) -> vec4f {
    let w = texels.weight;
    let at = texels.at;
    let width = texels.width;
    var sum = hcbtf_add(vec4f(0.0), hcbtf_piece_texel(sheet, grid, piece, at.xy, width),
        (1.0 - w.x) * (1.0 - w.y));
    if w.x > 0.0 {
        sum = hcbtf_add(sum, hcbtf_piece_texel(sheet, grid, piece, at.zy, width),
            w.x * (1.0 - w.y));
    }
    if w.y > 0.0 {
        sum = hcbtf_add(sum, hcbtf_piece_texel(sheet, grid, piece, at.xw, width),
            (1.0 - w.x) * w.y);
    }
    if (w.x > 0.0) & (w.y > 0.0) {
        sum = hcbtf_add(sum, hcbtf_piece_texel(sheet, grid, piece, at.zw, width), w.x * w.y);
    }
    return sum;
}

/// Blend of all samples that count around a light and a view, from the compact storage or that of
/// blocks; premultiplied.
fn hcbtf_compact(sheet: texture_2d_array<f32>, grid: HcbtfGrid, texels: HcbtfTexels,
    light: HcbtfPlace, views: HcbtfViews) -> vec4f {
    let steps = grid.light.y;
    let theta = vec4i(light.theta.x, light.theta.y, light.theta.x, light.theta.y);
    let lights = theta * steps + vec4i(light.phi.x, light.phi.x, light.phi.y, light.phi.y);
    let w = light.weight;
    let weights = vec4f((1.0 - w.x) * (1.0 - w.y), w.x * (1.0 - w.y), (1.0 - w.x) * w.y, w.x * w.y);
    var sum = vec4f(0.0);
    for (var i = 0; i < 16; i++) {
        let weight = views.weight[i >> 2u] * weights[i & 3];
        if weight > 0.0 {
            let piece = hcbtf_piece(sheet, grid, views.layer[i >> 2u], lights[i & 3], texels.level,
                texels.before);
            sum += weight * hcbtf_piece_blend(sheet, grid, piece, texels);
        }
    }
    return sum;
}

/// The nearest view alone.
fn hcbtf_one_view(near: vec2i, grid: HcbtfGrid) -> HcbtfViews {
    return HcbtfViews(vec4i(near.x * grid.view.y + near.y), vec4f(1.0, 0.0, 0.0, 0.0));
}

/// All sixteen samples, each bilinear between the texels of one level; premultiplied.
fn hcbtf_sixteen_at(sheet: texture_2d_array<f32>, uv: vec2f, grid: HcbtfGrid, level: i32,
    light: HcbtfPlace, views: HcbtfViews) -> vec4f {
    let texels = hcbtf_texels(uv, grid, level);
    if grid.is_compact {
        return hcbtf_compact(sheet, grid, texels, light, views);
    }
    let w = texels.weight;
    let blocks = hcbtf_blocks(texels, grid.light);
    return (1.0 - w.x) * (1.0 - w.y) * hcbtf_sixteen(sheet, blocks.left_top, light, views)
        + w.x * (1.0 - w.y) * hcbtf_sixteen(sheet, blocks.right_top, light, views)
        + (1.0 - w.x) * w.y * hcbtf_sixteen(sheet, blocks.left_bottom, light, views)
        + w.x * w.y * hcbtf_sixteen(sheet, blocks.right_bottom, light, views);
}

/// [`hcbtf_sixteen_at`] for the levels around one between them, blended; premultiplied.
///
/// A loop and not a branch around the second level: what runs on a CPU executes both sides of a
/// branch, but leaves a loop as soon as no pixel needs more.
fn hcbtf_smooth(sheet: texture_2d_array<f32>, uv: vec2f, grid: HcbtfGrid, level: f32,
    light: HcbtfPlace, view: HcbtfViews) -> vec4f {
    let views = hcbtf_stored(sheet, grid, view);
    let finer = i32(level);
    let part = level - f32(finer);
    let last = select(finer, finer + 1, part > 0.0);
    var sum = vec4f(0.0);
    var at = finer;
    loop {
        let share = select(part, 1.0 - part, at == finer);
        sum += share * hcbtf_sixteen_at(sheet, uv, grid, at, light, views);
        at += 1;
        if at > last {
            break;
        }
    }
    return sum;
}

/// [`hcbtf_sixteen_at`] by a bilinear tap for each view and texel; premultiplied. Not for the
/// compact storage.
fn hcbtf_taps_at(sheet: texture_2d_array<f32>, sheet_sampler: sampler, uv: vec2f, grid: HcbtfGrid,
    level: i32, light: HcbtfTurns, views: HcbtfViews) -> vec4f {
    let texels = hcbtf_texels(uv, grid, level);
    let w = texels.weight;
    let blocks = hcbtf_blocks(texels, grid.light);
    var sum = vec4f(0.0);
    var index = 0;
    loop {
        let turn = hcbtf_turn(light, index);
        let place = turn.xy;
        sum += turn.z * ((1.0 - w.x) * (1.0 - w.y) * hcbtf_taps(sheet, sheet_sampler,
            hcbtf_tap_place(blocks.left_top, place), views)
            + w.x * (1.0 - w.y) * hcbtf_taps(sheet, sheet_sampler,
            hcbtf_tap_place(blocks.right_top, place), views)
            + (1.0 - w.x) * w.y * hcbtf_taps(sheet, sheet_sampler,
            hcbtf_tap_place(blocks.left_bottom, place), views)
            + w.x * w.y * hcbtf_taps(sheet, sheet_sampler,
            hcbtf_tap_place(blocks.right_bottom, place), views));
        index += 1;
        if index >= light.count {
            break;
        }
    }
    return sum;
}

/// [`hcbtf_smooth`] by taps.
fn hcbtf_smooth_taps(sheet: texture_2d_array<f32>, sheet_sampler: sampler, uv: vec2f,
    grid: HcbtfGrid, level: f32, light: vec2f, view: HcbtfViews) -> vec4f {
    if grid.is_compact {
        return hcbtf_smooth(sheet, uv, grid, level, hcbtf_around(light, grid.light), view);
    }
    let views = hcbtf_stored(sheet, grid, view);
    let lights = hcbtf_turns(light, grid);
    let finer = i32(level);
    let part = level - f32(finer);
    let last = select(finer, finer + 1, part > 0.0);
    var sum = vec4f(0.0);
    var at = finer;
    loop {
        let share = select(part, 1.0 - part, at == finer);
        sum += share * hcbtf_taps_at(sheet, sheet_sampler, uv, grid, at, lights, views);
        at += 1;
        if at > last {
            break;
        }
    }
    return sum;
}

/// A bilinear tap of the nearest view alone for each texel; straight.
fn hcbtf_tap_at(sheet: texture_2d_array<f32>, sheet_sampler: sampler, uv: vec2f, grid: HcbtfGrid,
    level: i32, light: vec2f, near: vec2i) -> vec4f {
    let texels = hcbtf_texels(uv, grid, level);
    if grid.is_compact {
        let view = hcbtf_one_view(near, grid);
        return hcbtf_straight(hcbtf_compact(sheet, grid, texels, hcbtf_around(light, grid.light),
            view));
    }
    let layer = hcbtf_layer(sheet, grid, near.x * grid.view.y + near.y);
    let w = texels.weight;
    let blocks = hcbtf_blocks(texels, grid.light);
    return (1.0 - w.x) * (1.0 - w.y) * hcbtf_tap(sheet, sheet_sampler,
        hcbtf_tap_place(blocks.left_top, light), layer)
        + w.x * (1.0 - w.y) * hcbtf_tap(sheet, sheet_sampler,
        hcbtf_tap_place(blocks.right_top, light), layer)
        + (1.0 - w.x) * w.y * hcbtf_tap(sheet, sheet_sampler,
        hcbtf_tap_place(blocks.left_bottom, light), layer)
        + w.x * w.y * hcbtf_tap(sheet, sheet_sampler,
        hcbtf_tap_place(blocks.right_bottom, light), layer);
}

/// All sixteen samples at the texel of a texture coordinate; premultiplied.
fn hcbtf_crisp(sheet: texture_2d_array<f32>, uv: vec2f, grid: HcbtfGrid, light: HcbtfPlace,
    views: HcbtfViews) -> vec4f {
    let texel = hcbtf_crisp_texel(uv, grid);
    if grid.is_compact {
        return hcbtf_compact(sheet, grid, texel, light, views);
    }
    return hcbtf_sixteen(sheet, hcbtf_block(texel.at.xy, grid.light, vec2i(0)), light,
        hcbtf_stored(sheet, grid, views));
}

/// [`hcbtf_crisp`] by a bilinear tap for each view; premultiplied.
fn hcbtf_crisp_taps(sheet: texture_2d_array<f32>, sheet_sampler: sampler, uv: vec2f,
    grid: HcbtfGrid, light: vec2f, view: HcbtfViews) -> vec4f {
    if grid.is_compact {
        return hcbtf_crisp(sheet, uv, grid, hcbtf_around(light, grid.light), view);
    }
    let block = hcbtf_block(hcbtf_texel(uv, grid.size), grid.light, vec2i(0));
    let views = hcbtf_stored(sheet, grid, view);
    let lights = hcbtf_turns(light, grid);
    var sum = vec4f(0.0);
    var index = 0;
    loop {
        let turn = hcbtf_turn(lights, index);
        sum += turn.z * hcbtf_taps(sheet, sheet_sampler, hcbtf_tap_place(block, turn.xy), views);
        index += 1;
        if index >= lights.count {
            break;
        }
    }
    return sum;
}

/// [`hcbtf_crisp`] by one bilinear tap of the nearest view; straight.
fn hcbtf_crisp_tap(sheet: texture_2d_array<f32>, sheet_sampler: sampler, uv: vec2f, grid: HcbtfGrid,
    light: vec2f, near: vec2i) -> vec4f {
    let texel = hcbtf_crisp_texel(uv, grid);
    if grid.is_compact {
        let view = hcbtf_one_view(near, grid);
        return hcbtf_straight(hcbtf_compact(sheet, grid, texel, hcbtf_around(light, grid.light),
            view));
    }
    let block = hcbtf_block(texel.at.xy, grid.light, vec2i(0));
    return hcbtf_tap(sheet, sheet_sampler, hcbtf_tap_place(block, light),
        hcbtf_layer(sheet, grid, near.x * grid.view.y + near.y));
}

/// The nearest sample at the texel of a texture coordinate, as it was painted; straight.
fn hcbtf_painted(sheet: texture_2d_array<f32>, uv: vec2f, grid: HcbtfGrid, light: vec2i,
    near: vec2i) -> vec4f {
    let texel = hcbtf_texel(uv, grid.size);
    let view = near.x * grid.view.y + near.y;
    if grid.is_compact {
        let piece = hcbtf_piece(sheet, grid, view, light.x * grid.light.y + light.y, 0, 0);
        return hcbtf_piece_texel(sheet, grid, piece, texel, grid.size.x);
    }
    let at = hcbtf_block(texel, grid.light, vec2i(0)) + vec2i(light.x, light.y + 1);
    return textureLoad(sheet, at, hcbtf_layer(sheet, grid, view), 0);
}

/// Level of the tile to read: log2 of how many times smaller the tile is seen than it is painted.
/// Call it in uniform control flow.
fn hcbtf_level(uv: vec2f, grid: HcbtfGrid) -> f32 {
    let dx = bounded_vec2(dpdx(uv) * vec2f(grid.size));
    let dy = bounded_vec2(dpdy(uv) * vec2f(grid.size));
    let widest = clamp(max(dot(dx, dx), dot(dy, dy)), 1.0, 1e9);
    let side = max(grid.size.x, grid.size.y);
    let last = floor(log2(f32(side)) + 1e-4);
    return select(0.0, min(0.5 * log2(widest), last), grid.has_levels);
}

/// Share of a light that arrives at a horizon: 1 above it, 0 below, with an edge as wide as a
/// pixel. Call it in uniform control flow.
fn hcbtf_horizon(light: vec3f, frame: mat3x3f) -> f32 {
    let height = dot(normalize_or(light, frame[2]), frame[2]);
    return step_filtered(height, 0.0, footprint_of(height));
}

/// The color to show for a straight blend: decoded where the look is in linear light, and replaced
/// below the horizon.
fn hcbtf_finished(lit: vec4f, above: f32, unlit: vec4f, grid: HcbtfGrid) -> vec4f {
    let painted = select(lit, linear_from_display(lit), grid.is_decoded);
    return mix(bounded_vec4(unlit), painted, above);
}
