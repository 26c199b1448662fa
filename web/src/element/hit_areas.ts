/** What a press can hit: areas as large as the pointer in use needs, and the scene that tools find them in. */
import type { Grips, ToolContext } from '../tools/state';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

/** Sizes of the hit areas for a mouse and for a finger, CSS pixels. See `Grips`. */
const REACH = {
  fine: { handle: 14, line: 9, ring: 40, band: 8, slop: 3 },
  coarse: { handle: 24, line: 20, ring: 52, band: 18, slop: 8 },
} as const;

export class HitAreas {
  readonly #workbench: Workbench;
  readonly #viewing: Viewing;
  /** Whether the last press was one of a finger; at first, whether the device has no finer pointer. */
  coarse = matchMedia('(pointer: coarse)').matches;

  constructor(workbench: Workbench, viewing: Viewing) {
    this.#workbench = workbench;
    this.#viewing = viewing;
  }

  /** Current sizes, image pixels. */
  get grips(): Grips {
    const reach = this.coarse ? REACH.coarse : REACH.fine;
    const { scale } = this.#viewing.camera;
    return {
      handle: reach.handle / scale,
      line: reach.line / scale,
      ring: reach.ring / scale,
      band: reach.band / scale,
      slop: reach.slop / scale,
      view: this.#viewing.free,
    };
  }

  get press(): 'click' | 'tap' {
    return this.coarse ? 'tap' : 'click';
  }

  /** Without hit areas: a press places something, even on an existing handle. */
  get bareScene(): ToolContext {
    return { ...this.scene, grips: { ...this.grips, handle: -1, line: -1, band: -1 } };
  }

  get scene(): ToolContext {
    const { editing, posing } = this.#workbench;
    const { grips } = this;
    return {
      document: editing.document,
      grips,
      turns: posing.turns(),
      place: (at) => posing.place(at, grips.line),
      placeNear: (at) => posing.placeNear(at),
    };
  }
}
