//! Interpreter of naga IR, in f64 or f32.
//!
//! [`Program::compile`] turns one function of a `naga::Module`, with all functions that it calls,
//! into a flat list of instructions over numbered slots; [`Program::call`] runs the list.
//! Everything decidable is decided while compiling: types, shapes, swizzles, jumps, the place of
//! every value. At run time there is no map, no tree and no call stack.
//!
//! For a stage of a pipeline, [`Program::bind`] binds uniforms, storage buffers, textures and
//! samplers; the result makes [`Machine`]s, which run one call, and [`Lanes`], which run 64 in
//! lockstep.
//!
//! # Layout
//!
//! - Memory is one list of 64-bit **slots**. A slot holds one scalar: the bits of an f64, an i32 or
//!   u32 in its low 32 bits, a bool as 0 or 1, or the number of another slot (a pointer) or of a
//!   resource. Composites take a slot for each scalar, in order, matrices by columns, without
//!   padding.
//! - A slot is a row of as many scalars as there are lanes. The effect of an instruction is written
//!   once, in `step` and `math`, as a loop over the row, and compiled for rows of 1 and of 64: a
//!   call alone and a batch cannot disagree, and the loop over one is no loop, so folding is as
//!   fast as with scalars.
//! - While compiling, an expression is the list of the slots of its scalars, which need not be
//!   neighbors: `Compose`, `Splat`, `Swizzle` and constant indices therefore cost no instruction.
//!   Only dynamically indexed values are gathered into neighboring slots first. A value at a fixed
//!   place of a buffer has a slot that is filled when the buffer is bound, and costs no instruction
//!   either.
//! - Slots are never shared: WGSL has no recursion, so each function's arguments, locals and
//!   temporaries have one fixed place. A call copies arguments there and writes its return address
//!   into the callee's *link* slot.
//! - Callees precede their callers in the code, and every construct's code stands between its entry
//!   and its exit. Lanes that run in lockstep thus reconverge by always advancing those with the
//!   smallest program counter.
//! - A temporary is read only in the scope that computed it, by lanes that passed there. So all
//!   lanes may write it, whichever are active: nothing is masked but copies, stores and loads.
//! - A call whose result depends on its arguments alone, and that all lanes make with the same ones
//!   (a look's `prepare`, of uniforms), is run for one lane, and not again until its arguments
//!   change.
//!
//! # What a number is
//!
//! With [`Precision::F64`] every float is an f64, and nothing is rounded to f32 but bitcasts, which
//! go through f32's bits, and literals, which naga's WGSL front end has already rounded (and
//! folded, in f32) before the interpreter sees them; given the module's [`Literals`], they are
//! read again from its text. With [`Precision::F32`] each float operation is computed in
//! f64 and rounded to f32, which for `+ - * / sqrt` is exactly f32 arithmetic, and for the rest the
//! nearest f32 to a nearly exact result. Nothing flushes subnormals; infinities and NaN propagate
//! as in IEEE 754. Functions composed of others (`dot`, `mix`, `smoothstep`, `refract`, ...) follow
//! the formulas of the WGSL specification step by step. An f16 is a float, in f32 mode rounded to
//! f16 by every operation; one of type f64 is a float like any other. Integers of 64 bits are not
//! supported.
//!
//! Where WGSL leaves room, the interpreter does as naga's back ends: an index out of bounds is
//! clamped (a negative one to the last), shifts use the amount modulo 32, `x / 0` is `x` and `x %
//! 0` is 0 for integers, conversions to integers saturate and turn NaN into 0. `pow` has the domain
//! that WGSL gives it, `exp2(y * log2(x))`: a negative base gives NaN, as on a GPU. A texture load
//! from outside gives zeros; filters weigh exactly, in f64; a derivative is that of the lane's own
//! row or column, unless a coarse one is asked for; `discard` leaves the lane as a helper of its
//! quad.

#![allow(
    clippy::result_large_err,
    reason = "diagnostics are large, and made only when all is lost"
)]

mod compile;
mod image;
mod instruction;
mod lanes;
mod machine;
mod math;
mod memory;
mod observed;
mod port;
mod resources;
mod shape;
mod step;
mod value;

#[cfg(test)]
mod tests;

pub use compile::Literals;
pub use lanes::{Batch, LANES, Lanes};
pub use machine::Machine;
pub use observed::ObservedValue;
pub use port::LanePort;
pub use resources::{
    AddressMode, Bindings, BoundProgram, Filter, Resource, ResourceKind, Sampler, SamplerCompare,
    Texel, Texture, TextureDimension, TextureLevel,
};
pub use shape::{ScalarKind, Shape};
pub use value::{Scalar, Value};

use crate::diag::Diagnostic;

/// Precision of floats.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Precision {
    /// Floats are f64.
    #[default]
    F64,
    /// Floats are f32: every operation is rounded.
    F32,
}

/// Meaning of derivatives (`dpdx`, `fwidth`, ...).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Derivatives {
    /// None: a function with derivatives is refused.
    #[default]
    Refuse,
    /// Zero, as on a footprint over which everything is constant.
    Zero,
    /// Differences within 2x2 quads of [`Lanes`]; 0 where one call stands alone.
    Quads,
}

