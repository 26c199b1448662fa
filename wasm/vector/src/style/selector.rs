//! Matches selectors with Servo's `selectors` crate. A still picture has no mouse pointer or focus, so `:hover` and
//! similar pseudo-classes match nothing.

use std::{borrow::Borrow, fmt};

use cssparser::{ParseError, Parser, ToCss, serialize_identifier};
use precomputed_hash::PrecomputedHash;
use selectors::{
    Element, OpaqueElement, SelectorImpl, SelectorList,
    attr::{AttrSelectorOperation, CaseSensitivity, NamespaceConstraint},
    bloom::BloomFilter,
    context::{MatchingContext, MatchingForInvalidation, MatchingMode, NeedsSelectorFlags, QuirksMode, SelectorCaches},
    matching::{ElementSelectorFlags, matches_selector},
    parser::{Component, NonTSPseudoClass, ParseRelative, PseudoElement, Selector, SelectorParseErrorKind},
};
use usvg::roxmltree::Node;

use super::value::Effort;

/// The syntax of selectors.
#[derive(Debug, Clone)]
pub(super) struct Svg;

/// A name or a value in a selector.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash)]
pub(super) struct Word(Box<str>);

impl From<&str> for Word {
    fn from(text: &str) -> Self {
        Self(text.into())
    }
}

impl AsRef<str> for Word {
    fn as_ref(&self) -> &str {
        &self.0
    }
}

impl Borrow<str> for Word {
    fn borrow(&self) -> &str {
        &self.0
    }
}

impl PrecomputedHash for Word {
    /// Only Bloom filters use hashes, and [`Matcher`] has no Bloom filter.
    fn precomputed_hash(&self) -> u32 {
        0
    }
}

impl ToCss for Word {
    fn to_css<W: fmt::Write>(&self, dest: &mut W) -> fmt::Result {
        serialize_identifier(&self.0, dest)
    }
}

/// A pseudo-class that matches nothing in a picture, such as `:hover`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Live(Box<str>);

impl ToCss for Live {
    fn to_css<W: fmt::Write>(&self, dest: &mut W) -> fmt::Result {
        write!(dest, ":{}", self.0)
    }
}

impl NonTSPseudoClass for Live {
    fn is_active_or_hover(&self) -> bool {
        false
    }

    fn is_user_action_state(&self) -> bool {
        false
    }
}

/// A pseudo-element. Shapes do not have any.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Never {}

impl ToCss for Never {
    fn to_css<W: fmt::Write>(&self, _: &mut W) -> fmt::Result {
        match *self {}
    }
}

impl PseudoElement for Never {}

impl SelectorImpl for Svg {
    type ExtraMatchingData<'a> = ();
    type AttrValue = Word;
    type Identifier = Word;
    type LocalName = Word;
    type NamespaceUrl = Word;
    type NamespacePrefix = Word;
    type BorrowedNamespaceUrl = str;
    type BorrowedLocalName = str;
    type NonTSPseudoClass = Live;
    type PseudoElement = Never;
}

struct Reader;

/// Pseudo-classes of links, pointers, focus and controls.
const LIVE: &str =
    "active any-link checked disabled enabled focus focus-visible focus-within hover link target visited";

impl<'i> selectors::Parser<'i> for Reader {
    type Impl = Svg;
    type Error = SelectorParseErrorKind;

    fn parse_is_and_where(&self) -> bool {
        true
    }

    fn parse_non_ts_pseudo_class(&self, name: &str) -> Result<Live, ParseError<Self::Error>> {
        if !LIVE.split(' ').any(|known| name.eq_ignore_ascii_case(known)) {
            return Err(ParseError::custom(SelectorParseErrorKind::UnsupportedPseudoClassOrElement));
        }
        Ok(Live(name.into()))
    }

    /// Elements of other namespaces are left out anyway.
    fn namespace_for_prefix(&self, _: &Word) -> Option<Word> {
        Some(super::SVG.into())
    }
}

/// Parses the selectors of a rule. `None` if one is invalid or not supported.
pub(super) fn selectors(input: &mut Parser<'_>) -> Option<Vec<Selector<Svg>>> {
    let list = SelectorList::parse(&Reader, input, ParseRelative::No).ok()?;
    Some(list.slice().to_vec())
}

/// A quick test of an element before the full one.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Key {
    Id(Box<str>),
    Class(Box<str>),
    Tag(Box<str>),
    Any,
}

pub(super) fn key(selector: &Selector<Svg>) -> Key {
    let keys = selector.iter().filter_map(|component| match component {
        Component::ID(id) => Some(Key::Id(id.0.clone())),
        Component::Class(class) => Some(Key::Class(class.0.clone())),
        Component::LocalName(tag) => Some(Key::Tag(tag.name.0.clone())),
        _ => None,
    });
    keys.min_by_key(|key| match key {
        Key::Id(_) => 0,
        Key::Class(_) => 1,
        _ => 2,
    })
    .unwrap_or(Key::Any)
}

