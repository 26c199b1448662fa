/** The attributes of an element in the form for the editor. */
import { featuresOf } from '../editor/features';
import type { PageAttributes } from '../editor/page';

type Plain = Omit<PageAttributes, 'tool' | 'hint' | 'credentials' | 'features'>;

/** The properties of the element from which they are derived. */
interface Source extends Plain {
  readonly toolSource: string | null;
  readonly hint: string | null;
  readonly hintFor: string | null;
  readonly crossOrigin: string | null;
  readonly features: string | null;
}

export function pageAttributes(
  element: Omit<Source, 'defaults'>,
  defaults: Source['defaults'],
): PageAttributes {
  const { readonly, disabled, posable, clip, autoplay, loop, alt, src, projectSource, samples } = element;
  return {
    readonly,
    disabled,
    posable,
    clip,
    autoplay,
    loop,
    tool: element.toolSource,
    alt,
    hint: element.hint ? { text: element.hint, handle: element.hintFor } : null,
    src,
    projectSource,
    samples,
    features: featuresOf(element.features),
    credentials: element.crossOrigin === 'use-credentials' ? 'include' : 'same-origin',
    defaults,
  };
}
