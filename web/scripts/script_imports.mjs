/** The imports between TypeScript files, including type imports. */
import { posix } from 'node:path';
import { scriptSpans } from './spans.mjs';

const IMPORT = /(?:\bfrom|\bimport|\bimport\s*\()\s*$/;

/**
 * @param {import('./cycles.mjs').Sources} sources
 * @returns {import('./cycles.mjs').Graph}
 */
export function scriptImports(sources) {
  return new Map([...sources].map(([file, text]) => [file, new Set(targets(file, text, sources))]));
}

/**
 * @param {string} file
 * @param {string} text
 * @param {import('./cycles.mjs').Sources} sources
 */
function targets(file, text, sources) {
  return scriptSpans(text)
    .filter(({ kind, start }) => kind === 'string' && IMPORT.test(text.slice(Math.max(0, start - 20), start)))
    .map(({ start, end }) => text.slice(start + 1, end - 1))
    .filter((path) => path.startsWith('.'))
    .map((path) => posix.join(posix.dirname(file), path.replace(/\.js$/, '')))
    .flatMap((path) => [path, `${path}.ts`, `${path}/index.ts`])
    .filter((path) => sources.has(path) && path !== file);
}
