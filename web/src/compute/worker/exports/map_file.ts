/** A map of the warp, a heat map, or weights. */
import type { MapName } from '../../../document/map_file';
import type { ExportRequest, MapOrder } from '../../exporting_messages';
import { MapKind, MapOptions, SolvedProject } from '../../generated/c2warp_export';
import { zipped } from './zip';

type Bytes = Uint8Array<ArrayBuffer>;

const MAPS: Readonly<Record<MapName, MapKind>> = {
  inverse: MapKind.Inverse,
  forward: MapKind.Forward,
  stretch: MapKind.Stretch,
  disocclusion: MapKind.Disocclusion,
};

/** @throws Error for a map or a table that is too large. */
export function mapFile(
  { project, width, height }: ExportRequest,
  { file, picture, pixelated, clip, time }: MapOrder,
  rgba: Uint8Array,
  onProgress: (part: number) => void,
): Bytes {
  const solved = new SolvedProject(project, width, height, rgba, onProgress);
  if (file.what === 'heat') return solved.heatMap(file.handle) as Bytes;
  if (file.what === 'weights') {
    const { handle, every, format } = file;
    const isArray = format === 'npy';
    if (handle !== null) return solved.handleWeights(handle, every, isArray) as Bytes;
    const table = solved.weights(every, isArray) as Bytes;
    if (!isArray) return table;
    return zipped([
      { name: 'weights.npy', bytes: table },
      { name: 'sites.csv', bytes: solved.sites() as Bytes },
    ]);
  }
  const options = new MapOptions(MAPS[file.map], file.format === 'exr', file.grow, pixelated);
  return solved.map(options, picture, clip ?? undefined, time) as Bytes;
}
