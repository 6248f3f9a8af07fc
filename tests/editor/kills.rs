//! A program that edits and saves is killed at random instants: nothing older than the last
//! reported gesture is lost, and the look's file is always whole.
//!
//! The program is this test itself, started again with `CHIARO_KILLED` set to a seed and a folder.

use std::io::{BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::Duration;

use chiaro::document::{Edit, Endpoint, GraphId, History, Look, Node, Value, Wire};
use chiaro::editor::{GestureId, Session};
use chiaro::files::journal::{left_behind, recover};
use chiaro::ids::NodeId;
use chiaro::library::Library;

const KILLED: &str = "CHIARO_KILLED";

/// The generator SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.bits() % count.max(1) as u64) as usize
    }
}

/// One gesture of a user, frame by frame.
enum Gesture {
    /// Edits of each frame.
    Edits(Vec<Vec<Edit>>),
    Undo,
    Redo,
    Save,
}

/// Gesture `number` of a seed, for the look as it is at that gesture.
fn gesture(seed: u64, number: u64, look: &Look) -> Gesture {
    let mut random = Random(seed ^ number.wrapping_mul(0x1234_5678_9ABC_DEF1));
    let ids: Vec<NodeId> = look.graph.nodes.keys().cloned().collect();
    let graph = GraphId::Look;
    let id = ids[random.below(ids.len())].clone();
    match random.below(12) {
        0 => Gesture::Undo,
        1 => Gesture::Redo,
        2 | 3 => Gesture::Save,
        4 => {
            let new = NodeId::from(format!("n{number}"));
            let node = Node { kind: "add".to_owned(), ..Node::default() };
            let wire = Wire { from: Endpoint::new(id, ""), to: Endpoint::new(new.clone(), "a") };
            let add = Edit::AddNode { graph: graph.clone(), id: new, node, index: None };
            Gesture::Edits(vec![vec![add], vec![Edit::AddWire { graph, wire, index: None }]])
        }
        5 if ids.len() > 2 => Gesture::Edits(vec![vec![Edit::RemoveNode { graph, id }]]),
        6 => {
            let mut place = || [random.below(1000) as f64, random.below(1000) as f64];
            let moved = (0..20).map(|_| ids.iter().map(|id| (id.clone(), place())).collect());
            let moved =
                moved.map(|positions| vec![Edit::MoveNodes { graph: graph.clone(), positions }]);
            Gesture::Edits(moved.collect())
        }
        _ => {
            let mut value = || Value::Number(random.bits() as f64 / 1e15);
            let mut set = |port: &str| Edit::SetValue {
                graph: graph.clone(),
                id: id.clone(),
                port: port.into(),
                value: value(),
                index: None,
            };
            Gesture::Edits((0..10).map(|_| vec![set("a"), set("b")]).collect())
        }
    }
}

/// Makes gestures until the program is killed. Each gesture's number is printed once the gesture's
/// journal has been handed to the system.
#[test]
fn killed_program() {
    let Ok(told) = std::env::var(KILLED) else { return };
    let (seed, folder) = told.split_once(' ').unwrap();
    let (seed, folder) = (seed.parse().unwrap(), Path::new(folder));
    let mut session = Session::new(Arc::new(Library::default()), || {});
    session.keep_in(&folder.join("journals"), || {});
    let mut output = std::io::stdout().lock();
    for number in 1u64.. {
        match gesture(seed, number, session.look()) {
            Gesture::Edits(frames) => {
                for frame in frames {
                    for edit in frame {
                        let _ = session.apply(edit, Some(GestureId(number)));
                    }
                    session.commit(true);
                }
            }
            Gesture::Undo => drop(session.undo()),
            Gesture::Redo => drop(session.redo()),
            Gesture::Save => session.save_as(&folder.join("look.json")).unwrap(),
        }
        session.commit(false);
        session.wait_for_journal();
        writeln!(output, "done {number}").unwrap();
        output.flush().unwrap();
    }
}

