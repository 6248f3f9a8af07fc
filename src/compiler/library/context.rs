//! What a node may ask of its surroundings: the surface, the camera, the clock and the lights.

use crate::document::{LightInput, Tier};

/// When a value is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Rate {
    /// When the look is compiled.
    #[default]
    Constant,
    /// Once a frame.
    Frame,
    /// Once an object.
    Object,
    /// At each vertex.
    Vertex,
    /// At each fragment.
    Fragment,
}

/// A value from the surroundings; the word after `from=` in a node's `@param`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Context {
    /// Unit surface normal, world space, toward the side that is seen.
    Normal,
    /// Unit, from the surface to the eye, world space.
    View,
    /// World space.
    Position,
    /// The object's own space.
    PositionObject,
    /// Camera axes: x right, y up, z toward the viewer, from the eye.
    PositionCamera,
    /// Texture coordinates; v up.
    Uv,
    /// Straight RGBA of the vertices; white where the mesh has none.
    VertexColor,
    /// Unit, along u, world space, orthogonal to the normal.
    Tangent,
    /// Unit, along v, world space.
    Bitangent,
    /// Distance in front of the eye along the viewing axis, scene units.
    Depth,
    /// Signed curvature of the surface in 1/viewport-height, convex positive.
    Kappa,
    /// The same from four neighbours of a pixel.
    KappaSparse,
    /// The same from the derivatives of the fragment's normal, without any pass before.
    KappaFast,
    /// The same as `Kappa`, of the normal that the Output node is given.
    KappaDetail,
    /// The same from four neighbours of a pixel.
    KappaDetailSparse,
    /// Curvature of the surface by direction: xx, xy and yy in camera axes, in 1/viewport-height,
    /// convex positive.
    Tensor,
    /// The same from the derivatives of the fragment's normal, without any pass before.
    TensorFast,
    /// The surface's normal smoothed over the picture, world space; level 1 the least,
    /// [`SMOOTH_LEVELS`] the most.
    SmoothNormal(u8),
    /// The rotation from world to camera axes.
    CameraFromWorld,
    /// Counts objects from 0.
    ObjectId,
    /// Seconds.
    Time,
    /// Frames since the start of the time range.
    Frame,
    /// Width and height in pixels.
    Viewport,
    /// The pixel's place from the picture's upper left corner: x to the right, y down, in pixels;
    /// centres lie at halves.
    Pixel,
    /// Where the object's origin is seen from the picture's middle, x to the right and y down, and
    /// how large a unit of the scene is seen there; in picture heights.
    Anchor,
    /// How large a unit of the scene is seen at this distance, in picture heights.
    Magnification,
    /// Turns normals and gradients of the object's own space into world space.
    WorldFromNormal,
    /// What the light that the node names gives.
    Light(LightInput),
}

/// How many levels of smoothed normals there are.
pub const SMOOTH_LEVELS: u8 = 4;

