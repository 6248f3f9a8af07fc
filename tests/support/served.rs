//! Folders served to a browser of this machine, for pages that import modules: a page from a file
//! may not.

use std::fs;
use std::io::{BufRead as _, BufReader, Write as _};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// Longest time that a request may take to arrive.
const PATIENCE: Duration = Duration::from_secs(20);

/// A server of folders, which ends with its [`Server`].
#[derive(Debug)]
pub struct Server {
    address: SocketAddr,
    is_over: Arc<AtomicBool>,
}

impl Server {
    /// Serves folders, each below the first part of its paths: `("three", folder)` has
    /// `/three/file.js`. The folder named `""` has all other paths.
    ///
    /// # Errors
    /// A machine that has no port to give.
    #[expect(clippy::disallowed_methods, reason = "a server answers beside the test")]
    pub fn start(folders: Vec<(String, PathBuf)>) -> Result<Self, String> {
        let text = |error: std::io::Error| format!("serving pages: {error}");
        let listener = TcpListener::bind(("127.0.0.1", 0)).map_err(text)?;
        let address = listener.local_addr().map_err(text)?;
        let is_over = Arc::new(AtomicBool::new(false));
        let (over, folders) = (Arc::clone(&is_over), Arc::new(folders));
        thread::spawn(move || {
            for stream in listener.incoming().map_while(Result::ok) {
                if over.load(Ordering::Relaxed) {
                    break;
                }
                let folders = Arc::clone(&folders);
                // A browser that has lost interest is no failure of the server.
                thread::spawn(move || answer(stream, &folders).ok());
            }
        });
        Ok(Self { address, is_over })
    }

    /// The address of a path, such as `page.html`.
    pub fn url(&self, path: &str) -> String {
        format!("http://{}/{path}", self.address)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
        // The listener wakes up to see that it is over.
        let _woken = TcpStream::connect(self.address);
    }
}

/// Answers one request: the file, or that there is none.
fn answer(mut stream: TcpStream, folders: &[(String, PathBuf)]) -> std::io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    let mut request = String::new();
    let mut lines = BufReader::new(&stream);
    lines.read_line(&mut request)?;
    let mut header = String::new();
    while lines.read_line(&mut header)? > 2 {
        header.clear();
    }
    let path = request.split(' ').nth(1).unwrap_or("/");
    let path = path.split(['?', '#']).next().unwrap_or_default().trim_start_matches('/');
    let found =
        file_of(path, folders).and_then(|file| Some((kind_of(&file), fs::read(&file).ok()?)));
    let (status, kind, bytes) = match found {
        Some((kind, bytes)) => ("200 OK", kind, bytes),
        None => ("404 Not Found", "text/plain", b"there is no such file".to_vec()),
    };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\n\
         Cache-Control: no-store\r\nConnection: close\r\n\r\n",
        bytes.len()
    )?;
    stream.write_all(&bytes)
}

/// The file that a path names; `None` for paths that lead out of their folder.
fn file_of(path: &str, folders: &[(String, PathBuf)]) -> Option<PathBuf> {
    let named = path.split_once('/').and_then(|(first, rest)| {
        let found = folders.iter().find(|(name, _)| !name.is_empty() && name == first)?;
        Some((&found.1, rest))
    });
    let whole = || folders.iter().find(|(name, _)| name.is_empty()).map(|found| (&found.1, path));
    let (folder, rest) = named.or_else(whole)?;
    let rest = Path::new(rest);
    let is_inside = rest.components().all(|part| matches!(part, Component::Normal(_)));
    is_inside.then(|| folder.join(rest))
}

/// The kind of a file for a browser, by its ending.
fn kind_of(file: &Path) -> &'static str {
    match file.extension().and_then(|ending| ending.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("css") => "text/css",
        Some("png") => "image/png",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    }
}
