/** The pose that exports of the moment have. */
import { clipNamed } from '../../document/clips';
import { isAlong } from '../../document/moment';
import type { Project } from '../../document/project';
import type { ClipMoment } from '../effects';
import { documentOf, type EditorState } from '../state';

/** The project, and the time of a clip that poses it. Along a clip the picture keeps to the way from its beginning. */
export function drawn(state: EditorState): { readonly project: Project; readonly moment: ClipMoment | null } {
  const document = documentOf(state);
  const clip = document.moment && clipNamed(document.moment.base, document.moment.clip);
  const deformation = state.solution.shown?.deformation;
  if (!document.moment || !clip || !deformation || !isAlong(document, deformation.posesAt))
    return { project: document.project, moment: null };
  return { project: document.moment.base, moment: { clip, time: document.moment.time } };
}
