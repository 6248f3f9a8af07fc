//! Text on pictures: glyphs of the font that the window has, filled by the area that they cover.

use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, MetadataProvider as _};

use crate::frame::Picture;

/// Sign in place of what does not fit.
const CUT: char = '…';

/// Rows of a pixel that coverage is sampled in; along a row it is exact.
const ROWS: usize = 4;

/// Pieces of a curve.
const PIECES: usize = 8;

/// A typeface of one width a sign, at a height.
pub(crate) struct Typeface {
    font: FontRef<'static>,
    size: Size,
    /// Width of every sign, in pixels.
    advance: f32,
    /// Height of a line, in pixels.
    pub(crate) line: u32,
}

impl Typeface {
    /// The typeface at so many pixels; `None` if the font cannot be read.
    pub(crate) fn new(pixels: f32) -> Option<Self> {
        let font = FontRef::new(epaint_default_fonts::HACK_REGULAR).ok()?;
        let size = Size::new(pixels);
        let glyph = font.charmap().map('0')?;
        let advance = font.glyph_metrics(size, LocationRef::default()).advance_width(glyph)?;
        Some(Self { font, size, advance, line: (pixels * 1.4).ceil() as u32 })
    }

    /// Number of signs that so many pixels have room for.
    fn room(&self, width: u32) -> usize {
        (width as f32 / self.advance).floor() as usize
    }

    /// The text, cut where it is wider than so many pixels.
    pub(crate) fn fitted(&self, text: &str, width: u32) -> String {
        let room = self.room(width);
        if text.chars().count() <= room {
            return text.to_owned();
        }
        text.chars().take(room.saturating_sub(1)).chain((room > 0).then_some(CUT)).collect()
    }

    /// A name with its value, `NAME = VALUE`. Where it is wider than so many pixels the name loses
    /// its front, down to nothing, before the value is cut.
    pub(crate) fn fitted_value(&self, name: &str, value: &str, width: u32) -> String {
        let (room, length) = (self.room(width), name.chars().count());
        for equals in [" = ", "="] {
            let left = room.saturating_sub(equals.len() + value.chars().count());
            if length <= left {
                return format!("{name}{equals}{value}");
            }
            // One sign beside the one that stands for the rest.
            if left >= 2 {
                let end: String = name.chars().skip(length - (left - 1)).collect();
                return format!("{CUT}{end}{equals}{value}");
            }
        }
        self.fitted(value, width)
    }

    /// Draws a line of text whose upper left corner is at a pixel. What lies outside is left out.
    pub(crate) fn draw(&self, picture: &mut Picture, at: [u32; 2], text: &str, color: [f32; 3]) {
        // The line's height has room of 0.4 of the size above and below.
        let base = at[1] as f32 + self.line as f32 * 0.74;
        let outlines = self.font.outline_glyphs();
        let charmap = self.font.charmap();
        let mut edges = Edges::default();
        for (place, sign) in text.chars().enumerate() {
            let glyph = charmap.map(sign).and_then(|glyph| outlines.get(glyph));
            let Some(glyph) = glyph else { continue };
            edges.origin = [at[0] as f32 + place as f32 * self.advance, base];
            let settings = DrawSettings::unhinted(self.size, LocationRef::default());
            // A glyph that cannot be drawn is left out, as one that is not there.
            let _ = glyph.draw(settings, &mut edges);
        }
        edges.fill(picture, color);
    }
}

/// Straight edges of outlines, in pixels from the upper left.
#[derive(Default)]
struct Edges {
    lines: Vec<[[f32; 2]; 2]>,
    origin: [f32; 2],
    first: [f32; 2],
    last: [f32; 2],
}

impl Edges {
    fn place(&self, x: f32, y: f32) -> [f32; 2] {
        [self.origin[0] + x, self.origin[1] - y]
    }

    fn line(&mut self, to: [f32; 2]) {
        if self.last[1] != to[1] {
            self.lines.push([self.last, to]);
        }
        self.last = to;
    }

    /// Lays the color over the picture as far as each pixel is covered.
    fn fill(&self, picture: &mut Picture, color: [f32; 3]) {
        let [width, height] = picture.size.map(|side| side as usize);
        let heights = self.lines.iter().flatten().map(|[_, y]| *y);
        let (top, bottom) =
            heights.fold((f32::MAX, 0.0_f32), |(top, bottom), y| (top.min(y), bottom.max(y)));
        if top > bottom {
            return;
        }
        let rows = top.max(0.0) as usize..(bottom.ceil() as usize).min(height);
        let mut covered = vec![0.0_f32; width];
        for row in rows {
            covered.fill(0.0);
            for sample in 0..ROWS {
                let y = row as f32 + (sample as f32 + 0.5) / ROWS as f32;
                self.cover(y, &mut covered);
            }
            for (pixel, cover) in picture.rgba[row * width..].iter_mut().zip(&covered) {
                let cover = (cover / ROWS as f32).clamp(0.0, 1.0);
                for (slot, ink) in pixel.iter_mut().zip(color) {
                    *slot += (ink - *slot) * cover;
                }
            }
        }
    }

