/** The study card, and the settings that it shows. */

import { type Document, isSameWork } from '../../document/document';
import * as history from '../../document/history';
import { presetMode, type Setting, withPreset, withSetting } from '../../document/settings';
import { isSameWording, say, type Wording } from '../../texts/wording';
import { cancelPress } from '../../tools/machine';
import type { Emit } from '../effects';
import { savedWords } from '../notice_words';
import { mayEdit } from '../permissions';
import { stem } from '../picture';
import { documentOf, type EditorState, projectOf } from '../state';
import type { StudyPage } from '../study_state';
import { refitView } from '../view';
import { committed, withDocument, withHistory } from './document_slice';
import { edited } from './edited';
import { rebend } from './edits';
import type { Handlers } from './handlers';
import { beginLooking, withStudy } from './lens';
import { inform } from './notices';
import { applyTools } from './press';
import { commitStep } from './steps';
import { choose, takeTool } from './tool_choice';

/** Shows a page of the card, or closes it. The picture keeps clear of the card. */
export function showStudy(before: EditorState, page: StudyPage | null, emit: Emit): EditorState {
  if (page === before.study.page || (page && (!before.picture || before.page.posable))) return before;
  const overlayList = before.display.overlayList && !page;
  const display = { ...before.display, settings: false, outlined: false, overlayList };
  const state = refitView(withStudy({ ...before, display }, { page }));
  if (page === 'lens') return beginLooking(takeTool(state, 'lens', emit));
  if (state.tools.tool !== 'lens') return state;
  return choose(state, state.page.readonly ? 'hand' : 'select', emit);
}

const labelOf = ({ name }: Setting): Wording => say(`steps.settings.${name}`);

/** Whether a drag of this setting's slider is an open undo step. */
const isSliding = ({ document }: EditorState, setting: Setting): boolean => {
  const { open } = document.history;
  return open !== null && isSameWording(open.label, labelOf(setting));
};

const withNew = (state: EditorState, setting: Setting): Document => ({
  ...documentOf(state),
  project: withSetting(projectOf(state), setting),
});

/** Sets a setting, which ends a drag of its slider. Consecutive values are one undo step. */
function set(state: EditorState, setting: Setting, emit: Emit): EditorState {
  if (!isSliding(state, setting))
    return commitStep(state, labelOf(setting), withNew(state, setting), emit, `setting ${setting.name}`);
  const updated = history.update(state.document.history, withNew(state, setting));
  return edited(committed(withHistory(state, updated)), 'change', emit);
}

/** Sets a setting during a drag of its slider: the whole drag is one undo step. */
function slide(before: EditorState, setting: Setting, emit: Emit): EditorState {
  const state = isSliding(before, setting) ? before : beginSliding(before, labelOf(setting), emit);
  const updated = history.update(state.document.history, withNew(state, setting));
  return edited(withHistory(state, updated), 'input', emit);
}

function beginSliding(before: EditorState, label: Wording, emit: Emit): EditorState {
  const state = applyTools(before, cancelPress(before.tools), emit);
  const begun = history.begin(state.document.history, label, isSameWork);
  return withDocument(state, { history: begun, travelled: null, refused: [], posedByPage: [] });
}

export const studyHandlers: Handlers<
  | 'study-shown'
  | 'setting-set'
  | 'setting-slid'
  | 'preset-chosen'
  | 'figure-asked'
  | 'figure-saved'
  | 'variant-solved'
> = {
  'study-shown': (state, { page }, emit) => showStudy(state, page, emit),
  'variant-solved': (state, { variant, refusal }) =>
    withStudy(state, { refusals: { ...state.study.refusals, [variant]: refusal } }),
  'figure-asked': (state, { figure }, emit) => {
    const name = `${stem(state.picture?.name ?? 'picture')}-${figure}.svg`;
    emit({ type: 'save-figure', figure, name });
    return state;
  },
  'figure-saved': (state, { name }, emit) => inform(state, savedWords(name, false), emit),
  'setting-set': (state, { setting }, emit) => (mayEdit(state) ? set(state, setting, emit) : state),
  'setting-slid': (state, { setting }, emit) => (mayEdit(state) ? slide(state, setting, emit) : state),
  'preset-chosen': (state, { preset }, emit) => {
    if (!mayEdit(state)) return state;
    const label = say(`steps.presets.${presetMode(preset) === 'rigid' ? 'editor' : 'paper'}`);
    return rebend(state, label, (project) => withPreset(project, preset), emit);
  },
};
