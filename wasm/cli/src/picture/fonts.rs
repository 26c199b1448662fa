//! The fonts of the system, for texts of drawings.

use c2warp_vector::fontdb::{Database, Family, Query};

/// Replacements for generic families that the system lacks.
const SERIF: &[&str] = &["DejaVu Serif", "Liberation Serif", "Noto Serif"];
const SANS: &[&str] = &["DejaVu Sans", "Liberation Sans", "Noto Sans"];
const MONOSPACE: &[&str] = &["DejaVu Sans Mono", "Liberation Mono", "Noto Sans Mono"];

/// All fonts of the system. Every generic family has a font if the system has any.
pub(super) fn of_system() -> Database {
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    let any = fonts.faces().next().and_then(|face| face.families.first()).map(|(name, _)| name.clone());
    let family = |fonts: &Database, generic: Family<'_>, names: &[&str]| {
        let knows = |family| fonts.query(&Query { families: &[family], ..Query::default() }).is_some();
        if knows(generic) {
            return None;
        }
        names.iter().find(|name| knows(Family::Name(name))).map(|&name| name.to_owned()).or(any.clone())
    };
    if let Some(name) = family(&fonts, Family::Serif, SERIF) {
        fonts.set_serif_family(name);
    }
    for generic in [Family::SansSerif, Family::Cursive, Family::Fantasy] {
        if let Some(name) = family(&fonts, generic, SANS) {
            match generic {
                Family::Cursive => fonts.set_cursive_family(name),
                Family::Fantasy => fonts.set_fantasy_family(name),
                _ => fonts.set_sans_serif_family(name),
            }
        }
    }
    if let Some(name) = family(&fonts, Family::Monospace, MONOSPACE) {
        fonts.set_monospace_family(name);
    }
    fonts
}
