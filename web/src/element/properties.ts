/** Properties that reflect attributes, by the rules of HTML. */

export interface PropertyOptions {
  /** Its attribute: by default its name in lower case. */
  readonly attribute?: string | false;
  /**
   * By default text, empty without the attribute. A `flag` is true while the attribute is present, an `address` is
   * absolute, and `optional` text is null without the attribute.
   */
  readonly kind?: 'flag' | 'address' | 'optional';
  /** The words of an attribute that has no other values. */
  readonly words?: readonly string[];
  /** The value without the attribute, or without a property that has none. */
  readonly initial?: unknown;
  /** The value for other words than these: by default `initial`. */
  readonly invalid?: string;
}

export type Properties = Readonly<Record<string, PropertyOptions>>;

/** Names of properties by their attributes. */
export const propertiesByAttribute = (properties: Properties): ReadonlyMap<string, string> => {
  const names = new Map<string, string>();
  for (const name of Object.keys(properties)) {
    const attribute = attributeOf(properties, name);
    if (attribute !== null) names.set(attribute, name);
  }
  return names;
};

/** The attribute of a property; null without one. */
export function attributeOf(properties: Properties, name: string): string | null {
  const { attribute = name.toLowerCase() } = properties[name] ?? {};
  return attribute === false ? null : attribute;
}

/** The value of a property whose attribute is `text`, in a document with an address. */
export function valueFrom(options: PropertyOptions, text: string | null, base: string): unknown {
  const { kind, words, initial = null, invalid = initial } = options;
  if (kind === 'flag') return text !== null;
  if (words) return text === null ? initial : (wordOf(words, text) ?? invalid);
  if (kind === 'optional') return text;
  return kind === 'address' && text ? resolved(text, base) : (text ?? '');
}

/** Words are compared as HTML does. */
const wordOf = (words: readonly string[], text: string): string | undefined =>
  words.find((word) => word === text.toLowerCase());

function resolved(text: string, base: string): string {
  try {
    return new URL(text, base).href;
  } catch {
    return text;
  }
}

/** Whether an attribute rejects a text. An attribute without a list of words accepts any text. */
export const isUnknown = ({ words, invalid }: PropertyOptions, text: string): boolean =>
  words !== undefined && wordOf(words, text) === undefined && !(text === '' && invalid !== undefined);

/** The attribute of a value; null if it is absent. */
export function textOf({ kind }: PropertyOptions, value: unknown): string | null {
  if (kind === 'flag') return value ? '' : null;
  return value === null || value === undefined ? null : String(value);
}

/** Removes and returns an element's own properties, set before it was defined, because they would hide accessors. */
export function taken(from: object, names: readonly string[]): Record<string, unknown> {
  const values: Record<string, unknown> = {};
  for (const name of names) {
    if (!Object.hasOwn(from, name)) continue;
    values[name] = Reflect.get(from, name);
    Reflect.deleteProperty(from, name);
  }
  return values;
}
