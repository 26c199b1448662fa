/** Tables of a JSON schema, for people. */

/** The parts of JSON Schema that the project file uses. */
export interface Schema {
  title?: string;
  description?: string;
  type?: string;
  const?: string;
  default?: unknown;
  $ref?: string;
  items?: Schema;
  oneOf?: Schema[];
  anyOf?: Schema[];
  properties?: Record<string, Schema>;
  required?: string[];
  $defs?: Record<string, Schema>;
}

export interface Row {
  key: string;
  /** Words, and names of other tables. */
  type: { text: string; table?: string }[];
  meaning: string;
  /** The value of a key that is left out, as JSON; undefined for a key that must be there or has no default. */
  standard: string | undefined;
  required: boolean;
}

export interface Table {
  name: string;
  description: string;
  /** The tables of alternatives are headed by what distinguishes them. */
  parts: { title: string; rows: Row[] }[];
  /** Values of a list of words. */
  words: { word: string; meaning: string }[];
}

/** The first paragraphs, without examples. */
const plain = (description = '') => description.split('\n\n```')[0]?.replaceAll(/\s+/g, ' ') ?? '';

const named = (ref: string) => ref.replace('#/$defs/', '');

function typeOf(schema: Schema): Row['type'] {
  if (schema.$ref) return [{ text: named(schema.$ref), table: named(schema.$ref) }];
  if (schema.items) return [{ text: 'list of ' }, ...typeOf(schema.items)];
  if (schema.const !== undefined) return [{ text: JSON.stringify(schema.const) }];
  const choices = schema.oneOf ?? schema.anyOf;
  if (choices)
    return choices.flatMap((choice, k) => [...(k > 0 ? [{ text: ' or ' }] : []), ...typeOf(choice)]);
  return [{ text: schema.type ?? 'any' }];
}

function rowsOf({ properties = {}, required = [] }: Schema): Row[] {
  return Object.entries(properties).map(([key, schema]) => ({
    key,
    type: typeOf(schema),
    meaning: plain(schema.description),
    standard: schema.default === undefined ? undefined : JSON.stringify(schema.default),
    required: required.includes(key),
  }));
}

function tableOf(name: string, schema: Schema): Table {
  const own = schema.properties ? [{ title: '', rows: rowsOf(schema) }] : [];
  const choices = (schema.oneOf ?? []).filter(({ properties }) => properties);
  const alternatives = choices.map((choice) => ({ title: plain(choice.description), rows: rowsOf(choice) }));
  const words = (schema.oneOf ?? []).flatMap(({ const: word, description }) =>
    word === undefined ? [] : [{ word, meaning: plain(description) }],
  );
  return { name, description: plain(schema.description), parts: [...own, ...alternatives], words };
}

export const tablesOf = (schema: Schema): Table[] => [
  tableOf(schema.title ?? '', schema),
  ...Object.entries(schema.$defs ?? {}).map(([name, part]) => tableOf(name, part)),
];
