//! A farm that is one: Slurm itself, started in a folder of its own on the loopback.

use std::fs;
use std::io::Write as _;
use std::net::TcpListener;
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use crate::film::Stage;
use crate::support::validators::{Tool, slurm_program};

/// Time until the whole job must be done.
const PATIENCE: Duration = Duration::from_secs(120);

/// A cluster of this machine alone. Its daemons end with it.
struct Cluster {
    folder: PathBuf,
}

impl Cluster {
    /// Starts the daemons; all of their files lie in a folder.
    fn start(folder: &Path) -> Self {
        for name in ["munge", "state", "spool", "log"] {
            fs::create_dir_all(folder.join(name)).unwrap();
        }
        fs::set_permissions(folder.join("munge"), fs::Permissions::from_mode(0o755)).unwrap();
        let host = said(Command::new("hostname").arg("-s"));
        let user = said(Command::new("id").arg("-un"));
        let munge = |name: &str| folder.join("munge").join(name);
        run(program("mungekey").arg("--create").arg("--keyfile").arg(munge("key")));
        let mut munged = program("munged");
        munged.arg("--force");
        for (option, name) in [
            ("key-file", "key"),
            ("socket", "socket"),
            ("pid-file", "pid"),
            ("log-file", "log"),
            ("seed-file", "seed"),
        ] {
            munged.arg(format!("--{option}={}", munge(name).display()));
        }
        run(&mut munged);
        // Two ports that nobody has now.
        let free: Vec<TcpListener> =
            (0..2).map(|_| TcpListener::bind("127.0.0.1:0").unwrap()).collect();
        let ports: Vec<u16> = free.iter().map(|one| one.local_addr().unwrap().port()).collect();
        drop(free);
        let place = folder.display();
        let conf = format!(
            "ClusterName=chiaro\nSlurmctldHost={host}(127.0.0.1)\nSlurmUser={user}\n\
             SlurmdUser={user}\nAuthType=auth/munge\nAuthInfo=socket={place}/munge/socket\n\
             CredType=cred/munge\nStateSaveLocation={place}/state\nSlurmdSpoolDir={place}/spool\n\
             SlurmctldPidFile={place}/slurmctld.pid\nSlurmdPidFile={place}/slurmd.pid\n\
             SlurmctldLogFile={place}/log/slurmctld\nSlurmdLogFile={place}/log/slurmd\n\
             SlurmctldPort={}\nSlurmdPort={}\nProctrackType=proctrack/pgid\n\
             TaskPlugin=task/none\nSwitchType=switch/none\nMpiDefault=none\nReturnToService=2\n\
             SchedulerType=sched/backfill\n\
             SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1\n\
             SelectType=select/cons_tres\nSelectTypeParameters=CR_Core\nJobRequeue=1\n\
             MinJobAge=300\nAccountingStorageType=accounting_storage/none\n\
             JobAcctGatherType=jobacct_gather/none\n\
             NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\n\
             PartitionName=film Nodes={host} Default=YES MaxTime=INFINITE State=UP\n",
            ports[0], ports[1]
        );
        fs::write(folder.join("slurm.conf"), conf).unwrap();
        let cluster = Self { folder: folder.to_owned() };
        run(program("slurmctld").arg("-f").arg(cluster.conf()));
        run(program("slurmd").arg("-f").arg(cluster.conf()));
        let is_idle = || cluster.asked(&["sinfo", "-h", "-o", "%T"]).contains("idle");
        assert!(until(Duration::from_secs(30), is_idle), "{}", cluster.logs());
        cluster
    }

    fn conf(&self) -> PathBuf {
        self.folder.join("slurm.conf")
    }

    fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command.env("SLURM_CONF", self.conf());
        command
    }

    /// The output of a command, empty where it fails.
    fn asked(&self, words: &[&str]) -> String {
        let ran = self.command(words[0]).args(&words[1..]).output().unwrap();
        String::from_utf8_lossy(&ran.stdout).into_owned()
    }

    fn logs(&self) -> String {
        let read = |name| fs::read_to_string(self.folder.join("log").join(name));
        ["slurmctld", "slurmd"].map(|name| read(name).unwrap_or_default()).join("\n")
    }
}

