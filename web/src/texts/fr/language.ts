/** French. Zero is singular: the rules of the language say so. */
import { languageOf } from '../language';

export const { plural, number, list } = languageOf('fr');

/** "1 clé", "2 clés". The plural is given where it takes more than an s at the end. */
export const counted = (count: number, one: string, other = `${one}s`): string =>
  `${number(count)} ${plural(count, { one, other })}`;

/** Of many names only the first few, since a long notice would cover the picture. */
export const fewNames = (names: readonly string[], quote = (name: string) => name): string =>
  list(names.length > 6 ? [...names.slice(0, 5).map(quote), `${names.length - 5} autres`] : names.map(quote));

export const quoted = (name: string): string => `« ${name} »`;
