//! Colours of CSS Color 4, and `color-mix()`. Colours outside the gamut of sRGB are clipped, as in browsers.

use color::{AlphaColor, ColorSpaceTag, DynamicColor, HueDirection, Srgb, parse_color};
use cssparser::{ParseError, Parser, Token};

type Parsed<T> = Result<T, ParseError<()>>;

/// Replaces each colour in a value, such as a paint or a filter, by `#rrggbb` or `#rrggbbaa`. `currentColor` is kept,
/// because used elements resolve it; in a mix, it is `current`. `None` if a colour cannot be resolved.
pub(super) fn with_hex(value: &str, current: &str) -> Option<String> {
    let mut input = Parser::new(value);
    let mut text = String::new();
    written(&mut input, current, &mut text).ok()?;
    Some(text.trim().to_owned())
}

fn written(input: &mut Parser<'_>, current: &str, text: &mut String) -> Parsed<()> {
    loop {
        let start = input.state();
        let Ok(token) = input.next_including_whitespace() else { return Ok(()) };
        let is_color = match token {
            Token::Hash(_) | Token::IDHash(_) => true,
            Token::Function(name) => is_color_function(name),
            Token::Ident(name) => parse_color(name).is_ok(),
            _ => false,
        };
        if is_color {
            input.reset(&start);
            text.push_str(&hex(color(input, current)?));
            continue;
        }
        let opening = token.clone();
        match &opening {
            // The only keyword that usvg compares with letter case.
            Token::Ident(name) if name.eq_ignore_ascii_case("currentcolor") => text.push_str("currentColor"),
            Token::Ident(name) => text.push_str(&name.to_ascii_lowercase()),
            _ => text.push_str(input.slice_from(start.position())),
        }
        let closing = match opening {
            Token::Function(_) | Token::ParenthesisBlock => ")",
            Token::SquareBracketBlock => "]",
            Token::CurlyBracketBlock => "}",
            _ => continue,
        };
        input.parse_nested_block(|input| written(input, current, text))?;
        text.push_str(closing);
    }
}

fn is_color_function(name: &str) -> bool {
    const NAMES: &str =
        "rgb rgba hsl hsla hwb lab lch oklab oklch color color-mix light-dark contrast-color device-cmyk";
    NAMES.split(' ').any(|known| name.eq_ignore_ascii_case(known))
}

fn hex(color: DynamicColor) -> String {
    let color: AlphaColor<Srgb> = color.to_alpha_color();
    let [r, g, b, a] = color.to_rgba8().to_u8_array();
    if a == 255 { format!("#{r:02x}{g:02x}{b:02x}") } else { format!("#{r:02x}{g:02x}{b:02x}{a:02x}") }
}

/// The next colour.
fn color(input: &mut Parser<'_>, current: &str) -> Parsed<DynamicColor> {
    let unknown = || ParseError::custom(());
    input.skip_whitespace();
    let start = input.position();
    match input.next()?.clone() {
        Token::Ident(name) if name.eq_ignore_ascii_case("currentcolor") => parse_color(current).map_err(|_| unknown()),
        Token::Function(name) if name.eq_ignore_ascii_case("color-mix") => {
            input.parse_nested_block(|input| mixed(input, current))
        }
        token => {
            if let Token::Function(_) = token {
                input.parse_nested_block(|input| {
                    while input.next().is_ok() {}
                    Parsed::Ok(())
                })?;
            }
            parse_color(input.slice_from(start)).map_err(|_| unknown())
        }
    }
}

/// The content of the parentheses of `color-mix()`.
fn mixed(input: &mut Parser<'_>, current: &str) -> Parsed<DynamicColor> {
    let space = if input.try_parse(|input| input.expect_ident_matching("in")).is_ok() {
        let space = space(input.expect_ident()?).ok_or_else(|| ParseError::custom(()))?;
        input.expect_comma()?;
        space
    } else {
        ColorSpaceTag::Oklab
    };
    let part = |input: &mut Parser<'_>| -> Parsed<(Option<f32>, DynamicColor)> {
        let before = input.try_parse(Parser::expect_percentage).ok();
        let color = color(input, current)?;
        let share = before.or_else(|| input.try_parse(Parser::expect_percentage).ok());
        Ok((share, color))
    };
    let (first_share, first) = part(input)?;
    input.expect_comma()?;
    let (second_share, second) = part(input)?;
    let (one, other) = match (first_share, second_share) {
        (None, None) => (0.5, 0.5),
        (Some(one), None) => (one, 1.0 - one),
        (None, Some(other)) => (1.0 - other, other),
        (Some(one), Some(other)) => (one, other),
    };
    let sum = one + other;
    if one < 0.0 || other < 0.0 || sum <= 0.0 {
        return Err(ParseError::custom(()));
    }
    let mut mix = first.interpolate(second, space, HueDirection::Shorter).eval(other / sum);
    mix.components[3] *= sum.min(1.0);
    Ok(mix)
}

fn space(name: &str) -> Option<ColorSpaceTag> {
    match &*name.to_ascii_lowercase() {
        "hsl" => Some(ColorSpaceTag::Hsl),
        "hwb" => Some(ColorSpaceTag::Hwb),
        "rec2020" => Some(ColorSpaceTag::Rec2020),
        other => other.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::with_hex;

    #[test]
    fn all_colour_syntaxes_become_hexadecimal() {
        // As painted by Chromium.
        for (value, hex) in [
            ("#ABC", "#aabbcc"),
            ("#11223380", "#11223380"),
            ("RebeccaPurple", "#663399"),
            ("transparent", "#00000000"),
            ("rgb(20 90 200 / 80%)", "#145ac8cc"),
            ("rgba(100%, 0%, 50%, .5)", "#ff008080"),
            ("hsl(280deg 60% 50%)", "#9933cc"),
            ("hsla(0.5turn, 100%, 25%, 1)", "#008080"),
            ("hwb(194 0% 0% / .5)", "#00c3ff80"),
            ("lab(50% 40 59.5)", "#bf5700"),
            ("lch(52.2% 72.2 50)", "#cd561a"),
            ("oklab(59% .1 .1)", "#c05d2b"),
            ("oklch(70% .2 60)", "#f47700"),
            ("color(display-p3 0 1 0)", "#00ff00"),
            ("color(srgb-linear .5 0 0)", "#bc0000"),
            ("color-mix(in srgb, red, blue)", "#800080"),
            ("color-mix(in srgb, red 25%, transparent)", "#ff000040"),
            ("color-mix(in oklch, red 50%, color-mix(in lab, blue, lime))", "#af6ac7"),
            ("color-mix(in srgb, currentColor, black)", "#091a33"),
            ("url(#a) hsl(0 100% 50%)", "url(#a) #ff0000"),
            ("drop-shadow(0 0 3px rgb(0 0 0 / 50%)) blur(2px)", "drop-shadow(0 0 3px #00000080) blur(2px)"),
            ("currentColor", "currentColor"),
        ] {
            assert_eq!(with_hex(value, "#123466").as_deref(), Some(hex), "{value}");
        }
    }

    #[test]
    fn ambiguous_colours_are_rejected() {
        for value in ["light-dark(red, blue)", "rgb(from red r g b)", "rgb(calc(1 + 2) 0 0)", "color-mix(red)", "#12"] {
            assert_eq!(with_hex(value, "#000"), None, "{value}");
        }
    }
}
