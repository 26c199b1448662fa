/** Everything that the templates show, derived from the state. */

import type { Document } from '../document/document';
import { handleById, selectedHandles } from '../document/document';
import { isSameDomain, ringsOf } from '../document/domain';
import { anchor, type HiddenCorners, isLine, type Turns } from '../document/handle';
import { redoLabel, undoLabel } from '../document/history';
import type { RingCorner } from '../document/lasso_corners';
import { atMoment } from '../document/moment';
import { nameWords } from '../document/names';
import type { Handle } from '../document/project';
import type { Box } from '../geometry/box';
import { type Camera, type Size, toStage } from '../geometry/camera';
import type { Crease } from '../geometry/crease';
import type { Guide } from '../geometry/guides';
import { distance, type Vec } from '../geometry/vec';
import type { Texts } from '../texts/texts';
import { say, type Wording, type Words, worded } from '../texts/wording';
import { type BrushKind, oppositeBrush } from '../tools/brush_kinds';
import { ringedHandle } from '../tools/hit';
import { draftOf, hasTakenCorners, isPressing, places, type ToolName } from '../tools/machine';
import type { Draft, Grips } from '../tools/state';
import { type BrushState, brushSizes, sizeOf } from './brush_state';
import { canRun, offers, reasonAgainst } from './can_run';
import type { CommandName, PreviewCommand } from './commands';
import { type Cursor, cursorOf } from './cursor';
import type { CreasedMesh, SiteGraph } from './deformation';
import { snapsToEdges } from './edge_snapping';
import { type EngineModel, engineModel } from './engine_model';
import { choicesFor, type ExportChoices, type ExportKind } from './export_choices';
import { type FilmModel, filmModel } from './film_model';
import { type HintPlace, hintPlace } from './hint_place';
import { brushOf, gripsOf, hiddenOf, hitAt, isBrushing, isLassoing, turnsOf } from './hit_areas';
import { type MapModel, mapModel } from './map_model';
import type { MenuState } from './menu_state';
import type { Notice, NoticesState } from './notice';
import { noticeIsAside } from './notice_place';
import { openClip } from './open_clip';
import { isOpening, readingName } from './opening_state';
import type { OverlayFlags } from './overlays';
import type { Sample } from './page';
import { handlesAreShown } from './permissions';
import { isDrawing, type Picture } from './picture';
import { ringCornerInHand } from './ring_corner';
import { snapped } from './snapping';
import type { SolveReport } from './solution';
import {
  documentOf,
  type EditorState,
  isUnsaved,
  overlaysOf,
  projectOf,
  type Renaming,
  selectionOf,
} from './state';
import type { StudyState } from './study_state';
import type { Task } from './task';
import { neighbouringTimes, type TimelineModel, timelineModel } from './timeline_model';
import { isKept } from './update/autosave';
import { currentTask, shownNotice } from './update/notices';
import { exportSize, freeStage, isInView } from './view';
import { awaitsPicture, toolToCome, waitingPlaces } from './waiting_input';
import { type WebPageModel, webPageModel } from './web_page_model';
import type { WorkSnapshot } from './work';

