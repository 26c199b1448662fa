/** The list of recent work, and the versions of other tabs in it. */
import { say } from '../../texts/wording';
import { removedWords } from '../notice_words';
import { bounded, withoutVersions } from '../recent';
import { saveRecent } from './autosave';
import type { Handlers } from './handlers';
import { notify } from './notices';
import { withOpening } from './requests';

export const recentHandlers: Handlers<'version-kept' | 'recent-removed' | 'recent-put-back'> = {
  'version-kept': (state, _, emit) =>
    saveRecent(withOpening(state, { recent: withoutVersions(state.opening.recent) }), emit),
  'recent-removed': (state, { id }, emit) => {
    const { recent: before } = state.opening;
    const works = before.filter((work) => id === null || work.id === id);
    const recent = before.filter((work) => !works.includes(work));
    const removed = saveRecent(withOpening(state, { recent }), emit);
    const action = { label: say('answers.putBack'), event: { type: 'recent-put-back', works } } as const;
    return notify(removed, { kind: 'info', text: removedWords(works), action, passes: true }, emit);
  },
  'recent-put-back': (state, { works }, emit) =>
    saveRecent(withOpening(state, { recent: bounded([...works, ...state.opening.recent]) }), emit),
};
