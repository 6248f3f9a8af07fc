//! Contact sheets: pictures in rows, each with its labels below.

use std::fmt::{Display, Formatter};

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::document::{linear_to_srgb, srgb_to_linear};
use crate::frame::Picture;
use crate::label::Typeface;

/// Greatest number of pixels of a sheet, and of one of its sides.
const MAX_PIXELS: u64 = 200_000_000;
const MAX_SIDE: u64 = 32_768;

/// Size of the text, distance between pictures, and of text from its picture, in pixels.
const TEXT: f32 = 15.0;
const TITLE: f32 = 20.0;
const GAP: u32 = 16;
const NEAR: u32 = 6;

/// Colors as shown: the paper, the labels and the title.
const PAPER: [f32; 4] = [0.11, 0.11, 0.12, 1.0];
const INK: [f32; 3] = [0.82, 0.82, 0.84];
const TITLE_INK: [f32; 3] = [1.0, 1.0, 1.0];

/// A picture of a sheet.
#[derive(Clone, Debug)]
pub struct SheetCell {
    /// The picture, small: see [`scaled`]. Opaque.
    pub picture: Picture,
    /// Lines below it.
    pub labels: Vec<SheetLabel>,
}

/// Line below a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SheetLabel {
    /// A text, whose end is cut where it is too long.
    Text(String),
    /// A name and its value, of which the value stays whole.
    Value(String, String),
}

impl SheetLabel {
    fn fitted(&self, face: &Typeface, width: u32) -> String {
        match self {
            Self::Text(text) => face.fitted(text, width),
            Self::Value(name, value) => face.fitted_value(name, value, width),
        }
    }
}

impl Display for SheetLabel {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Text(text) => f.write_str(text),
            Self::Value(name, value) => write!(f, "{name} = {value}"),
        }
    }
}

/// Number of columns of a sheet of so many pictures, so that it is somewhat wider than high.
pub fn columns_for(cells: usize, size: [u32; 2]) -> usize {
    let [width, height] = size.map(|side| f64::from(side.max(1)));
    let columns = (cells as f64 * 1.5 * height / width).sqrt().round() as usize;
    columns.clamp(1, cells.max(1))
}

/// Draws a sheet of a title and cells, row by row.
///
/// # Errors
/// `too-many-cells` where the sheet would be too large.
pub fn draw(title: &str, cells: &[SheetCell], columns: usize) -> Result<Picture, Diagnostic> {
    Ok(draw_with_places(title, cells, columns)?.0)
}

/// Sheet of a title and cells, with the place of each cell's picture on it: left and upper edge,
/// width and height, in pixels.
///
/// # Errors
/// As [`draw`].
pub fn draw_with_places(
    title: &str,
    cells: &[SheetCell],
    columns: usize,
) -> Result<(Picture, Vec<[u32; 4]>), Diagnostic> {
    let no_font = || Diagnostic::error("no-font", tr!("the font of labels cannot be read"));
    let (text, heading) = Typeface::new(TEXT).zip(Typeface::new(TITLE)).ok_or_else(no_font)?;
    let columns = columns.clamp(1, cells.len().max(1));
    let side = |at: usize| cells.iter().map(|cell| cell.picture.size[at]).max().unwrap_or(0);
    let lines = cells.iter().map(|cell| cell.labels.len()).max().unwrap_or(0) as u32;
    let labels = if lines > 0 { NEAR + lines * text.line } else { 0 };
    let cell = [side(0), side(1) + labels];
    let top = if title.is_empty() { GAP } else { GAP + heading.line + NEAR };
    let rows = cells.len().div_ceil(columns);
    let along = |count: usize, length: u32| count as u64 * u64::from(length + GAP);
    let size = [along(columns, cell[0]) + u64::from(GAP), along(rows, cell[1]) + u64::from(top)];
    if size.iter().any(|side| *side > MAX_SIDE) || size[0] * size[1] > MAX_PIXELS {
        let [width, height] = size;
        let message = tr!("the sheet would be {width}x{height} pixels, which is too large");
        return Err(Diagnostic::error("too-many-cells", message)
            .hint(tr!("ask for fewer or for smaller pictures, with --cells or --width")));
    }
    let size = size.map(|side| side as u32);
    let mut sheet = Picture { size, rgba: vec![PAPER; size[0] as usize * size[1] as usize] };
    let fitted = heading.fitted(title, size[0] - 2 * GAP);
    heading.draw(&mut sheet, [GAP, GAP / 2], &fitted, TITLE_INK);
    let mut places = Vec::with_capacity(cells.len());
    for (at, SheetCell { picture, labels }) in cells.iter().enumerate() {
        let x = GAP + (at % columns) as u32 * (cell[0] + GAP);
        let y = top + (at / columns) as u32 * (cell[1] + GAP);
        lay(&mut sheet, picture, [x, y]);
        places.push([x, y, picture.size[0], picture.size[1]]);
        for (line, label) in labels.iter().enumerate() {
            let y = y + picture.size[1] + NEAR + line as u32 * text.line;
            text.draw(&mut sheet, [x, y], &label.fitted(&text, cell[0]), INK);
        }
    }
    Ok((sheet, places))
}

