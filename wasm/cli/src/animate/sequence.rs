//! Names of single frames, as `frame-%04d.png`.

use std::path::{Path, PathBuf};

/// The names of single frames.
#[derive(Debug, PartialEq)]
pub(super) struct Sequence {
    folder: PathBuf,
    before: String,
    digits: usize,
    after: String,
}

impl Sequence {
    /// Parses a path with one `%d` or `%04d` in its last part. It must end with `.png`.
    pub(super) fn named(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let (before, rest) = name.split_once('%')?;
        let (digits, after) = rest.split_once('d')?;
        let is_number = digits.is_empty() || (digits.starts_with('0') && digits.len() == 2);
        let digits = if digits.is_empty() { 1 } else { digits.parse().ok()? };
        let is_png = after.to_ascii_lowercase().ends_with(".png") && !after.contains('%');
        (is_number && is_png).then(|| Self {
            folder: path.with_file_name(""),
            before: before.to_owned(),
            digits,
            after: after.to_owned(),
        })
    }

    /// The path of a frame, counted from 0.
    pub(super) fn path(&self, frame: usize) -> PathBuf {
        let Self { folder, before, digits, after } = self;
        folder.join(format!("{before}{frame:0digits$}{after}"))
    }
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::Sequence;

    #[test]
    fn names_have_the_number_of_the_frame() {
        let path = |name: &str| Sequence::named(Path::new(name)).map(|sequence| sequence.path(7));
        assert_eq!(path("out/frame-%04d.png"), Some(PathBuf::from("out/frame-0007.png")));
        assert_eq!(path("%d.PNG"), Some(PathBuf::from("7.PNG")));
        for other in ["frame.png", "frame-%s.png", "frame-%4d.png", "frame-%04d.gif", "50%.png", "%d-%d.png"] {
            assert_eq!(path(other), None, "{other}");
        }
    }
}
