//! Splits a WebAssembly module in two: the functions that a page needs at once, and those that it loads later.
//!
//! Both share the memory, the tables and the globals of the first part. The later part contains the functions that only
//! its own exports reach, and imports all others from the first. Nothing in the first part calls the later one, so the
//! first needs no stubs. Functions in tables remain in the first part, because any function may call them. So does all
//! data.

use std::collections::HashMap;

use walrus::{
    Export, ExportItem, FunctionId, FunctionKind, GlobalKind, Import, ImportKind, ImportedFunction, Module, passes::gc,
};

/// The name under which the later part imports the first.
const FIRST: &str = "first";

/// The two parts of a module, as bytes.
pub(crate) struct Parts {
    pub(crate) first: Vec<u8>,
    pub(crate) later: Vec<u8>,
}

/// Splits a module by the names of its exports.
///
/// # Errors
/// For bytes that are not a module.
pub(crate) fn split(bytes: &[u8], is_later: impl Fn(&str) -> bool) -> walrus::Result<Parts> {
    let mut first = Module::from_buffer(bytes)?;
    retain_exports(&mut first, |name| !is_later(name));
    gc::run(&mut first);
    let of_first = functions(&first);
    let mut later = Module::from_buffer(bytes)?;
    retain_exports(&mut later, is_later);
    import_from_first(&mut later, &of_first);
    gc::run(&mut later);
    export_to_later(&mut first, &later, &of_first);
    Ok(Parts { first: first.emit_wasm(), later: later.emit_wasm() })
}

/// The additions to the generated glue for a later part: a function that adds it, and its type.
///
/// After a panic, the new instance gets the later part again. `None` if the glue has an unexpected structure.
pub(crate) fn joining_glue(glue: &str) -> Option<String> {
    const REPLACED: &str = "wasm = wasmInstance.exports;\n    wasm.__wbindgen_start();";
    let (before, after) = glue.split_once(REPLACED)?;
    Some(format!(
        "{before}wasm = joined();\n    wasm.__wbindgen_start();{after}
let laterModule;
function joined() {{
    const first = wasmInstance.exports;
    if (!laterModule) return first;
    const later = new WebAssembly.Instance(laterModule, {{ ...__wbg_get_imports(), {FIRST}: first }});
    return {{ ...first, ...later.exports }};
}}
export function join_later(module) {{
    laterModule = module;
    wasm = joined();
}}
"
    ))
}

/// The declaration of the function that [`joining_glue`] adds.
pub(crate) const JOINING_TYPES: &str = "
/** Adds the later part of the module, once that is instantiated. Without it, its functions are missing. */
export function join_later(module: WebAssembly.Module): void;
";

fn retain_exports(module: &mut Module, is_kept: impl Fn(&str) -> bool) {
    let others = module.exports.iter().filter(|export| !is_kept(&export.name));
    let others: Vec<_> = others.map(Export::id).collect();
    others.into_iter().for_each(|id| module.exports.delete(id));
}

/// The functions of a module that have a body, by their index in the whole module.
fn functions(module: &Module) -> HashMap<usize, FunctionId> {
    module.funcs.iter_local().map(|(id, _)| (id.index(), id)).collect()
}

