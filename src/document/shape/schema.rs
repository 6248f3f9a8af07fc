//! JSON Schemas (draft 2020-12) of the documents.

/// The schema of a look.
pub fn look_schema() -> serde_json::Value {
    serde_json::Value::Null
}

/// The schema of a scene.
pub fn scene_schema() -> serde_json::Value {
    serde_json::Value::Null
}
