//! Programs that run a package's texts in Unity's place: Mono for the component, slangc for the
//! shader.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::textures::{Texture, Textures};
use super::{Package, stand_ins};
use crate::support::validators::slangc;

/// Values that a component gives its material, by property.
#[derive(Clone, Debug, Default)]
pub(super) struct WornLook {
    pub(super) numbers: BTreeMap<String, Vec<f32>>,
    pub(super) textures: Textures,
}

impl WornLook {
    /// Side of triangles that is not drawn: what the property `_Cull` says, or the back.
    pub(super) fn left_out(&self) -> Option<wgpu::Face> {
        match self.numbers.get("_Cull").and_then(|numbers| numbers.first()) {
            Some(0.0) => None,
            Some(1.0) => Some(wgpu::Face::Front),
            _ => Some(wgpu::Face::Back),
        }
    }
}

/// Mono, with stand-ins for Unity's classes.
pub(super) struct Engine;

impl Engine {
    /// True if C# can be compiled and run.
    pub(super) fn is_here() -> bool {
        let runs = |program: &str| Command::new(program).arg("--version").output().is_ok();
        runs("mcs") && runs("mono")
    }

    /// Values that a package's component gives its material. `main` are statements that make
    /// `look`, `camera` and `wearer` what they are; fields that name files do so as in the editor.
    pub(super) fn worn(package: &Package, main: &str) -> WornLook {
        let folder = tempfile::tempdir().expect("a folder");
        let main = package.references() + main;
        let text = format!(
            "using System;\nusing System.Globalization;\nusing System.IO;\n\
             using System.Reflection;\nusing UnityEngine;\nusing UnityEngine.Rendering;\n\
             static class Trial\n{{\nstatic void Main()\n{{\n\
             CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;\n\
             var wearer = new Renderer();\nvar camera = new Camera();\n\
             var look = new Chiaro.{} {{ renderer_ = wearer }};\n{main}\n\
             typeof(Chiaro.{}).GetMethod(\"OnEnable\", BindingFlags.NonPublic | \
             BindingFlags.Instance).Invoke(look, null);\n\
             RenderPipelineManager.Begin(camera);\n\
             foreach (var pair in wearer.sharedMaterials[0].Numbers)\n\
             Console.WriteLine(pair.Key + \" \" + string.Join(\" \", \
             Array.ConvertAll(pair.Value, x => x.ToString(\"R\"))));\n\
             foreach (var pair in wearer.sharedMaterials[0].Textures)\n\
             Console.WriteLine(\"texture \" + pair.Key + \" \" + pair.Value.Told());\n}}\n}}\n",
            package.class, package.class
        );
        fs::write(folder.path().join("Trial.cs"), text).expect("a file");
        let output = Command::new("mcs")
            .args(["-nologo", "-langversion:7.2", "-warn:0", "-out:trial.exe", "Trial.cs"])
            .arg(stand_ins().join("UnityEngine.cs"))
            .arg(&package.component)
            .current_dir(folder.path())
            .output()
            .expect("mcs starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {said}", package.class);
        let output = Command::new("mono").arg("trial.exe").current_dir(folder.path()).output();
        let output = output.expect("mono starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {said}", package.class);
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        let mut worn = WornLook::default();
        for line in told.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                ["texture", name, "file", file] => {
                    let texture = Texture::imported(&package.folder.join(file));
                    worn.textures.insert((*name).to_owned(), texture);
                }
                ["texture", name, "layers", width, height, count, file] => {
                    let number = |word: &str| word.parse().expect("a number");
                    let texture = Texture {
                        size: [number(width), number(height)],
                        bytes: fs::read(folder.path().join(file)).expect("layers"),
                        layers: Some(number(count)),
                        is_decoded: false,
                        is_linear: true,
                        wrap: wgpu::AddressMode::MirrorRepeat,
                    };
                    worn.textures.insert((*name).to_owned(), texture);
                }
                [name, numbers @ ..] => {
                    let numbers = numbers.iter().filter_map(|word| word.parse().ok()).collect();
                    worn.numbers.insert((*name).to_owned(), numbers);
                }
                [] => {}
            }
        }
        worn
    }
}

/// A function of a shader's pass as WGSL, by slangc.
pub(super) fn wgsl(folder: &Path, text: &str, function: &str, stage: &str) -> String {
    let place = tempfile::tempdir().expect("a folder");
    let (file, out) = (place.path().join("pass.hlsl"), place.path().join("pass.wgsl"));
    fs::write(&file, text).expect("a file");
    let output = Command::new(slangc())
        .arg(&file)
        .args(["-target", "wgsl", "-entry", function, "-stage", stage])
        .args(["-warnings-disable", "30056", "-I"])
        .arg(stand_ins())
        .arg("-I")
        .arg(folder)
        .arg("-o")
        .arg(&out)
        .output()
        .expect("slangc starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{function}: {said}");
    fs::read_to_string(out).expect("WGSL")
}
