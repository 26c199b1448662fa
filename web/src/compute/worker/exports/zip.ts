/** Several files in one. */
import { zipSync } from 'fflate';
import type { ExportedFile } from '../../exporting_messages';

/** The same files give the same bytes: a zip can hold no earlier day. */
const DAY = '1980-01-01T00:00';

/** Pictures are compressed already. */
export function zipped(files: readonly ExportedFile[]): Uint8Array<ArrayBuffer> {
  const entries = files.map(({ name, bytes }) => [name, [bytes, { level: name.endsWith('.png') ? 0 : 6 }]]);
  return zipSync(Object.fromEntries(entries), { mtime: DAY }) as Uint8Array<ArrayBuffer>;
}
