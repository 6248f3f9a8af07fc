//! An interpreter over naga IR, in f64 or f32.
//!
//! [`Program::compile`] turns one function of a `naga::Module`, with all that it calls, into a flat list of
//! instructions over numbered slots; [`Program::call`] runs it. Whatever is decidable is decided while compiling:
//! types, shapes, swizzles, jumps, where every value lies. At run time there is no map, no tree and no call stack.
//!
//! # Layout
//!
//! - Memory is one list of 64-bit **slots**. A slot holds one scalar: the bits of an f64, an i32 or u32 in its low 32
//!   bits, a bool as 0 or 1, or the number of another slot (a pointer). Composites take a slot for each scalar, in
//!   order, matrices by columns, without padding.
//! - While compiling, an expression is the list of the slots of its scalars, which need not be neighbours: `Compose`,
//!   `Splat`, `Swizzle` and constant indices therefore cost no instruction. Only what is indexed dynamically is
//!   gathered into neighbours first.
//! - Slots are never shared: WGSL has no recursion, so each function's arguments, locals and temporaries have one fixed
//!   place. A call copies arguments there and writes where to go on into the callee's *link* slot.
//! - Callees precede their callers in the code, and every construct's code stands between its entry and its exit.
//!   Lanes that run in lockstep can thus reconverge by always advancing those with the smallest program counter.
//!
//! # What a number is
//!
//! With [`Precision::F64`] every float is an f64, and nothing is rounded to f32 but bitcasts, which go through f32's bits,
//! and literals, which naga's WGSL front end has already rounded (and folded, in f32) before this sees them. With
//! [`Precision::F32`] each float operation is computed in f64 and rounded to f32, which for `+ - * / sqrt` is exactly f32
//! arithmetic, and for the rest the nearest f32 to a nearly exact result. Nothing flushes subnormals; infinities
//! and NaN propagate as in IEEE 754. Functions composed of others (`dot`, `mix`, `smoothstep`, `refract`, ...) follow the
//! formulas of the WGSL specification step by step. WGSL's own 64-bit and 16-bit numbers are not supported, but
//! that a value of type f64 is a float like any other.
//!
//! Where WGSL leaves room, this does what naga's back ends do: an index out of bounds is clamped (a negative one to the
//! last), shifts use the amount modulo 32, `x / 0` is `x` and `x % 0` is 0 for integers, conversions to integers saturate
//! and turn NaN into 0. `pow` has the domain that WGSL gives it, `exp2(y * log2(x))`: a negative base gives NaN, as on a GPU.

#![allow(clippy::result_large_err, reason = "diagnostics are large, and made only when all is lost")]

mod compile;
mod instruction;
mod machine;
mod math;
mod shape;
mod value;

#[cfg(test)]
mod tests;

pub use machine::Machine;
pub use shape::{ScalarKind, Shape};
pub use value::{Scalar, Value};

use crate::diag::Diagnostic;

/// How floats are rounded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Precision {
    /// Every float is an f64.
    #[default]
    F64,
    /// Every float operation is rounded to f32.
    F32,
}

/// What derivatives (`dpdx`, `fwidth`, ...) give where there are no neighbouring pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Derivatives {
    /// Nothing: the function is refused.
    #[default]
    Refuse,
    /// 0, as on a footprint over which everything is constant.
    Zero,
}

/// Choices made when a function is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// What derivatives give.
    pub derivatives: Derivatives,
    /// The number of instructions after which a call is given up as endless; one that copies counts for each scalar.
    pub step_limit: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self { derivatives: Derivatives::default(), step_limit: 10_000_000 }
    }
}

/// One argument of a [`Program`].
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name in the source, or empty.
    pub name: String,
    /// What it takes.
    pub shape: Shape,
    /// The first of its slots.
    slot: u32,
}

/// One function of a module with all that it calls, ready to run any number of times, on any number of threads.
#[derive(Clone, Debug)]
pub struct Program {
    name: String,
    code: Vec<instruction::Instruction>,
    switches: Vec<instruction::Switch>,
    /// What memory holds before a call: the constants, and zeros.
    image: Vec<u64>,
    /// Slots of float constants that f32 cannot hold, to be rounded for [`Precision::F32`].
    wide_constants: Vec<u32>,
    entry: u32,
    parameters: Vec<Parameter>,
    result: Shape,
    result_slot: u32,
    step_limit: u64,
}

impl Program {
    /// Compiles `function`, a function or entry point of `module`, which must have passed naga's validator.
    ///
    /// # Errors
    /// - `interp-unknown-function`: the module has none of that name.
    /// - `interp-unsupported`: it, or a function that it calls, does what only a GPU can do (textures, resources,
    ///   barriers, derivatives unless [`Derivatives::Zero`]), or uses a type that is none of bool, i32, u32, float and
    ///   their composites, or gives no result. The place has the span in the WGSL source.
    /// - `interp-too-big`: it needs more memory than the interpreter grants (32 MiB), or nests types more than 64 deep.
    pub fn compile(module: &naga::Module, function: &str, options: Options) -> Result<Self, Diagnostic> {
        compile::compile(module, function, options).map_err(|boxed| *boxed)
    }

    /// Runs it once. For many calls, keep a [`Machine`].
    ///
    /// # Errors
    /// - `interp-argument`: the number of arguments is wrong, or one has another shape than the [`parameters`](Self::parameters).
    /// - `interp-endless`: it ran for more instructions than [`Options::step_limit`].
    pub fn call(&self, arguments: &[Value], precision: Precision) -> Result<Value, Diagnostic> {
        self.machine(precision).call(arguments)
    }

    /// Memory to run it in, again and again.
    pub fn machine(&self, precision: Precision) -> Machine<'_> {
        Machine::new(self, precision)
    }

    /// The name of the function.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What it takes.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    /// What it gives.
    pub fn result(&self) -> &Shape {
        &self.result
    }
}
