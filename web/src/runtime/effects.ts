/** Carries out the effects of the editor: one line per effect names who does it. */
import type { EditorEffect, PageNotification } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { type PageQuestion, questionOf } from '../editor/page_question';
import type { EditorState } from '../editor/state';
import { prepareEncoder } from '../io/encoder';
import { focusExport, toggleExport } from '../ui/export/menu';
import { showSelected } from '../ui/handle_list';
import type { Clipboard } from './clipboard';
import type { Clock } from './clock';
import { exportEngineRig } from './engines';
import type { Exports } from './exports';
import type { Files } from './files';
import { exportFilm, findCodecs } from './films';
import type { Focus } from './focus';
import { exportMap } from './maps';
import type { MenuPopover } from './menu_popover';
import type { Pictures } from './pictures';
import { fitRig } from './rig_fitting';
import type { Solver } from './solver';
import type { Storage } from './storage';
import type { Study } from './study';
import type { Timers } from './timers';
import { copyCode, exportRig } from './web_pages';

/** The resources that carry out effects. */
export interface Resources {
  readonly root: ShadowRoot;
  readonly state: EditorState;
  readonly clipboard: Clipboard;
  readonly clock: Clock;
  readonly exports: Exports;
  readonly files: Files;
  readonly focus: Focus;
  readonly menu: MenuPopover;
  readonly pictures: Pictures;
  readonly solver: Solver;
  readonly storage: Storage;
  readonly study: Study;
  readonly timers: Timers;
  readonly dispatch: Dispatch;
  /** Whether the picture is shown as pixel art. */
  readonly pixelated: boolean;
  /** Resolves once the page shows the state. */
  rendered(): Promise<unknown>;
  notifyPage(notification: PageNotification): void;
  /** Whether the page lets the action continue. */
  ask(question: PageQuestion): boolean;
  settleLoad(reply: number, error: Error | 'superseded' | null): void;
  adoptPageProject(effect: Extract<EditorEffect, { type: 'adopt-page-project' }>): void;
  sourceFailed(error: Error | 'superseded'): void;
  setTheme(theme: 'light' | 'dark'): void;
  releaseInput(): void;
}

type EffectOf<T extends EditorEffect['type']> = Extract<EditorEffect, { readonly type: T }>;

type Carried = Exclude<EditorEffect['type'], 'follow-up'>;

const CARRY_OUT: { readonly [T in Carried]: (effect: EffectOf<T>, resources: Resources) => unknown } = {
  'notify-page': (effect, resources) => resources.notifyPage(effect.notification),
  'use-picture': (effect, { pictures, solver }) =>
    solver.usePicture(effect.picture && pictures.opened(effect.picture).pixels),
  'read-luminance': ({ picture }, { dispatch, pictures }) =>
    pictures
      .opened(picture)
      .luminance()
      .then((values) => dispatch({ type: 'luminance-read', picture, values })),
  solve: (effect, { solver }) => solver.solve(effect.key, effect.project),
  fill: (effect, { solver }) => solver.fill(effect.key, effect.project),
  'stop-filling': (_, { solver }) => solver.stopFilling(),
  'fit-rig': (effect, { dispatch, pictures, solver }) => fitRig(effect, pictures, solver, dispatch),
  'suggest-handles': (effect, { solver }) => solver.suggestHandles(effect.project),
  'stop-suggesting': (_, { solver }) => solver.stopSuggesting(),
  'find-borders': (effect, { solver }) => solver.findBorders(effect.solution),
  'find-study': (effect, { solver }) => solver.findStudy(effect.solution),
  'save-figure': (effect, { files, state, study }) =>
    files.saveFigure(effect.name, study.figureText(effect.figure, state)),
  'find-lens': (effect, { solver }) => solver.findLens(effect.solution, effect.at),
  read: (effect, { files, state }) => files.read(effect, state.page.credentials),
  'abandon-read': (effect, { files }) => files.abandon(effect.id),
  'settle-load': (effect, resources) => resources.settleLoad(effect.reply, effect.error),
  'adopt-page-project': (effect, resources) => resources.adoptPageProject(effect),
  'pick-file': (_, { files }) => files.pick(),
  'save-project': (effect, { files }) =>
    files.saveProject(effect.name, effect.project, effect.of, effect.picture),
  export: (effect, { exports, files, pixelated }) =>
    exports.run((following) => files.exportPicture(effect, pixelated, following)),
  'export-film': (effect, { exports, solver, pixelated }) =>
    exports.run((following) => exportFilm(effect, solver, pixelated, following)),
  'export-rig': (effect, { exports, pictures }) =>
    exports.run((following) => exportRig(effect, pictures, following)),
  'export-engine-rig': (effect, { exports, pictures, dispatch }) =>
    exports.run((following) => exportEngineRig(effect, pictures, following, dispatch)),
  'export-map': (effect, { exports, pictures, pixelated }) =>
    exports.run((following) => exportMap(effect, pictures, pixelated, following)),
  'cancel-export': (_, { exports }) => exports.cancel(),
  'find-codecs': (effect, { dispatch }) => findCodecs(effect, dispatch),
  'copy-code': (effect, { dispatch }) => copyCode(effect.code, dispatch),
  'prepare-export': (_, { solver }) => {
    prepareEncoder();
    solver.prepareDrawing();
  },
  copy: (effect, { clipboard }) => clipboard.copy(effect.text),
  paste: (_, { clipboard }) => clipboard.paste(),
  'use-storage': (effect, { storage }) => storage.use(effect.key),
  'read-storage': (_, { storage }) => storage.read(),
  store: (effect, { storage }) => storage.store(effect.work, effect.recent, effect.changed),
  'notify-tabs': (_, { storage }) => storage.notifyTabs(),
  focus: (effect, { focus }) => focus.move(effect.target),
  'focus-control': (effect, { focus }) => focus.moveToControl(effect.control),
  'leave-field': (_, { focus }) => focus.leaveField(),
  'scroll-list': (_, { root }) => requestAnimationFrame(() => showSelected(root)),
  'show-menu': (effect, { state, menu }) => menu.show(effect.at, state),
  'hide-menu': (_, { menu }) => menu.hide(),
  'toggle-keys': (_, { root }) => root.querySelector<HTMLElement>('#keys')?.togglePopover(),
  'toggle-export': (_, { root, rendered }) => {
    toggleExport(root);
    rendered().then(() => focusExport(root));
  },
  'source-failed': ({ error }, resources) => resources.sourceFailed(error),
  'set-theme': (effect, resources) => resources.setTheme(effect.theme),
  'release-input': (_, resources) => resources.releaseInput(),
  'run-clock': ({ on }, { clock }) => clock.run(on),
  'start-timer': (effect, { timers }) => timers.start(effect.timer, effect.ms),
  'stop-timer': (effect, { timers }) => timers.stop(effect.timer),
};

export function carryOut(effect: EditorEffect, resources: Resources): void {
  // `update` reduces follow-ups itself.
  if (effect.type === 'follow-up') return;
  const question = questionOf(effect);
  if (question && !resources.ask(question)) {
    if (question.type === 'beforeexport')
      resources.dispatch({ type: 'export-ended', saved: null, error: null });
    return;
  }
  // Each entry takes the effects of its own type, which the compiler cannot relate.
  const run = CARRY_OUT[effect.type] as (effect: EditorEffect, resources: Resources) => unknown;
  run(effect, resources);
}
