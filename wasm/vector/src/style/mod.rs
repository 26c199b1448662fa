//! Converts the styles of a drawing to attributes that usvg reads.
//!
//! usvg supports few selectors and colours, and no custom properties or conditions. It silently replaces unknown
//! values. So styles are resolved first, by CSS Cascade 4, Custom Properties 1 and Color 4. Other styles are left out
//! with remarks.
//!
//! - `sheet`: rules and conditions. `selector`: matching elements. `property`: values as usvg reads them.
//!   `value`: custom properties. `color`: colours.
//!
//! Cost: each element is compared with the rules for its tag, id or classes. [`EFFORT`] bounds the sum.
//! Known limits: nested rules, and rules in layers, are left out.

mod color;
mod property;
mod selector;
mod sheet;
mod value;

use std::{
    collections::{BTreeMap, HashMap},
    rc::Rc,
};

use usvg::roxmltree::{Document, Node, NodeId};

use self::{
    property::{Kind, Known, has_geometry, known, longhands, read},
    selector::Matcher,
    sheet::{Declaration, Sheet, declarations},
    value::{Effort, Scope, has_variables},
};
use crate::{
    burden::MAX_ELEMENTS,
    error::VectorError,
    remark::{Remark, Remarks},
    xml::Xml,
};

const SVG: &str = "http://www.w3.org/2000/svg";
const XLINK: &str = "http://www.w3.org/1999/xlink";
const XML: &str = "http://www.w3.org/XML/1998/namespace";

/// Maximum number of steps for matching selectors and substituting values: a few seconds.
const EFFORT: u64 = 100_000_000;
/// Longest side of a matrix of a filter.
const MOST_ORDER: f64 = 255.0;

/// Writes a drawing with all styles as attributes. Records remarks on those that are left out.
///
/// # Errors
/// For styles that take too long, and for too many copies of used elements.
pub(crate) fn resolved(document: &Document<'_>, remarks: &mut Remarks) -> Result<String, VectorError> {
    let effort = Effort::new(EFFORT);
    let text = document.input_text();
    let mut pass = Pass {
        sheet: Sheet::of(document, remarks),
        matcher: Matcher::new(document.descendants().count(), &effort),
        effort: &effort,
        remarks,
        by_id: first_by_id(document),
        // Used elements inherit from their `<use>`.
        depends_on_use: has_variables(text) || text.contains("color-mix("),
        has_dashes: text.contains("dasharray"),
        surroundings: HashMap::new(),
        copies: HashMap::new(),
        copied: Vec::new(),
        written: 0,
    };
    let mut xml = Xml::in_one_line();
    pass.element(&mut xml, document.root_element(), &Surroundings::default(), Place::default())?;
    Ok(xml.into_text())
}

/// The inherited values that other values depend on.
#[derive(Debug, Clone)]
struct Surroundings {
    scope: Rc<Scope>,
    color: Rc<str>,
}

impl Default for Surroundings {
    fn default() -> Self {
        Self { scope: Rc::default(), color: "#000000".into() }
    }
}

impl Surroundings {
    fn is_same(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.scope, &other.scope) && self.color == other.color
    }
}

/// Where an element is written.
#[derive(Debug, Clone, Copy, Default)]
struct Place<'p> {
    is_in_text: bool,
    /// A copy of an element for one `<use>`. Only its root keeps an id.
    is_copy: bool,
    name: Option<&'p str>,
}

struct Pass<'a, 'input, 'e> {
    sheet: Sheet,
    matcher: Matcher<'e>,
    effort: &'e Effort,
    remarks: &'e mut Remarks,
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    depends_on_use: bool,
    has_dashes: bool,
    /// The surroundings of the children of elements at their position in the file.
    surroundings: HashMap<NodeId, Surroundings>,
    /// Names of copies by element and surroundings.
    copies: HashMap<(NodeId, *const Scope, Rc<str>), String>,
    /// What is copied, in the order of writing. Kept, because the address of its scope identifies a copy.
    copied: Vec<(Node<'a, 'input>, Surroundings, String)>,
    written: u32,
}

