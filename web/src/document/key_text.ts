/** Keys of a clip as text for the clipboard: as in the project file, each with its handle. The first is at time 0. */
import { KEYED_VALUES, type PlacedKey } from './clip_keys';
import { listIn, saysFormat } from './clipboard_text';
import type { Ease } from './project';
import { projectText } from './project_text';

const FORMAT = 'c2warp-keys/1';
const VALUES: readonly string[] = ['posed', ...KEYED_VALUES];
const EASES = ['smooth', 'linear', 'hold'] as const satisfies readonly Ease[];

export const keysText = (placed: readonly PlacedKey[]): string =>
  projectText({ format: FORMAT, keys: placed.map(({ handle, key }) => ({ handle, ...key })) });

/** Whether a text has the format of keys. */
export const isKeys = (text: string): boolean => saysFormat(text, 'c2warp-keys');

/**
 * Returns the keys of a text, or `null` if the text has another format. `withKey` checks their values.
 * @throws RangeError with the reason if a key is invalid.
 */
export const parseKeys = (text: string): readonly PlacedKey[] | null =>
  isKeys(text) ? listIn(text, FORMAT, 'keys').map(placedKey) : null;

function placedKey(value: unknown): PlacedKey {
  const { handle, time, ease = 'smooth', ...values } = Object(value);
  const refuse = (what: string): never => {
    throw new RangeError(`key of "${handle}", ${what}`);
  };
  if (typeof handle !== 'string' || handle === '') refuse('handle: expected a name');
  if (typeof time !== 'number' || !(time >= 0)) refuse('time: expected seconds');
  if (!EASES.includes(ease)) refuse(`ease: expected one of ${EASES.join(', ')}`);
  const unknown = Object.keys(values).find((name) => !VALUES.includes(name));
  if (unknown !== undefined) refuse(`${unknown}: unknown key; expected one of ${VALUES.join(', ')}`);
  return { handle, key: { ...values, time, ease } };
}
