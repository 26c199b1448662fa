/** Quiet colours for cells, so that neighbours differ. */
import { type Colours, mixed, type Rgb } from './colours';

/** @param chosen The cell to stand out, if any. */
export function cellColours({ shape, blue, green, pink }: Colours, count: number, chosen = -1): Rgb[] {
  const tints = [
    mixed(shape, blue, 0.16),
    mixed(shape, green, 0.18),
    mixed(shape, pink, 0.12),
    mixed(shape, green, 0.06),
    mixed(shape, blue, 0.07),
  ];
  return Array.from({ length: count }, (_, index) =>
    index === chosen ? mixed(shape, blue, 0.4) : (tints[index % tints.length] as Rgb),
  );
}
