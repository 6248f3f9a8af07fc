//! Choices of frames and of farms' jobs, and the command lines that they are.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use chiaro_locale::{Text, text, tr};

use super::{CommandLine, PickedOutput, Variation};
use crate::film::farm::{DEFAULT_CHUNK, Farm};
use crate::film::{Contributions, FrameList, FramePattern, FrameRate, MatteKind};
use crate::ids::make_slug;
use crate::state::display::DisplayChoice;
use crate::state::paths::tidy;

/// Layers that an option of the command line asks for by a word.
pub(crate) struct LayerOption {
    /// Word of the command line.
    pub(crate) word: &'static str,
    /// Label in the window.
    pub(crate) label: Text,
    /// Content of the layers.
    pub(crate) help: Text,
}

const fn option(word: &'static str, label: Text, help: Text) -> LayerOption {
    LayerOption { word, label, help }
}

/// Values of `--aov` for parts of the picture.
pub(crate) const CONTRIBUTIONS: [LayerOption; 7] = [
    option("layers", text!("Layers"), text!("What each layer of the looks adds to the picture")),
    option(
        "lights",
        text!("Lights"),
        text!("What each light adds: graded by itself in the compositor"),
    ),
    option("groups", text!("Groups"), text!("What each group of lights adds")),
    option(
        "lights-by-layer",
        text!("Lights by layer"),
        text!("What each light adds within each layer"),
    ),
    option(
        "groups-by-layer",
        text!("Groups by layer"),
        text!("What each group of lights adds within each layer"),
    ),
    option("shadows", text!("Shadows"), text!("The shadows of each light")),
    option("named", text!("Named passes"), text!("All outputs that looks name as passes")),
];

/// Values of `--matte`.
pub(crate) const MATTES: [LayerOption; 4] = [
    option("objects", text!("Objects"), text!("A Cryptomatte of the objects")),
    option("looks", text!("Looks"), text!("A Cryptomatte of the looks")),
    option("materials", text!("Materials"), text!("A Cryptomatte of the materials")),
    option("lights", text!("Lights"), text!("A Cryptomatte of the light that is strongest")),
];

/// Document that is rendered: a file, as it is on the disk.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FilmDocument {
    /// The file of the shot, the scene or the look.
    pub(crate) path: PathBuf,
    /// Frames of the document: the shot's, or those of the scene's time.
    pub(crate) frames: [i32; 2],
    /// Frames a second, where the command line is to be told.
    pub(crate) rate: Option<FrameRate>,
    /// Width and height in pixels, where the document says them.
    pub(crate) size: Option<[u32; 2]>,
    /// Mesh that a look alone is shown on, and true if its z axis points up.
    pub(crate) mesh: Option<(String, bool)>,
    /// True for a shot, whose frames need not be said.
    pub(crate) is_shot: bool,
    /// Greatest number of frames of a farm's task, which a shot says.
    pub(crate) chunk: Option<u32>,
}

impl FilmDocument {
    /// The folder of the document, in which commands are called.
    pub(crate) fn folder(&self) -> PathBuf {
        let folder = std::path::absolute(&self.path).unwrap_or_else(|_| self.path.clone());
        folder.parent().map(Path::to_path_buf).unwrap_or_default()
    }

    /// Folder in which a farm's tasks run: the nearest one that has the document and the files
    /// that pictures of it are drawn of, so that machines need that folder alone.
    pub(crate) fn job_folder(&self, files: &[PathBuf]) -> PathBuf {
        let (own, files) = (tidy(&self.folder()), files.iter().map(|file| tidy(file)));
        let files: Vec<PathBuf> = files.collect();
        let holds_all = |folder: &&Path| files.iter().all(|file| file.starts_with(folder));
        // What lies all over a disk has no folder of its own.
        let found = own.ancestors().find(holds_all).filter(|folder| folder.parent().is_some());
        found.map_or_else(|| own.clone(), Path::to_path_buf)
    }

