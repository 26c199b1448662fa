//! `xtask schema`: the project file's format, as the solver defines it, for others to read: a JSON schema for
//! editors and validators, and TypeScript types for the page.
//!
//! Both are committed, so that the page builds without Rust; `--check` tells when they no longer say what the
//! solver does.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use c2warp::project::Project;
use schemars::generate::SchemaSettings;

use crate::typescript;

const OUTPUT: &str = "web/src/document/generated";

/// Why the types were not written, or are not in order.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SchemaError {
    #[error("could not write {path}: {reason}")]
    Write { path: PathBuf, reason: io::Error },
    #[error("{path} is out of date: run `cargo run -p xtask -- schema` and commit what it writes")]
    OutOfDate { path: PathBuf },
    #[error(transparent)]
    TypeScript(#[from] typescript::Unknown),
}

/// Writes `project.schema.json` and `project.ts`, or only compares what stands there.
pub(crate) fn write(root: &Path, check: bool) -> Result<(), SchemaError> {
    // Of a file, that is to say, in which much may be left out.
    let schema = SchemaSettings::draft2020_12().for_deserialize().into_generator().into_root_schema_for::<Project>();
    let json = serde_json::to_string_pretty(&schema).expect("a schema is JSON already") + "\n";
    let types = typescript::declarations(schema.as_value())?;

    let folder = root.join(OUTPUT);
    for (name, text) in [("project.schema.json", json), ("project.ts", types)] {
        let path = folder.join(name);
        if check {
            // A checkout on Windows may have other line ends.
            if fs::read_to_string(&path).ok().map(|found| found.replace("\r\n", "\n")) != Some(text) {
                return Err(SchemaError::OutOfDate { path: Path::new(OUTPUT).join(name) });
            }
        } else {
            fs::create_dir_all(&folder)
                .and_then(|()| fs::write(&path, text))
                .map_err(|reason| SchemaError::Write { path, reason })?;
        }
    }
    Ok(())
}
