/** Simplified Chinese. It has no plurals: every count takes a measure word. */
import { languageOf } from '../language';

export const { number, list } = languageOf('zh');

export const quoted = (name: string): string => `“${name}”`;

/** Of many names only the first few, since a long notice would cover the picture. */
export const fewNames = (names: readonly string[]): string =>
  list(
    names.length > 6
      ? [...names.slice(0, 5).map(quoted), `另外 ${number(names.length - 5)} 个`]
      : names.map(quoted),
  );

export const handleCount = (count: number): string => `${number(count)} 个控制点`;
export const keyCount = (count: number): string => `${number(count)} 个关键帧`;
