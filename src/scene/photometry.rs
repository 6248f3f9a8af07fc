//! Photometric files of lamps (IES LM-63), as pictures of the sphere around them.
//!
//! Such a file lists candela by two angles of type C: the vertical one from where the lamp points,
//! 0, to its back, 180 degrees, and the horizontal one around it. A picture of it has 256 rows from
//! the first to the last, and columns around, and holds the square root of each strength over the
//! greatest one, so that eight bits are fine where a lamp fades (docs/math.md 6.7).

use std::path::Path;

use chiaro_locale::tr;

use crate::diag::Diagnostic;

/// File ending of photometric files.
pub const LAMP_FILE: &str = "ies";

/// Rows of a picture: `nodes/light/lamp_sphere.wgsl` keeps half of one from either end.
const ROWS: u32 = 256;
/// Columns of a picture of a lamp that shines differently around.
const COLUMNS: u32 = 360;
/// Most angles of either kind; files have a few hundred at most.
const MOST_ANGLES: usize = 4096;

/// True for a photometric file, by its name.
pub fn is_lamp_file(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(LAMP_FILE))
}

/// Strengths of a lamp by direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Photometry {
    /// Angles from where the lamp points, in degrees, ascending.
    vertical: Vec<f64>,
    /// Angles around it, in degrees, ascending: one where all are equal, up to 90 or 180 where the
    /// others mirror these.
    horizontal: Vec<f64>,
    /// Candela, for each horizontal angle those of all vertical ones.
    candela: Vec<f64>,
    /// Greatest of them, above 0.
    greatest: f64,
}

/// Numbers of a photometric file, as they follow one another in its lines.
struct LampNumbers<'t> {
    words: Box<dyn Iterator<Item = (usize, &'t str)> + 't>,
    /// Line of the last word, from 1.
    line: usize,
}

impl<'t> LampNumbers<'t> {
    /// The numbers of lines from number `first`, from 0.
    fn new(text: &'t str, first: usize) -> Self {
        let words = text.lines().enumerate().skip(first).flat_map(|(line, text)| {
            text.split([' ', '\t', ',', '\r'])
                .filter(|word| !word.is_empty())
                .map(move |word| (line + 1, word))
        });
        Self { words: Box::new(words), line: first }
    }

    /// The next number.
    fn next(&mut self) -> Result<f64, Diagnostic> {
        let Some((line, word)) = self.words.next() else {
            return Err(problem(self.line, tr!("the file ends before its last number")));
        };
        self.line = line;
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| problem(line, &tr!("`{word}` is no number")))
    }

    /// The next number as a count, which says how many numbers follow.
    fn count(&mut self) -> Result<usize, Diagnostic> {
        let number = self.next()?;
        let count = number as usize;
        let is_count = number.fract() == 0.0 && (1..=MOST_ANGLES).contains(&count);
        let message =
            || tr!("{number} angles are announced; 1 to {most} can be", most = MOST_ANGLES);
        is_count.then_some(count).ok_or_else(|| problem(self.line, &message()))
    }

    /// Leaves numbers out.
    fn skip(&mut self, count: usize) -> Result<(), Diagnostic> {
        (0..count).try_for_each(|_| self.next().map(drop))
    }

    /// The next angles, which ascend.
    fn angles(&mut self, count: usize) -> Result<Vec<f64>, Diagnostic> {
        let mut angles: Vec<f64> = Vec::new();
        for _ in 0..count {
            let angle = self.next()?;
            if angles.last().is_some_and(|last| *last >= angle) {
                return Err(problem(self.line, &tr!("angles must grow, {angle} does not")));
            }
            angles.push(angle);
        }
        Ok(angles)
    }
}

