//! HTML of the pages.

use std::fmt::Write as _;

use super::entry::GalleryEntry;
use super::{GENERATOR, GalleryOptions, List, Section};
use crate::accuracy::report::{MeasurementRow, MeasurementSubject};
use crate::catalog::Catalog;
use crate::document::Look;
use crate::drawing::{escaped, graph_svg};

/// Stylesheet of all pages.
pub(super) const STYLE: &str = include_str!("style.css");

fn head(title: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{GENERATOR}\n\
         <meta name=\"viewport\" content=\"width=device-width, \
         initial-scale=1\">\n<title>{}</title>\n\
         <link rel=\"stylesheet\" href=\"style.css\">\n</head>\n<body>\n",
        escaped(title)
    )
}

/// The text as HTML; blank lines separate paragraphs.
fn paragraphs(text: &str) -> String {
    let filled = text.split("\n\n").map(str::trim).filter(|paragraph| !paragraph.is_empty());
    filled.map(|paragraph| format!("<p>{}</p>\n", escaped(paragraph))).collect()
}

/// The index page, with all pictures.
pub(super) struct Index {
    html: String,
    is_open: bool,
}

impl Index {
    pub(super) fn new(list: &List) -> Self {
        let mut html = head(&list.title);
        let _ = write!(
            html,
            "<header>\n<h1>{}</h1>\n{}</header>\n<main>\n",
            escaped(&list.title),
            paragraphs(&list.about)
        );
        Self { html, is_open: false }
    }

    pub(super) fn section(&mut self, section: &Section) {
        self.close();
        if !section.title.is_empty() {
            let _ = writeln!(self.html, "<h2>{}</h2>", escaped(&section.title));
        }
        self.html += &paragraphs(&section.about);
        self.html += "<div class=\"grid\">\n";
        self.is_open = true;
    }

    pub(super) fn entry(&mut self, entry: &GalleryEntry, slug: &str) {
        let [width, height] = entry.size;
        let name = escaped(&entry.name);
        let _ = writeln!(
            self.html,
            "<a class=\"card\" href=\"{slug}.html\"><img src=\"{slug}.png\" width=\"{width}\" \
             height=\"{height}\" \
             alt=\"{name}\" loading=\"lazy\"><span>{name}</span></a>"
        );
    }

    fn close(&mut self) {
        if std::mem::take(&mut self.is_open) {
            self.html += "</div>\n";
        }
    }

    pub(super) fn finish(mut self) -> String {
        self.close();
        self.html + "</main>\n</body>\n</html>\n"
    }
}

/// Name of the file of a graph on a page, by the index of the look.
pub(super) fn graph_file(slug: &str, place: usize) -> String {
    if place == 0 { format!("{slug}-graph.svg") } else { format!("{slug}-graph-{}.svg", place + 1) }
}

/// A look's graph, as SVG.
pub(super) fn graph(look: &Look, catalog: &Catalog) -> String {
    graph_svg(look, &look.graph, catalog, None)
}

