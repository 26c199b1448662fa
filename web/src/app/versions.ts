/**
 * The versions of the editor that the browser has stored, and the one that this page shows. See `service_worker.ts`.
 *
 * Where a browser has no service workers, or refuses them, the editor works as any page does.
 */
import type { Texts } from '../texts/texts';

/** Longer than a worker takes to start. */
const ANSWER_MS = 3000;
/** Browsers look for a new version at each start. A window that stays open looks this often. */
const BETWEEN_LOOKS_MS = 3_600_000;

type Inform = (text: string) => void;

/**
 * Starts the version that waits, if no other page shows the editor: this page then loads again.
 *
 * Resolves if this page stays; to whether a version waits for other pages to close.
 */
export async function startNewest(): Promise<boolean> {
  const container = serviceWorkers();
  const waiting = container?.controller && (await container.getRegistration().catch(() => null))?.waiting;
  if (!container || !waiting) return false;
  const replaced = new Promise((done) =>
    container.addEventListener('controllerchange', done, { once: true }),
  );
  if (!(await takesOver(waiting))) return true;
  await replaced;
  location.reload();
  return new Promise(() => {});
}

/** Whether a waiting version takes over. */
function takesOver(waiting: ServiceWorker): Promise<boolean> {
  const { port1, port2 } = new MessageChannel();
  return new Promise((done) => {
    port1.onmessage = ({ data }) => done(data);
    setTimeout(done, ANSWER_MS, false);
    waiting.postMessage(null, [port2]);
  });
}

/**
 * Stores this version, and then looks for newer ones. A new version is announced once.
 *
 * @param address of the worker.
 * @param waits whether a newer version is stored already.
 */
export async function storeVersions(
  address: string,
  waits: boolean,
  inform: Inform,
  { notices }: Texts,
): Promise<void> {
  const container = serviceWorkers();
  if (!container) return;
  if (waits) inform(notices.newVersionWaits);
  // A private window may refuse it.
  const registration = await container.register(address).catch(() => null);
  if (!registration) return;
  const follow = (): void => {
    const { installing } = registration;
    installing?.addEventListener('statechange', () => {
      // The first version is no news.
      if (installing.state === 'installed' && registration.active) whenSeen(() => inform(notices.newVersion));
      // The next start tries again. In a browser's tab nobody expects it to work without a network.
      if (installing.state === 'redundant' && !registration.active && isInstalled())
        inform(notices.notOffline);
    });
  };
  follow();
  registration.addEventListener('updatefound', follow);
  let looked = performance.now();
  document.addEventListener('visibilitychange', () => {
    if (document.hidden || performance.now() - looked < BETWEEN_LOOKS_MS) return;
    looked = performance.now();
    // Without a network, the next look may find it.
    registration.update().catch(() => {});
  });
}

/** Undefined where the page is not served securely, or is in a sandboxed frame. */
function serviceWorkers(): ServiceWorkerContainer | undefined {
  try {
    return navigator.serviceWorker;
  } catch {
    return undefined;
  }
}

const isInstalled = (): boolean => matchMedia('(display-mode: standalone)').matches;

/** A notice that passes would pass unseen in a hidden tab. */
function whenSeen(notify: () => void): void {
  if (!document.hidden) notify();
  else document.addEventListener('visibilitychange', notify, { once: true });
}
