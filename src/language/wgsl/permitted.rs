//! Rules for the code of a node, which may hold functions that a look calls, structs, constants and
//! small variables.
//!
//! A node has no bindings, no pipeline constants and no workgroup of its own, so resources,
//! overrides, entry points and barriers have no meaning in it; and drivers keep variables in
//! registers, so variables are small.

use std::ops::Range;

use chiaro_locale::tr;
use naga::{AddressSpace, Block, Expression, Function, Handle, Module, Statement, TypeInner};

use super::operations::Operations;
use super::validate::{ValidModule, WgslError};

/// Greatest size of all variables of a node's code, private ones included, in bytes.
///
/// Mesa's software Vulkan keeps arrays in registers and compiles them in quadratic time: 2 KiB in 1
/// s, 4 KiB in 6 s, 8 KiB in 29 s.
pub const MAX_VARIABLE_BYTES: u64 = 2048;
/// Greatest size of a type, and of all arrays of one function that are indexed by a variable
/// number, in bytes.
///
/// naga copies an array that is no variable into one for such an index. 512 vectors of 4 floats
/// take software Vulkan 2 s.
pub const MAX_TABLE_BYTES: u64 = 8192;
/// Greatest number of elements of such an array; 1,024 floats take software Vulkan 7 s.
pub const MAX_TABLE_LENGTH: u64 = 512;
/// Greatest number of operations of one function, those of called functions included. Functions
/// that call one another twice double them. 16,000 take software Vulkan 40 s.
pub const MAX_CODE_OPERATIONS: u64 = 10_000;

/// Errors of everything in the part `own` of a module's text that is not permitted, with places.
pub fn refusals(valid: &ValidModule, own: &Range<usize>) -> Vec<WgslError> {
    let mut refused = Refusals { valid, own, told: Vec::new() };
    refused.overrides();
    refused.variables();
    refused.entry_points();
    refused.types();
    refused.functions();
    refused.told
}

struct Refusals<'a> {
    valid: &'a ValidModule,
    own: &'a Range<usize>,
    told: Vec<WgslError>,
}

