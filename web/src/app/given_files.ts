/** Files that the system gives to the installed editor: opened with it, or shared with it. */
import type { Texts } from '../texts/texts';
import { sharedCache } from './cache_names';
import { SHARED, takeShared } from './shared_files';

/** The part of the Launch Handler API that TypeScript does not know. */
interface LaunchQueue {
  setConsumer(consume: (launch: { readonly files?: readonly FileSystemFileHandle[] }) => void): void;
}

type Open = (files: readonly File[]) => void;

interface Editor {
  readonly open: Open;
  /** Any page can send the form of a share: the person decides. */
  readonly offer: Open;
  readonly inform: (text: string) => void;
}

/** Whether this start may have shared files. */
export const isShare = (): boolean => new URLSearchParams(location.search).has(SHARED);

/** Hands over the files of this start, and those that are opened with the running editor later. */
export function receiveFiles({ open, offer, inform }: Editor, { notices }: Texts): void {
  const { launchQueue } = globalThis as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files = [] }) => {
    openLaunched(files, open, (handle) => inform(notices.notGiven(handle.name)));
  });
  if (isShare()) receiveShared(offer, () => inform(notices.shareFailed));
}

async function openLaunched(
  handles: readonly FileSystemFileHandle[],
  open: Open,
  failed: (handle: FileSystemFileHandle) => void,
): Promise<void> {
  const files = [];
  for (const handle of handles) {
    try {
      files.push(await handle.getFile());
    } catch {
      failed(handle);
    }
  }
  if (files.length > 0) open(files);
}

async function receiveShared(offer: Open, failed: () => void): Promise<void> {
  const { href } = new URL('./', location.href);
  // A reload has nothing to take any more.
  history.replaceState(history.state, '', href);
  const files = await caches.open(sharedCache(href)).then(takeShared, () => []);
  if (files.length > 0) offer(files);
  else failed();
}
