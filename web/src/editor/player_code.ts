/** The HTML that shows a rig in a page beside its file: see web/docs/player.md. */
import type { Project } from '../document/project';
import { stem } from './picture';

/** The name of the file that an export for the web gets. */
export const rigName = (picture: string): string => `${stem(picture)}.c2rig`;

/**
 * Two lines of HTML: the player's script, and the player.
 *
 * @param picture The name of the picture's file.
 * @param posable Whether readers may pose the handles.
 */
export function playerCode(
  { image, handles, clips = [] }: Project,
  picture: string,
  posable: boolean,
): string {
  const [first] = clips;
  const plays = first ? ` autoplay${first.loop === 'none' ? '' : ' loop'}` : '';
  const flags = posable && handles.length > 0 ? `${plays} posable` : plays;
  const alt = stem(picture).replaceAll(/[-_\s]+/g, ' ');
  const src = encodeURIComponent(rigName(picture));
  return `<script type="module" src="player/c2warp-player.js"></script>
<c2-warp-player src="${src}" width="${image.width}" height="${image.height}" alt="${escaped(alt)}"${flags}></c2-warp-player>
`;
}

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '"': '&quot;', '<': '&lt;' };

const escaped = (text: string): string => text.replaceAll(/[&"<]/g, (character) => ENTITIES[character] ?? '');