impl<'a> Refusals<'a> {
    fn module(&self) -> &'a Module {
        &self.valid.module
    }

    fn tell(&mut self, span: naga::Span, message: String) {
        self.told.push(WgslError { message, span: span.to_range() });
    }

    /// True for a declaration in the node's own code; imported code belongs to Chiaro.
    fn is_own(&self, span: naga::Span) -> bool {
        span.to_range().is_none_or(|span| self.own.start <= span.start)
    }

    fn overrides(&mut self) {
        for (handle, found) in self.module().overrides.iter() {
            let name = found.name.as_deref().unwrap_or_default();
            let message = tr!(
                "no pipeline gives the override `{name}` a value: write `const {name} = ...;`, or \
                 make it \
                 a parameter"
            );
            self.tell(self.module().overrides.get_span(handle), message);
        }
    }

    fn variables(&mut self) {
        let mut bytes = 0;
        for (handle, variable) in self.module().global_variables.iter() {
            let span = self.module().global_variables.get_span(handle);
            if !self.is_own(span) {
                continue;
            }
            let name = variable.name.as_deref().unwrap_or_default();
            if variable.space == AddressSpace::Private {
                bytes += self.size(variable.ty);
                self.variable_bytes(bytes, name, span);
                continue;
            }
            let instead = match variable.space {
                AddressSpace::Handle => {
                    tr!("take an image as a parameter, with its sampler after it: \
                     `image: texture_2d<f32>, image_sampler: sampler`")
                }
                AddressSpace::Uniform => tr!("take the value as a parameter"),
                _ => tr!("`const` and `var<private>` are what there is outside functions"),
            };
            self.tell(span, tr!("nothing can be bound to `{name}` in a node: {instead}"));
        }
        for (handle, function) in self.module().functions.iter() {
            if self.is_own(self.module().functions.get_span(handle)) {
                for (local, variable) in function.local_variables.iter() {
                    bytes += self.size(variable.ty);
                    let name = variable.name.as_deref().unwrap_or_default();
                    self.variable_bytes(bytes, name, function.local_variables.get_span(local));
                }
            }
        }
    }

    /// Reports the first variable that exceeds the bound.
    fn variable_bytes(&mut self, bytes: u64, name: &str, span: naga::Span) {
        let is_told =
            self.told.iter().any(|error| error.message.contains("variables of this code"));
        if bytes > MAX_VARIABLE_BYTES && !is_told {
            let message =
                tr!("with `{name}` the variables of this code take {bytes} bytes, and at most \
                 {MAX_VARIABLE_BYTES} are compiled in good time: use shorter arrays");
            self.tell(span, message);
        }
    }

    fn size(&self, ty: Handle<naga::Type>) -> u64 {
        self.module().types[ty]
            .inner
            .try_size(self.module().to_ctx())
            .map_or(u64::MAX >> 16, u64::from)
    }

    fn entry_points(&mut self) {
        for entry in &self.module().entry_points {
            let message = tr!(
                "`{name}` is an entry point, and a node's functions are called: leave `@{stage}` \
                 out",
                name = entry.name,
                stage = stage(entry.stage)
            );
            let span = entry
                .function
                .expressions
                .iter()
                .next()
                .map(|(first, _)| entry.function.expressions.get_span(first));
            self.tell(span.unwrap_or_default(), message);
        }
    }

    /// Reports types of values that are too large; none where another problem is reported, as a too
    /// large variable's type is no news.
    fn types(&mut self) {
        if !self.told.is_empty() {
            return;
        }
        for (handle, ty) in self.module().types.iter() {
            let bytes = self.size(handle);
            if bytes > MAX_TABLE_BYTES {
                let name = ty
                    .name
                    .as_ref()
                    .map_or_else(|| tr!("an array").to_owned(), |name| format!("`{name}`"));
                let message =
                    tr!("{name} takes {bytes} bytes, and a value at most {MAX_TABLE_BYTES}: use \
                     shorter arrays");
                self.tell(self.module().types.get_span(handle), message);
            }
        }
    }

    fn functions(&mut self) {
        let operations = Operations::of(self.module());
        for (handle, function) in self.module().functions.iter() {
            let span = self.module().functions.get_span(handle);
            if !self.is_own(span) {
                continue;
            }
            let name = function.name.clone().unwrap_or_default();
            self.tables(handle, function);
            if let Some(place) = barrier(&function.body) {
                self.tell(
                    place,
                    tr!("a barrier waits for a workgroup, and a look has none").to_owned(),
                );
            }
            self.imported_resources(handle, &name, span);
            let count = operations.of_function(self.module(), &name);
            if count > MAX_CODE_OPERATIONS {
                let message = tr!(
                    "`{name}` asks for {count} operations, with those of what it calls, and at \
                     most \
                     {MAX_CODE_OPERATIONS} are compiled in good time"
                );
                self.tell(span, message);
                // The callers of this function have at least as many operations.
                return;
            }
        }
    }

    /// Reports arrays that are no variables and are indexed by a variable number.
    fn tables(&mut self, handle: Handle<Function>, function: &Function) {
        let info = &self.valid.info[handle];
        let mut bytes = 0;
        for (access, expression) in function.expressions.iter() {
            let Expression::Access { base, .. } = *expression else { continue };
            let ty = info[base].ty.inner_with(&self.module().types);
            let TypeInner::Array { stride, .. } = *ty else { continue };
            let size = ty.try_size(self.module().to_ctx()).map_or(u64::MAX >> 16, u64::from);
            bytes += size;
            let length = size / u64::from(stride.max(1));
            let span = function.expressions.get_span(access);
            if length > MAX_TABLE_LENGTH {
                let message = tr!(
                    "an array has {length} elements, and one that is looked up in has at most \
                     {MAX_TABLE_LENGTH}"
                );
                self.tell(span, message);
                return;
            }
            if bytes > MAX_TABLE_BYTES {
                let message = tr!(
                    "the arrays that are looked up in here take {bytes} bytes, and in one function \
                     at most \
                     {MAX_TABLE_BYTES}: look each up once, in a function of its own"
                );
                self.tell(span, message);
                return;
            }
        }
    }

    /// Reports imported functions of passes, which read resources that only passes have.
    fn imported_resources(&mut self, handle: Handle<Function>, name: &str, span: naga::Span) {
        let uses = &self.valid.info[handle];
        let is_foreign = |global: Handle<naga::GlobalVariable>| {
            self.module().global_variables[global].space != AddressSpace::Private
                && !uses[global].is_empty()
                && !self.is_own(self.module().global_variables.get_span(global))
        };
        if let Some((_, found)) =
            self.module().global_variables.iter().find(|(global, _)| is_foreign(*global))
        {
            let resource = found.name.clone().unwrap_or_default();
            let message =
                tr!("`{name}` reads `{resource}`, which passes are given and nodes are not");
            self.tell(span, message);
        }
    }
}

