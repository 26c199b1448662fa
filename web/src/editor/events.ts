/**
 * Everything that can happen to an editor, as values.
 *
 * A list of events replays a session without a browser. Names are in the past tense: an event says what happened, and
 * `update` decides what follows. Places are image pixels unless the name says otherwise.
 */

import type { Detail } from '../document/bending';
import type { KeyRef } from '../document/clip_keys';
import type { ClipPreset } from '../document/clip_presets';
import type { EngineLoss } from '../document/engine_rig';
import type { Lens } from '../document/generated/lens';
import type { Study } from '../document/generated/study';
import type { RingCorner } from '../document/lasso_corners';
import type { Ease, Handle, Loop, PoseMode, Project, ProjectFile } from '../document/project';
import type { Preset, Setting } from '../document/settings';
import type { Suggestion } from '../document/suggestion';
import type { Variant } from '../document/variants';
import type { Camera, Size } from '../geometry/camera';
import type { Luminance } from '../geometry/luminance';
import type { Blend } from '../geometry/skin';
import type { Vec } from '../geometry/vec';
import type { Wording, Words } from '../texts/wording';
import type { ToolName } from '../tools/machine';
import type { Draft } from '../tools/state';
import type { BrushState } from './brush_state';
import type { CommandName, PreviewCommand } from './commands';
import type { Corner } from './corner';
import type { CellBorders } from './deformation';
import type { EngineChoices } from './engine_choices';
import type { ExportChoices, ExportKind } from './export_choices';
import type { FilmChoices, VideoCodecs } from './film_choices';
import type { MapChoices } from './map_choices';
import type { MenuState } from './menu_state';
import type { OpenOutcome, OpenRequest, Restoring } from './opening_state';
import type { OverlayName } from './overlays';
import type { Media, PageAttributes, Sample } from './page';
import type { NamedFile, Picture, SourceFile } from './picture';
import type { Popover } from './popover';
import type { RigSource } from './rig_source';
import type { Solution, SolveStage } from './solution';
import type { StagePointer } from './stage_pointer';
import type { FigureName, StudyPage } from './study_state';
import type { TaskName } from './task';
import type { Rate } from './timeline_state';
import type { Timer } from './timer';
import type { WorkSnapshot } from './work';

/** A number of the selected handles that the panel can set. */
export type Field = 'x' | 'y' | 'rotation' | 'scale' | 'depth' | 'stiffness';

/** A new number, or a step from each current number within bounds. */
export type NumberChange =
  | { readonly to: number }
  | { readonly by: number; readonly least: number; readonly most: number };

type PageEvent =
  | { readonly type: 'page-changed'; readonly page: PageAttributes }
  | { readonly type: 'media-changed'; readonly media: Media }
  /** `typing`: a field has the focus, and an on-screen keyboard may have changed the height. */
  | { readonly type: 'stage-resized'; readonly size: Size; readonly typing: boolean }
  /** The page sets a tool: checked against the attributes, not against the person's permissions. */
  | { readonly type: 'tool-set'; readonly tool: ToolName }
  | { readonly type: 'handle-added'; readonly handle: Handle }
  | { readonly type: 'handle-changed'; readonly handle: Handle }
  | { readonly type: 'handle-removed'; readonly id: string }
  | { readonly type: 'handles-posed'; readonly handles: readonly Handle[] }
  | { readonly type: 'project-adopted'; readonly project: Project }
  | { readonly type: 'page-project-set'; readonly project: ProjectFile | null }
  | { readonly type: 'selection-set'; readonly ids: readonly string[] }
  /** Playing a clip, as on a media element. */
  | { readonly type: 'play-asked' | 'pause-asked' | 'autoplay-asked' }
  | { readonly type: 'seek-asked'; readonly time: number }
  | { readonly type: 'rate-asked'; readonly rate: number }
  /** CSS pixels per pixel of the picture. */
  | { readonly type: 'zoom-asked'; readonly scale: number }
  | { readonly type: 'undo-asked' | 'redo-asked' | 'reset-asked' | 'fit-asked' };

