//! Films from frames, for JavaScript: a separate module, which a page loads when a film is exported.
//!
//! It runs in a worker. Bytes are taken out after every frame, so memory does not grow with the film.

mod outlet;

use std::fmt;
use std::io;

use c2warp_film::{Apng, Encoder, Film, Gif, GifColours, Plays, Sheet, WebP};
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

use self::outlet::Outlet;

/// The format of a film.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub enum Container {
    /// GIF: 255 colours, and pixels that are either opaque or transparent.
    Gif,
    /// Animated PNG.
    Apng,
    /// Animated WebP, lossless.
    WebP,
    /// A sprite sheet: all frames in one PNG.
    Sheet,
}

/// A film that is being written.
#[wasm_bindgen]
pub struct FilmWriter {
    outlet: Outlet,
    /// `None` after the end.
    encoder: Option<Box<dyn Encoder>>,
    /// The positions of the frames in a sheet.
    json: Option<String>,
}

impl fmt::Debug for FilmWriter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FilmWriter").finish_non_exhaustive()
    }
}

/// Bytes of a film, and their position in the file.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Piece {
    position: u64,
    bytes: Vec<u8>,
}

#[wasm_bindgen]
impl Piece {
    /// The position of the first byte in the file.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn position(&self) -> f64 {
        self.position as f64
    }

    /// The bytes. The bytes can be taken only once.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.bytes)
    }
}

#[wasm_bindgen]
impl FilmWriter {
    /// Begins a film of frames with a width and height in pixels. `rate` is in frames a second.
    ///
    /// A GIF uses the colours of `picture`, in straight RGBA. Its soft edges blend with the colour `matte`, three
    /// bytes, or else are cut at half their alpha. The JSON of a sheet refers to the file `image`, and names the frames
    /// by `name` and their number.
    ///
    /// # Errors
    /// For a film that exceeds the limits of the format.
    #[wasm_bindgen(constructor)]
    #[allow(clippy::too_many_arguments, reason = "wasm-bindgen has no structs of plain values")]
    pub fn new(
        container: Container,
        width: u32,
        height: u32,
        frames: u32,
        rate: f64,
        endlessly: bool,
        picture: &[u8],
        matte: Option<Vec<u8>>,
        image: &str,
        name: &str,
    ) -> Result<Self, JsValue> {
        let plays = if endlessly { Plays::Endlessly } else { Plays::Once };
        let film = Film { width, height, frames, rate, plays, profile: None };
        let outlet = Outlet::default();
        let output = outlet.clone();
        let mut json = None;
        let begun: io::Result<Box<dyn Encoder>> = match container {
            Container::Gif => {
                let matte = matte.and_then(|matte| matte.try_into().ok());
                Gif::new(film, GifColours::new(picture, matte), output).map(|film| Box::new(film) as Box<dyn Encoder>)
            }
            Container::Apng => Apng::new(film, output).map(|film| Box::new(film) as Box<dyn Encoder>),
            Container::WebP => WebP::new(film, output).map(|film| Box::new(film) as Box<dyn Encoder>),
            Container::Sheet => Sheet::new(film, output).map(|sheet| {
                json = Some(sheet.json(image, name));
                Box::new(sheet) as Box<dyn Encoder>
            }),
        };
        let encoder = Some(begun.map_err(|reason| to_js(&reason))?);
        Ok(Self { outlet, encoder, json })
    }

    /// The JSON that belongs to a sheet; `undefined` for other films.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn json(&self) -> Option<String> {
        self.json.clone()
    }

    /// Adds the next frame: straight RGBA, rows from top to bottom.
    ///
    /// # Errors
    /// For a frame of another size, and after the end.
    pub fn add(&mut self, rgba: &[u8]) -> Result<(), JsValue> {
        let encoder = self.encoder.as_mut().ok_or_else(|| JsValue::from(JsError::new("the film has ended")))?;
        encoder.add(rgba).map_err(|reason| to_js(&reason))
    }

    /// Completes the film, after its last frame.
    ///
    /// # Errors
    /// If frames are missing.
    pub fn finish(&mut self) -> Result<(), JsValue> {
        self.encoder.take().map_or(Ok(()), |encoder| encoder.finish().map_err(|reason| to_js(&reason)))
    }

    /// The next bytes that have not been taken; `undefined` if all have. Only the first bytes of a file may be written
    /// after later ones.
    #[wasm_bindgen(js_name = takePiece)]
    pub fn take_piece(&mut self) -> Option<Piece> {
        self.outlet.take().map(|(position, bytes)| Piece { position, bytes })
    }
}

fn to_js(reason: &io::Error) -> JsValue {
    JsError::new(&reason.to_string()).into()
}