impl<'a, 'input> Pass<'a, 'input, '_> {
    fn element(
        &mut self,
        xml: &mut Xml,
        node: Node<'a, 'input>,
        inherited: &Surroundings,
        place: Place<'_>,
    ) -> Result<(), VectorError> {
        let tag = node.tag_name().name();
        if !is_drawn(node) {
            return Ok(());
        }
        self.written += 1;
        if self.written > MAX_ELEMENTS {
            return Err(VectorError::TooManyElements { most: MAX_ELEMENTS });
        }
        let (own, styles) = self.styles(node, inherited);
        if self.effort.is_spent() {
            return Err(VectorError::TooManyStyles);
        }
        if !place.is_copy {
            self.surroundings.insert(node.id(), own.clone());
        }
        xml.open(tag);
        let is_root = node.parent_element().is_none();
        if is_root {
            xml.attribute("xmlns", SVG);
            xml.attribute("xmlns:xlink", XLINK);
        }
        if let Some(name) = place.name {
            xml.attribute("id", name);
        }
        for attribute in node.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            let prefix = match attribute.namespace() {
                None => "",
                Some(XLINK) => "xlink:",
                Some(XML) => "xml:",
                Some(_) => continue,
            };
            let is_left_out = matches!(name, "style" | "class") || (name == "id" && place.is_copy);
            let is_style = styles.contains_key(name) || is_presentation(name, value);
            if is_left_out || is_style || name.starts_with("on") {
                continue;
            }
            let copy = if tag == "use" && name == "href" { self.copy_in(value, &own) } else { None };
            xml.attribute(&format!("{prefix}{name}"), copy.as_deref().unwrap_or(bounded(name, value)));
        }
        let mut declared = String::new();
        for (name, value) in styles.iter().filter(|(_, value)| !value.is_empty()) {
            // usvg only reads these as styles.
            if matches!(&**name, "mix-blend-mode" | "isolation" | "font-kerning" | "image-rendering") {
                declared += &format!("{name}:{value};");
            } else {
                xml.attribute(name, value);
            }
        }
        if !declared.is_empty() {
            xml.attribute("style", declared);
        }
        let is_in_text = place.is_in_text || tag == "text";
        for child in node.children() {
            if child.is_element() {
                self.element(xml, child, &own, Place { is_in_text, is_copy: place.is_copy, name: None })?;
            } else if is_in_text && child.is_text() {
                xml.text(child.text().unwrap_or_default());
            }
        }
        if is_root {
            xml.open("defs");
            let mut at = 0;
            while let Some((node, surroundings, name)) = self.copied.get(at).cloned() {
                let place = Place { is_copy: true, name: Some(&name), ..Place::default() };
                self.element(xml, node, &surroundings, place)?;
                at += 1;
            }
            xml.close("defs");
        }
        xml.close(tag);
        Ok(())
    }

    /// The address of a copy of a used element, if the copy inherits other values than the element itself.
    fn copy_in(&mut self, address: &str, surroundings: &Surroundings) -> Option<String> {
        let target = *self.by_id.get(address.trim().strip_prefix('#')?)?;
        if !self.depends_on_use || self.surroundings_of(target.parent_element()?).is_same(surroundings) {
            return None;
        }
        let key = (target.id(), Rc::as_ptr(&surroundings.scope), Rc::clone(&surroundings.color));
        let mut names = (self.copies.len()..).map(|at| format!("c2warp-use-{at}"));
        let name = self.copies.entry(key).or_insert_with(|| {
            let name = names.find(|name| !self.by_id.contains_key(&**name)).expect("there are always more names");
            self.copied.push((target, surroundings.clone(), name.clone()));
            name
        });
        Some(format!("#{name}"))
    }

    /// The values that children of an element inherit.
    fn surroundings_of(&mut self, node: Node<'a, 'input>) -> Surroundings {
        if let Some(known) = self.surroundings.get(&node.id()) {
            return known.clone();
        }
        let inherited = node.parent_element().map_or_else(Surroundings::default, |parent| self.surroundings_of(parent));
        let (own, _) = self.styles(node, &inherited);
        self.surroundings.insert(node.id(), own.clone());
        own
    }

    /// The properties of an element by their names, and the values that its children inherit. Properties with an empty
    /// value are left out, so that they are inherited or initial.
    fn styles(
        &mut self,
        node: Node<'a, 'input>,
        inherited: &Surroundings,
    ) -> (Surroundings, BTreeMap<Rc<str>, String>) {
        let declared = self.declared(node);
        let custom = declared.iter().filter(|one| one.name.starts_with("--"));
        let custom = custom.map(|one| (Rc::clone(&one.name), Rc::clone(&one.value))).collect();
        let mut own = Surroundings { scope: Scope::within(&inherited.scope, custom), ..inherited.clone() };
        let mut styles = BTreeMap::new();
        // `color-mix()` in other properties may need the value of `color`.
        for wants_color in [true, false] {
            for one in declared.iter().filter(|one| (&*one.name == "color") == wants_color) {
                self.effort.take(1 + one.value.len() as u64 / 8);
                self.declare(node, one, &own, &mut styles);
            }
            if let Some(color) = styles.get("color").filter(|color| color.starts_with('#')) {
                own.color = (&**color).into();
            }
        }
        if self.has_dashes && node.has_attribute("pathLength") {
            self.remarks.note(Remark::Property("pathLength".to_owned()));
        }
        (own, styles)
    }

    /// The declarations for an element, in ascending order of precedence.
    fn declared(&mut self, node: Node<'a, 'input>) -> Vec<Declaration> {
        let attributes = node.attributes().filter(|attribute| attribute.namespace().is_none());
        let mut declared: Vec<Declaration> = attributes
            .filter(|attribute| is_presentation(attribute.name(), attribute.value()))
            .map(|attribute| {
                let (name, value) = (attribute.name().into(), attribute.value().trim().into());
                Declaration { name, value, is_important: false }
            })
            .collect();
        declared.extend(self.sheet.matching(node, &mut self.matcher).into_iter().cloned());
        declared.extend(node.attribute("style").map(declarations).unwrap_or_default());
        declared.sort_by_key(|one| one.is_important);
        declared
    }

    fn declare(
        &mut self,
        node: Node<'_, '_>,
        one: &Declaration,
        own: &Surroundings,
        styles: &mut BTreeMap<Rc<str>, String>,
    ) {
        let Declaration { name, value, .. } = one;
        let depends = has_variables(value);
        let filled = if depends { own.scope.resolved(value, self.effort) } else { Some((**value).to_owned()) };
        let Some(filled) = filled else {
            if !is_template(node) {
                self.remarks.note(Remark::value(name, value));
            }
            // As CSS specifies: the property does not fall back to the next declaration.
            styles.insert(Rc::clone(name), String::new());
            return;
        };
        for (name, filled) in longhands(name, &filled).unwrap_or_else(|| vec![(&**name, filled)]) {
            match known(name, &filled) {
                Known::Read(Kind::Geometry) if !has_geometry(node.tag_name().name(), name) => {}
                Known::Read(kind) => {
                    let text = read(name, kind, &filled, &own.color);
                    if text.is_none() {
                        self.remarks.note(Remark::value(name, value));
                    }
                    if text.is_some() || depends {
                        styles.insert(name.into(), text.unwrap_or_default());
                    }
                }
                Known::Unsupported => self.remarks.note(Remark::Property(name.to_owned())),
                Known::Unknown if matches!(name, "animation" | "animation-name") && filled != "none" => {
                    self.remarks.note(Remark::Animations);
                }
                Known::Unknown => {}
            }
        }
    }
}

