// Lines over the picture, drawn after the looks: where surfaces end, fold and meet, evenly on both
// sides of the edges, in one color. Premultiplied, in display colors; 0 where no line is.
import chiaro::line_map;

/// Lines of a scene: a straight color, and widths in pixels.
struct Ink {
    ink_red: f32,
    ink_green: f32,
    ink_blue: f32,
    ink_alpha: f32,
    silhouette_width: f32,
    crease_width: f32,
    border_width: f32,
    material_border_width: f32,
    id_border_width: f32,
}

@group(0) @binding(3) var<uniform> ink: Ink;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let widths = vec4f(ink.silhouette_width, ink.crease_width, ink.border_width,
        ink.material_border_width);
    let cover = ink_covers(vec2i(position.xy), LineWidths(widths, ink.id_border_width));
    let alpha = cover * ink.ink_alpha;
    return vec4f(alpha * vec3f(ink.ink_red, ink.ink_green, ink.ink_blue), alpha);
}

/// Share of a pixel that lines cover: those of its own surface and of all that lies in front.
fn ink_covers(pixel: vec2i, widths: LineWidths) -> f32 {
    let last = vec2i(textureDimensions(surface)) - 1;
    let seen = textureLoad(surface, pixel, 0);
    let own = plane_of(abs(seen.w), seen.z, normal_of(seen));
    let widest = max(max(max(widths.kinds.x, widths.kinds.y), max(widths.kinds.z, widths.kinds.w)),
        widths.ids);
    // An edge lies up to a pixel from the middle of the pixel that keeps it.
    let reach = i32(ceil(0.5 * widest + 1.5));
    var covers = 0.0;
    for (var row = max(-reach, -pixel.y); row <= min(reach, last.y - pixel.y); row++) {
        for (var column = max(-reach, -pixel.x); column <= min(reach, last.x - pixel.x); column++) {
            let offset = vec2i(column, row);
            let codes = textureLoad(edges, pixel + offset, 0);
            if all(codes == vec4f(0.0)) {
                continue;
            }
            let owner = textureLoad(surface, pixel + offset, 0);
            // What lies behind draws no line over what is in front.
            let is_behind = seen.w != 0.0 && owner.z > seen.z;
            if is_behind && !is_same_surface(own, owner, vec2f(offset)) {
                continue;
            }
            covers = max(covers, piece_covers(codes, vec2f(offset), widths));
        }
    }
    return covers;
}

/// Share of a pixel that lines along the edges of a pixel so many columns and rows away cover.
fn piece_covers(codes: vec4f, offset: vec2f, widths: LineWidths) -> f32 {
    let lines = edges_of(abs(codes), FINE);
    let across = abs(lines.offset + lines.x * offset.x + lines.y * offset.y);
    // What is farther along than the edge's own pixel lies beyond the edge's end.
    let beyond = max(abs(lines.y * offset.x - lines.x * offset.y) - 1.0, vec4f(0.0));
    let distance = sqrt(across * across + beyond * beyond);
    let own = select(vec4f(0.0), widths_near(codes, widths), codes != vec4f(0.0));
    let covers = middle_line_covers(distance, own);
    return max(max(covers.x, covers.y), max(covers.z, covers.w));
}
