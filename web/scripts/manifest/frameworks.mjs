/**
 * Types of the tags for templates of frameworks, and of the component for React.
 *
 * Each file extends the types of its framework. No file needs another framework.
 */

/** @typedef {import('./manifest.mjs').Element} Element */
/** @typedef {(event: string) => string} Listener The name of a template's listener. */
/**
 * @typedef {{
 *   imports: string,
 *   module: string,
 *   scope: string[],
 *   tag: (own: string, element: string) => string,
 * }} Framework The declarations, of outer scopes first, that have an entry for each tag.
 */

const HEADER = '// Generated from the manifest of the elements.\n';

/** Their setters need an element on a page: templates set properties earlier. Set them by a reference. */
const LIVE = new Map([['c2-warp', ['currentTime', 'playbackRate', 'zoom']]]);

const GLOBALS = new Set(['Event', 'ErrorEvent', 'CustomEvent', 'File', 'Blob', 'URL']);

/** Names that templates set: attributes, and properties that are no attribute. @param {Element} element */
export function settable({ tagName, attributes, fields }) {
  const live = LIVE.get(tagName) ?? [];
  const own = fields.filter(({ name, readonly, attribute }) => {
    // The text of the attribute `project` is a property of its own. Templates have one of this name.
    const isText =
      attribute !== undefined && attribute !== name && fields.some((one) => one.name === attribute);
    return !readonly && !isText && !live.includes(name);
  });
  const names = new Set(own.map(({ name }) => name));
  return [...own, ...attributes.filter(({ name }) => !names.has(name))];
}

/** @param {string} event As React names listeners: `onSelectionChange`. */
export const reactListener = (event) =>
  `on${event
    .replace(/^before(?=.)/, 'before ')
    .replace(/(?<=.)(change|update)$/, ' $1')
    .split(' ')
    .map(capital)
    .join('')}`;

/** @param {string} word */
const capital = (word) => word.slice(0, 1).toUpperCase() + word.slice(1);

/** @type {Listener} */
const plain = (event) => `on${event}`;
/** @type {Listener} */
const withColon = (event) => `on:${event}`;
/** @type {Listener} */
const capitalised = (event) => `on${capital(event)}`;

/**
 * Files by their names.
 * @param {readonly Element[]} elements
 * @returns {Record<string, string>}
 */
export const frameworkTypes = (elements) => ({
  'props.d.ts': props(elements),
  'react.d.ts': tags(elements, [plain], {
    imports: "import type { HTMLAttributes, RefAttributes } from 'react';",
    module: 'react',
    scope: ['namespace JSX', 'interface IntrinsicElements'],
    tag: (own, element) =>
      `${own} & Omit<HTMLAttributes<${element}>, keyof ${own}> & RefAttributes<${element}>`,
  }),
  'preact.d.ts': tags(elements, [plain], {
    imports: "import type { JSX } from 'preact';",
    module: 'preact',
    scope: ['namespace JSX', 'interface IntrinsicElements'],
    tag: (own, element) => `${own} & Omit<JSX.HTMLAttributes<${element}>, keyof ${own}>`,
  }),
  'solid.d.ts': tags(elements, [plain, withColon], {
    imports: "import type { JSX } from 'solid-js';",
    module: 'solid-js',
    scope: ['namespace JSX', 'interface IntrinsicElements'],
    tag: (own, element) => `${own} & Omit<JSX.HTMLAttributes<${element}>, keyof ${own}>`,
  }),
  'svelte.d.ts': tags(elements, [plain, withColon], {
    imports: "import type { HTMLAttributes } from 'svelte/elements';",
    module: 'svelte/elements',
    scope: ['interface SvelteHTMLElements'],
    tag: (own, element) => `${own} & Omit<HTMLAttributes<${element}>, keyof ${own}>`,
  }),
  'vue.d.ts': tags(elements, [capitalised], {
    imports: "import type { HTMLAttributes, PublicProps } from 'vue';",
    module: 'vue',
    scope: ['interface GlobalComponents'],
    tag: (own, element) =>
      `new () => ${element} & { $props: ${own} & Omit<HTMLAttributes, keyof ${own}> & PublicProps }`,
  }),
});

