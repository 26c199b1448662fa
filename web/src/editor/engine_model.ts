/** The page of the export panel for game engines, as people see it. */

import { clipsOf } from '../document/clips';
import type { EngineLoss } from '../document/engine_rig';
import { say, type Wording } from '../texts/wording';
import {
  bonesOf,
  ENGINE_FORMATS,
  type EngineChoices,
  engineFile,
  INFLUENCES,
  influencesOf,
  leastBones,
} from './engine_choices';
import { type EngineLossRow, lossRows } from './engine_words';
import { type EditorState, filedProject } from './state';

export interface EngineModel {
  readonly choices: EngineChoices;
  /** As the project takes them. */
  readonly bones: { readonly now: number; readonly least: number };
  /** As the format takes them. */
  readonly influences: { readonly now: number; readonly most: number };
  /** Clips that become animations. */
  readonly clips: number;
  /** Whether the files can go into a folder: the format has several, and the browser can pick one. */
  readonly folders: boolean;
  readonly folder: boolean;
  /** The name of the only file; null for a folder. */
  readonly file: string | null;
  /** The loss of the last rig, while project and choices are the same. */
  readonly loss: { readonly caption: Wording; readonly rows: readonly EngineLossRow[] } | null;
}

const captionOf = ({ bones, sites, vertices }: EngineLoss): Wording =>
  say('engine.lossCaption', bones, sites, vertices);

export function engineModel(state: EditorState): EngineModel {
  const { engine: choices, measured } = state.exporting;
  const project = filedProject(state);
  const folders = state.media.folders && ENGINE_FORMATS[choices.format].extension === null;
  const clips = clipsOf(project).map(({ name }) => name);
  const folder = folders && choices.into === 'folder';
  const isCurrent = measured?.project === project && measured.choices === choices;
  return {
    choices,
    bones: { now: bonesOf(choices, project), least: leastBones(project) },
    influences: {
      now: influencesOf(choices),
      most: choices.format === 'godot' ? INFLUENCES.mostOfGodot : INFLUENCES.most,
    },
    clips: clips.length,
    folders,
    folder,
    file: folder ? null : engineFile(state.picture?.name ?? '', choices.format),
    loss: isCurrent ? { caption: captionOf(measured.loss), rows: lossRows(measured.loss, clips) } : null,
  };
}