    /// Name of the document's file.
    pub(crate) fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Name of the document's file, without ending.
    pub(crate) fn stem(&self) -> String {
        self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    fn mesh_words(&self, words: &mut Vec<String>) {
        let Some((mesh, is_up)) = &self.mesh else { return };
        words.extend(["--mesh".to_owned(), mesh.clone()]);
        words.extend(is_up.then(|| "--z-up".to_owned()));
    }
}

/// Numbers of an EXR.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum SampleDepth {
    /// 16 bits.
    #[default]
    Half,
    /// 32 bits.
    Float,
}

/// Choices of frames that are rendered.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FrameChoices {
    /// First and last frame; `None` for those of the document.
    pub(crate) frames: Option<[i32; 2]>,
    /// Distance from one frame to the next, 1 for all.
    pub(crate) step: u32,
    /// Folder of the frames, from the document's.
    pub(crate) folder: String,
    /// Name of the files, with the place of the number.
    pub(crate) name: String,
    /// Width and height in pixels; `None` for those of the document.
    pub(crate) size: Option<[u32; 2]>,
    /// Words of `--aov`.
    pub(crate) aovs: BTreeSet<String>,
    /// Outputs of nodes that are layers.
    pub(crate) outputs: Vec<PickedOutput>,
    /// Words of `--matte`.
    pub(crate) mattes: BTreeSet<&'static str>,
    /// Names of the layers.
    pub(crate) naming: &'static str,
    pub(crate) depth: SampleDepth,
    /// True if PNGs are shown by the view of the window.
    pub(crate) has_view: bool,
}

impl Default for FrameChoices {
    fn default() -> Self {
        Self {
            frames: None,
            step: 1,
            folder: "out".to_owned(),
            name: "####.exr".to_owned(),
            size: None,
            aovs: BTreeSet::new(),
            outputs: Vec::new(),
            mattes: BTreeSet::new(),
            naming: "nuke",
            depth: SampleDepth::Half,
            has_view: true,
        }
    }
}

/// Choices of a farm's job.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FarmChoices {
    /// Word of the farm.
    pub(crate) to: &'static str,
    /// Greatest number of frames of a task.
    pub(crate) chunk: u32,
}

impl Default for FarmChoices {
    fn default() -> Self {
        Self { to: "slurm", chunk: DEFAULT_CHUNK }
    }
}

impl FarmChoices {
    /// Choices for the farm of a word, where there is one of that name.
    pub(crate) fn of(farm: Option<&str>, chunk: u32) -> Self {
        let to = farm.and_then(Farm::named).map_or(Self::default().to, |farm| farm.word);
        Self { to, chunk }
    }

    /// Name of the job's file.
    pub(crate) fn job(&self, stem: &str) -> String {
        let ending = match self.to {
            "slurm" => "sh",
            "opencue" => "xml",
            "flamenco" => "js",
            _ => "job.json",
        };
        format!("{stem}.{ending}")
    }
}

/// A name from the folder of a document as one from the folder that `way` leads there from.
fn from(way: &Path, name: &str) -> String {
    match way.as_os_str().is_empty() {
        true => name.to_owned(),
        false => tidy(&way.join(name)).to_string_lossy().into_owned(),
    }
}

impl FrameChoices {
    /// Choices of a document that has none yet: as those of another one, but for what is of the
    /// document. Its frames have a folder of their own, so that no other's are written over.
    pub(crate) fn of(document: &FilmDocument, other: &Self) -> Self {
        Self {
            frames: None,
            size: None,
            outputs: Vec::new(),
            folder: format!("out/{}", document.stem()),
            ..other.clone()
        }
    }

    /// Makes an output of a node a layer, under a name of its own.
    pub(crate) fn pick(&mut self, output: &str) {
        if self.outputs.iter().any(|picked| picked.output == output) {
            return;
        }
        let path = output.rsplit_once(':').map_or(output, |(_, path)| path);
        let own = path.rsplit_once('/').map_or(path, |(_, own)| own);
        let name = make_slug(own, |name| self.outputs.iter().any(|picked| picked.name == name));
        self.outputs.push(PickedOutput { name, output: output.to_owned() });
    }

