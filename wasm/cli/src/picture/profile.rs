//! ICC profiles of pictures that were decoded to RGB.
//!
//! A grey profile becomes an RGB profile with the same curve, so that grey levels keep their values. The PNG chunks
//! cICP, gAMA and cHRM become a profile as well. PNG 3rd edition, section 13.14, defines their precedence.

use std::io::{BufRead, Seek};

use moxcms::{
    Chromaticity, CicpProfile, ColorPrimaries, ColorProfile, DataColorSpace, MatrixCoefficients, ProfileText,
    ToneReprCurve,
};

/// The gAMA value that approximates sRGB, times 100,000. Without cHRM, it counts as sRGB, as in browsers.
const SRGB_GAMMA: u32 = 45_455;

/// Returns the RGB profile for the embedded profile `icc`.
///
/// `None` if `icc` describes colours other than RGB and grey, or a grey without a curve.
pub(crate) fn rgb_profile(icc: Vec<u8>) -> Option<Vec<u8>> {
    // The field "data colour space" of the header (ICC.1, section 7.2.6).
    match icc.get(16..20)? {
        b"RGB " => Some(icc),
        b"GRAY" => {
            let grey = ColorProfile::new_from_slice(&icc).ok()?;
            (grey.pcs == DataColorSpace::Xyz).then_some(())?;
            encode(ColorProfile::new_srgb(), grey.gray_trc?, grey.description)
        }
        _ => None,
    }
}

/// Returns the profile that the chunks cICP, gAMA and cHRM of a PNG describe.
///
/// `None` if the PNG embeds a profile, has none of these chunks, or is sRGB.
pub(crate) fn png_profile(file: impl BufRead + Seek) -> Option<Vec<u8>> {
    let reader = png::Decoder::new(file).read_info().ok()?;
    let info = reader.info();
    if let Some(code) = info.coding_independent_code_points {
        let profile = ColorProfile::new_from_cicp(CicpProfile {
            color_primaries: code.color_primaries.try_into().ok()?,
            transfer_characteristics: code.transfer_function.try_into().ok()?,
            matrix_coefficients: MatrixCoefficients::Identity,
            full_range: true,
        });
        // Codes without primaries or a curve give a profile without a curve.
        return profile.red_trc.as_ref().and_then(|_| profile.encode().ok());
    }
    if info.icc_profile.is_some() || info.srgb.is_some() {
        return None;
    }
    let gamma = info.gama_chunk?;
    let mut profile = ColorProfile::new_srgb();
    match info.chrm_chunk {
        None if gamma.into_scaled() == SRGB_GAMMA => return None,
        None => {}
        Some(chromaticities) => {
            let chromaticity =
                |(x, y): (png::ScaledFloat, png::ScaledFloat)| Chromaticity::new(x.into_value(), y.into_value());
            let [white, red, green, blue] =
                [chromaticities.white, chromaticities.red, chromaticities.green, chromaticities.blue].map(chromaticity);
            profile.update_rgb_colorimetry(white.to_xyyb(), ColorPrimaries { red, green, blue });
        }
    }
    let exponent = 1.0 / gamma.into_value();
    // Collinear or infinite primaries span no colours.
    let volume = profile.colorant_matrix().determinant().unwrap_or(0.0).abs();
    let is_valid = exponent.is_finite() && volume.is_finite() && volume > 1e-6;
    let name = ProfileText::PlainString("gAMA and cHRM of a PNG".to_owned());
    encode(profile, ToneReprCurve::Parametric(vec![exponent]), Some(name)).filter(|_| is_valid)
}

/// Encodes the profile with `curve` for all channels.
fn encode(mut profile: ColorProfile, curve: ToneReprCurve, description: Option<ProfileText>) -> Option<Vec<u8>> {
    profile.red_trc = Some(curve.clone());
    profile.green_trc = Some(curve.clone());
    profile.blue_trc = Some(curve);
    // The code points still describe sRGB.
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

    /// Converts colours from a profile to sRGB.
    fn to_srgb(icc: &[u8], layout: Layout, colours: &[u8]) -> Vec<u8> {
        let profile = ColorProfile::new_from_slice(icc).unwrap();
        let srgb = ColorProfile::new_srgb();
        let transform = profile.create_transform_8bit(layout, &srgb, Layout::Rgb, TransformOptions::default()).unwrap();
        let pixels = colours.len() / if layout == Layout::Gray { 1 } else { 3 };
        let mut converted = vec![0; pixels * 3];
        transform.transform(colours, &mut converted).unwrap();
        converted
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
    fn grey_keeps_its_values_and_appearance() {
        let levels: Vec<u8> = (0..=255).collect();
        let levels_of_rgb: Vec<u8> = levels.iter().flat_map(|&level| [level; 3]).collect();
        for gamma in [1.0, 1.8, 2.2] {
            let grey = ColorProfile::new_gray_with_gamma(gamma).encode().unwrap();
            let rgb = rgb_profile(grey.clone()).unwrap();
            assert_close(&to_srgb(&rgb, Layout::Rgb, &levels_of_rgb), &to_srgb(&grey, Layout::Gray, &levels));
        }
    }

    #[test]
    fn cmyk_and_truncated_profiles_are_dropped() {
        assert_eq!(rgb_profile([[0; 16].as_slice(), b"CMYK", &[0; 200]].concat()), None);
        assert_eq!(rgb_profile(vec![0; 7]), None);
    }

    #[test]
    fn png_chunks_become_profiles() {
        let p3 = ColorProfile::new_display_p3().encode().unwrap();
        let by_code = png_profile(png(&[(b"cICP", &[12, 13, 0, 1])])).unwrap();
        assert_close(&to_srgb(&by_code, Layout::Rgb, &COLOURS), &to_srgb(&p3, Layout::Rgb, &COLOURS));

        // Adobe RGB.
        let primaries = [31_270, 32_900, 64_000, 33_000, 21_000, 71_000, 15_000, 6_000_u32];
        let primaries: Vec<u8> = primaries.iter().flat_map(|number| number.to_be_bytes()).collect();
        let adobe = ColorProfile::new_adobe_rgb().encode().unwrap();
        let by_chromaticities = png_profile(png(&[TWO_POINT_TWO, (b"cHRM", &primaries)])).unwrap();
        assert_close(&to_srgb(&by_chromaticities, Layout::Rgb, &COLOURS), &to_srgb(&adobe, Layout::Rgb, &COLOURS));

        let linear = png_profile(png(&[(b"gAMA", &100_000_u32.to_be_bytes())])).unwrap();
        assert_close(&to_srgb(&linear, Layout::Rgb, &[128; 3]), &[188; 3]);
    }

    #[test]
    fn srgb_and_invalid_chunks_give_no_profile() {
        assert_eq!(png_profile(png(&[])), None);
        assert_eq!(png_profile(png(&[TWO_POINT_TWO])), None);
        assert_eq!(png_profile(png(&[(b"sRGB", &[0]), (b"gAMA", &100_000_u32.to_be_bytes())])), None);
        assert_eq!(png_profile(png(&[(b"gAMA", &[0; 4])])), None);
        assert_eq!(png_profile(png(&[TWO_POINT_TWO, (b"cHRM", &[0; 32])])), None);
        assert_eq!(png_profile(png(&[(b"cICP", &[2, 2, 0, 1])])), None);
        assert_eq!(png_profile(Cursor::new(b"no PNG".to_vec())), None);
    }
}
