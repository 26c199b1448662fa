/** Spanish. */
import { languageOf } from '../language';

export const { plural, number, list } = languageOf('es');

/** "1 clave", "2 claves". */
export const counted = (count: number, one: string, other: string): string =>
  `${number(count)} ${plural(count, { one, other })}`;

export const countedHandles = (count: number): string =>
  counted(count, 'punto de control', 'puntos de control');

export const countedKeys = (count: number): string => counted(count, 'clave', 'claves');

/** Of many names only the first few, since a long notice would cover the picture. */
export const fewNames = (names: readonly string[], quote = (name: string) => name): string =>
  list(names.length > 6 ? [...names.slice(0, 5).map(quote), `${names.length - 5} más`] : names.map(quote));

export const quoted = (name: string): string => `«${name}»`;
