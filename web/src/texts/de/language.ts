/** German. */
import { languageOf } from '../language';

export const { plural, number, list } = languageOf('de');

/** A number with its noun: "1 Griff", "2 Griffe". */
export const counted = (count: number, one: string, other: string): string =>
  `${number(count)} ${plural(count, { one, other })}`;

export const handleCount = (count: number): string => counted(count, 'Griff', 'Griffe');

export const keyCount = (count: number): string => counted(count, 'Keyframe', 'Keyframes');

/** Of many names only the first few, since a long notice would cover the picture. */
export const fewNames = (names: readonly string[], quote = (name: string) => name): string =>
  list(
    names.length > 6 ? [...names.slice(0, 5).map(quote), `${names.length - 5} weitere`] : names.map(quote),
  );

export const quoted = (name: string): string => `„${name}“`;
