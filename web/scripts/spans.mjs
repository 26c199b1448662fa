/**
 * Comments and strings of Rust and TypeScript, for the scripts that measure prose and imports. A scanner, not a parser:
 * it finds the ends of comments, strings and regular expressions.
 */

/** @typedef {{ kind: 'comment' | 'string', start: number, end: number }} Span The offsets of a comment or a string. */

/** A regular expression may follow one of these; after anything else a slash divides. */
const BEFORE_REGEX = /(?:^|[(,=:[!&|?{};+\-*%<>~^]|\b(?:return|typeof|case|of|in))\s*$/;

/** A lifetime, not a character: a quote, a name, and no quote behind it. */
const LIFETIME = /'[A-Za-z_]\w*(?!')/y;

const RAW_STRING = /b?r(#*)"/y;

/**
 * @param {string} text Rust
 * @returns {Span[]}
 */
export function rustSpans(text) {
  /** @type {Span[]} */
  const spans = [];
  let at = 0;
  const add = (/** @type {Span['kind']} */ kind, /** @type {number} */ end) => {
    spans.push({ kind, start: at, end });
    at = end;
  };
  while (at < text.length) {
    const two = text.slice(at, at + 2);
    const raw = /\w/.test(text[at - 1] ?? '') ? null : matchAt(RAW_STRING, text, at);
    if (two === '//') add('comment', endOf(text, '\n', at, 0));
    else if (two === '/*') add('comment', endOfNested(text, at));
    else if (raw) add('string', endOf(text, `"${raw[1]}`, at + raw[0].length));
    else if (text[at] === '"') add('string', endOfQuoted(text, at));
    else if (text[at] === "'" && !matchAt(LIFETIME, text, at)) add('string', endOfQuoted(text, at));
    else at++;
  }
  return spans;
}

/**
 * @param {string} text TypeScript, JavaScript or GLSL
 * @returns {Span[]} Parts of a template between its expressions are strings of their own. Comments of style sheets in
 *   templates (css`…`) are comments.
 */
export function scriptSpans(text) {
  /** @type {Span[]} */
  const spans = [];
  scanScript(text, 0, spans, false);
  return spans;
}

/**
 * @param {string} text
 * @param {number} from
 * @param {Span[]} spans
 * @param {boolean} inTemplate Whether the scan ends at the brace that closes an expression of a template.
 * @returns {number} The offset behind that brace, or the end.
 */
function scanScript(text, from, spans, inTemplate) {
  let at = from;
  let depth = 0;
  const add = (/** @type {Span['kind']} */ kind, /** @type {number} */ end) => {
    spans.push({ kind, start: at, end });
    at = end;
  };
  while (at < text.length) {
    const two = text.slice(at, at + 2);
    const one = text[at] ?? '';
    if (two === '//') add('comment', endOf(text, '\n', at, 0));
    else if (two === '/*') add('comment', endOf(text, '*/', at + 2));
    else if (one === "'" || one === '"') add('string', endOfQuoted(text, at));
    else if (one === '`') at = scanTemplate(text, at, spans);
    else if (one === '/' && BEFORE_REGEX.test(text.slice(Math.max(0, at - 40), at)))
      at = endOfRegex(text, at);
    else {
      at++;
      if (one === '{') depth++;
      if (one === '}' && inTemplate && depth-- === 0) return at;
    }
  }
  return at;
}

/**
 * @param {string} text
 * @param {number} from The offset of the opening backtick.
 * @param {Span[]} spans
 * @returns {number} The offset behind the closing backtick.
 */
function scanTemplate(text, from, spans) {
  const isSheet = text.slice(Math.max(0, from - 3), from) === 'css';
  let start = from;
  let at = from + 1;
  while (at < text.length) {
    const two = text.slice(at, at + 2);
    if (text[at] === '\\') at += 2;
    else if (isSheet && two === '/*') {
      const end = endOf(text, '*/', at + 2);
      spans.push({ kind: 'string', start, end: at }, { kind: 'comment', start: at, end });
      start = end;
      at = end;
    } else if (two === '${') {
      spans.push({ kind: 'string', start, end: at });
      start = scanScript(text, at + 2, spans, true);
      at = start;
    } else if (text[at++] === '`') break;
  }
  spans.push({ kind: 'string', start, end: at });
  return at;
}

/**
 * @param {RegExp} pattern sticky
 * @param {string} text
 * @param {number} at
 */
function matchAt(pattern, text, at) {
  pattern.lastIndex = at;
  return pattern.exec(text);
}

/**
 * The offset behind the next `mark`, or the end of the text.
 * @param {string} text
 * @param {string} mark
 * @param {number} from
 * @param {number} [length] How much of the mark belongs to the span.
 */
function endOf(text, mark, from, length = mark.length) {
  const found = text.indexOf(mark, from);
  return found < 0 ? text.length : found + length;
}

/**
 * @param {string} text
 * @param {number} from The offset of the opening quote.
 */
function endOfQuoted(text, from) {
  let at = from + 1;
  while (at < text.length && text[at] !== text[from]) at += text[at] === '\\' ? 2 : 1;
  return at + 1;
}

/**
 * @param {string} text
 * @param {number} from The offset of the first slash.
 */
function endOfRegex(text, from) {
  let inClass = false;
  for (let at = from + 1; at < text.length && text[at] !== '\n'; at++) {
    if (text[at] === '\\') at++;
    else if (text[at] === '[') inClass = true;
    else if (text[at] === ']') inClass = false;
    else if (text[at] === '/' && !inClass) return at + 1;
  }
  return from + 1;
}

/**
 * Block comments of Rust nest.
 * @param {string} text
 * @param {number} from
 */
function endOfNested(text, from) {
  let depth = 0;
  for (let at = from; at < text.length; at++) {
    const two = text.slice(at, at + 2);
    if (two === '/*') depth++;
    if (two === '*/') depth--;
    if (two !== '/*' && two !== '*/') continue;
    at++;
    if (depth === 0) return at + 1;
  }
  return text.length;
}
