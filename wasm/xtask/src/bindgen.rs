//! `xtask bindgen`: the WebAssembly modules of pages with their TypeScript glue, or one of another crate.
//!
//! Builds crates for `wasm32-unknown-unknown` and passes the results to `wasm-bindgen`. `wasm-bindgen` is used as a
//! library, in the version that the crates are compiled with, so nothing must be installed and versions always match.
//! Takes half a second if nothing has changed.
//!
//! One run of cargo builds all modules. The modules share their dependencies, and their last steps run in parallel.

use std::path::{Path, PathBuf};
use std::process::Command;

use wasm_bindgen_cli_support::Bindgen;

use crate::panic_places;
use crate::split::{JOINING_TYPES, Parts, joining_glue, split};

const TARGET: &str = "wasm32-unknown-unknown";

/// A module: its crate, its output folder relative to the root of the repository, and the name of its files.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Module<'a> {
    pub(crate) package: &'a str,
    pub(crate) output: &'a Path,
    pub(crate) name: &'a str,
    /// The exports that a page loads later, as `NAME_later_bg.wasm`; empty for a module in one part.
    pub(crate) later: &'a [&'a str],
}

/// The exports of the solver that few pages need, or only later: suggestions, drawings, films, fills, explanations, and
/// queries that only `c2warp/core` uses. A name that ends with `_` is a prefix.
const LATER: &[&str] = &[
    "session_begin_fill",
    "session_advance_fill",
    "session_fill",
    "session_fit",
    "session_suggest",
    "session_cell_borders",
    "session_lens",
    "session_study",
    "session_draw",
    "session_rows",
    "session_film",
    "session_frame",
    "session_include",
    "session_picture_at_rest",
    "session_map",
    "session_inverse",
    "session_posed_mesh",
    "session_next_pose",
    "session_weights",
    "session_distances",
    "session_path",
    "cellborders_",
    "drawing_",
    "fill_",
    "filming_",
    "history_",
    "pointweights_",
    "posedmesh_",
];

/// The name of a solver's files, also of its benchmark's.
pub(crate) const SOLVER: &str = "c2warp";

/// The modules that pages load: the solver, the modules for films and other exports, and the poser of baked rigs.
pub(crate) fn page_modules() -> [Module<'static>; 4] {
    let solver =
        Module { package: "c2warp-bind", output: Path::new("web/src/compute/generated"), name: SOLVER, later: LATER };
    let film =
        Module { package: "c2warp-film-bind", output: Path::new("web/src/io/generated"), name: "film", later: &[] };
    let export = Module { package: "c2warp-export-bind", output: solver.output, name: "c2warp_export", later: &[] };
    let pose =
        Module { package: "c2warp-pose-bind", output: Path::new("web/src/player/generated"), name: "pose", later: &[] };
    [solver, film, export, pose]
}

/// The solver and the poser in another folder.
pub(crate) fn measured_in(output: &Path) -> [Module<'_>; 2] {
    let [solver, _, _, pose] = page_modules();
    [solver, pose].map(|module| Module { output, ..module })
}

/// The profile of cargo for the module.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Profile {
    /// Builds quickly and keeps the names of functions, for profiling and stack traces.
    Dev,
    /// The module of a published editor.
    Release,
    /// As a release, with the names of functions: for measuring its composition.
    Named,
}

