// A highlight, moved: made by Chiaro 0.1.0. This is the images that the look reads.
((window.chiaroExports ??= {})["highlight-moves"] ??= {}).textures = {
};
