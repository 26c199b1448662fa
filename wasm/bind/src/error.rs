//! Errors as JavaScript knows them: an `Error` whose message is fit to show, with a `code` for programs.

use js_sys::{Error as JsError, Reflect};
use wasm_bindgen::JsValue;

pub(crate) fn to_js(error: &c2warp::Error) -> JsValue {
    with_code(&error.to_string(), error.code())
}

pub(crate) fn with_code(message: &str, code: &str) -> JsValue {
    let error = JsError::new(message);
    // A plain object takes every property, so setting one cannot fail.
    let _ = Reflect::set(&error, &"code".into(), &code.into());
    error.into()
}
