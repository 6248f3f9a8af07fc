//! A real Chromium that opens pages, for tests of exported packages.
//!
//! The browser is driven through its DevTools protocol: JSON messages that end with a zero byte, on
//! the file descriptors 3 and 4 of the browser (`--remote-debugging-pipe`), which a shell makes of
//! standard input and output. Every answer has a limit of time, and the browser with all of its
//! processes ends with its [`Chromium`]. WebGPU and WebGL run in software, on SwiftShader.

use std::collections::VecDeque;
use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use chiaro_language::clock::Clock;
use tempfile::TempDir;

use crate::validators::Tool;

/// Longest time that the browser may take for an answer: looks with ten shadow maps take minutes by
/// WebGL 2 in software.
const PATIENCE: Duration = Duration::from_secs(300);

/// Flags of the browser: no window, no network of its own, both graphics APIs in software.
const FLAGS: [&str; 15] = [
    "--headless=new",
    "--no-sandbox",
    "--no-first-run",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    // Without these two, showing a WebGPU canvas ends the browser's process for graphics.
    "--use-vulkan=swiftshader",
    "--enable-features=Vulkan",
    "--force-color-profile=srgb",
    "--remote-debugging-pipe",
];

/// Part of what Chromium remarks about the speed of WebGL, which is no error of the page.
const GL_REMARK: &str = "GL Driver Message (OpenGL, Performance";

/// Turn of the one browser that runs at a time in a test program: several that start together on
/// few cores leave each other without a graphics process.
static TURN: Mutex<()> = Mutex::new(());

/// A running browser with one page. Another one of the same test program starts when it is dropped.
pub struct Chromium {
    browser: Child,
    requests: ChildStdin,
    answers: Receiver<Value>,
    /// Events that came while an answer was waited for, oldest first.
    events: VecDeque<Value>,
    /// Name of the page in the protocol.
    session: Option<String>,
    last_id: u64,
    errors: Vec<String>,
    /// The browser's profile, and what it says on standard error.
    folder: TempDir,
    /// Held until the browser has ended.
    _turn: MutexGuard<'static, ()>,
}

impl Chromium {
    /// A browser with an empty page. `None`, told on standard error, where Chromium is missing and
    /// tools are not required.
    ///
    /// # Errors
    /// Reasons why the browser does not start; a missing Chromium where `CHIARO_REQUIRE_TOOLS` is
    /// 1.
    pub fn start() -> Result<Option<Self>, String> {
        if !Tool::Chromium.is_here() {
            return Tool::Chromium.missing().map(|()| None);
        }
        let mut chromium = Self::launch().map_err(|error| format!("Chromium: {error}"))?;
        let page = chromium.call("Target.createTarget", &json!({"url": "about:blank"}))?;
        let attached = json!({"targetId": page["targetId"], "flatten": true});
        let session = chromium.call("Target.attachToTarget", &attached)?;
        chromium.session = session["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Log"] {
            chromium.call(&format!("{domain}.enable"), &json!({}))?;
        }
        Ok(Some(chromium))
    }

