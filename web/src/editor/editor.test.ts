import { describe, expect, it } from 'vitest';
import { isSameWork } from '../document/document';
import { timeline, undoLabel } from '../document/history';
import { en } from '../texts/en';
import { inEnglish } from './english';
import { editedAtRandom, settle } from './random_edits';
import { documentOf } from './state';
import { viewModel } from './view_model';

describe('10,000 random sequences of events', () => {
  it('never throw, undo and redo exactly to the first step, and record no empty one', () => {
    for (let seed = 0; seed < 10_000; seed++) {
      const runtime = editedAtRandom(seed);
      viewModel(runtime.state, en);
      settle(runtime);
      const { values } = timeline(runtime.state.document.history);
      for (const [k, value] of values.entries()) {
        const next = values[k + 1];
        if (next) expect(isSameWork(value, next), `seed ${seed}: a step that changes nothing`).toBe(false);
      }
      // A pose of the page is no step: redo does not bring it back.
      if (inEnglish(undoLabel(runtime.state.document.history)) === null || runtime.posedByPage) continue;
      const before = documentOf(runtime.state);
      const { at } = timeline(runtime.state.document.history);
      for (const steps of [1, at]) {
        for (let step = 0; step < steps; step++) runtime.dispatch({ type: 'undo-asked' });
        for (let step = 0; step < steps; step++) runtime.dispatch({ type: 'redo-asked' });
        expect(isSameWork(documentOf(runtime.state), before), `seed ${seed}: ${steps} steps back`).toBe(true);
      }
    }
  }, 300_000);
});
