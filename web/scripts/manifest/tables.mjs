/** The tables of the reference: regions of documents between two comments, generated from the manifest. */

/** @typedef {import('./manifest.mjs').Element} Element */
/** @typedef {import('./manifest.mjs').Type} Type */

const REGION = /(<!-- manifest: ([\w-]+) ([a-z ]+) -->\n)(.*?)(<!-- \/manifest -->)/gs;

/**
 * A document with regenerated tables.
 * @param {string} markdown
 * @param {readonly Element[]} elements
 * @param {string} errors The source with the codes of errors.
 */
export const withTables = (markdown, elements, errors) =>
  markdown.replaceAll(REGION, (_, head, tag, kind, __, end) => {
    const element = elements.find(({ tagName }) => tagName === tag);
    const table = TABLES.get(kind);
    if (!element || !table) throw new Error(`there is no table of ${kind} of ${tag}`);
    return `${head}\n${table(element, errors)}\n\n${end}`;
  });

/** @type {Map<string, (element: Element, errors: string) => string>} */
const TABLES = new Map([
  [
    'attributes',
    ({ attributes }) =>
      rows(
        ['attribute', 'value', 'meaning'],
        attributes.map(({ name, type, description = '' }) => [code(name), attributeValue(type), description]),
      ),
  ],
  [
    'properties',
    ({ fields }) =>
      rows(
        ['property', 'type', 'meaning'],
        fields
          .filter(({ name, attribute }) => attribute !== name)
          .map(({ name, type, writtenType, readonly, description }) => [
            code(name),
            code((writtenType ?? type).text),
            readonly ? `${description} Read only.` : description,
          ]),
      ),
  ],
  [
    'methods',
    ({ methods }) =>
      rows(
        ['method', 'result', 'meaning'],
        methods.map(({ name, parameters = [], description, ...method }) => [
          code(`${name}(${parameters.map((one) => `${one.name}${one.optional ? '?' : ''}`).join(', ')})`),
          code(method.return?.type?.text ?? 'void'),
          description,
        ]),
      ),
  ],
  [
    'events',
    ({ events }) =>
      rows(
        ['event', 'detail', 'fired'],
        events.map(({ name, type, detail, bubbles, description }) => [
          code(name),
          detail ? (detail.text === 'null' ? '' : code(detail.text)) : code(type.text),
          bubbles ? `${description} It bubbles.` : description,
        ]),
      ),
  ],
  ['parts', ({ cssParts }) => rows(['part', 'meaning'], named(cssParts))],
  ['custom properties', ({ cssProperties }) => rows(['property', 'meaning'], named(cssProperties))],
  ['slots', ({ slots }) => rows(['slot', 'meaning'], named(slots))],
  [
    'errors',
    (_, errors) =>
      [...errors.matchAll(/^ \* (\|.*\|)$/gm)]
        .map(([, row]) => row)
        .join('\n')
        .replace('| code | |', '| code | reason |'),
  ],
]);

/** @param {readonly { name: string, description: string }[]} members */
const named = (members) =>
  members.map(({ name, description }) => [name === '' ? 'the default one' : code(name), description]);

/**
 * @param {string[]} head
 * @param {string[][]} body
 */
const rows = (head, body) =>
  [head, head.map(() => '---'), ...body]
    .map(
      (cells) =>
        `| ${cells.map((cell) => cell.replaceAll(/\s*\n\s*/g, ' ').replaceAll('|', '\\|')).join(' | ')} |`,
    )
    .join('\n')
    .replaceAll('| --- ', '|---')
    .replaceAll('|--- |', '|---|')
    .replaceAll('--- |', '---|');

/** @param {string} text */
const code = (text) => `\`${text}\``;

/** @param {Type} type */
const attributeValue = ({ text, words }) =>
  text === 'boolean' ? 'boolean: present or absent' : (words?.map(code).join(', ') ?? code(text));
