/** For tests: the messages to people, in English. */
import { en } from '../texts/en';
import { type Words, worded } from '../texts/wording';
import type { EditorState } from './state';
import { currentTask, shownNotice } from './update/notices';

export const inEnglish = <W extends Words | null>(words: W): W extends null ? string | null : string =>
  (words === null ? null : worded(en, words)) as W extends null ? string | null : string;

const answered = <A extends { readonly label: Words }>(action: A | undefined) =>
  action && { ...action, label: inEnglish(action.label) };

/** The notice on screen. */
export function englishNotice(state: EditorState) {
  const notice = shownNotice(state);
  if (!notice) return null;
  const { action, other, ...rest } = notice;
  return {
    ...rest,
    text: inEnglish(notice.text),
    ...(action && { action: answered(action) }),
    ...(other && { other: answered(other) }),
  };
}

/** The task under way. */
export function englishTask(state: EditorState) {
  const task = currentTask(state);
  if (!task) return null;
  return { ...task, label: inEnglish(task.label), ...(task.left && { left: inEnglish(task.left) }) };
}

/** The last announcement. */
export const spokenText = ({ notices: { announcement } }: EditorState): string =>
  announcement ? worded(en, announcement.words) : '';