impl Photometry {
    /// Reads a photometric file: its labels are skipped, and so is what it says of a tilted lamp.
    ///
    /// # Errors
    /// `photometry`, with the line: text that is none, angles of type A or B, angles that do not
    /// ascend, a negative strength, or a lamp that gives no light.
    pub fn read(text: &str) -> Result<Self, Diagnostic> {
        let is_tilt = |line: &str| line.trim_start().to_ascii_uppercase().starts_with("TILT=");
        let tilt = text.lines().enumerate().find(|(_, line)| is_tilt(line));
        let (line, tilt) = tilt.ok_or_else(|| problem(1, tr!("it has no line `TILT=`")))?;
        let mut numbers = LampNumbers::new(text, line + 1);
        if tilt.to_ascii_uppercase().contains("INCLUDE") {
            numbers.skip(1)?;
            let tilts = numbers.count()?;
            numbers.skip(2 * tilts)?;
        }
        // The number of lamps, lumens, and a factor of all strengths.
        numbers.skip(3)?;
        let rows = numbers.count()?;
        let columns = numbers.count()?;
        if numbers.next()? != 1.0 {
            let message = tr!("its angles are of type A or B");
            return Err(problem(numbers.line, message).hint(tr!("convert it to type C")));
        }
        // Units, width, length, height; ballast, a number for later use, watts.
        numbers.skip(7)?;
        let vertical = numbers.angles(rows)?;
        let horizontal = numbers.angles(columns)?;
        let mut candela = Vec::new();
        for _ in 0..rows * columns {
            let strength = numbers.next()?;
            if strength < 0.0 {
                return Err(problem(numbers.line, &tr!("the strength {strength} is negative")));
            }
            candela.push(strength);
        }
        let greatest = candela.iter().copied().fold(0.0, f64::max);
        match greatest > 0.0 {
            true => Ok(Self { vertical, horizontal, candela, greatest }),
            false => Err(problem(numbers.line, tr!("the lamp gives no light"))),
        }
    }

    /// The strength in a direction, in degrees, over the greatest one: linear between the angles of
    /// the file, and 0 above and below them.
    pub fn strength(&self, vertical: f64, horizontal: f64) -> f64 {
        let rows = self.vertical.len();
        if !(self.vertical[0]..=self.vertical[rows - 1]).contains(&vertical) {
            return 0.0;
        }
        let row = AnglePair::of(&self.vertical, vertical);
        let column = self.around(horizontal);
        let in_column = |column: usize| {
            let at = |row: usize| self.candela[column * rows + row];
            row.mixed(at)
        };
        column.mixed(in_column) / self.greatest
    }

    /// The columns of the file beside a horizontal angle, in degrees.
    fn around(&self, angle: f64) -> AnglePair {
        let count = self.horizontal.len();
        let (first, last) = (self.horizontal[0], self.horizontal[count - 1]);
        let angle = angle.rem_euclid(360.0);
        let on_one_side = if angle > 180.0 { 360.0 - angle } else { angle };
        let folded = match [first, last] {
            _ if count == 1 => first,
            [0.0, 90.0] if on_one_side > 90.0 => 180.0 - on_one_side,
            [0.0, 90.0 | 180.0] => on_one_side,
            [90.0, 270.0] if !(90.0..=270.0).contains(&angle) => (180.0 - angle).rem_euclid(360.0),
            _ => angle,
        };
        if (first..=last).contains(&folded) {
            return AnglePair::of(&self.horizontal, folded);
        }
        // From the last angle of the file around to its first.
        let gap = 360.0 - (last - first);
        let along = if gap > 0.0 { (folded - last).rem_euclid(360.0) / gap } else { 0.0 };
        AnglePair { indices: [count - 1, 0], along }
    }

