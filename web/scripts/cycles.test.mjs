import { describe, expect, it } from 'vitest';
import { cycles, folderCycles } from './cycles.mjs';
import { rustImports } from './rust_imports.mjs';
import { scriptImports } from './script_imports.mjs';

/** @param {Record<string, string[]>} edges */
const graph = (edges) => new Map(Object.entries(edges).map(([file, targets]) => [file, new Set(targets)]));

describe('cycles', () => {
  it('are found once for each tangle', () => {
    expect(cycles(graph({ a: ['b'], b: ['c'], c: ['a', 'b'], d: ['a'], e: [] }))).toEqual([
      ['a', 'b', 'c', 'a'],
    ]);
    expect(cycles(graph({ a: ['b', 'c'], b: ['c'], c: [] }))).toEqual([]);
  });

  it('are found between folders that import one another by different files', () => {
    expect(folderCycles(graph({ 'a/b/one.ts': ['a/c/two.ts'], 'a/c/three.ts': ['a/b/four.ts'] }))).toEqual([
      ['a/b', 'a/c', 'a/b'],
    ]);
  });

  it('are not those of a module and its children', () => {
    expect(folderCycles(graph({ 'a/mod.rs': ['a/b.rs'], 'a/b.rs': ['a/mod.rs', 'lib.rs'] }))).toEqual([]);
  });
});

describe('imports of Rust', () => {
  const imports = (/** @type {Record<string, string>} */ files) =>
    Object.fromEntries(
      [...rustImports(new Map(Object.entries(files)))].map(([file, targets]) => [file, [...targets]]),
    );

  it('lead through re-exports to the file of the item', () => {
    const files = {
      'lib.rs': 'mod a;\nmod d;\npub use a::B;\npub use d::run;',
      'a/mod.rs':
        'mod b;\nmod c;\npub use b::B;\npub(crate) use self::c::{C as Short, D};\nfn f(_: Short) {}',
      'a/b.rs': 'use super::{Own, c::C};\npub struct B;',
      'a/c.rs': 'pub struct C;',
      'd.rs': 'use std::fmt;\nuse crate::{B, a::{self, Short}};\nfn run() { crate::a::b::B::new(); }',
    };
    expect(imports(files)).toEqual({
      'lib.rs': [],
      'a/mod.rs': ['a/c.rs'],
      'a/b.rs': ['a/mod.rs', 'a/c.rs'],
      'a/c.rs': [],
      'd.rs': ['a/b.rs', 'a/mod.rs', 'a/c.rs'],
    });
  });

  it('are not those of comments, strings and unit tests', () => {
    const a = `// use crate::b::B;
const TEXT: &str = "use crate::b::B;";
#[cfg(test)]
mod tests {
    use crate::b::B;
}`;
    expect(imports({ 'lib.rs': '', 'a.rs': a, 'b.rs': '' })['a.rs']).toEqual([]);
  });
});

describe('imports of scripts', () => {
  it('are those of values, of types and in functions', () => {
    const a = `import { b } from './b';
import type { C } from '../d/c';
import './styles.css';
// import './no';
const text = "import './no'";
const e = () => import('./e.js');`;
    const files = { 'a/a.ts': a, 'a/b.ts': '', 'd/c.ts': '', 'a/e.ts': '', 'a/no.ts': '' };
    const found = scriptImports(new Map(Object.entries(files))).get('a/a.ts');
    expect([...(found ?? [])]).toEqual(['a/b.ts', 'd/c.ts', 'a/e.ts']);
  });
});