/// Every state of a history, with the labels of its steps.
fn all_of(history: &History<Look>) -> Vec<String> {
    let mut history = history.clone();
    let (done, undone) = history.steps();
    let mut all = vec![format!("{done} {undone}"), history.document().to_text()];
    while let Some(label) = history.undo().map(str::to_owned) {
        all.push(label + &history.document().to_text());
    }
    while let Some(label) = history.redo().map(str::to_owned) {
        all.push(label + &history.document().to_text());
    }
    all
}

/// States that the work may have after `number` reported gestures: before, within and after the
/// next one; and the texts that the file may hold.
fn expected(seed: u64, number: u64) -> (Vec<History<Look>>, Vec<Option<String>>) {
    let begun = Session::new(Arc::new(Library::default()), || {});
    let mut history = History::new(begun.look().clone());
    let (mut may_be, mut file) = (Vec::new(), vec![None]);
    for of in 1..=number + 1 {
        may_be = vec![history.clone()];
        match gesture(seed, of, history.document()) {
            Gesture::Edits(frames) => {
                for frame in frames {
                    for edit in frame {
                        let _ = history.apply_in(of, edit);
                    }
                    may_be.push(history.clone());
                }
            }
            Gesture::Undo => drop(history.undo()),
            Gesture::Redo => drop(history.redo()),
            Gesture::Save => {
                if of <= number {
                    file.clear();
                }
                file.push(Some(history.document().to_text()));
            }
        }
        may_be.push(history.clone());
    }
    (may_be, file)
}

/// Starts the program, kills it after a while, and checks the files that it left. Returns the
/// number of gestures that it had reported.
fn kill_once(seed: u64) -> u64 {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(seed);
    let mut child = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "kills::killed_program", "--nocapture", "--test-threads=1"])
        .env(KILLED, format!("{seed} {}", folder.path().display()))
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let number_of =
        |line: &str| line.split_once("done ").and_then(|(_, number)| number.parse::<u64>().ok());
    let mut last = 0;
    let wanted = random.below(40) as u64;
    while last < wanted {
        last =
            number_of(&lines.next().expect("it works until it is killed").unwrap()).unwrap_or(last);
    }
    std::thread::park_timeout(Duration::from_micros(random.below(4000) as u64));
    child.kill().unwrap();
    child.wait().unwrap();
    // A line that was cut off counts as no report.
    let rest: Vec<String> = lines.map_while(Result::ok).collect();
    last = rest.iter().filter_map(|line| number_of(line)).max().unwrap_or(last).max(last);

    let (may_be, files) = expected(seed, last);
    let slots = left_behind(&folder.path().join("journals"));
    match slots.as_slice() {
        [slot] if slot.written().is_some() => {
            let found = recover::<Look>(slot.path())
                .unwrap_or_else(|problem| panic!("seed {seed}: {problem}"));
            assert!(found.damage.is_empty(), "seed {seed}: {:?}", found.damage);
            let all = all_of(&found.history);
            let is_one = may_be.iter().any(|history| all_of(history) == all);
            assert!(is_one, "seed {seed}: after gesture {last} this came back: {}", all[1]);
        }
        [] => assert_eq!(
            all_of(&may_be[0])[0],
            "0 0",
            "seed {seed}: nothing came back after gesture {last}"
        ),
        more => panic!("seed {seed}: {more:?}"),
    }
    let text = std::fs::read_to_string(folder.path().join("look.json")).ok();
    assert!(files.contains(&text), "seed {seed}: after gesture {last} the file holds {text:?}");
    last
}

#[allow(clippy::print_stdout, reason = "figures for those who ask with `--nocapture`")]
fn kill(times: u64, first: u64) {
    let gestures: u64 = (0..times).map(|index| kill_once(first + index)).sum();
    assert!(gestures > times, "they were killed at work: {gestures} gestures");
    println!("{times} kills after {gestures} gestures, nothing lost");
}

#[test]
fn twenty_kills_lose_nothing() {
    kill(20, 1);
}

#[test]
#[ignore = "two hundred starts of a program"]
fn soak_two_hundred_kills_lose_nothing() {
    kill(200, 1000);
}
