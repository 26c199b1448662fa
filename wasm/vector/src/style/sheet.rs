//! Style sheets: rules in the order of the file, with the conditions of `@media` decided.

use std::{collections::HashMap, rc::Rc};

use cssparser::{
    AtRuleParser, CowRcStr, DeclarationParser, ParseError, Parser, ParserState, QualifiedRuleParser,
    RuleBodyItemParser, RuleBodyParser, StyleSheetParser, Token,
};
use selectors::parser::Selector;
use usvg::roxmltree::{Document, Node};

use super::selector::{Key, Matcher, Svg, key, selectors};
use crate::remark::{Remark, Remarks};

/// A declaration, such as `fill: red`.
#[derive(Debug, Clone)]
pub(super) struct Declaration {
    /// In lower case, except for custom properties.
    pub(super) name: Rc<str>,
    pub(super) value: Rc<str>,
    pub(super) is_important: bool,
}

#[derive(Debug)]
struct Rule {
    selector: Selector<Svg>,
    declarations: Rc<[Declaration]>,
}

/// All rules of a drawing.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    rules: Vec<Rule>,
    by_key: HashMap<Key, Vec<usize>>,
}

impl Sheet {
    /// The rules of all style sheets in a drawing. Records remarks on those that are left out.
    pub(super) fn of(document: &Document<'_>, remarks: &mut Remarks) -> Self {
        let mut sheet = Self::default();
        let is_css = |node: &Node<'_, '_>| {
            let kind = node.attribute("type").unwrap_or_default();
            node.tag_name().name() == "style" && (kind.is_empty() || kind.eq_ignore_ascii_case("text/css"))
        };
        for node in document.descendants().filter(is_css) {
            let media = node.attribute("media").unwrap_or("all");
            let text: String = node.children().filter_map(|child| child.text()).collect();
            match applies(&mut Parser::new(media)) {
                Some(true) => sheet.read(&mut Parser::new(&text), remarks),
                Some(false) => {}
                None => remarks.note(Remark::rules(&format!("@media {media}"))),
            }
        }
        sheet
    }

    fn read(&mut self, input: &mut Parser<'_>, remarks: &mut Remarks) {
        let mut reader = RuleReader { sheet: self, remarks };
        for _ in StyleSheetParser::new(input, &mut reader) {}
    }

    fn add(&mut self, selectors: Vec<Selector<Svg>>, declarations: &Rc<[Declaration]>) {
        for selector in selectors {
            self.by_key.entry(key(&selector)).or_default().push(self.rules.len());
            self.rules.push(Rule { selector, declarations: Rc::clone(declarations) });
        }
    }

    /// The declarations for an element, in ascending order of precedence.
    pub(super) fn matching(&self, node: Node<'_, '_>, matcher: &mut Matcher<'_>) -> Vec<&Declaration> {
        let id = node.attribute("id").map(|id| Key::Id(id.into()));
        let classes = node.attribute("class").unwrap_or_default().split_ascii_whitespace();
        let classes = classes.map(|class| Key::Class(class.into()));
        let keys = [Key::Any, Key::Tag(node.tag_name().name().into())].into_iter().chain(id).chain(classes);
        let mut found: Vec<usize> = keys.filter_map(|key| self.by_key.get(&key)).flatten().copied().collect();
        // A class may be named twice.
        found.sort_unstable();
        found.dedup();
        found.retain(|&at| matcher.matches(&self.rules[at].selector, node));
        found.sort_by_key(|&at| self.rules[at].selector.specificity());
        found.iter().flat_map(|&at| self.rules[at].declarations.iter()).collect()
    }
}

/// The declarations in a `style` attribute.
pub(super) fn declarations(text: &str) -> Vec<Declaration> {
    RuleBodyParser::new(&mut Parser::new(text), &mut Body).flatten().flatten().collect()
}

struct RuleReader<'a> {
    sheet: &'a mut Sheet,
    remarks: &'a mut Remarks,
}

type Parsed<T> = Result<T, ParseError<()>>;

impl<'i> QualifiedRuleParser<'i> for RuleReader<'_> {
    type Prelude = Vec<Selector<Svg>>;
    type QualifiedRule = ();
    type Error = ();

    fn parse_prelude(&mut self, input: &mut Parser<'i>) -> Parsed<Self::Prelude> {
        let start = input.position();
        let read = selectors(input);
        while input.next().is_ok() {}
        let text = input.slice_from(start).trim();
        // Shapes do not have pseudo-elements such as `::before`.
        if read.is_none() && !text.contains("::") {
            self.remarks.note(Remark::rules(text));
        }
        Ok(read.unwrap_or_default())
    }

    fn parse_block(
        &mut self,
        selectors: Self::Prelude,
        _: &ParserState,
        input: &mut Parser<'i>,
    ) -> Parsed<Self::QualifiedRule> {
        let mut declarations = Vec::new();
        for item in RuleBodyParser::new(input, &mut Body) {
            match item {
                Ok(Some(declaration)) => declarations.push(declaration),
                Ok(None) => {}
                Err((_, text, _)) => {
                    if let Some((selectors, _)) = text.split_once('{') {
                        self.remarks.note(Remark::rules(selectors.trim()));
                    }
                }
            }
        }
        self.sheet.add(selectors, &declarations.into());
        Ok(())
    }
}