type PointerEvent =
  | { readonly type: 'press-began'; readonly pointer: StagePointer; readonly pans: boolean }
  | { readonly type: 'press-moved' | 'press-ended' | 'double-pressed'; readonly pointer: StagePointer }
  | { readonly type: 'press-cancelled' }
  | { readonly type: 'pointer-hovered'; readonly pointer: StagePointer | null }
  /** The kind of the pointer, before it is known whether it presses a handle. */
  | { readonly type: 'pointer-noted'; readonly coarse: boolean }
  /** A click that was left to the page. */
  | { readonly type: 'page-clicked' }
  | { readonly type: 'menu-asked'; readonly pointer: StagePointer; readonly resting: boolean }
  | { readonly type: 'camera-moved'; readonly camera: Camera };

type KeyEvent =
  | { readonly type: 'space-held' | 'alt-held'; readonly held: boolean }
  /** `by`: one step or, with Shift, ten. */
  | { readonly type: 'arrow-pressed'; readonly by: Vec }
  | { readonly type: 'turn-pressed'; readonly degrees: number; readonly scale: number }
  | { readonly type: 'place-pressed' | 'menu-key-pressed' };

type ControlEvent =
  /** `menu`: the context menu that the command was chosen from. */
  | { readonly type: 'command-run'; readonly command: CommandName; readonly menu?: MenuState | null }
  | { readonly type: 'menu-command-run'; readonly command: CommandName | null }
  | { readonly type: 'preview-held'; readonly command: PreviewCommand | null }
  | { readonly type: 'overlay-switched'; readonly overlay: OverlayName; readonly on: boolean }
  | { readonly type: 'field-set'; readonly field: Field; readonly change: NumberChange }
  /** A coordinate of the focused corner: 0 for x, 1 for y. */
  | { readonly type: 'corner-field-set'; readonly axis: 0 | 1; readonly change: NumberChange }
  | { readonly type: 'automatic-rotation-switched'; readonly on: boolean }
  | { readonly type: 'pose-mode-chosen'; readonly mode: PoseMode }
  | { readonly type: 'detail-chosen'; readonly detail: Detail }
  | { readonly type: 'blend-chosen'; readonly blend: Blend }
  | { readonly type: 'lasso-removed' }
  | { readonly type: 'brush-set'; readonly change: Partial<BrushState> }
  | { readonly type: 'stiffness-cleared' | 'displacement-cleared' }
  | { readonly type: 'boundary-switched'; readonly held: boolean }
  | { readonly type: 'edges-switched'; readonly on: boolean }
  | { readonly type: 'fill-switched'; readonly on: boolean }
  | { readonly type: 'feather-set'; readonly change: NumberChange }
  /** The control of the minimum opacity has the focus, or has lost it. */
  | { readonly type: 'outline-shown'; readonly on: boolean }
  | { readonly type: 'fold-guard-switched'; readonly on: boolean }
  | { readonly type: 'crease-zoomed' }
  | {
      readonly type: 'pixel-art-switched' | 'snapping-switched' | 'edge-snapping-switched';
      readonly on: boolean;
    }
  | { readonly type: 'drawing-finished' | 'corner-taken-back' | 'theme-switched' }
  | { readonly type: 'settings-opened'; readonly open: boolean }
  | { readonly type: 'numbers-opened'; readonly open: boolean }
  | { readonly type: 'popover-toggled'; readonly popover: Popover; readonly open: boolean }
  /** `keyed`: by a key. The focus goes to the open list or, once that has closed, to its button. */
  | { readonly type: 'overlays-opened'; readonly open: boolean; readonly keyed: boolean }
  | { readonly type: 'handles-selected'; readonly ids: readonly string[] }
  | { readonly type: 'handle-toggled'; readonly id: string }
  | { readonly type: 'handle-focus-asked' | 'rename-asked'; readonly id: string }
  /** While the name of a handle is typed. */
  | { readonly type: 'name-typed'; readonly name: string }
  /** `keyed`: by Enter. A refused name then stays to be corrected; otherwise the handle keeps the old one. */
  | { readonly type: 'name-given'; readonly name: string; readonly keyed: boolean }
  | { readonly type: 'renaming-ended' }
  | { readonly type: 'place-revealed'; readonly at: Vec }
  | { readonly type: 'number-refused'; readonly text: Wording };

