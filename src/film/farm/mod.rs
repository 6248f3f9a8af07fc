//! Jobs of render farms: chunks of frames, then a check of all frames and a contact sheet.
//!
//! A farm is a row of [`FARMS`] and a file that writes its job as text; nothing is sent anywhere.
//! Tasks have no state: a chunk is `chiaro render --frames`, which keeps the frames that are whole,
//! so that any machine may do any chunk, and again.

mod flamenco;
mod opencue;
mod openjd;
pub mod simulation;
mod slurm;

use chiaro_locale::{Text, text, tr};

use crate::diag::Diagnostic;
use crate::frame::ShotStack;
use crate::frames::FrameList;

/// Attempts at a chunk before its frames are given up.
pub const ATTEMPTS: u32 = 3;

/// Greatest number of frames of a task, where neither a shot nor a command says another.
pub const DEFAULT_CHUNK: u32 = 10;

/// The greatest number of frames of a task that the nearest shot says.
pub fn chunk_of(stack: &ShotStack) -> u32 {
    stack.shots.iter().find_map(|file| file.shot.chunk).unwrap_or(DEFAULT_CHUNK)
}

/// Frames to be drawn by a farm, as a command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FarmJob {
    /// Name for people.
    pub name: String,
    /// Program on the machines of the farm.
    pub program: String,
    /// Arguments of `chiaro render`, without the frames.
    pub render: Vec<String>,
    /// Path of the frames' files, with the place of the number.
    pub output: String,
    /// Frames to draw.
    pub frames: FrameList,
    /// Greatest number of frames of a task.
    pub chunk: usize,
    /// Folder that all paths are relative to.
    pub folder: String,
    /// Path of the contact sheet.
    pub sheet: String,
    /// Paths of files outside the folder that frames are made of.
    pub outside: Vec<String>,
}

impl FarmJob {
    /// Frames of each task.
    pub fn chunks(&self) -> Vec<String> {
        self.frames.chunks(self.chunk).map(|part| part.to_string()).collect()
    }

    /// The command of a task; the frames are text of the farm, such as a variable, and stand as
    /// they are.
    fn render(&self, frames: &str) -> String {
        let words = self.render.iter().map(|word| quoted(word));
        let words: Vec<String> = words.collect();
        format!("{} render {} --frames {frames}", quoted(&self.program), words.join(" "))
    }

    /// The commands of the last task: a check of all frames, which are to be whole and of the
    /// document as it is now, and a contact sheet where they are.
    fn check(&self) -> [String; 2] {
        let (program, output) = (quoted(&self.program), quoted(&self.output));
        let frames = self.frames.to_string();
        let frames = quoted(&frames);
        let words = self.render.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ");
        [
            format!("{program} verify {output} --frames {frames} --of {words}"),
            format!(
                "{program} sheet {output} --frames {frames} -o {} --force",
                quoted(&self.sheet)
            ),
        ]
    }

    /// A sentence on the job, for the head of its file.
    fn about(&self) -> String {
        let tasks = self.frames.frames().len().div_ceil(self.chunk.max(1));
        let plural = if tasks == 1 { "task" } else { "tasks" };
        format!(
            "{}: {} frames in {tasks} {plural}, then a check of all frames and a contact sheet",
            self.name,
            self.frames.frames().len()
        )
    }
}

/// An engine that runs jobs.
#[derive(Clone, Copy)]
pub struct Farm {
    /// Word of the command line.
    pub word: &'static str,
    /// Way to submit the job's file.
    pub submitted_by: Text,
    write: fn(&FarmJob) -> Result<String, Diagnostic>,
}

/// All farms.
pub const FARMS: &[Farm] = &[
    Farm { word: "slurm", submitted_by: Text::new("sh FILE"), write: slurm::write },
    Farm {
        word: "openjd",
        submitted_by: text!("openjd run FILE -p Folder=$PWD, or deadline bundle submit"),
        write: openjd::write,
    },
    Farm {
        word: "opencue",
        submitted_by: text!(
            "the launchSpec call of Cuebot, as python's opencue.api.launchSpec(text)"
        ),
        write: opencue::write,
    },
    Farm {
        word: "flamenco",
        submitted_by: text!("its folder of scripts, as a job type of Flamenco's manager"),
        write: flamenco::write,
    },
];

impl std::fmt::Debug for Farm {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.word)
    }
}

impl Farm {
    /// The farm of a word.
    pub fn named(word: &str) -> Option<Self> {
        FARMS.iter().find(|farm| farm.word == word).copied()
    }

    /// The text of a job.
    ///
    /// # Errors
    /// `no-job` with what the farm cannot hold.
    pub fn job(self, job: &FarmJob) -> Result<String, Diagnostic> {
        (self.write)(job)
    }
}

fn no_job(message: String) -> Diagnostic {
    Diagnostic::error("no-job", message)
}

/// Refuses more tasks than a farm has room for.
fn refuse_more(job: &FarmJob, most: usize, farm: &str) -> Result<Vec<String>, Diagnostic> {
    let chunks = job.chunks();
    if chunks.len() <= most {
        return Ok(chunks);
    }
    let message = tr!("{count} tasks are more than {farm} takes, {most}", count = chunks.len());
    let chunk = job.frames.frames().len().div_ceil(most);
    Err(no_job(message).hint(tr!("draw more frames in a task: --chunk {chunk}")))
}

/// A word for a POSIX shell.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_./=:,+@%-".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn job() -> FarmJob {
        FarmJob {
            name: "shot".to_owned(),
            program: "chiaro".to_owned(),
            render: ["shot.json", "-o", "out/####.exr", "--camera", "fov=20;eye=0,0,5"]
                .map(str::to_owned)
                .to_vec(),
            output: "out/####.exr".to_owned(),
            frames: "1-25".parse().unwrap(),
            chunk: 10,
            folder: "/projects/a b".to_owned(),
            sheet: "out/sheet.png".to_owned(),
            outside: Vec::new(),
        }
    }

    #[test]
    fn every_farm_writes_every_chunk_and_the_check() {
        for farm in FARMS {
            let text = farm.job(&job()).unwrap();
            for needed in [
                "shot.json",
                "fov=20;eye=0,0,5",
                "verify",
                "--of shot.json",
                "out/sheet.png",
                "a b",
            ] {
                assert!(text.contains(needed), "{farm:?}: no `{needed}` in {text}");
            }
            assert_eq!(Farm::named(farm.word).map(|found| found.word), Some(farm.word));
        }
        assert!(Farm::named("deadline").is_none());
    }

    #[test]
    fn words_are_safe_in_shells() {
        assert_eq!(quoted("out/a-1.exr"), "out/a-1.exr");
        assert_eq!(quoted("out/####.exr"), "'out/####.exr'");
        assert_eq!(quoted("it's"), "'it'\\''s'");
        assert_eq!(quoted(""), "''");
        let task = job().render("\"$frames\"");
        assert!(task.ends_with("--camera 'fov=20;eye=0,0,5' --frames \"$frames\""), "{task}");
    }

    #[test]
    fn too_many_tasks_are_refused_with_a_chunk_that_fits() {
        let frames = "1-10000".parse().unwrap();
        let problem = Farm::named("slurm").unwrap().job(&FarmJob { frames, chunk: 1, ..job() });
        let problem = problem.unwrap_err();
        assert!(problem.hints[0].contains("--chunk 10"), "{problem}");
    }
}
