//! The reference's picture of a setup, to hold others against.
use super::{Colors, ErrorFigures, Progress, Stopped, compare};
use crate::frame::{FramePlan, PlanOptions, Planner, Setup};
use crate::library::Library;
use crate::render::Renderer;
#[derive(Debug)]
pub struct Truth;
impl Truth {
    pub fn of(_: &Setup, _: &Library, _: &mut Planner, _: &PlanOptions, _: &mut Progress<'_>) -> Result<Self, Stopped> {
        todo!()
    }
    pub fn compare(&self, _: &mut Renderer, _: &FramePlan) -> Result<ErrorFigures, Stopped> {
        todo!()
    }
}
