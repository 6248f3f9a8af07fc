//! Previews of nodes' outputs: a ball shaded by the output, or, where the output is the same
//! everywhere, its value in a few letters.
//!
//! A thread evaluates one node at a time in the interpreter, on a small grid of points of a ball:
//! nodes in view first, and only once nothing was changed for a moment. So neither the window nor
//! the renderer waits for previews.

use chiaro_locale::tr;
use eframe::egui;
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::{
    Color32, ColorImage, Context, Pos2, Rect, TextureHandle, TextureOptions, Ui, pos2, vec2,
};

use super::Canvas;
use super::draw::ALL_TEXT;
use super::table::NodeRow;
use crate::compile::CompileOptions;
use crate::document::{Look, SourceMap};
use crate::drawing::{NODE_WIDTH, TITLE_HEIGHT};
use crate::frame::{Assets, EvalSample, SetupLook, eval_batches};
use crate::ids::{NodeId, NodePath, PortName};
use crate::interp::Precision;
use crate::library::{Library, Type};
use crate::reference;
use crate::state::crashes::{CrashStep, DocumentOrigin};
use crate::state::revision::{DocumentNumber, MeaningRevision};
use crate::state::session::Session;
use crate::state::worker::{BackgroundJobs, Worker};
use crate::values::number_text;

/// Width of the ball, in samples.
const SIZE: usize = 48;
/// Time without a change to the look before previews are evaluated, in seconds.
const REST: f64 = 0.35;
/// Largest number of nodes of a look with previews; longer looks take too long to compile for each
/// of their nodes.
const MAX_NODES: usize = 1500;
/// Zoom below which balls are too small to see.
const MIN_ZOOM: f32 = 0.18;
/// Width of a ball in a node's title, in points of the graph.
const SIDE: f32 = 22.0;
/// Margin between a ball and the sockets beside it, where the ball takes the place of values that
/// would be too small to read, in points of the graph.
const MARGIN: f32 = 18.0;

/// Preview of an output.
#[derive(Clone)]
pub(super) enum Preview {
    /// Ball shaded by the output.
    Ball(TextureHandle),
    /// Value that is the same everywhere.
    Value(String),
    /// Output that cannot be shown or evaluated.
    Nothing,
}

/// Request to evaluate one node.
struct Request {
    key: Key,
    look: Arc<Look>,
    source: Arc<SourceMap>,
    library: Arc<Library>,
    folder: PathBuf,
    root: (NodePath, PortName),
    samples: Arc<Vec<EvalSample>>,
    /// Document of the picture: its name and its file.
    file: (String, Option<PathBuf>),
}

struct Answer {
    key: Key,
    /// Value at each point of the ball, with the type; `None` where the look has errors.
    values: Option<(Vec<[f64; 4]>, Type)>,
}

/// Key of a preview: the node, and the state of the look.
type Key = (NodePath, (DocumentNumber, MeaningRevision));

/// Previews of nodes.
#[derive(Default)]
pub(super) struct Previews {
    worker: Option<Worker<Request, Answer>>,
    known: HashMap<NodePath, ((DocumentNumber, MeaningRevision), Preview)>,
    /// State of the look that was seen last, the time it was first seen, and a copy of the look.
    seen: Option<((DocumentNumber, MeaningRevision), f64)>,
    look: Option<((DocumentNumber, MeaningRevision), Arc<Look>)>,
    samples: Option<Arc<Vec<EvalSample>>>,
    waits: bool,
}

