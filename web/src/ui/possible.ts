/** Whether a command can be run now, for its button and for menus alike. */
import { handleById, selectedHandles } from '../document/document';
import { CORNERS_NEEDED, DEPTHS, depthOf, isAtRest, isLine } from '../document/handle';
import type { Handle } from '../document/project';
import type { CommandName } from './commands';
import type { EditorModel } from './model';

export function isPossible(name: CommandName, model: EditorModel): boolean {
  return CONDITIONS[name]?.(model) ?? true;
}

const opened = ({ picture }: EditorModel): boolean => picture !== null;
const changeable = ({ readonly }: EditorModel): boolean => !readonly;
const handled = ({ readonly, document }: EditorModel): boolean =>
  !readonly && document.project.handles.length > 0;

/** Whether any selected handle may be changed, and is such that the change makes a difference. */
const some =
  (differs: (handle: Handle) => boolean) =>
  ({ readonly, document }: EditorModel): boolean =>
    !readonly && selectedHandles(document).some(differs);

/** Whether the bar or polygon whose corners are meant, if any, can have them changed. */
const cornered =
  (differs: (count: number, needed: number) => boolean) =>
  ({ readonly, document, menu }: EditorModel): boolean => {
    const [only, ...others] = selectedHandles(document);
    const line = menu?.corner ? handleById(document, menu.corner.id) : others.length === 0 ? only : undefined;
    return (
      !readonly && line !== undefined && isLine(line) && differs(line.posed.length, CORNERS_NEEDED[line.kind])
    );
  };

/** Commands that are missing can always be run. */
const CONDITIONS: Partial<Readonly<Record<CommandName, (model: EditorModel) => boolean>>> = {
  select: changeable,
  point: changeable,
  bar: changeable,
  polygon: changeable,
  lasso: changeable,
  open: changeable,
  save: opened,
  export: opened,
  compare: opened,
  preview: opened,
  settings: opened,
  undo: (model) => opened(model) && changeable(model) && model.undo !== null,
  redo: (model) => opened(model) && changeable(model) && model.redo !== null,
  'reset-all': ({ readonly, document }) => !readonly && !document.project.handles.every(isAtRest),
  'select-all': handled,
  copy: handled,
  paste: handled,
  reset: some((handle) => !isAtRest(handle)),
  mirror: some(() => true),
  remove: some(() => true),
  forward: some((handle) => depthOf(handle) !== DEPTHS.most),
  backward: some((handle) => depthOf(handle) !== DEPTHS.least),
  'add-point': ({ menu }) => menu?.bends === true,
  'add-corner': cornered(() => true),
  'remove-corner': cornered((count, needed) => count > needed),
};
