/** Files that describe the tags to editors: custom data for VS Code, and web types for JetBrains. */

/** @typedef {import('./manifest.mjs').Element} Element */
/** @typedef {import('./manifest.mjs').Type} Type */

/** Custom data for the HTML of VS Code. @param {readonly Element[]} elements */
export const htmlData = (elements) => ({
  version: 1.1,
  tags: elements.map(({ tagName, description, attributes }) => ({
    name: tagName,
    description: markdown(description),
    attributes: attributes.map(({ name, description = '', type }) => ({
      name,
      description: markdown(description),
      // The set of VS Code for attributes without a value.
      ...(type.text === 'boolean' && { valueSet: 'v' }),
      ...(type.words && { values: type.words.map((word) => ({ name: word })) }),
    })),
  })),
});

/** Custom data for the CSS of VS Code. @param {readonly Element[]} elements */
export const cssData = (elements) => ({
  version: 1.1,
  properties: elements.flatMap(({ tagName, cssProperties }) =>
    cssProperties.map(({ name, description }) => ({ name, description: `\`<${tagName}>\`: ${description}` })),
  ),
  pseudoElements: [...partsByName(elements)].map(([name, descriptions]) => ({
    name: `::part(${name})`,
    description: descriptions.join('\n\n'),
  })),
});

/**
 * @param {readonly Element[]} elements
 * @param {{ name: string, version: string }} package_
 */
export const webTypes = (elements, { name, version }) => ({
  $schema: 'https://raw.githubusercontent.com/JetBrains/web-types/master/schema/web-types.json',
  name,
  version,
  'js-types-syntax': 'typescript',
  'description-markup': 'markdown',
  contributions: {
    html: {
      elements: elements.map((element) => ({
        name: element.tagName,
        description: element.description,
        attributes: element.attributes.map(({ name, description, type, ...rest }) => ({
          name,
          description,
          value: { type: expanded(type), required: type.text !== 'boolean' },
          ...(rest.default !== undefined && { default: rest.default }),
        })),
        slots: element.slots,
        js: {
          properties: element.fields.map(({ name, description, type, writtenType, readonly }) => ({
            name,
            description,
            type: expanded(writtenType ?? type),
            ...(readonly && { 'read-only': true }),
          })),
          events: element.events.map(({ name, description, type }) => ({
            name,
            description,
            type: type.text,
          })),
        },
        css: {
          parts: element.cssParts,
          properties: element.cssProperties.map(({ syntax: _, ...rest }) => rest),
        },
      })),
    },
  },
});

/** @param {string} value */
const markdown = (value) => ({ kind: 'markdown', value });

/** Two elements may have a part of the same name. @param {readonly Element[]} elements */
function partsByName(elements) {
  /** @type {Map<string, string[]>} */
  const parts = new Map();
  for (const { tagName, cssParts } of elements)
    for (const { name, description } of cssParts)
      parts.set(name, [...(parts.get(name) ?? []), `\`<${tagName}>\`: ${description}`]);
  return parts;
}

/** Editors do not know the types of this package. @param {Type} type */
const expanded = ({ text, words }) => (words ? words.map((word) => `'${word}'`).join(' | ') : text);
