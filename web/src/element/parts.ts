/** The parts of a running editor, each made from those before it. */
import { actionsOf } from './actions';
import { Autosave } from './autosave';
import { Bordering } from './bordering';
import { CommandRunner } from './command_runner';
import { ContextMenu } from './context_menu';
import { Crosshair } from './crosshair';
import { Display } from './display';
import type { Emit } from './events';
import { type Aside, Files } from './files';
import { FirstHint, type PageHint } from './first_hint';
import { Focus } from './focus';
import { HitAreas } from './hit_areas';
import { LineCommands } from './line_commands';
import { NOT_KEPT, OVERWRITTEN } from './notice_texts';
import { Notices } from './notices';
import { type Attributes, Permissions } from './permissions';
import { PoseChecks } from './pose_checks';
import { Reaching } from './reaching';
import { StageKeys } from './stage_keys';
import { Viewing } from './viewing';
import { Workbench, type WorkbenchHost } from './workbench';

/** What the parts need of the element. */
export interface PartsHost extends Attributes {
  readonly root: ShadowRoot;
  readonly aside: Aside;
  readonly hint: PageHint | null;
  /** The model has changed: render again. */
  changed(): void;
  /** A picture is open, whether the page or a person opened it; `given`, with a project of its own. */
  opened(given: boolean): void;
  /** Opens again what the solver has failed at. */
  again(): void;
  readonly emit: Emit;
  switchTheme(): void;
  /** Copies the pose to the clipboard; pastes what is there. */
  copy(): void;
  paste(): void;
}

/** What concerns several parts. */
export interface Reactions extends Pick<WorkbenchHost, 'opened' | 'solved' | 'edited' | 'carryOut'> {
  /** Camera, cursor, crosshair or overlays changed. */
  looked(): void;
  /** The reach of the selected handles has changed. */
  reached(): void;
  /** A person's files have been taken, except those ignored. */
  received(ignored: readonly string[]): void;
  /** These handles, others than before, lie partly outside the picture. */
  outside(ids: readonly string[]): void;
}

export type Parts = ReturnType<typeof partsOf>;

export function partsOf(host: PartsHost, canvas: HTMLCanvasElement, reactions: Reactions) {
  const changed = () => host.changed();
  const looked = () => reactions.looked();
  const workbench: Workbench = new Workbench({
    get look() {
      return viewing.now;
    },
    opened: (picture, look) => reactions.opened(picture, look),
    solved: (solved, first) => reactions.solved(solved, first),
    edited: (kind) => reactions.edited(kind),
    carryOut: (effect) => reactions.carryOut(effect),
    say: (text) => notices.say(text),
    begin: (label, cancel) =>
      notices.begin(label, cancel && (() => (permissions.editable ? cancel() : changed()))),
    report: (error) => notices.report(error),
  });
  const permissions = new Permissions(host, workbench);
  const display = new Display({ workbench, permissions, canvas, changed, looked });
  const notices = new Notices({
    changed,
    emit: host.emit,
    get answerable() {
      return permissions.changing;
    },
    get playing() {
      return permissions.playing;
    },
    get again() {
      if (!workbench.isUnsolved) return null;
      const { solving, editing } = workbench;
      return () => (solving.current ? solving.want(editing.project) : host.again());
    },
  });
  const viewing: Viewing = new Viewing({
    bounds: () => workbench.posing.bounds(),
    get coarse() {
      return matchMedia('(pointer: coarse)').matches;
    },
    get sheet() {
      return display.settings || workbench.editing.document.selection.length > 0;
    },
    get bare() {
      if (!permissions.playing) return null;
      return permissions.readonly ? 'picture' : 'handles';
    },
  });
  const checks = new PoseChecks({
    get shown() {
      return !permissions.playing;
    },
    folds: () => workbench.posing.folds(),
    beyond: () => workbench.posing.beyond(),
    changed,
    outside: (ids) => reactions.outside(ids),
  });
  const reaching = new Reaching({ workbench, changed: () => reactions.reached() });
  const bordering = new Bordering({ workbench, changed });
  const files = new Files(workbench, host.aside, {
    changed,
    opened: (given) => {
      host.opened(given);
      // Now with the way back to what was open before.
      autosave.saveOpened();
    },
    notify: (notice) => notices.notify(notice),
    report: (error) => notices.report(error),
    begin: (label) => notices.begin(label),
    cuts: () => workbench.posing.beyond(),
    warped: (grow) => workbench.warped(1, grow, display.pixelated),
    received: (ignored) => reactions.received(ignored),
  });
  const autosave: Autosave = new Autosave(workbench, files, {
    lost: () => {
      if (!permissions.playing) notices.notify({ kind: 'error', text: NOT_KEPT });
    },
    overwritten: () => notices.notify({ kind: 'info', text: OVERWRITTEN }),
  });
  const hint = new FirstHint({
    workbench,
    viewing,
    permissions,
    get hint() {
      return host.hint;
    },
  });
  const areas = new HitAreas(workbench, viewing);
  const crosshair = new Crosshair(viewing);
  const focus = new Focus(host.root, changed);
  const shared = {
    workbench,
    permissions,
    display,
    notices,
    viewing,
    files,
    autosave,
    areas,
    crosshair,
    focus,
    changed,
    looked,
  };
  const lines = new LineCommands(shared);
  const commands = new CommandRunner({
    ...shared,
    lines,
    copy: () => host.copy(),
    paste: () => host.paste(),
    toggleKeys: () => host.root.querySelector<HTMLElement>('#keys')?.togglePopover(),
  });
  const menu = new ContextMenu({ ...shared, root: host.root, commands });
  const stageKeys = new StageKeys({ ...shared, lines, menu });
  const actions = actionsOf({ ...shared, lines, commands, menu, switchTheme: () => host.switchTheme() });
  return { ...shared, lines, stageKeys, commands, menu, actions, checks, reaching, bordering, hint };
}
