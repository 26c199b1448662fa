/** What is shown besides the document: overlays, the picture alone while a key is held, opened settings, the selection box. */
import type { Box } from '../geometry/box';
import type { BareView } from '../ui/commands';
import type { OverlayFlags } from '../ui/overlays';
import type { Permissions } from './permissions';
import type { Workbench } from './workbench';

export interface DisplayHost {
  readonly workbench: Workbench;
  readonly permissions: Permissions;
  /** Which the picture is drawn on, and whose style the page may set. */
  readonly canvas: HTMLCanvasElement;
  /** The controls show something else. */
  changed(): void;
  /** The stage shows something else too. */
  looked(): void;
}

const NO_OVERLAYS: OverlayFlags = {
  mesh: false,
  cells: false,
  sites: false,
  graph: false,
  folds: false,
  reach: false,
  coverage: false,
};

/** Of two heat maps one is shown. */
const INSTEAD: Partial<Record<keyof OverlayFlags, Partial<OverlayFlags>>> = {
  reach: { coverage: false },
  coverage: { reach: false },
};

export class Display {
  readonly #host: DisplayHost;
  #overlays = NO_OVERLAYS;
  #bare: BareView | null = null;
  #settings = false;
  #numbers = false;
  /** The selection box being drawn, image pixels. */
  box: Box | null = null;

  constructor(host: DisplayHost) {
    this.#host = host;
  }

  /** With `play` there are none. */
  get overlays(): OverlayFlags {
    return this.#host.permissions.playing ? NO_OVERLAYS : this.#overlays;
  }

  /** What is shown alone, without handles and overlays: the original, or the posed picture. */
  get bare(): BareView | null {
    return this.#bare;
  }

  /** Whether the picture is shown at rest: held to compare, or to be drawn around. */
  get original(): boolean {
    return this.#bare === 'compare' || this.lassoing;
  }

  /** Whether handles and overlays are out of the way of a lasso. */
  get lassoing(): boolean {
    return this.#host.workbench.editing.machine.tool === 'lasso';
  }

  /** Whether the picture is drawn as pixel art: as the page says by `image-rendering`, or the person. */
  get pixelated(): boolean {
    const { workbench, canvas } = this.#host;
    return workbench.pixelated || getComputedStyle(canvas).imageRendering === 'pixelated';
  }

  /** Whether the settings of the whole picture are open, in layouts without room to show them always. */
  get settings(): boolean {
    return this.#settings;
  }

  /** Whether the numbers of the selected handles are open, in the same layouts. */
  get numbers(): boolean {
    return this.#numbers;
  }

  overlay(name: keyof OverlayFlags, on: boolean): void {
    this.#overlays = { ...this.#overlays, ...(on && INSTEAD[name]), [name]: on };
    this.#host.looked();
  }

  /** Shows the picture alone, or null for all. */
  showBare(view: BareView | null): void {
    if (view === this.#bare || (view && !this.#host.workbench.picture)) return;
    this.#bare = view;
    this.#host.looked();
  }

  toggleBare(view: BareView): void {
    this.showBare(this.#bare === view ? null : view);
  }

  openSettings(on: boolean): void {
    this.#settings = on;
    this.#host.changed();
  }

  openNumbers(on: boolean): void {
    this.#numbers = on;
    this.#host.changed();
  }
}
