/** Exports of maps and weights. */
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import { type MapChoices, mapFile, mapFileName } from '../map_choices';
import { type EditorState, onlySelected } from '../state';
import { saveWork } from './autosave';
import { drawn } from './drawn';
import { beginExport, withExport } from './export_slice';
import type { Handlers } from './handlers';
import { inform } from './notices';

export function exportMap(state: EditorState, emit: Emit): EditorState {
  const { picture, exporting } = state;
  if (!picture || exporting.running) return state;
  const file = mapFile(exporting.maps, onlySelected(state)?.id ?? null);
  if (!file) return inform(state, say('notices.selectOne'), emit);
  emit({ type: 'export-map', name: mapFileName(picture.name, file), ...drawn(state), picture, file });
  return beginExport(state, emit);
}

const choose = (state: EditorState, choice: Partial<MapChoices>, emit: Emit): EditorState =>
  saveWork(withExport(state, { maps: { ...state.exporting.maps, ...choice } }), emit);

export const mapHandlers: Handlers<'map-choice-made'> = {
  'map-choice-made': (state, { choice }, emit) => choose(state, choice, emit),
};
