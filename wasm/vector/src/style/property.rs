//! The properties of a drawing, and their values as usvg reads them.
//!
//! usvg silently replaces values that it cannot read by initial ones. So values are parsed here first, with the
//! parsers of usvg.

use std::{collections::HashMap, sync::LazyLock};

use svgtypes::{
    FilterValueListParser, FontShorthand, FuncIRI, Length, LengthListParser, LengthUnit, Paint, TransformListParser,
};

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
    Word(&'static str),
    /// A reference.
    Link,
    Filter,
    Transform,
    /// It affects texts, or is a hint.
    Any,
    /// An attribute in SVG 1.1, and a property in SVG 2.
    Geometry,
}

/// The properties that usvg reads.
const PROPERTIES: &[(Kind, &str)] = &[
    (Kind::Paint, "fill stroke"),
    (Kind::Color, "color stop-color flood-color lighting-color background-color"),
    (Kind::Share, "opacity fill-opacity stroke-opacity stop-opacity flood-opacity"),
    (Kind::Number, "stroke-miterlimit"),
    (Kind::Length, "stroke-width stroke-dashoffset"),
    (Kind::Lengths, "stroke-dasharray"),
    (Kind::Word("butt round square"), "stroke-linecap"),
    (Kind::Word("miter miter-clip round bevel"), "stroke-linejoin"),
    (Kind::Word("nonzero evenodd"), "fill-rule clip-rule"),
    (Kind::Word("visible hidden collapse"), "visibility"),
    (Kind::Word("luminance alpha"), "mask-type"),
    (Kind::Word("auto isolate"), "isolation"),
    (Kind::Word("sRGB linearRGB auto"), "color-interpolation-filters"),
    (
        Kind::Word(
            "normal multiply screen overlay darken lighten color-dodge color-burn hard-light soft-light difference \
             exclusion hue saturation color luminosity plus-lighter",
        ),
        "mix-blend-mode",
    ),
    (Kind::Link, "clip-path mask marker-start marker-mid marker-end"),
    (Kind::Filter, "filter"),
    (Kind::Transform, "transform"),
    (Kind::Geometry, "cx cy r rx ry x y width height"),
    (
        Kind::Any,
        "display overflow paint-order shape-rendering image-rendering text-rendering transform-origin font-family \
         font-size font-style font-weight font-stretch font-variant font-kerning font-size-adjust \
         font-variation-settings font-optical-sizing letter-spacing word-spacing text-anchor text-decoration \
         dominant-baseline alignment-baseline baseline-shift direction unicode-bidi writing-mode white-space",
    ),
];

/// Properties that browsers support and usvg does not, except those for text and for boxes in HTML.
const UNSUPPORTED: &str = "all backdrop-filter background background-image color-interpolation d mask-border \
    mask-border-source mask-clip mask-composite mask-image mask-mode offset offset-path rotate scale transform-box \
    translate vector-effect zoom -webkit-mask -webkit-mask-image";

/// Values of these that change nothing.
const NEUTRAL: &str = "none auto normal initial unset sRGB transparent border-box view-box match-source add 1";

/// How a property with this name is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Known {
    Read(Kind),
    /// It changes the drawing, and is left out.
    Unsupported,
    /// It changes nothing that is drawn.
    Unknown,
}

/// Looks up a property with its value.
pub(super) fn known(name: &str, value: &str) -> Known {
    static TABLE: LazyLock<HashMap<&str, Known>> = LazyLock::new(|| {
        let read = PROPERTIES.iter().map(|&(kind, names)| (Known::Read(kind), names));
        let all = read.chain([(Known::Unsupported, UNSUPPORTED)]);
        all.flat_map(|(known, names)| names.split(' ').map(move |name| (name, known))).collect()
    });
    match TABLE.get(name) {
        Some(Known::Unsupported) if NEUTRAL.split(' ').any(|word| word.eq_ignore_ascii_case(value)) => Known::Unknown,
        found => found.copied().unwrap_or(Known::Unknown),
    }
}

/// The properties that a shorthand sets.
pub(super) fn longhands(name: &str, value: &str) -> Option<Vec<(&'static str, String)>> {
    match name {
        "marker" => Some(["marker-start", "marker-mid", "marker-end"].map(|name| (name, value.to_owned())).into()),
        "background" => {
            let color = with_hex(value, "#000").filter(|hex| hex.starts_with('#') && !hex.contains(' '));
            color.map(|color| vec![("background-color", color)])
        }
        "font" => {
            let font = FontShorthand::from_str(value).ok()?;
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
        _ => matches!(tag, "rect" | "image" | "use"),
    }
}

/// The initial value of an inherited property. For others, the attribute is left out.
fn initial(name: &str) -> &'static str {
    match name {
        "fill" | "color" => "black",
        "stroke" | "stroke-dasharray" | "marker-start" | "marker-mid" | "marker-end" => "none",
        "fill-opacity" | "stroke-opacity" | "stroke-width" => "1",
        "stroke-dashoffset" => "0",
        "stroke-miterlimit" => "4",
        "stroke-linecap" => "butt",
        "stroke-linejoin" => "miter",
        "fill-rule" | "clip-rule" => "nonzero",
        "visibility" => "visible",
        "color-interpolation-filters" => "linearRGB",
        _ => "",
    }
}

