//! Rows of the table of passes.

use chiaro_locale::Text;

use crate::library::Context;

/// Stage: the purpose of a look's module.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Draws meshes with the look.
    #[default]
    Draw,
    /// Draws the surface's own normal, for the curvature pass.
    Normals,
    /// Draws the look's detail normal, for the curvature pass.
    DetailNormals,
    /// Draws the surface's own normal with the numbers of object, material and id, for lines.
    Facets,
    /// Draws the same of what lies behind the first surface.
    HiddenFacets,
    /// Evaluates the look at given surface samples.
    Eval,
}

/// Row of a stage: what its modules are for, and where their value comes from.
#[derive(Debug)]
pub struct StageRow {
    /// Work of a module, as a sentence.
    pub help: &'static str,
    /// Result of a module's function `shade`, as a sentence.
    pub shade: &'static str,
    /// Value that the module computes.
    pub value: StageValue,
    /// True if the module draws normals, from which later passes are made.
    pub draws_normals: bool,
    /// True if what the module draws tells the materials and ids of one object apart.
    pub tells_parts: bool,
    /// Slug of the pass whose surfaces the module leaves out, to draw what lies behind them.
    pub behind: Option<&'static str>,
}

/// Value that the modules of a stage compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StageValue {
    /// The look's output, or the output that is shown in its place.
    Output,
    /// Context of the surface.
    Context(Context),
    /// Input with this name of the look's output node.
    Input(&'static str),
}

impl Stage {
    /// Row of the stage.
    pub fn row(self) -> &'static StageRow {
        const NORMALS: StageRow = StageRow {
            help: "Draws normals and depth, for the curvature pass.",
            shade: "The normal that the curvature pass sees.",
            value: StageValue::Context(Context::NORMAL),
            draws_normals: true,
            tells_parts: false,
            behind: None,
        };
        const LOOK: StageRow = StageRow {
            help: "Draws a mesh with the look; the result is straight RGBA.",
            shade: "The look at one point of the surface.",
            value: StageValue::Output,
            draws_normals: false,
            tells_parts: false,
            behind: None,
        };
        match self {
            Self::Draw => &LOOK,
            Self::Normals => &NORMALS,
            Self::DetailNormals => {
                &const { StageRow { value: StageValue::Input("normal"), ..NORMALS } }
            }
            Self::Facets => {
                &const {
                    StageRow {
                        help: "Draws normals, depth, objects, materials and ids, for lines.",
                        shade: "The normal that the passes of lines see.",
                        tells_parts: true,
                        ..NORMALS
                    }
                }
            }
            Self::HiddenFacets => {
                &const {
                    StageRow {
                        help: "Draws what lies behind the first surface, for hidden lines.",
                        shade: "The normal that the passes of hidden lines see.",
                        tells_parts: true,
                        behind: Some("facets"),
                        ..NORMALS
                    }
                }
            }
            Self::Eval => {
                &const {
                    StageRow {
                        help: "Evaluates the look at given surface samples, four pixels each.",
                        ..LOOK
                    }
                }
            }
        }
    }

    /// True for a stage that draws normals.
    pub fn draws_normals(self) -> bool {
        self.row().draws_normals
    }

    /// True for a stage whose modules draw meshes, in a pass.
    pub fn draws_meshes(self) -> bool {
        super::PassId::of_stage(self).is_some()
    }

    /// True for the stage whose modules draw the picture.
    pub fn is_picture(self) -> bool {
        super::PassId::of_stage(self).is_some_and(super::PassId::writes_picture)
    }
}

/// Row of the table of passes.
#[derive(Debug)]
pub struct PassRow {
    /// Name of the pass in exports and in the rows of other tables.
    pub slug: &'static str,
    /// Label that people read.
    pub label: Text,
    /// Work of the pass.
    pub work: PassWork,
    /// Results of earlier passes that the pass reads, by the names of its module's textures.
    pub reads: &'static [PassInput],
    /// Textures that the pass draws into, in the order of locations.
    pub writes: &'static [PassOutput],
    /// Name under which a look's module binds the first of the written textures; empty where no
    /// look reads the pass.
    pub map: &'static str,
    /// Quantity that a look reads from the pass; of a pass that draws meshes, its purpose.
    pub purpose: Text,
    /// Quantity that the pass computes from meshes' normals, with its verb: `curvature is` computed
    /// from them.
    pub result: Text,
    /// Work of the module, as a sentence.
    pub help: &'static str,
}

