/** The base class of elements; an empty class without a DOM, so that servers and workers can import the element. */
export const AnyElement = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);