export interface EditorModel {
  /** All texts, in the language of the editor. */
  readonly texts: Texts;
  readonly document: Document;
  readonly turns: Turns;
  /** Depths by id that are automatic, as long as handles have them. */
  readonly automaticDepths: ReadonlyMap<string, number>;
  /** The corners of handles that lie behind another part of the picture. */
  readonly hidden: HiddenCorners;
  readonly picture: Picture | null;
  /** No file holds the last changes of the project. */
  readonly unsaved: boolean;
  /** Whether the browser holds the newest state; null where the page stores nothing. */
  readonly kept: boolean | null;
  /** The newest first. */
  readonly recent: readonly WorkSnapshot[];
  readonly samples: readonly Sample[];
  /** A picture is being opened. */
  readonly opening: boolean;
  /** The next picture is still to come, and input waits for it. */
  readonly awaiting: boolean;
  /** Where waiting presses began, CSS pixels of the stage. */
  readonly waitingPlaces: readonly Vec[];
  readonly tool: ToolName;
  readonly readonly: boolean;
  /** Shows only the picture and its handles, or only the picture where `readonly`. */
  readonly posable: boolean;
  readonly disabled: boolean;
  readonly camera: Camera;
  /** CSS pixels. */
  readonly stage: Size;
  readonly grips: Grips;
  /** A press on the stage is in progress. */
  readonly pressing: boolean;
  /** The verb for a short press: fingers tap. */
  readonly press: 'click' | 'tap';
  /** Labels of the next undo and redo steps, or null. */
  readonly undo: string | null;
  readonly redo: string | null;
  /** The shown solution in figures. */
  readonly solved: SolveReport | null;
  /** The running task, once it has taken long enough to be shown. */
  readonly task: ShownTask | null;
  readonly notice: ShownNotice | null;
  /** The notice is at the opposite edge, since it would cover a handle. */
  readonly noticeAside: boolean;
  readonly hint: Hint | null;
  readonly announcement: string;
  /** The picture is shown without handles: the original, or the posed picture. */
  readonly preview: PreviewCommand | null;
  readonly overlays: OverlayFlags;
  readonly sites: SiteGraph | null;
  /** Pieces × 2 ends × 2: the borders between cells, while they are shown and known. */
  readonly borders: Float32Array | null;
  /** Pieces × 2 ends × 2: the outline of the bending part, while it is being set. */
  readonly outline: Float32Array | null;
  /** The outline of the part that bends inside of a lasso, in the same form, while it is shown. */
  readonly selected: Float32Array | null;
  /** The triangles of the creases, while they are shown. */
  readonly creased: CreasedMesh | null;
  /** Where the picture is visibly turned over, from the largest. */
  readonly creases: readonly Crease[];
  /** Names of the handles that force the creases, from the one that forces most. */
  readonly forcing: readonly Words[];
  /** Part of the posed picture lies beyond the picture's frame, which bounds the export. */
  readonly beyond: boolean;
  /** The guard against folds is on, and whether it holds a drag back now. */
  readonly guarded: boolean;
  readonly holding: boolean;
  /** The selected handles where the guard does not let them go, as of its last stop. */
  readonly asked: readonly Handle[];
  /** Whether the picture is drawn as pixel art; null where it is too large for that. */
  readonly pixelated: boolean | null;
  /** The focused corner, of the only selected handle. */
  readonly corner: number | null;
  /** Open on a small screen: the settings of the whole picture; the numbers of the selected handles. */
  readonly settings: boolean;
  /** The menu of recent work is open. */
  readonly filesMenu: boolean;
  readonly numbers: boolean;
  readonly study: StudyState;
  /** Null while the timeline is closed. */
  readonly timeline: TimelineModel | null;
  /** Pieces × 2 ends × 2: the posed outlines at the keys beside the playhead, while they are shown. */
  readonly onion: readonly Float32Array[];
  /** The list of overlays is open. */
  readonly overlayList: boolean;
  /** The name of the only selected handle is being typed. */
  readonly renaming: Renaming | null;
  readonly menu: MenuState | null;
  /** The line being drawn with the current tool. */
  readonly draft: Draft | null;
  /** Null with another tool. */
  readonly brush: BrushModel | null;
  readonly box: Box | null;
  /** Where the keyboard would place a handle, image pixels. */
  readonly crosshair: Vec | null;
  /** Whether handles snap to guides, and the guides through the item that is moved or placed. */
  readonly snapping: boolean;
  readonly guides: readonly Guide[];
  /** Whether the lasso snaps to edges of the picture. */
  readonly edgeSnapping: boolean;
  /** Whether the edges of the picture are still to be found. */
  readonly edgesPending: boolean;
  /** The focused corner of the selection's outline. */
  readonly ringCorner: RingCorner | null;
  /** The ids of handles whose names are shown beside them: of the one selected, and of the one under the pointer. */
  readonly named: readonly string[];
  /** The id of the handle whose ring Alt shows. */
  readonly ringed: string | null;
  readonly cursor: Cursor;
  readonly platform: string;
  readonly alt: string | null;
  readonly dark: boolean;
  /** The layout goes from the right to the left. */
  readonly rtl: boolean;
  readonly exporting: ExportModel;
  /** The posed course of lines at rest, at places no farther apart than `step` at rest. */
  posedLines(lines: readonly (readonly Vec[])[], step: number): readonly (readonly Vec[])[];
  canRun(command: CommandName): boolean;
  /** Whether the page offers a command at all. */
  offers(command: CommandName): boolean;
  /** Why a command cannot run now; null if it can. */
  reasonAgainst(command: CommandName): string | null;
  /** Words in the language of the editor. */
  worded(words: Words): string;
}

