//! The ICC profile that a picture's numbers are meant by, once it is RGB.
//!
//! Grey stays as many levels as it was: its profile becomes one of RGB with the same curve, so that no number changes.
//! What a PNG says by its chunks cICP, gAMA and cHRM becomes a profile, too (PNG 3rd edition, 13.14 tells which counts).

use std::io::{BufRead, Seek};

use moxcms::{
    Chromaticity, CicpProfile, ColorPrimaries, ColorProfile, DataColorSpace, MatrixCoefficients, ProfileText,
    ToneReprCurve,
};

/// What gAMA says of pictures for sRGB, which is no exact description of it; alone it is taken for sRGB, as browsers do.
const USUAL_GAMMA: u32 = 45_455;

/// The profile of the RGB that a decoder makes, from the one in the file. `None` where that is of other colours than RGB and
/// grey, or of a grey that has no curve.
pub(crate) fn of_rgb(icc: Vec<u8>) -> Option<Vec<u8>> {
    // The "data colour space" of the header (ICC.1, 7.2.6).
    match icc.get(16..20)? {
        b"RGB " => Some(icc),
        b"GRAY" => {
            let grey = ColorProfile::new_from_slice(&icc).ok()?;
            (grey.pcs == DataColorSpace::Xyz).then_some(())?;
            encoded(ColorProfile::new_srgb(), grey.gray_trc?, grey.description)
        }
        _ => None,
    }
}

/// The profile that a PNG describes otherwise than by one; `None` where it holds one, says nothing, or says sRGB.
pub(crate) fn of_png(file: impl BufRead + Seek) -> Option<Vec<u8>> {
    let reader = png::Decoder::new(file).read_info().ok()?;
    let info = reader.info();
    if let Some(code) = info.coding_independent_code_points {
        let profile = ColorProfile::new_from_cicp(CicpProfile {
            color_primaries: code.color_primaries.try_into().ok()?,
            transfer_characteristics: code.transfer_function.try_into().ok()?,
            matrix_coefficients: MatrixCoefficients::Identity,
            full_range: true,
        });
        // Without a curve it was none that has primaries or a curve.
        return profile.red_trc.as_ref().and_then(|_| profile.encode().ok());
    }
    if info.icc_profile.is_some() || info.srgb.is_some() {
        return None;
    }
    let gamma = info.gama_chunk?;
    let mut profile = ColorProfile::new_srgb();
    match info.chrm_chunk {
        None if gamma.into_scaled() == USUAL_GAMMA => return None,
        None => {}
        Some(chromaticities) => {
            let place =
                |(x, y): (png::ScaledFloat, png::ScaledFloat)| Chromaticity::new(x.into_value(), y.into_value());
            let [white, red, green, blue] =
                [chromaticities.white, chromaticities.red, chromaticities.green, chromaticities.blue].map(place);
            profile.update_rgb_colorimetry(white.to_xyyb(), ColorPrimaries { red, green, blue });
        }
    }
    let exponent = 1.0 / gamma.into_value();
    // Primaries in one line, or at infinity, mix no colours.
    let volume = profile.colorant_matrix().determinant().unwrap_or(0.0).abs();
    let sound = exponent.is_finite() && volume.is_finite() && volume > 1e-6;
    let name = ProfileText::PlainString("gAMA and cHRM of a PNG".to_owned());
    encoded(profile, ToneReprCurve::Parametric(vec![exponent]), Some(name)).filter(|_| sound)
}

