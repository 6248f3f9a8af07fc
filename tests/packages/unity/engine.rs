//! Programs that run a package's texts in Unity's place: Mono for the component, slangc for the
//! shader.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::{Package, stand_ins};
use crate::support::validators::slangc;

/// Mono, with stand-ins for Unity's classes.
pub(super) struct Engine;

impl Engine {
    /// True if C# can be compiled and run.
    pub(super) fn is_here() -> bool {
        let runs = |program: &str| Command::new(program).arg("--version").output().is_ok();
        runs("mcs") && runs("mono")
    }

    /// The numbers that a package's component gives its material, by property. `main` are
    /// statements that make `look`, `camera` and `wearer` what they are.
    pub(super) fn numbers(package: &Package, main: &str) -> BTreeMap<String, Vec<f32>> {
        let folder = tempfile::tempdir().expect("a folder");
        let text = format!(
            "using System;\nusing System.Globalization;\nusing System.Reflection;\n\
             using UnityEngine;\nusing UnityEngine.Rendering;\n\
             static class Trial\n{{\nstatic void Main()\n{{\n\
             CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;\n\
             var wearer = new Renderer();\nvar camera = new Camera();\n\
             var look = new Chiaro.{} {{ renderer_ = wearer }};\n{main}\n\
             typeof(Chiaro.{}).GetMethod(\"OnEnable\", BindingFlags.NonPublic | \
             BindingFlags.Instance).Invoke(look, null);\n\
             RenderPipelineManager.Begin(camera);\n\
             foreach (var pair in wearer.sharedMaterials[0].Numbers)\n\
             Console.WriteLine(pair.Key + \" \" + string.Join(\" \", \
             Array.ConvertAll(pair.Value, x => x.ToString(\"R\"))));\n}}\n}}\n",
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
        let output = Command::new("mono").arg(folder.path().join("trial.exe")).output();
        let output = output.expect("mono starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {said}", package.class);
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        let line = |line: &str| {
            let mut words = line.split_whitespace();
            let name = words.next()?.to_owned();
            Some((name, words.filter_map(|word| word.parse().ok()).collect()))
        };
        told.lines().filter_map(line).collect()
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