/// Elements by their names. If several have the same name, uses refer to the first.
fn first_by_id<'a, 'input>(document: &'a Document<'input>) -> HashMap<&'a str, Node<'a, 'input>> {
    let mut by_id = HashMap::new();
    for (id, node) in document.descendants().filter_map(|node| Some((node.attribute("id")?, node))) {
        by_id.entry(id).or_insert(node);
    }
    by_id
}

/// Whether an SVG attribute is also a CSS property. Sizes of shapes stay attributes.
fn is_presentation(name: &str, value: &str) -> bool {
    match known(name, value) {
        Known::Read(kind) => kind != Kind::Geometry,
        Known::Unsupported => matches!(name, "vector-effect" | "color-interpolation"),
        Known::Unknown => false,
    }
}

/// Whether usvg reads an element and its content.
fn is_drawn(node: Node<'_, '_>) -> bool {
    let tag = node.tag_name();
    matches!(tag.namespace(), None | Some(SVG)) && !matches!(tag.name(), "style" | "script" | "foreignObject")
}

/// Whether an element is drawn only through `<use>`, which may set its custom properties.
fn is_template(node: Node<'_, '_>) -> bool {
    const DEFINITIONS: &str = "symbol defs linearGradient radialGradient pattern mask clipPath marker filter";
    let is_definition = |tag: &&str| DEFINITIONS.split(' ').any(|known| known == *tag);
    let nearest = node.ancestors().map(|node| node.tag_name().name()).find(is_definition);
    matches!(nearest, Some("symbol" | "defs"))
}

/// The value of an attribute. Orders of matrices would overflow in usvg. Browsers do not draw larger ones either.
fn bounded<'v>(name: &str, value: &'v str) -> &'v str {
    let is_beyond = |number: &str| number.parse::<f64>().is_ok_and(|order| order > MOST_ORDER);
    if name == "order" && value.split([' ', ',']).any(is_beyond) { "255" } else { value }
}
