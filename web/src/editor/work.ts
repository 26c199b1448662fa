/** A person's work on one picture, as it is stored, kept among recent work and reopened. */
import type { Document } from '../document/document';
import type { HistoryRecord } from '../document/history';
import type { Project } from '../document/project';
import type { Draft } from '../tools/state';
import type { EngineChoices } from './engine_choices';
import type { ExportChoices, ExportKind } from './export_choices';
import type { FilmChoices } from './film_choices';
import type { MapChoices } from './map_choices';
import type { SourceFile } from './picture';
import type { ViewState } from './view_state';

export interface Work {
  readonly record: HistoryRecord<Document>;
  /** The unfinished bar, polygon or lasso. Works stored by earlier versions have up to one of each. */
  readonly drawings?: readonly Draft[];
  readonly view?: ViewState;
  /** Whether the picture is drawn as pixel art. Without it, the picture decides. */
  readonly pixelated?: boolean;
  /** The project as a file holds it. Without it, the oldest of the history. */
  readonly saved?: Project;
}

/** Everything needed to open a closed picture again. */
export interface WorkSnapshot extends Work {
  /** Tells apart works on pictures of the same name. */
  readonly id: string;
  readonly file: SourceFile;
  readonly name: string;
  /** The address of a small picture. */
  readonly thumbnail: string;
  /** Whether the guard against folds was on. */
  readonly guarded: boolean;
  /** Whether handles snap to guides. Without it, the switch does not change. */
  readonly snapping?: boolean;
  /** Whether the lasso snaps to edges. Without it, the picture decides. */
  readonly edgeSnapping?: boolean;
  /** Another tab stored this version of the open work, and the person has not chosen yet. */
  readonly fromOtherTab?: boolean;
  /** The choices for exports. Without them, those of the editor stay. */
  readonly exports?: ExportChoices;
  readonly films?: FilmChoices;
  readonly engines?: EngineChoices;
  readonly maps?: MapChoices;
  readonly exportKind?: ExportKind;
}

/** Whether losing the work would lose a step or a drawing. */
export const isWorkedOn = ({ record, drawings = [] }: Work): boolean =>
  record.past.length + drawings.length > 0;
