/** Exports for web pages: a rig, and the code that shows it. */
import type { Emit } from '../effects';
import { playerCode, rigName } from '../player_code';
import { type EditorState, filedProject } from '../state';
import { beginExport, withExport } from './export_slice';
import type { Handlers } from './handlers';

export function exportRig(state: EditorState, emit: Emit): EditorState {
  const { picture, exporting } = state;
  if (!picture || exporting.running) return state;
  const { posable } = exporting;
  emit({ type: 'export-rig', name: rigName(picture.name), posable, project: filedProject(state), picture });
  return beginExport(state, emit);
}

function copyCode(state: EditorState, emit: Emit): EditorState {
  const { picture, exporting } = state;
  const code = picture && playerCode(filedProject(state), picture.name, exporting.posable);
  if (code) emit({ type: 'copy-code', code });
  return state;
}

export const webPageHandlers: Handlers<'posable-chosen' | 'code-asked' | 'code-copied'> = {
  'posable-chosen': (state, { posable }) => withExport(state, { posable, code: null }),
  'code-asked': (state, _, emit) => copyCode(state, emit),
  'code-copied': (state, { copied }, emit) => {
    if (!copied) emit({ type: 'focus-control', control: 'code' });
    return withExport(state, { code: copied ? 'copied' : 'blocked' });
  },
};