/// A property's value as usvg reads it, given the colour that `currentColor` has in mixes. Empty for a property that
/// has no value of its own. `None` for an unknown value.
pub(super) fn read(name: &str, kind: Kind, value: &str, current: &str) -> Option<String> {
    let lower = value.to_ascii_lowercase();
    match &*lower {
        "inherit" => return Some(lower),
        "initial" => return Some(initial(name).to_owned()),
        "unset" | "revert" | "revert-layer" => return Some(String::new()),
        "none" if matches!(kind, Kind::Lengths | Kind::Link | Kind::Filter) => return Some(lower),
        "none" if kind == Kind::Transform => return Some(String::new()),
        "auto" if kind == Kind::Geometry => return Some(String::new()),
        _ => {}
    }
    let (text, is_read) = match kind {
        Kind::Paint | Kind::Color => {
            let text = with_hex(value, current)?;
            let is_color = matches!(Paint::from_str(&text).ok()?, Paint::Color(_) | Paint::CurrentColor);
            (text, is_color || kind == Kind::Paint)
        }
        Kind::Share => {
            let share: Length = lower.parse().ok()?;
            (lower, matches!(share.unit, LengthUnit::None | LengthUnit::Percent))
        }
        Kind::Number => {
            let is_read = lower.parse::<f64>().is_ok_and(f64::is_finite);
            (lower, is_read)
        }
        Kind::Length | Kind::Geometry => {
            let is_read = lower.parse::<Length>().is_ok();
            (lower, is_read)
        }
        Kind::Lengths => {
            let is_read = LengthListParser::from(&*lower).all(|length| length.is_ok());
            (lower, is_read)
        }
        Kind::Word(words) => (words.split(' ').find(|word| word.eq_ignore_ascii_case(value))?.to_owned(), true),
        Kind::Link => (value.to_owned(), FuncIRI::from_str(value).is_ok()),
        Kind::Filter => {
            let text = with_hex(value, current)?;
            let is_read = FilterValueListParser::from(&*text).all(|value| value.is_ok());
            (text, is_read)
        }
        Kind::Transform => {
            // The units of SVG, which has no others.
            let text = value.replace("px", "").replace("deg", "");
            let is_read = TransformListParser::from(&*text).all(|part| part.is_ok());
            (text, is_read)
        }
        Kind::Any => (value.to_owned(), true),
    };
    is_read.then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(name: &str, value: &str) -> Option<String> {
        let Known::Read(kind) = known(name, value) else { return None };
        read(name, kind, value, "#000000")
    }

    #[test]
    fn values_become_those_that_usvg_reads() {
        for (name, given, expected) in [
            ("fill", "CurrentColor", "currentColor"),
            ("fill", "url( '#a' ) RED", "url( '#a' ) #ff0000"),
            ("stroke", "NONE", "none"),
            ("stop-color", "rgb(1 2 3 / 0)", "#01020300"),
            ("opacity", "50%", "50%"),
            ("stroke-width", "3PX", "3px"),
            ("stroke-dasharray", "1px, 2px", "1px, 2px"),
            ("color-interpolation-filters", "srgb", "sRGB"),
            ("clip-path", "url(\"#a\")", "url(\"#a\")"),
            ("filter", "drop-shadow(1px 2px 3px oklch(0 0 0))", "drop-shadow(1px 2px 3px #000000)"),
            ("transform", "translate(1px, 2px) rotate(30deg) skewX(2)", "translate(1, 2) rotate(30) skewX(2)"),
            ("transform", "none", ""),
            ("fill", "initial", "black"),
            ("fill", "unset", ""),
        ] {
            assert_eq!(value(name, given).as_deref(), Some(expected), "{name}: {given}");
        }
    }

    #[test]
    fn values_that_usvg_would_replace_are_rejected() {
        for (name, given) in [
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
            assert_eq!(value(name, given), None, "{name}: {given}");
        }
    }

    #[test]
    fn properties_that_change_nothing_are_not_reported() {
        assert_eq!(known("vector-effect", "none"), Known::Unknown);
        assert_eq!(known("cursor", "pointer"), Known::Unknown);
        assert_eq!(known("vector-effect", "non-scaling-stroke"), Known::Unsupported);
    }
}
