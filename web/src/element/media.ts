/** The settings of the device that affect an element. */
import type { Media } from '../editor/page';
import { isFromRight } from './inherited_language';

/**
 * Returns the current settings for an element.
 *
 * The queries are cached, because every frame of an animation uses them.
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
