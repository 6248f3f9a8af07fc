//! A page of a JavaScript library with packages, served to Chromium: pages from files cannot import
//! modules.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::chromium::{Chromium, from_base64};
use crate::support::root;
use crate::support::served::Server;
use crate::support::validators::Tool;
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::pictures::{Difference, SIZE, Trial, keep, soak_trials};
use crate::table;

/// The APIs that libraries draw by.
pub(crate) const APIS: [&str; 2] = ["webgl", "webgpu"];

/// The camera of the pages.
const CAMERA: &str = "eye=0.8,0.9,3;target=0,0,0;fov=30";

/// A library that packages are made for.
pub(crate) struct Library {
    /// Name of the package and of the library's folder on the server.
    pub(crate) slug: &'static str,
    /// The tool that has to be here.
    pub(crate) tool: Tool,
    /// The library's own folder.
    pub(crate) folder: fn() -> PathBuf,
    /// Files of this folder that the page is made of, the page first.
    pub(crate) page: &'static [&'static str],
}

/// A page of a library with packages.
pub(crate) struct Page {
    library: &'static Library,
    pub(crate) browser: Chromium,
    server: Server,
    /// Names of the packages' files, and their folders.
    packages: Vec<(String, PathBuf)>,
    folder: TempDir,
}

impl Page {
    /// A page for packages; `None`, told on standard error, where a tool is missing.
    pub(crate) fn new(library: &'static Library, trials: &[&Trial]) -> Option<Self> {
        if !library.tool.is_here() {
            library.tool.missing().expect(library.slug);
            return None;
        }
        let browser = Chromium::start().expect("Chromium starts")?;
        let folder = tempfile::tempdir().expect("a folder");
        for name in library.page {
            let file = root().join("tests/packages").join(name);
            fs::copy(file, folder.path().join(name)).expect("the page is written");
        }
        let packages: Vec<_> = trials
            .iter()
            .map(|trial| {
                let package = trial.package(library.slug);
                (stem_of(&package), package)
            })
            .collect();
        let places = packages.iter().enumerate();
        let mut served: Vec<_> =
            places.map(|(place, (_, package))| (format!("{place}"), package.clone())).collect();
        served.push((library.slug.to_owned(), (library.folder)()));
        served.push((String::new(), folder.path().to_owned()));
        let server = Server::start(served).expect("a server");
        Some(Self { library, browser, server, packages, folder })
    }

    /// Opens the page for an API.
    pub(crate) fn open(&mut self, api: &str) {
        let page = self.server.url(&format!("{}?{api}", self.library.page[0]));
        self.browser.open(&page).expect("the page opens");
        let ready = "new Promise((resolve) => {
            const wait = () => (window.isReady ? resolve(true) : setTimeout(wait, 10));
            wait();
        })";
        self.evaluate(ready);
    }

    pub(crate) fn evaluate(&mut self, expression: &str) -> Value {
        let value = self.browser.evaluate(expression);
        value.unwrap_or_else(|error| panic!("{error}\n{:?}", self.browser.console_errors()))
    }

    /// Wears the look of a package, by its place in the list.
    pub(crate) fn wear(&mut self, place: usize) {
        let stem = json!(self.packages[place].0);
        self.evaluate(&format!("test.wear('{place}', {stem}).then(() => true)"));
    }

    /// The pixels that the library draws.
    pub(crate) fn pixels(&mut self) -> Vec<u8> {
        let [width, height] = SIZE;
        let text = self.evaluate(&format!("test.pixels({width}, {height})"));
        let errors = self.browser.console_errors();
        assert!(errors.is_empty(), "{errors:?}");
        from_base64(text.as_str().expect("base64")).expect("bytes")
    }

    /// The mesh of the page as a file, with what else our own picture is to be drawn with.
    pub(crate) fn own_arguments(&mut self) -> [String; 4] {
        let mesh = self.folder.path().join("knot.gltf");
        let text = self.evaluate("test.gltf()");
        fs::write(&mesh, text.as_str().expect("a text")).expect("the mesh is written");
        let mesh = mesh.display().to_string();
        ["--mesh".to_owned(), mesh, "--camera".to_owned(), CAMERA.to_owned()]
    }
}

/// The beginning of the names of a package's files.
fn stem_of(package: &Path) -> String {
    let mut names = fs::read_dir(package)
        .expect("a package")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned());
    let stem = names.find_map(|name| Some(name.strip_suffix(".material.js")?.to_owned()));
    stem.expect("a material")
}

/// Compares looks in a library with our own pictures, and the differences with the table.
pub(crate) fn compare(library: &'static Library, trials: &[(String, Trial)]) {
    let Some(mut page) =
        Page::new(library, &trials.iter().map(|(_, trial)| trial).collect::<Vec<_>>())
    else {
        return;
    };
    let mut measured = BTreeMap::new();
    let mut ours = Vec::new();
    for api in APIS {
        page.open(api);
        for (place, (name, trial)) in trials.iter().enumerate() {
            page.wear(place);
            if ours.len() == place {
                let arguments = page.own_arguments();
                ours.push(trial.ours_with_arguments(&arguments.each_ref().map(String::as_str)));
            }
            let pixels = page.pixels();
            keep(&format!("{name}.{api}"), &pixels, &ours[place]);
            let found = Difference::of(&pixels, &ours[place]);
            measured.insert(format!("{} {api} {name}", library.slug), found);
        }
    }
    table::check(&measured);
}

/// Compares all example looks that the package takes.
pub(crate) fn compare_all(library: &'static Library) {
    // A few at a time, so that what was measured stands in the table if a later one fails.
    for trials in soak_trials(library.slug, |trial| trial).chunks(8) {
        compare(library, trials);
    }
}
