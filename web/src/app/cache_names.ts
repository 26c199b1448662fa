/** The caches of the editor. Several editors of one origin differ by their scope: the address of their folder. */

/** All files of the editor, by path and content. */
export const filesCache = (scope: string): string => `c2warp files ${scope}`;

/** Files that other programs have shared, until the page opens them. */
export const sharedCache = (scope: string): string => `c2warp shared ${scope}`;
