//! A drawing, simplified by usvg to paths, groups and definitions. Nothing outside the file is loaded.
//!
//! Sizes are bounded before usvg makes copies of used elements: see [`Burden`].

#[cfg(feature = "text")]
use std::collections::HashSet;
use std::sync::{Arc, Mutex, PoisonError};

use c2warp::limits::MAX_PIXELS;
use usvg::{
    ImageKind,
    roxmltree::{Document, Error as XmlError, Node, ParsingOptions},
};

use crate::{
    burden::{Burden, MAX_DEPTH, MAX_ELEMENTS},
    error::VectorError,
    remark::{Remark, Remarks},
    style,
};

/// Largest file, in bytes.
pub const MAX_BYTES: usize = 64 << 20;
/// Maximum number of attributes of an element, because parsing them takes quadratic time.
const MAX_ATTRIBUTES: usize = 256;
/// Greatest nesting depth of embedded drawings.
const MAX_PICTURE_DEPTH: u32 = 5;
/// Maximum size of the pictures in a drawing in bytes, counting a copy for each use.
const MAX_PICTURE_BYTES: usize = 256 << 20;
/// Maximum number of characters of a text in a remark.
const TEXT_CHARACTERS: usize = 40;

/// A drawing whose shapes are paths.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// SVG as usvg writes it.
    pub(crate) text: String,
    size: [f64; 2],
    pub(crate) tree: usvg::Tree,
    pub(crate) burden: Burden,
    remarks: Vec<Remark>,
}

impl Drawing {
    /// Reads an SVG file. Texts are left out.
    ///
    /// # Errors
    /// For files that are not drawings, and for drawings that are too large.
    pub fn read(text: &str) -> Result<Self, VectorError> {
        Self::read_by(text, &Reader::default())
    }

    /// Reads an SVG file. Texts become paths, using these fonts.
    ///
    /// # Errors
    /// The errors of [`read`](Self::read).
    #[cfg(feature = "text")]
    pub fn read_with_fonts(text: &str, fonts: Arc<usvg::fontdb::Database>) -> Result<Self, VectorError> {
        Self::read_by(text, &Reader { fonts: Some(fonts), ..Reader::default() })
    }

    fn read_by(text: &str, reader: &Reader) -> Result<Self, VectorError> {
        let (tree, burden) = reader.read(text, MAX_PICTURE_DEPTH)?;
        check_pictures(tree.root())?;
        let size = [tree.size().width(), tree.size().height()].map(f64::from);
        let text = tree.to_string(&usvg::WriteOptions { indent: usvg::Indent::None, ..Default::default() });
        if text.contains("<image ") {
            reader.note(Remark::Pictures);
        }
        let remarks = reader.with(|notes| notes.remarks.all().to_vec());
        Ok(Self { text, size, tree, burden, remarks })
    }

    /// Width and height in its own units.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The drawing at rest, as SVG with shapes as paths and without references to other files.
    #[must_use]
    pub fn plain_svg(&self) -> &str {
        &self.text
    }

    /// Parts that are left out or do not bend.
    #[must_use]
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}

/// Reads a drawing and the drawings in its pictures.
#[derive(Debug, Clone, Default)]
struct Reader {
    notes: Arc<Mutex<Notes>>,
    #[cfg(feature = "text")]
    fonts: Option<Arc<usvg::fontdb::Database>>,
}

/// Remarks and counts for the whole file.
#[derive(Debug, Default)]
struct Notes {
    remarks: Remarks,
    picture_bytes: usize,
    elements: u64,
    /// The reason for rejecting a picture in the drawing, and therefore the drawing.
    refusal: Option<VectorError>,
}

