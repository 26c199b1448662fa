/** The functions and the data of a WebAssembly module, in groups. The names come from its name section. */
import { brotliCompressSync } from 'node:zlib';

const SECTION = { custom: 0, import: 2, code: 10, data: 11 };

/** The part of a custom section "name" that has the names of functions. */
const FUNCTION_NAMES = 1;

/** The first pattern that matches the name of a function determines its group. */
const GROUPS = /** @type {const} */ ([
  [/core::slice::sort/, 'sorts of the standard library'],
  [/^<?c2warp::project::json|serde|c2warp::project/, 'project and JSON'],
  [/^<?c2warp::(pose|deform|clip|bone|weight)\b/, 'poses, folds and clips'],
  [/^<?c2warp::(site|distance|domain|solver|solve_input|pipeline|solution)\b/, 'sites, distances, domain'],
  [/^<?c2warp::(sample|triangulation)\b|spade|robust/, 'samples and triangulation'],
  [/^<?c2warp::suggest/, 'suggested handles'],
  [/^<?c2warp::(fill|solver_fill)/, 'fills'],
  [/^<?c2warp::raster/, 'drawings'],
  [/^<?c2warp/, 'other modules of the core'],
  [/core::fmt|flt2dec|alloc::fmt|core::num/, 'formatting'],
  [/hashbrown|btree|HashMap/, 'maps and sets'],
  [/::/, 'iterators, vectors, memory'],
  [/./, 'border to JavaScript'],
]);

/** @typedef {{ name: string, raw: number, brotli: number }} Group Sizes in bytes. */

/**
 * The groups of a module, the largest first. Each group is compressed separately. Their sizes are scaled to that of the
 * module, which compresses better as a whole.
 * @param {Uint8Array} module with a name section
 * @returns {Group[]}
 */
export function moduleGroups(module) {
  /** @type {Map<string, Uint8Array[]>} */
  const groups = new Map();
  const { functions, data } = parts(module);
  for (const { name, body } of functions) {
    const group = GROUPS.find(([pattern]) => pattern.test(name))?.[1] ?? 'unnamed';
    groups.set(group, [...(groups.get(group) ?? []), body]);
  }
  groups.set('data: tables, texts', data);
  const sizes = [...groups].map(([name, pieces]) => {
    const bytes = Buffer.concat(pieces);
    return { name, raw: bytes.length, brotli: brotliCompressSync(bytes).length };
  });
  const alone = sizes.reduce((sum, { brotli }) => sum + brotli, 0);
  const whole = brotliCompressSync(Buffer.concat([...groups.values()].flat())).length;
  const scaled = sizes.map((group) => ({ ...group, brotli: (group.brotli * whole) / alone }));
  return scaled.sort((one, other) => other.brotli - one.brotli);
}

/**
 * @param {Uint8Array} module
 * @returns {{ functions: { name: string, body: Uint8Array }[], data: Uint8Array[] }}
 */
function parts(module) {
  const reader = new Reader(module, 8);
  let imported = 0;
  /** @type {Uint8Array[]} */
  const bodies = [];
  /** @type {Map<number, string>} */
  const names = new Map();
  /** @type {Uint8Array[]} */
  const data = [];
  while (reader.at < module.length) {
    const id = reader.byte();
    const section = new Reader(reader.bytes(reader.number()));
    if (id === SECTION.import) imported = importedFunctions(section);
    else if (id === SECTION.code)
      for (let count = section.number(); count > 0; count--) bodies.push(section.bytes(section.number()));
    else if (id === SECTION.data) data.push(section.rest());
    else if (id === SECTION.custom && section.text() === 'name') readNames(section, names);
  }
  const functions = bodies.map((body, at) => ({ name: names.get(imported + at) ?? '', body }));
  return { functions, data };
}

/**
 * @param {Reader} section
 * @param {Map<number, string>} names
 */
function readNames(section, names) {
  while (!section.isAtEnd) {
    const kind = section.byte();
    const part = new Reader(section.bytes(section.number()));
    if (kind === FUNCTION_NAMES)
      for (let count = part.number(); count > 0; count--) names.set(part.number(), part.text());
  }
}

/**
 * Counts the functions among imports.
 * @param {Reader} section
 */
function importedFunctions(section) {
  let functions = 0;
  for (let count = section.number(); count > 0; count--) {
    section.text();
    section.text();
    const kind = section.byte();
    if (kind === 0) {
      section.number();
      functions++;
    } else if (kind === 3) {
      // A global: its type, and whether it changes.
      section.bytes(2);
    } else {
      // A table has a type before its limits.
      if (kind === 1) section.byte();
      const hasMost = section.number() & 1;
      section.number();
      if (hasMost) section.number();
    }
  }
  return functions;
}

/** Reads the encodings of the binary format. */
class Reader {
  at;
  #all;

  /**
   * @param {Uint8Array} all
   * @param {number} at
   */
  constructor(all, at = 0) {
    this.#all = all;
    this.at = at;
  }

  get isAtEnd() {
    return this.at >= this.#all.length;
  }

  byte() {
    return this.#all[this.at++] ?? 0;
  }

  /** An unsigned number in LEB128. */
  number() {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.byte();
      value += (byte & 127) * factor;
      if (byte < 128) return value;
    }
  }

  /** @param {number} length */
  bytes(length) {
    this.at += length;
    return this.#all.subarray(this.at - length, this.at);
  }

  text() {
    return new TextDecoder().decode(this.bytes(this.number()));
  }

  rest() {
    return this.bytes(this.#all.length - this.at);
  }
}