/// A failure to make the module.
#[derive(Debug, thiserror::Error)]
pub(crate) enum BindgenError {
    #[error("could not run cargo: {0}")]
    Cargo(#[source] std::io::Error),
    #[error("a module does not build for {TARGET}. The reason is above")]
    Build,
    #[error("wasm-bindgen rejects {path}: {reason}")]
    Glue { path: PathBuf, reason: String },
    #[error("{path} cannot be rewritten: {reason}")]
    Rewrite { path: PathBuf, reason: String },
    #[error("{path}: {source}")]
    File { path: PathBuf, source: std::io::Error },
}

/// Builds modules and writes `NAME.js`, `NAME.d.ts` and `NAME_bg.wasm` of each into its folder.
pub(crate) fn run(root: &Path, modules: &[Module<'_>], profile: Profile) -> Result<(), BindgenError> {
    let compiled = compiled_modules(root, modules, profile)?;
    for module in modules {
        let file = compiled.join(module.package.replace('-', "_")).with_extension("wasm");
        let output = root.join(module.output);
        generate(&file, &output, module.name, profile)?;
        if !matches!(profile, Profile::Dev) {
            remove_panic_places(&output.join(format!("{}_bg.wasm", module.name)))?;
        }
        if !module.later.is_empty() {
            split_off(&output, module.name, module.later)?;
        }
    }
    Ok(())
}

/// The folder of the compiled modules.
fn compiled_modules(root: &Path, modules: &[Module<'_>], profile: Profile) -> Result<PathBuf, BindgenError> {
    let (flag, directory) = match profile {
        Profile::Dev => ("dev", "debug"),
        Profile::Release | Profile::Named => ("release", "release"),
    };
    // Cargo sets these variables for the programs that it runs.
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let target_dir =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |directory| root.join(directory));
    let status = Command::new(cargo)
        .current_dir(root)
        .args(["build", "--lib", "--target", TARGET, "--profile", flag, "--target-dir"])
        .arg(&target_dir)
        .args(modules.iter().flat_map(|module| ["--package", module.package]))
        .status()
        .map_err(BindgenError::Cargo)?;
    if !status.success() {
        return Err(BindgenError::Build);
    }
    Ok(target_dir.join(TARGET).join(directory))
}

fn generate(module: &Path, output: &Path, name: &str, profile: Profile) -> Result<(), BindgenError> {
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(module)
        .out_name(name)
        .typescript(true)
        .ts_typed_array_buffers(true)
        // The page compiles the module itself, so that the bundler need not follow an import to it.
        .omit_default_module_path(true)
        // Programs without a worker continue after a panic, with a new instance.
        .reset_state_function(name == SOLVER)
        .keep_debug(matches!(profile, Profile::Dev))
        .remove_name_section(matches!(profile, Profile::Release));
    bindgen
        .web(true)
        .and_then(|bindgen| bindgen.generate(output))
        .map_err(|error| BindgenError::Glue { path: module.to_owned(), reason: format!("{error:#}") })
}

fn remove_panic_places(path: &Path) -> Result<(), BindgenError> {
    let mut module = walrus::Module::from_buffer(&read(path)?)
        .map_err(|error| BindgenError::Rewrite { path: path.to_owned(), reason: format!("{error:#}") })?;
    panic_places::remove(&mut module);
    write(path, &module.emit_wasm())
}

/// Moves exports of a module into a later part, and adds the function that joins both to its glue.
fn split_off(output: &Path, name: &str, later: &[&str]) -> Result<(), BindgenError> {
    let is_later =
        |export: &str| later.iter().any(|&one| export == one || one.ends_with('_') && export.starts_with(one));
    let path = output.join(format!("{name}_bg.wasm"));
    let reason = |reason: String| BindgenError::Rewrite { path: path.clone(), reason };
    let parts = split(&read(&path)?, is_later).map_err(|error| reason(format!("{error:#}")))?;
    let Parts { first, later } = parts;
    let glue_path = output.join(format!("{name}.js"));
    let glue = String::from_utf8_lossy(&read(&glue_path)?).into_owned();
    let glue = joining_glue(&glue).ok_or_else(|| reason("its glue is not as expected".to_owned()))?;
    let types_path = output.join(format!("{name}.d.ts"));
    let types = [&read(&types_path)?[..], JOINING_TYPES.as_bytes()].concat();
    write(&path, &first)?;
    write(&output.join(format!("{name}_later_bg.wasm")), &later)?;
    write(&glue_path, glue.as_bytes())?;
    write(&types_path, &types)
}

fn read(path: &Path) -> Result<Vec<u8>, BindgenError> {
    std::fs::read(path).map_err(|source| BindgenError::File { path: path.to_owned(), source })
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), BindgenError> {
    std::fs::write(path, bytes).map_err(|source| BindgenError::File { path: path.to_owned(), source })
}
