/** Properties that mirror attributes. */

export interface PropertyOptions {
  /** Its attribute: by default its name in lower case. */
  readonly attribute?: string | false;
  /** True while the attribute is present. Other properties are the attribute's text, or null. */
  readonly type?: BooleanConstructor;
  /** Whether setting the property sets the attribute. */
  readonly reflect?: boolean;
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

/** The value of a property whose attribute is `text`. */
export const valueFrom = ({ type }: PropertyOptions, text: string | null): unknown =>
  type === Boolean ? text !== null : text;

/** The attribute of a value; null if it is absent. */
export function textOf({ type }: PropertyOptions, value: unknown): string | null {
  if (type === Boolean) return value ? '' : null;
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
