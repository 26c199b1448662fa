/**
 * `node web/scripts/cycles.mjs`: fails if files or folders of the core or of the page import one another in a circle.
 *
 * The files and folders within each folder are the nodes of a graph. A folder has the imports of all its files. The
 * `mod.rs` of a folder is not a node of that folder's graph: it may use its children, and they may use its items. Unit
 * tests do not count.
 */
import { readFileSync } from 'node:fs';
import { join, posix, relative, sep } from 'node:path';
import { filesUnder } from './prose.mjs';
import { rustImports } from './rust_imports.mjs';
import { scriptImports } from './script_imports.mjs';
import { main, ROOT, StepError } from './steps.mjs';

/** @typedef {Map<string, string>} Sources The text of each file by its path in the source folder, with slashes. */
/** @typedef {Map<string, Set<string>>} Graph For each file the files that it imports. */

/** The face of a folder to others. */
const FACE = /^(?:mod|lib)\.rs$/;

/**
 * The cycles among the children of each folder.
 * @param {Graph} files
 * @returns {string[][]} Paths of the children, the first again at the end.
 */
export function folderCycles(files) {
  /** @type {Map<string, Graph>} */
  const folders = new Map();
  for (const [file, targets] of files) {
    for (const target of targets) {
      const [folder, from, to] = parted(file, target);
      if (FACE.test(from) || FACE.test(to)) continue;
      const graph = folders.get(folder) ?? new Map();
      folders.set(folder, graph);
      graph.set(from, (graph.get(from) ?? new Set()).add(to));
    }
  }
  return [...folders].flatMap(([folder, graph]) =>
    cycles(graph).map((cycle) => cycle.map((child) => posix.join(folder, child))),
  );
}

/**
 * @param {string} a
 * @param {string} b
 * @returns {[folder: string, childOfA: string, childOfB: string]} The deepest folder that holds both.
 */
function parted(a, b) {
  const [left, right] = [a.split('/'), b.split('/')];
  const at = left.findIndex((part, k) => part !== right[k]);
  return [left.slice(0, at).join('/'), left[at] ?? '', right[at] ?? ''];
}

/**
 * One cycle for each strongly connected component, by Tarjan's algorithm.
 * @param {Graph} graph
 * @returns {string[][]} A shortest cycle through the first node of each component.
 */
export function cycles(graph) {
  /** @type {Map<string, { index: number, low: number, onStack: boolean }>} */
  const states = new Map();
  /** @type {string[]} */
  const stack = [];
  /** @type {string[][]} */
  const found = [];
  const visit = (/** @type {string} */ file) => {
    const state = { index: states.size, low: states.size, onStack: true };
    states.set(file, state);
    stack.push(file);
    for (const next of graph.get(file) ?? []) {
      const known = states.get(next);
      if (!known) state.low = Math.min(state.low, visit(next).low);
      else if (known.onStack) state.low = Math.min(state.low, known.index);
    }
    if (state.low === state.index) {
      const component = stack.splice(stack.indexOf(file));
      for (const one of component) Object.assign(states.get(one) ?? {}, { onStack: false });
      if (component.length > 1) found.push(shortestCycle(graph, new Set(component)));
    }
    return state;
  };
  for (const file of [...graph.keys()].sort()) if (!states.has(file)) visit(file);
  return found;
}

/**
 * @param {Graph} graph
 * @param {Set<string>} component
 */
function shortestCycle(graph, component) {
  const first = [...component].sort()[0] ?? '';
  let paths = [[first]];
  const reached = new Set();
  while (paths.length > 0) {
    /** @type {string[][]} */
    const longer = [];
    for (const path of paths) {
      for (const next of graph.get(path.at(-1) ?? '') ?? []) {
        if (next === first) return [...path, first];
        if (!component.has(next) || reached.has(next)) continue;
        reached.add(next);
        longer.push([...path, next]);
      }
    }
    paths = longer;
  }
  return [first];
}

/**
 * @param {string} folder relative to the root
 * @param {RegExp} ending
 * @returns {Sources}
 */
function sourcesOf(folder, ending) {
  const files = filesUnder(join(ROOT, folder)).filter((file) => ending.test(file));
  const name = (/** @type {string} */ file) => relative(join(ROOT, folder), file).split(sep).join('/');
  return new Map(files.map((file) => [name(file), readFileSync(file, 'utf8')]));
}

/**
 * The imports that lead from each child of a cycle to the next.
 * @param {Graph} files
 * @param {string[]} cycle
 */
const importsOf = (files, cycle) =>
  [...files].flatMap(([file, targets]) =>
    [...targets]
      .filter((target) => cycle.some((from, k) => isIn(file, from) && isIn(target, cycle[k + 1] ?? '/')))
      .map((target) => `  ${file} imports ${target}`),
  );

/**
 * @param {string} file
 * @param {string} child
 */
const isIn = (file, child) => file === child || file.startsWith(`${child}/`);

if (process.argv[1] && import.meta.filename === process.argv[1]) {
  await main(async () => {
    let count = 0;
    for (const files of [
      rustImports(sourcesOf('wasm/core/src', /\.rs$/)),
      scriptImports(sourcesOf('web/src', /(?<!\.test)\.ts$/)),
    ]) {
      for (const cycle of folderCycles(files)) {
        count++;
        console.log([cycle.join(' → '), ...importsOf(files, cycle)].join('\n'));
      }
    }
    if (count > 0)
      throw new StepError(`${count} cycles of imports. Move the shared part to a file that imports neither.`);
  });
}
