//! Animated PNGs, which every browser plays.

use std::io::{self, Write};

use chiaro_locale::tr;

use crate::FrameRate;
use crate::diag::Diagnostic;
use crate::frame::Picture;

/// Greatest length of a file, in bytes: it is made in memory.
const MAX_BYTES: usize = 1 << 30;

/// Bytes up to the greatest length.
struct BoundedBytes(Vec<u8>);

impl Write for BoundedBytes {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0.len() + bytes.len() > MAX_BYTES {
            return Err(io::Error::other(tr!("an animation of so many pixels is too large")));
        }
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// An animated PNG that plays for ever, of opaque pictures. Of each but the first one the rectangle
/// is stored that differs from the last.
///
/// # Errors
/// `png` with the reason: other sizes than the first picture's, another number of pictures than
/// `count`, a file that becomes too large; and the first error of the pictures.
pub fn animated(
    count: u32,
    rate: FrameRate,
    pictures: impl IntoIterator<Item = Result<Picture, Diagnostic>>,
) -> Result<Vec<u8>, Diagnostic> {
    let mut pictures = pictures.into_iter();
    let first =
        pictures.next().ok_or_else(|| problem(tr!("an animation has a picture at least")))??;
    let size = first.size;
    let mut bytes = BoundedBytes(Vec::new());
    let mut encoder = ::png::Encoder::new(&mut bytes, size[0], size[1]);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_animated(count, 0).map_err(|error| failed(&error))?;
    let [duration, of_second] = delay(rate);
    encoder.set_frame_delay(duration, of_second).map_err(|error| failed(&error))?;
    let mut writer = encoder.write_header().map_err(|error| failed(&error))?;
    let mut last = rgb8(&first);
    let mut written: u32 = 1;
    writer.write_image_data(&last).map_err(|error| failed(&error))?;
    for picture in pictures {
        let picture = picture?;
        if picture.size != size {
            return Err(problem(tr!("the pictures of an animation are of one size")));
        }
        let next = rgb8(&picture);
        let [left, top, width, height] = changed(&last, &next, size);
        let row = size[0] as usize * 3;
        let span = left as usize * 3..(left + width) as usize * 3;
        let rows = next.chunks_exact(row).skip(top as usize).take(height as usize);
        let cut: Vec<u8> = rows.flat_map(|row| row[span.clone()].iter().copied()).collect();
        // The corner comes first: no rectangle on the way may leave the picture.
        let placed = writer
            .set_frame_position(0, 0)
            .and_then(|()| writer.set_frame_dimension(width, height))
            .and_then(|()| writer.set_frame_position(left, top))
            .and_then(|()| writer.write_image_data(&cut));
        placed.map_err(|error| failed(&error))?;
        last = next;
        written += 1;
    }
    if written != count {
        return Err(problem(tr!("an animation has as many pictures as it says")));
    }
    writer.finish().map_err(|error| failed(&error))?;
    Ok(bytes.0)
}

/// The pixels of an opaque picture with eight bits a channel, without alpha.
pub fn rgb8(picture: &Picture) -> Vec<u8> {
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    picture.rgba.iter().flat_map(|[r, g, b, _]| [byte(*r), byte(*g), byte(*b)]).collect()
}

/// Seconds that a picture is shown, as a fraction of 16 bits.
fn delay(rate: FrameRate) -> [u16; 2] {
    match (u16::try_from(rate.seconds), u16::try_from(rate.frames)) {
        (Ok(seconds), Ok(frames)) => [seconds, frames],
        _ => {
            let milliseconds = 1000.0 * f64::from(rate.seconds) / f64::from(rate.frames.max(1));
            [milliseconds.round().clamp(1.0, 65_535.0) as u16, 1000]
        }
    }
}

/// The least rectangle of what differs: left, top, width and height; a pixel where nothing does.
fn changed(last: &[u8], next: &[u8], size: [u32; 2]) -> [u32; 4] {
    let row = size[0] as usize * 3;
    let [mut left, mut top, mut right, mut bottom] = [row, usize::MAX, 0, 0];
    for (y, (old, new)) in last.chunks_exact(row).zip(next.chunks_exact(row)).enumerate() {
        let differs = |(a, b): (&u8, &u8)| a != b;
        let Some(from) = old.iter().zip(new).position(differs) else { continue };
        let to = old.iter().zip(new).rposition(differs).unwrap_or(from);
        (left, right) = (left.min(from), right.max(to + 1));
        (top, bottom) = (top.min(y), y + 1);
    }
    if bottom == 0 {
        return [0, 0, 1, 1];
    }
    let (left, right) = (left / 3, right.div_ceil(3));
    [left, top, right - left, bottom - top].map(|side| side as u32)
}

fn failed(error: &::png::EncodingError) -> Diagnostic {
    problem(&error.to_string())
}

fn problem(message: &str) -> Diagnostic {
    Diagnostic::error("png", message)
        .hint(tr!("ask for fewer frames or smaller ones, with --frames or --width"))
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    fn picture(dot: u32) -> Picture {
        let at = |pixel: u32| if pixel == dot { [1.0; 4] } else { [0.2, 0.2, 0.2, 1.0] };
        Picture { size: [8, 4], rgba: (0..32).map(at).collect() }
    }

    #[test]
    fn an_animation_is_read_back_frame_by_frame() {
        let dots = [3, 3, 30, 9];
        let rate = "23.976".parse().unwrap();
        let bytes = animated(4, rate, dots.map(|dot| Ok(picture(dot)))).unwrap();
        let mut reader = ::png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        assert_eq!(reader.info().animation_control.unwrap().num_frames, 4);
        let mut shown = vec![0; 8 * 4 * 3];
        for dot in dots {
            let mut part = vec![0; 8 * 4 * 3];
            let info = reader.next_frame(&mut part).unwrap();
            let control = *reader.info().frame_control().unwrap();
            assert_eq!((control.delay_num, control.delay_den), (1001, 24_000));
            let width = info.width as usize * 3;
            for (row, pixels) in part.chunks_exact(width).take(info.height as usize).enumerate() {
                let at = ((control.y_offset as usize + row) * 8 + control.x_offset as usize) * 3;
                shown[at..at + width].copy_from_slice(pixels);
            }
            assert_eq!(shown, rgb8(&picture(dot)), "{dot}");
        }
    }

    #[test]
    fn pictures_that_are_no_animation_are_refused() {
        let rate = FrameRate::FILM;
        assert!(animated(0, rate, []).is_err());
        assert!(animated(2, rate, [Ok(picture(1))]).is_err(), "one is missing");
        let other = Picture { size: [4, 8], ..picture(0) };
        assert!(animated(2, rate, [Ok(picture(1)), Ok(other)]).is_err());
        let told = animated(2, rate, [Ok(picture(1)), Err(Diagnostic::error("gone", "gone"))]);
        assert_eq!(told.unwrap_err().code, "gone");
    }
}
