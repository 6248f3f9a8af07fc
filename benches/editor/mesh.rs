//! Memory of the window with a large mesh, drawn on the present device. Software keeps what is on a
//! GPU in the memory of the process, too.

use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::process::Command;

use crate::editor_support::User;
use crate::example;

/// Argument that makes this program measure one mesh and print the result.
pub(crate) const CHILD: &str = "memory-of-mesh";
/// Size of the file where none is asked for, in MiB.
const USUAL: usize = 500;
/// Bytes that the file has for each vertex: three numbers of its place, three of its normal, two of
/// its UV, and two triangles of a count and three indices.
const VERTEX: usize = 8 * 4 + 2 * (1 + 3 * 4);

/// Memory of this process in MiB by a row of what the system tells; `None` if it does not tell.
fn memory(row: &str) -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(row))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()? / 1024.0)
}

/// Writes a sheet of waves as PLY, of about so many MiB, and returns its size in MiB.
fn write(path: &Path, mebibytes: usize) -> std::io::Result<f64> {
    let side = ((mebibytes << 20) / VERTEX).isqrt();
    let mut file = BufWriter::new(std::fs::File::create(path)?);
    write!(
        file,
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n\
         property float y\nproperty float z\nproperty float nx\nproperty float ny\n\
         property float nz\nproperty float s\nproperty float t\nelement face {}\n\
         property list uchar int vertex_indices\nend_header\n",
        side * side,
        2 * (side - 1) * (side - 1)
    )?;
    let share = |index: usize| index as f32 / (side - 1) as f32;
    for (row, column) in (0..side * side).map(|index| (index / side, index % side)) {
        let (u, v) = (share(column), share(row));
        let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
        let (waves, height) = (9.0_f32, 0.2_f32);
        let z = height * (waves * x).sin() * (waves * y).sin();
        let slope = [
            -height * waves * (waves * x).cos() * (waves * y).sin(),
            -height * waves * (waves * x).sin() * (waves * y).cos(),
        ];
        let length = (slope[0] * slope[0] + slope[1] * slope[1] + 1.0).sqrt();
        let numbers = [x, y, z, slope[0] / length, slope[1] / length, 1.0 / length, u, v];
        numbers.iter().try_for_each(|number| file.write_all(&number.to_le_bytes()))?;
    }
    let cells = (0..side - 1).flat_map(|row| (0..side - 1).map(move |column| (row, column)));
    for (row, column) in cells {
        let at = |row: usize, column: usize| (row * side + column) as u32;
        let [a, b] = [at(row, column), at(row, column + 1)];
        let [c, d] = [at(row + 1, column + 1), at(row + 1, column)];
        for triangle in [[a, b, c], [a, c, d]] {
            file.write_all(&[3])?;
            triangle.iter().try_for_each(|index| file.write_all(&index.to_le_bytes()))?;
        }
    }
    file.flush()?;
    Ok(std::fs::metadata(path)?.len() as f64 / f64::from(1 << 20))
}

/// Measures one mesh, in a process that did nothing else.
pub(crate) fn child(mebibytes: usize) {
    let folder = tempfile::tempdir().expect("a folder for the mesh");
    let path = folder.path().join("sheet.ply");
    let size = write(&path, mebibytes).expect("room for the mesh");
    let mut hand = User::drawing();
    hand.app_mut().open(&example("figure2-diffuse"));
    hand.settle();
    let tell = |row| memory(row).unwrap_or(f64::NAN);
    let empty = tell("VmRSS:");
    hand.app_mut().show_on(path.to_str().expect("a plain path"));
    hand.settle();
    hand.harness.run_steps(8);
    hand.settle();
    let [peak, resident] = ["VmHWM:", "VmRSS:"].map(tell);
    println!(
        "| {size:.0} | {empty:.0} | {resident:.0} = {:.2} | {peak:.0} = {:.2} |",
        resident / size,
        peak / size
    );
}

pub(crate) fn run() {
    println!("\nMemory of a window that draws a mesh, MiB, and in sizes of the mesh's file");
    println!("\n| file | another mesh | resident | peak |\n| ---: | ---: | ---: | ---: |");
    let asked: Vec<String> =
        std::env::args().filter(|text| text.parse::<usize>().is_ok()).collect();
    let sizes = if asked.is_empty() { vec![USUAL.to_string()] } else { asked };
    for size in sizes {
        let program = std::env::current_exe().expect("this program");
        let output = Command::new(program).args([CHILD, &size]).output().expect("it starts");
        print!("{}", String::from_utf8_lossy(&output.stdout));
    }
}
