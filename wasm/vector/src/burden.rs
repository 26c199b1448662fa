//! The elements that usvg makes of a drawing, counted before it makes them.

use std::collections::HashMap;

use usvg::roxmltree::{Document, Node, NodeId};

use crate::error::VectorError;

/// Most elements and texts, with a copy for each use.
pub(crate) const MAX_ELEMENTS: u32 = 250_000;
/// Deepest nesting, through uses as well: usvg recurses.
pub(crate) const MAX_DEPTH: usize = 200;
/// Most bytes in attributes, with a copy for each use: usvg reads them again for each.
const MAX_COPIED_BYTES: u64 = 512 << 20;
/// Most references of elements to themselves. usvg looks through the drawing again for each.
const MAX_LOOPS: u32 = 100;

/// The work that a drawing makes for usvg.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Burden {
    /// Elements, with a copy for each use.
    pub(crate) elements: u64,
    /// Elements that are there by uses, markers and other references alone.
    pub(crate) copies: u64,
    /// Bytes of attributes, with a copy for each use.
    bytes: u64,
    height: usize,
}

impl Burden {
    /// # Errors
    /// For too many elements, bytes or loops, and for elements that are nested too deeply.
    pub(crate) fn of(document: &Document<'_>, most_depth: usize) -> Result<Self, VectorError> {
        let mut by_id: HashMap<&str, Vec<Node<'_, '_>>> = HashMap::new();
        for (id, node) in document.descendants().filter_map(|node| Some((node.attribute("id")?, node))) {
            by_id.entry(id).or_default().push(node);
        }
        let mut counter = Counter { by_id, known: HashMap::new(), loops: 0, most_depth };
        let burden = counter.count(document.root_element(), 0)?;
        if burden.elements > u64::from(MAX_ELEMENTS) || counter.loops > MAX_LOOPS {
            return Err(VectorError::TooManyElements { most: MAX_ELEMENTS });
        }
        if burden.bytes > MAX_COPIED_BYTES {
            return Err(VectorError::TooManyCopies);
        }
        Ok(burden)
    }

    fn add(&mut self, other: Self, times: u64) {
        self.elements = self.elements.saturating_add(other.elements.saturating_mul(times));
        self.copies = self.copies.saturating_add(other.copies.saturating_mul(times));
        self.bytes = self.bytes.saturating_add(other.bytes.saturating_mul(times));
        self.height = self.height.max(other.height + 1);
    }
}

struct Counter<'a, 'input> {
    /// Of elements with one name, usvg takes the first or the last.
    by_id: HashMap<&'a str, Vec<Node<'a, 'input>>>,
    /// `None` while an element is counted: it refers to itself.
    known: HashMap<NodeId, Option<Burden>>,
    loops: u32,
    most_depth: usize,
}

impl<'a, 'input> Counter<'a, 'input> {
    fn count(&mut self, node: Node<'a, 'input>, level: usize) -> Result<Burden, VectorError> {
        let too_deep = VectorError::TooDeep { most: self.most_depth };
        match self.known.get(&node.id()) {
            Some(&Some(burden)) if level + burden.height <= self.most_depth => return Ok(burden),
            Some(Some(_)) => return Err(too_deep),
            // usvg leaves such elements out.
            Some(None) => {
                self.loops += 1;
                return Ok(Burden::default());
            }
            None => {}
        }
        if level > self.most_depth {
            return Err(too_deep);
        }
        self.known.insert(node.id(), None);
        let mut burden = Burden { elements: 1, ..Burden::default() };
        for child in node.children().filter(Node::is_element) {
            burden.add(self.count(child, level + 1)?, 1);
        }
        let (links, others): (Vec<_>, Vec<_>) = node.attributes().partition(|attribute| attribute.name() == "href");
        // Elements in use inherit from their use, so they are counted first.
        for attribute in links.into_iter().chain(others) {
            burden.bytes = burden.bytes.saturating_add(attribute.value().len() as u64);
            for id in references(attribute.name(), attribute.value()) {
                for target in self.by_id.get(id).cloned().unwrap_or_default() {
                    let times = times_drawn(attribute.name(), node, target, &burden);
                    let used = self.count(target, level + 1)?;
                    burden.add(Burden { copies: used.elements, ..used }, times);
                }
            }
        }
        self.known.insert(node.id(), Some(burden));
        Ok(burden)
    }
}

/// How often usvg makes the target of an attribute. Shapes in a group inherit references.
fn times_drawn(name: &str, node: Node<'_, '_>, target: Node<'_, '_>, burden: &Burden) -> u64 {
    let data = node.attribute("d").or(node.attribute("points"));
    let is_group = data.is_none() && burden.elements > 1;
    match (name, target.tag_name().name()) {
        // At every node of a path.
        (_, "marker") => data.map_or(if is_group { burden.bytes / 2 } else { 2 }, |text| text.len() as u64 / 2),
        ("fill" | "stroke", "pattern") if is_group => burden.elements,
        _ => 1,
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
