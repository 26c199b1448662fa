/** Texts of the clipboard: JSON with a format and one list. */

/** Whether a text says that it has a format, whatever its version. Also matches a text that is cut off. */
export const saysFormat = (text: string, name: string): boolean =>
  new RegExp(`^\\s*\\{.*"format"\\s*:\\s*"${name}/`, 's').test(text);

/**
 * Returns the items of the list.
 * @throws RangeError with the reason if the text is incomplete, of another version or without items.
 */
export function listIn(text: string, format: string, list: string): readonly unknown[] {
  const content = parsed(text);
  const items = content[list];
  if (content.format !== format) throw new RangeError(`format: expected "${format}"`);
  if (!Array.isArray(items) || items.length === 0) throw new RangeError(`${list}: expected a list`);
  return items;
}

function parsed(text: string): Readonly<Record<string, unknown>> {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new RangeError('its text is incomplete', { cause });
  }
}
