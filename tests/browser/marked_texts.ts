/** Finds texts of the editor that are not in its table, and texts that do not fit. */
import type { Page } from '@playwright/test';

/** Names by people, and texts that are the same in all languages: units, formats, keys and symbols. */
const SAME: readonly RegExp[] = [
  /\b(left|right) (hand|foot)\b/gi,
  /\b(head|arm|blob|clip|sway|wave|walk in place)\b/gi,
  /\bgingerbread(-[\w-]+)?(\.[\w.]+)?\b/g,
  /\b(px|ms|s|min|fps|kB|MB|GB)\b/g,
  /\b(PNG|JPEG|WebP|SVG|WebM|MP4|GIF|APNG|EXR|NPY|CSV|Spine|DragonBones|glTF|Godot)\b/g,
  /\bC²|α|\b[nrdhxy]\b/g,
  /\b([A-Z]|F\d+|Tab|Enter|Alt)\b/g,
];

/** Every text, label and tooltip that is shown outside of the marks ⟦⟧ of the pseudo-language. */
export async function unmarked(page: Page): Promise<readonly string[]> {
  const shown = await page.locator('c2-warp').evaluate((element) => {
    const texts: string[] = [];
    const attributes = [
      'aria-label',
      'aria-description',
      'aria-valuetext',
      'title',
      'placeholder',
      'data-tip',
    ];
    const walk = (node: Element) => {
      if (node instanceof HTMLStyleElement || node.matches('textarea, .brand')) return;
      if (node instanceof HTMLElement && !node.checkVisibility() && !node.matches('option, optgroup')) return;
      const tag = `${node.localName}.${node.getAttribute('class') ?? ''}`;
      for (const name of attributes) {
        const value = node.getAttribute(name);
        if (value) texts.push(`${tag} ${name}|${value}`);
      }
      // An index of a symbol divides its sentence.
      if (node.querySelector(':scope > sub')) {
        texts.push(`${tag}|${node.textContent?.trim()}`);
        return;
      }
      for (const child of node.childNodes) {
        if (child instanceof Element) walk(child);
        else if (child instanceof Text && child.data.trim()) texts.push(`${tag}|${child.data.trim()}`);
      }
    };
    for (const child of element.shadowRoot?.children ?? []) walk(child);
    return texts;
  });
  return shown.filter((text) => /\p{L}/u.test(rest(text.slice(text.indexOf('|') + 1))));
}

/** A text without its marked parts and those that are the same in all languages. */
function rest(text: string): string {
  let [left, before] = [text, ''];
  // From the inside: marked texts hold others.
  while (left !== before) [before, left] = [left, left.replace(/⟦[^⟦⟧]*⟧/g, '')];
  return SAME.reduce((words, same) => words.replace(same, ''), left);
}

/** Controls and words that do not fit: they leave the editor, are cut off, or run out of their box. */
export const unfitting = (page: Page): Promise<readonly string[]> =>
  page.locator('c2-warp').evaluate((element) => {
    const root = element.shadowRoot as ShadowRoot;
    const frame = element.getBoundingClientRect();
    const found: string[] = [];
    const scrolls = (node: Element | null): boolean =>
      node !== null &&
      (/auto|scroll/.test(getComputedStyle(node).overflowX + getComputedStyle(node).overflowY) ||
        scrolls(node.parentElement));
    const own = (node: Element) =>
      [...node.childNodes].some((child) => child instanceof Text && child.data.trim() !== '');
    for (const node of root.querySelectorAll('.shell *')) {
      if (!(node instanceof HTMLElement) || !node.checkVisibility({ opacityProperty: true })) continue;
      // Names by people may be cut, and so may words below icons, which have a label. Spoken texts are not seen. Marks
      // lie anywhere on the stage.
      if (node.closest('.stage, .spoken, .title, .track-name, .name, .caption, option, svg, .bubble'))
        continue;
      const { left, right, top, bottom, width } = node.getBoundingClientRect();
      if (width === 0) continue;
      const label = `${node.localName}.${node.className}: ${node.textContent?.trim().slice(0, 40)}`;
      const isOut =
        left < frame.left - 1 || right > frame.right + 1 || top < frame.top - 1 || bottom > frame.bottom + 1;
      if (isOut && !scrolls(node.parentElement)) found.push(`out of the editor: ${label}`);
      const runs = node.scrollWidth > node.clientWidth + 1 && getComputedStyle(node).display !== 'inline';
      const isScroller = /auto|scroll/.test(getComputedStyle(node).overflowX);
      if (own(node) && runs && !isScroller) found.push(`too narrow: ${label}`);
      if (
        own(node) &&
        node.scrollHeight > node.clientHeight + 3 &&
        /hidden|clip/.test(getComputedStyle(node).overflowY)
      )
        found.push(`cut off: ${label}`);
    }
    return found;
  });