impl Previews {
    pub(super) fn is_busy(&self) -> bool {
        self.waits || self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    pub(super) fn wait(&self) {
        if let Some(worker) = &self.worker {
            worker.wait();
        }
    }

    /// Takes finished previews, and requests those that are missing among `visible`.
    fn update(
        &mut self,
        ctx: &Context,
        session: &Session,
        visible: impl Iterator<Item = (NodePath, PortName)>,
    ) {
        let state = (session.revisions().document, session.revisions().meaning);
        for Answer { key: (path, of), values } in self.worker.iter().flat_map(Worker::answers) {
            let shown =
                values.map_or(Preview::Nothing, |(values, ty)| show(ctx, &path, &values, &ty));
            self.known.insert(path, (of, shown));
            self.waits = false;
        }
        let now = ctx.input(|input| input.time);
        if self.seen.is_none_or(|(seen, _)| seen != state) {
            self.seen = Some((state, now));
        }
        let rested = now - self.seen.map_or(now, |(_, since)| since);
        if self.waits || session.awaits_first_picture || session.journals.held().is_some() {
            return;
        }
        if session.graph().nodes.len() > MAX_NODES || session.look().graph.nodes.len() > MAX_NODES {
            return;
        }
        let is_missing = |(path, _): &(NodePath, PortName)| {
            self.known.get(path).is_none_or(|(of, _)| *of != state)
        };
        let mut missing = visible.filter(is_missing);
        let Some(root) = missing.next() else { return };
        drop(missing);
        if rested < REST {
            ctx.request_repaint_after(std::time::Duration::from_secs_f64(
                (REST - rested).max(0.01),
            ));
            return;
        }
        if self.look.as_ref().is_none_or(|(of, _)| *of != state) {
            self.look = Some((state, Arc::new(session.look().clone())));
        }
        let Some((_, look)) = &self.look else { return };
        let request = Request {
            key: (root.0.clone(), state),
            look: look.clone(),
            source: session.look.file.source.clone(),
            library: session.project.library.clone(),
            folder: session
                .path()
                .and_then(|path| path.parent())
                .map(PathBuf::from)
                .unwrap_or_default(),
            root,
            file: session.shown_file(),
            samples: self.samples.get_or_insert_with(|| Arc::new(ball())).clone(),
        };
        let worker = self.worker.get_or_insert_with(|| {
            let (ctx, crashes, mut assets) =
                (ctx.clone(), session.journals.crashes.clone(), Assets::of(&session.assets));
            Worker::new(
                "previews",
                move || ctx.request_repaint(),
                move |request: Request| {
                    let (name, path) = &request.file;
                    let _going = crashes.begin(CrashStep::Draw, || {
                        DocumentOrigin::new(name, path.as_deref(), &request.look)
                    });
                    evaluate(request, &mut assets)
                },
            )
        });
        worker.request(|_| request);
        self.waits = true;
    }
}

/// Contexts that do not follow from the surface.
const PIXEL: crate::library::Context = crate::library::Context::named("pixel");
const MAGNIFICATION: crate::library::Context = crate::library::Context::named("magnification");

/// Points of a ball as the camera sees it, row by row; points in the corners lie on the ball's rim
/// and are not shown.
fn ball() -> Vec<EvalSample> {
    let sample = |index: usize| {
        let along = |i: usize| (i as f64 + 0.5) / SIZE as f64 * 2.0 - 1.0;
        let (x, y) = (along(index % SIZE), -along(index / SIZE));
        let length = x.hypot(y).max(1.0);
        let (x, y) = (x / length, y / length);
        let normal = glam::DVec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt()).normalize();
        let uv = glam::DVec2::new(0.5 + x / 2.0, 0.5 - y / 2.0);
        // The position in the picture is that of a ball as high as the picture.
        let pixel = glam::DVec2::new(uv.x, 1.0 - uv.y);
        EvalSample {
            normal,
            position: normal,
            uv,
            kappa: 2.0,
            contexts: [(PIXEL, pixel.to_array().to_vec()), (MAGNIFICATION, vec![0.5])].into(),
            ..EvalSample::default()
        }
    };
    (0..SIZE * SIZE).map(sample).collect()
}

fn evaluate(request: Request, assets: &mut Assets) -> Answer {
    let Request { key, look, source, library, folder, root, samples, file: _ } = request;
    let setup = SetupLook { look: (*look).clone(), source, folder };
    let options = CompileOptions { root: Some(root), ..CompileOptions::default() };
    let evaluated =
        eval_batches(&setup, &library, &samples, &options, assets).ok().and_then(|batches| {
            let mut values = vec![[0.0; 4]; samples.len()];
            let mut ty = None;
            for batch in &batches {
                let found = reference::evaluate(batch, Precision::F32).ok()?;
                for (&index, value) in batch.indices.iter().zip(found) {
                    values[index] = value;
                }
                ty = Some(batch.shader.root_type.clone());
            }
            Some((values, ty?))
        });
    Answer { key, values: evaluated }
}

/// Preview of the values at all points: a picture, or the one value that they share.
fn show(ctx: &Context, path: &NodePath, values: &[[f64; 4]], ty: &Type) -> Preview {
    let Some(width) = (if *ty == Type::Angle { Some(1) } else { ty.width() }) else {
        return Preview::Nothing;
    };
    // An angle is given as the sine and cosine of its half.
    let number = |value: &[f64; 4]| {
        if *ty == Type::Angle { 2.0 * value[0].atan2(value[1]) } else { value[0] }
    };
    let is_color = matches!(ty, Type::Color | Type::Composite);
    if let Some(first) = values.first()
        && !is_color
        && values.iter().all(|value| value[..width] == first[..width])
    {
        let text = match ty {
            Type::Angle => format!("{}°", number_text(number(first).to_degrees(), 1)),
            Type::Bool => {
                if first[0] > 0.5 { tr!("switch" => "on") } else { tr!("switch" => "off") }
                    .to_owned()
            }
            _ if width == 1 => number_text(first[0], 3),
            _ => first[..width].iter().map(|x| number_text(*x, 2)).collect::<Vec<_>>().join(", "),
        };
        return Preview::Value(text);
    }
    let byte = |x: f64| if x.is_finite() { (x.clamp(0.0, 1.0) * 255.0).round() as u8 } else { 0 };
    let pixel = |value: &[f64; 4]| match width {
        _ if value.iter().any(|x| !x.is_finite()) => Color32::from_rgb(255, 0, 255),
        1 if *ty == Type::Angle => Color32::from_gray(byte(number(value) / std::f64::consts::PI)),
        1 => Color32::from_gray(byte(value[0])),
        2 => Color32::from_rgb(byte(value[0]), byte(value[1]), 0),
        4 if is_color => {
            let [r, g, b, a] = value.map(byte);
            Color32::from_rgba_unmultiplied(r, g, b, a)
        }
        // Directions from -1 to 1 are shown as in normal maps.
        _ => Color32::from_rgb(
            byte(value[0] * 0.5 + 0.5),
            byte(value[1] * 0.5 + 0.5),
            byte(value[2] * 0.5 + 0.5),
        ),
    };
    let pixels = values.iter().enumerate().map(|(index, value)| {
        let along = |i: usize| i as f32 + 0.5 - SIZE as f32 / 2.0;
        let radius = along(index % SIZE).hypot(along(index / SIZE));
        // The rim is soft, one point wide.
        pixel(value).gamma_multiply((SIZE as f32 / 2.0 - radius).clamp(0.0, 1.0))
    });
    let image = ColorImage::new([SIZE, SIZE], pixels.collect());
    Preview::Ball(ctx.load_texture(format!("preview {path}"), image, TextureOptions::LINEAR))
}

