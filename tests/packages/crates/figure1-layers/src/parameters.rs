//! The parameters of the look.

#![allow(clippy::approx_constant, reason = "values are those that the artist chose")]

/// Parameters that the artist exposed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Color of Base. What is seen where no layer paints.
    pub base_color: [f32; 4],
    /// Offset of Fill, 0 to 3.1416, in radians. Up to this angle the tone is 1; pi is ambient.
    pub fill_offset: f32,
    /// Fall-off of Fill, 0 to 3.1416, in radians. Where the tone falls fastest.
    pub fill_falloff: f32,
    /// Cut-off of Fill, 0 to 3.1416, in radians. Where the tone reaches 0.
    pub fill_cutoff: f32,
    /// Convex color of Fill. Straight RGBA, where the surface bulges.
    pub fill_convex: [f32; 4],
    /// Concave color of Fill. Straight RGBA, where the surface is hollow; while unset, the convex
    /// color, so that there is one color everywhere.
    pub fill_concave: [f32; 4],
    /// Shape slope of Fill. How fast flat becomes convex; 0 is 0.5 everywhere.
    pub fill_slope: f32,
    /// Shape offset of Fill, -3.1416 to 3.1416, in radians. The shape offset t.
    pub fill_amount: f32,
    /// Opacity of Fill, 0 to 1. 0 leaves what is below as it is, in every mode. It counts from 0 to
    /// 1, as does the color's alpha, and, but for Add, Multiply and Subtract, the tone.
    pub fill_opacity: f32,
    /// Clamp of Fill. Keeps the stack, which is premultiplied, within 0 and 1 after this layer.
    pub fill_clamped: bool,
    /// Offset of Diffuse, 0 to 3.1416, in radians. Up to this angle the tone is 1; pi is ambient.
    pub diffuse_offset: f32,
    /// Fall-off of Diffuse, 0 to 3.1416, in radians. Where the tone falls fastest.
    pub diffuse_falloff: f32,
    /// Cut-off of Diffuse, 0 to 3.1416, in radians. Where the tone reaches 0.
    pub diffuse_cutoff: f32,
    /// Convex color of Diffuse. Straight RGBA, where the surface bulges.
    pub diffuse_convex: [f32; 4],
    /// Concave color of Diffuse. Straight RGBA, where the surface is hollow; while unset, the
    /// convex color, so that there is one color everywhere.
    pub diffuse_concave: [f32; 4],
    /// Shape slope of Diffuse. How fast flat becomes convex; 0 is 0.5 everywhere.
    pub diffuse_slope: f32,
    /// Shape offset of Diffuse, -3.1416 to 3.1416, in radians. The shape offset t.
    pub diffuse_amount: f32,
    /// Opacity of Diffuse, 0 to 1. 0 leaves what is below as it is, in every mode. It counts from 0
    /// to 1, as does the color's alpha, and, but for Add, Multiply and Subtract, the tone.
    pub diffuse_opacity: f32,
    /// Clamp of Diffuse. Keeps the stack, which is premultiplied, within 0 and 1 after this layer.
    pub diffuse_clamped: bool,
    /// Offset of Specular, 0 to 3.1416, in radians. Up to this angle the tone is 1; pi is ambient.
    pub specular_offset: f32,
    /// Fall-off of Specular, 0 to 3.1416, in radians. Where the tone falls fastest.
    pub specular_falloff: f32,
    /// Cut-off of Specular, 0 to 3.1416, in radians. Where the tone reaches 0.
    pub specular_cutoff: f32,
    /// Convex color of Specular. Straight RGBA, where the surface bulges.
    pub specular_convex: [f32; 4],
    /// Concave color of Specular. Straight RGBA, where the surface is hollow; while unset, the
    /// convex color, so that there is one color everywhere.
    pub specular_concave: [f32; 4],
    /// Shape slope of Specular. How fast flat becomes convex; 0 is 0.5 everywhere.
    pub specular_slope: f32,
    /// Shape offset of Specular, -3.1416 to 3.1416, in radians. The shape offset t.
    pub specular_amount: f32,
    /// Opacity of Specular, 0 to 1. 0 leaves what is below as it is, in every mode. It counts from
    /// 0 to 1, as does the color's alpha, and, but for Add, Multiply and Subtract, the tone.
    pub specular_opacity: f32,
    /// Clamp of Specular. Keeps the stack, which is premultiplied, within 0 and 1 after this layer.
    pub specular_clamped: bool,
    /// Offset of Back-light, 0 to 3.1416, in radians. Up to this angle the tone is 1; pi is
    /// ambient.
    pub back_light_offset: f32,
    /// Fall-off of Back-light, 0 to 3.1416, in radians. Where the tone falls fastest.
    pub back_light_falloff: f32,
    /// Cut-off of Back-light, 0 to 3.1416, in radians. Where the tone reaches 0.
    pub back_light_cutoff: f32,
    /// Convex color of Back-light. Straight RGBA, where the surface bulges.
    pub back_light_convex: [f32; 4],
    /// Concave color of Back-light. Straight RGBA, where the surface is hollow; while unset, the
    /// convex color, so that there is one color everywhere.
    pub back_light_concave: [f32; 4],
    /// Shape slope of Back-light. How fast flat becomes convex; 0 is 0.5 everywhere.
    pub back_light_slope: f32,
    /// Shape offset of Back-light, -3.1416 to 3.1416, in radians. The shape offset t.
    pub back_light_amount: f32,
    /// Opacity of Back-light, 0 to 1. 0 leaves what is below as it is, in every mode. It counts
    /// from 0 to 1, as does the color's alpha, and, but for Add, Multiply and Subtract, the tone.
    pub back_light_opacity: f32,
    /// Clamp of Back-light. Keeps the stack, which is premultiplied, within 0 and 1 after this
    /// layer.
    pub back_light_clamped: bool,
    /// Alpha cutoff of Output, 0 to 1. Fragments with less alpha than this are not drawn, the
    /// others keep theirs; 0 draws all.
    pub output_cutoff: f32,
}