/** A task in the language of the editor. */
export interface ShownTask extends Omit<Task, 'label' | 'left'> {
  readonly label: string;
  /** How long it will still take; empty if nobody knows. */
  readonly left: string;
}

/** A notice in the language of the editor. */
export interface ShownNotice extends Omit<Notice, 'text'> {
  readonly text: string;
}

export interface BrushModel {
  readonly settings: BrushState;
  /** Image pixels. */
  readonly radius: number;
  /** Where the next press would paint, image pixels; null where the pointer is elsewhere. */
  readonly at: Vec | null;
  /** What that press would do, and whether it would erase or take back. */
  readonly kind: BrushKind;
  readonly erasing: boolean;
  /** In percent: the size that counts, and its bounds. */
  readonly size: number;
  readonly sizes: { readonly least: number; readonly most: number };
  /** The keyboard holds the picture: arrows push it. */
  readonly holding: boolean;
}

export interface ExportModel {
  readonly kind: ExportKind;
  readonly choices: ExportChoices;
  /** Whether the picture is a drawing, so that it can be exported as SVG. */
  readonly isOfDrawing: boolean;
  readonly running: boolean;
  /**
   * Of the export, in pixels; for an area that follows the posed picture, about. Null without a picture, and while the
   * panel is closed.
   */
  readonly size: Size | null;
  /** Null while the panel shows another kind, or is closed. */
  readonly film: FilmModel | null;
  /** The same for a web page, for an engine, and for maps. */
  readonly page: WebPageModel | null;
  readonly engine: EngineModel | null;
  readonly maps: MapModel | null;
}

/** The page's hint, and the place of the picture that it points to. */
export interface Hint {
  readonly text: string;
  readonly at: Vec;
  readonly place: HintPlace;
}

