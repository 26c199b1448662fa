/** Texts about exports of maps and weights. */
import type { Size } from '../geometry/camera';
import type { MapChoices, MapKind } from './map_choices';
import { SELECT_ONE } from './notice_texts';

export const MAP_NAMES: Readonly<Record<MapKind, string>> = {
  inverse: 'Inverse',
  forward: 'Forward',
  stretch: 'Stretch',
  disocclusion: 'Disocclusion',
  heat: 'Heat map',
  weights: 'Weights',
};

export const MAP_NOTES: Readonly<Record<MapKind, string>> = {
  inverse: 'An ST map for compositors: it bends other pictures as this one is bent.',
  forward: 'The way back: as an ST map on the warped picture, it takes the warp back.',
  stretch: 'How much areas and lengths grow, at each pixel of the warped picture.',
  disocclusion: 'Red where the warp uncovers something, green where it covers something.',
  heat: 'How far the picture follows a handle, in colours over the original.',
  weights: 'How far points of the original follow, as numbers for scripts.',
};

export const MAP_FORMAT_NOTES: Readonly<Record<MapChoices['format'], string>> = {
  exr: 'OpenEXR with 32-bit floats. The header tells what the channels mean.',
  png: '16 bits a channel, for programs without OpenEXR.',
};

/** @param isZip the array comes with the list of its sites. */
export function tableNote({ table }: MapChoices, isZip: boolean): string {
  if (table === 'csv') return 'A row for each weight above 0.';
  return isZip ? 'A zip: an array for NumPy, and the list of its sites.' : 'An array for NumPy.';
}

export const pointsText = (size: Size | null): string =>
  size ? `${size.width.toLocaleString('en')} × ${size.height.toLocaleString('en')} points` : '';

/** @param handle the selected one in words. */
export const heatText = (handle: string | null): string =>
  handle === null ? SELECT_ONE : `Selected: ${handle}.`;
