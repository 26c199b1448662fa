/** The entry `c2warp/player`: defines `<c2-warp-player>`. Servers can also import it. */
import { C2WarpPlayer } from './player/element';

export { C2WarpError, type C2WarpErrorCode } from './error';
export type { C2WarpPlayerEventMap } from './player/events';
export type { HandlePose, PosedHandle } from './player/posed';
export { C2WarpPlayer };

if (globalThis.customElements && !customElements.get('c2-warp-player'))
  customElements.define('c2-warp-player', C2WarpPlayer);

declare global {
  interface HTMLElementTagNameMap {
    'c2-warp-player': C2WarpPlayer;
  }
}
