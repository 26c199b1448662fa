/** The rigs of a page, each loaded once for all players that show it. */
import { C2WarpError } from '../error';
import { type Rig, readRig } from './rig';

export interface Loaded {
  readonly rig: Rig;
  /** Premultiplied. */
  readonly picture: ImageBitmap;
}

interface Book {
  readonly loaded: Promise<Loaded>;
  readers: number;
}

const books = new Map<string, Book>();

/** The rig of an address. Every `borrow` must be followed by a `giveBack`. */
export function borrow(address: string): Promise<Loaded> {
  const known = books.get(address);
  const book = known ?? { loaded: load(address), readers: 0 };
  book.readers++;
  books.set(address, book);
  return book.loaded;
}

export function giveBack(address: string, forget: (loaded: Loaded) => void): void {
  const book = books.get(address);
  if (!book || --book.readers > 0) return;
  books.delete(address);
  book.loaded.then(
    (loaded) => {
      forget(loaded);
      loaded.picture.close();
    },
    () => {},
  );
}

async function load(address: string): Promise<Loaded> {
  const response = await fetch(address).catch(() => {
    throw new C2WarpError('address', `Could not load ${address}. Check that the file exists.`);
  });
  if (!response.ok)
    throw new C2WarpError('address', `Could not load ${address}: the server answered ${response.status}.`);
  const rig = await readRig(new Uint8Array(await response.arrayBuffer()));
  const picture = await createImageBitmap(new Blob([rig.picture]), { premultiplyAlpha: 'premultiply' }).catch(
    () => {
      throw new C2WarpError('rig', 'This rig is damaged: its picture cannot be decoded.');
    },
  );
  if (picture.width === rig.width && picture.height === rig.height) return { rig, picture };
  picture.close();
  throw new C2WarpError('rig', 'This rig is damaged: its picture has another size.');
}
