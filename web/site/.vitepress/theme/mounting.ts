/** Mounts a figure into an element of the page, and returns a function that removes it. */
export type Mount = (host: HTMLElement) => undefined | (() => void) | Promise<undefined | (() => void)>;

/**
 * Loads a figure and mounts it when its place scrolls near.
 * @returns A function that removes the figure, at any time.
 */
export function mountWhenNear(host: HTMLElement, load: () => Promise<Mount>): () => void {
  let removed = false;
  let remove: (() => void) | undefined;
  const observer = new IntersectionObserver(
    async ([entry]) => {
      if (!entry?.isIntersecting) return;
      observer.disconnect();
      const mount = await load();
      if (removed) return;
      remove = await mount(host);
      if (removed) remove?.();
    },
    { rootMargin: '400px' },
  );
  observer.observe(host);
  return () => {
    removed = true;
    observer.disconnect();
    remove?.();
  };
}
