/** Tells the handles that force folds, with a way out, where folds or handles are new. */

import { handleById } from '../../document/document';
import { nameWords } from '../../document/names';
import { say } from '../../texts/wording';
import { isPressing } from '../../tools/machine';
import type { Emit } from '../effects';
import { foldsWords } from '../notice_words';
import { mayEdit } from '../permissions';
import { documentOf, type EditorState, projectOf } from '../state';
import { notify } from './notices';

/** Waits for the end of a press: it takes some poses, and a person does not read meanwhile. */
export function checkForcing(before: EditorState, emit: Emit): EditorState {
  const { checks, solution, tools } = before;
  const folds = checks.creases.length > 0;
  if (isPressing(tools) || (!folds && checks.forcing.length === 0)) return before;
  const forcing = folds ? (solution.shown?.deformation.forcing(projectOf(before)) ?? []) : [];
  if (isSame(forcing, checks.forcing)) return before;
  const state = { ...before, checks: { ...checks, forcing } };
  if (forcing.length === 0 || !mayEdit(state)) return state;
  const names = forcing.flatMap((id) => handleById(documentOf(state), id) ?? []).map(nameWords);
  const event = { type: 'command-run', command: 'without-folds' } as const;
  const action = { label: say('commands.without-folds'), event } as const;
  return notify(state, { kind: 'info', text: foldsWords(names), action, passes: true, ofStep: true }, emit);
}

const isSame = (a: readonly string[], b: readonly string[]): boolean =>
  a.length === b.length && a.every((id) => b.includes(id));