    /// True if the files are PNGs, which have no layers.
    pub(crate) fn is_png(&self) -> bool {
        Path::new(&self.name).extension().is_some_and(|end| end.eq_ignore_ascii_case("png"))
    }

    /// Gives the files another ending.
    pub(crate) fn set_ending(&mut self, ending: &str) {
        let name = Path::new(&self.name).with_extension(ending);
        self.name = name.to_string_lossy().into_owned();
    }

    /// Path of the files with the place of the number, from the document's folder.
    pub(crate) fn output(&self) -> String {
        let folder = self.folder.trim();
        match folder {
            "" | "." => self.name.clone(),
            folder => Path::new(folder).join(&self.name).to_string_lossy().into_owned(),
        }
    }

    /// Folder of the frames, outright.
    pub(crate) fn folder_of(&self, document: &FilmDocument) -> PathBuf {
        document.folder().join(self.folder.trim())
    }

    /// First and last frame.
    pub(crate) fn range(&self, document: &FilmDocument) -> [i32; 2] {
        self.frames.unwrap_or(document.frames)
    }

    /// The frames that are asked for.
    ///
    /// # Errors
    /// The reason, as a sentence, where they are none or too many.
    pub(crate) fn list(&self, document: &FilmDocument) -> Result<FrameList, String> {
        let [first, last] = self.range(document);
        let step = self.step.max(1);
        let text = match step {
            1 => format!("{first}-{last}"),
            step => format!("{first}-{last}x{step}"),
        };
        text.parse()
    }

    /// The frames that are asked for, each with its file from the document's folder.
    ///
    /// # Errors
    /// The reason, as a sentence, where the choices cannot be rendered.
    pub(crate) fn files(&self, document: &FilmDocument) -> Result<Vec<(i32, String)>, String> {
        let (pattern, list) = self.pattern_and_list(document)?;
        let file = |frame: &i32| (*frame, pattern.path(*frame).display().to_string());
        Ok(list.frames().iter().map(file).collect())
    }

    fn pattern_and_list(
        &self,
        document: &FilmDocument,
    ) -> Result<(FramePattern, FrameList), String> {
        let pattern = FramePattern::of(Path::new(&self.output()))?;
        let pattern =
            pattern.ok_or(tr!("let #### stand for the number in the name of the files"))?;
        Ok((pattern, self.list(document)?))
    }

    /// The command line that renders the frames.
    ///
    /// # Errors
    /// The reason, as a sentence, where the choices cannot be rendered.
    pub(crate) fn render(
        &self,
        document: &FilmDocument,
        view: Option<&DisplayChoice>,
    ) -> Result<CommandLine, String> {
        self.pattern_and_list(document)?;
        let mut words = vec!["render".to_owned()];
        self.words((document, Path::new("")), view, &mut words);
        Ok(CommandLine { folder: document.folder(), words })
    }

    /// The command line that writes a farm's job.
    ///
    /// # Errors
    /// The reason, as a sentence, where the choices cannot be rendered.
    pub(crate) fn job(
        &self,
        document: &FilmDocument,
        view: Option<&DisplayChoice>,
        (farm, files): (&FarmChoices, &[PathBuf]),
    ) -> Result<CommandLine, String> {
        self.pattern_and_list(document)?;
        let folder = document.job_folder(files);
        let own = tidy(&document.folder());
        let way = own.strip_prefix(&folder).unwrap_or(Path::new("")).to_path_buf();
        let mut words = vec!["farm".to_owned()];
        self.words((document, &way), view, &mut words);
        words.extend(["--to".to_owned(), farm.to.to_owned()]);
        words.extend(["--chunk".to_owned(), farm.chunk.to_string()]);
        words.extend(["--job".to_owned(), from(&way, &farm.job(&document.stem()))]);
        Ok(CommandLine { folder, words })
    }