type StudyEvent =
  /** Another page of the study card; null closes it. */
  | { readonly type: 'study-shown'; readonly page: StudyPage | null }
  /** `setting-slid`: during a drag of a slider, which `setting-set` ends. */
  | { readonly type: 'setting-set' | 'setting-slid'; readonly setting: Setting }
  | { readonly type: 'preset-chosen'; readonly preset: Preset }
  /** The lens follows the pointer again. */
  | { readonly type: 'lens-released' }
  /** A site whose falloff is to be shown. */
  | { readonly type: 'lens-site-chosen'; readonly site: number }
  /** A round of the replay, from 0. */
  | { readonly type: 'round-shown'; readonly round: number }
  | { readonly type: 'replay-switched'; readonly on: boolean }
  | { readonly type: 'variant-solved'; readonly variant: Variant; readonly refusal: Wording | null }
  | { readonly type: 'figure-asked'; readonly figure: FigureName }
  | { readonly type: 'figure-saved'; readonly name: string }
  /** A place of the posed picture, pointed at by other means than the pointer. */
  | { readonly type: 'lens-pointed'; readonly at: Vec };

/** Times are seconds from the beginning of the clip. */
type ClipEvent =
  | { readonly type: 'timeline-opened'; readonly open: boolean }
  /** Null adds a clip without keys. */
  | { readonly type: 'clip-added'; readonly preset: ClipPreset | null }
  | { readonly type: 'clip-chosen'; readonly name: string }
  | { readonly type: 'clip-renaming-switched'; readonly on: boolean }
  | { readonly type: 'clip-named'; readonly name: string }
  | { readonly type: 'clip-duplicated' | 'clip-removed' }
  | { readonly type: 'clip-loop-chosen'; readonly loop: Loop }
  | { readonly type: 'clip-duration-set'; readonly change: NumberChange }
  | { readonly type: 'frame-rate-chosen'; readonly rate: Rate }
  | { readonly type: 'timeline-zoomed'; readonly notches: number }
  | { readonly type: 'onion-switched'; readonly on: boolean }
  | { readonly type: 'playhead-moved'; readonly time: number }
  | { readonly type: 'playhead-stepped'; readonly frames: number }
  /** A frame of the screen has passed. */
  | { readonly type: 'clock-ticked'; readonly seconds: number }
  | { readonly type: 'record-held'; readonly held: boolean }
  | { readonly type: 'keys-selected'; readonly keys: readonly KeyRef[] }
  /** The selected keys, by seconds from where the drag began; `ended`: it has ended. */
  | { readonly type: 'keys-dragged'; readonly by: number; readonly ended: boolean }
  | { readonly type: 'keys-drag-cancelled' }
  | { readonly type: 'keys-stepped'; readonly frames: number }
  | { readonly type: 'keys-eased'; readonly ease: Ease }
  /** From the last of the selected keys to the one beside it. `extends`: the others stay selected. */
  | { readonly type: 'keys-walked'; readonly by: Vec; readonly extends: boolean };

/** Null if it cannot be read. */
type LuminanceEvent = {
  readonly type: 'luminance-read';
  readonly picture: Picture;
  readonly values: Luminance | null;
};

/** What a tool did with a press, when more than the document is concerned. */
type ToolEvent =
  /** A drawing that has ended without a result. */
  | { readonly type: 'drawing-continued'; readonly draft: Draft }
  | { readonly type: 'placement-missed'; readonly at: Vec }
  /** The selection is to include a place of the original. */
  | { readonly type: 'selection-extended'; readonly at: Vec }
  | { readonly type: 'lasso-drawn'; readonly ring: readonly Vec[]; readonly hole: boolean };

type FocusEvent =
  | { readonly type: 'stage-focused' | 'field-focused' | 'control-focused' | 'key-focused' | 'focus-lost' }
  | { readonly type: 'handle-focused'; readonly id: string }
  | { readonly type: 'corner-focused'; readonly corner: Corner }
  /** A corner of the selection's outline. */
  | { readonly type: 'ring-focused'; readonly corner: RingCorner };

