//! Removes panic locations from the data of a module: paths of source files, lines and columns.
//!
//! The standard library writes them to the standard error output, which pages do not have. A page only receives the
//! trap. Locations take two hundredths of a download, and contain paths of the build machine.

use std::ops::Range;

use walrus::{ConstExpr, Data, DataId, DataKind, Module, ir::Value};

/// Bytes of a `core::panic::Location` in WebAssembly: address and length of the path, line, column.
const PLACE: usize = 16;

/// Larger numbers are not lines, columns or lengths of paths.
const MOST_LINES: u32 = 100_000;
const MOST_COLUMNS: u32 = 2_000;
const LONGEST_PATH: u32 = 300;

/// Sets all panic locations in the data, and their paths, to zero.
pub(crate) fn remove(module: &mut Module) {
    let segments: Vec<(DataId, usize)> =
        module.data.iter().filter_map(|data| Some((data.id(), address(data)?))).collect();
    let mut found: Vec<(DataId, Range<usize>)> = Vec::new();
    for &(id, start) in &segments {
        let bytes = &module.data.get(id).value;
        // Addresses of places are multiples of four.
        for at in (start.next_multiple_of(4) - start..bytes.len().saturating_sub(PLACE - 1)).step_by(4) {
            let Some([path, length, line, column]) = numbers(&bytes[at..]) else { continue };
            let is_place = (1..MOST_LINES).contains(&line) && (1..MOST_COLUMNS).contains(&column);
            if !is_place || length > LONGEST_PATH {
                continue;
            }
            if let Some(path) = path_at(module, &segments, path as usize, length as usize) {
                found.extend([(id, at..at + PLACE), path]);
            }
        }
    }
    for (id, range) in found {
        module.data.get_mut(id).value[range].fill(0);
    }
}

fn address(data: &Data) -> Option<usize> {
    match data.kind {
        DataKind::Active { offset: ConstExpr::Value(Value::I32(start)), .. } => usize::try_from(start).ok(),
        _ => None,
    }
}

fn numbers(bytes: &[u8]) -> Option<[u32; 4]> {
    let (numbers, _) = bytes.first_chunk::<PLACE>()?.as_chunks::<4>();
    Some([0, 1, 2, 3].map(|k| u32::from_le_bytes(numbers[k])))
}

/// The path of a Rust file at an address.
fn path_at(
    module: &Module,
    segments: &[(DataId, usize)],
    address: usize,
    length: usize,
) -> Option<(DataId, Range<usize>)> {
    segments.iter().find_map(|&(id, start)| {
        let from = address.checked_sub(start)?;
        let path = module.data.get(id).value.get(from..from + length)?;
        path.ends_with(b".rs").then_some((id, from..from + length))
    })
}

#[cfg(test)]
mod tests {
    use walrus::ModuleConfig;

    use super::*;

    #[test]
    fn locations_and_their_paths_become_zeros_and_other_data_is_kept() {
        let mut module = Module::with_config(ModuleConfig::new());
        let memory = module.memories.add_local(false, false, 1, None, None);
        let place: Vec<u8> = [1000_u32, 6, 12, 5].iter().flat_map(|number| number.to_le_bytes()).collect();
        let value = [b"lib.rstext.rs ", &[0; 2][..], &place, &[7; PLACE]].concat();
        let offset = ConstExpr::Value(Value::I32(1000));
        let id = module.data.add(DataKind::Active { memory, offset }, value);
        remove(&mut module);
        let expected = [&[0; 6][..], b"text.rs ", &[0; 2], &[0; PLACE], &[7; PLACE]].concat();
        assert_eq!(module.data.get(id).value[..], expected[..]);
    }
}
