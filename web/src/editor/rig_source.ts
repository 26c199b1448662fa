/** The rig of one picture for another. */

import type { Project } from '../document/project';
import type { Words } from '../texts/wording';
import type { NamedFile } from './picture';

/** The rig of a picture, to be used on another one. */
export interface RigSource {
  /** The picture or the project file, for people. */
  readonly name: Words;
  readonly project: Project;
  /** The picture that it was made for, to align its outline with that of the other picture. */
  readonly own: NamedFile | null;
}
