//! Table of all passes, a row each, each after those that it reads.
//!
//! A new pass over the picture results in 0 where no object is near, and is not run there
//! (`FramePlan::screen_area`). With one sample a pixel, it results in 0 at each pixel that shows no
//! object, and the renderer leaves these out, too, unless the row's extent is more. It needs a row
//! here and a file of `shaders/passes`, whose textures are the row's `reads` by name and whose
//! uniform has numbers of the view, by the names in `VIEW_NUMBERS` (`src/scene/frame/screen.rs`). A
//! look reads the pass through a row of the table of contexts.

use chiaro_locale::{Text, text};

use super::row::{PassInput, PassOutput, PassRow, PassWork, ScreenExtent, Stage, TexelFormat};

/// Outputs of every pass that draws normals: slope, depth and object of what a pixel shows, packed
/// by `surface_texel` (`shaders/lib/slope.wgsl`); 0 where no object is.
const SURFACE: &[PassOutput] = &[PassOutput { name: "surface", format: TexelFormat::Numbers }];
const CURVATURE: &[PassOutput] = &[PassOutput { name: "curvature", format: TexelFormat::Number }];
const TENSOR: &[PassOutput] = &[PassOutput { name: "curvature", format: TexelFormat::Numbers }];
const NORMAL: &[PassOutput] = &[PassOutput { name: "normal", format: TexelFormat::Numbers }];
/// Edges of four kinds, packed by `edge_code` (`shaders/lib/edge_code.wgsl`).
const EDGES: &[PassOutput] = &[PassOutput { name: "edges", format: TexelFormat::Numbers }];
/// Shares of what stands near, packed by `packed_shares` (`shaders/lib/near_shares.wgsl`).
const SHARES: &[PassOutput] = &[PassOutput { name: "shares", format: TexelFormat::Numbers }];
/// Lines in display colors, premultiplied.
const LINES: &[PassOutput] = &[PassOutput { name: "lines", format: TexelFormat::Numbers }];
const NEARNESS: &[PassOutput] = &[PassOutput { name: "nearness", format: TexelFormat::Numbers }];
/// Nearness to the light, number of the object, and how the nearness changes to the next texels
/// (`light_texel` in `shaders/lib/light_view.wgsl`).
const SEEN: &[PassOutput] = &[PassOutput { name: "seen", format: TexelFormat::Numbers }];
const COLOR: &[PassOutput] = &[PassOutput { name: "color", format: TexelFormat::Picture }];

/// Inputs of a pass: the surface that a pass drew, and for a level of smoothed normals the image of
/// the level before, which for the first one is the surface.
macro_rules! reads {
    ($surface:literal) => {
        &[PassInput { binding: "surface", pass: $surface, output: "surface" }]
    };
    ($surface:literal, $normals:literal, $output:literal) => {
        &[
            PassInput { binding: "surface", pass: $surface, output: "surface" },
            PassInput { binding: "normals", pass: $normals, output: $output },
        ]
    };
}

/// Inputs of the passes that look for the nearest edges, the last one by the columns' pass.
const COLUMNS_READ: &[PassInput] = &[
    PassInput { binding: "surface", pass: "facets", output: "surface" },
    PassInput { binding: "edges", pass: "edges", output: "edges" },
];
const LINES_READ: &[PassInput] = &[
    COLUMNS_READ[0],
    COLUMNS_READ[1],
    PassInput { binding: "columns", pass: "edge_columns", output: "edges" },
];
/// Inputs of the same passes over what lies behind the first surface.
const HIDDEN_EDGES_READ: &[PassInput] = &[
    PassInput { binding: "surface", pass: "hidden_facets", output: "surface" },
    PassInput { binding: "front", pass: "facets", output: "surface" },
];
const HIDDEN_COLUMNS_READ: &[PassInput] =
    &[HIDDEN_EDGES_READ[0], PassInput { binding: "edges", pass: "hidden_edges", output: "edges" }];
