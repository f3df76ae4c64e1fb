//! Printing the document as PDF with a browser: its print style sheet is the layout.

use std::ffi::OsString;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::error::CaseError;

/// The environment variable that names the browser.
pub const VARIABLE: &str = "PASSIVITY_BROWSER";

/// The browsers that are looked for on the PATH.
pub const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// How long the browser may take: it takes a few seconds.
pub const TIME_LIMIT: Duration = Duration::from_secs(120);

/// The browser to print with: the one that the environment names, else the first on the PATH.
#[must_use]
pub fn browser(named: Option<OsString>, path: Option<OsString>) -> Option<PathBuf> {
    if let Some(named) = named.filter(|named| !named.is_empty()) {
        return Some(PathBuf::from(named));
    }
    let folders: Vec<PathBuf> = path.iter().flat_map(std::env::split_paths).collect();
    BROWSERS.iter().find_map(|name| {
        let mut places = folders.iter().map(|folder| folder.join(name));
        places.find(|place| place.is_file())
    })
}

/// Prints the page `html` as PDF.
///
/// # Errors
///
/// A browser that cannot be started, takes longer than `limit`, or writes no PDF.
pub fn to_pdf(browser: &Path, html: &Path, limit: Duration) -> Result<Vec<u8>, CaseError> {
    let html = std::path::absolute(html).map_err(|error| CaseError::io(html, &error))?;
    let scratch = Scratch::new()?;
    let output = scratch.0.join("page.pdf");
    let log = scratch.0.join("log");
    let log_file = File::create(&log).map_err(|error| CaseError::io(&log, &error))?;
    let log_too = log_file
        .try_clone()
        .map_err(|error| CaseError::io(&log, &error))?;
    let mut command = Command::new(browser);
    command
        .args([
            "--headless",
            "--disable-gpu",
            "--disable-extensions",
            "--no-first-run",
        ])
        .args(["--no-pdf-header-footer", "--generate-pdf-document-outline"])
        .arg(option("--user-data-dir", &scratch.0.join("profile")))
        .arg(option("--print-to-pdf", &output))
        .stdin(Stdio::null())
        .stdout(log_file)
        .stderr(log_too);
    if is_root() {
        // Chromium's sandbox refuses to run as root. The page is our own, and has no script.
        command.arg("--no-sandbox");
    }
    command.arg(file_url(&html));
    let mut child = command
        .spawn()
        .map_err(|error| CaseError::io(browser, &error))?;
    let status = wait(&mut child, limit).map_err(|error| CaseError::io(browser, &error))?;
    let said = std::fs::read_to_string(&log).map_err(|error| CaseError::io(&log, &error))?;
    let failed = |what: &str| {
        let last: Vec<&str> = said.lines().rev().take(3).collect();
        let last: Vec<&str> = last.into_iter().rev().collect();
        CaseError::within(browser, format!("{what}\n{}", last.join("\n")))
    };
    match status {
        None => {
            let limit = limit.as_secs_f32();
            return Err(failed(&format!("did not print the page within {limit} s")));
        }
        Some(status) if !status.success() => {
            return Err(failed(&format!("did not print the page: {status}")));
        }
        Some(_) => {}
    }
    let bytes = std::fs::read(&output).map_err(|_| failed("wrote no PDF"))?;
    if !bytes.starts_with(b"%PDF-") {
        return Err(failed("wrote a file that is no PDF"));
    }
    Ok(bytes)
}

fn option(name: &str, path: &Path) -> OsString {
    let mut option = OsString::from(format!("{name}="));
    option.push(path);
    option
}

/// Waits for the child; `None` when it had to be ended because it took too long.
fn wait(child: &mut Child, limit: Duration) -> std::io::Result<Option<ExitStatus>> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if start.elapsed() >= limit {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(Duration::from_millis(20));
    }
}

/// Whether this program runs as root, as it does in many containers.
#[cfg(unix)]
fn is_root() -> bool {
    use std::os::unix::fs::MetadataExt as _;
    // Where there is no such folder, the browser itself says what it needs.
    std::fs::metadata("/proc/self").is_ok_and(|process| process.uid() == 0)
}

#[cfg(not(unix))]
fn is_root() -> bool {
    false
}

