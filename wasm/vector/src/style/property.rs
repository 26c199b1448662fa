//! The properties of a drawing, and their values as usvg reads them.
//!
//! usvg takes values that it cannot read for initial ones, without a word. So every value is read here first, by the
//! parsers that usvg has.

use cssparser::{ParseError, Parser, Token};
use svgtypes::{FilterValueListParser, FuncIRI, Length, LengthListParser, LengthUnit, Paint, TransformListParser};

use super::color::with_hex;

/// The syntax of a property's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Paint,
    Color,
    /// A number or a percentage.
    Share,
    Number,
    Length,
    Lengths,
    /// One of these words.
    Word(&'static [&'static str]),
    /// A reference.
    Link,
    Filter,
    Transform,
    Origin,
    /// It matters to texts, or is a hint.
    Any,
    /// An attribute in SVG 1.1, and a property since.
    Geometry,
    /// The data of a path.
    Path,
}

use Kind::{Any, Color, Filter, Geometry, Length as OneLength, Lengths, Link, Number, Origin, Share, Transform, Word};

/// A property that usvg reads.
#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: &'static str,
    pub(super) kind: Kind,
    /// The initial value of an inherited property.
    pub(super) inherited: Option<&'static str>,
}

const fn inherited(name: &'static str, kind: Kind, initial: &'static str) -> Property {
    Property { name, kind, inherited: Some(initial) }
}

const fn own(name: &'static str, kind: Kind) -> Property {
    Property { name, kind, inherited: None }
}

const RULES: Kind = Word(&["nonzero", "evenodd"]);
const BLENDS: Kind = Word(&[
    "normal",
    "multiply",
    "screen",
    "overlay",
    "darken",
    "lighten",
    "color-dodge",
    "color-burn",
    "hard-light",
    "soft-light",
    "difference",
    "exclusion",
    "hue",
    "saturation",
    "color",
    "luminosity",
    "plus-lighter",
]);

const PROPERTIES: &[Property] = &[
    inherited("fill", Kind::Paint, "black"),
    inherited("stroke", Kind::Paint, "none"),
    inherited("color", Color, "black"),
    own("stop-color", Color),
    own("flood-color", Color),
    own("lighting-color", Color),
    own("background-color", Color),
    own("opacity", Share),
    inherited("fill-opacity", Share, "1"),
    inherited("stroke-opacity", Share, "1"),
    own("stop-opacity", Share),
    own("flood-opacity", Share),
    inherited("stroke-width", OneLength, "1"),
    inherited("stroke-dasharray", Lengths, "none"),
    inherited("stroke-dashoffset", OneLength, "0"),
    inherited("stroke-miterlimit", Number, "4"),
    inherited("stroke-linecap", Word(&["butt", "round", "square"]), "butt"),
    inherited("stroke-linejoin", Word(&["miter", "miter-clip", "round", "bevel"]), "miter"),
    inherited("fill-rule", RULES, "nonzero"),
    inherited("clip-rule", RULES, "nonzero"),
    inherited("visibility", Word(&["visible", "hidden", "collapse"]), "visible"),
    own("display", Any),
    own("overflow", Any),
    own("mask-type", Word(&["luminance", "alpha"])),
    own("mix-blend-mode", BLENDS),
    own("isolation", Word(&["auto", "isolate"])),
    inherited("paint-order", Any, "normal"),
    inherited("shape-rendering", Any, "auto"),
    inherited("image-rendering", Any, "auto"),
    inherited("text-rendering", Any, "auto"),
    inherited("color-interpolation-filters", Word(&["sRGB", "linearRGB", "auto"]), "linearRGB"),
    own("clip-path", Link),
    own("mask", Link),
    inherited("marker-start", Link, "none"),
    inherited("marker-mid", Link, "none"),
    inherited("marker-end", Link, "none"),
    own("filter", Filter),
    own("transform", Transform),
    own("transform-origin", Origin),
    inherited("font-family", Any, "serif"),
    inherited("font-size", Any, "medium"),
    inherited("font-style", Any, "normal"),
    inherited("font-weight", Any, "normal"),
    inherited("font-stretch", Any, "normal"),
    inherited("font-variant", Any, "normal"),
    inherited("font-kerning", Any, "auto"),
    inherited("font-size-adjust", Any, "none"),
    inherited("font-variation-settings", Any, "normal"),
    inherited("font-optical-sizing", Any, "auto"),
    inherited("letter-spacing", Any, "normal"),
    inherited("word-spacing", Any, "normal"),
    inherited("text-anchor", Any, "start"),
    own("text-decoration", Any),
    own("dominant-baseline", Any),
    own("alignment-baseline", Any),
    own("baseline-shift", Any),
    inherited("direction", Any, "ltr"),
    own("unicode-bidi", Any),
    inherited("writing-mode", Any, "lr-tb"),
    inherited("white-space", Any, "normal"),
    own("cx", Geometry),
    own("cy", Geometry),
    own("r", Geometry),
    own("rx", Geometry),
    own("ry", Geometry),
    own("x", Geometry),
    own("y", Geometry),
    own("width", Geometry),
    own("height", Geometry),
    own("d", Kind::Path),
];