    /// Adds the words that `render` and `farm` share; `way` leads from the folder of the command to
    /// that of the document.
    fn words(
        &self,
        (document, way): (&FilmDocument, &Path),
        view: Option<&DisplayChoice>,
        words: &mut Vec<String>,
    ) {
        words.extend([from(way, &document.name()), "-o".to_owned(), from(way, &self.output())]);
        // A shot knows its own frames.
        let is_whole =
            document.is_shot && self.step <= 1 && self.range(document) == document.frames;
        let list = self.list(document).ok().filter(|_| !is_whole);
        words.extend(list.map(|list| frames_word(&list.to_string())).into_iter().flatten());
        if let Some(rate) = document.rate {
            push(words, "--rate", rate.to_string());
        }
        if let Some([width, height]) = self.size.filter(|size| Some(*size) != document.size) {
            push(words, "--size", format!("{width}x{height}"));
        }
        match self.is_png() {
            true => {
                if let Some(view) = view.filter(|_| self.has_view) {
                    push(words, "--ocio", view.config.clone());
                    push(words, "--display", view.display.clone());
                    push(words, "--view", view.view.clone());
                }
            }
            false => self.layer_words(words),
        }
        document.mesh_words(words);
    }

    /// Adds the words for layers, mattes and the numbers of an EXR.
    fn layer_words(&self, words: &mut Vec<String>) {
        let outputs = self.outputs.iter().map(PickedOutput::word);
        let aovs: Vec<String> = self.aovs.iter().cloned().chain(outputs).collect();
        let is_parted = aovs.iter().any(|aov| Contributions::all().any(|(it, _)| it == aov));
        aovs.into_iter().for_each(|aov| push(words, "--aov", aov));
        let mattes = MatteKind::all().map(|(word, _)| word);
        let mattes: Vec<&str> = mattes.filter(|word| self.mattes.contains(word)).collect();
        if !mattes.is_empty() {
            push(words, "--matte", mattes.join(","));
        }
        if is_parted && self.naming != "nuke" {
            push(words, "--naming", self.naming.to_owned());
        }
        if self.depth == SampleDepth::Float {
            push(words, "--depth", "float".to_owned());
        }
    }
}

fn push(words: &mut Vec<String>, option: &str, value: String) {
    words.extend([option.to_owned(), value]);
}

/// The words for frames: a value that begins with a sign is joined to its option.
fn frames_word(list: &str) -> Vec<String> {
    match list.starts_with('-') {
        true => vec![format!("--frames={list}")],
        false => vec!["--frames".to_owned(), list.to_owned()],
    }
}