    /// Adds the shares of a row's pixels that lie inside at a height, by the rule of winding.
    fn cover(&self, y: f32, covered: &mut [f32]) {
        let crossings = self.lines.iter().filter_map(|[[x0, y0], [x1, y1]]| {
            let is_down = y0 < y1;
            let (low, high) = if is_down { (y0, y1) } else { (y1, y0) };
            let is_crossed = *low <= y && y < *high;
            is_crossed
                .then(|| (x0 + (x1 - x0) * (y - y0) / (y1 - y0), if is_down { 1 } else { -1 }))
        });
        let mut crossings: Vec<(f32, i32)> = crossings.collect();
        crossings.sort_unstable_by(|(a, _), (b, _)| a.total_cmp(b));
        let mut winding = 0;
        for pair in crossings.windows(2) {
            winding += pair[0].1;
            if winding == 0 {
                continue;
            }
            let right = covered.len() as f32;
            let (from, to) = (pair[0].0.clamp(0.0, right), pair[1].0.clamp(0.0, right));
            for (x, slot) in covered.iter_mut().enumerate().skip(from as usize) {
                let x = x as f32;
                if x >= to {
                    break;
                }
                *slot += (to.min(x + 1.0) - from.max(x)).max(0.0);
            }
        }
    }
}

impl OutlinePen for Edges {
    fn move_to(&mut self, x: f32, y: f32) {
        self.first = self.place(x, y);
        self.last = self.first;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.line(self.place(x, y));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        let (from, by, to) = (self.last, self.place(cx, cy), self.place(x, y));
        for piece in 1..=PIECES {
            let t = piece as f32 / PIECES as f32;
            let on = |a: f32, b: f32, c: f32| {
                (1.0 - t) * (1.0 - t) * a + 2.0 * (1.0 - t) * t * b + t * t * c
            };
            self.line([on(from[0], by[0], to[0]), on(from[1], by[1], to[1])]);
        }
    }

    /// The font has curves of the second degree alone.
    fn curve_to(&mut self, _: f32, _: f32, _: f32, _: f32, x: f32, y: f32) {
        self.line_to(x, y);
    }

    fn close(&mut self) {
        self.line(self.first);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(text: &str) -> Picture {
        let mut picture = Picture { size: [60, 20], rgba: vec![[0.0, 0.0, 0.0, 1.0]; 1200] };
        Typeface::new(14.0).unwrap().draw(&mut picture, [2, 0], text, [1.0; 3]);
        picture
    }

    fn ink(picture: &Picture) -> f32 {
        picture.rgba.iter().map(|pixel| pixel[0]).sum()
    }

    #[test]
    fn text_is_drawn_where_it_is_said() {
        let one = ink(&drawn("o"));
        assert!((15.0..60.0).contains(&one), "{one}");
        assert!((ink(&drawn("oo")) / one - 2.0).abs() < 0.05);
        assert_eq!(ink(&drawn("  ")), 0.0);
        // An o is open in its middle, and an I is not.
        let at = |picture: &Picture, x: u32, y: u32| picture.pixel(x, y)[0];
        let round = drawn("o");
        let middle = (4..9).map(|x| at(&round, x, 11)).fold(1.0, f32::min);
        assert!(middle < 0.1, "{middle}");
        assert!(ink(&drawn(&"w".repeat(40))) > 0.0, "what lies outside is left out");
    }

    #[test]
    fn long_text_is_cut() {
        let face = Typeface::new(14.0).unwrap();
        assert_eq!(face.fitted("abc", 200), "abc");
        let cut = face.fitted(&"x".repeat(90), 100);
        assert!(cut.ends_with(CUT) && cut.chars().count() as f32 * face.advance <= 100.0, "{cut}");
        assert_eq!(face.fitted("abc", 0), "");
    }

    #[test]
    fn names_are_cut_before_their_values() {
        let face = Typeface::new(15.0).unwrap();
        let fitted = |value: &str, signs: u32| {
            let width = (face.advance * signs as f32).ceil() as u32;
            face.fitted_value("moon.intensity", value, width)
        };
        assert_eq!(fitted("0.5", 20), "moon.intensity = 0.5");
        assert_eq!(fitted("0.5", 10), "…ity = 0.5");
        assert_eq!(fitted("0.8333", 10), "…ty=0.8333");
        assert_eq!(fitted("#88aaff", 8), "#88aaff");
        assert_eq!(fitted("#88aaff", 4), "#88…");
        assert_eq!(fitted("0.5", 0), "");
        assert_eq!(face.fitted_value("t", "0.25", 96), "t = 0.25");
    }
}
