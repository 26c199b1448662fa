/** The lens tool (I): a press examines the point under it, and a drag follows the pointer. It holds no handle. */
import { type Outcome, outcome, type Press, type State } from './state';

export const lens: State = {
  down: (press) => look(press),
};

const looking: State = {
  move: (press) => look(press),
  up: () => outcome(lens),
  cancel: () => outcome(lens),
};

function look({ at }: Press): Outcome {
  return outcome(looking, { type: 'look', at });
}