    fn launch() -> std::io::Result<Self> {
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = tempfile::tempdir()?;
        let messages = File::create(folder.path().join("messages.txt"))?;
        let mut command = Command::new("sh");
        command
            .args(["-c", "exec chromium \"$@\" 3<&0 4>&1 </dev/null >/dev/null", "sh"])
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(messages);
        // Its own Vulkan in software, not the one that our tests draw with.
        for variable in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"] {
            command.env_remove(variable);
        }
        // A group of its own, so that the browser's processes can be ended together.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut browser = command.spawn()?;
        let missing = || std::io::Error::other("the browser has no pipes");
        let requests = browser.stdin.take().ok_or_else(missing)?;
        let answers = listen(browser.stdout.take().ok_or_else(missing)?);
        let (events, errors) = (VecDeque::new(), Vec::new());
        Ok(Self {
            browser,
            requests,
            answers,
            events,
            session: None,
            last_id: 0,
            errors,
            folder,
            _turn: turn,
        })
    }

    /// Opens a URL, such as `file:///tmp/page/index.html`, and waits for the page's event `load`.
    /// Errors of earlier pages are forgotten.
    ///
    /// # Errors
    /// Pages that cannot be opened, and pages that take too long.
    pub fn open(&mut self, url: &str) -> Result<(), String> {
        self.errors.clear();
        self.events.clear();
        let answer = self.call("Page.navigate", &json!({"url": url}))?;
        if let Some(problem) = answer["errorText"].as_str() {
            return Err(format!("{url}: {problem}"));
        }
        let waited = Clock::start();
        loop {
            while let Some(event) = self.events.pop_front() {
                if event["method"] == "Page.loadEventFired" {
                    return Ok(());
                }
            }
            let event = self.receive(waited, "the page to load")?;
            self.note(event);
        }
    }

    /// Opens a file of this machine.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_file(&mut self, path: &Path) -> Result<(), String> {
        self.open_file_with(path, "")
    }

    /// Opens a file of this machine with a query or fragment, such as `?api=webgl2`, at the end of
    /// its URL.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_file_with(&mut self, path: &Path, ending: &str) -> Result<(), String> {
        let path = path.canonicalize().map_err(|error| format!("{}: {error}", path.display()))?;
        self.open(&format!("file://{}{ending}", percent_encoded(&path.to_string_lossy())))
    }

    /// Value of a JavaScript expression in the page, as JSON; a promise is awaited.
    ///
    /// # Errors
    /// Exceptions with their message and place, rejected promises, and values that take too long.
    pub fn evaluate(&mut self, expression: &str) -> Result<Value, String> {
        // The page holds the promise: one that nothing else holds is collected as garbage, and the
        // inspector then answers that.
        let held = format!("globalThis.awaited = (0, eval)({})", json!(expression));
        let question = json!({"expression": held, "awaitPromise": true, "returnByValue": true});
        let answer = self.call("Runtime.evaluate", &question)?;
        match answer.get("exceptionDetails") {
            Some(exception) => Err(exception_text(exception)),
            None => Ok(answer["result"]["value"].clone()),
        }
    }

    /// Sets the size of the page in CSS pixels, at one device pixel each.
    ///
    /// # Errors
    /// As [`Self::call`].
    pub fn resize(&mut self, [width, height]: [u32; 2]) -> Result<(), String> {
        let metrics =
            json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": false});
        self.call("Emulation.setDeviceMetricsOverride", &metrics).map(|_| ())
    }

    /// A PNG of the page as a person sees it.
    ///
    /// # Errors
    /// As [`Self::call`].
    pub fn screenshot(&mut self) -> Result<Vec<u8>, String> {
        let answer = self.call("Page.captureScreenshot", &json!({"format": "png"}))?;
        from_base64(answer["data"].as_str().unwrap_or_default())
    }

    /// Errors and warnings of the page's console and exceptions that nothing caught, since the page
    /// was opened, a text each.
    pub fn console_errors(&self) -> &[String] {
        &self.errors
    }

    /// Answer to a method of the DevTools protocol, e.g. `Input.dispatchMouseEvent`.
    ///
    /// # Errors
    /// Errors that the browser answers with; a browser that has ended, or that takes longer than a
    /// minute.
    pub fn call(&mut self, method: &str, parameters: &Value) -> Result<Value, String> {
        self.last_id += 1;
        let id = self.last_id;
        let mut request = json!({"id": id, "method": method, "params": parameters});
        if let Some(session) = &self.session {
            request["sessionId"] = json!(session);
        }
        let mut bytes = request.to_string().into_bytes();
        bytes.push(0);
        let sent = self.requests.write_all(&bytes).and_then(|()| self.requests.flush());
        sent.map_err(|error| self.complaint(&format!("{method}: {error}")))?;
        let waited = Clock::start();
        loop {
            let mut answer = self.receive(waited, method)?;
            if answer["id"] != id {
                self.note(answer);
                continue;
            }
            return match answer["error"]["message"].as_str() {
                Some(problem) => Err(format!("{method}: {problem}")),
                None => Ok(answer["result"].take()),
            };
        }
    }

    /// The next message of the browser.
    fn receive(&mut self, waited: Clock, awaited: &str) -> Result<Value, String> {
        let left = PATIENCE.saturating_sub(Duration::from_secs_f64(waited.seconds()));
        self.answers.recv_timeout(left).map_err(|error| match error {
            RecvTimeoutError::Timeout => {
                self.complaint(&format!("no answer: waited for {awaited}"))
            }
            RecvTimeoutError::Disconnected => {
                self.complaint(&format!("the browser ended: waited for {awaited}"))
            }
        })
    }

    /// Keeps an event, and the text of an error that it tells.
    fn note(&mut self, event: Value) {
        let parameters = &event["params"];
        let entry = &parameters["entry"];
        match event["method"].as_str() {
            Some("Runtime.consoleAPICalled")
                if ["error", "warning", "assert"]
                    .map(Value::from)
                    .contains(&parameters["type"]) =>
            {
                let words = parameters["args"].as_array().into_iter().flatten().map(shown);
                self.errors.push(words.collect::<Vec<_>>().join(" "));
            }
            Some("Runtime.exceptionThrown") => {
                self.errors.push(exception_text(&parameters["exceptionDetails"]));
            }
            Some("Log.entryAdded")
                if ["error", "warning"].map(Value::from).contains(&entry["level"])
                    && !entry["text"].as_str().is_some_and(|text| text.contains(GL_REMARK)) =>
            {
                self.errors.push(shown(&json!({"value": entry["text"]})));
            }
            _ => {}
        }
        // Events are kept only while a page loads, and few.
        if self.events.len() == 1024 {
            self.events.pop_front();
        }
        self.events.push_back(event);
    }

    /// A complaint with the last lines that the browser wrote on standard error.
    fn complaint(&self, problem: &str) -> String {
        let messages = std::fs::read(self.folder.path().join("messages.txt")).unwrap_or_default();
        let messages = String::from_utf8_lossy(&messages);
        let lines: Vec<&str> = messages.lines().collect();
        format!("Chromium: {problem}\n{}", lines[lines.len().saturating_sub(12)..].join("\n"))
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        // The group has the number of its first process.
        let group = format!("-{}", self.browser.id());
        let ended = Command::new("kill").args(["-KILL", "--", &group]).status();
        if !ended.is_ok_and(|status| status.success()) {
            let _is_over = self.browser.kill();
        }
        let _status = self.browser.wait();
    }
}

