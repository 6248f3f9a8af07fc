//! Wavefront OBJ: polygons of any shape, negative indices, materials by `usemtl`, colors after the
//! coordinates.
//!
//! Two walks through the lines: first the points, normals and UVs, then the faces, since a face may
//! name a point that comes later. Smoothing groups are left to the crease angle; material
//! libraries, lines, points and groups say nothing that Chiaro uses.

use chiaro_locale::{Text, text, tr};

use super::report::ImportReport;
use super::{MAX_TRIANGLES, MAX_VERTICES};
use crate::diag::Diagnostic;
use crate::geometry::mesh::DEFAULT_MATERIAL;
use crate::geometry::soup::{Corner, NONE, Polygon, TriangleSoup};

/// Reads the text of an OBJ file; text that is no UTF-8 is read with replacement characters in
/// names.
pub(super) fn read(bytes: &[u8], report: &mut ImportReport) -> TriangleSoup {
    let text = String::from_utf8_lossy(bytes);
    let mut reader = Reader { text: &text, soup: TriangleSoup::default(), colored: 0, report };
    let mut names = Vec::new();
    let mut statements = Statements::new(&text);
    let mut tokens = Vec::new();
    while statements.next_into(&mut tokens) && reader.soup.points.len() <= MAX_VERTICES {
        match tokens[0] {
            "v" => reader.point(&tokens),
            "vn" => reader.normal(&tokens),
            "vt" => reader.uv(&tokens),
            "o" => names.extend(tokens.get(1).copied()),
            "curv" | "curv2" | "surf" | "cstype" => reader.unsupported(tokens[0]),
            _ => {}
        }
    }
    let counts = [reader.soup.points.len(), reader.soup.normals.len(), reader.soup.uvs.len()];
    if counts.iter().any(|&count| count > MAX_VERTICES) {
        reader.report.error(
            "mesh-too-large",
            tr!("the file has more than {MAX_VERTICES} points, normals or UVs"),
        );
        return TriangleSoup::default();
    }
    reader.faces();
    let Reader { mut soup, colored, .. } = reader;
    if let [name] = names[..] {
        name.clone_into(&mut soup.name);
    }
    soup.colors = if colored == 0 { Vec::new() } else { scaled_colors(soup.colors) };
    soup
}

/// Scales colors to 0 to 1: some programs write them as 0 to 255.
fn scaled_colors(mut colors: Vec<[f32; 4]>) -> Vec<[f32; 4]> {
    let in_bytes = colors.iter().any(|c| c[..3].iter().any(|&x| x > 1.0));
    let scale = if in_bytes { 1.0 / 255.0 } else { 1.0 };
    for color in &mut colors {
        let [r, g, b, a] = *color;
        // A point without a color among points with one is white in either unit.
        *color = if a < 0.0 {
            [1.0; 4]
        } else {
            [r * scale, g * scale, b * scale, a].map(|x| x.clamp(0.0, 1.0))
        };
    }
    colors
}

/// The statements of a text, as lists of words: comments are dropped, lines that end in `\` joined
/// to the next.
struct Statements<'a> {
    lines: std::str::Lines<'a>,
}

impl<'a> Statements<'a> {
    fn new(text: &'a str) -> Self {
        Self { lines: text.lines() }
    }

    /// Puts the words of the next line that has any into `tokens`; false at the end of the text.
    fn next_into(&mut self, tokens: &mut Vec<&'a str>) -> bool {
        tokens.clear();
        for line in self.lines.by_ref() {
            let line = line.split('#').next().unwrap_or("");
            let (line, goes_on) =
                line.trim_end().strip_suffix('\\').map_or((line, false), |line| (line, true));
            tokens.extend(line.split_ascii_whitespace());
            if !goes_on && !tokens.is_empty() {
                break;
            }
        }
        !tokens.is_empty()
    }
}

struct Reader<'a, 'r> {
    text: &'a str,
    soup: TriangleSoup,
    /// Number of points that have a color.
    colored: usize,
    report: &'r mut ImportReport,
}

impl Reader<'_, '_> {
    fn error(&mut self, token: &str, code: &'static str, message: String) {
        self.report.error_at(self.text, token, code, message);
    }

    fn unsupported(&mut self, keyword: &str) {
        let diagnostic =
            Diagnostic::warning("mesh-unsupported", tr!("`{keyword}` surfaces are left out"))
                .hint(tr!("export the surface as polygons"));
        self.report.add_at(self.text, keyword, diagnostic);
    }

