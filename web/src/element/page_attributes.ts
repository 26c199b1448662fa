/** The attributes of an element in the form for the editor. */
import { featuresOf } from '../editor/features';
import type { PageAttributes } from '../editor/page';

type Plain = Pick<PageAttributes, 'readonly' | 'disabled' | 'posable' | 'autoplay' | 'loop' | 'samples'>;

/** The element. Addresses are taken as the page wrote them: projects name their pictures so. */
interface Source extends Plain, Pick<Element, 'getAttribute'> {
  readonly toolSource: string | null;
  readonly hintFor: string;
  readonly crossOrigin: string | null;
}

export function pageAttributes(element: Source, defaults: PageAttributes['defaults']): PageAttributes {
  const { readonly, disabled, posable, autoplay, loop, samples } = element;
  const text = (attribute: string) => element.getAttribute(attribute) || null;
  const hint = text('hint');
  return {
    readonly,
    disabled,
    posable,
    clip: text('clip'),
    autoplay,
    loop,
    tool: element.toolSource,
    alt: element.getAttribute('alt'),
    hint: hint === null ? null : { text: hint, handle: element.hintFor || null },
    src: text('src'),
    projectSource: text('project'),
    samples,
    features: featuresOf(element.getAttribute('features')),
    credentials: element.crossOrigin === 'use-credentials' ? 'include' : 'same-origin',
    defaults,
  };
}
