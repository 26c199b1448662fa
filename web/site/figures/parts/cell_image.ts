/** Cells as an image: each pixel has the colour of its nearest site. */
import { packed, type Rgb } from './colours';
import { paint } from './field_image';
import type { PixelMap } from './pixel_map';

/** The index of the least field at each point. */
export function nearestFields(fields: readonly Float64Array[], points: number): Uint16Array {
  const nearest = new Uint16Array(points);
  const least = new Float64Array(points).fill(Number.POSITIVE_INFINITY);
  for (const [index, field] of fields.entries()) {
    for (let point = 0; point < points; point++) {
      const value = field[point] as number;
      if (value >= (least[point] as number)) continue;
      least[point] = value;
      nearest[point] = index;
    }
  }
  return nearest;
}

/** @param nearest The index of the nearest site at each point. @param border The colour of lines between cells. */
export function cellImage(
  map: PixelMap,
  fields: readonly Float64Array[],
  nearest: Uint16Array,
  colours: readonly Rgb[],
  border: Rgb,
): ImageData {
  const cells = cellsOf(map, fields, nearest);
  const { width } = map;
  const image = new ImageData(width, map.height);
  const pixels = new Uint32Array(image.data.buffer);
  const fills = Uint32Array.from(colours, packed);
  for (let pixel = 0; pixel < cells.length; pixel++) {
    const cell = cells[pixel] as number;
    if (cell < 0) continue;
    pixels[pixel] = fills[cell] as number;
    let others = 0;
    for (let y = -width; y <= width; y += width) {
      for (let x = -1; x <= 1; x++) {
        const other = cells[pixel + x + y] ?? -1;
        if (other >= 0 && other !== cell) others += 1;
      }
    }
    // More pixels of other cells around make a border darker, which smooths it.
    if (others > 0) paint(image.data, pixel, border, Math.min(1, 0.2 * others));
  }
  return image;
}

/** The cell of each pixel, −1 outside the shape. */
function cellsOf(map: PixelMap, fields: readonly Float64Array[], nearest: Uint16Array): Int32Array {
  const { triangle, triangles, coordinates } = map;
  const cells = new Int32Array(triangle.length).fill(-1);
  for (let pixel = 0; pixel < cells.length; pixel++) {
    const first = 3 * (triangle[pixel] as number);
    if (first < 0) continue;
    const u = triangles[first] as number;
    const v = triangles[first + 1] as number;
    const w = triangles[first + 2] as number;
    const a = coordinates[2 * pixel] as number;
    const b = coordinates[2 * pixel + 1] as number;
    /** The distance of a site, which is linear in the triangle. */
    const distance = (site: number) => {
      const field = fields[site] as Float64Array;
      return a * (field[u] as number) + b * (field[v] as number) + (1 - a - b) * (field[w] as number);
    };
    const [one, two, three] = [nearest[u] as number, nearest[v] as number, nearest[w] as number];
    let cell = one;
    if (two !== cell && distance(two) < distance(cell)) cell = two;
    if (three !== cell && three !== one && distance(three) < distance(cell)) cell = three;
    cells[pixel] = cell;
  }
  return cells;
}