export function viewModel(state: EditorState, texts: Texts): EditorModel {
  const { page, media, picture, tools, display, notices, guard, checks } = state;
  const { shown, borders } = state.solution;
  const { history } = state.document;
  const project = projectOf(state);
  const draft = draftOf(tools);
  const overlays = overlaysOf(state);
  const notice = shownNotice(state);
  const inWords = (words: Wording | null) => words && worded(texts, words);
  return {
    texts,
    document: documentOf(state),
    // Only when asked: without visible handles nothing else may need the pose.
    get turns() {
      return turnsOf(state);
    },
    get hidden() {
      return hiddenOf(state);
    },
    automaticDepths: state.document.automaticDepths,
    picture,
    unsaved: isUnsaved(state),
    kept: state.autosave.key === null ? null : isKept(state),
    recent: state.opening.recent.toReversed(),
    samples: page.samples,
    opening: isOpening(state.opening),
    awaiting: awaitsPicture(state),
    waitingPlaces: waitingPlaces(state),
    tool: toolToCome(state),
    readonly: page.readonly,
    disabled: page.disabled,
    posable: page.posable,
    camera: state.view.camera,
    stage: state.stage,
    grips: gripsOf(state),
    pressing: isPressing(tools),
    press: state.pointer.coarse ? 'tap' : 'click',
    undo: inWords(draft ? SET_CORNER : undoLabel(history)),
    redo: inWords(hasTakenCorners(tools) ? SET_CORNER : draft ? null : redoLabel(history)),
    solved: shown?.report ?? null,
    task: shownTask(currentTask(state) ?? openingTask(state), texts),
    notice: notice && { ...notice, text: worded(texts, notice.text) },
    get noticeAside() {
      return noticeIsAside(state);
    },
    hint: hintOf(state),
    announcement: announced(notices.announcement, texts),
    preview: display.preview,
    overlays,
    sites: shown && (overlays.sites || overlays.graph) ? shown.deformation.siteGraph(project) : null,
    borders:
      shown && (overlays.cells || state.study.page === 'cells') && borders?.of === shown && borders.pieces
        ? shown.deformation.posedBorders(project, borders.pieces)
        : null,
    outline: shown && display.outlined ? shown.deformation.outline(project) : null,
    get selected() {
      return selectedOutline(state);
    },
    creased: shown && overlays.creases ? shown.deformation.creasedMesh(project) : null,
    creases: overlays.creases || guard.on ? (shown?.deformation.creases(project) ?? []) : checks.creases,
    forcing: forcingNames(state),
    beyond: checks.beyond,
    guarded: guard.on,
    holding: guard.holding,
    asked: askedHandles(state),
    pixelated: picture?.isSmall ? state.pixelated : null,
    corner: cornerInHand(state),
    settings: display.settings,
    filesMenu: display.popover === 'files',
    numbers: display.numbers,
    study: state.study,
    timeline: timelineModel(state),
    get onion() {
      return onionOf(state);
    },
    overlayList: display.overlayList,
    renaming: page.readonly ? null : display.renaming,
    menu: state.menu,
    draft,
    brush: brushModel(state),
    box: display.box,
    crosshair: display.crosshair,
    snapping: display.snapping,
    edgeSnapping: snapsToEdges(state),
    edgesPending: state.luminance?.of !== picture,
    ringCorner: ringCornerInHand(state),
    get guides() {
      return guidesShown(state);
    },
    get named() {
      return namedOf(state);
    },
    get ringed() {
      return ringedOf(state);
    },
    get cursor() {
      return cursorOf(state);
    },
    platform: media.platform,
    alt: page.alt,
    dark: media.dark,
    rtl: media.rtl,
    get exporting() {
      const { kind, running } = state.exporting;
      const isOfDrawing = state.picture !== null && isDrawing(state.picture);
      const choices = choicesFor(state.exporting.choices, isOfDrawing);
      const open = display.popover === 'export';
      // The bounds of the posed picture take a pass over its mesh.
      const size = open && kind === 'picture' ? exportSize(state, choices) : null;
      const film = open && kind === 'film' ? filmModel(state) : null;
      const page = open && kind === 'page' ? webPageModel(state) : null;
      const engine = open && kind === 'engine' ? engineModel(state) : null;
      const maps = open && kind === 'maps' ? mapModel(state) : null;
      return { kind, choices, isOfDrawing, running: running !== null, size, film, page, engine, maps };
    },
    posedLines: (lines, step) => shown?.deformation.posedLines(project, lines, step) ?? lines,
    canRun: (command) => canRun(state, command),
    offers: (command) => offers(state, command),
    reasonAgainst: (command) => inWords(reasonAgainst(state, command)),
    worded: (words) => worded(texts, words),
  };
}

/** The undo and redo label during a drawing. */
const SET_CORNER = say('steps.setCorner');

const shownTask = (task: Task | null, texts: Texts): ShownTask | null =>
  task && { ...task, label: worded(texts, task.label), left: task.left ? worded(texts, task.left) : '' };

/** Screen readers read only changes: repeated words get a trailing space that is not read. */
const announced = (said: NoticesState['announcement'], texts: Texts): string =>
  said ? `${worded(texts, said.words)}${said.again ? '\u00a0' : ''}` : '';

/** Null without a lasso, and before its solution: the shown one would have another outline. */
function selectedOutline(state: EditorState): Float32Array | null {
  const project = projectOf(state);
  const { shown } = state.solution;
  const isShown = overlaysOf(state).selection && state.display.preview === null;
  if (!shown || !isShown || ringsOf(project).length === 0) return null;
  return isSameDomain(shown.project, project) ? shown.deformation.outline(project) : null;
}

function forcingNames(state: EditorState): readonly Words[] {
  const { forcing } = state.checks;
  return forcing.length === 0 ? NO_IDS : forcing.map((id) => nameWords({ id }));
}

function brushModel(state: EditorState): BrushModel | null {
  if (toolToCome(state) !== 'brush') return null;
  const { brush, pointer, display } = state;
  const { radius } = brushOf(state);
  const { kind, erases } = pointer.alt ? oppositeBrush(brush) : brush;
  const at = display.crosshair ?? (pointer.coarse ? null : pointer.hovered);
  return {
    settings: brush,
    radius,
    at,
    kind,
    erasing: kind === 'stiffen' ? erases : kind === 'restore',
    size: sizeOf(brush),
    sizes: brushSizes(brush),
    holding: display.crosshair !== null && isPressing(state.tools),
  };
}

