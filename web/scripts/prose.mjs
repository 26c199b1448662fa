/**
 * Measures the prose of the repository: comments, Markdown and names of tests.
 *
 *     node web/scripts/prose.mjs [PATHS…]             prints each finding, and a summary of each folder
 *     node web/scripts/prose.mjs --summary [PATHS…]   prints only the summary
 *     node web/scripts/prose.mjs --limits             fails if the whole tree exceeds `LIMITS`
 *
 * For comparison, the folder `src` of linebender/kurbo 0.13.1 has 21,417 words of comments. There are 4 lines longer
 * than 120 columns. 5.3 % of the sentences have more than 25 words. Per 1,000 words it has 0.4 "what", 2.1 "which".
 */
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join, relative, resolve, sep } from 'node:path';
import { proseOf } from './prose_text.mjs';
import { main, ROOT, StepError } from './steps.mjs';

/** @typedef {import('./prose_text.mjs').Line} Line */
/** @typedef {{ file: string, line: number, message: string }} Finding */
/** @typedef {Record<'words' | 'sentences' | 'long' | 'lines' | 'names' | 'what' | 'which', number>} Sums */

/** Columns of a line, words of a sentence, characters of a test's name. */
const LONGEST = { line: 120, sentence: 25, name: 80 };

/**
 * The limits of `npm run check` for the whole tree. Long lines and names are counted. Long sentences are a percentage
 * of all sentences, "what" and "which" are per 1,000 words.
 */
export const LIMITS = { lines: 0, names: 0, long: 1, what: 1, which: 2.1 };

/** Folders of other people's files, of generated files, and of files that tests read or write. */
const SKIPPED =
  /^(?:node_modules|target|dist|dist-site|generated|output|golden|scenes|test-results|playwright-report|\..+)$/;

/**
 * Splits a paragraph into sentences.
 * @param {Line[]} paragraph
 * @returns {Line[]} Each with the number of its first line.
 */
export function sentences(paragraph) {
  /** @type {Line[]} */
  const found = [];
  const whole = paragraph.map(({ text }) => text).join(' ');
  const ends = paragraph.map((_, k) =>
    paragraph.slice(0, k + 1).reduce((sum, { text }) => sum + text.length + 1, 0),
  );
  let from = 0;
  for (const text of whole.split(
    /(?<=[.!?][)"”’*_]*)(?<!\b(?:e\.g|i\.e|vs|cf|\p{Lu})\.)\s(?=[("“‘*_[]*\p{Lu})/u,
  )) {
    found.push({ line: paragraph[ends.findIndex((end) => from < end)]?.line ?? 0, text });
    from += text.length + 1;
  }
  return found.filter(({ text }) => wordsOf(text).length > 0);
}