    /// The numbers after the keyword, at least `least` and at most `N`; zeros where a number cannot
    /// be read, so that counting goes on. The second value is the count of numbers given.
    fn numbers<const N: usize>(
        &mut self,
        tokens: &[&str],
        least: usize,
        what: Text,
        index: usize,
    ) -> ([f32; N], usize) {
        let mut values = [0.0; N];
        let given = tokens.len() - 1;
        if given < least {
            let message =
                tr!("{what} {number} has {given} of its {least} numbers", number = index + 1);
            self.error(tokens[0], "mesh-syntax", message);
            return (values, 0);
        }
        for (value, token) in values.iter_mut().zip(&tokens[1..]) {
            match token.parse::<f32>() {
                Ok(number) if number.is_finite() => *value = number,
                Ok(_) => {
                    let message = tr!(
                        "{what} {number} has the coordinate `{token}`, which is not finite",
                        number = index + 1
                    );
                    self.error(token, "mesh-not-finite", message);
                }
                Err(_) => {
                    let message =
                        tr!("`{token}` in {what} {number} is not a number", number = index + 1);
                    self.error(token, "mesh-syntax", message);
                }
            }
        }
        (values, given.min(N))
    }

    fn point(&mut self, tokens: &[&str]) {
        let index = self.soup.points.len();
        let ([x, y, z, r, g, b, a], given) = self.numbers::<7>(tokens, 3, text!("vertex"), index);
        self.soup.points.push([x, y, z]);
        // Four numbers are x y z w: w matters to rational curves only. An alpha below 0 marks a
        // point without color.
        self.soup.colors.push(match given {
            6 => [r, g, b, 1.0],
            7 => [r, g, b, a.max(0.0)],
            _ => [0.0, 0.0, 0.0, -1.0],
        });
        self.colored += usize::from(given >= 6);
    }

    fn normal(&mut self, tokens: &[&str]) {
        let index = self.soup.normals.len();
        let (normal, _) = self.numbers::<3>(tokens, 3, text!("normal"), index);
        self.soup.normals.push(normal);
    }

    fn uv(&mut self, tokens: &[&str]) {
        let index = self.soup.uvs.len();
        let (uv, _) = self.numbers::<2>(tokens, 1, Text::new("UV"), index);
        self.soup.uvs.push(uv);
    }

    fn faces(&mut self) {
        let mut statements = Statements::new(self.text);
        let mut tokens = Vec::new();
        let mut material = None;
        // Counts of points, UVs and normals before the line: negative indices count back from them.
        let mut before = [0; 3];
        let mut polygon = Polygon::default();
        while statements.next_into(&mut tokens) {
            match tokens[0] {
                "v" => before[0] += 1,
                "vt" => before[1] += 1,
                "vn" => before[2] += 1,
                "usemtl" => {
                    let name = if tokens.len() > 1 {
                        tokens[1..].join(" ")
                    } else {
                        DEFAULT_MATERIAL.to_owned()
                    };
                    material = Some(self.soup.material(&name));
                }
                "f" | "fo" => {
                    let material =
                        *material.get_or_insert_with(|| self.soup.material(DEFAULT_MATERIAL));
                    self.face(&tokens, before, material, &mut polygon);
                }
                _ => {}
            }
            if self.soup.triangles.len() > MAX_TRIANGLES {
                let message = tr!("the file has more than {MAX_TRIANGLES} triangles");
                self.error(tokens[0], "mesh-too-large", message);
                return;
            }
        }
    }

    fn face(&mut self, tokens: &[&str], before: [usize; 3], material: u32, polygon: &mut Polygon) {
        if tokens.len() < 4 {
            let message =
                tr!("a face has {count} corners; it needs 3 or more", count = tokens.len() - 1);
            self.error(tokens[0], "mesh-syntax", message);
            return;
        }
        polygon.corners.clear();
        for token in &tokens[1..] {
            match self.corner(token, before) {
                Some(corner) => polygon.corners.push(corner),
                None => return,
            }
        }
        polygon.cut(&mut self.soup, material);
    }

    /// Reads `point`, `point/uv`, `point//normal` or `point/uv/normal`; `None` after an error.
    fn corner(&mut self, token: &str, before: [usize; 3]) -> Option<Corner> {
        let mut indices = [NONE; 3];
        let mut fields = token.split('/');
        let counts = [self.soup.points.len(), self.soup.uvs.len(), self.soup.normals.len()];
        for (slot, what) in
            [text!("vertex"), Text::new("UV"), text!("normal")].into_iter().enumerate()
        {
            let field = fields.next().unwrap_or("");
            if field.is_empty() && slot > 0 {
                continue;
            }
            let Ok(number) = field.parse::<i64>() else {
                let message =
                    tr!("`{token}` is not a corner: write vertex, vertex/uv or vertex/uv/normal");
                self.error(token, "mesh-syntax", message);
                return None;
            };
            let count = counts[slot];
            let index =
                if number < 0 { number.saturating_add(before[slot] as i64) } else { number - 1 };
            if number == 0 || index < 0 || index >= count as i64 {
                let message = tr!("{what} {number} is out of range: there are {count} in the file");
                self.error(token, "mesh-index", message);
                return None;
            }
            indices[slot] = index as u32;
        }
        let [point, uv, normal] = indices;
        Some(Corner { point, normal, uv })
    }
}
