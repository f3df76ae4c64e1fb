//! What the document of a case and its argument say of a scene is so.

mod text;
mod witnesses;

use std::path::Path;

use passivity_case::{Case, Records, Study, html, sections};
use passivity_scene::Scene;

fn study(text: &str) -> Study {
    let scene = Scene::from_toml("scene", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    Study::new(scene, text.to_owned(), Path::new("scene.toml"))
}

fn dimensionless(beta: &str, sigma: &str, sections: &str) -> Study {
    study(&format!(
        "[dimensionless]\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n{sections}"
    ))
}

fn shipped(name: &str) -> Study {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");
    Study::read(&Path::new(folder).join(name)).expect("a scene")
}

/// A case of a scene with the records of this build.
fn case(study: Study) -> Case {
    let records = Records::read(None, None).expect("the records of this build");
    Case::new(vec![study], records, Vec::new())
}

/// The document, without its line breaks.
fn page(case: &Case) -> String {
    in_one_line(&html::write(&sections::document(case)))
}

/// A text that is broken into lines, in one.
fn in_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