/// Turns everything in the first part into imports from it.
fn import_from_first(later: &mut Module, of_first: &HashMap<usize, FunctionId>) {
    later.start = None;
    for (at, id) in functions(later).into_iter().filter(|(at, _)| of_first.contains_key(at)) {
        let import = later.imports.add(FIRST, &format!("f{at}"), id);
        let function = later.funcs.get_mut(id);
        function.kind = FunctionKind::Import(ImportedFunction { import, ty: function.ty() });
    }
    for memory in later.memories.iter_mut() {
        memory.data_segments.clear();
        memory.import = Some(later.imports.add(FIRST, &format!("m{}", memory.id().index()), memory.id()));
    }
    for table in later.tables.iter_mut() {
        table.elem_segments.clear();
        table.import = Some(later.imports.add(FIRST, &format!("t{}", table.id().index()), table.id()));
    }
    let globals: Vec<_> = later.globals.iter().map(walrus::Global::id).collect();
    for id in globals {
        let import = later.imports.add(FIRST, &format!("g{}", id.index()), id);
        later.globals.get_mut(id).kind = GlobalKind::Import(import);
    }
    let data: Vec<_> = later.data.iter().map(walrus::Data::id).collect();
    data.into_iter().for_each(|id| later.data.delete(id));
    let elements: Vec<_> = later.elements.iter().map(walrus::Element::id).collect();
    elements.into_iter().for_each(|id| later.elements.delete(id));
}

/// Exports everything that the later part imports.
fn export_to_later(first: &mut Module, later: &Module, of_first: &HashMap<usize, FunctionId>) {
    for import in later.imports.iter().filter(|import| import.module == FIRST) {
        let item = item_of_first(first, import, of_first).expect("the first part has all shared items");
        first.exports.add(&import.name, item);
    }
}

fn item_of_first(first: &Module, import: &Import, of_first: &HashMap<usize, FunctionId>) -> Option<ExportItem> {
    match import.kind {
        ImportKind::Function(id) => of_first.get(&id.index()).map(|&id| id.into()),
        ImportKind::Memory(id) => {
            first.memories.iter().map(walrus::Memory::id).find(|one| one.index() == id.index()).map(Into::into)
        }
        ImportKind::Table(id) => {
            first.tables.iter().map(walrus::Table::id).find(|one| one.index() == id.index()).map(Into::into)
        }
        ImportKind::Global(id) => {
            first.globals.iter().map(walrus::Global::id).find(|one| one.index() == id.index()).map(Into::into)
        }
        ImportKind::Tag(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use walrus::{FunctionBuilder, ModuleConfig, ValType};

    use super::*;

    /// A module with a function that both exports call, and one that a single export calls.
    fn module() -> Vec<u8> {
        let mut module = Module::with_config(ModuleConfig::new());
        let memory = module.memories.add_local(false, false, 1, None, None);
        module.exports.add("memory", memory);
        let shared = returning(&mut module, |body| {
            body.i32_const(1);
        });
        let rare = returning(&mut module, |body| {
            body.i32_const(2);
        });
        let often = returning(&mut module, |body| {
            body.call(shared);
        });
        let seldom = returning(&mut module, |body| {
            body.call(shared).drop().call(rare);
        });
        module.exports.add("often", often);
        module.exports.add("seldom", seldom);
        module.emit_wasm()
    }

    fn returning(module: &mut Module, write: impl Fn(&mut walrus::InstrSeqBuilder<'_>)) -> FunctionId {
        let mut builder = FunctionBuilder::new(&mut module.types, &[], &[ValType::I32]);
        write(&mut builder.func_body());
        builder.finish(Vec::new(), &mut module.funcs)
    }

    #[test]
    fn later_part_has_functions_that_only_its_exports_reach() {
        let parts = split(&module(), |name| name == "seldom").unwrap();
        let (first, later) = (Module::from_buffer(&parts.first).unwrap(), Module::from_buffer(&parts.later).unwrap());
        assert_eq!(first.funcs.iter_local().count(), 2);
        assert_eq!(later.funcs.iter_local().count(), 2);
        let exports: Vec<&str> = later.exports.iter().map(|export| export.name.as_str()).collect();
        assert_eq!(exports, ["seldom"]);
        let shared: Vec<&str> = later.imports.iter().map(|import| import.name.as_str()).collect();
        assert_eq!(shared.len(), 1);
        assert!(first.exports.iter().any(|export| export.name == shared[0]));
    }

    #[test]
    fn unexpected_glue_is_rejected() {
        assert_eq!(joining_glue("wasm = instance.exports;"), None);
    }
}