const HIDDEN_READ: &[PassInput] = &[
    HIDDEN_COLUMNS_READ[0],
    HIDDEN_COLUMNS_READ[1],
    PassInput { binding: "columns", pass: "hidden_columns", output: "edges" },
];
const SHORT_READ: &[PassInput] = &[
    COLUMNS_READ[0],
    COLUMNS_READ[1],
    PassInput { binding: "columns", pass: "edge_columns_short", output: "edges" },
];

/// Inputs of the pass that joins shares of what stands near.
const SHARES_READ: &[PassInput] = &[
    PassInput { binding: "surface", pass: "normals", output: "surface" },
    PassInput { binding: "slices", pass: "near_slices", output: "shares" },
];

/// Constants of a pass that looks for the nearest edges, its steps first, and the pixels at which
/// the pass finds any.
type EdgeSearch = (&'static [(&'static str, i32)], ScreenExtent);

/// Search for the edges of the surface that a pixel shows, as far as the widest lines reach.
const OF_SURFACE: EdgeSearch = (&[("STEPS", 16)], ScreenExtent::Surface);
/// The same, half as far.
const OF_SURFACE_NEARBY: EdgeSearch = (&[("STEPS", 8)], ScreenExtent::Surface);
/// Search for the edges of all surfaces, on both sides.
const OF_ALL: EdgeSearch = (&[("STEPS", 16), ("OF_ALL", 1)], ScreenExtent::Around);

/// Steps of 1/800 of the picture's height that a scene's lines reach from their edges: half of the
/// greatest width, and what rounding and antialiasing take.
const OUTLINES_REACH: u32 = 14;

/// Work of a pass that measures normals with a file whose constants are not set.
const fn measured(shader: &'static str, reach: u32) -> PassWork {
    PassWork::Screen { shader, constants: &[], reach, extent: ScreenExtent::Surface }
}

/// Row of a level of smoothed normals, each made from the level before it, twice as far around.
const fn smooth(
    slug: &'static str,
    (label, map): (Text, &'static str),
    reads: &'static [PassInput],
    level: &'static [(&'static str, i32); 1],
    help: &'static str,
) -> PassRow {
    let reach = 1_u32 << level[0].1;
    PassRow {
        slug,
        label,
        work: PassWork::Screen {
            shader: "smooth_normals",
            constants: level,
            reach,
            extent: ScreenExtent::Surface,
        },
        reads,
        writes: NORMAL,
        map,
        purpose: text!("smoothed normals"),
        result: text!("smoother ones are"),
        help,
    }
}

/// Row of the nearest edges in columns, as far as the steps that its file's first constant gives.
const fn columns(
    slug: &'static str,
    label: Text,
    reads: &'static [PassInput],
    (steps, extent): EdgeSearch,
) -> PassRow {
    PassRow {
        slug,
        label,
        work: PassWork::Screen {
            shader: "edge_columns",
            constants: steps,
            reach: steps[0].1 as u32,
            extent,
        },
        reads,
        writes: EDGES,
        map: "",
        purpose: text!("the nearest edges of columns"),
        result: text!("edges are"),
        help: "Finds the nearest edges in each pixel's column.",
    }
}

/// Row of the nearness of edges, as far as the steps of the columns that it reads.
const fn lines(
    (slug, label, map): (&'static str, Text, &'static str),
    reads: &'static [PassInput],
    (steps, extent): EdgeSearch,
) -> PassRow {
    PassRow {
        slug,
        label,
        work: PassWork::Screen {
            shader: "line_nearness",
            constants: steps,
            reach: steps[0].1 as u32,
            extent,
        },
        reads,
        writes: NEARNESS,
        map,
        purpose: text!("the nearness of edges"),
        result: text!("lines are"),
        help: "Finds how near the nearest edges of each kind are.",
    }
}