/// Values that the artist has chosen.
impl Default for Parameters {
    fn default() -> Self {
        Self {
            base_color: [0.0824, 0.0745, 0.1098, 1.0],
            fill_offset: std::f32::consts::PI,
            fill_falloff: std::f32::consts::PI,
            fill_cutoff: std::f32::consts::PI,
            fill_convex: [0.0863, 0.0745, 0.1216, 1.0],
            fill_concave: [0.0314, 0.0235, 0.051, 1.0],
            fill_slope: 0.25,
            fill_amount: 0.0,
            fill_opacity: 1.0,
            fill_clamped: true,
            diffuse_offset: 0.05,
            diffuse_falloff: 1.25,
            diffuse_cutoff: 1.9,
            diffuse_convex: [0.7098, 0.4, 0.1804, 1.0],
            diffuse_concave: [0.4314, 0.1647, 0.1176, 1.0],
            diffuse_slope: 0.2,
            diffuse_amount: 0.25,
            diffuse_opacity: 1.0,
            diffuse_clamped: true,
            specular_offset: 0.1,
            specular_falloff: 0.26,
            specular_cutoff: 0.5,
            specular_convex: [0.9098, 0.851, 0.7216, 1.0],
            specular_concave: [0.5412, 0.3608, 0.251, 1.0],
            specular_slope: 0.15,
            specular_amount: 0.1,
            specular_opacity: 1.0,
            specular_clamped: true,
            back_light_offset: 0.5,
            back_light_falloff: 0.95,
            back_light_cutoff: 1.25,
            back_light_convex: [0.3098, 0.5255, 0.7216, 1.0],
            back_light_concave: [0.1294, 0.2706, 0.4314, 1.0],
            back_light_slope: 0.2,
            back_light_amount: 0.15,
            back_light_opacity: 1.0,
            back_light_clamped: true,
            output_cutoff: 0.0,
        }
    }
}