/// Properties that browsers draw and usvg does not know, with the values that change nothing. Those of text and of
/// boxes of HTML are left out: they change no shape.
const UNSUPPORTED: &[(&str, &[&str])] = &[
    ("all", &[]),
    ("backdrop-filter", &["none"]),
    ("background", &["none", "transparent"]),
    ("background-image", &["none"]),
    ("color-interpolation", &["auto", "srgb"]),
    ("mask-border", &["none"]),
    ("mask-border-source", &["none"]),
    ("mask-clip", &["border-box"]),
    ("mask-composite", &["add"]),
    ("mask-image", &["none"]),
    ("mask-mode", &["match-source"]),
    ("offset", &["none"]),
    ("offset-path", &["none"]),
    ("rotate", &["none"]),
    ("scale", &["none"]),
    ("transform-box", &["view-box"]),
    ("translate", &["none"]),
    ("vector-effect", &["none"]),
    ("zoom", &["1", "normal"]),
    ("-webkit-mask", &["none"]),
    ("-webkit-mask-image", &["none"]),
];

/// How a property by this name is known.
#[derive(Debug)]
pub(super) enum Known {
    Read(&'static Property),
    /// It changes the drawing, and is left out.
    Unsupported(&'static str),
    /// It changes nothing that is drawn.
    Unknown,
}

/// Looks up a property with its value.
pub(super) fn known(name: &str, value: &str) -> Known {
    if let Some(property) = PROPERTIES.iter().find(|property| property.name == name) {
        return Known::Read(property);
    }
    let found = UNSUPPORTED.iter().find(|(known, _)| *known == name);
    let changing = found.filter(|(_, neutral)| !neutral.iter().any(|word| value.eq_ignore_ascii_case(word)));
    changing.map_or(Known::Unknown, |&(name, _)| Known::Unsupported(name))
}

/// A shorthand as the properties that it sets.
pub(super) fn longhands(name: &str, value: &str) -> Option<Vec<(&'static str, String)>> {
    let all = |names: &[&'static str]| Some(names.iter().map(|&name| (name, value.to_owned())).collect());
    match name {
        "marker" => all(&["marker-start", "marker-mid", "marker-end"]),
        "background" if with_hex(value, "#000").is_some_and(|hex| hex.starts_with('#') && !hex.contains(' ')) => {
            all(&["background-color"])
        }
        "font" => {
            let font = svgtypes::FontShorthand::from_str(value).ok()?;
            let part = |name, part: Option<&str>| (name, part.unwrap_or("normal").to_owned());
            Some(vec![
                part("font-style", font.font_style),
                part("font-variant", font.font_variant),
                part("font-weight", font.font_weight),
                part("font-stretch", font.font_stretch),
                part("font-size", Some(font.font_size)),
                part("font-family", Some(font.font_family)),
            ])
        }
        _ => None,
    }
}

/// Whether a geometry property applies to an element.
pub(super) fn has_geometry(tag: &str, name: &str) -> bool {
    match name {
        "cx" | "cy" => matches!(tag, "circle" | "ellipse"),
        "r" => tag == "circle",
        "rx" | "ry" => matches!(tag, "rect" | "ellipse"),
        "x" | "y" | "width" | "height" => matches!(tag, "rect" | "image" | "use"),
        "d" => tag == "path",
        _ => false,
    }
}

impl Property {
    /// A value as usvg reads it, given the colour for `currentColor` in mixes. `None` if it cannot be read.
    pub(super) fn read(&self, value: &str, is_attribute: bool, current: &str) -> Option<String> {
        let lower = value.to_ascii_lowercase();
        match &*lower {
            "inherit" => return Some(lower),
            // The attribute is left out: see `is_unset`.
            "initial" => return Some(self.inherited.unwrap_or_default().to_owned()),
            "unset" | "revert" | "revert-layer" => return Some(String::new()),
            _ => {}
        }
        let checked = |text: String, is_read: bool| is_read.then_some(text);
        match self.kind {
            Kind::Paint | Color => {
                let text = spelled(&with_links(&with_hex(value, current)?)?);
                let paint = Paint::from_str(&text).ok();
                let fits = match paint? {
                    Paint::Color(_) | Paint::CurrentColor => true,
                    _ => self.kind == Kind::Paint,
                };
                checked(text, fits)
            }
            Share => {
                let share: Length = lower.parse().ok()?;
                checked(lower, matches!(share.unit, LengthUnit::None | LengthUnit::Percent))
            }
            Number => {
                let is_read = lower.parse::<f64>().is_ok_and(f64::is_finite);
                checked(lower, is_read)
            }
            Geometry if lower == "auto" => Some(String::new()),
            OneLength | Geometry => {
                let is_read = lower.parse::<Length>().is_ok();
                checked(lower, is_read)
            }
            Lengths => {
                let is_read = lower == "none" || LengthListParser::from(&*lower).all(|length| length.is_ok());
                checked(lower, is_read)
            }
            Word(words) => words.iter().find(|word| word.eq_ignore_ascii_case(value)).map(|&word| word.to_owned()),
            Link => {
                let text = with_links(value)?;
                let is_read = lower == "none" || FuncIRI::from_str(&text).is_ok();
                checked(if lower == "none" { lower } else { text }, is_read)
            }
            Filter => {
                if lower == "none" {
                    return Some(lower);
                }
                let text = with_links(&with_hex(value, current)?)?;
                let is_read = FilterValueListParser::from(&*text).all(|value| value.is_ok());
                checked(text, is_read)
            }
            Transform if is_attribute && lower != "none" => {
                let is_read = TransformListParser::from(value).all(|part| part.is_ok());
                checked(value.to_owned(), is_read)
            }
            Transform => transform(&lower),
            Origin => {
                let is_read = lower.parse::<svgtypes::TransformOrigin>().is_ok();
                checked(lower, is_read)
            }
            Any => Some(value.to_owned()),
            Kind::Path => path(value),
        }
    }
}

/// A paint with the one word whose case usvg cares for.
fn spelled(paint: &str) -> String {
    let words = paint.split(' ').map(|word| match &*word.to_ascii_lowercase() {
        "currentcolor" => "currentColor".to_owned(),
        lower @ ("none" | "context-fill" | "context-stroke") => lower.to_owned(),
        _ => word.to_owned(),
    });
    words.collect::<Vec<_>>().join(" ")
}

/// A value with all references written as `url(#id)`.
fn with_links(value: &str) -> Option<String> {
    let mut input = Parser::new(value);
    let mut text = String::new();
    loop {
        let start = input.state();
        let Ok(token) = input.next_including_whitespace() else { break };
        let is_link = match token {
            Token::UnquotedUrl(_) => true,
            Token::Function(name) => name.eq_ignore_ascii_case("url"),
            _ => false,
        };
        let is_block = matches!(token, Token::Function(_) | Token::ParenthesisBlock);
        if is_link {
            input.reset(&start);
            let address = input.expect_url().ok()?;
            text.push_str(&format!("url({address})"));
        } else if is_block {
            let skipped: Result<(), ParseError<()>> = input.parse_nested_block(|input| {
                while input.next().is_ok() {}
                Ok(())
            });
            skipped.ok()?;
            text.push_str(input.slice_from(start.position()));
        } else {
            text.push_str(input.slice_from(start.position()));
        }
    }
    Some(text.trim().to_owned())
}

/// A transform of CSS as one of SVG.
fn transform(value: &str) -> Option<String> {
    if value == "none" {
        return Some(String::new());
    }
    let mut input = Parser::new(value);
    let mut functions = Vec::new();
    while !input.is_exhausted() {
        let name = input.expect_function().ok()?.to_string();
        let numbers: Result<Vec<f32>, ParseError<()>> =
            input.parse_nested_block(|input| input.parse_comma_separated(plain_number));
        functions.push(svg_function(&name, &numbers.ok()?)?);
    }
    Some(functions.join(" "))
}

fn svg_function(name: &str, numbers: &[f32]) -> Option<String> {
    let listed = |name: &str, numbers: &[f32]| {
        let numbers: Vec<String> = numbers.iter().map(f32::to_string).collect();
        Some(format!("{name}({})", numbers.join(" ")))
    };
    match (name, numbers) {
        ("translate", [_] | [_, _]) | ("scale", [_] | [_, _]) | ("rotate", [_]) => listed(name, numbers),
        ("skewx", &[angle]) | ("skew", &[angle]) => listed("skewX", &[angle]),
        ("skewy", &[angle]) => listed("skewY", &[angle]),
        ("matrix", [_, _, _, _, _, _]) => listed(name, numbers),
        ("translatex", &[x]) => listed("translate", &[x, 0.0]),
        ("translatey", &[y]) => listed("translate", &[0.0, y]),
        ("translate3d", &[x, y, _]) => listed("translate", &[x, y]),
        ("translatez", [_]) => Some(String::new()),
        ("scalex", &[x]) => listed("scale", &[x, 1.0]),
        ("scaley", &[y]) => listed("scale", &[1.0, y]),
        ("scale3d", &[x, y, _]) => listed("scale", &[x, y]),
        ("rotatez", &[angle]) => listed("rotate", &[angle]),
        _ => None,
    }
}

/// A number, a length in pixels, or an angle in degrees.
fn plain_number(input: &mut Parser<'_>) -> Result<f32, ParseError<()>> {
    let number = match input.next()? {
        &Token::Number { value, .. } => value,
        Token::Dimension { value, unit, .. } => {
            let factor = match &**unit {
                "px" | "deg" => 1.0,
                "rad" => 180.0 / std::f32::consts::PI,
                "grad" => 0.9,
                "turn" => 360.0,
                "pt" => 4.0 / 3.0,
                "pc" => 16.0,
                "in" => 96.0,
                "cm" => 96.0 / 2.54,
                "mm" => 96.0 / 25.4,
                "q" => 96.0 / 101.6,
                _ => return Err(ParseError::custom(())),
            };
            value * factor
        }
        _ => return Err(ParseError::custom(())),
    };
    Ok(number)
}

/// The data in `path("…")`.
fn path(value: &str) -> Option<String> {
    if value.eq_ignore_ascii_case("none") {
        return Some(String::new());
    }
    let mut input = Parser::new(value);
    input.expect_function_matching("path").ok()?;
    let data: Result<String, ParseError<()>> =
        input.parse_nested_block(|input| Ok(input.expect_string().map(|data| data.to_string())?));
    data.ok().filter(|_| input.is_exhausted())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, value: &str) -> Option<String> {
        let Known::Read(property) = known(name, value) else { return None };
        property.read(value, false, "#000000")
    }

    #[test]
    fn values_become_what_usvg_reads() {
        for (name, value, expected) in [
            ("fill", "CurrentColor", "currentColor"),
            ("fill", "url( '#a' ) RED", "url(#a) #ff0000"),
            ("stroke", "NONE", "none"),
            ("stop-color", "rgb(1 2 3 / 0)", "#01020300"),
            ("opacity", "50%", "50%"),
            ("stroke-width", "3PX", "3px"),
            ("stroke-dasharray", "1px, 2px", "1px, 2px"),
            ("color-interpolation-filters", "srgb", "sRGB"),
            ("clip-path", "url(\"#a\")", "url(#a)"),
            ("filter", "drop-shadow(1px 2px 3px oklch(0 0 0))", "drop-shadow(1px 2px 3px #000000)"),
            (
                "transform",
                "translate(1px, 2pt) rotate(0.5turn) scaleX(2)",
                "translate(1 2.6666667) rotate(180) scale(2 1)",
            ),
            ("transform", "none", ""),
            ("fill", "initial", "black"),
            ("fill", "unset", ""),
            ("d", "path('M0 0h1')", "M0 0h1"),
        ] {
            assert_eq!(read(name, value).as_deref(), Some(expected), "{name}: {value}");
        }
    }

    #[test]
    fn values_that_usvg_would_replace_are_refused() {
        for (name, value) in [
            ("fill", "light-dark(red, blue)"),
            ("fill", "12"),
            ("stop-color", "none"),
            ("stroke-width", "calc(1px + 2px)"),
            ("stroke-width", "1rem"),
            ("opacity", "50px"),
            ("fill-rule", "winding"),
            ("clip-path", "circle(40%)"),
            ("mask", "linear-gradient(red, blue)"),
            ("filter", "url(#a) glow(2px)"),
            ("transform", "translate(50%, 0)"),
            ("transform", "perspective(3px)"),
        ] {
            assert_eq!(read(name, value), None, "{name}: {value}");
        }
    }

    #[test]
    fn properties_that_change_nothing_are_not_named() {
        assert!(matches!(known("vector-effect", "none"), Known::Unknown));
        assert!(matches!(known("cursor", "pointer"), Known::Unknown));
        assert!(matches!(known("vector-effect", "non-scaling-stroke"), Known::Unsupported("vector-effect")));
    }
}