/// Rows of the table.
pub(super) const TABLE: &[PassRow] = &[
    PassRow {
        slug: "shadow_map",
        label: text!("shadow maps"),
        work: PassWork::Lights { shader: "shadow_map" },
        reads: &[],
        writes: SEEN,
        map: "shadow_map",
        purpose: text!("shadows from maps"),
        result: text!("what lies behind is"),
        help: "Draws what each light sees first.",
    },
    PassRow {
        slug: "shadow_map_behind",
        label: text!("shadow maps behind"),
        work: PassWork::Lights { shader: "shadow_map_behind" },
        reads: &[PassInput { binding: "first", pass: "shadow_map", output: "seen" }],
        writes: SEEN,
        map: "shadow_map_behind",
        purpose: text!("shadows behind the first object"),
        result: Text::new(""),
        help: "Draws what each light sees behind the first object.",
    },
    PassRow {
        slug: "normals",
        label: text!("normals"),
        work: PassWork::Meshes(Stage::Normals),
        reads: &[],
        writes: SURFACE,
        map: "",
        purpose: text!("curvature of the surface"),
        result: Text::new(""),
        help: "Draws normals and depth, for the curvature pass.",
    },
    PassRow {
        slug: "curvature",
        label: text!("curvature"),
        work: measured("curvature", 3),
        reads: reads!("normals"),
        writes: CURVATURE,
        map: "curvature_map",
        purpose: text!("curvature"),
        result: text!("curvature is"),
        help: "Finds curvature from normals and depth.",
    },
    PassRow {
        slug: "curvature_sparse",
        label: text!("sparse curvature"),
        work: measured("curvature_sparse", 3),
        reads: reads!("normals"),
        writes: CURVATURE,
        map: "curvature_sparse_map",
        purpose: text!("curvature from four neighbors, its cheaper tier"),
        result: text!("curvature is"),
        help: "Finds curvature from normals and depth of four neighbors alone.",
    },
    PassRow {
        slug: "curvature_tensor",
        label: text!("curvature tensor"),
        work: measured("curvature_tensor", 3),
        reads: reads!("normals"),
        writes: TENSOR,
        map: "curvature_tensor_map",
        purpose: text!("curvature by direction"),
        result: text!("curvature is"),
        help: "Finds curvature by direction from normals and depth.",
    },
    smooth(
        "smooth_normals_1",
        (text!("smooth normals 1"), "smooth_normal_1_map"),
        reads!("normals", "normals", "surface"),
        &[("LEVEL", 1)],
        "Smooths normals from neighbors two steps away.",
    ),
    smooth(
        "smooth_normals_2",
        (text!("smooth normals 2"), "smooth_normal_2_map"),
        reads!("normals", "smooth_normals_1", "normal"),
        &[("LEVEL", 2)],
        "Smooths normals further, from neighbors four steps away.",
    ),
    smooth(
        "smooth_normals_3",
        (text!("smooth normals 3"), "smooth_normal_3_map"),
        reads!("normals", "smooth_normals_2", "normal"),
        &[("LEVEL", 3)],
        "Smooths normals further, from neighbors eight steps away.",
    ),
    smooth(
        "smooth_normals_4",
        (text!("smooth normals 4"), "smooth_normal_4_map"),
        reads!("normals", "smooth_normals_3", "normal"),
        &[("LEVEL", 4)],
        "Smooths normals further, from neighbors sixteen steps away.",
    ),
    PassRow {
        slug: "detail_normals",
        label: text!("detail normals"),
        work: PassWork::Meshes(Stage::DetailNormals),
        reads: &[],
        writes: SURFACE,
        map: "",
        purpose: text!("curvature of the detail normals"),
        result: Text::new(""),
        help: "Draws detail normals and depth, for the curvature pass.",
    },
    PassRow {
        slug: "detail_curvature",
        label: text!("detail curvature"),
        work: measured("curvature", 3),
        reads: reads!("detail_normals"),
        writes: CURVATURE,
        map: "curvature_detail_map",
        purpose: text!("curvature"),
        result: text!("curvature is"),
        help: "Finds curvature from normals and depth.",
    },
    PassRow {
        slug: "detail_curvature_sparse",
        label: text!("sparse detail curvature"),
        work: measured("curvature_sparse", 3),
        reads: reads!("detail_normals"),
        writes: CURVATURE,
        map: "curvature_detail_sparse_map",
        purpose: text!("curvature from four neighbors, its cheaper tier"),
        result: text!("curvature is"),
        help: "Finds curvature from normals and depth of four neighbors alone.",
    },
    PassRow {
        slug: "facets",
        label: text!("facets"),
        work: PassWork::Meshes(Stage::Facets),
        reads: &[],
        writes: SURFACE,
        map: "facet_map",
        purpose: text!("outlines"),
        result: Text::new(""),
        help: "Draws normals, depth, objects, materials and ids, for lines.",
    },
    PassRow {
        slug: "edges",
        label: text!("edges"),
        work: measured("edges", 14),
        reads: reads!("facets"),
        writes: EDGES,
        map: "",
        purpose: text!("edges"),
        result: text!("edges are"),
        help: "Finds where surfaces end, fold and meet.",
    },
    columns("edge_columns", text!("edge columns"), COLUMNS_READ, OF_SURFACE),
    lines(("line_nearness", text!("lines"), "line_nearness_map"), LINES_READ, OF_SURFACE),
    columns("edge_columns_short", text!("edge columns nearby"), COLUMNS_READ, OF_SURFACE_NEARBY),
    lines(
        ("line_nearness_short", text!("lines nearby"), "line_short_map"),
        SHORT_READ,
        OF_SURFACE_NEARBY,
    ),
    PassRow {
        slug: "hidden_facets",
        label: text!("hidden facets"),
        work: PassWork::Meshes(Stage::HiddenFacets),
        reads: &[PassInput { binding: "facet_map", pass: "facets", output: "surface" }],
        writes: SURFACE,
        map: "",
        purpose: text!("hidden lines"),
        result: text!("what lies behind is"),
        help: "Draws what lies behind the first surface, for the passes of hidden lines.",
    },
    PassRow {
        slug: "hidden_edges",
        label: text!("hidden edges"),
        work: measured("hidden_edges", 14),
        reads: HIDDEN_EDGES_READ,
        writes: EDGES,
        map: "",
        purpose: text!("hidden edges"),
        result: text!("hidden edges are"),
        help: "Finds where surfaces behind the first end, fold and meet.",
    },
    columns("hidden_columns", text!("hidden edge columns"), HIDDEN_COLUMNS_READ, OF_ALL),
    lines(("hidden_nearness", text!("hidden lines"), "hidden_map"), HIDDEN_READ, OF_ALL),
    PassRow {
        slug: "outlines",
        label: text!("outlines"),
        work: PassWork::Screen {
            shader: "outlines",
            constants: &[],
            reach: OUTLINES_REACH,
            extent: ScreenExtent::Picture,
        },
        reads: COLUMNS_READ,
        writes: LINES,
        map: "",
        purpose: text!("outlines of the scene"),
        result: text!("lines are"),
        help: "Draws a scene's lines over the picture.",
    },
    PassRow {
        slug: "near_slices",
        label: text!("occlusion slices"),
        work: measured("near_slices", 256),
        reads: reads!("normals"),
        writes: SHARES,
        map: "",
        purpose: text!("slices of what stands near"),
        result: text!("occlusion is"),
        help: "Finds how much stands near along two slices a pixel.",
    },
    PassRow {
        slug: "near_shares",
        label: text!("occlusion"),
        work: measured("near_shares", 2),
        reads: SHARES_READ,
        writes: SHARES,
        map: "near_shares_map",
        purpose: text!("occlusion, its cheaper tier"),
        result: text!("occlusion is"),
        help: "Joins the slices of four by four pixels.",
    },
    PassRow {
        slug: "draw",
        label: text!("look"),
        work: PassWork::Meshes(Stage::Draw),
        reads: &[],
        writes: COLOR,
        map: "",
        purpose: text!("the picture"),
        result: Text::new(""),
        help: "Draws a mesh with the look; the result is straight RGBA.",
    },
];