impl<'i> AtRuleParser<'i> for RuleReader<'_> {
    /// Whether the block is read.
    type Prelude = bool;
    type AtRule = ();
    type Error = ();

    fn parse_prelude(&mut self, name: CowRcStr<'i>, input: &mut Parser<'i>) -> Parsed<Self::Prelude> {
        let start = input.position();
        let name = name.to_ascii_lowercase();
        let applies = match &*name {
            "media" => applies(input),
            // Remarks on loading and fonts are recorded elsewhere. The others change nothing that is drawn.
            "charset" | "import" | "font-face" | "namespace" | "page" => Some(false),
            "keyframes" | "-webkit-keyframes" => {
                self.remarks.note(Remark::Animations);
                Some(false)
            }
            _ => None,
        };
        while input.next().is_ok() {}
        if applies.is_none() {
            self.remarks.note(Remark::rules(&format!("@{name} {}", input.slice_from(start).trim())));
        }
        Ok(applies == Some(true))
    }

    fn rule_without_block(&mut self, _: bool, _: &ParserState) -> Result<(), ()> {
        Ok(())
    }

    fn parse_block(&mut self, is_read: bool, _: &ParserState, input: &mut Parser<'i>) -> Parsed<()> {
        if is_read {
            self.sheet.read(input, self.remarks);
        }
        while input.next().is_ok() {}
        Ok(())
    }
}

/// The declarations of a rule. Nested rules are left out.
struct Body;

impl<'i> DeclarationParser<'i> for Body {
    type Declaration = Option<Declaration>;
    type Error = ();

    fn parse_value(
        &mut self,
        name: CowRcStr<'i>,
        input: &mut Parser<'i>,
        _: &ParserState,
    ) -> Parsed<Self::Declaration> {
        let start = input.position();
        while let Ok(token) = input.next() {
            // A nested rule.
            if *token == Token::CurlyBracketBlock {
                return Err(ParseError::custom(()));
            }
        }
        let text = without_comments(input.slice_from(start));
        let (value, is_important) = match text.rsplit_once('!') {
            Some((value, word)) if word.trim().eq_ignore_ascii_case("important") => (value, true),
            _ => (&*text, false),
        };
        let name: Rc<str> = if name.starts_with("--") { (&*name).into() } else { name.to_ascii_lowercase().into() };
        Ok(Some(Declaration { name, value: value.trim().into(), is_important }))
    }
}

impl<'i> AtRuleParser<'i> for Body {
    type Prelude = ();
    type AtRule = Option<Declaration>;
    type Error = ();
}

impl<'i> QualifiedRuleParser<'i> for Body {
    type Prelude = ();
    type QualifiedRule = Option<Declaration>;
    type Error = ();
}

impl RuleBodyItemParser<'_, Option<Declaration>, ()> for Body {
    fn parse_declarations(&self) -> bool {
        true
    }

    fn parse_qualified(&self) -> bool {
        true
    }
}

fn without_comments(value: &str) -> String {
    let mut parts = value.split("/*");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        text.push(' ');
        text.push_str(part.split_once("*/").map_or("", |(_, rest)| rest));
    }
    text
}

/// Whether a list of media queries applies to a picture on a screen. `None` if that depends on the screen.
fn applies(input: &mut Parser<'_>) -> Option<bool> {
    if input.is_exhausted() {
        return Some(true);
    }
    let queries: Parsed<Vec<Option<bool>>> = input.parse_comma_separated(|input| Ok(query_applies(input)));
    any(&queries.ok()?)
}

fn query_applies(input: &mut Parser<'_>) -> Option<bool> {
    let is_negated = input.try_parse(|input| input.expect_ident_matching("not")).is_ok();
    let _ = input.try_parse(|input| input.expect_ident_matching("only"));
    let kind = input.try_parse(Parser::expect_ident_cloned).ok();
    let has_features = !input.is_exhausted();
    while input.next().is_ok() {}
    let is_shown =
        ["all", "screen"].iter().any(|shown| kind.as_ref().is_some_and(|kind| kind.eq_ignore_ascii_case(shown)));
    let applies = match kind {
        Some(_) if !is_shown => Some(false),
        Some(_) if !has_features => Some(true),
        _ => None,
    };
    applies.map(|applies| applies != is_negated)
}

/// Whether a condition holds. `None` if that depends on an unknown one.
fn any(conditions: &[Option<bool>]) -> Option<bool> {
    if conditions.contains(&Some(true)) { Some(true) } else { (!conditions.contains(&None)).then_some(false) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn media_types_are_decided_and_features_of_screens_are_unknown() {
        for (media, expected) in [
            ("", Some(true)),
            ("screen", Some(true)),
            ("only ALL", Some(true)),
            ("print, screen", Some(true)),
            ("print", Some(false)),
            ("not print", Some(true)),
            ("not screen", Some(false)),
            ("print and (color)", Some(false)),
            ("(prefers-color-scheme: dark)", None),
            ("screen and (min-width: 9px)", None),
            ("print, (hover)", None),
        ] {
            assert_eq!(applies(&mut Parser::new(media)), expected, "{media}");
        }
    }

    #[test]
    fn declarations_keep_functions_without_comments() {
        let declared =
            declarations("FILL: rgb(1 2 3/4%) !important; --A:x /* y */ z; stroke-width:2; {bad};stroke:red");
        let found: Vec<_> = declared.iter().map(|one| (&*one.name, &*one.value, one.is_important)).collect();
        let expected = [
            ("fill", "rgb(1 2 3/4%)", true),
            ("--A", "x   z", false),
            ("stroke-width", "2", false),
            ("stroke", "red", false),
        ];
        assert_eq!(found, expected);
    }
}
