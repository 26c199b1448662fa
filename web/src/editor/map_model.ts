/** The page of the export panel for maps and weights, as people see it. */
import { nameWords } from '../document/names';
import type { Size } from '../geometry/camera';
import type { Words } from '../texts/wording';
import { type MapChoices, mapFile, mapFileName } from './map_choices';
import { type EditorState, onlySelected } from './state';
import { exportSize } from './view';

export interface MapModel {
  readonly choices: MapChoices;
  /** The only selected handle. */
  readonly handle: Words | null;
  /** The name of the file; null if it needs a selected handle. */
  readonly file: string | null;
  /** Pixels, or points of a table. */
  readonly size: Size | null;
}

export function mapModel(state: EditorState): MapModel {
  const { picture, exporting } = state;
  const choices = exporting.maps;
  const handle = onlySelected(state);
  const file = mapFile(choices, handle?.id ?? null);
  return {
    choices,
    handle: handle && nameWords(handle),
    file: picture && file && mapFileName(picture.name, file),
    size: sizeOf(state, choices),
  };
}

function sizeOf(state: EditorState, { map, area, every }: MapChoices): Size | null {
  const { picture } = state;
  if (map === 'weights')
    return picture && { width: Math.ceil(picture.width / every), height: Math.ceil(picture.height / every) };
  const isAtRest = map === 'forward' || map === 'heat';
  return exportSize(state, { percent: 100, area: isAtRest ? 'picture' : area });
}
