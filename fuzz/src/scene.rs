//! Scene files, and scenes in requests.

use passivity_scene::{Scene, check};

/// A scene is refused with a message, or every question about it has an answer.
pub(crate) fn run(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    judge(Scene::from_toml("fuzz", text));
    if let Ok(value) = serde_json::from_str(text) {
        judge(Scene::from_json(&value));
    }
}

fn judge(scene: Result<Scene, passivity_scene::SceneError>) {
    match scene {
        Err(error) => assert!(!error.to_string().is_empty(), "an error that says nothing"),
        Ok(scene) => {
            let report = check::check(&scene).to_json();
            let verdict = report["verdict"].as_str().unwrap_or_default();
            let known = [
                "passive",
                "not_passive",
                "not_guaranteed",
                "depends",
                "not_covered",
            ];
            assert!(known.contains(&verdict), "the verdict `{verdict}`");
            let uncovered = scene.not_covered();
            assert_eq!(
                verdict == "not_covered",
                !uncovered.is_empty(),
                "{uncovered:?}"
            );
        }
    }
}
