/**
 * The custom-elements manifest of both elements (schema 2.1.0), from the doc comments of their sources.
 *
 * The package's types and editor data, and tables of the documentation, are generated from it.
 */
import { StepError } from '../steps.mjs';
import { withSource } from './source.mjs';

/** @typedef {import('custom-elements-manifest').Package} Package */
/** @typedef {import('custom-elements-manifest').CustomElementDeclaration} CustomElementDeclaration */
/** @typedef {import('custom-elements-manifest').ClassMember} ClassMember */
/** @typedef {import('./source.mjs').Source} Source */
/** @typedef {import('./source.mjs').Comment} Comment */
/** @typedef {import('./source.mjs').Member} Member */
/** @typedef {import('./source.mjs').TypeText} TypeText */
/**
 * @typedef {import('custom-elements-manifest').Type & { words?: string[] }} Type
 * @typedef {Omit<import('custom-elements-manifest').Attribute, 'type'> & { type: Type, reflects?: true }} Attribute
 * @typedef {Omit<import('custom-elements-manifest').CustomElementField, 'type'>
 *   & { description: string, type: Type, writtenType?: Type }} Field
 * @typedef {import('custom-elements-manifest').ClassMethod & { description: string }} Method
 * @typedef {import('custom-elements-manifest').Event
 *   & { description: string, detail?: Type, bubbles?: true, cancelable?: true }} Event
 * @typedef {Omit<CustomElementDeclaration, 'attributes' | 'members' | 'events'> & {
 *   tagName: string,
 *   description: string,
 *   attributes: Attribute[],
 *   fields: Field[],
 *   methods: Method[],
 *   events: Event[],
 *   slots: { name: string, description: string }[],
 *   cssParts: { name: string, description: string }[],
 *   cssProperties: { name: string, description: string, syntax?: string }[],
 * }} Element For generators. `written` has the same in the form of the schema.
 */

/** Each element, with its source and its module. `events` has the details of its events, or the events. */
const ELEMENTS = /** @type {const} */ ([
  {
    tag: 'c2-warp',
    name: 'C2Warp',
    file: 'web/src/element.ts',
    module: 'web/dist/element/c2warp.js',
    events: { file: 'web/src/element/events.ts', name: 'EventDetails', of: 'detail' },
  },
  {
    tag: 'c2-warp-player',
    name: 'C2WarpPlayer',
    file: 'web/src/player/element.ts',
    module: 'web/dist/player/c2warp-player.js',
    events: { file: 'web/src/player/events.ts', name: 'C2WarpPlayerEventMap', of: 'event' },
  },
]);

/** Called only by the browser. */
const REACTIONS = /^(connected|disconnected|adopted|attributeChanged|form\w+)Callback$/;

/** @returns {Element[]} @throws Error that names members without a comment. */
export const elements = () => withSource((source) => ELEMENTS.map((one) => element(source, one)));

/** Names that a page cannot use, though they are on the prototypes: protected members and reactions. */
export const hiddenNames = () =>
  withSource((source) =>
    ELEMENTS.flatMap(({ file, name }) =>
      source
        .members(source.exported(file, name))
        .filter((member) => !isShown(member))
        .map((member) => member.name),
    ),
  );

/** @param {readonly Element[]} all @returns {Package} */
export const written = (all) => ({
  schemaVersion: '2.1.0',
  readme: 'README.md',
  modules: all.map(({ fields, methods, ...rest }, at) => {
    const { module } = /** @type {(typeof ELEMENTS)[number]} */ (ELEMENTS[at]);
    const declaration = { name: rest.name, module };
    return {
      kind: 'javascript-module',
      path: module,
      declarations: [{ ...rest, members: [...fields, ...methods] }],
      exports: [
        { kind: 'js', name: rest.name, declaration },
        { kind: 'custom-element-definition', name: rest.tagName, declaration },
      ],
    };
  }),
});

/**
 * @param {Source} source
 * @param {(typeof ELEMENTS)[number]} place
 * @returns {Element}
 */
function element(source, { tag, name, file, events }) {
  const symbol = source.exported(file, name);
  const comment = source.comment(symbol);
  const members = source.members(symbol).filter(isShown);
  const details = source.members(source.exported(events.file, events.name));
  const silent = [...members, ...details].filter(({ description }) => description === '');
  if (silent.length > 0)
    throw new StepError(
      silent.map((one) => `${one.file}: ${one.owner}.${one.name} has no comment`).join('\n'),
    );
  const options = optionsOf(source.text(symbol, 'properties'));
  const fields = members
    .filter(({ kind }) => kind !== 'method')
    .map((member) => field(member, name, options.get(member.name)));
  return {
    kind: 'class',
    customElement: true,
    name,
    tagName: tag,
    description: comment.description,
    superclass: { name: 'HTMLElement', package: 'global:' },
    attributes: [...fields.flatMap(attributeOf), ...tagged(comment, 'attr').map(plainAttribute)],
    fields,
    methods: members.filter(({ kind }) => kind === 'method').map((member) => method(member, name)),
    events: details.map((detail) => event(detail, events.of === 'detail')),
    slots: tagged(comment, 'slot').map(({ name, description }) => ({ name, description })),
    cssParts: tagged(comment, 'csspart').map(({ name, description }) => ({ name, description })),
    cssProperties: tagged(comment, 'cssprop').map(({ type, ...rest }) => ({
      ...rest,
      ...(type && { syntax: type }),
    })),
  };
}

/** @param {Member} member */
const isShown = ({ name, privacy, file, tags }) =>
  privacy === 'public' &&
  !tags.some((tag) => tag.name === 'internal') &&
  !REACTIONS.test(name) &&
  // They only add the types of events.
  !(file.endsWith('/events.ts') && name.endsWith('EventListener'));

