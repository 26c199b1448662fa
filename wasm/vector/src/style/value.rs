//! Custom properties, and values with `var()`.
//!
//! A scope holds the custom properties that an element declares, and inherits the others. A property is resolved when
//! it is first asked for. Cost: the length of the result; [`Effort`] bounds the sum.

use std::{
    cell::{Cell, RefCell},
    collections::HashMap,
    rc::Rc,
};

use cssparser::{ParseError, Parser, Token};

/// Longest value of a property, in bytes. Properties that double one another would grow without end.
const MOST_BYTES: usize = 1 << 16;
/// Custom properties that refer to one another in a row.
const MOST_STEPS: u32 = 50;

/// Steps that are left for the styles of a drawing.
#[derive(Debug)]
pub(super) struct Effort(Cell<u64>);

impl Effort {
    pub(super) fn new(steps: u64) -> Self {
        Self(Cell::new(steps))
    }

    /// Takes steps. Returns whether there were enough.
    pub(super) fn take(&self, steps: u64) -> bool {
        self.0.set(self.0.get().saturating_sub(steps));
        self.0.get() > 0
    }

    pub(super) fn is_spent(&self) -> bool {
        self.0.get() == 0
    }
}

/// The custom properties of an element.
#[derive(Debug, Default)]
pub(super) struct Scope {
    own: RefCell<HashMap<Rc<str>, Custom>>,
    parent: Option<Rc<Scope>>,
}

#[derive(Debug, Clone)]
enum Custom {
    Raw(Rc<str>),
    /// It is being resolved: a property that refers to itself has no value.
    Busy,
    Known(Option<Rc<str>>),
}

impl Scope {
    /// The scope of an element, which is its parent's unless it declares custom properties.
    pub(super) fn within(parent: &Rc<Self>, declared: HashMap<Rc<str>, Rc<str>>) -> Rc<Self> {
        if declared.is_empty() {
            return Rc::clone(parent);
        }
        let own = declared.into_iter().map(|(name, raw)| (name, Custom::Raw(raw))).collect();
        Rc::new(Self { own: RefCell::new(own), parent: Some(Rc::clone(parent)) })
    }

    /// The value of a property with the values of custom properties. `None` if one has no value and no fallback.
    pub(super) fn resolved(&self, value: &str, effort: &Effort) -> Option<String> {
        self.substituted(value, effort, MOST_STEPS)
    }

    fn substituted(&self, value: &str, effort: &Effort, steps: u32) -> Option<String> {
        let mut text = String::new();
        let filled = self.fill(&mut Parser::new(value), &mut text, effort, steps);
        filled.ok().map(|()| text.trim().to_owned())
    }

    fn fill(
        &self,
        input: &mut Parser<'_>,
        text: &mut String,
        effort: &Effort,
        steps: u32,
    ) -> Result<(), ParseError<()>> {
        loop {
            if text.len() > MOST_BYTES || !effort.take(1) {
                return Err(ParseError::custom(()));
            }
            let start = input.position();
            let Ok(token) = input.next_including_whitespace() else { return Ok(()) };
            let closing = match token {
                Token::Function(name) if name.eq_ignore_ascii_case("var") => {
                    input.parse_nested_block(|input| self.variable(input, text, effort, steps))?;
                    continue;
                }
                Token::Function(_) | Token::ParenthesisBlock => ")",
                Token::SquareBracketBlock => "]",
                Token::CurlyBracketBlock => "}",
                _ => "",
            };
            text.push_str(input.slice_from(start));
            if !closing.is_empty() {
                input.parse_nested_block(|input| self.fill(input, text, effort, steps))?;
                text.push_str(closing);
            }
        }
    }

    /// Writes the value of `var()`, given the content of its parentheses.
    fn variable(
        &self,
        input: &mut Parser<'_>,
        text: &mut String,
        effort: &Effort,
        steps: u32,
    ) -> Result<(), ParseError<()>> {
        let name = input.expect_ident_cloned()?;
        let has_fallback = input.try_parse(Parser::expect_comma).is_ok();
        // Spaces keep tokens apart.
        text.push(' ');
        if let Some(value) = self.custom(&name, effort, steps) {
            effort.take(value.len() as u64);
            text.push_str(&value);
            while input.next().is_ok() {}
        } else if has_fallback {
            self.fill(input, text, effort, steps)?;
        } else {
            return Err(ParseError::custom(()));
        }
        text.push(' ');
        Ok(())
    }