type Row = (Context, &'static str, &'static str, Rate, &'static str);

/// Every context with the word that node files use, its WGSL type, its rate, and what it is; those
/// of lights are rows of [`LightInput`].
const TABLE: &[Row] = &[
    (
        Context::Normal,
        "normal",
        "vec3f",
        Rate::Fragment,
        "unit surface normal, world space, toward the side that is seen",
    ),
    (
        Context::View,
        "view",
        "vec3f",
        Rate::Fragment,
        "unit, from the surface to the eye, world space",
    ),
    (
        Context::Position,
        "position",
        "vec3f",
        Rate::Fragment,
        "the place on the surface, world space",
    ),
    (
        Context::PositionObject,
        "position_object",
        "vec3f",
        Rate::Fragment,
        "the place on the surface, the object's own space",
    ),
    (
        Context::PositionCamera,
        "position_camera",
        "vec3f",
        Rate::Fragment,
        "the place on the surface from the eye, camera axes: x right, y up, z toward the viewer",
    ),
    (Context::Uv, "uv", "vec2f", Rate::Fragment, "texture coordinates; v up"),
    (
        Context::VertexColor,
        "vertex_color",
        "Color",
        Rate::Fragment,
        "straight RGBA of the vertices; white where the mesh has none",
    ),
    (
        Context::Tangent,
        "tangent",
        "vec3f",
        Rate::Fragment,
        "unit, along u, world space, at a right angle to the normal",
    ),
    (Context::Bitangent, "bitangent", "vec3f", Rate::Fragment, "unit, along v, world space"),
    (
        Context::Depth,
        "depth",
        "f32",
        Rate::Fragment,
        "distance in front of the eye along the viewing axis, scene units",
    ),
    (
        Context::Kappa,
        "kappa",
        "f32",
        Rate::Fragment,
        "signed curvature of the surface in 1/viewport-height, convex positive",
    ),
    (
        Context::KappaSparse,
        "kappa_sparse",
        "f32",
        Rate::Fragment,
        "the same from four neighbours of a pixel, two steps away",
    ),
    (
        Context::KappaFast,
        "kappa_fast",
        "f32",
        Rate::Fragment,
        "the same from the normals of neighbouring pixels alone, without a pass of its own; \
         triangles show in it",
    ),
    (
        Context::KappaDetail,
        "kappa_detail",
        "f32",
        Rate::Fragment,
        "signed curvature of the Output node's detail normal, in 1/viewport-height",
    ),
    (
        Context::KappaDetailSparse,
        "kappa_detail_sparse",
        "f32",
        Rate::Fragment,
        "the same from four neighbours of a pixel, two steps away",
    ),
    (
        Context::Tensor,
        "curvature_tensor",
        "vec3f",
        Rate::Fragment,
        "curvature of the surface by direction: xx, xy and yy in camera axes, in \
         1/viewport-height, convex positive",
    ),
    (
        Context::TensorFast,
        "curvature_tensor_fast",
        "vec3f",
        Rate::Fragment,
        "the same from the normals of neighbouring pixels alone, without a pass of its own; \
         triangles show in it",
    ),
    (
        Context::SmoothNormal(1),
        "smooth_normal_1",
        "vec3f",
        Rate::Fragment,
        "the surface's normal smoothed over 1/570 of the picture's height, world space; 0 where \
         there is none",
    ),
    (
        Context::SmoothNormal(2),
        "smooth_normal_2",
        "vec3f",
        Rate::Fragment,
        "the same over 1/250 of the height",
    ),
    (
        Context::SmoothNormal(3),
        "smooth_normal_3",
        "vec3f",
        Rate::Fragment,
        "the same over 1/125 of the height",
    ),
    (
        Context::SmoothNormal(4),
        "smooth_normal_4",
        "vec3f",
        Rate::Fragment,
        "the same over 1/60 of the height",
    ),
    (
        Context::CameraFromWorld,
        "camera_from_world",
        "mat3x3f",
        Rate::Frame,
        "the rotation from world to camera axes",
    ),
    (Context::ObjectId, "object_id", "f32", Rate::Object, "counts objects from 0"),
    (Context::Time, "time", "f32", Rate::Frame, "seconds"),
    (Context::Frame, "frame", "f32", Rate::Frame, "frames since the start of the time range"),
    (Context::Viewport, "viewport", "vec2f", Rate::Frame, "width and height in pixels"),
    (
        Context::Pixel,
        "pixel",
        "vec2f",
        Rate::Fragment,
        "the pixel's place from the picture's upper left corner, x to the right and y down, in \
         pixels; centres lie at halves",
    ),
    (
        Context::Anchor,
        "anchor",
        "vec3f",
        Rate::Fragment,
        "where the object's origin is seen from the picture's middle, x to the right and y down, \
         and how large a unit of \
         the scene is seen there; in picture heights",
    ),
    (
        Context::Magnification,
        "magnification",
        "f32",
        Rate::Fragment,
        "how large a unit of the scene is seen at this distance, in picture heights",
    ),
    (
        Context::WorldFromNormal,
        "world_from_normal",
        "mat3x3f",
        Rate::Fragment,
        "turns normals and gradients of the object's own space into world space",
    ),
];

impl Context {
    /// All of them, with their words.
    pub fn all() -> impl Iterator<Item = (Self, &'static str)> {
        let lights = LightInput::all().map(|input| (Self::Light(input), input.word()));
        TABLE.iter().map(|row| (row.0, row.1)).chain(lights)
    }

    /// The context that a node file's `from=` names.
    pub fn from_word(word: &str) -> Option<Self> {
        Self::all().find(|(_, known)| *known == word).map(|(context, _)| context)
    }

    /// What stands for it in a node of this tier.
    ///
    /// What is off by more than is seen stands for a curvature only where an artist asked for that:
    /// in the fast tier, and in the balanced one of the node that is the measure itself
    /// (`is_measure`) and nothing else.
    pub fn at_tier(self, tier: Tier, is_measure: bool) -> Self {
        match (self, tier) {
            (Self::Kappa, Tier::Balanced) if is_measure => Self::KappaSparse,
            (Self::KappaDetail, Tier::Balanced) if is_measure => Self::KappaDetailSparse,
            (Self::Kappa, Tier::Fast) => Self::KappaFast,
            (Self::Tensor, Tier::Fast) => Self::TensorFast,
            (Self::KappaDetail, Tier::Fast) => Self::KappaDetailSparse,
            _ => self,
        }
    }

    /// Whether it is found from the derivatives of the fragment's own normal.
    pub fn is_derived(self) -> bool {
        matches!(self, Self::KappaFast | Self::TensorFast)
    }

    /// Whether it is a vector that a pass over normals finds, or what stands for one.
    pub fn is_measured_vector(self) -> bool {
        matches!(self, Self::Tensor | Self::TensorFast | Self::SmoothNormal(_))
    }

    /// Whether it is a curvature in one number, whatever of and however it is measured.
    pub fn is_curvature(self) -> bool {
        matches!(
            self,
            Self::Kappa
                | Self::KappaSparse
                | Self::KappaFast
                | Self::KappaDetail
                | Self::KappaDetailSparse
        )
    }

    fn row(self) -> Row {
        if let Self::Light(input) = self {
            return (self, input.word(), input.wgsl_type(), Rate::Object, input.help());
        }
        *TABLE.iter().find(|row| row.0 == self).expect("the table holds every context")
    }

    /// The word that node files use; also the variable's name in generated source.
    pub fn word(self) -> &'static str {
        self.row().1
    }

    /// Its WGSL type.
    pub fn wgsl_type(self) -> &'static str {
        self.row().2
    }

    /// When it is known. Lights are of object rate, because a direction key may turn them for each
    /// object.
    pub fn rate(self) -> Rate {
        self.row().3
    }

    /// What it is, with its space and unit: a phrase for docs and tooltips.
    pub fn help(self) -> &'static str {
        self.row().4
    }
}
