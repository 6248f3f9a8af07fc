//! `chiaro farm`: the job by which a render farm draws frames. Nothing is sent anywhere.

use std::path::{Path, PathBuf};

use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{ArgAction, ArgMatches, Args as _, FromArgMatches};

use super::output::Output;
use super::render;
use super::target::{OutputPath, outputs};
use super::used_files;
use crate::diag::Diagnostic;
use crate::files::{OutputKind, shortened};
use crate::film::FrameList;
use crate::film::farm::simulation::{FarmFigures, FarmSettings, simulate};
use crate::film::farm::{DEFAULT_CHUNK, FARMS, Farm, FarmJob, chunk_of};
use crate::frame::ShotStack;

const EXAMPLES: &str = "\
Examples:
  chiaro farm scene.json -o 'out/####.exr' --frames 1-240 --to slurm --job scene.sh && sh scene.sh
  chiaro farm scene.json -o 'out/####.exr' --frames 1-240 --chunk 5 --to openjd --job scene.job.json
  chiaro farm scene.json -o 'out/####.exr' --frames 1-10000 --to slurm --simulate 1000

A job has a task for each chunk of frames, and a last one that checks all frames and draws a contact
sheet. All options of chiaro render are handed on. A frame that is whole is kept, so that any task
may be done again, on any machine. docs/farm.md tells what a farm must give.";

/// Arguments of `chiaro farm`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[group(skip)]
pub(super) struct Arguments {
    #[command(flatten)]
    render: RenderWords,
    /// The farm: slurm, openjd, opencue or flamenco
    #[arg(long, value_parser = parse_farm)]
    to: Farm,
    /// Greatest number of frames of a task [default: the shot's own, or else 10]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    chunk: Option<u32>,
    /// The file of the job; standard output without it
    #[arg(long)]
    job: Option<OutputPath>,
    /// The contact sheet that the last task draws [default: sheet.png beside the frames]
    #[arg(long)]
    sheet: Option<PathBuf>,
    /// Name of the program on the farm's machines
    #[arg(long, default_value = "chiaro")]
    program: String,
    /// Instead of a job, tell how long so many machines would take, and what failures would cost
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    simulate: Option<u32>,
    /// Seconds of a frame, for --simulate
    #[arg(long, default_value_t = 60.0, value_parser = parse_positive, requires = "simulate")]
    frame_seconds: f64,
    /// Hours from one failure of a machine to its next, for --simulate
    #[arg(long, default_value_t = 8.0, value_parser = parse_positive, requires = "simulate")]
    failure_hours: f64,
}

fn parse_farm(word: &str) -> Result<Farm, String> {
    let words = || FARMS.iter().map(|farm| farm.word).collect::<Vec<_>>().join(", ");
    Farm::named(word).ok_or_else(|| format!("it is one of {}", words()))
}

fn parse_positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "it is a number above 0".to_owned())
}

/// Arguments of `chiaro render`, as words to hand on, but for the frames.
#[derive(Clone, Debug)]
struct RenderWords {
    words: Vec<String>,
    document: PathBuf,
    output: PathBuf,
    /// Frames that were asked for; of a shot all without them.
    frames: Option<FrameList>,
    is_forced: bool,
}

/// Arguments that a job says by itself.
const NOT_HANDED_ON: [&str; 2] = ["frames", "progress"];

