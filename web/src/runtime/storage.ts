/** Autosave in the browser's storage, and the channel for notifications between tabs. */
import type { Dispatch } from '../editor/events';
import type { WorkSnapshot } from '../editor/work';
import { StoredWork } from './stored_work';

export class Storage {
  readonly #dispatch: Dispatch;
  #work: StoredWork | null = null;
  #tabs: BroadcastChannel | null = null;

  constructor(dispatch: Dispatch) {
    this.#dispatch = dispatch;
  }

  /** Stores under this key from now on; null stops that. */
  use(key: string | null): void {
    this.dispose();
    if (key === null) return;
    this.#work = new StoredWork(key, (stored, newest) =>
      this.#dispatch({ type: 'work-stored', stored, newest }),
    );
    this.#tabs = new BroadcastChannel(`c2warp/${key}`);
    this.#tabs.addEventListener('message', () => this.#dispatch({ type: 'other-tab-stored' }));
  }

  async read(): Promise<void> {
    const stored = (await this.#work?.read()) ?? null;
    this.#dispatch({ type: 'storage-read', stored });
  }

  store(work: WorkSnapshot | null, recent: readonly WorkSnapshot[], changed: boolean): void {
    this.#work?.write(work, recent, changed);
  }

  notifyTabs(): void {
    this.#tabs?.postMessage(null);
  }

  dispose(): void {
    this.#work = null;
    this.#tabs?.close();
    this.#tabs = null;
  }
}
