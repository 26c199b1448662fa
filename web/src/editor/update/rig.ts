/** The rig of one picture on another: offered when a picture or a project is opened, and one step of the history. */

import { openDocument } from '../../document/document';
import { nameWords } from '../../document/names';
import type { Project } from '../../document/project';
import { say, type Words } from '../../texts/wording';
import type { Emit } from '../effects';
import type { NoticeAction } from '../notice';
import type { Picture } from '../picture';
import type { EditorState } from '../state';
import type { Work } from '../work';
import type { Handlers } from './handlers';
import { informOfStep } from './notices';
import { withOpening } from './requests';
import { step } from './steps';
import { chooseByHandles } from './tool_choice';

/** Offers the rig of work on another picture; null if it has no handles. */
export function rigOfWork(picture: Picture, { record }: Work): NoticeAction | null {
  const { project } = record.present;
  if (project.handles.length === 0) return null;
  const { name, file, alphaThreshold } = picture;
  // Without transparency there is no outline to align.
  const own = alphaThreshold === null ? null : { name, file };
  return { label: say('answers.useRig'), event: { type: 'rig-asked', rig: { name, project, own } } };
}

/** Offers the rig of a project whose picture is not there; null if it has no handles. */
export const rigOfProject = (name: Words, project: Project): NoticeAction | null =>
  project.handles.length === 0
    ? null
    : {
        label: say('answers.useRig'),
        event: { type: 'rig-asked', rig: { name: project.image.src || name, project, own: null } },
      };

export const rigHandlers: Handlers<'rig-asked' | 'rig-fitted'> = {
  'rig-asked': (state, { rig }, emit) => {
    if (state.picture) emit({ type: 'fit-rig', rig, picture: state.picture });
    return state;
  },
  'rig-fitted': (state, { rig, picture, project, moved }, emit) =>
    // Another picture may be open by now.
    state.picture === picture ? useRig(state, rig.name, project, moved, emit) : state,
};

function useRig(
  before: EditorState,
  name: Words,
  fitted: Project,
  moved: readonly string[],
  emit: Emit,
): EditorState {
  const project = { ...fitted, image: { ...fitted.image, src: before.picture?.name ?? '' } };
  const used = step(
    withOpening(before, { awaiting: null }),
    say('steps.useRig', name),
    openDocument(project),
    emit,
  );
  const state = chooseByHandles(used, emit);
  return moved.length > 0
    ? informOfStep(
        state,
        say(
          'notices.movedInside',
          moved.map((id) => nameWords({ id })),
        ),
        emit,
      )
    : state;
}