/// Options of the compilation of a function.
#[derive(Clone, Copy, Debug)]
pub struct FunctionOptions<'s> {
    /// Meaning of derivatives.
    pub derivatives: Derivatives,
    /// True if the function may use features that only a stage of a pipeline has: resources,
    /// private variables, `discard`.
    pub is_stage: bool,
    /// Literals of the module at f64, since naga has rounded them to f32; [`Precision::F32`] uses
    /// naga's.
    pub literals: Option<&'s Literals>,
    /// True if values that the source names can be read after a run.
    pub observe: bool,
    /// Number of instructions after which a call is given up as endless; an instruction that copies
    /// counts for each scalar.
    pub step_limit: u64,
}

impl Default for FunctionOptions<'_> {
    fn default() -> Self {
        Self {
            derivatives: Derivatives::default(),
            is_stage: false,
            literals: None,
            observe: false,
            step_limit: 10_000_000,
        }
    }
}

impl<'s> FunctionOptions<'s> {
    /// Options for an entry point of a pipeline, run in [`Lanes`], with constants at f64.
    pub fn stage(literals: &'s Literals) -> Self {
        Self {
            derivatives: Derivatives::Quads,
            is_stage: true,
            literals: Some(literals),
            // Rays past the triangles of a scene are long work for a batch of fragments.
            step_limit: 300_000_000,
            ..Self::default()
        }
    }
}

/// Parameter of a [`Program`].
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramParameter {
    /// Name in the source, or empty.
    pub name: String,
    /// Shape of the argument.
    pub shape: Shape,
    /// First slot of the argument.
    slot: u32,
}

/// Function of a module with all functions that it calls, ready to run any number of times, on any
/// number of threads.
#[derive(Clone, Debug)]
pub struct Program {
    name: String,
    code: Vec<instruction::Instruction>,
    switches: Vec<instruction::Switch>,
    pure_calls: Vec<instruction::PureCall>,
    /// Memory before a call: the constants, and zeros.
    image: Vec<u64>,
    /// Slots of float constants that f32 cannot hold, with their bits in [`Precision::F32`].
    wide_constants: Vec<(u32, u64)>,
    /// Slots that hold scalars of buffers, or the buffers' lengths.
    bound_slots: Vec<(u32, resources::SlotSource)>,
    resources: Vec<Resource>,
    operations: Vec<image::Operation>,
    observed: Vec<ObservedValue>,
    entry: u32,
    parameters: Vec<ProgramParameter>,
    inputs: Vec<LanePort>,
    outputs: Vec<LanePort>,
    result: Shape,
    result_slot: u32,
    step_limit: u64,
}

impl Program {
    /// Compiles `function`, a function or entry point of `module`, which must have passed naga's
    /// validator.
    ///
    /// # Errors
    /// - `interp-unknown-function`: the module has no function of that name.
    /// - `interp-unsupported`: the function, or one that it calls, uses a feature that only a GPU
    ///   has (barriers, atomics, storage textures, ray queries; derivatives unless
    ///   [`FunctionOptions::derivatives`] gives their meaning; resources unless
    ///   [`FunctionOptions::is_stage`]), or a type that is none of bool, i32, u32, float and their
    ///   composites, or gives no result and is no stage. The place has the span in the WGSL source.
    /// - `interp-too-big`: the function needs more memory than the interpreter grants (32 MiB), or
    ///   nests types more than 64 deep.
    pub fn compile(
        module: &naga::Module,
        function: &str,
        options: FunctionOptions,
    ) -> Result<Self, Diagnostic> {
        compile::compile(module, function, options).map_err(|boxed| *boxed)
    }

    /// Runs the program once. For many calls, keep a [`Machine`].
    ///
    /// # Errors
    /// - `interp-argument`: the number of arguments is wrong, or one has another shape than the
    ///   [`parameters`](Self::parameters).
    /// - `interp-endless`: the program ran for more instructions than
    ///   [`FunctionOptions::step_limit`].
    /// - `interp-unbound`: the program reads [`resources`](Self::resources); [`bind`](Self::bind)
    ///   them.
    pub fn call(&self, arguments: &[Value], precision: Precision) -> Result<Value, Diagnostic> {
        self.machine(precision).call(arguments)
    }

    /// Machine with memory in which the program runs again and again.
    pub fn machine(&self, precision: Precision) -> Machine<'_> {
        Machine::new(self, precision, &[])
    }

    /// Binds the program's resources; the result makes machines that run it.
    ///
    /// # Errors
    /// `interp-binding` for every resource that is not bound, or is bound to another kind than it
    /// takes.
    pub fn bind(
        &self,
        bindings: &Bindings,
        precision: Precision,
    ) -> Result<BoundProgram<'_>, Vec<Diagnostic>> {
        BoundProgram::new(self, bindings, precision)
    }

    /// Name of the function.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Parameters of the function.
    pub fn parameters(&self) -> &[ProgramParameter] {
        &self.parameters
    }

    /// Resources that the program reads.
    pub fn resources(&self) -> &[Resource] {
        &self.resources
    }

    /// Scalars and vectors among the arguments and the members of arguments that are structs, in
    /// order.
    pub fn inputs(&self) -> &[LanePort] {
        &self.inputs
    }

    /// Scalars and vectors of the result, or the members of a result that is a struct, in order.
    pub fn outputs(&self) -> &[LanePort] {
        &self.outputs
    }

    /// Shape of the result; an empty struct if there is none.
    pub fn result(&self) -> &Shape {
        &self.result
    }
}
