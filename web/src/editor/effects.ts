/** What the runtime does for the editor: everything that takes time or touches the page. */

import type { KeyRef } from '../document/clip_keys';
import type { RingCorner } from '../document/lasso_corners';
import type { MapFile } from '../document/map_file';
import type { Clip, Project, ProjectFile } from '../document/project';
import type { Vec } from '../geometry/vec';
import type { Wording } from '../texts/wording';
import type { ToolName } from '../tools/machine';
import type { EngineChoices } from './engine_choices';
import type { EditorEvent } from './events';
import type { ExportChoices } from './export_choices';
import type { FilmArea, FilmFormat, Range } from './film_choices';
import type { NamedFile, Picture } from './picture';
import type { RigSource } from './rig_source';
import type { Solution } from './solution';
import type { Title } from './state';
import type { FigureName } from './study_state';
import type { Timer } from './timer';
import type { WorkSnapshot } from './work';

/** An element to focus: a handle, one of its corners, a corner of the selection's outline, a key, or the stage. */
export interface FocusTarget {
  readonly handle: string | null;
  readonly corner: number | null;
  /** A corner of the selection's outline. */
  readonly ring?: RingCorner;
  /** A key of the timeline. */
  readonly key?: KeyRef;
}

/** Controls that the editor focuses automatically. */
export type ControlName = 'name' | 'clip-name' | 'timeline' | 'overlays' | 'overlay-button' | 'code';

/** Who had a picture opened: the page, a person, or the editor itself, which brings earlier work back. */
export type Origin = 'page' | 'person' | 'restored';

/** The DOM events of the element. */
export type PageNotification =
  | { readonly type: 'ready' | 'play' | 'pause' | 'timeupdate' | 'ended' }
  | { readonly type: 'load'; readonly origin: Origin }
  | { readonly type: 'toolchange'; readonly tool: ToolName }
  | { readonly type: 'input' | 'change'; readonly project: Project }
  | { readonly type: 'selectionchange'; readonly selection: readonly string[] }
  | { readonly type: 'historychange'; readonly undo: Wording | null; readonly redo: Wording | null }
  | { readonly type: 'titlechange'; readonly title: Title | null }
  | { readonly type: 'progress'; readonly label: Wording | null; readonly fraction: number | null }
  | { readonly type: 'error'; readonly error: Error };

/** A project: an address, an object of the page, or a file. */
export type ProjectSource =
  | { readonly address: string }
  | { readonly object: ProjectFile }
  | { readonly named: NamedFile };

/** The project that a PNG carries, and the picture that the project holds, or null. */
export interface CarriedProject {
  readonly project: Project;
  readonly picture: NamedFile | null;
}

/** A time of a clip. */
export interface ClipMoment {
  readonly clip: Clip;
  /** Seconds. */
  readonly time: number;
}

/** A film as it was chosen. */
export interface FilmOrder {
  readonly format: FilmFormat;
  /** Bits of a video for each of its pixels. */
  readonly bits: number;
  readonly scale: number;
  readonly area: FilmArea;
  /** Frames a second. */
  readonly rate: number;
  /** Null for the whole clip. */
  readonly range: Range | null;
  /** As `#rrggbb`; null for a transparent film. */
  readonly background: string | null;
  readonly matte: string;
  /** Names files in a zip. */
  readonly name: string;
}

