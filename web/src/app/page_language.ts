/** The language of the editor's page: by its address, `?lang=de`, or by the browser. */
import { bestOf, directionOf } from '../texts/lookup';

/** Marks the page with its language, and returns the tag. @param there the tags that there are texts for. */
export function markLanguage(there: readonly string[]): string {
  const asked = new URLSearchParams(location.search).get('lang');
  const tag = bestOf(asked === null ? navigator.languages : [asked], there);
  const { documentElement } = document;
  documentElement.lang = tag;
  documentElement.dir = directionOf(tag);
  return tag;
}