impl Reader {
    fn with<T>(&self, act: impl FnOnce(&mut Notes) -> T) -> T {
        act(&mut self.notes.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn note(&self, remark: Remark) {
        self.with(|notes| notes.remarks.note(remark));
    }

    /// Reads a drawing, or one that it embeds. `depth` is the number of further levels that may be embedded.
    fn read(&self, text: &str, depth: u32) -> Result<(usvg::Tree, Burden), VectorError> {
        let source = parsed(text)?;
        // Pictures are in elements that are nested already.
        let most_depth = MAX_DEPTH >> (MAX_PICTURE_DEPTH - depth);
        // Resolving styles recurses. It also adds references, so the result is counted again.
        Burden::of(&source, most_depth)?;
        let text = self.with(|notes| {
            note_left_out(&source, &mut notes.remarks);
            style::resolved(&source, &mut notes.remarks)
        })?;
        let document = parsed(&text)?;
        let burden = Burden::of(&document, most_depth)?;
        let elements = self.with(|notes| {
            notes.elements += burden.elements;
            notes.elements
        });
        if elements > u64::from(MAX_ELEMENTS) {
            return Err(VectorError::TooManyElements { most: MAX_ELEMENTS });
        }
        let tree = usvg::Tree::from_xmltree(&document, &self.options(depth)).map_err(refused)?;
        if let Some(refusal) = self.with(|notes| notes.refusal.take()) {
            return Err(refusal);
        }
        #[cfg(feature = "text")]
        let drawn = {
            let mut drawn = HashSet::new();
            note_texts(tree.root(), &mut drawn);
            drawn
        };
        for text in texts(&source) {
            #[cfg(feature = "text")]
            if drawn.contains(&compact(&text)) {
                continue;
            }
            self.note(Remark::Text(text));
        }
        Ok((tree, burden))
    }

    /// Options that prevent loading: only data in the file is used.
    fn options(&self, depth: u32) -> usvg::Options<'static> {
        let mut options = usvg::Options::default();
        #[cfg(feature = "text")]
        if let Some(fonts) = &self.fonts {
            options.fontdb = Arc::clone(fonts);
            options.font_resolver.select_font = font_selector(self.clone());
        }
        options.image_href_resolver.resolve_string = Box::new(|_, _| None);
        let known = usvg::ImageHrefResolver::default_data_resolver();
        let reader = self.clone();
        options.image_href_resolver.resolve_data = Box::new(move |kind, data, options| {
            let is_refused = reader.with(|notes| {
                notes.picture_bytes = notes.picture_bytes.saturating_add(data.len());
                if notes.picture_bytes > MAX_PICTURE_BYTES {
                    notes.refusal = Some(VectorError::TooManyCopies);
                }
                notes.refusal.is_some()
            });
            let is_drawing = kind == "image/svg+xml" || (kind == "text/plain" && data.first() == Some(&b'<'));
            let picture = match is_drawing {
                _ if is_refused => return None,
                true => reader.nested(&data, depth),
                false => known(kind, data, options),
            };
            if picture.is_none() {
                reader.note(Remark::Picture);
            }
            picture
        });
        options
    }

    /// Reads a drawing that another one embeds as a picture.
    fn nested(&self, data: &[u8], depth: u32) -> Option<ImageKind> {
        let text = std::str::from_utf8(data).ok().filter(|_| depth > 0)?;
        match self.read(text, depth - 1) {
            Ok((tree, _)) => Some(ImageKind::SVG(tree)),
            // Browsers leave these out as well.
            Err(VectorError::Xml(_) | VectorError::Root(_) | VectorError::NoSize) => None,
            Err(refusal) => {
                self.with(|notes| notes.refusal = Some(refusal));
                None
            }
        }
    }
}

fn refused(reason: usvg::Error) -> VectorError {
    match reason {
        usvg::Error::InvalidSize => VectorError::NoSize,
        usvg::Error::ElementsLimitReached => VectorError::TooManyElements { most: MAX_ELEMENTS },
        reason => VectorError::Xml(reason.to_string()),
    }
}

/// Rejects a drawing that contains a picture with too many pixels.
fn check_pictures(group: &usvg::Group) -> Result<(), VectorError> {
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => check_pictures(group)?,
            usvg::Node::Image(image) => match image.kind() {
                usvg::ImageKind::SVG(tree) => check_pictures(tree.root())?,
                _ if image.size().width() * image.size().height() > MAX_PIXELS as f32 => {
                    return Err(VectorError::PictureTooLarge { most: MAX_PIXELS / 1_000_000 });
                }
                _ => {}
            },
            _ => {}
        }
        let mut within = Ok(());
        node.subroots(|root| {
            if within.is_ok() {
                within = check_pictures(root);
            }
        });
        within?;
    }
    Ok(())
}

/// Parses a file, and checks its size.
fn parsed(text: &str) -> Result<Document<'_>, VectorError> {
    if text.len() > MAX_BYTES {
        return Err(VectorError::TooLarge { most: MAX_BYTES });
    }
    if most_attributes(text) > MAX_ATTRIBUTES {
        return Err(VectorError::TooManyAttributes { most: MAX_ATTRIBUTES });
    }
    let limits = ParsingOptions { allow_dtd: true, nodes_limit: MAX_ELEMENTS, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, limits).map_err(|reason| match reason {
        XmlError::NodesLimitReached => VectorError::TooManyElements { most: MAX_ELEMENTS },
        reason => VectorError::Xml(reason.to_string()),
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(VectorError::Root(root.tag_name().name().chars().take(TEXT_CHARACTERS).collect()));
    }
    Ok(document)
}

