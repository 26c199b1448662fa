/** A person's work on one picture, as it is stored, parked and reopened. */
import type { Document } from '../document/document';
import type { HistoryRecord } from '../document/history';
import type { Drawings } from '../tools/machine';
import type { SourceFile } from './picture';
import type { ViewState } from './view_state';

export interface Work {
  readonly record: HistoryRecord<Document>;
  /** Unfinished bars, polygons and lassos. */
  readonly drawings?: Drawings;
  readonly view?: ViewState;
  /** Whether the picture is drawn as pixel art. Without it, the picture decides. */
  readonly pixelated?: boolean;
}

/** Everything needed to open a closed picture again. */
export interface WorkSnapshot extends Work {
  readonly file: SourceFile;
  readonly name: string;
  /** Whether the guard against folds was on. */
  readonly guarded: boolean;
}

/** Whether losing the work would lose a step or a drawing. */
export const isWorkedOn = ({ record, drawings = [] }: Work): boolean =>
  record.past.length + drawings.length > 0;