type NoticeEvent =
  | { readonly type: 'notice-dismissed' }
  /** An action of the shown notice was chosen, the first one unless `other`. */
  | { readonly type: 'notice-answered'; readonly other?: boolean }
  /** A pointer or the focus is on the notice, or has left it. */
  | { readonly type: 'notice-hovered'; readonly on: boolean }
  | { readonly type: 'task-cancelled'; readonly task: TaskName }
  | { readonly type: 'person-informed'; readonly text: Words }
  | { readonly type: 'error-reported'; readonly error: Error }
  | { readonly type: 'timer-elapsed'; readonly timer: Timer };

type ClipboardEvent =
  /** The browser copied the selection. */
  { readonly type: 'selection-copied' } | { readonly type: 'text-pasted'; readonly text: string };

type FileEvent =
  | { readonly type: 'files-received'; readonly files: readonly NamedFile[] }
  /** A person gives an address of a picture or a project, by typing, pasting or dropping it. */
  | { readonly type: 'address-given'; readonly text: string }
  | { readonly type: 'sample-chosen'; readonly sample: Sample }
  /**
   * A link or another program brings something, which anybody can send: it opens at once only if no picture is open.
   * `names`: of the files.
   */
  | {
      readonly type: 'offered';
      readonly names: readonly string[];
      readonly opening: Extract<EditorEvent, { type: 'files-received' | 'sample-chosen' }>;
    }
  | {
      readonly type: 'load-asked';
      readonly reply: number;
      readonly source: string | NamedFile;
      readonly project: string | ProjectFile | null;
      /** A failure is shown to the user. */
      readonly notice: boolean;
    }
  /** The page no longer wants the picture of this request. */
  | { readonly type: 'load-cancelled'; readonly reply: number }
  /** The attributes `src` or `project` have changed; the new values follow with `page-changed`. */
  | { readonly type: 'source-changed' }
  /** Opens the picture that the attributes name. */
  | { readonly type: 'source-asked' }
  /** The element is connected. `work` is what it was disconnected with. */
  | { readonly type: 'started'; readonly work: WorkSnapshot | null }
  | { readonly type: 'request-ended'; readonly request: OpenRequest; readonly outcome: OpenOutcome }
  | { readonly type: 'restore-ended'; readonly restoring: Restoring; readonly outcome: OpenOutcome }
  /** A person's files are open, except the ignored ones. */
  | { readonly type: 'files-opened'; readonly ignored: readonly NamedFile[] }
  | {
      readonly type: 'read-ended';
      readonly id: number;
      readonly picture: Picture | null;
      /** The file that the picture was found in. */
      readonly source: SourceFile | null;
      readonly project: Project | null;
      /** The project in the picture, which is for another one, or why it cannot be read. */
      readonly carried: Project | Error | null;
    }
  | { readonly type: 'read-failed'; readonly id: number; readonly error: Error }
  /** The person uses a rig of another picture on the open one. */
  | { readonly type: 'rig-asked'; readonly rig: RigSource }
  /** `moved`: names of handles that were moved into the outline. */
  | {
      readonly type: 'rig-fitted';
      readonly rig: RigSource;
      readonly picture: Picture;
      readonly project: Project;
      readonly moved: readonly string[];
    }
  | { readonly type: 'back-asked'; readonly work: WorkSnapshot }
  /** The person keeps the open version of a work of two tabs. */
  | { readonly type: 'version-kept' }
  /** Recent work is removed from the list, by its id or all of it. */
  | { readonly type: 'recent-removed'; readonly id: string | null }
  /** Removed work returns to the list. */
  | { readonly type: 'recent-put-back'; readonly works: readonly WorkSnapshot[] }
  /** The project was saved to a file. */
  | { readonly type: 'project-saved'; readonly project: Project }
  | { readonly type: 'picture-asked' }
  | { readonly type: 'retry-asked' }
  | {
      readonly type: 'export-ended';
      /** The name of the saved file; null if it was cancelled or has failed. */
      readonly saved: string | null;
      readonly error: Error | null;
      /** Sentences on parts that the file lacks. */
      readonly remarks?: readonly Wording[];
    }
  /** `left`: seconds until it ends, if that is known. */
  | { readonly type: 'export-progressed'; readonly fraction: number; readonly left?: number }
  | { readonly type: 'export-choice-made'; readonly choice: Partial<ExportChoices> }
  | { readonly type: 'export-kind-chosen'; readonly kind: ExportKind }
  | { readonly type: 'film-choice-made'; readonly choice: Partial<FilmChoices> }
  /** The browser's codecs for films of the last asked size. */
  | { readonly type: 'codecs-found'; readonly codecs: VideoCodecs }
  | { readonly type: 'engine-choice-made'; readonly choice: Partial<EngineChoices> }
  /** A rig for an engine was made from these, with a loss. It is still to be saved. */
  | {
      readonly type: 'engine-rig-measured';
      readonly project: Project;
      readonly choices: EngineChoices;
      readonly loss: EngineLoss;
    }
  | { readonly type: 'map-choice-made'; readonly choice: Partial<MapChoices> }
  /** Whether readers of the exported rig may pose the handles. */
  | { readonly type: 'posable-chosen'; readonly posable: boolean }
  /** The code that shows the exported rig is requested. */
  | { readonly type: 'code-asked' }
  /** `copied`: whether the browser took it to the clipboard. */
  | { readonly type: 'code-copied'; readonly copied: boolean };

