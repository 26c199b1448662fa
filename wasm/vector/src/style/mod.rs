//! The styles of a drawing as attributes that usvg reads.
//!
//! usvg knows few selectors, no custom properties, no conditions and few colours. It takes unknown values for
//! black or leaves them out, without a word. So all styles are resolved before: CSS Cascade 4, Custom Properties 1, and
//! Color 4 and 5 as far as a picture decides them. The rest is left out with a remark.
//!
//! - `sheet`: rules and conditions. `selector`: their elements. `property`: values as usvg reads them. `value`: custom
//!   properties. `color`: colours.
//!
//! Cost: each element looks at the rules that its tag, id or classes begin; [`EFFORT`] bounds the sum.
//! Known limits: rules in rules and layers are left out.

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
    property::{Kind, Known, has_geometry, known, longhands},
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

/// Steps for matching selectors and substituting values: some seconds.
const EFFORT: u64 = 100_000_000;
/// Octaves of noise that can be seen. Each adds half of the one before.
const MOST_OCTAVES: f64 = 12.0;
/// Longest side of a matrix of a filter. Browsers draw nothing beyond, too.
const MOST_ORDER: f64 = 255.0;

/// Writes a drawing with all styles as attributes. Notes those that are left out.
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
        // Elements in use inherit from where they are used.
        depends_on_use: has_variables(text) || text.contains("color-mix("),
        has_dashes: text.contains("dasharray"),
        surroundings: HashMap::new(),
        copies: HashMap::new(),
        waiting: Vec::new(),
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
    /// A copy for one use: its elements have no names, but for the first.
    is_copy: bool,
    name: Option<&'p str>,
}

/// A copy of an element for other surroundings than its own. These are kept, since the copy is known by their place.
#[derive(Debug, Clone)]
struct Copied {
    name: String,
    surroundings: Surroundings,
}

