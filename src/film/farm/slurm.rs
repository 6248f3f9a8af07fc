//! Slurm: an array of tasks, and a job that waits for it.

use chiaro_locale::tr;

use super::{ATTEMPTS, FarmJob, quoted, refuse_more};
use crate::diag::Diagnostic;

/// Greatest number of tasks of an array, where the site has not set `MaxArraySize`.
const MAX_TASKS: usize = 1001;

/// A script that submits both jobs and prints their numbers.
///
/// `afterany` and not `afterok`: the check is to say which frames are missing.
pub(super) fn write(job: &FarmJob) -> Result<String, Diagnostic> {
    let chunks = refuse_more(job, MAX_TASKS, tr!("an array of Slurm"))?;
    let last = chunks.len().saturating_sub(1);
    let chunks = chunks.join(" ");
    let (name, check_name) = (quoted(&job.name), quoted(&format!("{}-check", job.name)));
    let folder = quoted(&job.folder);
    let about = job.about();
    let attempts: Vec<String> = (1..=ATTEMPTS).map(|attempt| attempt.to_string()).collect();
    let attempts = attempts.join(" ");
    let render = job.render("\"$frames\"");
    let [verify, sheet] = job.check();
    Ok(format!(
        r#"#!/bin/sh
# {about}.
# Submits both jobs and prints their numbers. More options of sbatch for both go into
# SBATCH_OPTIONS, and those of drawing alone, such as --gpus=1, into RENDER_OPTIONS: the check needs
# no GPU.
set -eu
render=$(sbatch --parsable --job-name={name} --array=0-{last} --requeue --open-mode=append \
    --chdir={folder} --output={name}-%A_%a.log ${{SBATCH_OPTIONS:-}} ${{RENDER_OPTIONS:-}} <<'TASK'
#!/bin/bash
chunks=({chunks})
frames=${{chunks[$SLURM_ARRAY_TASK_ID]:?}}
# Frames that are whole are kept: another attempt, here or elsewhere, goes on with the rest.
for attempt in {attempts}; do
    {render} && exit 0
    code=$?
    # Wrong arguments stay wrong, and who was asked to end does not begin again.
    case $code in 2 | 130) exit $code ;; esac
done
exit $code
TASK
)
render=${{render%%;*}}
check=$(sbatch --parsable --job-name={check_name} --dependency=afterany:$render --requeue \
    --open-mode=append --chdir={folder} --output={check_name}-%j.log ${{SBATCH_OPTIONS:-}} <<'TASK'
#!/bin/sh
{verify} &&
    {sheet}
TASK
)
echo "$render ${{check%%;*}}"
"#
    ))
}

#[cfg(test)]
mod tests {
    use super::super::tests::job;
    use super::*;

    #[test]
    fn an_array_has_a_task_for_each_chunk() {
        let text = write(&job()).unwrap();
        for needed in [
            "--array=0-2 ",
            "chunks=(1-10 11-20 21-25)\n",
            "--chdir='/projects/a b'",
            "--frames \"$frames\" && exit 0",
            "--dependency=afterany:$render",
            "%A_%a.log ${SBATCH_OPTIONS:-} ${RENDER_OPTIONS:-} <<",
            "-check-%j.log ${SBATCH_OPTIONS:-} <<",
            "chiaro verify 'out/####.exr' --frames 1-25 --of shot.json -o 'out/####.exr' --camera \
             'fov=20;eye=0,0,5' &&\n",
        ] {
            assert!(text.contains(needed), "no `{needed}` in {text}");
        }
    }
}
