/** The study card, and the settings that it shows. */
import { type Document, isSameWork } from '../../document/document';
import * as history from '../../document/history';
import { presetMode, type Setting, withPreset, withSetting } from '../../document/settings';
import { cancelPress } from '../../tools/machine';
import type { Emit } from '../effects';
import { mayEdit } from '../permissions';
import { SETTING_NAMES } from '../setting_texts';
import { documentOf, type EditorState, projectOf } from '../state';
import type { StudyPage, StudyState } from '../study_state';
import { refitView } from '../view';
import { withDocument, withHistory } from './document_slice';
import { edited } from './edited';
import type { Handlers } from './handlers';
import { applyTools } from './press';
import { commitStep, step } from './steps';

const withStudy = (state: EditorState, change: Partial<StudyState>): EditorState => ({
  ...state,
  study: { ...state.study, ...change },
});

/** Shows a page of the card, or closes it. The picture keeps clear of the card. */
export function showStudy(state: EditorState, page: StudyPage | null): EditorState {
  if (page === state.study.page || (page && (!state.picture || state.page.playing))) return state;
  const display = { ...state.display, settings: false, overlayList: state.display.overlayList && !page };
  return refitView(withStudy({ ...state, display }, { page }));
}

const labelOf = ({ name }: Setting): string => `Set ${SETTING_NAMES[name]}`;

/** Whether a drag of this setting's slider is an open undo step. */
const isSliding = ({ document }: EditorState, setting: Setting): boolean =>
  document.history.open?.label === labelOf(setting);

const withNew = (state: EditorState, setting: Setting): Document => ({
  ...documentOf(state),
  project: withSetting(projectOf(state), setting),
});

/** Sets a setting, which ends a drag of its slider. Consecutive values are one undo step. */
function set(state: EditorState, setting: Setting, emit: Emit): EditorState {
  if (!isSliding(state, setting))
    return commitStep(state, labelOf(setting), withNew(state, setting), emit, `setting ${setting.name}`);
  const updated = history.update(state.document.history, withNew(state, setting));
  return edited(withHistory(state, history.commit(updated, isSameWork)), 'change', emit);
}

/** Sets a setting during a drag of its slider: the whole drag is one undo step. */
function slide(before: EditorState, setting: Setting, emit: Emit): EditorState {
  const state = isSliding(before, setting) ? before : beginSliding(before, labelOf(setting), emit);
  const updated = history.update(state.document.history, withNew(state, setting));
  return edited(withHistory(state, updated), 'input', emit);
}

function beginSliding(before: EditorState, label: string, emit: Emit): EditorState {
  const state = applyTools(before, cancelPress(before.tools), emit);
  const begun = history.begin(state.document.history, label, isSameWork);
  return withDocument(state, { history: begun, travelled: null, refused: [], posedByPage: [] });
}

export const studyHandlers: Handlers<'study-shown' | 'setting-set' | 'setting-slid' | 'preset-chosen'> = {
  'study-shown': (state, { page }) => showStudy(state, page),
  'setting-set': (state, { setting }, emit) => (mayEdit(state) ? set(state, setting, emit) : state),
  'setting-slid': (state, { setting }, emit) => (mayEdit(state) ? slide(state, setting, emit) : state),
  'preset-chosen': (state, { preset }, emit) => {
    if (!mayEdit(state)) return state;
    const project = withPreset(projectOf(state), preset);
    const label = presetMode(preset) === 'rigid' ? 'Set all as in the editor' : 'Set all as in the paper';
    return step(state, label, { ...documentOf(state), project }, emit);
  },
};
