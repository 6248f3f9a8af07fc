//! What a row of the table of passes says.

/// What a look's module is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Draws meshes with the look.
    #[default]
    Draw,
    /// Draws the surface's own normal, for the curvature pass.
    Normals,
    /// Draws the look's detail normal, for the curvature pass.
    DetailNormals,
    /// Evaluates the look at given surface samples.
    Eval,
}

impl Stage {
    /// Whether it draws normals.
    pub fn is_normals(self) -> bool {
        matches!(self, Self::Normals | Self::DetailNormals)
    }
}

/// A row of the table of passes.
#[derive(Debug)]
pub struct PassRow {
    /// What exports and the rows of other tables call it.
    pub slug: &'static str,
    /// What people read.
    pub label: &'static str,
    /// What is run.
    pub work: PassWork,
    /// Results of earlier passes that it reads, by the names of its module's textures.
    pub reads: &'static [PassInput],
    /// The textures that it draws into, in the order of locations.
    pub writes: &'static [PassOutput],
    /// The name under which a look's module binds the first of them; empty where none does.
    pub map: &'static str,
    /// What a look reads by it; of a pass that draws meshes, what it is for.
    pub purpose: &'static str,
    /// What it makes of meshes' normals, with its verb: `curvature is` computed from them.
    pub result: &'static str,
    /// What its module does, as a sentence.
    pub help: &'static str,
}

/// What a pass runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassWork {
    /// Every mesh is drawn, depth-tested, by its look's module of this stage.
    Meshes(Stage),
    /// One triangle over the whole picture is drawn.
    Screen {
        /// The file of `shaders/passes`, without its ending.
        shader: &'static str,
        /// What constants of that file are set to.
        constants: &'static [(&'static str, i32)],
        /// How far around a pixel it reads, in steps of 1/800 of the picture's height.
        reach: u32,
    },
}

/// A texture that a pass reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassInput {
    /// The module's variable.
    pub binding: &'static str,
    /// The slug of the pass that made it.
    pub pass: &'static str,
    /// Which of that pass's outputs it is.
    pub output: &'static str,
}

/// A texture that a pass draws into, as large as the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassOutput {
    /// Its name among the pass's outputs.
    pub name: &'static str,
    /// What a texel holds.
    pub format: TexelFormat,
}

/// What a texel holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TexelFormat {
    /// A number, f32.
    Number,
    /// Four numbers, f32.
    Numbers,
    /// A color of the picture, with the picture's samples: half floats here, and in exports the
    /// host's own format.
    Picture,
}

impl TexelFormat {
    /// How many numbers it is.
    pub fn channels(self) -> usize {
        if self == Self::Number { 1 } else { 4 }
    }

    /// Bytes.
    pub fn bytes(self) -> u64 {
        match self {
            Self::Number => 4,
            Self::Numbers => 16,
            Self::Picture => 8,
        }
    }

    /// The name in WebGPU; `any` for the host's own color target.
    pub fn name(self) -> &'static str {
        match self {
            Self::Number => "r32float",
            Self::Numbers => "rgba32float",
            Self::Picture => "any",
        }
    }
}

/// Bytes of a pixel in a depth buffer.
const DEPTH_BYTES: u64 = 4;

impl PassRow {
    /// Where an output lies among [`writes`](Self::writes).
    pub fn output(&self, name: &str) -> Option<usize> {
        self.writes.iter().position(|output| output.name == name)
    }

    /// The name of its module: that of its file, where the file is not set to anything.
    pub fn module(&self) -> &'static str {
        match self.work {
            PassWork::Screen { shader, constants: [], .. } => shader,
            _ => self.slug,
        }
    }

    /// Bytes a pixel that it keeps, and that it at least reads and writes once, in a picture of so
    /// many samples a pixel.
    pub fn bytes_per_pixel(&self, samples: u32) -> (u64, u64) {
        let written: u64 = self.writes.iter().map(|output| output.format.bytes()).sum();
        match self.work {
            PassWork::Meshes(_) => {
                let is_picture =
                    self.writes.iter().any(|output| output.format == TexelFormat::Picture);
                let drawn = written + DEPTH_BYTES;
                if is_picture && samples > 1 {
                    // Samples are written, read and averaged.
                    let samples = u64::from(samples);
                    (written + samples * drawn, written + 2 * samples * drawn)
                } else {
                    (drawn, drawn)
                }
            }
            // What is written is read again by the look.
            PassWork::Screen { .. } => (written, self.bytes_read() + 2 * written),
        }
    }

    fn bytes_read(&self) -> u64 {
        let format = |input: &PassInput| {
            let read = super::PassId::from_slug(input.pass)?.row();
            Some(read.writes[read.output(input.output)?].format.bytes())
        };
        self.reads.iter().filter_map(format).sum()
    }
}
