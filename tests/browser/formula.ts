/** The blends by the formulas in the documentation of `Pose::packed`: a reference for the shader. */
import type { Blend, Skin } from '../../web/src/geometry/skin';

type Complex = readonly [x: number, y: number];

const add = ([a, b]: Complex, [c, d]: Complex): Complex => [a + c, b + d];
const scaled = (k: number, [x, y]: Complex): Complex => [k * x, k * y];
const times = ([a, b]: Complex, [c, d]: Complex): Complex => [a * c - b * d, a * d + b * c];

/** Returns vertices × 2: the posed positions. Every vertex must have sites. */
export function posedByFormula(skin: Skin, motions: Float32Array, blend: Blend): readonly number[] {
  return Array.from({ length: skin.offsets.length - 1 }, (_, vertex) => {
    const p: Complex = [skin.positions[2 * vertex] ?? 0, skin.positions[2 * vertex + 1] ?? 0];
    const [from, to] = [skin.offsets[vertex] ?? 0, skin.offsets[vertex + 1] ?? 0];
    const terms = Array.from(skin.sites.subarray(from, to), (site, entry) => {
      const [a = 1, b = 0, c = 0, d = 1, restX = 0, restY = 0, posedX = 0, posedY = 0, , , hx = 1, hy = 0] =
        motions.subarray(12 * site, 12 * site + 12);
      const [x, y] = [p[0] - restX, p[1] - restY];
      const place: Complex = [posedX + a * x + c * y, posedY + b * x + d * y];
      return { weight: skin.weights[from + entry] ?? 0, place, half: [hx, hy] as Complex };
    });
    const sum = (of: (term: (typeof terms)[number]) => Complex): Complex =>
      terms.reduce<Complex>((total, term) => add(total, scaled(term.weight, of(term))), [0, 0]);
    const linear = sum(({ place }) => place);
    if (blend === 'linear') return linear;
    const half = sum((term) => term.half);
    const s = half[0] ** 2 + half[1] ** 2;
    const factor = s >= 0.25 ? 1 / s : 4 * (3 - 12 * s + 16 * s * s);
    const apart = sum(({ place, half: [x, y] }) => times([x, -y], add(place, scaled(-1, linear))));
    return add(linear, scaled(factor, times(half, apart)));
  }).flat();
}
