//! A drawing, read by usvg into a plain form: paths, groups and definitions. Nothing outside the file is loaded.
//!
//! Sizes are bounded before usvg makes copies of used elements: see [`Burden`].

use std::collections::HashMap;
#[cfg(feature = "text")]
use std::collections::HashSet;
#[cfg(feature = "text")]
use std::sync::{Arc, Mutex};

use c2warp::limits::MAX_PIXELS;
use usvg::roxmltree::{Document, Error as XmlError, Node, NodeId, ParsingOptions};

use crate::{error::VectorError, remark::Remark};

/// Largest file, in bytes.
pub const MAX_BYTES: usize = 64 << 20;
/// Most elements and texts, with a copy for each use.
const MAX_ELEMENTS: u32 = 250_000;
/// Deepest nesting, through uses as well: usvg recurses.
const MAX_DEPTH: usize = 200;
/// Characters of a text in a remark.
const TEXT_CHARACTERS: usize = 40;

/// A drawing whose shapes are paths.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// SVG as usvg writes it.
    pub(crate) text: String,
    size: [f64; 2],
    remarks: Vec<Remark>,
}

impl Drawing {
    /// Reads an SVG file. Its texts are left out.
    ///
    /// # Errors
    /// For files that are no drawings, and for drawings that are too large.
    pub fn read(text: &str) -> Result<Self, VectorError> {
        let mut remarks = Vec::new();
        let source = parse(text, &mut remarks)?;
        remarks.extend(texts(&source).map(Remark::Text));
        let tree = usvg::Tree::from_xmltree(&source, &options()).map_err(refused)?;
        Self::new(&tree, remarks)
    }

    /// Reads an SVG file. Its texts become paths by these fonts.
    ///
    /// # Errors
    /// Those of [`read`](Self::read).
    #[cfg(feature = "text")]
    pub fn read_with_fonts(text: &str, fonts: Arc<usvg::fontdb::Database>) -> Result<Self, VectorError> {
        let mut remarks = Vec::new();
        let source = parse(text, &mut remarks)?;
        let replaced = Arc::new(Mutex::new(Vec::new()));
        let mut options = options();
        options.fontdb = fonts;
        options.font_resolver.select_font = telling(Arc::clone(&replaced));
        let tree = usvg::Tree::from_xmltree(&source, &options).map_err(refused)?;
        let mut drawn = HashSet::new();
        note_texts(tree.root(), &mut drawn);
        remarks.extend(texts(&source).filter(|text| !drawn.contains(&compact(text))).map(Remark::Text));
        remarks.extend(replaced.lock().into_iter().flat_map(|mut all| std::mem::take(&mut *all)));
        Self::new(&tree, remarks)
    }

    fn new(tree: &usvg::Tree, mut remarks: Vec<Remark>) -> Result<Self, VectorError> {
        check_pictures(tree.root())?;
        let size = [tree.size().width(), tree.size().height()].map(f64::from);
        let text = tree.to_string(&usvg::WriteOptions { indent: usvg::Indent::None, ..Default::default() });
        if text.contains("<image ") {
            remarks.push(Remark::Pictures);
        }
        Ok(Self { text, size, remarks })
    }

    /// Width and height in its own units.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The drawing at rest, as SVG with shapes as paths and with nothing that needs another file.
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

/// Options under which nothing is loaded: data in the file is all there is.
fn options() -> usvg::Options<'static> {
    let mut options = usvg::Options::default();
    options.image_href_resolver.resolve_string = Box::new(|_, _| None);
    options
}

fn refused(reason: usvg::Error) -> VectorError {
    match reason {
        usvg::Error::InvalidSize => VectorError::NoSize,
        usvg::Error::ElementsLimitReached => VectorError::TooManyElements { most: MAX_ELEMENTS },
        reason => VectorError::Xml(reason.to_string()),
    }
}

/// Refuses a drawing with a picture that has too many pixels to be decoded.
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

/// Parses a file, checks its size, and remarks on all that is left out.
fn parse<'a>(text: &'a str, remarks: &mut Vec<Remark>) -> Result<Document<'a>, VectorError> {
    if text.len() > MAX_BYTES {
        return Err(VectorError::TooLarge { bytes: text.len(), most: MAX_BYTES });
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
    Burden::of(&document).check(root)?;
    note_left_out(&document, remarks);
    Ok(document)
}

