/** The orientation that a camera recorded in EXIF data. */
import { startsWith } from './latin';

/** The orientations of TIFF 6.0 from 1, upright, to 8. */
export type Orientation = 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8;

const ORIENTATION = 0x112;
const SHORT = 3;

/** Returns the recorded orientation: upright if the data records none, or is invalid. */
export function orientationOf(exif: DataView): Orientation {
  // JPEG files have this prefix. Some programs write it to other files, too.
  const start = startsWith(exif, 'Exif\0\0') ? 6 : 0;
  const little = startsWith(exif, 'II*\0', start);
  if (!little && !startsWith(exif, 'MM\0*', start)) return 1;
  try {
    const directory = start + exif.getUint32(start + 4, little);
    const entries = exif.getUint16(directory, little);
    for (let at = directory + 2; at < directory + 2 + entries * 12; at += 12) {
      const isOrientation = exif.getUint16(at, little) === ORIENTATION;
      if (!isOrientation || exif.getUint16(at + 2, little) !== SHORT) continue;
      const value = exif.getUint16(at + 8, little);
      return value >= 1 && value <= 8 ? (value as Orientation) : 1;
    }
  } catch {
    // The data ends early.
  }
  return 1;
}
