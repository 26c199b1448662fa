/**
 * Names of handles, clips, pictures and files, as people see them. Invisible characters are escaped, as in messages of
 * the command: `wasm/core/src/display_name.rs` has the same rule.
 *
 * A control character, or one that changes the direction of text, could change the words around the name.
 */

/** Control characters, direction marks, ends of lines and paragraphs, and the byte order mark. */
const NOT_DRAWN = /[\p{Cc}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]/gu;

const SHORT: Readonly<Record<string, string>> = { '\n': '\\n', '\r': '\\r', '\t': '\\t' };

/** The name as people read it. A name that is shown already stays as it is. */
export const shownName = (name: string): string =>
  name.replace(NOT_DRAWN, (sign) => SHORT[sign] ?? `\\u{${sign.codePointAt(0)?.toString(16)}}`);