type StorageEvent =
  | { readonly type: 'autosave-key-set'; readonly key: string | null }
  | {
      readonly type: 'storage-read';
      readonly stored: { readonly work: WorkSnapshot; readonly recent: readonly WorkSnapshot[] } | null;
    }
  /** `stored`: `newer` if the storage holds work of a newer version. `newest`: no newer state waits to be stored. */
  | { readonly type: 'work-stored'; readonly stored: boolean | 'newer'; readonly newest: boolean }
  | { readonly type: 'other-tab-stored' };

type SolverEvent =
  | { readonly type: 'solver-started' }
  | { readonly type: 'solve-progressed'; readonly key: string; readonly stage: SolveStage }
  | { readonly type: 'solved'; readonly solution: Solution }
  /** `part`: from 0 to 1. */
  | { readonly type: 'fill-progressed'; readonly key: string; readonly part: number }
  | { readonly type: 'filled'; readonly key: string }
  | { readonly type: 'fill-failed'; readonly key: string; readonly error: Error }
  /** `failed`: the solver itself failed, so the project is not to blame. */
  | { readonly type: 'solve-refused'; readonly key: string; readonly error: Error; readonly failed: boolean }
  /** The project is the one that handles were suggested for. */
  | { readonly type: 'handles-suggested'; readonly project: Project; readonly suggestion: Suggestion }
  | { readonly type: 'suggestion-failed'; readonly project: Project; readonly error: Error }
  | { readonly type: 'borders-found'; readonly solution: Solution; readonly borders: CellBorders }
  /** Null if the solver could not answer. */
  | { readonly type: 'study-found'; readonly solution: Solution; readonly study: Study | null }
  | {
      readonly type: 'lens-found';
      readonly solution: Solution;
      readonly at: Vec;
      readonly lens: Lens | null;
    };

/** The next input that has waited for its picture is carried out. */
type WaitingEvent = { readonly type: 'input-released' };

/** The graphics context of the canvas: without one nothing can be drawn. */
type GraphicsEvent = { readonly type: 'graphics-lost' | 'graphics-restored' };

export type EditorEvent =
  | PageEvent
  | PointerEvent
  | KeyEvent
  | ControlEvent
  | StudyEvent
  | ClipEvent
  | ToolEvent
  | LuminanceEvent
  | FocusEvent
  | NoticeEvent
  | ClipboardEvent
  | FileEvent
  | StorageEvent
  | SolverEvent
  | GraphicsEvent
  | WaitingEvent;

export type Dispatch = (event: EditorEvent) => void;

/** The event of a type. Some events have several types. */
export type EventOf<T extends EditorEvent['type'], E = EditorEvent> = E extends { readonly type: infer Types }
  ? T extends Types
    ? E
    : never
  : never;