impl Canvas {
    /// Updates the previews of the nodes in view, and draws the balls.
    pub(super) fn draw_previews(&mut self, ui: &Ui, session: &Session) {
        if self.view.zoom < MIN_ZOOM {
            return;
        }
        let visible = self.view.visible();
        let rows = self.table.nodes.iter().enumerate();
        let rows = rows
            .filter(|(_, row)| row.rect.intersects(visible) && !row.is_end && !row.kind.is_missing);
        let shown: Vec<(usize, NodePath)> = rows
            .filter(|(_, row)| row.kind.outputs.first().is_some_and(|port| can_be_shown(&port.ty)))
            .map(|(index, row)| (index, session.selection.path_of(&row.id)))
            .collect();
        let roots = shown.iter().map(|(index, path)| {
            let port = self.table.nodes[*index].kind.outputs[0].name.clone();
            (path.clone(), port)
        });
        self.previews.update(ui.ctx(), session, roots);
        let painter = ui.painter_at(self.view.screen);
        for (index, path) in shown {
            let row = &self.table.nodes[index];
            let Some((_, Preview::Ball(texture))) = self.previews.known.get(&path) else {
                continue;
            };
            let (center, side) = place(row, self.view.zoom);
            let is_tagged = row.is_muted || self.idle_of(row).is_some();
            // A ball under another node is not drawn: balls are painted after all nodes.
            let is_covered =
                self.table.nodes[index + 1..].iter().any(|other| other.rect.contains(center));
            if !is_tagged && !is_covered {
                let place =
                    self.view.rect_to_screen(Rect::from_center_size(center, vec2(side, side)));
                let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
                painter.image(texture.id(), place, uv, Color32::WHITE);
            }
        }
    }

    /// Value of a node's first output, where it is the same everywhere.
    pub(super) fn value_of(&self, session: &Session, id: &NodeId) -> Option<&str> {
        match self.previews.known.get(&session.selection.path_of(id)) {
            Some((_, Preview::Value(text))) => Some(text),
            _ => None,
        }
    }

    /// Ball of a node, for a closer look.
    pub(super) fn ball_of(&self, session: &Session, id: &NodeId) -> Option<&TextureHandle> {
        match self.previews.known.get(&session.selection.path_of(id)) {
            Some((_, Preview::Ball(texture))) => Some(texture),
            _ => None,
        }
    }
}

impl BackgroundJobs for Canvas {
    fn is_busy(&self) -> bool {
        self.previews.is_busy() || self.costs.is_busy()
    }

    fn wait(&self) {
        self.previews.wait();
        self.costs.wait();
    }
}

/// Center and width of a node's ball: in the title, or, from afar, over the whole node, which is
/// then told apart by its ball.
fn place(row: &NodeRow, zoom: f32) -> (Pos2, f32) {
    let body = Rect::from_min_max(row.rect.min + vec2(0.0, TITLE_HEIGHT), row.rect.max);
    let side = (body.width() - 2.0 * MARGIN).min(body.height() - 8.0);
    if zoom > ALL_TEXT || side < SIDE {
        return (row.rect.min + vec2(NODE_WIDTH - SIDE / 2.0 - 4.0, TITLE_HEIGHT / 2.0), SIDE);
    }
    (body.center(), side)
}

/// True if values of a type consist of numbers that a preview can show.
fn can_be_shown(ty: &Type) -> bool {
    *ty == Type::Angle || *ty != Type::Mat3 && ty.width().is_some()
}

/// Shows a ball enlarged, beside the pointer.
pub(super) fn large(ui: &mut egui::Ui, texture: &TextureHandle) {
    ui.add(egui::Image::new((texture.id(), vec2(96.0, 96.0))));
}
