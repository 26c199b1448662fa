//! `xtask bindgen`: the editor's WebAssembly modules with their TypeScript glue, or one of another crate.
//!
//! Builds crates for `wasm32-unknown-unknown` and passes the results to `wasm-bindgen`. That is a library here, in
//! the version that the crates are compiled with. So nothing must be installed, and versions always match. Takes half a
//! second if nothing has changed.
//!
//! One run of cargo builds all modules. They share what they depend on, and their last steps run side by side.

use std::path::{Path, PathBuf};
use std::process::Command;

use wasm_bindgen_cli_support::Bindgen;

const TARGET: &str = "wasm32-unknown-unknown";

/// A module: its crate, the folder to write it into, from the root of the repository, and the name of its files.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Module<'a> {
    pub(crate) package: &'a str,
    pub(crate) output: &'a Path,
    pub(crate) name: &'a str,
}

/// The name of a solver's files, also of its benchmark's.
pub(crate) const SOLVER: &str = "c2warp";

/// The modules that the editor loads: the solver, and the makers of films and of other exports when they are needed.
pub(crate) fn editor_modules() -> [Module<'static>; 3] {
    let solver = Module { package: "c2warp-bind", output: Path::new("web/src/compute/generated"), name: SOLVER };
    let film = Module { package: "c2warp-film-bind", output: Path::new("web/src/io/generated"), name: "film" };
    let export = Module { package: "c2warp-export-bind", output: solver.output, name: "c2warp_export" };
    [solver, film, export]
}

/// The profile of cargo for the module.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Profile {
    /// Builds quickly and keeps the names of functions, for profiling and stack traces.
    Dev,
    /// The module of a published editor.
    Release,
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
}

/// Builds modules and writes `NAME.js`, `NAME.d.ts` and `NAME_bg.wasm` of each into its folder.
pub(crate) fn run(root: &Path, modules: &[Module<'_>], profile: Profile) -> Result<(), BindgenError> {
    let compiled = compiled_modules(root, modules, profile)?;
    for module in modules {
        let file = compiled.join(module.package.replace('-', "_")).with_extension("wasm");
        generate(&file, &root.join(module.output), module.name, profile)?;
    }
    Ok(())
}

/// The folder of the compiled modules.
fn compiled_modules(root: &Path, modules: &[Module<'_>], profile: Profile) -> Result<PathBuf, BindgenError> {
    let (flag, directory) = match profile {
        Profile::Dev => ("dev", "debug"),
        Profile::Release => ("release", "release"),
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
        // Programs without a worker go on after a panic, with a new instance.
        .reset_state_function(name == SOLVER)
        .keep_debug(matches!(profile, Profile::Dev))
        .remove_name_section(matches!(profile, Profile::Release));
    bindgen
        .web(true)
        .and_then(|bindgen| bindgen.generate(output))
        .map_err(|error| BindgenError::Glue { path: module.to_owned(), reason: format!("{error:#}") })
}
