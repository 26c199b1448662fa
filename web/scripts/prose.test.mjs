import { describe, expect, it } from 'vitest';
import { measure, sentences } from './prose.mjs';
import { proseOf } from './prose_text.mjs';

const texts = (/** @type {string} */ file, /** @type {string} */ text) =>
  proseOf(file, text)?.paragraphs.map((lines) => lines.map((line) => line.text).join(' '));

describe('prose of a file', () => {
  it('joins the comments of Rust into paragraphs', () => {
    const rust = `//! One
//! text.
//!
//! Another.
let a = "// no comment"; // Trailing.
let b = ('"', 'a', r#"/* no " comment */"#); /* A block. */
/// Of \`b\`.
fn c<'a>() {}`;
    expect(texts('a.rs', rust)).toEqual(['One text.', 'Another.', 'Trailing.', 'A block.', 'Of Code.']);
  });

  it('leaves out code, tables, HTML and the marks of links and lists', () => {
    const markdown = `# Title
Text with [a link](there.md).

- An item
  of two lines
- Another
| a | table |

\`\`\`sh
code
\`\`\`

    code

<img alt="no text" />
`;
    expect(texts('a.md', markdown)).toEqual([
      'Title',
      'Text with a link.',
      'An item of two lines',
      'Another',
    ]);
  });

  it('finds comments of scripts, in style sheets too', () => {
    const script = `/**
 * Of a function.
 * @param {string} a The first.
 */
const sheet = css\`a { b: url('//c'); /* Of a style. */ top: \${/* Of an expression. */ 1}px; }\`;
const address = 'https://a', divided = 4 / 2 / 1, pattern = /\\/\\*[/*]/; // Last.`;
    expect(texts('a.ts', script)).toEqual([
      'Of a function.',
      'a The first.',
      'Of a style.',
      'Of an expression.',
      'Last.',
    ]);
  });

  it('finds names of tests', () => {
    const rust = '#[test]\n#[ignore]\nfn adds_two() {}\nfn helper() {}';
    expect(proseOf('a.rs', rust)?.names).toEqual([{ line: 3, text: 'adds_two' }]);
    const script =
      "describe('sums', () => {\n  it.each([1])('adds %i', () => call('no name'));\n  test.only(`adds`, f);\n});";
    expect(proseOf('a.test.ts', script)?.names.map(({ text }) => text)).toEqual(['sums', 'adds %i', 'adds']);
    expect(proseOf('a.ts', script)?.names).toEqual([]);
  });

  it('knows no other files', () => expect(proseOf('a.png', '')).toBeUndefined());
});

describe('sentences', () => {
  it('start where they begin, and do not end at abbreviations', () => {
    const paragraph = [
      { line: 1, text: 'By eq. 2, e.g. At r. One' },
      { line: 2, text: 'more. "Two?" (Three.) No. 4' },
    ];
    expect(sentences(paragraph)).toEqual([
      { line: 1, text: 'By eq. 2, e.g. At r.' },
      { line: 1, text: 'One more.' },
      { line: 2, text: '"Two?"' },
      { line: 2, text: '(Three.)' },
      { line: 2, text: 'No. 4' },
    ]);
  });
});

describe('measuring', () => {
  it('reports long lines, sentences and names, and counts words', () => {
    const long = `/// ${'word '.repeat(26)}what. Which?`;
    const rust = `${long}\n#[test]\nfn ${'name_'.repeat(17)}() { let code = "${'long '.repeat(30)}"; }`;
    const measured = measure('a.rs', rust);
    expect(measured?.findings).toEqual([
      { file: 'a.rs', line: 1, message: 'line of 146 columns' },
      { file: 'a.rs', line: 1, message: expect.stringMatching(/^sentence of 27 words: word word .*…$/) },
      {
        file: 'a.rs',
        line: 3,
        message: expect.stringMatching(/^test name of 85 characters: name_name_.*…$/),
      },
    ]);
    expect(measured?.sums).toEqual({
      words: 45,
      sentences: 2,
      long: 1,
      lines: 1,
      names: 1,
      what: 1,
      which: 1,
    });
  });

  it('lets lines with a long address be', () => {
    expect(measure('a.md', `See https://example.org/${'path/'.repeat(30)} there.`)?.sums.lines).toBe(0);
  });
});