impl clap::Args for RenderWords {
    fn augment_args(command: clap::Command) -> clap::Command {
        // The frames' files are written by the tasks, and must not be missing in a job.
        render::Arguments::augment_args(command)
            .mut_arg("output", |output| output.value_parser(clap::value_parser!(PathBuf)))
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for RenderWords {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let command = render::Arguments::augment_args(clap::Command::new("render"));
        let mut words = Vec::new();
        for argument in command.get_arguments() {
            let id = argument.get_id().as_str();
            let is_said = matches.value_source(id) == Some(ValueSource::CommandLine);
            if !is_said || NOT_HANDED_ON.contains(&id) {
                continue;
            }
            let flag = argument.get_long().map(|long| format!("--{long}"));
            if let ArgAction::SetTrue = argument.get_action() {
                words.extend(flag);
                continue;
            }
            let values = matches.get_raw_occurrences(id).into_iter().flatten().flatten();
            for value in values {
                let value = value.to_str().ok_or_else(|| {
                    let message = format!("`{}` is no text", value.display());
                    super::command().error(ErrorKind::InvalidUtf8, message)
                })?;
                match &flag {
                    // A value may begin with a sign.
                    Some(flag) => words.push(format!("{flag}={value}")),
                    None => words.push(value.to_owned()),
                }
            }
        }
        let get = |id: &str| {
            let missing = || super::command().error(ErrorKind::MissingRequiredArgument, id);
            matches.get_one::<PathBuf>(id).cloned().ok_or_else(missing)
        };
        Ok(Self {
            words,
            document: get("document")?,
            output: get("output")?,
            frames: matches.get_one::<FrameList>("frames").cloned(),
            is_forced: matches.get_flag("force"),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let one = |problem: Diagnostic| vec![problem];
    let RenderWords { words, document, output: target, frames, is_forced } = &arguments.render;
    let pattern = super::frame_files::pattern_of(target).map_err(one)?;
    let (frames, chunk) = &tasks_of(frames.as_ref(), document, arguments.chunk, output)?;
    if let Some(workers) = arguments.simulate {
        tell(arguments, workers, (frames, *chunk), output);
        return Ok(());
    }
    let mut outputs = outputs(*is_forced, [document]);
    if !document.is_file() {
        let message = "there is no such file: tasks would draw nothing";
        return Err(one(Diagnostic::error("cannot-read", message)
            .in_file(document.display().to_string())
            .hint("name the look or the scene as it is called from this folder")));
    }
    let folder = pattern.folder();
    if folder != Path::new("") && !folder.is_dir() {
        let message = format!("there is no folder `{}`: no task could write", folder.display());
        return Err(one(Diagnostic::error("cannot-write", message)
            .hint(format!("make it: mkdir -p {}", folder.display()))));
    }
    let here = std::env::current_dir().map_err(|error| {
        one(Diagnostic::error("cannot-read", format!("this folder is not known: {error}")))
    })?;
    render::rehearse(&render::Arguments::of_words(words)?, target, output)?;
    let outside = used_files::outside(&here, document);
    let own = shortened(&here.join(document));
    output.diagnostics(outside_warning(&here, &own, &outside).as_slice());
    let sheet = arguments.sheet.clone().unwrap_or_else(|| folder.join("sheet.png"));
    let job = FarmJob {
        name: name_of(document),
        program: arguments.program.clone(),
        render: words.clone(),
        output: target.display().to_string(),
        frames: frames.clone(),
        chunk: *chunk as usize,
        folder: here.display().to_string(),
        sheet: sheet.display().to_string(),
        outside: outside.iter().map(|path| path.display().to_string()).collect(),
    };
    let text = arguments.to.job(&job).map_err(one)?;
    let Some(file) = &arguments.job else {
        output.result(text.trim_end());
        return Ok(());
    };
    let file: &Path = file.as_ref();
    outputs.write(file, OutputKind::DOCUMENT, text.as_bytes()).map_err(one)?;
    let by = arguments.to.submitted_by.english().replace("FILE", &file.display().to_string());
    output.message(&format!(
        "{}: {} frames in {} tasks; submit it by {by}",
        file.display(),
        frames.frames().len(),
        job.chunks().len()
    ));
    Ok(())
}

/// The frames, and the greatest number of them in a task, that were asked for, or else those of the
/// shot; warns of chunks and frames that do not fit the shot.
fn tasks_of(
    asked: Option<&FrameList>,
    document: &Path,
    asked_chunk: Option<u32>,
    output: &Output,
) -> Result<(FrameList, u32), Vec<Diagnostic>> {
    let bad = |message: String| vec![Diagnostic::error("bad-argument", message)];
    let is_there = document.is_file();
    let shot = is_there.then(|| ShotStack::load(&crate::files::Disk, document)).flatten();
    let Some(shot) = shot.transpose()?.map(|shot| shot.value) else {
        let missing = || bad("name the frames, as --frames 1-240".to_owned());
        let frames = asked.cloned().ok_or_else(missing)?;
        return Ok((frames, asked_chunk.unwrap_or(DEFAULT_CHUNK)));
    };
    let [first, last] = shot.frames();
    let frames = match asked {
        Some(frames) => frames.clone(),
        None => FrameList::of_range([first, last]).map_err(bad)?,
    };
    let warning = |message: String, hint: String| {
        output.diagnostics(&[Diagnostic::warning("farm", message).hint(hint)]);
    };
    if frames.frames().iter().any(|frame| !(first..=last).contains(frame)) {
        let message = format!("some of the frames are not the shot's, which are {first} to {last}");
        warning(message, format!("leave --frames out, or write --frames {first}-{last}"));
    }
    let step = shot.step();
    let chunk = asked_chunk.unwrap_or_else(|| chunk_of(&shot));
    if !chunk.is_multiple_of(step) {
        let message =
            format!("chunks of {chunk} frames part frames that the shot holds for {step}");
        warning(message, format!("--chunk {} draws none twice", chunk.next_multiple_of(step)));
    }
    Ok((frames, chunk))
}

/// A warning of files outside the folder of a job, which its machines must find at the same paths.
fn outside_warning(folder: &Path, document: &Path, outside: &[PathBuf]) -> Option<Diagnostic> {
    if outside.is_empty() {
        return None;
    }
    let named = used_files::named(outside, |path| path.display().to_string());
    let is_outside = outside.iter().any(|path| path == document);
    let what = match (is_outside, outside.len()) {
        (true, 1) => "the document lies outside this folder",
        (true, _) => "the document and files that it reads lie outside this folder",
        (false, _) => "the document reads files outside this folder",
    };
    let message = format!(
        "{what}, in which tasks run; every machine must have the same at the same path: \
         {named}"
    );
    let files: Vec<&Path> = outside.iter().map(|path| &**path).collect();
    let all = [&[folder], &files[..]].concat();
    let with_frames = used_files::common_folder(&all);
    let folders: Vec<&Path> = outside.iter().filter_map(|path| path.parent()).collect();
    let with_files = used_files::common_folder(&folders).filter(|_| is_outside);
    let hint = match (with_frames, with_files) {
        (Some(common), _) => {
            format!("call chiaro farm in {}, which has all", common.display())
        }
        (None, Some(common)) => format!(
            "call chiaro farm in {}, which has them, and let -o name the frames from there",
            common.display()
        ),
        (None, None) => format!(
            "lay them on a disk that all machines share, or into {} with the document's paths to \
             them changed",
            folder.display()
        ),
    };
    Some(Diagnostic::warning("farm", message).hint(hint))
}

/// A name of letters, digits, `_` and `.`, which every farm takes.
fn name_of(document: &Path) -> String {
    let name = document.file_stem().unwrap_or_default().to_string_lossy();
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '.' { c } else { '_' };
    name.chars().map(plain).collect()
}

/// Tells what a farm of so many machines would do.
fn tell(arguments: &Arguments, workers: u32, (frames, chunk): (&FrameList, u32), output: &Output) {
    let settings = FarmSettings {
        frames: frames.frames().len(),
        chunk: chunk as usize,
        workers: workers as usize,
        frame: arguments.frame_seconds,
        between_failures: arguments.failure_hours * 3600.0,
        ..FarmSettings::default()
    };
    let told = |what: &str, figures: FarmFigures| {
        let FarmFigures { duration, useful, tasks, losses, lost, most_attempts } = figures;
        output.result(&format!(
            "{what}: {:.1} min, {:.1} % of all machines' time useful, {tasks} tasks, {losses} \
             machines lost, {:.1} machine hours drawn again, a chunk begun {most_attempts} times \
             at most",
            duration / 60.0,
            100.0 * useful,
            lost / 3600.0
        ));
    };
    told("frames that are whole are kept", simulate(settings));
    told(
        "a chunk is kept or lost whole",
        simulate(FarmSettings { keeps_frames: false, ..settings }),
    );
    let calm = FarmSettings { between_failures: f64::INFINITY, ..settings };
    told("no machine fails", simulate(calm));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_outside_a_job_are_told_with_what_helps() {
        let told = |document: &str, outside: &[&str]| {
            let outside: Vec<PathBuf> = outside.iter().map(PathBuf::from).collect();
            let told = outside_warning(Path::new("/job/here"), Path::new(document), &outside);
            told.map(|mut told| (told.message, told.hints.remove(0)))
        };
        assert_eq!(told("/job/here/shot.json", &[]), None);
        let (message, hint) = told("/job/here/shot.json", &["/job/looks/a.json"]).unwrap();
        assert!(message.starts_with("the document reads files outside"), "{message}");
        assert_eq!(hint, "call chiaro farm in /job, which has all");
        // A copy of the document beside itself helped nobody.
        let (message, hint) = told("/film/shot.json", &["/film/shot.json"]).unwrap();
        assert!(message.starts_with("the document lies outside"), "{message}");
        assert!(hint.starts_with("call chiaro farm in /film,"), "{hint}");
        let (message, hint) = told("/film/s/a.json", &["/film/m.obj", "/film/s/a.json"]).unwrap();
        assert!(message.starts_with("the document and files"), "{message}");
        assert!(hint.starts_with("call chiaro farm in /film,"), "{hint}");
        let (_, hint) = told("/job/here/shot.json", &["/mesh/m.obj"]).unwrap();
        assert!(hint.contains("share") && hint.contains("/job/here"), "{hint}");
    }
}
