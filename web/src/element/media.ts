/** The device and its settings, as an element sees them. */
import type { Media } from '../editor/page';
import { isFromRight } from './inherited_language';

/**
 * Tells them of an element, each time they are asked for.
 *
 * The queries are kept: every frame of an animation asks them.
 */
export function mediaOf(node: Element & { readonly theme: string }): () => Media {
  const darkScheme = matchMedia('(prefers-color-scheme: dark)');
  const coarsePointer = matchMedia('(pointer: coarse)');
  const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)');
  return () => {
    const { theme } = node;
    return {
      dark: theme === 'auto' ? darkScheme.matches : theme === 'dark',
      coarse: coarsePointer.matches,
      still: reducedMotion.matches,
      platform: navigator.platform,
      rtl: isFromRight(node),
      folders: 'showDirectoryPicker' in globalThis,
    };
  };
}
