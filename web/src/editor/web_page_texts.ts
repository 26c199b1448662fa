/** Texts about exports for web pages. */

export const WEB_PAGE_NOTE =
  'One small file with all clips, for the player: a script of 13 kB that needs no editor.';

export const WITHOUT_CLIPS = 'There is no clip yet: the page shows the pose.';

export const POSABLE_NOTE = 'Pages can pose its handles, too.';

export const CODE_NOTE = 'Paste it into a page beside the file and the folder “player” of the package.';

/** @param file the name of the file beside the page. */
export const codeCopiedText = (file: string): string =>
  `Copied. The code shows ${file} in a page beside it and the folder “player” of the package.`;

export const CODE_NOT_COPIED = 'The browser blocked the clipboard. The code is selected: copy it by hand.';