impl FilmDocument {
    /// The command line that draws a wedge; `sheet` is its PNG from the document's folder, `frame`
    /// the frame that is drawn.
    pub(crate) fn wedge(
        &self,
        varied: &[Variation],
        sheet: &str,
        size: [u32; 2],
        frame: Option<i32>,
    ) -> CommandLine {
        let mut words = vec!["wedge".to_owned(), self.name(), "-o".to_owned(), sheet.to_owned()];
        for varied in varied {
            words.extend(["--vary".to_owned(), varied.word()]);
        }
        let [width, height] = size;
        words.extend(["--size".to_owned(), format!("{width}x{height}")]);
        words.extend(frame.map(|frame| format!("--frames={frame}")));
        words.extend(self.rate.map(|rate| format!("--rate={rate}")));
        self.mesh_words(&mut words);
        CommandLine { folder: self.folder(), words }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shot() -> FilmDocument {
        FilmDocument {
            path: PathBuf::from("/films/sh010.json"),
            frames: [1, 48],
            rate: None,
            size: Some([1920, 1080]),
            mesh: None,
            is_shot: true,
            chunk: None,
        }
    }

    #[test]
    fn choices_are_a_command_line() {
        let mut choices = FrameChoices::default();
        let text = |choices: &FrameChoices| choices.render(&shot(), None).unwrap().text();
        assert_eq!(text(&choices), "chiaro render sh010.json -o 'out/####.exr'");
        choices.frames = Some([1, 24]);
        choices.step = 2;
        choices.size = Some([480, 270]);
        choices.aovs.insert("lights".to_owned());
        choices.pick("toon:face/outline.line");
        choices.pick("outline.line");
        choices.pick("outline.line");
        choices.mattes.extend(["looks", "objects"]);
        choices.naming = "blender";
        choices.depth = SampleDepth::Float;
        assert_eq!(
            text(&choices),
            "chiaro render sh010.json -o 'out/####.exr' --frames 1-23x2 --size 480x270 \
             --aov lights --aov outline_line=toon:face/outline.line \
             --aov outline_line_2=outline.line --matte objects,looks --naming blender \
             --depth float"
        );
        choices.set_ending("png");
        let view = DisplayChoice {
            config: "studio".to_owned(),
            display: "sRGB".to_owned(),
            view: "ACES 2.0".to_owned(),
        };
        let told = choices.render(&shot(), Some(&view)).unwrap().text();
        assert!(told.ends_with("--ocio studio --display sRGB --view 'ACES 2.0'"), "{told}");
        assert!(!told.contains("--aov") && !told.contains("--matte"), "{told}");
    }

    #[test]
    fn a_document_keeps_its_frames_apart() {
        let mut choices = FrameChoices { frames: Some([1, 24]), ..FrameChoices::default() };
        choices.mattes.insert("looks");
        choices.pick("outline.line");
        let own = FrameChoices::of(&shot(), &choices);
        let told = own.render(&shot(), None).unwrap().text();
        assert_eq!(told, "chiaro render sh010.json -o 'out/sh010/####.exr' --matte looks");
    }

    #[test]
    fn frames_have_their_files_and_what_is_wrong_is_said() {
        let mut choices = FrameChoices { frames: Some([-1, 1]), ..FrameChoices::default() };
        let files = choices.files(&shot()).unwrap();
        assert_eq!(files.len(), 3);
        assert_eq!(files[2], (1, "out/0001.exr".to_owned()));
        let words = choices.render(&shot(), None).unwrap().words;
        assert!(words.contains(&"--frames=-1-1".to_owned()), "{words:?}");
        choices.name = "frame.exr".to_owned();
        assert!(choices.render(&shot(), None).unwrap_err().contains("####"));
        choices = FrameChoices { frames: Some([9, 1]), ..FrameChoices::default() };
        assert!(choices.render(&shot(), None).is_err());
    }

    #[test]
    fn jobs_and_wedges_are_command_lines_too() {
        let choices = FrameChoices::default();
        assert_eq!(FarmChoices::of(Some("another"), 10), FarmChoices::default());
        let farm = FarmChoices::of(Some("openjd"), 5);
        assert_eq!(
            choices.job(&shot(), None, (&farm, &[])).unwrap().text(),
            "chiaro farm sh010.json -o 'out/####.exr' --to openjd --chunk 5 --job sh010.job.json"
        );
        // Tasks run where all files are, as in a film whose shots have a folder of their own.
        let in_film = FilmDocument { path: "/film/shots/sh010.json".into(), ..shot() };
        let files = ["/film/shots/sh010.json", "/film/shots/../scenes/room.json"];
        let files = files.map(PathBuf::from);
        let line = choices.job(&in_film, None, (&farm, &files)).unwrap();
        assert_eq!(line.folder, Path::new("/film"));
        assert_eq!(
            line.text(),
            "chiaro farm shots/sh010.json -o 'shots/out/####.exr' --to openjd --chunk 5 --job \
             shots/sh010.job.json"
        );
        let apart = [PathBuf::from("/meshes/cow.obj")];
        let line = choices.job(&in_film, None, (&farm, &apart)).unwrap();
        assert_eq!(line.folder, Path::new("/film/shots"), "a disk is no folder of a film");
        let varied = [Variation::around("rim.falloff".to_owned(), 0.4, false)];
        let mut look = shot();
        look.mesh = Some(("shape:knot".to_owned(), true));
        assert_eq!(
            look.wedge(&varied, "wedge/rim.png", [480, 270], Some(3)).text(),
            "chiaro wedge sh010.json -o wedge/rim.png --vary rim.falloff=0.2..0.6/4 \
             --size 480x270 --frames=3 --mesh shape:knot --z-up"
        );
    }
}
