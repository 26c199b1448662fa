/** The hand tool (H): every press pans. */
import { panning } from './panning';
import { outcome, type State } from './state';

export const hand: State = {
  down: (press) => outcome(panning(press.stage, hand)),
};
