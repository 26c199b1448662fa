/** The state of an editor before its first event. */
import { type Document, newProject, openDocument } from '../document/document';
import { historyOf } from '../document/history';
import { initialTools } from '../tools/machine';
import { DEFAULT_BRUSH } from './brush_state';
import { NO_CROSSING } from './crossing';
import { DEFAULT_ENGINE } from './engine_choices';
import { DEFAULT_CHOICES } from './export_choices';
import { DEFAULT_FILM } from './film_choices';
import { DEFAULT_MAPS } from './map_choices';
import type { OpeningState } from './opening_state';
import { FIRST_OVERLAYS } from './overlays';
import type { Media, PageAttributes } from './page';
import { NOT_PLAYED } from './playback_state';
import type { EditorState } from './state';
import { NO_STUDY } from './study_state';
import { CLOSED_TIMELINE } from './timeline_state';

const emptyDocument: Document = openDocument(newProject({ src: '', width: 1, height: 1 }, null));

export function initialState(page: PageAttributes, media: Media, opening: OpeningState): EditorState {
  const stage = { width: 1, height: 1 };
  return {
    page,
    media,
    picture: null,
    pixelated: false,
    document: {
      history: historyOf({ past: [], present: emptyDocument, future: [] }),
      drawn: null,
      travelled: null,
      refused: [],
      saved: emptyDocument.project,
      posedByPage: [],
      crossing: NO_CROSSING,
      automaticDepths: new Map(),
      touched: false,
      reported: { selection: [], undo: null, redo: null, title: null, tool: 'select' },
    },
    tools: initialTools,
    luminance: null,
    brush: DEFAULT_BRUSH,
    guard: { on: false, allowed: null, holding: false, asked: null, reached: null },
    opening,
    waiting: [],
    solution: {
      shown: null,
      recent: [],
      wanted: null,
      stage: null,
      failed: false,
      ready: false,
      fill: null,
      borders: null,
    },
    suggesting: null,
    stage,
    view: { camera: { scale: 1, x: 0, y: 0 }, stage, fitted: true, sheet: 'none' },
    widened: false,
    display: {
      overlays: FIRST_OVERLAYS,
      preview: null,
      settings: false,
      overlayList: false,
      renaming: null,
      numbers: false,
      popover: null,
      snapping: false,
      edgeSnapping: null,
      guides: [],
      box: null,
      zoomedCrease: -1,
      outlined: false,
      crosshair: null,
    },
    study: NO_STUDY,
    timeline: CLOSED_TIMELINE,
    playback: NOT_PLAYED,
    pointer: { coarse: media.coarse, hovered: null, alt: false, last: null, onHandle: false, space: false },
    focus: { on: 'nothing', handle: null, corner: null, ring: null },
    menu: null,
    notices: { offer: null, error: null, passing: null, graphics: null, announcement: null, tasks: [] },
    exporting: {
      kind: 'picture',
      choices: DEFAULT_CHOICES,
      film: DEFAULT_FILM,
      codecs: null,
      awaitsCodecs: false,
      code: null,
      posable: false,
      engine: DEFAULT_ENGINE,
      measured: null,
      maps: DEFAULT_MAPS,
      running: null,
    },
    autosave: {
      key: null,
      restoring: false,
      unread: false,
      step: '',
      unannounced: false,
      overwritten: false,
      storing: false,
      failing: false,
    },
    checks: {
      pending: false,
      creases: [],
      forcing: [],
      beyond: false,
      outside: '',
      outline: '',
      loose: false,
    },
  };
}