/// HTML of one document's page.
pub(super) fn entry(
    entry: &GalleryEntry,
    slug: &str,
    list: &List,
    options: &GalleryOptions,
) -> String {
    let mut html = head(&format!("{} – {}", entry.name, list.title));
    let [width, height] = entry.size;
    let name = escaped(&entry.name);
    let _ = write!(
        html,
        "<nav><a href=\"index.html\">{}</a></nav>\n<header class=\"entry\">\n<img \
         src=\"{slug}.png\" width=\"{width}\" \
         height=\"{height}\" \
         alt=\"{name}\">\n<div>\n<h1>{name}</h1>\n{}{}</div>\n</header>\n<main>\n",
        escaped(&list.title),
        paragraphs(&entry.about),
        facts(entry, options),
    );
    if let Some(report) = &entry.report {
        html += "<h2>What it costs, and how accurate it is</h2>\n";
        html += &costs(&report.rows);
        let software = if report.is_software {
            ", a software adapter, whose times say little about a GPU's"
        } else {
            ""
        };
        let clock = if report.has_timestamps { "GPU timestamps" } else { "the clock on the wall" };
        let [width, height] = report.size;
        let _ = writeln!(
            html,
            "<p class=\"small\">{width}x{height}, one sample a pixel, {} rounds on {}{software}; \
             medians by {clock}. Errors are \
             distances from the reference's picture in f64, in channels from 0 to 1.</p>",
            report.rounds,
            escaped(&report.adapter),
        );
    }
    for (place, look) in entry.looks.iter().enumerate() {
        let file = graph_file(slug, place);
        let title = if entry.looks.len() == 1 {
            "Graph".to_owned()
        } else {
            format!("Graph of {}", escaped(&look.name))
        };
        let _ = writeln!(
            html,
            "<h2>{title}</h2>\n<a class=\"graph\" href=\"{file}\"><img src=\"{file}\" \
             alt=\"{title}\" loading=\"lazy\"></a>"
        );
    }
    html += "<h2>Shader</h2>\n";
    for (name, wgsl) in &entry.shaders {
        let lines = wgsl.lines().count();
        let of =
            if entry.shaders.len() == 1 { String::new() } else { format!(" of {}", escaped(name)) };
        let _ = writeln!(
            html,
            "<details><summary>The WGSL{of}, {lines} \
             lines</summary>\n<pre><code>{}</code></pre></details>",
            escaped(wgsl)
        );
    }
    html + "</main>\n</body>\n</html>\n"
}

fn facts(entry: &GalleryEntry, options: &GalleryOptions) -> String {
    let kind = |(kind, count): (&String, &usize)| {
        let name = match &options.nodes {
            Some(nodes) => format!("<a href=\"{0}#{1}\">{1}</a>", escaped(nodes), escaped(kind)),
            None => escaped(kind),
        };
        if *count > 1 { format!("{name} &times;{count}") } else { name }
    };
    let kinds: Vec<String> = entry.kinds.iter().map(kind).collect();
    let passes: Vec<&str> = entry.passes.iter().map(|pass| pass.id.label()).collect();
    format!(
        "<dl>\n<dt>File</dt><dd>{}</dd>\n<dt>Passes</dt><dd>{}</dd>\n\
         <dt>Triangles</dt><dd>{}</dd>\n<dt>Nodes</dt><dd>{}</dd>\n</dl>\n",
        escaped(&entry.file),
        passes.join(", "),
        entry.triangles,
        kinds.join(", "),
    )
}

fn costs(rows: &[MeasurementRow]) -> String {
    let mut html = String::from(
        "<table>\n<tr><th>Tier</th><th>ms</th><th>95% interval</th><th>largest error</th><th>99.9% \
         are below</th>\
         <th>RMS</th><th>pixels over 1/255</th></tr>\n",
    );
    for row in rows {
        let what = match &row.subject {
            MeasurementSubject::Whole => row.tier.word().to_owned(),
            MeasurementSubject::Pass(kind) => format!("&nbsp;&nbsp;{} pass", kind.label()),
            MeasurementSubject::Node { name, .. } => escaped(name),
        };
        let small =
            |number: f64| if number == 0.0 { "0".to_owned() } else { format!("{number:.1e}") };
        let errors = match &row.error {
            Some(error) => {
                let [max, p999, rms] = [error.max, error.p999, error.rms].map(small);
                format!("<td>{max}</td><td>{p999}</td><td>{rms}</td><td>{}</td>", error.visible)
            }
            None => "<td></td>".repeat(4),
        };
        let time = &row.time;
        let _ = writeln!(
            html,
            "<tr><td>{what}</td><td>{:.2}</td><td>{:.2} to {:.2}</td>{errors}</tr>",
            time.median, time.low, time.high
        );
    }
    html + "</table>\n"
}
