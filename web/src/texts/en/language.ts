/** English. Lists have no comma before "and". */
import { languageOf } from '../language';

export const { plural, number, list } = languageOf('en-GB');

/** "1 key", "2 keys": for nouns that form their plural by an s. */
export const counted = (count: number, noun: string): string =>
  `${number(count)} ${noun}${plural(count, { one: '', other: 's' })}`;

/** Of many names only the first few, since a long notice would cover the picture. */
export const fewNames = (names: readonly string[], quote = (name: string) => name): string =>
  list(names.length > 6 ? [...names.slice(0, 5).map(quote), `${names.length - 5} more`] : names.map(quote));

export const quoted = (name: string): string => `“${name}”`;