/** The names, attributes and first values of properties, by `static properties`. @param {string} block */
const optionsOf = (block) =>
  new Map(
    [...block.matchAll(/^ {4}(\w+): \{(.*?)\}/gms)].map(([, name = '', text = '']) => {
      const attribute = text.match(/attribute: (?:'([^']+)'|false)/);
      return [
        name,
        {
          attribute: attribute ? attribute[1] : name.toLowerCase(),
          initial: initialOf(text),
        },
      ];
    }),
  );

/** As `PropertyOptions` has it. @param {string} text */
function initialOf(text) {
  const [, kind] = text.match(/kind: '(\w+)'/) ?? [];
  const [, initial] = text.match(/initial: ('[^']*'|\[\])/) ?? [];
  if (kind === 'flag') return 'false';
  return initial ?? (kind === 'optional' || text.includes('words:') ? 'null' : "''");
}

/**
 * @param {Member} member
 * @param {string} owner
 * @param {{ attribute: string | undefined, initial: string } | undefined} option
 * @returns {Field}
 */
function field(member, owner, option) {
  const { name, type, written, tags } = member;
  const attribute = option ? option.attribute : tags.some((tag) => tag.name === 'attr') ? name : undefined;
  const value = tags.find((tag) => tag.name === 'default')?.text ?? option?.initial;
  return {
    kind: 'field',
    name,
    description: described(member),
    privacy: 'public',
    type: typeOf(type),
    ...(written && written.text !== type.text && { writtenType: typeOf(written) }),
    ...(value !== undefined && { default: value }),
    ...(!written && { readonly: true }),
    ...(attribute !== undefined && { attribute }),
    // All accessors read and write attributes.
    ...(attribute !== undefined && { reflects: /** @type {const} */ (true) }),
    ...inherited(member, owner),
  };
}

/** @param {Field} field @returns {Attribute[]} */
function attributeOf({ name, attribute, description, type, reflects, inheritedFrom, ...rest }) {
  if (attribute === undefined) return [];
  const text = type.text.replace(/ \| null$/, '');
  return [
    {
      name: attribute,
      description,
      type: { ...type, text },
      ...(rest.default !== undefined && rest.default !== 'null' && { default: rest.default }),
      fieldName: name,
      ...(reflects && { reflects }),
      ...(inheritedFrom && { inheritedFrom }),
    },
  ];
}

/** An attribute without a property. @param {Tagged} tagged @returns {Attribute} */
const plainAttribute = ({ name, description, type }) => ({
  name,
  description,
  type: { text: type || 'string' },
});

/** @param {Member} member @param {string} owner @returns {Method} */
function method(member, owner) {
  const { name, type, parameters, tags } = member;
  const notes = new Map(
    tags
      .filter((tag) => tag.name === 'param')
      .map(({ text }) => [text.split(' ')[0] ?? '', text.slice(text.indexOf(' ') + 1)]),
  );
  const missing = parameters.find((parameter) => !notes.has(parameter.name));
  if (missing) throw new StepError(`${member.file}: ${owner}.${name}: @param ${missing.name} has no comment`);
  const result = tags.find((tag) => ['return', 'returns'].includes(tag.name))?.text;
  return {
    kind: 'method',
    name,
    description: described(member),
    privacy: 'public',
    parameters: parameters.map((parameter) => ({
      name: parameter.name,
      description: notes.get(parameter.name) ?? '',
      type: typeOf(parameter.type),
      ...(parameter.optional && { optional: true }),
      ...(parameter.default !== null && { default: parameter.default }),
    })),
    return: { type: typeOf(type), ...(result && { description: result }) },
    ...inherited(member, owner),
  };
}

/** @param {Member} member @param {boolean} isDetail @returns {Event} */
function event({ name, description, type, tags }, isDetail) {
  const has = (/** @type {string} */ tag) => tags.some((one) => one.name === tag);
  const detail = { text: type.text.replaceAll('readonly ', '') };
  return {
    name,
    description: has('cancelable')
      ? `${description} \`preventDefault()\` keeps the editor from it.`
      : description,
    type: { text: isDetail ? `CustomEvent<${detail.text}>` : type.text },
    ...(isDetail && { detail }),
    ...(has('bubbles') && { bubbles: /** @type {const} */ (true) }),
    ...(has('cancelable') && { cancelable: /** @type {const} */ (true) }),
  };
}

/** A comment with its errors. @param {Comment} comment */
const described = ({ description, tags }) =>
  [
    description,
    ...tags.filter(({ name }) => name === 'throws').map(({ text }) => `Throws ${sentence(text)}`),
  ].join('\n\n');

/** @param {string} text */
const sentence = (text) => (text.endsWith('.') ? text : `${text}.`);

/** @param {Member} member @param {string} owner */
const inherited = (member, owner) =>
  member.owner === owner ? {} : { inheritedFrom: { name: member.owner, module: member.file } };

/** @param {TypeText} type @returns {Type} */
const typeOf = ({ text, words }) => (words ? { text, words } : { text });

/** @typedef {{ name: string, description: string, type: string }} Tagged */

/**
 * Tags of the form `{type} name - text`, where the type, and the name of a default slot, may be left out.
 * @param {Comment} comment
 * @param {string} tag
 * @returns {Tagged[]}
 */
const tagged = ({ tags }, tag) =>
  tags
    .filter(({ name }) => name === tag)
    .map(({ text }) => {
      const [, type = '', name = '', description = ''] =
        text.match(/^(?:\{([^}]*)\} ?)?([\w-]*?) ?- (.+)$/s) ?? [];
      if (!description) throw new StepError(`@${tag} ${text}: expected a name, a dash and a sentence`);
      return { name, description, type };
    });
