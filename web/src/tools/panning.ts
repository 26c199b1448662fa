/** Panning: the picture follows the pointer. */
import { subtract, type Vec } from '../geometry/vec';
import { outcome, type State } from './state';

export const panning = (last: Vec, rest: State): State => ({
  move: (press) => outcome(panning(press.stage, rest), { type: 'pan', by: subtract(press.stage, last) }),
  up: () => outcome(rest),
  cancel: () => outcome(rest),
});
