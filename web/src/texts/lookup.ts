/** Finding the table for a language. */
import type { PartialTexts, Texts } from './texts';

/** A tag and its parents, from the most special on: `de-AT`, `de`. In lower case. */
export function parentsOf(tag: string): readonly string[] {
  const parts = tag.trim().toLowerCase().split(/[-_]/);
  return parts.map((_, k) => parts.slice(0, parts.length - k).join('-')).filter(Boolean);
}

/** The first of a person's languages that there are texts for, or English. */
export const bestOf = (wanted: readonly string[], there: readonly string[]): string =>
  wanted.flatMap(parentsOf).find((tag) => tag === 'en' || there.includes(tag)) ?? 'en';

/** A table with the entries of another one in place of its own. */
export const changedBy = (texts: Texts, changes: PartialTexts): Texts => merged(texts, changes) as Texts;

function merged(table: Table, changes: Table): Table {
  const entries = Object.entries(table).map(([key, own]) => {
    const change = changes[key];
    const both = isTable(own) && isTable(change) ? merged(own, change) : (change ?? own);
    return [key, both];
  });
  return Object.fromEntries(entries);
}

type Table = Readonly<Record<string, unknown>>;

const isTable = (value: unknown): value is Table => typeof value === 'object' && value !== null;

const FROM_THE_RIGHT = ['ar', 'ckb', 'dv', 'fa', 'he', 'ps', 'sd', 'ug', 'ur', 'yi'];

/** The direction in which a language is written. */
export const directionOf = (tag: string): 'ltr' | 'rtl' =>
  FROM_THE_RIGHT.includes(parentsOf(tag).at(-1) ?? '') ? 'rtl' : 'ltr';
