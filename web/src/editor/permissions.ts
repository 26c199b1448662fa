/** What people may do now, by the attributes `readonly`, `disabled` and `posable` and by whether a picture is open. */
import { hasFeature } from './features';
import type { EditorState } from './state';

/** Whether people may open and change something. */
export const mayChange = ({ page }: EditorState): boolean => !page.readonly && !page.disabled;

/** Whether people may change the open document. */
export const mayEdit = (state: EditorState): boolean => mayChange(state) && state.picture !== null;

/** Whether files are accepted by drop and paste. */
export const mayReceive = (state: EditorState): boolean =>
  mayChange(state) && !state.page.posable && hasFeature(state.page.features, 'open');

/** Whether handles are visible and editable. */
export const handlesAreShown = (state: EditorState): boolean =>
  mayEdit(state) && state.display.preview === null;

/** Whether a press moves the view with every tool but the lens, or even with that. */
export const pressesPan = (state: EditorState): boolean =>
  !state.page.posable && (state.pointer.space || (!handlesAreShown(state) && state.tools.tool !== 'lens'));
