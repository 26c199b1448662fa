/** The built element, which lies beside the pages as visitors of other sites get it. */
export const loadElement = (): Promise<unknown> =>
  import(/* @vite-ignore */ `${import.meta.env.BASE_URL}element/c2warp.js`);
