//! Checks that a JPEG file is complete. Decoders fill missing parts with grey and report no error.
//!
//! The check walks the markers of ITU-T T.81, annex B, from the first to "end of image". It skips segments by their
//! length. It skips scan data up to the next marker, because scan data never contains one.

use std::io::{self, BufRead, Read};

const END_OF_IMAGE: u8 = 0xd9;

/// Walks to the end of the image. Data after it is ignored.
///
/// # Errors
/// If the file ends early or cannot be read.
pub(crate) fn find_end(mut file: impl BufRead) -> io::Result<()> {
    let mut marker = next_marker(&mut file)?;
    while marker != END_OF_IMAGE {
        let mut length = [0; 2];
        file.read_exact(&mut length)?;
        let rest = u64::from(u16::from_be_bytes(length)).saturating_sub(2);
        if io::copy(&mut file.by_ref().take(rest), &mut io::sink())? < rest {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        marker = next_marker(&mut file)?;
    }
    Ok(())
}

/// Returns the next marker that is neither a stuffed byte of a scan nor a restart.
fn next_marker(file: &mut impl BufRead) -> io::Result<u8> {
    loop {
        file.skip_until(0xff)?;
        let mut marker = [0xff];
        while marker == [0xff] {
            file.read_exact(&mut marker)?;
        }
        // 0 marks a stuffed byte 0xff of a scan. 0xd0 to 0xd7 restart a scan, 0xd8 starts the image, 1 is for temporary
        // use.
        if !matches!(marker, [0 | 1 | 0xd0..=0xd8]) {
            return Ok(marker[0]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::find_end;

    /// A start, a segment that looks like an end, a scan with a stuffed byte, a restart and the end.
    const COMPLETE: &[u8] = b"\xff\xd8\xff\xe0\0\x04\xff\xd9\xff\xda\0\x03!abc\xff\0\xff\xd3def\xff\xff\xd9";

    #[test]
    fn truncated_file_has_no_end() {
        assert!(find_end(COMPLETE).is_ok());
        assert!(find_end(&[COMPLETE, b"trailing data"].concat()[..]).is_ok());
        for length in 0..COMPLETE.len() {
            assert!(find_end(&COMPLETE[..length]).is_err(), "{length}");
        }
    }
}
