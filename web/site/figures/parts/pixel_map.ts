/** The triangle under each pixel, with the pixel's barycentric coordinates: made once, used for every field. */

export class PixelMap {
  readonly width: number;
  readonly height: number;
  /** Triangles × 3 points. */
  readonly triangles: Uint32Array;
  /** Pixels: the triangle, −1 outside the shape. */
  readonly triangle: Int32Array;
  /** Pixels × 2: the coordinates for the first two corners. */
  readonly coordinates: Float32Array;

  constructor(points: Float64Array, triangles: Uint32Array, width: number, height: number, scale: number) {
    this.width = width;
    this.height = height;
    this.triangles = triangles;
    this.triangle = new Int32Array(width * height).fill(-1);
    this.coordinates = new Float32Array(2 * width * height);
    for (let triangle = 0; triangle < triangles.length / 3; triangle++) this.#cover(points, triangle, scale);
  }

  #cover(points: Float64Array, triangle: number, scale: number): void {
    const at = (corner: number, axis: number) =>
      (points[2 * (this.triangles[3 * triangle + corner] ?? 0) + axis] ?? 0) * scale - 0.5;
    const [ax, ay, bx, by, cx, cy] = [at(0, 0), at(0, 1), at(1, 0), at(1, 1), at(2, 0), at(2, 1)];
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (area === 0) return;
    const [left, right] = [
      Math.max(0, Math.ceil(Math.min(ax, bx, cx))),
      Math.min(this.width - 1, Math.max(ax, bx, cx)),
    ];
    const [top, bottom] = [
      Math.max(0, Math.ceil(Math.min(ay, by, cy))),
      Math.min(this.height - 1, Math.max(ay, by, cy)),
    ];
    for (let y = top; y <= bottom; y++) {
      for (let x = left; x <= right; x++) {
        const a = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area;
        const b = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area;
        if (a < 0 || b < 0 || a + b > 1) continue;
        const pixel = y * this.width + x;
        this.triangle[pixel] = triangle;
        this.coordinates[2 * pixel] = a;
        this.coordinates[2 * pixel + 1] = b;
      }
    }
  }

  /** The values of a field at all pixels, from those at the points: NaN outside the shape. */
  values(field: Float64Array): Float32Array {
    const { triangle, triangles, coordinates } = this;
    const values = new Float32Array(triangle.length).fill(Number.NaN);
    for (let pixel = 0; pixel < triangle.length; pixel++) {
      const first = 3 * (triangle[pixel] as number);
      if (first < 0) continue;
      const a = coordinates[2 * pixel] as number;
      const b = coordinates[2 * pixel + 1] as number;
      values[pixel] =
        a * (field[triangles[first] as number] as number) +
        b * (field[triangles[first + 1] as number] as number) +
        (1 - a - b) * (field[triangles[first + 2] as number] as number);
    }
    return values;
  }
}
