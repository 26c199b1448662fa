/** Plurals, numbers and lists of one language, for the functions of its table. */

/** Forms of a text by the plural categories of the language. `other` serves where a category is left out. */
export type Forms = Partial<Readonly<Record<Intl.LDMLPluralRule, string>>> & { readonly other: string };

export interface Language {
  /** The form for a count. */
  plural(count: number, forms: Forms): string;
  /** A number with its thousands grouped. */
  number(value: number): string;
  /** Names in a sentence: "a, b and c". */
  list(names: readonly string[]): string;
}

/** @param tag the BCP 47 tag of the language. */
export function languageOf(tag: string): Language {
  const rules = new Intl.PluralRules(tag);
  const numbers = new Intl.NumberFormat(tag);
  const lists = new Intl.ListFormat(tag);
  return {
    plural: (count, forms) => forms[rules.select(count)] ?? forms.other,
    number: (value) => numbers.format(value),
    list: (names) => lists.format(names),
  };
}

/** A text with its first letter in lower case. */
export const lowered = (text: string): string => `${text.charAt(0).toLowerCase()}${text.slice(1)}`;

/** Joins the parts that are not empty. */
export const joined = (parts: readonly string[], between = ' '): string =>
  parts.filter(Boolean).join(between);
