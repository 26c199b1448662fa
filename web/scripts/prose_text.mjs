/**
 * The prose of a file: paragraphs of its comments or of its Markdown, and names of its tests.
 *
 * Code, tables, addresses and the markup of comments, lists and links are left out. A code span counts as one word.
 */
import { rustSpans, scriptSpans } from './spans.mjs';

/** @typedef {{ line: number, text: string }} Line A line of prose, without the marks of its comment or list. */
/** @typedef {{ paragraphs: Line[][], names: Line[] }} Prose `names` are those of tests. */

const ITEM = /^\s*(?:[-*+]|\d+\.)\s+/;
const HEADING = /^#{1,6} /;
const TAG = /^\s*@\w+/;
const FENCE = /^\s*(?:```|~~~)/;
const INDENTED = /^ {4,}\S/;
/** Rows of tables, lines of HTML, targets of links, and rules. */
const NO_PROSE = /^\s*(?:\||<[/!a-z]|\[[^\]]+\]:|[-=*]{3,}\s*$)/;

const RUST_TEST = /#\[test\]\s*(?:#\[[^\]]*\]\s*)*fn\s+(\w+)/g;
const SCRIPT_TEST = /(?:\b(?:it|test|describe)(?:\.\w+)*|\))\(\s*$/;

/**
 * @param {string} file Its ending selects the language.
 * @param {string} text
 * @returns {Prose | undefined} `undefined` for files of other languages.
 */
export function proseOf(file, text) {
  if (file.endsWith('.md')) return { paragraphs: paragraphs(numbered(text)), names: [] };
  if (file.endsWith('.rs')) return { paragraphs: inComments(text, rustSpans(text)), names: rustNames(text) };
  if (!/\.(?:[mc]?[jt]s|glsl)$/.test(file)) return undefined;
  const spans = scriptSpans(text);
  const isTest = /\.(?:test|spec)\.\w+$/.test(file);
  return { paragraphs: inComments(text, spans), names: isTest ? scriptNames(text, spans) : [] };
}

/**
 * @param {string} text
 * @param {number} [first] The number of the first line.
 * @returns {Line[]}
 */
const numbered = (text, first = 1) => text.split('\n').map((line, k) => ({ line: first + k, text: line }));

/**
 * @param {string} text
 * @param {number} offset
 */
const lineAt = (text, offset) => text.slice(0, offset).split('\n').length;

/** @param {string} text */
const rustNames = (text) =>
  [...text.matchAll(RUST_TEST)].map(({ 0: match, 1: name = '', index }) => ({
    line: lineAt(text, index + match.length),
    text: name,
  }));

/**
 * @param {string} text
 * @param {import('./spans.mjs').Span[]} spans
 */
const scriptNames = (text, spans) =>
  spans
    .filter(
      ({ kind, start }) => kind === 'string' && SCRIPT_TEST.test(text.slice(Math.max(0, start - 80), start)),
    )
    .map(({ start, end }) => ({
      line: lineAt(text, start),
      text: text.slice(start + 1, end).replace(/['"`]$/, ''),
    }));

/**
 * Paragraphs of comments. Line comments of one kind that follow one another are one text.
 * @param {string} text
 * @param {import('./spans.mjs').Span[]} spans
 */
function inComments(text, spans) {
  /** @type {Line[][]} */
  const blocks = [];
  let before = '';
  for (const { kind, start, end } of spans) {
    if (kind !== 'comment') continue;
    const first = lineAt(text, start);
    const mark = /^(?:\/\/[/!]?|\/\*)/.exec(text.slice(start, end))?.[0] ?? '';
    const lines = numbered(text.slice(start, end), first).map((line) => ({
      ...line,
      text: unmarked(line.text, mark),
    }));
    const alone = /(?:^|\n)[^\S\n]*$/.test(text.slice(0, start));
    const goesOn = alone && mark === before && mark !== '/*' && blocks.at(-1)?.at(-1)?.line === first - 1;
    if (goesOn) blocks.at(-1)?.push(...lines);
    else blocks.push(lines);
    before = alone ? mark : '';
  }
  return blocks.flatMap(paragraphs);
}

/**
 * @param {string} line
 * @param {string} mark
 */
const unmarked = (line, mark) =>
  mark === '/*'
    ? line.replace(/^\s*(?:\/\*[*!]?|\*(?!\/))? ?/, '').replace(/\s*\*\/$/, '')
    : line.slice(mark.length).replace(/^ /, '');

/**
 * Splits Markdown into paragraphs. Items of lists, headings and tags (`@param`) are paragraphs of their own.
 * @param {Line[]} lines
 */
function paragraphs(lines) {
  /** @type {Line[][]} */
  const found = [];
  /** @type {Line[]} */
  let open = [];
  const close = () => {
    if (open.length > 0) found.push(open);
    open = [];
  };
  let fenced = false;
  for (const { line, text } of lines) {
    if (FENCE.test(text)) fenced = !fenced;
    if (fenced || FENCE.test(text) || NO_PROSE.test(text) || (INDENTED.test(text) && open.length === 0)) {
      close();
      continue;
    }
    if (ITEM.test(text) || HEADING.test(text) || TAG.test(text)) close();
    const words = plain(text);
    if (words !== '') open.push({ line, text: words });
    if (text.trim() === '' || HEADING.test(text)) close();
  }
  close();
  return found;
}

/** @param {string} text */
const plain = (text) =>
  text
    .replace(ITEM, '')
    .replace(HEADING, '')
    .replace(/^\s*@\w+\s*(?:\{.*\}\s*)?/, '')
    .replaceAll(/`[^`]*`/g, 'Code')
    .replaceAll(/!?\[([^\]]*)\](?:\([^)]*\)|\[[^\]]*\])/g, '$1')
    .replaceAll(/https?:\S+/g, 'Address')
    .trim();