    /// The value of a custom property.
    fn custom(&self, name: &str, effort: &Effort, steps: u32) -> Option<Rc<str>> {
        let mut scope = self;
        loop {
            effort.take(1);
            let known = scope.own.borrow().get(name).cloned();
            match known {
                Some(Custom::Known(value)) => return value,
                Some(Custom::Busy) => return None,
                Some(Custom::Raw(raw)) => return scope.resolve(name, &raw, effort, steps),
                None => scope = scope.parent.as_ref()?,
            }
        }
    }

    fn resolve(&self, name: &str, raw: &str, effort: &Effort, steps: u32) -> Option<Rc<str>> {
        let set = |state: Custom| self.own.borrow_mut().insert(name.into(), state);
        set(Custom::Busy);
        let value = match &*raw.trim().to_ascii_lowercase() {
            "initial" => None,
            "inherit" | "unset" | "revert" | "revert-layer" => self.parent.as_ref()?.custom(name, effort, steps),
            _ if steps == 0 => None,
            _ => self.substituted(raw, effort, steps - 1).map(Rc::from),
        };
        set(Custom::Known(value.clone()));
        value
    }
}

/// Whether a value refers to custom properties.
pub(super) fn has_variables(value: &str) -> bool {
    value.as_bytes().windows(4).any(|part| part.eq_ignore_ascii_case(b"var("))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scope(parent: &Rc<Scope>, declared: &[(&str, &str)]) -> Rc<Scope> {
        Scope::within(parent, declared.iter().map(|&(name, value)| (name.into(), value.into())).collect())
    }

    #[test]
    fn variables_are_inherited_and_have_fallbacks() {
        let effort = Effort::new(10_000);
        let root = scope(&Rc::default(), &[("--a", "#123"), ("--b", "var(--a)"), ("--part", "20 90")]);
        let inner = scope(&root, &[("--a", "red")]);
        let resolved = |value: &str| inner.resolved(value, &effort);
        assert_eq!(resolved("var(--a)").as_deref(), Some("red"));
        assert_eq!(resolved("var( --b )").as_deref(), Some("#123"));
        assert_eq!(resolved("rgb(var(--part) 7)").as_deref(), Some("rgb( 20 90  7)"));
        assert_eq!(resolved("var(--none, var(--b, 1))").as_deref(), Some("#123"));
        assert_eq!(resolved("var(--none, rgb(1, 2, 3))").as_deref(), Some("rgb(1, 2, 3)"));
        assert_eq!(resolved("var(--none)"), None);
        assert_eq!(resolved("var(--none,)").as_deref(), Some(""));
    }

    #[test]
    fn variables_that_refer_to_themselves_have_no_value() {
        let effort = Effort::new(10_000);
        let root = scope(&Rc::default(), &[("--a", "var(--b)"), ("--b", "var(--a)"), ("--c", "initial")]);
        assert_eq!(root.resolved("var(--a, 4)", &effort).as_deref(), Some("4"));
        assert_eq!(root.resolved("var(--c, 5)", &effort).as_deref(), Some("5"));
    }

    #[test]
    fn variables_that_double_one_another_end() {
        let doubling = |at: usize| (format!("--a{}", at + 1), format!("var(--a{at}) var(--a{at})"));
        let mut declared: Vec<_> = (0..40).map(doubling).collect();
        declared.push(("--a0".to_owned(), "red".to_owned()));
        let declared: Vec<_> = declared.iter().map(|(name, value)| (&**name, &**value)).collect();
        let root = scope(&Rc::default(), &declared);
        assert_eq!(root.resolved("var(--a40)", &Effort::new(10_000_000)), None);
        assert_eq!(root.resolved("var(--a3)", &Effort::new(10)), None);
    }
}
