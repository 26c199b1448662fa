/** The editor in a language in which every text is marked: in brackets, with accents, and 40 % longer. */
import { C2Warp, type PartialTexts, type Texts } from '../../../web/src/element';
import { en } from '../../../web/src/texts/en';

const ACCENTS: Readonly<Record<string, string>> = { a: 'á', e: 'é', i: 'í', o: 'ó', u: 'ú', c: 'ç', n: 'ñ' };

/** Texts within a text are marked already. */
const marked = (text: string): string => {
  const own = text.replace(/⟦[^⟧]*⟧/g, '').length;
  const accented = text.replace(/⟦[^⟧]*⟧|[aeioucn]/g, (part) => ACCENTS[part] ?? part);
  const more = Math.ceil(0.4 * own);
  // Sentences get words, which can be broken between lines.
  const padding = own > 16 ? ' ~~~~~'.repeat(Math.ceil(more / 6)) : '~'.repeat(more);
  return text === '' ? '' : `⟦${accented}${padding}⟧`;
};

type Table = { readonly [key: string]: string | ((...values: never[]) => string) | Table };

const pseudo = (table: Table): Table =>
  Object.fromEntries(
    Object.entries(table).map(([key, entry]) => {
      if (typeof entry === 'string') return [key, marked(entry)];
      if (typeof entry === 'object') return [key, pseudo(entry)];
      return [key, (...values: never[]) => marked(entry(...values))];
    }),
  );

/** Adds the language `qps`, and an editor that shows it. */
export function pseudoEditor(): void {
  C2Warp.addLanguage('qps', pseudo(en as unknown as Table) as unknown as Texts);
  document.documentElement.lang = 'qps';
  // As on the page of the editor.
  document.body.style.cssText = 'margin: 0; height: 100vh';
  const editor = document.createElement('c2-warp');
  editor.style.cssText = 'display: block; width: 100%; height: 100%';
  document.body.append(editor);
}

/** Adds texts of a language. */
export const addTexts = (tag: string, texts: PartialTexts): void => C2Warp.addLanguage(tag, texts);
