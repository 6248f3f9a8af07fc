//! Time from the start of the program to its first picture, as a real `chiaro` reports it.

use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use chiaro::clock::Clock;
use chiaro::milestones;

use crate::times::spread;
use crate::{example, has_display};

/// Number of starts that are counted; one more comes before them to warm up files, the program's
/// cache and the driver's.
const STARTS: usize = 7;
/// Name of the last milestone.
const LAST: &str = "picture on the screen";

/// Times of one start: seconds from the program's start to every milestone.
fn start(has_display: bool, cache: &Path) -> BTreeMap<String, f64> {
    let look = example("figure1-layers");
    let folder = tempfile::tempdir().expect("a folder for what the program remembers");
    let mut command = Command::new(env!("CARGO_BIN_EXE_chiaro"));
    if has_display {
        command.arg("edit").arg(look);
    } else {
        command
            .arg("render")
            .arg(look)
            .args(["-s", "800x600", "-o"])
            .arg(folder.path().join("picture.png"));
    }
    for place in ["CHIARO_CONFIG_DIR", "CHIARO_STATE_DIR", "XDG_DATA_HOME"] {
        command.env(place, folder.path());
    }
    command.env("CHIARO_CACHE_DIR", cache);
    command.env(milestones::VARIABLE, "1").stdout(Stdio::null()).stderr(Stdio::piped());
    let clock = Clock::start();
    let mut program = command.spawn().expect("the program that was built with this benchmark");
    let mut told = BTreeMap::new();
    let mut before = 0.0;
    for line in
        BufReader::new(program.stderr.take().expect("it is piped")).lines().map_while(Result::ok)
    {
        let Ok(line) = serde_json::from_str::<serde_json::Value>(&line) else { continue };
        let (Some(milestone), Some(seconds)) =
            (line["milestone"].as_str(), line["seconds"].as_f64())
        else {
            continue;
        };
        if told.is_empty() {
            // The program counts from its own beginning; the time before that is measured from
            // outside.
            before = clock.seconds() - seconds;
        }
        told.insert(milestone.to_owned(), before + seconds);
        if milestone == LAST {
            break;
        }
    }
    // The window stays open until killed; for a program that has ended, killing does nothing.
    let _ = program.kill();
    let _ = program.wait();
    told
}

pub(crate) fn run() {
    let has_display = has_display();
    let what = if has_display {
        "`chiaro edit`, a window"
    } else {
        "`chiaro render`, as there is no display"
    };
    let cache = tempfile::tempdir().expect("a folder for what the program keeps");
    start(has_display, cache.path());
    let mut all: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for _ in 0..STARTS {
        for (milestone, seconds) in start(has_display, cache.path()) {
            all.entry(milestone).or_default().push(seconds * 1e3);
        }
    }
    let mut rows: Vec<_> = all.into_iter().map(|(name, times)| (name, spread(times))).collect();
    rows.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    println!(
        "\nStart of {what}, on figure1-layers: ms since the program was asked for, of {STARTS} \
         starts"
    );
    println!("\n| milestone | median | p95 | since the one before |");
    println!("| --- | ---: | ---: | ---: |");
    let mut before = 0.0;
    for (name, [median, p95]) in rows {
        println!("| {name} | {median:.0} | {p95:.0} | {:.0} |", median - before);
        before = median;
    }
}
