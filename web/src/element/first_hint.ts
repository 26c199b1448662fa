/** The hint of the page, which points to a handle until the document is first changed. */
import { anchor } from '../document/handle';
import type { Hint } from '../ui/model';
import type { Permissions } from './permissions';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

/** A hint shown beside this handle, or beside the first if there is none of this id. */
export interface PageHint {
  readonly text: string;
  readonly handle: string | null;
}

export interface FirstHintHost {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly permissions: Permissions;
  readonly hint: PageHint | null;
}

/** Room for the hint beside a handle, CSS pixels. */
const WIDTH = 170;

export class FirstHint {
  readonly #host: FirstHintHost;
  /** The document has been changed. */
  touched = false;

  constructor(host: FirstHintHost) {
    this.#host = host;
  }

  get shown(): Hint | null {
    const { hint, permissions, viewing } = this.#host;
    const { editing, solving } = this.#host.workbench;
    const { handles } = editing.project;
    const handle = handles.find(({ id }) => id === hint?.handle) ?? handles[0];
    if (!hint || !handle || this.touched || permissions.readonly) return null;
    if (!solving.current || editing.machine.draft) return null;
    const at = anchor(handle);
    if (!viewing.shows(at)) return null;
    return { text: hint.text, at, above: !viewing.shows(at, WIDTH) };
  }
}
