/**
 * The whole state of an editor, as one immutable value.
 *
 * `update` turns a state and an event into the next state and effects; `viewModel` turns a state into the content of
 * the interface. The runtime holds what cannot be a value: workers, pixels, the WebGL context, listeners.
 */

import { type Document, fileProject, selectedHandles } from '../document/document';
import type { EngineLoss } from '../document/engine_rig';
import type { History } from '../document/history';
import type { NameFault } from '../document/names';
import type { Handle, Project } from '../document/project';
import type { Box } from '../geometry/box';
import type { Camera, Size } from '../geometry/camera';
import type { Crease } from '../geometry/crease';
import type { Guide } from '../geometry/guides';
import type { Luminance } from '../geometry/luminance';
import type { Vec } from '../geometry/vec';
import type { Wording } from '../texts/wording';
import type { ToolName, Tools } from '../tools/machine';
import type { Draft } from '../tools/state';
import type { AutosaveState } from './autosave_state';
import type { BrushState } from './brush_state';
import type { PreviewCommand } from './commands';
import type { Crossing } from './crossing';
import type { EngineChoices } from './engine_choices';
import type { EditorEvent } from './events';
import type { ExportChoices, ExportKind } from './export_choices';
import type { FilmChoices, VideoCodecs } from './film_choices';
import type { Focus } from './focus';
import type { FoldGuard } from './fold_guard';
import type { MapChoices } from './map_choices';
import type { MenuState } from './menu_state';
import type { NoticesState } from './notice';
import type { OpeningState } from './opening_state';
import { NO_OVERLAYS, type OverlayFlags } from './overlays';
import type { Media, PageAttributes } from './page';
import type { Picture } from './picture';
import type { PlaybackState } from './playback_state';
import type { Popover } from './popover';
import type { SolutionState } from './solution';
import type { StagePointer } from './stage_pointer';
import type { StudyState } from './study_state';
import type { TimelineState } from './timeline_state';
import type { ViewState } from './view_state';

export interface EditorState {
  readonly page: PageAttributes;
  readonly media: Media;
  /** The picture on the stage; null before the first one. */
  readonly picture: Picture | null;
  /** Whether the picture is drawn as pixel art. */
  readonly pixelated: boolean;
  /** How light a picture is, once the lasso needs it. */
  readonly luminance: { readonly of: Picture; readonly values: Luminance } | null;
  readonly document: DocumentState;
  readonly tools: Tools;
  readonly brush: BrushState;
  readonly guard: FoldGuard;
  readonly opening: OpeningState;
  /** A person's input for the picture that is being opened, in its order. */
  readonly waiting: readonly EditorEvent[];
  readonly solution: SolutionState;
  /** What handles are being suggested for. */
  readonly suggesting: { readonly project: Project; readonly picture: Picture | null } | null;
  /** CSS pixels. */
  readonly stage: Size;
  readonly view: ViewState;
  /** Whether the view has shrunk to show parts bent beyond the picture's rectangle. For a page that plays. */
  readonly widened: boolean;
  readonly display: DisplayState;
  readonly study: StudyState;
  readonly timeline: TimelineState;
  readonly playback: PlaybackState;
  readonly pointer: PointerState;
  readonly focus: Focus;
  readonly menu: MenuState | null;
  readonly notices: NoticesState;
  readonly exporting: ExportState;
  readonly autosave: AutosaveState;
  readonly checks: PoseChecks;
}

export interface DocumentState {
  readonly history: History<Document>;
  /** The last finished drawing and its handle. The drawing resumes if the solver refuses the handle. */
  readonly drawn: { readonly draft: Draft; readonly handle: Handle } | null;
  /** How the present was reached, if not by an edit. */
  readonly travelled: 'undo' | 'redo' | null;
  /** Handles that the solver has refused during the current press. */
  readonly refused: readonly Handle[];
  /** The project as a file holds it. */
  readonly saved: Project;
  /** Ids of handles that the page has posed during the current press. */
  readonly posedByPage: readonly string[];
  /** Whether the current drag brings its handles to the front. */
  readonly crossing: Crossing;
  /** The depths by id that crossings have decided. A person may have given a handle another one since. */
  readonly automaticDepths: ReadonlyMap<string, number>;
  /** Whether the document was ever changed: the page's hint ends then. */
  readonly touched: boolean;
  /** The last reports to the page: the selection, the history, the title and the tool. */
  readonly reported: Reported;
}

export interface Reported {
  readonly selection: readonly string[];
  readonly undo: Wording | null;
  readonly redo: Wording | null;
  readonly title: Title | null;
  readonly tool: ToolName;
}

