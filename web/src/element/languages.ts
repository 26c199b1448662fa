/** The languages of a page: those of the package, loaded on first use, and those of the page. */
import { en } from '../texts/en';
import { changedBy, parentsOf } from '../texts/lookup';
import type { PartialTexts, Texts } from '../texts/texts';

const SHIPPED: Readonly<Record<string, () => Promise<Texts>>> = {
  de: async () => (await import('../texts/de')).de,
  es: async () => (await import('../texts/es')).es,
  fr: async () => (await import('../texts/fr')).fr,
  ja: async () => (await import('../texts/ja')).ja,
  zh: async () => (await import('../texts/zh')).zh,
};

/** Tables of the page, by tags in lower case. */
const added = new Map<string, PartialTexts>();

/** Called when a page adds a language. */
const followers = new Set<() => void>();

/** The tags of all languages. */
export const languageTags = (): readonly string[] => [
  ...new Set(['en', ...Object.keys(SHIPPED), ...added.keys()]),
];

export function addLanguage(tag: string, texts: PartialTexts): void {
  added.set(tag.toLowerCase(), texts);
  for (const follow of followers) follow();
}

/** Calls `changed` whenever a page adds a language, until the signal is aborted. */
export function followLanguages(changed: () => void, signal: AbortSignal): void {
  followers.add(changed);
  signal.addEventListener('abort', () => followers.delete(changed));
}

/** The texts of a language, and the tag that marks them. */
export interface Language {
  readonly tag: string;
  readonly texts: Texts;
}

export const ENGLISH: Language = { tag: 'en', texts: en };

/**
 * The texts for a tag: of `de-AT`, then of `de`, then English. Languages that do not load are skipped.
 *
 * @param failed receives the reason.
 */
export async function languageFor(wanted: string, failed: (cause: unknown) => void): Promise<Language> {
  const tags = parentsOf(wanted);
  const known = tags.find((tag) => tag === 'en' || SHIPPED[tag] || added.has(tag));
  const language = tags.find((tag) => tag === 'en' || SHIPPED[tag]) ?? 'en';
  const shipped = await SHIPPED[language]?.().catch(failed);
  const changes = [...new Set(['en', ...tags.toReversed()])].flatMap((tag) => added.get(tag) ?? []);
  if (!known || (changes.length === 0 && !shipped)) return withChanges(ENGLISH, changes);
  return withChanges({ tag: wanted.trim(), texts: shipped ?? en }, changes);
}

const withChanges = ({ tag, texts }: Language, changes: readonly PartialTexts[]): Language => ({
  tag,
  texts: changes.reduce(changedBy, texts),
});
