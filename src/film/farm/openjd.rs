//! Open Job Description: a job template of two steps.

use chiaro_locale::tr;
use serde_json::{Value as Json, json};

use super::{FarmJob, no_job, refuse_more};
use crate::diag::Diagnostic;

/// Greatest number of values of a task's parameter.
const MAX_TASKS: usize = 1024;

/// Greatest length of a job's name.
const MAX_NAME: usize = 128;

/// Greatest length of a job's description.
const MAX_DESCRIPTION: usize = 2048;

/// Seconds from the request to end to the end by force: a frame is finished or dropped meanwhile.
const NOTICE: u32 = 10;

/// A template as JSON. Retries are the scheduler's, which begins a failed task again.
pub(super) fn write(job: &FarmJob) -> Result<String, Diagnostic> {
    let words = job.render.iter().chain([&job.program, &job.output, &job.sheet]);
    if let Some(word) = words.into_iter().find(|word| word.contains("{{")) {
        let message = tr!("`{word}` has the signs of a template's own values, {{{{");
        return Err(no_job(message).hint(tr!("choose a name without them")));
    }
    let chunks = refuse_more(job, MAX_TASKS, tr!("a parameter of a template"))?;
    let render = format!("{} --progress openjd", job.render("'{{Task.Param.Frames}}'"));
    let [verify, sheet] = job.check();
    let name: String = job.name.chars().take(MAX_NAME).collect();
    let template = json!({
        "specificationVersion": "jobtemplate-2023-09",
        "name": name,
        "description": description(job),
        "parameterDefinitions": [{
            "name": "Folder", "type": "PATH", "objectType": "DIRECTORY", "dataFlow": "INOUT",
            "description": format!("Folder that all paths are relative to, here {}.", job.folder),
        }],
        "steps": [
            {
                "name": "Render",
                "parameterSpace": {"taskParameterDefinitions": [
                    {"name": "Frames", "type": "STRING", "range": chunks}
                ]},
                "script": script(&render),
            },
            {
                "name": "Check",
                "dependencies": [{"dependsOn": "Render"}],
                "script": script(&format!("{verify} &&\n    {sheet}")),
            },
        ],
    });
    Ok(format!("{template:#}\n"))
}

/// A sentence on the job, and the files outside its folder: a template's path of a file may not
/// lead out of the template's folder, so that these are the site's to bring.
fn description(job: &FarmJob) -> String {
    let mut text = format!("{}.", job.about());
    if job.outside.is_empty() {
        return text;
    }
    text += " Files outside the folder, needed at these paths:";
    let mut left = job.outside.iter();
    for path in left.by_ref() {
        if text.chars().count() + path.chars().count() + 32 > MAX_DESCRIPTION {
            text += &format!(" and {} more", left.count() + 1);
            break;
        }
        text += &format!("\n{path}");
    }
    text
}

/// A script that runs commands in the job's folder. The shell takes the name of a frame's process,
/// so that a request to end reaches it.
fn script(commands: &str) -> Json {
    let exec = if commands.contains('\n') { "" } else { "exec " };
    json!({
        "embeddedFiles": [{
            "name": "Run", "type": "TEXT", "runnable": true,
            "data": format!("#!/bin/sh\ncd '{{{{Param.Folder}}}}' || exit 1\n{exec}{commands}\n"),
        }],
        "actions": {"onRun": {
            "command": "{{Task.File.Run}}",
            "cancelation": {
                "mode": "NOTIFY_THEN_TERMINATE", "notifyPeriodInSeconds": NOTICE
            },
        }},
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::job;
    use super::*;

    #[test]
    fn a_template_has_a_step_for_frames_and_one_that_waits() {
        let template: Json = serde_json::from_str(&write(&job()).unwrap()).unwrap();
        let render = &template["steps"][0];
        let frames = &render["parameterSpace"]["taskParameterDefinitions"][0]["range"];
        assert_eq!(*frames, json!(["1-10", "11-20", "21-25"]));
        let data = render["script"]["embeddedFiles"][0]["data"].as_str().unwrap();
        assert!(data.contains("cd '{{Param.Folder}}'") && data.contains("--progress openjd"));
        assert_eq!(template["steps"][1]["dependencies"], json!([{"dependsOn": "Render"}]));
        let outside: Vec<String> = (0..900).map(|n| format!("/looks/{n}.json")).collect();
        let far = write(&FarmJob { outside, ..job() }).unwrap();
        let far: Json = serde_json::from_str(&far).unwrap();
        let described = far["description"].as_str().unwrap();
        assert!(described.contains("\n/looks/0.json\n/looks/1.json"), "{described}");
        assert!(described.ends_with(" more") && described.len() <= MAX_DESCRIPTION);
        let odd = FarmJob { output: "{{a}}/#.exr".to_owned(), ..job() };
        assert_eq!(write(&odd).unwrap_err().code, "no-job");
    }
}
