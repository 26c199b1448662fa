/** Putting a picture on the stage, with or without earlier work on it. */

import { newProject, openDocument } from '../../document/document';
import { say } from '../../texts/wording';
import type { Emit } from '../effects';
import type { PageAttributes } from '../page';
import type { Picture } from '../picture';
import type { EditorState } from '../state';
import { openView } from '../view';
import type { Work } from '../work';
import { wantLuminance } from './luminance';
import { closeMenu } from './menu_closing';
import { announce, clearNotices } from './notices';
import { endStages, withSolution } from './solve_request';
import { openWork } from './steps';

/** A new project for a picture without one, with the settings of the page. */
export function freshWork(
  { name: src, width, height, alphaThreshold }: Picture,
  { defaults }: PageAttributes,
): Work {
  const present = openDocument(newProject({ src, width, height }, alphaThreshold, defaults));
  return { record: { past: [], present, future: [] } };
}

export function putPicture(state: EditorState, picture: Picture, work: Work, emit: Emit): EditorState {
  const pixelated = work.pixelated ?? picture.isPixelArt;
  const shown = showPicture({ ...state, pixelated }, picture, emit);
  // Fitted beside the sheet of this selection, not of the previous picture's.
  return openView(wantLuminance(openWork(shown, work, emit), emit), work.view);
}

/** Empties the stage. */
export const closePicture = (state: EditorState, emit: Emit): EditorState =>
  openView(showPicture(state, null, emit));

function showPicture(before: EditorState, picture: Picture | null, emit: Emit): EditorState {
  // First, so that this picture is not fitted with the bounds of the previous one.
  const solution = { shown: null, recent: [], wanted: null, fill: null, borders: null } as const;
  const state = closeMenu(clearNotices(withSolution(endStages(before, emit), solution), emit), emit);
  emit({ type: 'use-picture', picture });
  const shown = {
    ...state,
    picture,
    luminance: null,
    checks: { ...state.checks, outline: '', loose: false },
  };
  return picture && !shown.page.posable ? announce(shown, say('spoken.pictureOpen', picture.name)) : shown;
}
