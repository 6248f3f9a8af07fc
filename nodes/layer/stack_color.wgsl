import chiaro::types;

/// Stack color
///
/// The straight color of a whole stack of layers, for a layer that lays the stack over another one:
/// a Folder. Light that lies over nothing, as a layer in the mode Add leaves, is kept: it
/// covers a millionth, where a plain wire into a color would hide it.
///
/// @param stack "Stack" wire : The finished stack, over a transparent Base.
/// @return color "Color" : Its color and how much of it there is.
fn stack_color(stack: Composite) -> Color {
    let light = max(max(abs(stack.x), abs(stack.y)), abs(stack.z));
    let cover = max(stack.w, select(0.0, 1e-6, light > 0.0));
    if cover <= 0.0 {
        return vec4f(0.0);
    }
    return vec4f(clamp(stack.xyz / cover, vec3f(-1e9), vec3f(1e9)), cover);
}
