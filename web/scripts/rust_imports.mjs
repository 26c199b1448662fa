/**
 * The imports between files of a Rust crate.
 *
 * Imports are followed through re-exports to the file that defines the item. A `mod.rs` or `lib.rs` does not depend on
 * children that it only re-exports. Unit tests at the end of a file do not count.
 *
 * Known limits: globs resolve to the module itself, and macros are not followed.
 */
import { rustSpans } from './spans.mjs';

/** @typedef {{ path: string[], name: string, isExport: boolean }} Use `name` is the name in this file. */
/** @typedef {{ file: string, path: string[], uses: Use[], code: string }} Module `code` is without its uses. */

const TESTS = /#\[cfg\((?:all\()?test\b[^\]]*\]\s*(?:pub(?:\([^)]*\))? )?mod \w+ \{/;
const USE = /^([^\S\n]*)(pub(?:\([^)]*\))? )?use ([^;]+);/gm;
const INLINE = /(?<![\w:])((?:crate|self|super|[a-z]\w*)(?:::\w+)+)/g;

/**
 * @param {import('./cycles.mjs').Sources} sources with `lib.rs`
 * @returns {import('./cycles.mjs').Graph}
 */
export function rustImports(sources) {
  const modules = new Map(
    [...sources].map(([file, text]) => [pathOf(file).join('::'), moduleOf(file, text)]),
  );
  /** @type {import('./cycles.mjs').Graph} */
  const graph = new Map();
  for (const module of modules.values()) {
    const uses = module.uses.filter(
      ({ name, isExport }) => !isExport || new RegExp(`\\b${name}\\b`).test(module.code),
    );
    const inline = [...module.code.matchAll(INLINE)].map(([, path = '']) => path.split('::'));
    const targets = [...uses.map(({ path }) => path), ...inline].map((path) =>
      definer(modules, module, path),
    );
    const files = targets.flatMap((target) => (target && target !== module ? [target.file] : []));
    graph.set(module.file, new Set(files));
  }
  return graph;
}

/** @param {string} file */
const pathOf = (file) =>
  file
    .replace(/\.rs$/, '')
    .split('/')
    .filter((part, at, { length }) => at < length - 1 || !['mod', 'lib'].includes(part));

/**
 * @param {string} file
 * @param {string} text
 * @returns {Module}
 */
function moduleOf(file, text) {
  let plain = text;
  for (const { start, end } of rustSpans(text).reverse())
    plain = `${plain.slice(0, start)} ${plain.slice(end)}`;
  plain = plain.slice(0, TESTS.exec(plain)?.index);
  const uses = [...plain.matchAll(USE)].flatMap(([, , visibility, tree = '']) =>
    leaves(tree).map((path) => {
      const [last = '', alias] = (path.at(-1) ?? '').split(/\s+as\s+/);
      const whole = [...path.slice(0, -1), ...(last === 'self' ? [] : [last])];
      return { path: whole, name: alias ?? whole.at(-1) ?? '', isExport: visibility !== undefined };
    }),
  );
  return { file, path: pathOf(file), uses, code: plain.replaceAll(USE, '') };
}

/**
 * The paths of a tree of imports.
 * @param {string} tree such as `a::{b, c::{self, d}}`
 * @returns {string[][]}
 */
function leaves(tree) {
  const open = tree.indexOf('{');
  if (open < 0) return [tree.trim().split(/\s*::\s*/)];
  const prefix = tree
    .slice(0, open)
    .trim()
    .split(/\s*::\s*/)
    .filter((part) => part !== '');
  return branches(tree.slice(open + 1, tree.lastIndexOf('}'))).flatMap((branch) =>
    leaves(branch).map((path) => [...prefix, ...path]),
  );
}

/**
 * Splits at commas outside of braces.
 * @param {string} list
 */
function branches(list) {
  let depth = 0;
  const parts = [''];
  for (const letter of list) {
    if (letter === '{') depth++;
    if (letter === '}') depth--;
    if (letter === ',' && depth === 0) parts.push('');
    else parts[parts.length - 1] += letter;
  }
  return parts.filter((part) => part.trim() !== '');
}

/**
 * The module that defines the item of a path; `undefined` for other crates and for names of the file itself.
 * @param {Map<string, Module>} modules
 * @param {Module} from
 * @param {string[]} path
 * @param {number} [steps] Re-exports passed so far, so that a mistaken reading ends.
 * @returns {Module | undefined}
 */
function definer(modules, from, path, steps = 0) {
  let at = [...from.path];
  const rest = [...path];
  const [first = ''] = rest;
  const isChild = modules.has([...at, first].join('::'));
  if (first === 'crate') at = [];
  else if (first === 'super') at.pop();
  else if (first !== 'self' && !isChild) return undefined;
  if (!isChild) rest.shift();
  while (rest[0] === 'super') {
    at.pop();
    rest.shift();
  }
  while (rest.length > 0 && modules.has([...at, rest[0]].join('::'))) at.push(rest.shift() ?? '');
  const module = modules.get(at.join('::'));
  const use = module?.uses.find(({ name }) => name === rest[0]);
  if (!module || !use || steps > 9 || module === from) return module;
  return definer(modules, module, [...use.path, ...rest.slice(1)], steps + 1) ?? module;
}
