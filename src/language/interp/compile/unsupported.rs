//! Names of features that only a GPU has.

use chiaro_locale::tr;
use naga::{Expression, MathFunction, Module, Statement};

/// Name of an expression that the interpreter cannot run, and of the IR construct behind it.
pub(super) fn expression_name(module: &Module, expression: &Expression) -> String {
    match expression {
        Expression::Override(handle) => {
            let name = module.overrides[*handle].name.as_deref().unwrap_or_default();
            tr!("the override `{name}` (Override)")
        }
        Expression::GlobalVariable(handle) => {
            let name = module.global_variables[*handle].name.as_deref().unwrap_or_default();
            tr!("the global variable `{name}` (GlobalVariable)")
        }
        other => anonymous_expression_name(other).to_owned(),
    }
}

fn anonymous_expression_name(expression: &Expression) -> &'static str {
    match expression {
        Expression::ImageSample { .. } => tr!("a texture sample (ImageSample)"),
        Expression::ImageLoad { .. } => tr!("a texture load (ImageLoad)"),
        Expression::ImageQuery { .. } => tr!("a texture query (ImageQuery)"),
        Expression::Derivative { .. } => tr!("a derivative (Derivative)"),
        Expression::AtomicResult { .. } => tr!("an atomic operation (AtomicResult)"),
        Expression::WorkGroupUniformLoadResult { .. } => {
            tr!("a workgroup load (WorkGroupUniformLoadResult)")
        }
        Expression::ArrayLength(_) => tr!("the length of a runtime-sized array (ArrayLength)"),
        Expression::RayQueryVertexPositions { .. }
        | Expression::RayQueryProceedResult
        | Expression::RayQueryGetIntersection { .. } => tr!("a ray query (RayQuery)"),
        Expression::SubgroupBallotResult | Expression::SubgroupOperationResult { .. } => {
            tr!("a subgroup operation (SubgroupOperationResult)")
        }
        Expression::CooperativeLoad { .. } | Expression::CooperativeMultiplyAdd { .. } => {
            tr!("a cooperative matrix (CooperativeLoad)")
        }
        // naga's typing and its back ends disagree on which argument gives the columns; WGSL has no
        // such function.
        Expression::Math { fun: MathFunction::Outer, .. } => {
            tr!("an outer product (MathFunction::Outer)")
        }
        _ => tr!("an expression that is not valid naga IR"),
    }
}

/// Name of a statement that the interpreter cannot run, and of the IR construct behind it.
pub(super) fn statement_name(statement: &Statement) -> &'static str {
    match statement {
        Statement::Kill => tr!("`discard` (Kill)"),
        Statement::ControlBarrier(_) | Statement::MemoryBarrier(_) => {
            tr!("a barrier (ControlBarrier)")
        }
        Statement::ImageStore { .. } => tr!("a texture store (ImageStore)"),
        Statement::Atomic { .. } | Statement::ImageAtomic { .. } => {
            tr!("an atomic operation (Atomic)")
        }
        Statement::WorkGroupUniformLoad { .. } => tr!("a workgroup load (WorkGroupUniformLoad)"),
        Statement::RayQuery { .. } | Statement::RayPipelineFunction(_) => {
            tr!("ray tracing (RayQuery)")
        }
        Statement::SubgroupBallot { .. }
        | Statement::SubgroupGather { .. }
        | Statement::SubgroupCollectiveOperation { .. } => {
            tr!("a subgroup operation (SubgroupCollectiveOperation)")
        }
        Statement::CooperativeStore { .. } => tr!("a cooperative matrix (CooperativeStore)"),
        _ => tr!("a statement that is not valid naga IR"),
    }
}
