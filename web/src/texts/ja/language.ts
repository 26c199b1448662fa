/** Japanese. Nouns have no plural. */
import { languageOf } from '../language';

export const { number, list } = languageOf('ja');

/** Things that are counted by 個. */
export const counted = (count: number, noun: string): string => `${number(count)}個の${noun}`;

/** Of many names only the first few, since a long notice would cover the picture. */
export const fewNames = (names: readonly string[], quote = (name: string) => name): string =>
  list(names.length > 6 ? [...names.slice(0, 5).map(quote), `ほか${names.length - 5}個`] : names.map(quote));

export const quoted = (name: string): string => `「${name}」`;
