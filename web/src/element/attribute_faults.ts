/** Checks attributes for invalid values. */
import { FEATURES, unknownFeatures } from '../editor/features';
import { C2WarpError } from '../error';
import { attributeOf, isUnknown, type Properties } from './properties';

/** The errors of the attributes of changed properties, as sentences for the author of the page. */
export function attributeFaults(
  element: Element,
  properties: Properties,
  changed: Iterable<string>,
): readonly C2WarpError[] {
  return [...changed].flatMap((name) => {
    const { words } = properties[name] ?? {};
    const attribute = attributeOf(properties, name);
    const text = attribute && element.getAttribute(attribute);
    if (attribute === null || text === null) return [];
    const [unknown] = attribute === 'features' ? unknownFeatures(text) : [];
    if (unknown !== undefined) return [fault(attribute, `some of ${FEATURES.join(', ')}`, unknown)];
    return isUnknown(properties[name] ?? {}, text)
      ? [fault(attribute, `one of ${(words ?? []).join(', ')}`, text)]
      : [];
  });
}

const fault = (attribute: string, expected: string, found: string): C2WarpError =>
  new C2WarpError('attribute', `${attribute}: expected ${expected}, found "${found}"`);