/// The greatest number of attributes of an element, or of an entity, which may contain elements.
fn most_attributes(text: &str) -> usize {
    let mut rest = text;
    let mut most = 0;
    while let Some(at) = rest.find('<') {
        rest = &rest[at + 1..];
        let skipped = [("!--", "-->"), ("![CDATA[", "]]>"), ("?", "?>")].into_iter();
        if let Some((_, end)) = skipped.into_iter().find(|(start, _)| rest.starts_with(start)) {
            rest = rest.find(end).map_or("", |at| &rest[at + end.len()..]);
            continue;
        }
        // The text of an entity may contain elements.
        let is_declaration = rest.starts_with('!');
        let (mut quote, mut count, mut end) = (None, 0, rest.len());
        for (at, byte) in rest.bytes().enumerate() {
            match (byte, quote) {
                (b'=', _) if is_declaration => count += 1,
                (b'=', None) => count += 1,
                (b'>', None) => {
                    end = at;
                    break;
                }
                // Entities follow.
                (b'[', None) if is_declaration => {
                    end = at;
                    break;
                }
                (b'"' | b'\'', None) => quote = Some(byte),
                (byte, Some(open)) if byte == open => quote = None,
                _ => {}
            }
        }
        most = most.max(count);
        rest = &rest[end..];
    }
    most
}

/// Records remarks on everything that usvg leaves out, except text.
fn note_left_out(document: &Document<'_>, remarks: &mut Remarks) {
    let mut note = |remark: Remark| remarks.note(remark);
    for sheet in document.root().children().filter_map(|node| node.pi()).filter(|pi| pi.target == "xml-stylesheet") {
        note(Remark::External(sheet.value.unwrap_or_default().chars().take(TEXT_CHARACTERS).collect()));
    }
    for node in document.descendants().filter(Node::is_element) {
        match node.tag_name().name() {
            "script" => note(Remark::Scripts),
            "animate" | "animateMotion" | "animateTransform" | "animateColor" | "set" => note(Remark::Animations),
            "foreignObject" | "iframe" | "video" | "audio" | "canvas" => note(Remark::Foreign),
            "style" => {
                for rule in ["@import", "@font-face"] {
                    if node.children().filter_map(|child| child.text()).any(|text| text.contains(rule)) {
                        note(Remark::External(rule.to_owned()));
                    }
                }
            }
            _ => {}
        }
        for attribute in node.attributes() {
            if attribute.name().len() > 2 && attribute.name().starts_with("on") {
                note(Remark::Scripts);
            }
            let is_link = node.tag_name().name() == "a";
            let address = attribute.value().trim();
            if attribute.name() == "href" && !is_link && !address.starts_with('#') && !is_data(address) {
                note(Remark::External(address.chars().take(TEXT_CHARACTERS).collect()));
            }
        }
    }
}

fn is_data(address: &str) -> bool {
    address.get(..5).is_some_and(|scheme| scheme.eq_ignore_ascii_case("data:"))
}

/// The texts of a drawing, shortened.
fn texts<'a>(document: &'a Document<'_>) -> impl Iterator<Item = String> + 'a {
    let elements = document.descendants().filter(|node| node.is_element() && node.tag_name().name() == "text");
    elements.filter_map(|node| {
        let text: String = node.descendants().filter(Node::is_text).filter_map(|node| node.text()).collect();
        let words: Vec<&str> = text.split_whitespace().collect();
        Some(words.join(" ").chars().take(TEXT_CHARACTERS).collect::<String>()).filter(|text| !text.is_empty())
    })
}

/// A text without white space, because SVG mostly ignores it.
#[cfg(feature = "text")]
fn compact(text: &str) -> String {
    text.split_whitespace().collect()
}

/// Records the beginnings of texts that became paths.
#[cfg(feature = "text")]
fn note_texts(group: &usvg::Group, drawn: &mut HashSet<String>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => note_texts(group, drawn),
            usvg::Node::Text(text) => {
                let whole: String = text.chunks().iter().map(usvg::TextChunk::text).collect();
                let words: Vec<&str> = whole.split_whitespace().collect();
                drawn.insert(compact(&words.join(" ").chars().take(TEXT_CHARACTERS).collect::<String>()));
            }
            _ => {}
        }
        node.subroots(|root| note_texts(root, drawn));
    }
}

/// Selects fonts as usvg does, and records substitutions.
#[cfg(feature = "text")]
fn font_selector(reader: Reader) -> usvg::FontSelectionFn<'static> {
    let select = usvg::FontResolver::default_font_selector();
    Box::new(move |font, fonts| {
        let id = select(font, fonts)?;
        let used = fonts.face(id)?.families.first()?.0.clone();
        let named = |family: &usvg::FontFamily| matches!(family, usvg::FontFamily::Named(_));
        let is_wanted = |family: &usvg::FontFamily| match family {
            usvg::FontFamily::Named(name) => name.eq_ignore_ascii_case(&used),
            _ => true,
        };
        if font.families().iter().any(named) && !font.families().iter().any(is_wanted) {
            let wanted: Vec<String> = font.families().iter().map(ToString::to_string).collect();
            reader.note(Remark::Font { wanted: wanted.join(", ").replace('"', ""), used });
        }
        Some(id)
    })
}
