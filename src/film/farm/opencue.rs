//! OpenCue: a specification of a job, as Cuebot launches it.

use super::{ATTEMPTS, FarmJob, quoted};
use crate::diag::Diagnostic;

/// A specification of one layer of frames and one that waits for it. Show, shot and user are
/// Cuebot's own to know: those of its first steps stand here.
pub(super) fn write(job: &FarmJob) -> Result<String, Diagnostic> {
    let folder = format!("cd {} && ", quoted(&job.folder));
    let render = escaped(&format!("{folder}exec {}", job.render("#FRAMESPEC#")));
    let [verify, sheet] = job.check();
    let check = escaped(&format!("{folder}{verify} && {sheet}"));
    let (name, about) = (escaped(&job.name), escaped(&job.about()));
    let (frames, chunk) = (&job.frames, job.chunk);
    Ok(format!(
        r#"<?xml version="1.0"?>
<!DOCTYPE spec PUBLIC "SPI Cue Specification Language"
    "http://localhost:8080/spcue/dtd/cjsl-1.12.dtd">
<!-- {about}. Show, shot and user are yours to name. -->
<spec>
  <facility>local</facility>
  <show>testing</show>
  <shot>shot</shot>
  <user>chiaro</user>
  <job name="{name}">
    <paused>False</paused>
    <maxretries>{ATTEMPTS}</maxretries>
    <layers>
      <layer name="render" type="Render">
        <cmd>{render}</cmd>
        <range>{frames}</range>
        <chunk>{chunk}</chunk>
      </layer>
      <layer name="check" type="Post">
        <cmd>{check}</cmd>
        <range>1</range>
        <chunk>1</chunk>
      </layer>
    </layers>
  </job>
  <depends>
    <depend type="LAYER_ON_LAYER" anyframe="False">
      <depjob>{name}</depjob>
      <deplayer>check</deplayer>
      <onjob>{name}</onjob>
      <onlayer>render</onlayer>
    </depend>
  </depends>
</spec>
"#
    ))
}

/// A text for XML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