impl Drop for Cluster {
    fn drop(&mut self) {
        for file in ["slurmd.pid", "slurmctld.pid", "munge/pid"] {
            let Ok(id) = fs::read_to_string(self.folder.join(file)) else { continue };
            let _ = Command::new("kill").arg(id.trim()).status();
            // A process that has ended has no program, also while nobody has asked how.
            let is_gone = || fs::read_link(format!("/proc/{}/exe", id.trim())).is_err();
            until(Duration::from_secs(5), is_gone);
        }
    }
}

fn program(name: &str) -> Command {
    Command::new(slurm_program(name))
}

#[track_caller]
fn run(command: &mut Command) {
    let ran = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(ran.status.success(), "{command:?}: {}", String::from_utf8_lossy(&ran.stderr));
}

fn said(command: &mut Command) -> String {
    String::from_utf8(command.output().unwrap().stdout).unwrap().trim().to_owned()
}

/// Asks again and again; true if it came true in time.
#[expect(
    clippy::disallowed_methods,
    reason = "daemons of others, who tell nobody when they are up"
)]
fn until(patience: Duration, mut is_so: impl FnMut() -> bool) -> bool {
    let start = Instant::now();
    while start.elapsed() < patience {
        if is_so() {
            return true;
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    false
}

/// A process of our program that works in a folder.
fn process_in(folder: &Path) -> Option<String> {
    let folder = fs::canonicalize(folder).ok()?;
    let program = fs::canonicalize(env!("CARGO_BIN_EXE_chiaro")).ok()?;
    let processes = fs::read_dir("/proc").ok()?.flatten();
    let is_ours = |path: &Path| {
        let link = |name: &str| fs::read_link(path.join(name)).ok();
        link("cwd").as_deref() == Some(&folder) && link("exe").as_deref() == Some(&program)
    };
    let mut ours = processes.filter(|process| is_ours(&process.path()));
    ours.next()?.file_name().into_string().ok()
}

#[test]
fn a_real_slurm_draws_every_frame_although_a_task_is_killed() {
    if !Tool::Slurm.is_here() {
        Tool::Slurm.missing().expect("a required tool");
        return;
    }
    let stage = Stage::new();
    let cluster_folder = tempfile::tempdir().unwrap();
    let cluster = Cluster::start(cluster_folder.path());
    fs::create_dir(stage.path("out")).unwrap();
    let program = env!("CARGO_BIN_EXE_chiaro");
    let drawn = [
        "look.json",
        "--size",
        "120x80",
        "--samples",
        "4",
        "--mesh",
        "shape:sphere",
        "--on",
        "reference",
    ];
    let farm = [
        "farm",
        "-o",
        "out/####.exr",
        "--frames",
        "1-24",
        "--chunk",
        "6",
        "--to",
        "slurm",
        "--job",
        "job.sh",
        "--program",
        program,
    ];
    stage.done(&[&farm[..], &drawn].concat());
    let mut submit = cluster.command("sh");
    let submitted = said(submit.arg("job.sh").current_dir(stage.folder()));
    assert_eq!(submitted.split(' ').count(), 2, "{submitted}: {}", cluster.logs());
    // One task is killed without a word while it draws.
    let mut killed = None;
    until(PATIENCE, || {
        killed = process_in(stage.folder());
        killed.as_ref().is_some_and(|id| {
            Command::new("kill").args(["-KILL", id]).status().is_ok_and(|status| status.success())
        })
    });
    let _ = writeln!(std::io::stderr(), "killed {killed:?} of {submitted}");
    assert!(killed.is_some(), "{}", cluster.logs());
    let is_done = || cluster.asked(&["squeue", "-h"]).trim().is_empty();
    let logs = || {
        let names = stage.names();
        let logs = names.iter().filter(|name| name.ends_with(".log"));
        logs.map(|name| fs::read_to_string(stage.path(name)).unwrap()).collect::<String>()
    };
    assert!(until(PATIENCE, is_done), "{}\n{}", cluster.logs(), logs());
    assert!(logs().contains("24 frames, all whole"), "{}", logs());
    assert!(stage.path("out/sheet.png").is_file(), "{}", logs());
    // A run on this machine alone makes the same frames.
    let alone = ["render", "-o", "alone.####.exr", "--frames", "1-24"];
    stage.done(&[&alone[..], &drawn].concat());
    let [_, told] =
        stage.done(&["verify", "out/####.exr", "--frames", "1-24", "--against", "alone.####.exr"]);
    assert!(told.contains("equal to the other run's to the bit"), "{told}");
}