/// The URL of a file, with every byte that means something else in a URL written as a number.
fn file_url(path: &Path) -> String {
    let mut url = String::from("file://");
    let text = path.to_string_lossy();
    // On Windows a path begins with a drive.
    if !text.starts_with('/') {
        url.push('/');
    }
    for byte in text.bytes() {
        match byte {
            b'\\' => url.push('/'),
            b'/' | b':' | b'-' | b'_' | b'.' | b'~' => url.push(char::from(byte)),
            _ if byte.is_ascii_alphanumeric() => url.push(char::from(byte)),
            _ => url.push_str(&format!("%{byte:02X}")),
        }
    }
    url
}

/// A folder of our own for the browser, removed with everything in it.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Result<Self, CaseError> {
        use std::sync::atomic::{AtomicU32, Ordering};
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("passivity-print-{}-{number}", std::process::id());
        let path = std::env::temp_dir().join(name);
        std::fs::create_dir(&path).map_err(|error| CaseError::io(&path, &error))?;
        Ok(Self(path))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // A folder that stays behind in the temporary folder does no harm.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs;
    use std::os::unix::fs::PermissionsExt as _;

    use super::*;

    /// A folder with a page and with a script in the place of a browser.
    fn with_browser(script: &str) -> (Scratch, PathBuf) {
        let folder = Scratch::new().unwrap();
        let browser = folder.0.join("browser");
        fs::write(&browser, format!("#!/bin/sh\n{script}\n")).unwrap();
        fs::set_permissions(&browser, fs::Permissions::from_mode(0o755)).unwrap();
        fs::write(folder.0.join("page.html"), "<p>A page").unwrap();
        (folder, browser)
    }

    fn print(script: &str, limit: Duration) -> Result<Vec<u8>, String> {
        let (folder, browser) = with_browser(script);
        let printed = to_pdf(&browser, &folder.0.join("page.html"), limit);
        printed.map_err(|error| error.to_string())
    }

    /// Finds where the PDF is wanted, and the page.
    const ARGUMENTS: &str = "for a in \"$@\"; do case $a in --print-to-pdf=*) out=${a#*=};; \
                             file://*) page=$a;; esac; done";

    #[test]
    fn the_browser_gets_the_page_and_its_pdf_is_taken() {
        let script = format!("{ARGUMENTS}\n{{ echo %PDF-1.4; echo \"$page\"; }} >\"$out\"");
        let text = String::from_utf8(print(&script, TIME_LIMIT).unwrap()).unwrap();
        assert!(text.starts_with("%PDF-1.4\nfile:///"), "{text}");
        assert!(text.trim_end().ends_with("/page.html"), "{text}");
    }

    #[test]
    fn a_browser_that_fails_hangs_or_writes_no_pdf_is_an_error() {
        let wrong = format!("{ARGUMENTS}\necho nonsense >\"$out\"");
        for (script, limit, says) in [
            ("echo no display >&2; exit 7", 60_000, "no display"),
            ("exit 0", 60_000, "wrote no PDF"),
            (wrong.as_str(), 60_000, "no PDF"),
            ("exec sleep 60", 200, "within 0.2 s"),
        ] {
            let error = print(script, Duration::from_millis(limit)).unwrap_err();
            assert!(error.contains(says), "{error}");
        }
        let none = to_pdf(
            Path::new("/nowhere/browser"),
            Path::new("page.html"),
            TIME_LIMIT,
        );
        assert!(none.unwrap_err().to_string().contains("/nowhere/browser"));
    }

    #[test]
    fn the_named_browser_comes_first_and_then_the_path() {
        let (folder, browser_there) = with_browser("exit 0");
        let path = Some(folder.0.clone().into_os_string());
        let named = |name: &str| Some(OsString::from(name));
        assert_eq!(browser(named("mine"), path.clone()), Some("mine".into()));
        assert_eq!(browser(named(""), path.clone()), None);
        let place = folder.0.join("chromium-browser");
        fs::rename(browser_there, &place).unwrap();
        assert_eq!(browser(None, path), Some(place));
        assert_eq!(browser(None, None), None);
    }

    #[test]
    fn a_path_is_a_url() {
        let url = file_url(Path::new("/a b/50%#?é.html"));
        assert_eq!(url, "file:///a%20b/50%25%23%3F%C3%A9.html");
    }
}