/// The profile with this curve for all of its channels.
fn encoded(mut profile: ColorProfile, curve: ToneReprCurve, description: Option<ProfileText>) -> Option<Vec<u8>> {
    profile.red_trc = Some(curve.clone());
    profile.green_trc = Some(curve.clone());
    profile.blue_trc = Some(curve);
    // Code points would say sRGB.
    profile.cicp = None;
    profile.description = description;
    profile.encode().ok()
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use moxcms::{Layout, TransformOptions};
    use png::chunk::ChunkType;

    use super::*;

    /// What colours are in sRGB by a profile.
    fn seen(icc: &[u8], layout: Layout, colours: &[u8]) -> Vec<u8> {
        let profile = ColorProfile::new_from_slice(icc).unwrap();
        let srgb = ColorProfile::new_srgb();
        let transform = profile.create_transform_8bit(layout, &srgb, Layout::Rgb, TransformOptions::default()).unwrap();
        let pixels = colours.len() / if layout == Layout::Gray { 1 } else { 3 };
        let mut seen = vec![0; pixels * 3];
        transform.transform(colours, &mut seen).unwrap();
        seen
    }

    fn assert_close(one: &[u8], other: &[u8]) {
        assert!(one.iter().zip(other).all(|(a, b)| a.abs_diff(*b) <= 1), "{one:?} and {other:?}");
    }

    fn png(chunks: &[(&[u8; 4], &[u8])]) -> Cursor<Vec<u8>> {
        let mut file = Vec::new();
        let mut writer = png::Encoder::new(&mut file, 1, 1).write_header().unwrap();
        for (name, data) in chunks {
            writer.write_chunk(ChunkType(**name), data).unwrap();
        }
        writer.write_image_data(&[0]).unwrap();
        writer.finish().unwrap();
        Cursor::new(file)
    }

    const COLOURS: [u8; 12] = [200, 100, 50, 30, 160, 90, 128, 128, 128, 10, 20, 240];
    const TWO_POINT_TWO: (&[u8; 4], &[u8]) = (b"gAMA", &45_455_u32.to_be_bytes());

    #[test]
    fn grey_keeps_its_numbers_and_its_looks() {
        let levels: Vec<u8> = (0..=255).collect();
        let levels_of_rgb: Vec<u8> = levels.iter().flat_map(|&level| [level; 3]).collect();
        for gamma in [1.0, 1.8, 2.2] {
            let grey = ColorProfile::new_gray_with_gamma(gamma).encode().unwrap();
            let rgb = of_rgb(grey.clone()).unwrap();
            assert_close(&seen(&rgb, Layout::Rgb, &levels_of_rgb), &seen(&grey, Layout::Gray, &levels));
        }
    }

    #[test]
    fn colours_of_a_printer_have_no_profile_of_rgb() {
        assert_eq!(of_rgb([[0; 16].as_slice(), b"CMYK", &[0; 200]].concat()), None);
        assert_eq!(of_rgb(vec![0; 7]), None);
    }

    #[test]
    fn a_png_says_its_primaries_and_its_curve_in_three_ways() {
        let p3 = ColorProfile::new_display_p3().encode().unwrap();
        let by_code = of_png(png(&[(b"cICP", &[12, 13, 0, 1])])).unwrap();
        assert_close(&seen(&by_code, Layout::Rgb, &COLOURS), &seen(&p3, Layout::Rgb, &COLOURS));

        // Adobe RGB.
        let primaries = [31_270, 32_900, 64_000, 33_000, 21_000, 71_000, 15_000, 6_000_u32];
        let primaries: Vec<u8> = primaries.iter().flat_map(|number| number.to_be_bytes()).collect();
        let adobe = ColorProfile::new_adobe_rgb().encode().unwrap();
        let by_places = of_png(png(&[TWO_POINT_TWO, (b"cHRM", &primaries)])).unwrap();
        assert_close(&seen(&by_places, Layout::Rgb, &COLOURS), &seen(&adobe, Layout::Rgb, &COLOURS));

        let linear = of_png(png(&[(b"gAMA", &100_000_u32.to_be_bytes())])).unwrap();
        assert_close(&seen(&linear, Layout::Rgb, &[128; 3]), &[188; 3]);
    }

    #[test]
    fn what_is_srgb_or_makes_no_sense_has_no_profile() {
        assert_eq!(of_png(png(&[])), None);
        assert_eq!(of_png(png(&[TWO_POINT_TWO])), None);
        assert_eq!(of_png(png(&[(b"sRGB", &[0]), (b"gAMA", &100_000_u32.to_be_bytes())])), None);
        assert_eq!(of_png(png(&[(b"gAMA", &[0; 4])])), None);
        assert_eq!(of_png(png(&[TWO_POINT_TWO, (b"cHRM", &[0; 32])])), None);
        assert_eq!(of_png(png(&[(b"cICP", &[2, 2, 0, 1])])), None);
        assert_eq!(of_png(Cursor::new(b"no PNG".to_vec())), None);
    }
}
