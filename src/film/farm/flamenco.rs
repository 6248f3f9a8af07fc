//! Flamenco: a job type, which its manager compiles to tasks.

use serde_json::json;

use super::FarmJob;
use crate::diag::Diagnostic;

/// A script of a job type without settings: everything is said in it. Retries are the manager's
/// (`task_fail_after_softfail_count`).
pub(super) fn write(job: &FarmJob) -> Result<String, Diagnostic> {
    let text = |text: &str| json!(text).to_string();
    let chunks = json!(job.chunks());
    let folder = text(&format!("cd {} && exec ", super::quoted(&job.folder)));
    let (name, render) = (text(&job.name), text(&job.render("")));
    let [verify, sheet] = job.check();
    let check = text(&format!("{verify} && {sheet}"));
    let check_folder = text(&format!("cd {} && ", super::quoted(&job.folder)));
    let about = job.about();
    Ok(format!(
        r#"// {about}.
// Lies in the manager's folder `scripts`, and is submitted as a job of this type.
const JOB_TYPE = {{
    label: {name},
    settings: [],
}};

const CHUNKS = {chunks};

function command(line) {{
    return author.Command("exec", {{ exe: "/bin/sh", args: ["-c", line] }});
}}

function compileJob(job) {{
    const check = author.Task("check and contact sheet", "misc");
    check.addCommand(command({check_folder} + {check}));
    for (const frames of CHUNKS) {{
        const task = author.Task(`frames ${{frames}}`, "misc");
        task.addCommand(command({folder} + {render} + frames));
        check.addDependency(task);
        job.addTask(task);
    }}
    job.addTask(check);
}}
"#
    ))
}
