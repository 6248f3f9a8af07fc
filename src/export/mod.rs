//! Shaders in other languages.