/// Reads messages on a thread of its own, which ends with the browser.
#[expect(clippy::disallowed_methods, reason = "a pipe has to be read beside the test")]
fn listen(pipe: ChildStdout) -> Receiver<Value> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let messages = BufReader::new(pipe).split(0).map_while(Result::ok);
        for message in messages.filter_map(|bytes| serde_json::from_slice(&bytes).ok()) {
            if sender.send(message).is_err() {
                break;
            }
        }
    });
    receiver
}

/// Text of an argument of the console.
fn shown(argument: &Value) -> String {
    let value = argument.get("value").or_else(|| argument.get("description"));
    value.map_or_else(String::new, |value| {
        value.as_str().map_or_else(|| value.to_string(), Into::into)
    })
}

/// Message of an exception, with its place.
fn exception_text(details: &Value) -> String {
    let exception = &details["exception"];
    let message = exception["description"].as_str().map_or_else(|| shown(exception), Into::into);
    let place = format!("{}:{}", details["url"].as_str().unwrap_or("page"), details["lineNumber"]);
    let text = details["text"].as_str().unwrap_or("exception");
    format!("{place}: {text}: {message}")
}

/// A path as a URL writes it.
fn percent_encoded(path: &str) -> String {
    let mut encoded = String::new();
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"/-._~".contains(&byte) {
            encoded.push(char::from(byte));
        } else {
            let _infallible = write!(encoded, "%{byte:02X}");
        }
    }
    encoded
}

/// Bytes of a text in base64, as JavaScript's `btoa` writes it.
///
/// # Errors
/// The first letter that is not of base64.
pub fn from_base64(text: &str) -> Result<Vec<u8>, String> {
    let digit = |letter: u8| match letter {
        b'A'..=b'Z' => Ok(letter - b'A'),
        b'a'..=b'z' => Ok(letter - b'a' + 26),
        b'0'..=b'9' => Ok(letter - b'0' + 52),
        b'+' => Ok(62),
        b'/' => Ok(63),
        _ => Err(format!("`{}` is no letter of base64", char::from(letter))),
    };
    let letters: Vec<u8> = text.bytes().filter(|&letter| letter != b'=').collect();
    let mut bytes = Vec::with_capacity(letters.len() * 3 / 4);
    for four in letters.chunks(4) {
        let mut bits = 0_u32;
        for &letter in four {
            bits = bits << 6 | u32::from(digit(letter)?);
        }
        bits <<= 6 * (4 - four.len());
        bytes.extend(&bits.to_be_bytes()[1..four.len()]);
    }
    Ok(bytes)
}
