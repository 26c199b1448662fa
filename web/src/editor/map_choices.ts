/** How a person exports maps and weights: kept for the next one, and stored with the work. */
import type { MapFile, MapName, WarpMap, WeightTable } from '../document/map_file';
import { fileWord, stem } from './picture';

export type MapKind = MapName | 'heat' | 'weights';

export interface MapChoices {
  readonly map: MapKind;
  /** Of maps. */
  readonly format: WarpMap['format'];
  /** Whether a map holds everything that is bent beyond the picture. */
  readonly area: 'picture' | 'grown';
  /** Of weights. */
  readonly table: WeightTable['format'];
  /** Weights of all sites, or of the selected handle. */
  readonly of: 'sites' | 'handle';
  /** Pixels from one point of the weights to the next. */
  readonly every: number;
}

export const DEFAULT_MAPS: MapChoices = {
  map: 'inverse',
  format: 'exr',
  area: 'picture',
  table: 'npy',
  of: 'sites',
  every: 8,
};

export const EVERY = { least: 1, most: 1000 } as const;

/**
 * The file that the choices ask for; null if they need a handle first.
 *
 * @param handle the name of the only selected handle.
 */
export function mapFile(choices: MapChoices, handle: string | null): MapFile | null {
  const { map, format, area, table, of, every } = choices;
  if (map === 'heat') return handle === null ? null : { what: 'heat', handle };
  if (map !== 'weights') return { what: 'map', map, format, grow: area === 'grown' };
  if (of === 'handle' && handle === null) return null;
  return { what: 'weights', handle: of === 'handle' ? handle : null, every, format: table };
}

/** The name of a file. @param picture The name of the picture's file. */
export function mapFileName(picture: string, file: MapFile): string {
  const words =
    file.what === 'map' ? [file.map] : [file.what, ...(file.handle === null ? [] : [file.handle])];
  return `${[stem(picture), ...words.map(fileWord)].join('-')}.${mapExtension(file)}`;
}

export type MapExtension = 'exr' | 'png' | 'npy' | 'csv' | 'zip';

export function mapExtension(file: MapFile): MapExtension {
  if (file.what === 'heat') return 'png';
  return file.what === 'weights' && file.handle === null && file.format === 'npy' ? 'zip' : file.format;
}
