/** Finds programs on this machine. */
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';

/** The path of the first of some programs in PATH, or null. @param {...string} names */
export function executable(...names) {
  const folders = (process.env.PATH ?? '').split(delimiter);
  const paths = names.flatMap((name) => folders.map((folder) => join(folder, name)));
  return paths.find((path) => existsSync(path)) ?? null;
}
