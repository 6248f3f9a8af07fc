//! Compilation of a look in the background: the live shader (every value a uniform, for editing)
//! and the baked one (values folded, for a look at rest and for the code panel).

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::Arc;

use crate::compile::{CompileOptions, CompiledShader, Live, TypedGraph, check, compile_typed};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{DocumentRevision, Look};
use crate::ids::{NodePath, PortName};
use crate::library::{Library, Type};
use crate::milestones;
use crate::state::crashes::{CrashLog, CrashStep, DocumentOrigin};
use crate::state::revision::{DocumentNumber, LookRevision, PreviewRevision, SoloRevision};
use crate::state::wire::ShownWire;
use crate::state::worker::Worker;

/// A look to compile, with everything that the shaders depend on.
pub(crate) struct CompileRequest {
    /// The look at the time of the request.
    pub(crate) look: Arc<Look>,
    /// Number of the look's document.
    pub(crate) document: DocumentNumber,
    /// Revision of the document.
    pub(crate) revision: LookRevision,
    /// Revision of the last change that a picture may show.
    pub(crate) picture: DocumentRevision,
    /// Revision of the document's structure; other values with the same structure are shown by the
    /// same live shader.
    pub(crate) structure: LookRevision,
    /// The edited values, which stay live however long the look is.
    pub(crate) touched: Arc<HashSet<(NodePath, PortName)>>,
    /// The wire shown in place of the look's own output, with its type.
    pub(crate) wire: Option<(ShownWire, Option<Type>)>,
    /// The library of nodes.
    pub(crate) library: Arc<Library>,
    /// True if only the baked shader is wanted, because the live one still serves.
    pub(crate) only_baked: bool,
    /// Revision of the solo that the look is shown in.
    pub(crate) solo: SoloRevision,
    /// Revision of the look that is shown in place of the open one.
    pub(crate) preview: PreviewRevision,
    /// Display name of the document.
    pub(crate) name: String,
    /// File of the document, if there is one.
    pub(crate) path: Option<PathBuf>,
}

/// A request with its result.
pub(crate) struct CompileAnswer {
    /// The request, given back.
    pub(crate) request: CompileRequest,
    /// The shaders, or every problem of the look.
    pub(crate) result: Result<WithWarnings<Shaders>, Vec<Diagnostic>>,
}

/// A look's shaders.
pub(crate) struct Shaders {
    /// Shader with every value a uniform; `None` where only the baked one was wanted.
    pub(crate) live: Option<Arc<CompiledShader>>,
    /// Shader with values folded.
    pub(crate) baked: Arc<CompiledShader>,
    /// The typed look that both shaders were compiled from.
    pub(crate) typed: Arc<TypedGraph>,
}

/// A thread that compiles looks.
pub(crate) type Compiler = Worker<CompileRequest, CompileAnswer>;

/// Starts the compiling thread. Each compilation is noted in `crashes` while it runs.
pub(crate) fn start(wake: impl Fn() + Send + 'static, crashes: CrashLog) -> Compiler {
    Worker::new("compile", wake, move |request: CompileRequest| {
        let origin = || DocumentOrigin::new(&request.name, request.path.as_deref(), &request.look);
        let _going = crashes.begin(CrashStep::Compile, origin);
        let result = compile(&request);
        CompileAnswer { request, result }
    })
}

fn compile(request: &CompileRequest) -> Result<WithWarnings<Shaders>, Vec<Diagnostic>> {
    let shown = request
        .wire
        .as_ref()
        .map(|(wire, ty)| wire.of(&request.look, &request.library, ty.as_ref()));
    let (look, root) = match &shown {
        Some((look, root)) => (look, Some(root)),
        None => (&*request.look, None),
    };
    let (typed, warnings) = check(look, &request.library, root)?.into_parts();
    let with = |live| CompileOptions {
        root: root.cloned(),
        live,
        touched: (*request.touched).clone(),
        display: true,
        ..CompileOptions::default()
    };
    let baked = Arc::new(compile_typed(&typed, &with(Live::Keyed))?);
    let live = match request.only_baked {
        true => None,
        false => Some(Arc::new(compile_typed(&typed, &with(Live::All))?)),
    };
    milestones::reached("first shaders");
    Ok(WithWarnings::new(Shaders { live, baked, typed: Arc::new(typed) }, warnings))
}