/** The types of `c2warp/react`. @param {Element} element */
export const reactComponent = ({ name, tagName, events }) => `${HEADER}
import type { ForwardRefExoticComponent, HTMLAttributes, RefAttributes } from 'react';
import type { ${name}Settings } from '../element/frameworks/props.js';
import type { ${name} as ${name}Element, ${name}EventMap } from '../element/types/element.js';

export type { ${name}Element };

/** The properties of \`<${tagName}>\`, and listeners for its events. */
export interface ${name}Props
  extends ${name}Settings,
    Omit<HTMLAttributes<${name}Element>, keyof ${name}Settings | keyof ${name}Listeners>,
    ${name}Listeners {}

/** Each listener gets the event of the element itself. */
export interface ${name}Listeners {
${listeners(name, events, [reactListener])}}

/** \`<${tagName}>\` as a component. Its \`ref\` is the element. */
export declare const ${name}: ForwardRefExoticComponent<${name}Props & RefAttributes<${name}Element>>;
`;

/** @param {readonly Element[]} elements */
function props(elements) {
  const blocks = elements.map((element) => {
    const lines = settable(element).map((one) => {
      const type = 'writtenType' in one && one.writtenType ? one.writtenType : one.type;
      const isText = !('kind' in one);
      const text = [...new Set([...type.text.split(' | '), ...(isText ? ['null'] : []), 'undefined'])].join(
        ' | ',
      );
      return `${comment(one.description ?? '')}  ${quoted(one.name)}?: ${text};\n`;
    });
    return `/** Properties of \`<${element.tagName}>\` in templates. */\nexport interface ${element.name}Settings {\n${lines.join('')}}\n`;
  });
  const [warp = ''] = blocks;
  const names = [...new Set(warp.replaceAll(/\/\*\*.*?\*\//gs, '').match(/\b[A-Z]\w+\b/g))];
  const imported = names.filter((name) => !GLOBALS.has(name) && !name.endsWith('Settings')).sort();
  return `${HEADER}\nimport type { ${imported.join(', ')} } from '../types/element.js';\n\n${blocks.join('\n')}`;
}

/**
 * @param {readonly Element[]} elements
 * @param {Listener[]} named
 * @param {Framework} framework
 */
function tags(elements, named, { imports, module, scope, tag }) {
  const own = elements.map(
    ({ name, tagName, events }) =>
      `/** Properties and events of \`<${tagName}>\` in templates. */
export interface ${name}Tag extends ${name}Settings {\n${listeners(name, events, named)}}\n`,
  );
  const entries = elements.map(
    ({ name, tagName, description }) =>
      `${comment(description)}  '${tagName}': ${tag(`${name}Tag`, name)};\n`,
  );
  return `${HEADER}
${imports}
import type { ${elements.map(({ name }) => `${name}Settings`).join(', ')} } from './props.js';
import type { C2Warp, C2WarpEventMap } from '../types/element.js';
import type { C2WarpPlayer, C2WarpPlayerEventMap } from '../../player/types/player.js';

${own.join('\n')}
declare module '${module}' {
${scope.map((line) => `${line} {`).join('\n')}
${entries.join('')}${'}\n'.repeat(scope.length)}}
`;
}

/**
 * @param {string} name
 * @param {Element['events']} events
 * @param {Listener[]} named
 */
const listeners = (name, events, named) =>
  events
    .flatMap((event) => named.map((listener) => ({ ...event, listener: listener(event.name) })))
    .map(
      ({ name: type, description, listener }) =>
        `${comment(description)}  ${quoted(listener)}?: ((event: ${name}EventMap['${type}']) => void) | undefined;\n`,
    )
    .join('');

/** @param {string} text */
const comment = (text) =>
  `  /**\n${text
    .split('\n')
    .map((line) => `   * ${line}`.trimEnd())
    .join('\n')}\n   */\n`;

/** @param {string} name */
const quoted = (name) => (/^\w+$/.test(name) ? name : `'${name}'`);
