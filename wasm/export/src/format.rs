//! The formats and their file name endings.

use crate::{dragonbones, error::ExportError, gltf, godot, rig::EngineRig, spine};

/// A file format of an engine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Spine JSON 4.2, `.spine.json`, with an atlas.
    Spine,
    /// DragonBones JSON 5.5, `_ske.json`, with a texture file.
    DragonBones,
    /// glTF 2.0 binary, `.glb`, with the picture inside.
    Gltf,
    /// A scene of Godot 4, `.tscn`.
    Godot,
}

/// One file of a rig.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RigFile {
    /// The ending of its name, after the stem that all files of a rig share.
    pub ending: &'static str,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 4] = [Self::Spine, Self::DragonBones, Self::Gltf, Self::Godot];

    /// The display name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Spine => "Spine",
            Self::DragonBones => "DragonBones",
            Self::Gltf => "glTF",
            Self::Godot => "Godot",
        }
    }

    /// The ending of the main file's name.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            Self::Spine => ".spine.json",
            Self::DragonBones => "_ske.json",
            Self::Gltf => ".glb",
            Self::Godot => ".tscn",
        }
    }

    /// The ending of the name of the PNG beside it; `None` if the picture is embedded.
    #[must_use]
    pub fn picture_ending(self) -> Option<&'static str> {
        match self {
            Self::Spine | Self::Godot => Some(".png"),
            Self::DragonBones => Some("_tex.png"),
            Self::Gltf => None,
        }
    }

    /// The endings of the names of other files beside it.
    #[must_use]
    pub fn other_endings(self) -> &'static [&'static str] {
        match self {
            Self::Spine => &[".atlas"],
            Self::DragonBones => &["_tex.json"],
            Self::Gltf | Self::Godot => &[],
        }
    }

    /// The format and the stem of a file name; `None` if its ending is unknown or it has no stem.
    #[must_use]
    pub fn of_file(name: &str) -> Option<(Self, &str)> {
        let of = |format: Self| {
            let at = name.len().checked_sub(format.ending().len())?;
            let (stem, ending) = (name.get(..at)?, name.get(at..)?);
            (ending.eq_ignore_ascii_case(format.ending()) && !stem.is_empty()).then_some((format, stem))
        };
        Self::ALL.into_iter().find_map(of)
    }

    /// The maximum number of bones per vertex, if the format has a limit.
    #[must_use]
    pub fn most_influences(self) -> Option<usize> {
        (self == Self::Godot).then_some(4)
    }
}

impl EngineRig {
    /// The files of the rig, the main one first. `png` is the picture's file, for formats that embed it.
    ///
    /// # Errors
    /// [`ExportError::InfluencesOfFormat`] for a rig with more influences than the format supports.
    pub fn files(&self, format: Format, png: &[u8]) -> Result<Vec<RigFile>, ExportError> {
        if let Some(most) = format.most_influences().filter(|&most| self.influences() > most) {
            let found = self.influences();
            return Err(ExportError::InfluencesOfFormat { format: format.name(), most, found });
        }
        let main = |bytes: Vec<u8>| RigFile { ending: format.ending(), bytes };
        Ok(match format {
            Format::Spine => vec![main(spine::skeleton(self)), RigFile { ending: ".atlas", bytes: spine::atlas(self) }],
            Format::DragonBones => vec![
                main(dragonbones::skeleton(self)),
                RigFile { ending: "_tex.json", bytes: dragonbones::texture(self) },
            ],
            Format::Gltf => vec![main(gltf::binary(self, png))],
            Format::Godot => vec![main(godot::scene(self))],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Format;

    #[test]
    fn formats_follow_from_file_name_endings() {
        assert_eq!(Format::of_file("a.spine.json"), Some((Format::Spine, "a")));
        assert_eq!(Format::of_file("a_ske.json"), Some((Format::DragonBones, "a")));
        assert_eq!(Format::of_file("Ä.GLB"), Some((Format::Gltf, "Ä")));
        assert_eq!(Format::of_file("a.b.tscn"), Some((Format::Godot, "a.b")));
        for name in ["a.json", ".glb", "a.gltf", "é", "-"] {
            assert_eq!(Format::of_file(name), None);
        }
    }
}
