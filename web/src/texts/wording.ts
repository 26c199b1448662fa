/** Wordings: words to people, as data. They become sentences in the language of their reader. */
import { shownName } from './shown_name';
import type { Entry, PartialTexts, Texts } from './texts';

type KeysOf<T> = {
  [K in keyof T & string]: T[K] extends Entry ? K : `${K}.${KeysOf<T[K]>}`;
}[keyof T & string];

/** The path of an entry: `notices.saved`. */
export type TextKey = KeysOf<Texts>;

type EntryAt<T, Path extends string> = Path extends `${infer K}.${infer Rest}`
  ? K extends keyof T
    ? EntryAt<T[K], Rest>
    : never
  : Path extends keyof T
    ? T[Path]
    : never;

/** An entry of the table with the values for it. Plain data: it can be stored, and posted to workers. */
export interface Wording<K extends TextKey = TextKey> {
  readonly key: K;
  readonly values: readonly Value[];
}

/** A name, or words about something. */
export type Words = string | Wording;

type Value = Words | number | boolean | null | readonly Words[];

/** Words can stand where an entry takes a name. */
type Given<V> = string extends V ? V | Wording : V extends readonly string[] ? readonly Words[] : V;

type ValuesOf<E> = E extends (...values: infer V) => string ? { [I in keyof V]: Given<V[I]> } : [];

/** Names an entry, with values for it. */
export const say = <K extends TextKey>(key: K, ...values: ValuesOf<EntryAt<Texts, K>>): Wording<K> => ({
  key,
  values: values as readonly Value[],
});

/** Words in a language. A key of another version of the editor is empty. */
export function worded(texts: PartialTexts, words: Words): string {
  if (typeof words === 'string') return words;
  const entry = words.key.split('.').reduce((table: unknown, name) => (table as Tables)?.[name], texts);
  if (typeof entry !== 'function') return typeof entry === 'string' ? entry : '';
  return (entry as (...values: unknown[]) => string)(...words.values.map((value) => rendered(texts, value)));
}

type Tables = Readonly<Record<string, unknown>> | undefined;

const rendered = (texts: PartialTexts, value: Value): unknown => {
  if (typeof value === 'string') return shownName(value);
  if (isList(value)) return value.map((words) => rendered(texts, words));
  return typeof value === 'object' && value !== null ? worded(texts, value) : value;
};

const isList = (value: Value): value is readonly Words[] => Array.isArray(value);

export const isSameWording = (a: Words, b: Words): boolean =>
  a === b || JSON.stringify(a) === JSON.stringify(b);

/** Whether stored data is a wording. */
export const isWording = (value: unknown): value is Wording =>
  typeof value === 'object' && value !== null && 'key' in value && 'values' in value;