/// Work of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassWork {
    /// Depth-tested drawing of every mesh, by its look's module of this stage.
    Meshes(Stage),
    /// Drawing of one triangle over the whole picture.
    Screen {
        /// Name of the file in `shaders/passes`, without its ending.
        shader: &'static str,
        /// Values of constants of that file.
        constants: &'static [(&'static str, i32)],
        /// Distance around a pixel that is read, in steps of 1/800 of the picture's height.
        reach: u32,
        /// Pixels at which it may result in more than 0.
        extent: ScreenExtent,
    },
    /// Depth-tested drawing of every mesh that casts shadows, as each light sees them, with one
    /// module for all: a layer for each light that looks ask about.
    Lights {
        /// Name of the file in `shaders/passes`, without its ending.
        shader: &'static str,
    },
}

/// Pixels at which a pass over the picture may result in more than 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScreenExtent {
    /// Pixels that show the surface that the pass is made from; with several samples a pixel, those
    /// beside it, too.
    Surface,
    /// Pixels around it, too, as far as the pass reaches.
    Around,
    /// The same; the result is no image but laid over the picture when the looks are drawn,
    /// premultiplied and in display colors.
    Picture,
}

/// Texture that a pass reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassInput {
    /// Name of the module's variable.
    pub binding: &'static str,
    /// Slug of the pass that drew the texture.
    pub pass: &'static str,
    /// Name of the texture among that pass's outputs.
    pub output: &'static str,
}

/// Texture that a pass draws into, as large as the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassOutput {
    /// Name of the texture among the pass's outputs.
    pub name: &'static str,
    /// Format of a texel.
    pub format: TexelFormat,
}

/// Format of a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TexelFormat {
    /// One f32.
    Number,
    /// Four f32.
    Numbers,
    /// Color of the picture, with the picture's samples: half floats here, and in exports the
    /// host's own format.
    Picture,
}

impl TexelFormat {
    /// Number of channels.
    pub fn channels(self) -> usize {
        if self == Self::Number { 1 } else { 4 }
    }

    /// Size of a texel, in bytes.
    pub fn bytes(self) -> u64 {
        match self {
            Self::Number => 4,
            Self::Numbers => 16,
            Self::Picture => 8,
        }
    }

    /// Name of the format in WebGPU; `any` for the host's own color target.
    pub fn name(self) -> &'static str {
        match self {
            Self::Number => "r32float",
            Self::Numbers => "rgba32float",
            Self::Picture => "any",
        }
    }
}

/// Size of a pixel in a depth buffer, in bytes.
const DEPTH_BYTES: u64 = 4;

impl PassRow {
    /// Index of an output among [`writes`](Self::writes).
    pub fn output(&self, name: &str) -> Option<usize> {
        self.writes.iter().position(|output| output.name == name)
    }

    /// True if the pass draws into the picture.
    pub fn writes_picture(&self) -> bool {
        self.writes.iter().any(|output| output.format == TexelFormat::Picture)
    }

    /// Name of the pass's module: that of its file, where no constants of the file are set.
    pub fn module(&self) -> &'static str {
        match self.work {
            PassWork::Screen { shader, constants: [], .. } => shader,
            _ => self.slug,
        }
    }

    /// Memory that the pass keeps, and memory that it at least reads and writes once, in bytes a
    /// pixel, for a picture of so many `samples` a pixel.
    pub fn bytes_per_pixel(&self, samples: u32) -> (u64, u64) {
        let written: u64 = self.writes.iter().map(|output| output.format.bytes()).sum();
        match self.work {
            PassWork::Meshes(_) => {
                let drawn = written + DEPTH_BYTES;
                if self.writes_picture() && samples > 1 {
                    // Samples are written, read and averaged.
                    let samples = u64::from(samples);
                    (written + samples * drawn, written + 2 * samples * drawn)
                } else {
                    (drawn, drawn)
                }
            }
            // By the layer, whose size has nothing to do with the picture's.
            PassWork::Lights { .. } => (0, 0),
            // It is written into the picture.
            PassWork::Screen { extent: ScreenExtent::Picture, .. } => {
                (0, self.bytes_read() + 2 * TexelFormat::Picture.bytes())
            }
            // The look reads the written texture again.
            PassWork::Screen { .. } => (written, self.bytes_read() + 2 * written),
        }
    }

    fn bytes_read(&self) -> u64 {
        let format = |input: &PassInput| {
            let read = super::PassId::from_slug(input.pass)?.row();
            Some(read.writes[read.output(input.output)?].format.bytes())
        };
        // A texture that has two names is read once.
        let is_same = |a: &PassInput, b: &PassInput| (a.pass, a.output) == (b.pass, b.output);
        let reads = self.reads.iter().enumerate();
        let is_first = |(index, input): &(usize, &PassInput)| {
            !self.reads[..*index].iter().any(|before| is_same(before, input))
        };
        reads.filter(is_first).filter_map(|(_, input)| format(input)).sum()
    }
}