    /// The picture of the sphere around the lamp, as PNG: gray, 256 rows.
    ///
    /// # Errors
    /// `png`: the reason why it cannot be encoded.
    pub fn to_png(&self) -> Result<Vec<u8>, Diagnostic> {
        let columns = if self.horizontal.len() == 1 { 1 } else { COLUMNS };
        let center = |index: u32, count: u32| (f64::from(index) + 0.5) / f64::from(count);
        let gray = |row: u32, column: u32| {
            let strength =
                self.strength(180.0 * center(row, ROWS), 360.0 * center(column, columns));
            (255.0 * strength.sqrt()).round() as u8
        };
        let pixels: Vec<u8> =
            (0..ROWS).flat_map(|row| (0..columns).map(move |column| gray(row, column))).collect();
        let mut bytes = Vec::new();
        let encoder = image::codecs::png::PngEncoder::new(&mut bytes);
        let kind = image::ExtendedColorType::L8;
        image::ImageEncoder::write_image(encoder, &pixels, columns, ROWS, kind).map_err(
            |error| Diagnostic::error("png", tr!("the picture cannot be encoded: {error}")),
        )?;
        Ok(bytes)
    }
}

/// Two neighbors in a list of angles, and how far an angle is from the first to the second.
struct AnglePair {
    indices: [usize; 2],
    along: f64,
}

impl AnglePair {
    /// The neighbors of an angle that lies within ascending ones.
    fn of(angles: &[f64], angle: f64) -> Self {
        let last = angles.len() - 1;
        let next = angles.partition_point(|it| *it <= angle).clamp(1, last.max(1)).min(last);
        let before = next.saturating_sub(1);
        let width = angles[next] - angles[before];
        let along = if width > 0.0 { (angle - angles[before]) / width } else { 0.0 };
        Self { indices: [before, next], along }
    }

    /// A mix of what is at both.
    fn mixed(&self, at: impl Fn(usize) -> f64) -> f64 {
        let [first, second] = self.indices.map(at);
        first + self.along * (second - first)
    }
}