/** The name of the open picture, and whether its project has changes that no file holds. */
export interface Title {
  readonly name: string;
  readonly unsaved: boolean;
}

/** The handle whose name is being typed, and why it cannot have the typed name. */
export interface Renaming {
  readonly id: string;
  readonly fault: NameFault | null;
}

export interface DisplayState {
  readonly overlays: OverlayFlags;
  /** The picture is shown without handles: the original, or the posed picture. */
  readonly preview: PreviewCommand | null;
  /** Open on a small screen: the settings of the whole picture; the numbers of the selected handles. */
  readonly settings: boolean;
  /** The list of overlays is open in the panel. */
  readonly overlayList: boolean;
  readonly renaming: Renaming | null;
  readonly numbers: boolean;
  /** The open panel of the toolbar. */
  readonly popover: Popover | null;
  /** Dragged and placed handles snap to guides. */
  readonly snapping: boolean;
  /** The lasso snaps to edges of the picture; null before a choice, when it does in opaque pictures. */
  readonly edgeSnapping: boolean | null;
  /** The guides through the moved item. */
  readonly guides: readonly Guide[];
  /** The selection box being drawn, image pixels. */
  readonly box: Box | null;
  /** Index of the crease that the view was last zoomed to; −1 before the first. */
  readonly zoomedCrease: number;
  /** The outline of the bending part is shown, while it is being set. */
  readonly outlined: boolean;
  /** Where the keyboard would place a handle, image pixels; null until an arrow key moves it. */
  readonly crosshair: Vec | null;
}

export interface ExportState {
  readonly kind: ExportKind;
  readonly choices: ExportChoices;
  readonly film: FilmChoices;
  /** The browser's codecs; null until it has been asked. */
  readonly codecs: VideoCodecs | null;
  /** A film begins once they are known. */
  readonly awaitsCodecs: boolean;
  /** Whether the browser took the code of a web page to the clipboard; null before the attempt. */
  readonly code: 'copied' | 'blocked' | null;
  /** Whether readers of a web page may pose the handles. */
  readonly posable: boolean;
  readonly engine: EngineChoices;
  /** The loss of the last rig for an engine, with its project and choices. */
  readonly measured: {
    readonly project: Project;
    readonly choices: EngineChoices;
    readonly loss: EngineLoss;
  } | null;
  readonly maps: MapChoices;
  /** The export under way, and whether it cuts off a part of the posed picture. */
  readonly running: { readonly cut: boolean } | null;
}

export interface PointerState {
  /** Whether the last press was one of a finger. */
  readonly coarse: boolean;
  /** The resting pointer's place, image pixels. */
  readonly hovered: Vec | null;
  /** Alt is held over the stage: the handle under the pointer shows its ring. */
  readonly alt: boolean;
  /** The last pointer position, and the camera at that moment. */
  readonly last: { readonly pointer: StagePointer; readonly camera: Camera } | null;
  /** Whether the last press was on a handle that was there before. */
  readonly onHandle: boolean;
  /** Space is held: presses pan. */
  readonly space: boolean;
}

/** Faults of the pose that a person may overlook, as of the last check. */
export interface PoseChecks {
  readonly pending: boolean;
  /** Where the pose visibly turns the picture over, from the largest. */
  readonly creases: readonly Crease[];
  /** Ids of the handles that force the creases, from the one that forces most. */
  readonly forcing: readonly string[];
  /** Part of the posed picture lies outside the picture's frame, which bounds the export. */
  readonly beyond: boolean;
  /** The parts of handles outside the domain, as a key. */
  readonly outside: string;
  /** How closely the outline follows the picture, as a key. */
  readonly outline: string;
  /** Parts of this picture without a handle have been mentioned. */
  readonly loose: boolean;
}

export const documentOf = ({ document }: EditorState): Document => document.history.present;
/** The project as its file holds it: without the poses of a clip. */
export const filedProject = (state: EditorState): Project => fileProject(documentOf(state));
export const projectOf = (state: EditorState): Project => documentOf(state).project;
export const isUnsaved = (state: EditorState): boolean =>
  state.picture !== null && filedProject(state) !== state.document.saved;
export const selectionOf = (state: EditorState): readonly string[] => documentOf(state).selection;
/** The selected handle; null unless exactly one is selected. */
export function onlySelected(state: EditorState): Handle | null {
  const [only = null, ...others] = selectedHandles(documentOf(state));
  return others.length === 0 ? only : null;
}
/** A picture that plays is seen as it will be exported: without the marks of the selection. */
export function overlaysOf({ page, display, timeline }: EditorState): OverlayFlags {
  if (page.posable) return NO_OVERLAYS;
  return timeline.playing ? { ...display.overlays, selection: false } : display.overlays;
}
