/** Writes a project, a pose or keys as text, with one line per key, handle and key of a clip: diffs are readable. */
import type { Handle, Key, Project } from './project';

export interface Pose {
  readonly format: string;
  readonly handles: readonly Handle[];
}

export interface Keys {
  readonly format: string;
  readonly keys: readonly (Key & { readonly handle: string })[];
}

export function projectText(project: Project | Pose | Keys): string {
  const lines = Object.entries(project).map(
    ([key, value]) => `  ${JSON.stringify(key)}: ${valueText(value)}`,
  );
  return `{\n${lines.join(',\n')}\n}\n`;
}

/** Returns a value with each item of a list on its own line. */
function valueText(value: unknown, indent = 2): string {
  if (!Array.isArray(value) || value.length === 0) return lineText(value, indent);
  const [inside, outside] = [indent + 2, indent].map((spaces) => `\n${' '.repeat(spaces)}`);
  return `[${inside}${value.map((item) => lineText(item, indent + 2)).join(`,${inside}`)}${outside}]`;
}

/** The lists inside a clip. */
const LISTS: readonly string[] = ['tracks', 'keys'];

/** Returns a value in one line, with a space after commas and colons. The lists of a clip have a line for each item. */
function lineText(value: unknown, indent = 0): string {
  if (Array.isArray(value)) return `[${value.map((item) => lineText(item)).join(', ')}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const entries = Object.entries(value).filter(([, item]) => item !== undefined);
  const text = ([key, item]: [string, unknown]) =>
    `${JSON.stringify(key)}: ${LISTS.includes(key) ? valueText(item, indent + 2) : lineText(item)}`;
  return `{${entries.map(text).join(', ')}}`;
}
