//! Compiling a look in the background: the live shader (every value a uniform, for editing) and the
//! baked one (values folded, for a look at rest and for the code panel).

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use crate::compile::{CompiledShader, Live, Options, TypedGraph, check, compile_typed};
use crate::diag::Diagnostic;
use crate::document::Look;
use crate::ids::{NodePath, PortName};
use crate::library::{Library, Type};
use crate::milestones;
use crate::state::revision::{DocumentNumber, PreviewRevision, SoloRevision};
use crate::state::safety::crashes::{CrashLog, DocumentOrigin, Step};
use crate::state::wire::ShownWire;
use crate::state::worker::Worker;

/// What is to be compiled.
pub(crate) struct CompileRequest {
    /// The look as it is now.
    pub(crate) look: Arc<Look>,
    /// Which document that is.
    pub(crate) document: DocumentNumber,
    /// Its revision.
    pub(crate) revision: u64,
    /// Which structure it has; other values with the same structure are shown by the same live
    /// shader.
    pub(crate) structure: u64,
    /// The values that were edited, which stay live however long the look is.
    pub(crate) touched: Arc<HashSet<(NodePath, PortName)>>,
    /// The wire that is shown in place of the look's own output, with its type.
    pub(crate) wire: Option<(ShownWire, Option<Type>)>,
    /// The nodes there are.
    pub(crate) library: Arc<Library>,
    /// Whether only the baked shader is wanted, because the live one still serves.
    pub(crate) only_baked: bool,
    /// Which solo it is shown in.
    pub(crate) solo: SoloRevision,
    /// Which look is shown in place of the open one.
    pub(crate) preview: PreviewRevision,
    /// What people call the document.
    pub(crate) name: String,
    /// Its file, if it has one.
    pub(crate) path: Option<PathBuf>,
}

/// What became of a request.
pub(crate) struct CompileAnswer {
    /// The request.
    pub(crate) request: CompileRequest,
    /// The shaders, or everything that is wrong.
    pub(crate) result: Result<Shaders, Vec<Diagnostic>>,
}

/// A look's shaders.
pub(crate) struct Shaders {
    /// Every value a uniform; `None` where only the baked one was wanted.
    pub(crate) live: Option<Arc<CompiledShader>>,
    /// Values folded.
    pub(crate) baked: Arc<CompiledShader>,
    /// What they were made from.
    pub(crate) typed: Arc<TypedGraph>,
}

/// A thread that compiles looks.
pub(crate) type Compiler = Worker<CompileRequest, CompileAnswer>;

/// Starts it. What goes on is noted in `crashes`.
pub(crate) fn start(wake: impl Fn() + Send + 'static, crashes: CrashLog) -> Compiler {
    Worker::new("compile", wake, move |request: CompileRequest| {
        let origin = || DocumentOrigin::new(&request.name, request.path.as_deref(), &request.look);
        let _going = crashes.begin(Step::Compile, origin);
        let result = compile(&request);
        CompileAnswer { request, result }
    })
}

fn compile(request: &CompileRequest) -> Result<Shaders, Vec<Diagnostic>> {
    let shown = request
        .wire
        .as_ref()
        .map(|(wire, ty)| wire.of(&request.look, &request.library, ty.as_ref()));
    let (look, root) = match &shown {
        Some((look, root)) => (look, Some(root)),
        None => (&*request.look, None),
    };
    let (typed, warnings) = check(look, &request.library, root)?;
    let with = |live| Options {
        root: root.cloned(),
        live,
        touched: (*request.touched).clone(),
        display: true,
        ..Options::default()
    };
    let baked = Arc::new(compile_typed(&typed, &with(Live::Keyed), warnings.clone())?);
    let live = match request.only_baked {
        true => None,
        false => Some(Arc::new(compile_typed(&typed, &with(Live::All), warnings)?)),
    };
    milestones::reached("first shaders");
    Ok(Shaders { live, baked, typed: Arc::new(typed) })
}
