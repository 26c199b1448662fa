/** Exports in the state. */
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import type { EditorState, ExportState } from '../state';
import { beginTask } from './notices';

export const withExport = (state: EditorState, change: Partial<ExportState>): EditorState => ({
  ...state,
  exporting: { ...state.exporting, ...change },
});

/** @param cut whether the export cuts off a part of the posed picture. */
export function beginExport(state: EditorState, emit: Emit, cut = false): EditorState {
  const task = { name: 'export', label: say('tasks.exporting'), cancellable: true, fraction: 0 } as const;
  return beginTask(withExport(state, { running: { cut } }), task, emit);
}
