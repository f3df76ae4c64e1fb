//! Running the command in a folder of its own.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

use num_bigint::BigInt;
use passivity_core::BigRational;
use serde_json::Value;

/// A new empty folder, removed with everything in it when dropped.
pub(crate) struct Dir {
    path: PathBuf,
}

impl Dir {
    pub(crate) fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let name = format!(
            "passivity-test-{}-{}",
            std::process::id(),
            COUNT.fetch_add(1, Ordering::Relaxed)
        );
        let path = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&path).expect("a temporary folder");
        Self { path }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes a file and gives its name, to be used from within the folder.
    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) -> String {
        std::fs::write(self.path(name), text).expect("a file in a temporary folder");
        name.to_owned()
    }

    /// Runs the command in the folder.
    pub(crate) fn run(&self, args: &[&str]) -> Run {
        let output = Command::new(env!("CARGO_BIN_EXE_passivity"))
            .args(args)
            .current_dir(&self.path)
            .output()
            .expect("the command starts");
        Run::from(output)
    }

    /// Writes `text` as a scene and checks it, for programs; gives the one scene's object.
    pub(crate) fn check(&self, text: &str) -> Checked {
        let name = self.write("scene.toml", text);
        let run = self.run(&["check", "--format", "json", &name]);
        let document = run.json();
        let scenes = document["scenes"].as_array().expect("a list of scenes");
        assert_eq!(scenes.len(), 1, "{}", run.stderr);
        Checked {
            scene: scenes[0].clone(),
            code: run.code,
        }
    }

    /// Lets the second implementation check certificates: its exit code, and what it says of each.
    pub(crate) fn check_certificates(&self, files: &[impl AsRef<std::ffi::OsStr>]) -> Run {
        let reference =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/conformance/passivity_ref.py");
        let output = Command::new("python3")
            .arg(reference)
            .arg("check-certificate")
            .args(files)
            .current_dir(&self.path)
            .output()
            .expect("Python");
        Run::from(output)
    }
}

impl Drop for Dir {
    fn drop(&mut self) {
        // A folder that stays behind in the temporary folder does no harm.
        let _ = std::fs::remove_dir_all(&self.path);
    }
}

/// The words of a picture that run over its left or right edge, by letters of 0.6 of their size: of the font of the PNG
/// files, few are wider.
pub(crate) fn words_off(svg: &str) -> Vec<&str> {
    let number = |text: &str, name: &str| -> f64 {
        let (_, rest) = text.split_once(&format!(" {name}=\"")).expect(name);
        let (figure, _) = rest.split_once('"').expect(name);
        figure.parse().expect(figure)
    };
    let wide = number(svg, "width");
    let texts = svg.lines().filter(|line| line.starts_with("<text x="));
    let all = texts.filter_map(|line| {
        let (_, rest) = line.split_once('>')?;
        let (words, _) = rest.split_once('<')?;
        let letters = u32::try_from(words.chars().count()).ok()?;
        let long = 0.6 * number(line, "font-size") * f64::from(letters);
        let place = number(line, "x");
        let start = match line {
            _ if line.contains("\"middle\"") => place - 0.5 * long,
            _ if line.contains("\"end\"") => place - long,
            _ => place,
        };
        (start < 0.0 || start + long > wide).then_some(words)
    });
    all.collect()
}

/// What a run gave.
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl From<Output> for Run {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code().expect("the command ends by itself"),
            stdout: String::from_utf8(output.stdout).expect("UTF-8"),
            stderr: String::from_utf8(output.stderr).expect("UTF-8"),
        }
    }
}

impl Run {
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout)
            .unwrap_or_else(|error| panic!("{error}\n{}\n{}", self.stdout, self.stderr))
    }
}

/// A scene of `check --format json`.
pub(crate) struct Checked {
    pub(crate) scene: Value,
    pub(crate) code: i32,
}

impl Checked {
    pub(crate) fn text(&self, field: &str) -> &str {
        self.scene[field]
            .as_str()
            .unwrap_or_else(|| panic!("`{field}` in {:#}", self.scene))
    }

    /// Both ends of an interval, which must agree.
    pub(crate) fn point(&self, field: &str) -> BigRational {
        let range = self.scene.get(field).unwrap_or_else(|| panic!("`{field}`"));
        assert_eq!(range["lo"], range["hi"], "{field}");
        rational(&range["lo"])
    }

    /// The ends of an interval.
    pub(crate) fn range(&self, field: &str) -> (BigRational, BigRational) {
        let range = self.scene.get(field).unwrap_or_else(|| panic!("`{field}`"));
        (rational(&range["lo"]), rational(&range["hi"]))
    }

    pub(crate) fn approx(&self, field: &str) -> f64 {
        self.scene[field]["approx"]
            .as_f64()
            .unwrap_or_else(|| panic!("`{field}`"))
    }
}

/// A rational in lowest terms, as the interface writes it; read here without the product's codec.
pub(crate) fn rational(value: &Value) -> BigRational {
    let text = value
        .as_str()
        .unwrap_or_else(|| panic!("a rational as a string: {value}"));
    let (n, d) = text.split_once('/').unwrap_or((text, "1"));
    let (n, d): (BigInt, BigInt) = (n.parse().expect(text), d.parse().expect(text));
    let reduced = BigRational::new(n.clone(), d.clone());
    assert_eq!(
        (reduced.numer(), reduced.denom()),
        (&n, &d),
        "{text} is in lowest terms"
    );
    reduced
}

pub(crate) fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The shipped scenes.
pub(crate) fn shipped() -> Vec<PathBuf> {
    let mut scenes: Vec<PathBuf> = std::fs::read_dir(root().join("scenes"))
        .expect("the shipped scenes")
        .map(|entry| entry.expect("a folder entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    scenes.sort();
    assert!(scenes.len() >= 8, "{scenes:?}");
    scenes
}