struct Pass<'a, 'input, 'e> {
    sheet: Sheet,
    matcher: Matcher<'e>,
    effort: &'e Effort,
    remarks: &'e mut Remarks,
    by_id: HashMap<&'a str, Node<'a, 'input>>,
    depends_on_use: bool,
    has_dashes: bool,
    /// Values for the children of elements, where these are in the file.
    surroundings: HashMap<NodeId, Surroundings>,
    /// Names of copies, by the element and the surroundings.
    copies: HashMap<(NodeId, *const Scope, Rc<str>), Copied>,
    /// Copies still to write.
    waiting: Vec<(Node<'a, 'input>, Copied)>,
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
            if is_left_out || styles.contains_key(name) || name.starts_with("on") {
                continue;
            }
            let copy = if tag == "use" && name == "href" { self.copy_in(value, &own) } else { None };
            xml.attribute(&format!("{prefix}{name}"), copy.as_deref().unwrap_or(&bounded(name, value)));
        }
        let mut declared = String::new();
        for (name, value) in styles.iter().filter(|(_, value)| !value.is_empty()) {
            // usvg reads these as styles alone.
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
            while let Some((node, Copied { name, surroundings })) = self.waiting.pop() {
                let place = Place { is_copy: true, name: Some(&name), ..Place::default() };
                self.element(xml, node, &surroundings, place)?;
            }
            xml.close("defs");
        }
        xml.close(tag);
        Ok(())
    }

    /// The name of a copy of a used element that inherits other values than the element itself does. `None` if the
    /// element serves.
    fn copy_in(&mut self, address: &str, surroundings: &Surroundings) -> Option<String> {
        let target = *self.by_id.get(address.trim().strip_prefix('#')?)?;
        if !self.depends_on_use || self.surroundings_of(target.parent_element()?).is_same(surroundings) {
            return None;
        }
        let key = (target.id(), Rc::as_ptr(&surroundings.scope), Rc::clone(&surroundings.color));
        let mut names = (self.copies.len()..).map(|at| format!("c2warp-use-{at}"));
        let copied = self.copies.entry(key).or_insert_with(|| {
            let name = names.find(|name| !self.by_id.contains_key(&**name)).expect("names do not end");
            let copied = Copied { name, surroundings: surroundings.clone() };
            self.waiting.push((target, copied.clone()));
            copied
        });
        Some(format!("#{}", copied.name))
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

    /// The properties of an element by their names, and the values that its children inherit. A property without a
    /// value is left to inherit, or to have its initial value.
    fn styles(
        &mut self,
        node: Node<'a, 'input>,
        inherited: &Surroundings,
    ) -> (Surroundings, BTreeMap<Rc<str>, String>) {
        let declared = self.declared(node);
        let custom = declared.iter().filter(|(_, one)| one.name.starts_with("--"));
        let custom = custom.map(|(_, one)| (Rc::clone(&one.name), Rc::clone(&one.value))).collect();
        let mut own = Surroundings { scope: Scope::within(&inherited.scope, custom), ..inherited.clone() };
        let mut styles = BTreeMap::new();
        // Mixes of other properties need the colour.
        for wants_color in [true, false] {
            for (rank, one) in declared.iter().filter(|(_, one)| (&*one.name == "color") == wants_color) {
                self.effort.take(1 + one.value.len() as u64 / 8);
                self.declare(node, one, *rank == Rank::Attribute, &own, &mut styles);
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

    /// The declarations for an element, those that count more after the others.
    fn declared(&mut self, node: Node<'a, 'input>) -> Vec<(Rank, Declaration)> {
        let attributes = node.attributes().filter(|attribute| attribute.namespace().is_none());
        let mut declared: Vec<(Rank, Declaration)> = attributes
            .filter(|attribute| is_presentation(attribute.name(), attribute.value()))
            .map(|attribute| {
                let (name, value) = (attribute.name().into(), attribute.value().trim().into());
                (Rank::Attribute, Declaration { name, value, is_important: false })
            })
            .collect();
        let ranked = |one: &Declaration, [normal, important]: [Rank; 2]| {
            (if one.is_important { important } else { normal }, one.clone())
        };
        let rules = self.sheet.matching(node, &mut self.matcher);
        declared.extend(rules.into_iter().map(|one| ranked(one, [Rank::Rule, Rank::ImportantRule])));
        let styles = node.attribute("style").map(declarations).unwrap_or_default();
        declared.extend(styles.iter().map(|one| ranked(one, [Rank::Style, Rank::ImportantStyle])));
        declared.sort_by_key(|(rank, _)| *rank);
        declared
    }

    fn declare(
        &mut self,
        node: Node<'_, '_>,
        one: &Declaration,
        is_attribute: bool,
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
            // As CSS wants it: not the value that would count next.
            styles.insert(Rc::clone(name), String::new());
            return;
        };
        for (name, filled) in longhands(name, &filled).unwrap_or_else(|| vec![(&**name, filled)]) {
            match known(name, &filled) {
                Known::Read(property) => {
                    let tag = node.tag_name().name();
                    if matches!(property.kind, Kind::Geometry | Kind::Path) && !has_geometry(tag, name) {
                        continue;
                    }
                    match property.read(&filled, is_attribute, &own.color) {
                        Some(read) => {
                            styles.insert(name.into(), read);
                        }
                        None => {
                            self.remarks.note(Remark::value(name, value));
                            if depends {
                                styles.insert(name.into(), String::new());
                            }
                        }
                    }
                }
                Known::Unsupported(name) => self.remarks.note(Remark::Property(name.to_owned())),
                Known::Unknown if matches!(name, "animation" | "animation-name") && filled != "none" => {
                    self.remarks.note(Remark::Animations);
                }
                Known::Unknown => {}
            }
        }
    }
}

/// Elements by their names. Of several with one name, uses refer to the first.
fn first_by_id<'a, 'input>(document: &'a Document<'input>) -> HashMap<&'a str, Node<'a, 'input>> {
    let mut by_id = HashMap::new();
    for (id, node) in document.descendants().filter_map(|node| Some((node.attribute("id")?, node))) {
        by_id.entry(id).or_insert(node);
    }
    by_id
}

/// How much a declaration counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    Attribute,
    Rule,
    Style,
    ImportantRule,
    ImportantStyle,
}

/// Whether an attribute is a property as well. Those of shapes stay as they are.
fn is_presentation(name: &str, value: &str) -> bool {
    match known(name, value) {
        Known::Read(property) => !matches!(property.kind, Kind::Geometry | Kind::Path),
        Known::Unsupported(name) => matches!(name, "vector-effect" | "color-interpolation"),
        Known::Unknown => false,
    }
}

/// Whether usvg reads an element and those in it.
fn is_drawn(node: Node<'_, '_>) -> bool {
    let tag = node.tag_name();
    matches!(tag.namespace(), None | Some(SVG)) && !matches!(tag.name(), "style" | "script" | "foreignObject")
}

/// Whether an element is only drawn where it is used: there, custom properties may have values.
fn is_template(node: Node<'_, '_>) -> bool {
    let mut within = node.ancestors().map(|node| node.tag_name().name());
    let first = within.find(|tag| {
        matches!(
            *tag,
            "symbol"
                | "defs"
                | "linearGradient"
                | "radialGradient"
                | "pattern"
                | "mask"
                | "clipPath"
                | "marker"
                | "filter"
        )
    });
    matches!(first, Some("symbol" | "defs"))
}

/// The value of an attribute within the bounds that can be seen.
fn bounded(name: &str, value: &str) -> String {
    let numbers = || value.split([' ', ',']).filter_map(|number| number.parse::<f64>().ok());
    match name {
        "numOctaves" if numbers().any(|octaves| octaves > MOST_OCTAVES) => MOST_OCTAVES.to_string(),
        // Without a matrix of this order, the filter draws nothing.
        "order" if numbers().any(|order| order > MOST_ORDER) => MOST_ORDER.to_string(),
        _ => value.to_owned(),
    }
}
