//! Names of features that only a GPU has.

use naga::{Expression, MathFunction, Module, Statement};

/// Name of an expression that the interpreter cannot run, and of the IR construct behind it.
pub(super) fn expression_name(module: &Module, expression: &Expression) -> String {
    let named =
        |what: &str, name: &Option<String>| format!("{what} `{}`", name.as_deref().unwrap_or(""));
    match expression {
        Expression::Override(handle) => {
            named("the override", &module.overrides[*handle].name) + " (Override)"
        }
        Expression::GlobalVariable(handle) => {
            named("the global variable", &module.global_variables[*handle].name)
                + " (GlobalVariable)"
        }
        other => anonymous_expression_name(other).to_owned(),
    }
}

fn anonymous_expression_name(expression: &Expression) -> &'static str {
    match expression {
        Expression::ImageSample { .. } => "a texture sample (ImageSample)",
        Expression::ImageLoad { .. } => "a texture load (ImageLoad)",
        Expression::ImageQuery { .. } => "a texture query (ImageQuery)",
        Expression::Derivative { .. } => "a derivative (Derivative)",
        Expression::AtomicResult { .. } => "an atomic operation (AtomicResult)",
        Expression::WorkGroupUniformLoadResult { .. } => {
            "a workgroup load (WorkGroupUniformLoadResult)"
        }
        Expression::ArrayLength(_) => "the length of a runtime-sized array (ArrayLength)",
        Expression::RayQueryVertexPositions { .. }
        | Expression::RayQueryProceedResult
        | Expression::RayQueryGetIntersection { .. } => "a ray query (RayQuery)",
        Expression::SubgroupBallotResult | Expression::SubgroupOperationResult { .. } => {
            "a subgroup operation (SubgroupOperationResult)"
        }
        Expression::CooperativeLoad { .. } | Expression::CooperativeMultiplyAdd { .. } => {
            "a cooperative matrix (CooperativeLoad)"
        }
        // naga's typing and its back ends disagree on which argument gives the columns; WGSL has no
        // such function.
        Expression::Math { fun: MathFunction::Outer, .. } => {
            "an outer product (MathFunction::Outer)"
        }
        _ => "an expression that is not valid naga IR",
    }
}

/// Name of a statement that the interpreter cannot run, and of the IR construct behind it.
pub(super) fn statement_name(statement: &Statement) -> &'static str {
    match statement {
        Statement::Kill => "`discard` (Kill)",
        Statement::ControlBarrier(_) | Statement::MemoryBarrier(_) => "a barrier (ControlBarrier)",
        Statement::ImageStore { .. } => "a texture store (ImageStore)",
        Statement::Atomic { .. } | Statement::ImageAtomic { .. } => "an atomic operation (Atomic)",
        Statement::WorkGroupUniformLoad { .. } => "a workgroup load (WorkGroupUniformLoad)",
        Statement::RayQuery { .. } | Statement::RayPipelineFunction(_) => "ray tracing (RayQuery)",
        Statement::SubgroupBallot { .. }
        | Statement::SubgroupGather { .. }
        | Statement::SubgroupCollectiveOperation { .. } => {
            "a subgroup operation (SubgroupCollectiveOperation)"
        }
        Statement::CooperativeStore { .. } => "a cooperative matrix (CooperativeStore)",
        _ => "a statement that is not valid naga IR",
    }
}
