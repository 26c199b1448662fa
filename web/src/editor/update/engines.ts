/** Exports of rigs for game engines. */
import type { EngineLoss } from '../../document/engine_rig';
import type { Emit } from '../effects';
import { bonesOf, ENGINE_FORMATS, type EngineChoices, engineFile, influencesOf } from '../engine_choices';
import { stem } from '../picture';
import { type EditorState, filedProject } from '../state';
import { saveWork } from './autosave';
import { beginExport, withExport } from './export_slice';
import type { Handlers } from './handlers';

export function exportEngineRig(state: EditorState, emit: Emit): EditorState {
  const { picture, exporting, media } = state;
  if (!picture || exporting.running) return state;
  const { engine: choices } = exporting;
  const { format, vertices, into } = choices;
  const { extension } = ENGINE_FORMATS[format];
  const target = extension ? 'file' : into === 'folder' && media.folders ? 'folder' : 'zip';
  const influences = influencesOf(choices);
  const project = filedProject(state);
  const bones = bonesOf(choices, project);
  const order = { format, bones, influences, vertices, stem: stem(picture.name) };
  const name = engineFile(picture.name, format);
  emit({ type: 'export-engine-rig', name, project, choices, picture, order, target });
  return beginExport(withExport(state, { measured: null }), emit);
}

const choose = (state: EditorState, choice: Partial<EngineChoices>, emit: Emit): EditorState =>
  saveWork(withExport(state, { engine: { ...state.exporting.engine, ...choice } }), emit);

export const engineHandlers: Handlers<'engine-choice-made' | 'engine-rig-measured'> = {
  'engine-choice-made': (state, { choice }, emit) => choose(state, choice, emit),
  'engine-rig-measured': (state, { project, choices, loss }) =>
    withExport(state, { measured: { project, choices, loss } }),
};

/** The loss of the rig that was just saved; null after other exports. */
export const lossOf = ({ exporting }: EditorState): EngineLoss | null =>
  exporting.kind === 'engine' ? (exporting.measured?.loss ?? null) : null;
