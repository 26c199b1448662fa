/** The class of elements; where there is no DOM an empty one, so that servers and workers can import the element. */
export const AnyElement = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);
