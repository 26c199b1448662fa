/** The hand tool (H): pans, whatever lies under the pointer. */
import { panning } from './panning';
import { outcome, type State } from './state';

export const hand: State = {
  down: (press) => outcome(panning(press.stage, hand)),
};