/// Lays a picture that fits over another one.
fn lay(sheet: &mut Picture, picture: &Picture, [x, y]: [u32; 2]) {
    let width = sheet.size[0] as usize;
    let rows = picture.rgba.chunks_exact(picture.size[0].max(1) as usize);
    for (row, pixels) in rows.enumerate() {
        let at = (y as usize + row) * width + x as usize;
        sheet.rgba[at..at + pixels.len()].copy_from_slice(pixels);
    }
}

/// An opaque picture at most so many pixels wide: each pixel is the mean light of what it covers.
pub fn scaled(picture: &Picture, width: u32) -> Picture {
    let [from_width, from_height] = picture.size;
    if from_width <= width.max(1) {
        return picture.clone();
    }
    let width = width.max(1);
    let ratio = f64::from(from_width) / f64::from(width);
    let height = ((f64::from(from_height) / ratio).round() as u32).max(1);
    let across = shares(from_width, width);
    let down = shares(from_height, height);
    let light = |pixel: &[f32; 4]| [0, 1, 2].map(|at| srgb_to_linear(f64::from(pixel[at])));
    // First along the rows, then down the columns.
    let mut narrow = Vec::with_capacity(width as usize * from_height as usize);
    for row in picture.rgba.chunks_exact(from_width as usize) {
        let row: Vec<[f64; 3]> = row.iter().map(light).collect();
        narrow.extend(across.iter().map(|(first, shares)| {
            let mut sum = [0.0; 3];
            for (pixel, share) in row[*first..].iter().zip(shares) {
                sum.iter_mut().zip(pixel).for_each(|(sum, light)| *sum += share * light);
            }
            sum
        }));
    }
    let mut rgba = Vec::with_capacity(width as usize * height as usize);
    for (first, shares) in &down {
        for x in 0..width as usize {
            let mut sum = [0.0; 3];
            for (row, share) in shares.iter().enumerate() {
                let pixel = narrow[(first + row) * width as usize + x];
                sum.iter_mut().zip(pixel).for_each(|(sum, light)| *sum += share * light);
            }
            let [r, g, b] = sum.map(|light| linear_to_srgb(light) as f32);
            rgba.push([r, g, b, 1.0]);
        }
    }
    Picture { size: [width, height], rgba }
}

/// For each new pixel of a row the first old one that it covers, and the share of each; shares sum
/// to 1.
fn shares(from: u32, to: u32) -> Vec<(usize, Vec<f64>)> {
    let ratio = f64::from(from) / f64::from(to);
    let of = |at: u32| {
        let (begin, end) = (f64::from(at) * ratio, f64::from(at + 1) * ratio);
        let (first, last) = (begin.floor() as u32, (end.ceil() as u32).min(from));
        let covered =
            |pixel: u32| (end.min(f64::from(pixel + 1)) - begin.max(f64::from(pixel))).max(0.0);
        let shares: Vec<f64> = (first..last).map(covered).collect();
        let sum: f64 = shares.iter().sum();
        (first as usize, shares.iter().map(|share| share / sum).collect())
    };
    (0..to).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(size: [u32; 2], gray: f32) -> Picture {
        let pixel = [gray, gray, gray, 1.0];
        Picture { size, rgba: vec![pixel; (size[0] * size[1]) as usize] }
    }

    #[test]
    fn smaller_pictures_keep_their_light() {
        let small = scaled(&flat([37, 21], 0.6), 10);
        assert_eq!(small.size, [10, 6]);
        assert!(small.rgba.iter().all(|pixel| (pixel[0] - 0.6).abs() < 1e-5));
        let mut half = flat([2, 2], 0.0);
        half.rgba[0] = [1.0; 4];
        half.rgba[3] = [1.0; 4];
        let one = scaled(&half, 1).rgba[0][0];
        assert!((f64::from(one) - linear_to_srgb(0.5)).abs() < 1e-5, "{one}");
        assert_eq!(scaled(&half, 8), half);
    }

    #[test]
    fn cells_stand_in_rows_with_their_labels() {
        let cell = |gray, label: &str| SheetCell {
            picture: flat([40, 30], gray),
            labels: [label, "2"].map(|text| SheetLabel::Text(text.to_owned())).to_vec(),
        };
        let cells = [cell(0.9, "first"), cell(0.5, "second"), cell(0.7, "third")];
        let (sheet, places) = draw_with_places("title", &cells, 2).unwrap();
        assert_eq!(sheet.size[0], 2 * 56 + 16);
        let grays: Vec<f32> = [(16, 0), (72, 0), (16, 1)]
            .into_iter()
            .map(|(x, row)| {
                let top = sheet.size[1] - 2 * (30 + NEAR + 2 * 21 + GAP);
                sheet.pixel(x + 1, top + row * (30 + NEAR + 2 * 21 + GAP) + 1)[0]
            })
            .collect();
        assert_eq!(grays, [0.9, 0.5, 0.7]);
        for ([x, y, width, height], gray) in places.iter().zip(&grays) {
            let corners = [sheet.pixel(*x, *y), sheet.pixel(x + width - 1, y + height - 1)];
            assert!(corners.iter().all(|pixel| pixel[0] == *gray));
        }
        let many: Vec<SheetCell> =
            (0..600).map(|_| SheetCell { picture: flat([900, 1], 0.0), labels: vec![] }).collect();
        assert_eq!(draw("", &many, 600).unwrap_err().code, "too-many-cells");
        assert_eq!(columns_for(12, [300, 200]), 3);
        assert_eq!((columns_for(1, [1, 1]), columns_for(0, [0, 0])), (1, 1));
    }
}