/** The outlines at the neighbouring keys. Not while something plays: there they would flicker. */
function onionOf(state: EditorState): readonly Float32Array[] {
  const { onion, playing, recording, clip } = state.timeline;
  const deformation = state.solution.shown?.deformation;
  if (!onion || playing || recording || clip === null || !deformation || !openClip(state)) return NO_OUTLINES;
  return neighbouringTimes(state).map((time) =>
    deformation.outline(atMoment(documentOf(state), clip, time, deformation.posesAt).project),
  );
}

const NO_OUTLINES: readonly Float32Array[] = [];

/** The guides of the press under way or, before one with a tool that places, those of the pointer. */
function guidesShown(state: EditorState): readonly Guide[] {
  const { tools, pointer, display } = state;
  const tool = tools.tool;
  const aims =
    places(tool) && tool !== 'lasso' && tool !== 'brush' && pointer.hovered && !pointer.last?.pointer.free;
  if (isPressing(tools) || !aims || !pointer.hovered || !handlesAreShown(state)) return display.guides;
  return hitAt(state, pointer.hovered, false) ? [] : snapped(state, pointer.hovered, []).guides;
}

/** Names help to find a handle. During a press or a drawing they would cover the picture. */
function namedOf(state: EditorState): readonly string[] {
  const { tools, pointer, page } = state;
  if (page.posable || !handlesAreShown(state) || isPressing(tools) || draftOf(tools)) return NO_IDS;
  const under = pointer.hovered && hitAt(state, pointer.hovered, false);
  const hovered = under && under.part !== 'ring' && under.part !== 'grip' ? [under.id] : NO_IDS;
  const selection = selectionOf(state);
  return selection.length === 1 ? [...selection, ...hovered] : hovered;
}

const NO_IDS: readonly string[] = [];

/** With Alt held, the handle under the pointer. Not during a press or a drawing, which need no other marks. */
function ringedOf(state: EditorState): string | null {
  const { alt, hovered } = state.pointer;
  const { tools } = state;
  if (!alt || !hovered || !handlesAreShown(state) || isPressing(tools) || draftOf(tools)) return null;
  if (isLassoing(state) || isBrushing(state)) return null;
  return ringedHandle({ document: documentOf(state), grips: gripsOf(state) }, hovered)?.id ?? null;
}

/** The index of the focused corner, if only its bar or polygon is selected. */
function cornerInHand(state: EditorState): number | null {
  const { corner } = state.focus;
  const [only, ...others] = selectedHandles(documentOf(state));
  if (!only || !corner || corner.id !== only.id || others.length > 0 || !isLine(only)) return null;
  return corner.index < only.posed.length ? corner.index : null;
}

/** The handles of the selection that the guard stopped, where they were asked to go. */
function askedHandles(state: EditorState): readonly Handle[] {
  const { asked } = state.guard;
  if (!asked) return NONE;
  const { selection, project } = documentOf(state);
  const present = new Map(project.handles.map((handle) => [handle.id, handle]));
  return asked.handles.filter(
    (handle) => selection.includes(handle.id) && !isSamePlace(handle, present.get(handle.id)),
  );
}

const NONE: readonly Handle[] = [];

const isSamePlace = (a: Handle, b: Handle | undefined): boolean =>
  b !== undefined && distance(anchor(a), anchor(b)) < 0.5;

/** A picture that is being read while another is open. */
function openingTask({ picture, opening }: EditorState): Task | null {
  const name = picture && readingName(opening);
  return name ? { name: 'open', label: say('tasks.opening', name), cancellable: !opening.restoring } : null;
}

/** The page's hint, until the first change. */
function hintOf(state: EditorState): Hint | null {
  const { hint, readonly } = state.page;
  const document = documentOf(state);
  const handle = handleById(document, hint?.handle ?? '') ?? document.project.handles[0];
  if (!hint || !handle || readonly || state.document.touched) return null;
  if (!state.solution.shown || draftOf(state.tools)) return null;
  const at = anchor(handle);
  if (!isInView(state, at)) return null;
  const { camera } = state.view;
  const middle = toStage(camera, [document.project.image.width / 2, document.project.image.height / 2]);
  const place = hintPlace(hint.text, toStage(camera, at), freeStage(state), middle);
  return place && { text: hint.text, at, place };
}