/** @param {string} text */
const wordsOf = (text) => text.match(/[\p{L}\p{N}][\p{L}\p{N}'’²-]*/gu) ?? [];

/**
 * @param {string} file Its ending selects the language.
 * @param {string} text
 * @returns {{ findings: Finding[], sums: Sums } | undefined} `undefined` for files without prose.
 */
export function measure(file, text) {
  const prose = proseOf(file, text);
  if (!prose) return undefined;
  const source = text.split('\n');
  const lines = prose.paragraphs.flat();
  const all = prose.paragraphs.flatMap(sentences);
  const columns = [...new Set(lines.map(({ line }) => line))].filter((line) =>
    isLong(source[line - 1] ?? ''),
  );
  const long = all.filter((sentence) => wordsOf(sentence.text).length > LONGEST.sentence);
  const names = prose.names.filter((name) => name.text.length > LONGEST.name);
  const vocabulary = [...lines, ...prose.names].flatMap((line) =>
    wordsOf(line.text.replaceAll('_', ' ').toLowerCase()),
  );
  const times = (/** @type {string} */ word) => vocabulary.filter((other) => other === word).length;
  const findings = [
    ...columns.map((line) => ({ line, message: `line of ${[...(source[line - 1] ?? '')].length} columns` })),
    ...long.map((at) => ({
      line: at.line,
      message: `sentence of ${wordsOf(at.text).length} words: ${start(at.text)}`,
    })),
    ...names.map((at) => ({
      line: at.line,
      message: `test name of ${at.text.length} characters: ${start(at.text)}`,
    })),
  ];
  return {
    findings: findings.map((finding) => ({ file, ...finding })).sort((a, b) => a.line - b.line),
    sums: {
      words: vocabulary.length,
      sentences: all.length,
      long: long.length,
      lines: columns.length,
      names: names.length,
      what: times('what'),
      which: times('which'),
    },
  };
}

/** @param {string} line A line with a long address cannot be wrapped. */
const isLong = (line) => [...line].length > LONGEST.line && !/https?:\S{40,}/.test(line);

/** @param {string} text */
const start = (text) => (text.length > 60 ? `${text.slice(0, 60).trimEnd()}…` : text);

/**
 * Files under a path, in the order of their names.
 * @param {string} path
 * @returns {string[]}
 */
export function filesUnder(path) {
  if (!statSync(path).isDirectory()) return [path];
  const names = readdirSync(path).filter((name) => !SKIPPED.test(name));
  return names.sort().flatMap((name) => filesUnder(join(path, name)));
}

/** @param {string} file relative to the root */
function folderOf(file) {
  const depth = file.startsWith('wasm/core/') ? 4 : file.startsWith('web/src/') ? 3 : 2;
  return file.split('/').slice(0, -1).slice(0, depth).join('/') || '.';
}

/** @param {Sums[]} parts @returns {Sums} */
export function total(parts) {
  const sum = { words: 0, sentences: 0, long: 0, lines: 0, names: 0, what: 0, which: 0 };
  for (const part of parts)
    for (const [key, value] of Object.entries(part)) sum[/** @type {keyof Sums} */ (key)] += value;
  return sum;
}

/** @param {Sums} sums */
export const rates = ({ words, sentences, long, lines, names, what, which }) => ({
  lines,
  names,
  long: sentences === 0 ? 0 : (100 * long) / sentences,
  what: words === 0 ? 0 : (1000 * what) / words,
  which: words === 0 ? 0 : (1000 * which) / words,
});

/** @param {[name: string, sums: Sums][]} rows */
function table(rows) {
  const width = Math.max(...rows.map(([name]) => name.length));
  const cells = rows.map(([name, sums]) => {
    const { long, what, which } = rates(sums);
    const numbers = [
      sums.words,
      sums.lines,
      sums.names,
      sums.long,
      `${long.toFixed(1)} %`,
      what.toFixed(1),
      which.toFixed(1),
    ];
    return [name.padEnd(width), ...numbers.map((number) => String(number).padStart(9))].join('');
  });
  const titles = ['words', 'lines', 'names', 'sent.', 'of all', 'what', 'which'];
  return [`${''.padEnd(width)}${titles.map((title) => title.padStart(9)).join('')}`, ...cells].join('\n');
}

/** @param {string[]} args */
async function run(args) {
  const paths = args.filter((arg) => !arg.startsWith('--')).map((path) => resolve(path));
  const files = (paths.length > 0 ? paths : [ROOT]).flatMap(filesUnder);
  /** @type {Map<string, Sums[]>} */
  const folders = new Map();
  for (const path of files) {
    const file = relative(ROOT, path).split(sep).join('/');
    const measured = measure(file, readFileSync(path, 'utf8'));
    if (!measured) continue;
    folders.set(folderOf(file), [...(folders.get(folderOf(file)) ?? []), measured.sums]);
    if (args.includes('--summary') || args.includes('--limits')) continue;
    for (const { line, message } of measured.findings) console.log(`${file}:${line}: ${message}`);
  }
  const all = total([...folders.values()].flat());
  /** @type {[string, Sums][]} */
  const rows = [...folders].map(([name, parts]) => [name, total(parts)]);
  const limited = args.includes('--limits');
  console.log(`\n${table([...(limited ? [] : rows), ['all', all]])}`);
  if (!limited) return;
  const measured = rates(all);
  const over = Object.entries(LIMITS).filter(
    ([key, limit]) => measured[/** @type {keyof typeof LIMITS} */ (key)] > limit,
  );
  const told = over.map(([key, limit]) => `${key} (at most ${limit})`).join(', ');
  if (over.length > 0)
    throw new StepError(`Over the limits: ${told}. \`node web/scripts/prose.mjs\` lists every place.`);
}

if (process.argv[1] && import.meta.filename === process.argv[1]) await main(() => run(process.argv.slice(2)));
