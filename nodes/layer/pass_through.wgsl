import chiaro::types;

/// Pass-through folder
///
/// A folder of layers that lie on the stack below as if they were not in a folder; its opacity and
/// its mask count for all of them together. A Folder has a blend mode and is blended in itself
/// first.
///
/// @param below "Below" wire : The stack of layers below.
/// @param inside "Layers" wire : The stack of the layers in the folder, which begins with what is
///   below.
/// @param opacity "Opacity" default=1 min=0 max=1 : 0 leaves what is below as it is, 1 shows the
///   layers as they are without the folder.
/// @bound opacity
/// @bypass inside when opacity = 1 : its layers are as they are without it
/// @bypass below when opacity = 0 : its opacity is 0
/// @return below "Stack" : The stack with the folder on top.
fn pass_through(below: Composite, inside: Composite, opacity: f32) -> Composite {
    if opacity >= 1.0 {
        return inside;
    }
    if opacity <= 0.0 {
        return below;
    }
    // A difference would lose a faint part of one beside a bright part of the other.
    return below * (1.0 - opacity) + inside * opacity;
}
