/** The model that the templates show, gathered from the parts that hold its state. */
import { isSmall } from '../io/pixel_art';
import type { EditorModel } from '../ui/model';
import type { Bordering } from './bordering';
import type { ContextMenu } from './context_menu';
import type { Crosshair } from './crosshair';
import type { Display } from './display';
import type { Files } from './files';
import type { FirstHint } from './first_hint';
import type { HitAreas } from './hit_areas';
import type { LineCommands } from './line_commands';
import type { Notices } from './notices';
import type { Permissions } from './permissions';
import type { PoseChecks } from './pose_checks';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

export interface ModelParts {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly files: Files;
  readonly notices: Notices;
  readonly permissions: Permissions;
  readonly display: Display;
  readonly checks: PoseChecks;
  readonly hint: FirstHint;
  readonly areas: HitAreas;
  readonly crosshair: Crosshair;
  readonly lines: LineCommands;
  readonly menu: ContextMenu;
  readonly bordering: Bordering;
}

/** The undo and redo label while something is being drawn. */
const SET_CORNER = 'Set a corner';

export function modelOf(
  parts: ModelParts,
  page: Pick<EditorModel, 'alt' | 'cursor' | 'dark' | 'platform'>,
): EditorModel {
  const {
    workbench,
    viewing,
    files,
    notices,
    permissions,
    display,
    checks,
    hint,
    areas,
    crosshair,
    lines,
    menu,
    bordering,
  } = parts;
  const { editing, solving, posing, guarding, picture } = workbench;
  const { machine } = editing;
  const { overlays } = display;
  const borders = overlays.cells ? bordering.borders() : null;
  return {
    document: editing.document,
    /** Only when asked: where no handles are shown nothing else may need the pose. */
    get turns() {
      return posing.turns();
    },
    picture,
    opening: files.opening,
    tool: machine.tool,
    readonly: permissions.readonly,
    disabled: permissions.disabled,
    playing: permissions.playing,
    alt: page.alt,
    dark: page.dark,
    camera: viewing.camera,
    stage: viewing.stage,
    grips: areas.grips,
    pressing: machine.busy,
    press: areas.press,
    undo: machine.draft ? SET_CORNER : editing.undoLabel,
    redo: machine.takenBack ? SET_CORNER : machine.draft ? null : editing.redoLabel,
    solved: solving.label,
    progress: notices.progress,
    notice: notices.notice,
    hint: hint.shown,
    announcement: notices.announcement,
    bare: display.bare,
    overlays,
    borders: borders && posing.posed(borders),
    sites: overlays.sites || overlays.graph ? posing.graph() : null,
    folded: overlays.folds ? posing.folded() : null,
    folds: overlays.folds || guarding.on ? posing.folds() : checks.folds,
    beyond: checks.beyond,
    guarded: guarding.on,
    pixelated: picture && isSmall(picture) ? workbench.pixelated : null,
    holding: guarding.holding,
    corner: lines.corner,
    settings: display.settings,
    numbers: display.numbers,
    menu: menu.shown,
    draft: machine.draft,
    waiting: machine.waiting,
    box: display.box,
    crosshair: crosshair.at,
    cursor: picture ? page.cursor : 'default',
    platform: page.platform,
  };
}
