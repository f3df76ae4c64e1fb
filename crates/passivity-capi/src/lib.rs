//! The exact passivity ledger and verdict for C programs; see `include/passivity.h`.
//!
//! The one place with unsafe code: strings cross the border as pointers. Each function reads its
//! arguments once, does its work in safe Rust, and lets no panic out.
#![allow(unsafe_code)]

use std::ffi::{CStr, CString, c_char, c_longlong};
use std::panic::{AssertUnwindSafe, catch_unwind};

use passivity_oracle::protocol;
use passivity_scene::AnyScene;
use serde_json::{Map, Value, json};

/// The version that [`passivity_version`] gives.
const VERSION: &CStr =
    match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(version) => version,
        Err(_) => c"",
    };

/// A text as a string of C; its zero bytes, which JSON has none of, would end it early.
fn give(work: impl FnOnce() -> Vec<u8>) -> *mut c_char {
    let text = catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        br#"{"id": null, "error": {"kind": "internal", "message": "a defect in passivity", "at": null}}"#
            .to_vec()
    });
    CString::new(text).map_or(std::ptr::null_mut(), CString::into_raw)
}

fn ask(request: &Value) -> Vec<u8> {
    let mut answer = Vec::new();
    protocol::answer(request.to_string().as_bytes(), &mut answer);
    answer
}

/// The text at a pointer; bytes that are not UTF-8 become U+FFFD, which no number has.
///
/// # Safety
///
/// The pointer is null or points at a string that ends in a zero byte.
unsafe fn text(pointer: *const c_char) -> Option<String> {
    if pointer.is_null() {
        return None;
    }
    // SAFETY: not null, and the caller vouches for the rest.
    let text = unsafe { CStr::from_ptr(pointer) };
    Some(text.to_string_lossy().into_owned())
}

fn interval(ends: [(&str, Value); 2], [beta, sigma, dtau]: [Option<String>; 3]) -> *mut c_char {
    let (Some(beta), Some(sigma)) = (beta, sigma) else {
        return std::ptr::null_mut();
    };
    let mut request = Map::new();
    request.insert("op".to_owned(), json!("interval"));
    for (name, value) in ends {
        request.insert(name.to_owned(), value);
    }
    request.insert("beta".to_owned(), json!(beta));
    request.insert("sigma".to_owned(), json!(sigma));
    if let Some(dtau) = dtau {
        request.insert("dtau".to_owned(), json!(dtau));
    }
    give(|| ask(&Value::Object(request)))
}

/// The answer to a request of the line protocol.
///
/// # Safety
///
/// `request` is null or points at `length` readable bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_answer(request: *const c_char, length: usize) -> *mut c_char {
    if request.is_null() {
        return std::ptr::null_mut();
    }
    // SAFETY: not null, and the caller vouches for the length.
    let request = unsafe { std::slice::from_raw_parts(request.cast::<u8>(), length) };
    give(|| {
        let mut answer = Vec::new();
        protocol::answer(request, &mut answer);
        answer
    })
}

/// The ledger row of an interval between exact positions.
///
/// # Safety
///
/// Each argument is null or points at a string that ends in a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_interval(
    xi0: *const c_char,
    xi1: *const c_char,
    beta: *const c_char,
    sigma: *const c_char,
    dtau: *const c_char,
) -> *mut c_char {
    // SAFETY: the caller vouches for each.
    let [xi0, xi1, beta, sigma, dtau] = [xi0, xi1, beta, sigma, dtau].map(|x| unsafe { text(x) });
    let (Some(xi0), Some(xi1)) = (xi0, xi1) else {
        return std::ptr::null_mut();
    };
    interval(
        [("xi0", json!(xi0)), ("xi1", json!(xi1))],
        [beta, sigma, dtau],
    )
}

/// The ledger row of an interval between encoder counts.
///
/// # Safety
///
/// Each string is null or ends in a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_interval_of_counts(
    count0: c_longlong,
    count1: c_longlong,
    beta: *const c_char,
    sigma: *const c_char,
    dtau: *const c_char,
) -> *mut c_char {
    // SAFETY: the caller vouches for each.
    let strings = [beta, sigma, dtau].map(|x| unsafe { text(x) });
    interval(
        [("count0", json!(count0)), ("count1", json!(count1))],
        strings,
    )
}

/// The verdict on a scene.
///
/// # Safety
///
/// `scene_toml` is null or points at a string that ends in a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_check(scene_toml: *const c_char) -> *mut c_char {
    // SAFETY: the caller vouches for it.
    let Some(scene) = (unsafe { text(scene_toml) }) else {
        return std::ptr::null_mut();
    };
    give(|| {
        let answer = match AnyScene::from_toml("scene", &scene) {
            Ok(scene) => json!({ "result": scene.check().to_json() }),
            Err(error) => json!({
                "error": {"kind": "scene", "message": error.to_string(), "at": error.to_json()},
            }),
        };
        answer.to_string().into_bytes()
    })
}

/// The version of the library.
#[unsafe(no_mangle)]
pub extern "C" fn passivity_version() -> *const c_char {
    VERSION.as_ptr()
}

/// Releases a string that one of the functions gave.
///
/// # Safety
///
/// `answer` is null, or came from a function of this library and was not released before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_free(answer: *mut c_char) {
    if !answer.is_null() {
        // SAFETY: it came from `CString::into_raw`.
        drop(unsafe { CString::from_raw(answer) });
    }
}
