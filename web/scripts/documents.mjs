/** Links and code spans of Markdown, for the test that compares the documents with the repository. */

const FENCED = /^(```|~~~)[^\n]*\n.*?^\1[^\n]*$/gms;
const CODE = /`([^`\n]+)`/g;
const LINK = /\]\(\s*([^)\s]+)\s*\)/g;
/** The pictures of HTML in Markdown. */
const SOURCE = /\b(?:src|srcset|href)="([^"]+)"/g;

/** @param {string} markdown */
const prose = (markdown) => markdown.replaceAll(FENCED, '').replaceAll(/^ {4,}.*$/gm, '');

/**
 * The targets of links and pictures that lie in the repository.
 * @param {string} markdown
 */
export function localLinks(markdown) {
  const text = prose(markdown).replaceAll(CODE, '');
  const targets = [...text.matchAll(LINK), ...text.matchAll(SOURCE)].map(([, target = '']) => target);
  return targets.filter((target) => !/^[a-z]+:/.test(target));
}

/**
 * The anchors of headings, as code hosts name them.
 * @param {string} markdown
 */
export const anchors = (markdown) =>
  [...prose(markdown).matchAll(/^#{1,6} (.*)$/gm)].map(([, heading = '']) =>
    heading
      .toLowerCase()
      .replaceAll(/[^\p{L}\p{N}\s_-]/gu, '')
      .trim()
      .replaceAll(/\s/g, '-'),
  );

/**
 * Code spans, and the words of indented and fenced code.
 * @param {string} markdown
 */
export function codeOf(markdown) {
  const blocks = [...markdown.matchAll(FENCED)].map(([block]) => block);
  const indented = markdown.match(/^ {4,}.*$/gm) ?? [];
  const spans = [...prose(markdown).matchAll(CODE)].map(([, code = '']) => code);
  return [...spans, ...blocks, ...indented];
}

/**
 * The blocks of a language.
 * @param {string} markdown
 * @param {string} language
 */
export const blocksOf = (markdown, language) =>
  [...markdown.matchAll(FENCED)]
    .map(([block]) => block.split('\n'))
    .filter(([fence]) => fence?.slice(3) === language)
    .map((lines) => lines.slice(1, -1).join('\n'));