/// The elements that usvg makes of an element, with a copy of all that it refers to, and how deeply they are nested.
struct Burden<'a, 'input> {
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    /// Elements, and levels of nesting. `None` while they are counted: the element refers to itself.
    known: HashMap<NodeId, Option<(u64, usize)>>,
}

impl<'a, 'input> Burden<'a, 'input> {
    fn of(document: &'a Document<'input>) -> Self {
        let by_id = document.descendants().filter_map(|node| Some((node.attribute("id")?, node))).collect();
        Self { by_id, known: HashMap::new() }
    }

    fn check(mut self, root: Node<'a, 'input>) -> Result<(), VectorError> {
        let (elements, _) = self.count(root, 0)?;
        if elements > u64::from(MAX_ELEMENTS) {
            return Err(VectorError::TooManyElements { most: MAX_ELEMENTS });
        }
        Ok(())
    }

    fn count(&mut self, node: Node<'a, 'input>, level: usize) -> Result<(u64, usize), VectorError> {
        let too_deep = VectorError::TooDeep { most: MAX_DEPTH };
        match self.known.get(&node.id()) {
            Some(&Some((elements, height))) if level + height <= MAX_DEPTH => return Ok((elements, height)),
            Some(Some(_)) => return Err(too_deep),
            // usvg leaves such elements out.
            Some(None) => return Ok((0, 0)),
            None => {}
        }
        if level > MAX_DEPTH {
            return Err(too_deep);
        }
        self.known.insert(node.id(), None);
        let (mut elements, mut height) = (1_u64, 0);
        let mut add = |(more, below): (u64, usize), times: u64| {
            elements = elements.saturating_add(more.saturating_mul(times));
            height = height.max(below + 1);
        };
        for child in node.children().filter(Node::is_element) {
            add(self.count(child, level + 1)?, 1);
        }
        for attribute in node.attributes() {
            for id in references(attribute.name(), attribute.value()) {
                let Some(&target) = self.by_id.get(id) else { continue };
                // A marker is drawn at every node of a path.
                let is_marker = target.tag_name().name() == "marker";
                let nodes = node.attribute("d").or(node.attribute("points")).map_or(2, |text| text.len() as u64 / 2);
                add(self.count(target, level + 1)?, if is_marker { nodes } else { 1 });
            }
        }
        self.known.insert(node.id(), Some((elements, height)));
        Ok((elements, height))
    }
}

/// The ids that an attribute refers to.
fn references<'a>(name: &str, value: &'a str) -> Vec<&'a str> {
    if name == "href" {
        return value.strip_prefix('#').into_iter().collect();
    }
    let after_each = value.split("url(").skip(1);
    after_each
        .filter_map(|rest| {
            rest.trim_start_matches(['"', '\'', ' ']).strip_prefix('#')?.split([')', '"', '\'', ' ']).next()
        })
        .collect()
}

/// Remarks on all that usvg leaves out but text.
fn note_left_out(document: &Document<'_>, remarks: &mut Vec<Remark>) {
    let mut note = |remark: Remark| {
        if !remarks.contains(&remark) {
            remarks.push(remark);
        }
    };
    for node in document.descendants().filter(Node::is_element) {
        match node.tag_name().name() {
            "script" => note(Remark::Scripts),
            "animate" | "animateMotion" | "animateTransform" | "animateColor" | "set" => note(Remark::Animations),
            "foreignObject" | "iframe" | "video" | "audio" | "canvas" => note(Remark::Foreign),
            "style" if node.text().is_some_and(|text| text.contains("@import") || text.contains("@font-face")) => {
                note(Remark::External("@import or @font-face".to_owned()));
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

/// A text without white space, as white space counts little in SVG.
#[cfg(feature = "text")]
fn compact(text: &str) -> String {
    text.split_whitespace().collect()
}

/// Notes the beginnings of the texts that became paths.
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

/// Selects fonts as usvg does, and notes those that take the place of others.
#[cfg(feature = "text")]
fn telling(replaced: Arc<Mutex<Vec<Remark>>>) -> usvg::FontSelectionFn<'static> {
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
            let remark = Remark::Font { wanted: wanted.join(", ").replace('"', ""), used };
            if let Ok(mut replaced) = replaced.lock()
                && !replaced.contains(&remark)
            {
                replaced.push(remark);
            }
        }
        Some(id)
    })
}