export type EditorEffect =
  /** Another event that follows at once. `update` reduces it; the runtime never sees it. */
  | { readonly type: 'follow-up'; readonly event: EditorEvent }
  | { readonly type: 'notify-page'; readonly notification: PageNotification }
  /** Sets the solver's picture; null if no picture is open. */
  | { readonly type: 'use-picture'; readonly picture: Picture | null }
  /** Answered by `luminance-read`. */
  | { readonly type: 'read-luminance'; readonly picture: Picture }
  | { readonly type: 'solve'; readonly key: string; readonly project: Project }
  /** Fits a rig to the open picture. Answered by `rig-fitted` or `error-reported`. */
  | { readonly type: 'fit-rig'; readonly rig: RigSource; readonly picture: Picture }
  /** Answered by `handles-suggested` or `suggestion-failed`, unless `stop-suggesting` or a newer one ends it. */
  | { readonly type: 'suggest-handles'; readonly project: Project }
  | { readonly type: 'stop-suggesting' }
  /** Fills the picture behind the rings of a solution. */
  | { readonly type: 'fill'; readonly key: string; readonly project: Project }
  | { readonly type: 'stop-filling' }
  | { readonly type: 'find-borders'; readonly solution: Solution }
  | { readonly type: 'find-study'; readonly solution: Solution }
  /** Saves a figure of the study card as SVG. */
  | { readonly type: 'save-figure'; readonly figure: FigureName; readonly name: string }
  | { readonly type: 'find-lens'; readonly solution: Solution; readonly at: Vec }
  /** Reads a picture, a project file, or both. Answered by `read-ended` or `read-failed`. */
  | {
      readonly type: 'read';
      readonly id: number;
      /** An address, which includes the name, or files: the first picture is read. Empty for no picture. */
      readonly pictures: readonly (string | NamedFile)[];
      readonly project: ProjectSource | null;
      /** Whether a project in the picture is read too. */
      readonly inside: boolean;
    }
  | { readonly type: 'abandon-read'; readonly id: number }
  /** The picture of the attributes cannot be opened, or a person has opened another one first. */
  | { readonly type: 'source-failed'; readonly error: Error | 'superseded' }
  /** Settles the promise of a `load()`; `error` null resolves it, 'superseded' rejects it with an AbortError. */
  | { readonly type: 'settle-load'; readonly reply: number; readonly error: Error | 'superseded' | null }
  /** Checks a project of the page and adopts it, then selects handles. */
  | {
      readonly type: 'adopt-page-project';
      readonly project: ProjectFile;
      readonly selection: readonly string[] | null;
    }
  | { readonly type: 'pick-file' }
  /** Answered by `project-saved` with the project of the document, unless the person cancels. */
  | {
      readonly type: 'save-project';
      readonly name: string;
      readonly project: Project;
      readonly of: Project;
      /** The picture that the file holds too. */
      readonly picture: NamedFile | null;
    }
  | {
      readonly type: 'export';
      readonly name: string;
      readonly picture: Picture;
      readonly project: Project;
      /** The time of a clip that poses the handles. */
      readonly moment: ClipMoment | null;
      readonly choices: ExportChoices;
      /** The project that a PNG carries. */
      readonly carried: CarriedProject;
    }
  /** Answered by `export-ended`. */
  | {
      readonly type: 'export-film';
      readonly name: string;
      readonly project: Project;
      readonly clip: Clip;
      readonly film: FilmOrder;
    }
  /** Answered by `export-ended`. */
  | {
      readonly type: 'export-rig';
      readonly name: string;
      /** Whether readers may pose the handles in any mode. */
      readonly posable: boolean;
      readonly project: Project;
      readonly picture: Picture;
    }
  /** Answered by `engine-rig-measured` and `export-ended`. */
  | {
      readonly type: 'export-engine-rig';
      /** Of the only file. */
      readonly name: string;
      readonly project: Project;
      readonly choices: EngineChoices;
      readonly picture: Picture;
      readonly order: Omit<EngineChoices, 'into'> & { readonly stem: string };
      /** Several files go into a zip or a folder. */
      readonly target: 'file' | 'zip' | 'folder';
    }
  /** Answered by `export-ended`. */
  | {
      readonly type: 'export-map';
      readonly name: string;
      readonly project: Project;
      /** The time of a clip that poses the handles. */
      readonly moment: ClipMoment | null;
      readonly picture: Picture;
      readonly file: MapFile;
    }
  /** Answered by `code-copied`. */
  | { readonly type: 'copy-code'; readonly code: string }
  /** Answered by `codecs-found`. */
  | {
      readonly type: 'find-codecs';
      readonly width: number;
      readonly height: number;
      readonly rate: number;
    }
  /** Answered by `export-ended`, unless the export has ended already. */
  | { readonly type: 'cancel-export' }
  /** Loads the encoder and the part of the solver that draws, while the person looks at the picture. */
  | { readonly type: 'prepare-export' }
  | { readonly type: 'copy'; readonly text: string }
  | { readonly type: 'paste' }
  | { readonly type: 'use-storage'; readonly key: string | null }
  | { readonly type: 'read-storage' }
  | {
      readonly type: 'store';
      /** Null leaves the stored work. */
      readonly work: WorkSnapshot | null;
      readonly recent: readonly WorkSnapshot[];
      /** Whether the work has changed by more than a selection. Otherwise another tab's newer work stays. */
      readonly changed: boolean;
    }
  | { readonly type: 'notify-tabs' }
  | { readonly type: 'focus'; readonly target: FocusTarget }
  /** Focuses a control by its `data-control`, once it is rendered. Selects the text of a field. */
  | { readonly type: 'focus-control'; readonly control: ControlName }
  /** Commits a number that is being typed. */
  | { readonly type: 'leave-field' }
  | { readonly type: 'scroll-list' }
  | { readonly type: 'show-menu'; readonly at: Vec }
  | { readonly type: 'hide-menu' }
  | { readonly type: 'toggle-keys' | 'toggle-export' }
  | { readonly type: 'set-theme'; readonly theme: 'light' | 'dark' }
  /** Answered by `input-released`, once the page shows the state. */
  | { readonly type: 'release-input' }
  /** Frames of the screen pass, each reported by `clock-ticked`; or no more. */
  | { readonly type: 'run-clock'; readonly on: boolean }
  | { readonly type: 'start-timer'; readonly timer: Timer; readonly ms: number }
  | { readonly type: 'stop-timer'; readonly timer: Timer };

export type Emit = (effect: EditorEffect) => void;
