/** The type of a language: a table with the entries of English. */
import type { en } from './en/index';

/** A text, or a function that makes it of numbers and names. */
export type Entry = string | ((...values: never[]) => string);

/** Literal types, which functions with several results have, become strings. */
type Table<T> = {
  readonly [K in keyof T]: T[K] extends string
    ? string
    : T[K] extends (...values: infer Values) => string
      ? (...values: Values) => string
      : Table<T[K]>;
};

/** All texts of a language. */
export type Texts = Table<typeof en>;

/** Some texts of a language; the others are English. */
export type PartialTexts = PartialTable<Texts>;

type PartialTable<T> = {
  readonly [K in keyof T]?: T[K] extends Entry ? T[K] : PartialTable<T[K]>;
};