fn problem(line: usize, message: &str) -> Diagnostic {
    Diagnostic::error("photometry", tr!("line {line}: {message}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file with a strength for each pair of angles.
    fn file(vertical: &[f64], horizontal: &[f64], strength: impl Fn(f64, f64) -> f64) -> String {
        let words = |numbers: &[f64]| {
            let words: Vec<_> = numbers.iter().map(f64::to_string).collect();
            words.join(" ")
        };
        let candela: Vec<_> = horizontal
            .iter()
            .map(|around| {
                words(&vertical.iter().map(|down| strength(*down, *around)).collect::<Vec<_>>())
            })
            .collect();
        format!(
            "IESNA:LM-63-2002\r\n[TEST] none\r\n[MANUFAC] TILT is no key\r\nTILT=NONE\r\n\
             1 1200, 1.0 {} {} 1 2 0 0 0\r\n1.0 1.0 14\r\n{}\r\n{}\r\n{}\r\n",
            vertical.len(),
            horizontal.len(),
            words(vertical),
            words(horizontal),
            candela.join("\r\n")
        )
    }

    #[test]
    fn a_round_lamp_shines_alike_around_and_ends_where_its_angles_end() {
        let text = file(&[0.0, 30.0, 90.0], &[0.0], |down, _| 200.0 - 2.0 * down);
        let lamp = Photometry::read(&text).unwrap();
        for around in [0.0, 77.0, 359.0] {
            for (down, wanted) in [(0.0, 1.0), (15.0, 0.85), (60.0, 0.4), (90.0, 0.1), (91.0, 0.0)]
            {
                let found = lamp.strength(down, around);
                assert!((found - wanted).abs() < 1e-12, "{down} {around}: {found}");
            }
        }
    }

    #[test]
    fn halves_and_quarters_are_mirrored() {
        let down = [0.0, 180.0];
        let cosine = |angle: f64| angle.to_radians().cos();
        // Mirrored by 0 and 180 degrees; by 90 and 270; by all four; by none.
        let cases: [(&[f64], [f64; 4]); 4] = [
            (&[0.0, 90.0, 180.0], [30.0, 30.0, 150.0, 150.0]),
            (&[90.0, 180.0, 270.0], [150.0, 210.0, 150.0, 210.0]),
            (&[0.0, 45.0, 90.0], [30.0, 30.0, 30.0, 30.0]),
            (&[0.0, 90.0, 180.0, 270.0], [30.0, 330.0, 150.0, 210.0]),
        ];
        for (angles, known) in cases {
            let lamp =
                Photometry::read(&file(&down, angles, |_, around| 2.0 + cosine(around))).unwrap();
            for (asked, known) in [30.0, 330.0, 150.0, 210.0].into_iter().zip(known) {
                let [found, wanted] = [asked, known].map(|around| lamp.strength(60.0, around));
                assert!((found - wanted).abs() < 1e-12, "{angles:?} at {asked}");
            }
        }
        // Without an angle of 360 degrees the last one leads to the first.
        let ring = file(&down, &[0.0, 90.0, 180.0, 270.0], |_, around| 1.0 + around / 90.0);
        let ring = Photometry::read(&ring).unwrap();
        assert!((ring.strength(0.0, 315.0) - 2.5 / 4.0).abs() < 1e-12);
    }

    #[test]
    fn a_picture_holds_roots_of_strengths_from_the_front_to_the_back() {
        let text = file(&[0.0, 90.0, 180.0], &[0.0, 90.0], |down, around| {
            (180.0 - down) * (1.0 + around / 90.0)
        });
        let lamp = Photometry::read(&text).unwrap();
        let picture = image::load_from_memory(&lamp.to_png().unwrap()).unwrap().into_luma8();
        assert_eq!(picture.dimensions(), (360, 256));
        for (column, row) in [(0, 0), (90, 0), (45, 128), (200, 200), (359, 255)] {
            let (down, around) = (f64::from(row) + 0.5, f64::from(column) + 0.5);
            let wanted = lamp.strength(down * 180.0 / 256.0, around);
            let root = f64::from(picture.get_pixel(column, row).0[0]) / 255.0;
            assert!((root - wanted.sqrt()).abs() < 0.5 / 255.0 + 1e-9, "{column} {row}");
        }
        let round = file(&[0.0, 90.0], &[0.0], |_, _| 5.0);
        let round = Photometry::read(&round).unwrap().to_png().unwrap();
        let picture = image::load_from_memory(&round).unwrap();
        assert_eq!((picture.width(), picture.height()), (1, 256));
    }

    #[test]
    fn a_tilted_lamp_is_read_beside_its_tilts() {
        let plain = file(&[0.0, 90.0], &[0.0], |down, _| 90.0 - down);
        let tilted = plain.replace("TILT=NONE", "TILT=INCLUDE\r\n1\r\n3\r\n0 45 90\r\n1 .9 .8");
        assert_eq!(Photometry::read(&tilted).unwrap(), Photometry::read(&plain).unwrap());
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        let good = file(&[0.0, 45.0, 90.0], &[0.0], |down, _| 90.0 - down);
        assert!(Photometry::read(&good).is_ok());
        let cases = [
            (String::new(), "line 1: it has no line `TILT=`"),
            (good.replace("1200,", "12x"), "line 5: `12x` is no number"),
            (good.replace("1.0 3 1 1 2", "1.0 3 1 2 2"), "line 5: its angles are of type A or B"),
            (
                good.replace("1.0 3 1 1 2", "1.0 3e9 1 1 2"),
                "line 5: 3000000000 angles are announced; 1 to 4096 can be",
            ),
            (good.replace("0 45 90", "0 95 90"), "line 7: angles must grow, 90 does not"),
            (good.replace("90 45 0", "90 -45 0"), "line 9: the strength -45 is negative"),
            (good.replace("90 45 0", "0 0 0"), "line 9: the lamp gives no light"),
            (good.replace("90 45 0", "90 45"), "line 9: the file ends before its last number"),
            (good.replace("90 45 0", "90 nan 0"), "line 9: `nan` is no number"),
        ];
        for (text, wanted) in cases {
            let found = Photometry::read(&text).unwrap_err();
            assert!(found.message.contains(wanted), "{} for {wanted}", found.message);
        }
    }
}