fn stage(stage: naga::ShaderStage) -> &'static str {
    match stage {
        naga::ShaderStage::Vertex => "vertex",
        naga::ShaderStage::Fragment => "fragment",
        _ => "compute",
    }
}

/// Place of a barrier in a block, at any depth.
fn barrier(body: &Block) -> Option<naga::Span> {
    let mut blocks = vec![body];
    while let Some(block) = blocks.pop() {
        for (statement, span) in block.span_iter() {
            match statement {
                Statement::ControlBarrier(_) | Statement::MemoryBarrier(_) => return Some(*span),
                Statement::Block(inner) => blocks.push(inner),
                Statement::If { accept, reject, .. } => blocks.extend([accept, reject]),
                Statement::Loop { body, continuing, .. } => blocks.extend([body, continuing]),
                Statement::Switch { cases, .. } => {
                    blocks.extend(cases.iter().map(|case| &case.body));
                }
                _ => {}
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(code: &str) -> String {
        let valid = crate::wgsl::parse(code).unwrap();
        refusals(&valid, &(0..code.len())).into_iter().map(|error| error.message + "\n").collect()
    }

    #[test]
    fn what_nothing_gives_a_value_is_refused() {
        let cases = [
            (
                "@group(0) @binding(9) var t: texture_2d<f32>; fn f(x: f32) -> f32 { return x; }",
                "bound to `t`",
            ),
            (
                "@group(0) @binding(9) var<uniform> u: f32; fn f(x: f32) -> f32 { return u; }",
                "bound to `u`",
            ),
            (
                "@group(0) @binding(9) var<storage> b: f32; fn f(x: f32) -> f32 { return b; }",
                "bound to `b`",
            ),
            ("var<workgroup> a: atomic<u32>; fn f(x: f32) -> f32 { return x; }", "bound to `a`"),
            ("@id(1) override k: f32; fn f(x: f32) -> f32 { return x * k; }", "override `k`"),
            ("override k = 1.0; fn f(x: f32) -> f32 { return x * k; }", "override `k`"),
            ("fn f(x: f32) -> f32 { workgroupBarrier(); return x; }", "barrier"),
            ("@fragment fn f() -> @location(0) vec4f { return vec4f(); }", "`f` is an entry point"),
        ];
        for (code, expected) in cases {
            let told = told(code);
            assert!(told.contains(expected) && told.lines().count() == 1, "{code}: {told}");
        }
        let allowed = "const T = array<f32, 64>(); var<private> p: array<f32, 64>;
            fn f(x: f32, image: texture_2d<f32>, image_sampler: sampler) -> f32 {
                var a: array<vec4f, 64>;
                p[1] = T[u32(x)] + a[u32(x)].x;
                return p[2] + textureSample(image, image_sampler, vec2f(x)).x;
            }";
        assert_eq!(told(allowed), "");
    }

    #[test]
    fn memory_and_operations_are_bounded() {
        let cases = [
            (
                "fn f(x: f32) -> f32 { var a: array<f32, 100000000>; return a[u32(x)]; }",
                "400000000 bytes",
            ),
            (
                "var<private> a: array<f32, 1000>; fn f(x: f32) -> f32 { return a[u32(x)]; }",
                "4000 bytes",
            ),
            ("fn f(x: f32) -> f32 { return array<f32, 1000>()[u32(x)]; }", "1000 elements"),
            (
                "const T = array<vec4f, 300>(); fn f(x: f32) -> f32 \
                 { return T[u32(x)].x + T[u32(x) + 1u].x; }",
                "9600 bytes",
            ),
        ];
        for (code, expected) in cases {
            assert!(told(code).contains(expected), "{code}: {}", told(code));
        }
        let twice = |i: usize| {
            format!("fn g{}(x: f32) -> f32 {{ return g{i}(x) + g{i}(x + 1.0); }}\n", i + 1)
        };
        let doubling: String = (0..70).map(twice).collect();
        let told = told(&format!("fn g0(x: f32) -> f32 {{ return sin(x); }}\n{doubling}"));
        assert!(told.contains("operations") && told.lines().count() == 1, "{told}");
    }
}
