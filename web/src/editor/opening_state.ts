/**
 * Opening pictures as a state machine.
 *
 * A request is first *reading*: fetch, decode, check the project. Then it is on *trial*: the picture is on the stage
 * while its first solve runs. It ends as opened, refused, or superseded by a newer request. The previous picture waits
 * in the trial and comes back after a refusal.
 *
 * Restoring earlier work is a separate kind of request. A newer request *suspends* it. It is superseded only once the
 * newer picture is open, so that work is never lost to a file that cannot be opened.
 */

import type { Document } from '../document/document';
import type { Project, ProjectFile } from '../document/project';
import type { Words } from '../texts/wording';
import type { ToolName } from '../tools/machine';
import type { NamedFile, Picture } from './picture';
import type { Work, WorkSnapshot } from './work';

/** The requester of a picture, who receives the result. */
export type Purpose =
  /** A person, by picker, drop or paste. `received` are all files but the project. Those that do not open are named. */
  | { readonly by: 'person'; readonly received: readonly NamedFile[] }
  /** A person goes back to recent work. */
  | { readonly by: 'back'; readonly work: WorkSnapshot }
  /**
   * The page, by `load()`. `usesPageProject`: with the project that the page set before. `notice`: a failure is shown
   * to the user.
   */
  | {
      readonly by: 'load';
      readonly reply: number;
      readonly usesPageProject: ProjectFile | null;
      readonly notice: boolean;
    }
  /** The attributes. `revision` distinguishes a change from a newer one. */
  | { readonly by: 'attributes'; readonly revision: number }
  /** A person retries after a failure of the solver. */
  | { readonly by: 'retry' };

export interface OpenRequest {
  readonly id: number;
  /** The name of the file, for people. */
  readonly name: string;
  readonly purpose: Purpose;
  /** Earlier work on the picture, when that is reopened. */
  readonly work: WorkSnapshot | null;
}

/** Work that is restored automatically. */
export interface Restoring {
  readonly id: number;
  readonly work: WorkSnapshot;
  /** After a reload, after the element was moved, or after a newer picture was refused. */
  readonly from: 'storage' | 'element' | 'refusal';
  readonly phase: 'reading' | 'solving' | 'suspended';
}

/** The result of a request. */
export type OpenOutcome = 'opened' | 'superseded' | Error;

/** A picture on the stage before its first solution. */
export interface Trial {
  /** Null for restored work, which `restoring` describes. */
  readonly request: OpenRequest | null;
  /** The picture came with a project of its own. */
  readonly withProject: boolean;
  /** The project in the picture, which is for another one, or why it cannot be read. */
  readonly carried: Project | Error | null;
  /** The picture came without a project or work. */
  readonly fresh: boolean;
  /** The document that was put on the stage with the picture. */
  readonly opened: Document;
  /** The picture, the work and the tool to return to. */
  readonly before: { readonly picture: Picture; readonly work: Work; readonly tool: ToolName } | null;
  /** The recent work once the picture is open. */
  readonly recent: readonly WorkSnapshot[];
}

/**
 * The first content after the element is connected. Changed attributes go first, then the work that the element was
 * moved with, then stored work, then the attributes.
 */
export type Startup =
  | { readonly phase: 'waiting' | 'storage' | 'restoring' | 'done' }
  | {
      readonly phase: 'attributes';
      /** The id of the request. */
      readonly id: number;
      /** Work to reopen if the attributes cannot be opened. */
      readonly orElse: WorkSnapshot | null;
      /** Why stored work could not be opened. */
      readonly unread: Error | null;
    };

export interface ProjectRead {
  readonly id: number;
  readonly name: string;
  /** Names of further files. */
  readonly received: readonly NamedFile[];
}

export interface OpeningState {
  /** The id of the next request. */
  readonly nextId: number;
  /** The newest request, while it is being read. */
  readonly reading: OpenRequest | null;
  /** Project files without a picture that are being read, with the names of further files. */
  readonly readingProjects: readonly ProjectRead[];
  readonly restoring: Restoring | null;
  readonly trial: Trial | null;
  readonly startup: Startup;
  /** Another picture was requested since the connection: the first content no longer counts. */
  readonly overtaken: boolean;
  /** A project that was opened without its picture. */
  readonly awaiting: { readonly name: Words; readonly project: Project } | null;
  /** Edited pictures that gave way to others, oldest first. */
  readonly recent: readonly WorkSnapshot[];
  /** Counts changes of the attributes; `openedRevision` is the last one that was opened or refused. */
  readonly revision: number;
  readonly openedRevision: number;
  /** The project and the selection that the page set before there was a picture. */
  readonly pageProject: ProjectFile | null;
  readonly pageSelection: readonly string[] | null;
}

/** What outlives a disconnection of the element. */
export type Carried = Pick<
  OpeningState,
  'awaiting' | 'recent' | 'revision' | 'openedRevision' | 'pageProject' | 'pageSelection'
> & { readonly work: WorkSnapshot | null };

export const nothingCarried: Carried = {
  awaiting: null,
  recent: [],
  revision: 0,
  openedRevision: 0,
  pageProject: null,
  pageSelection: null,
  work: null,
};

export const initialOpening = ({ work: _, ...carried }: Carried): OpeningState => ({
  ...carried,
  nextId: 1,
  reading: null,
  readingProjects: [],
  restoring: null,
  trial: null,
  startup: { phase: 'waiting' },
  overtaken: false,
});

/** The name of what is being read to replace the open picture; null if nothing is. */
export const readingName = ({ reading, readingProjects, restoring }: OpeningState): string | null =>
  reading?.name ??
  readingProjects.at(-1)?.name ??
  (restoring?.phase === 'reading' ? restoring.work.name : null);

/** Whether a changed attribute names something that is not open yet. */
export const attributesPending = ({ revision, openedRevision }: OpeningState): boolean =>
  revision !== openedRevision;

export const isOpening = ({ reading, readingProjects, restoring, trial, startup }: OpeningState): boolean =>
  reading !== null ||
  readingProjects.length > 0 ||
  restoring !== null ||
  trial !== null ||
  startup.phase === 'storage';
