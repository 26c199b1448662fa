/** Writes a project or a pose as text, with one line per key and per handle, so that diffs are readable. */
import type { Handle, Project } from './project';

export interface Pose {
  readonly format: string;
  readonly handles: readonly Handle[];
}

export function projectText(project: Project | Pose): string {
  const lines = Object.entries(project).map(
    ([key, value]) => `  ${JSON.stringify(key)}: ${valueText(value)}`,
  );
  return `{\n${lines.join(',\n')}\n}\n`;
}

function valueText(value: unknown): string {
  if (!Array.isArray(value) || value.length === 0) return lineText(value);
  return `[\n${value.map((item) => `    ${lineText(item)}`).join(',\n')}\n  ]`;
}

/** Returns a value in one line, with a space after commas and colons. */
function lineText(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(lineText).join(', ')}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const entries = Object.entries(value).filter(([, item]) => item !== undefined);
  return `{${entries.map(([key, item]) => `${JSON.stringify(key)}: ${lineText(item)}`).join(', ')}}`;
}