/// Matches elements of one document.
pub(super) struct Matcher<'e> {
    effort: &'e Effort,
    /// A place for each node, as the caches of selectors know elements by places.
    places: Vec<u8>,
    caches: SelectorCaches,
}

impl<'e> Matcher<'e> {
    pub(super) fn new(nodes: usize, effort: &'e Effort) -> Self {
        Self { effort, places: vec![0; nodes], caches: SelectorCaches::default() }
    }

    pub(super) fn matches(&mut self, selector: &Selector<Svg>, node: Node<'_, '_>) -> bool {
        let mut context = MatchingContext::new(
            MatchingMode::Normal,
            None,
            &mut self.caches,
            QuirksMode::NoQuirks,
            NeedsSelectorFlags::No,
            MatchingForInvalidation::No,
        );
        let element = Styled { node, effort: self.effort, places: &self.places };
        matches_selector(selector, 0, None, element, &mut context)
    }
}

/// An element whose tests count as effort.
#[derive(Clone, Copy, Debug)]
struct Styled<'a, 'input> {
    node: Node<'a, 'input>,
    effort: &'a Effort,
    places: &'a [u8],
}

impl Styled<'_, '_> {
    fn has(&self, name: &str, test: impl Fn(&str) -> bool) -> bool {
        self.effort.take(1);
        self.node
            .attributes()
            .any(|attribute| attribute.namespace().is_none() && attribute.name() == name && test(attribute.value()))
    }
}

impl Element for Styled<'_, '_> {
    type Impl = Svg;

    fn opaque(&self) -> OpaqueElement {
        OpaqueElement::new(&self.places[self.node.id().get_usize()])
    }

    fn parent_element(&self) -> Option<Self> {
        self.effort.take(1).then(|| self.node.parent_element())?.map(|node| Self { node, ..*self })
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.effort.take(1).then(|| self.node.prev_sibling_element())?.map(|node| Self { node, ..*self })
    }

    fn next_sibling_element(&self) -> Option<Self> {
        self.effort.take(1).then(|| self.node.next_sibling_element())?.map(|node| Self { node, ..*self })
    }

    fn first_element_child(&self) -> Option<Self> {
        self.node.first_element_child().map(|node| Self { node, ..*self })
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.effort.take(1);
        self.node.tag_name().name() == name
    }

    fn has_namespace(&self, _: &str) -> bool {
        true
    }

    fn is_same_type(&self, other: &Self) -> bool {
        self.node.tag_name() == other.node.tag_name()
    }

    fn attr_matches(
        &self,
        _: &NamespaceConstraint<&Word>,
        name: &Word,
        operation: &AttrSelectorOperation<&Word>,
    ) -> bool {
        self.effort.take(1);
        let mut attributes = self.node.attributes();
        attributes.any(|attribute| attribute.name() == &*name.0 && operation.eval_str(attribute.value()))
    }

    fn match_non_ts_pseudo_class(&self, _: &Live, _: &mut MatchingContext<'_, Svg>) -> bool {
        false
    }

    fn match_pseudo_element(&self, never: &Never, _: &mut MatchingContext<'_, Svg>) -> bool {
        match *never {}
    }

    fn has_id(&self, id: &Word, case: CaseSensitivity) -> bool {
        self.has("id", |value| case.eq(value.as_bytes(), id.0.as_bytes()))
    }

    fn has_class(&self, class: &Word, case: CaseSensitivity) -> bool {
        self.has("class", |value| value.split_ascii_whitespace().any(|one| case.eq(one.as_bytes(), class.0.as_bytes())))
    }

    fn is_empty(&self) -> bool {
        !self.node.children().any(|child| child.is_element() || child.is_text())
    }

    fn is_root(&self) -> bool {
        self.node.parent_element().is_none()
    }

    // A drawing has no HTML, no shadow trees, no links to follow and no parts.

    fn is_html_element_in_html_document(&self) -> bool {
        false
    }

    fn is_html_slot_element(&self) -> bool {
        false
    }

    fn is_link(&self) -> bool {
        false
    }

    fn is_pseudo_element(&self) -> bool {
        false
    }

    fn is_part(&self, _: &Word) -> bool {
        false
    }

    fn imported_part(&self, _: &Word) -> Option<Word> {
        None
    }

    fn has_custom_state(&self, _: &Word) -> bool {
        false
    }

    fn parent_node_is_shadow_root(&self) -> bool {
        false
    }

    fn containing_shadow_host(&self) -> Option<Self> {
        None
    }

    fn apply_selector_flags(&self, _: ElementSelectorFlags) {}

    fn add_element_unique_hashes(&self, _: &mut BloomFilter) -> bool {
        false
    }
}
