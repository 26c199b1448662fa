//! Errors for JavaScript: an `Error` with a message for people, and a `code` for programs.

use js_sys::{Array, Error as JsError, Reflect};
use wasm_bindgen::JsValue;

/// With the ids of the `handles` that it names.
pub(crate) fn to_js(error: &c2warp::Error) -> JsValue {
    let handles: Array = error.handles().into_iter().map(JsValue::from).collect();
    let js = with_code(&error.to_string(), error.code());
    set(&js, "handles", &handles);
    js
}

pub(crate) fn with_code(message: &str, code: &str) -> JsValue {
    let error = JsError::new(message).into();
    set(&error, "code", &code.into());
    error
}

fn set(object: &JsValue, key: &str, value: &JsValue) {
    // A plain object takes every property, so setting one cannot fail.
    let _ = Reflect::set(object, &key.into(), value);
}
