/** The picture by one method of the comparison: its solution, and the canvas that shows it. */
import type { SolutionData } from '../compute/solution';
import { blendOf } from '../document/bending';
import type { Project } from '../document/project';
import { solveKey } from '../document/solved';
import { boxOfBoth } from '../geometry/box';
import { deviceView, fitted, type Size } from '../geometry/camera';
import type { TextureSource } from '../render/picture';
import { Renderer } from '../render/renderer';
import type { SolutionDeformation } from './deformation';

/** Room around the picture, CSS pixels. */
const RIM = { top: 6, right: 6, bottom: 6, left: 6 } as const;
/** Device pixels per CSS pixel of a saved picture. */
const SAVED_RATIO = 3;

export class ComparedPicture {
  readonly #canvas: HTMLCanvasElement;
  readonly #renderer: Renderer;
  readonly #changed: () => void;
  #solved: { readonly key: string; readonly deformation: SolutionDeformation } | null = null;

  /** @param changed is called when the canvas must be drawn again. */
  constructor(canvas: HTMLCanvasElement, changed: () => void) {
    this.#canvas = canvas;
    this.#renderer = new Renderer(canvas);
    this.#renderer.onrestore = changed;
    this.#changed = changed;
  }

  /** The key of the project that was solved; null without a solution. */
  get key(): string | null {
    return this.#solved?.key ?? null;
  }

  /** Shows another picture, without a solution. */
  setPicture(texture: TextureSource): void {
    this.#forget();
    this.#renderer.setPicture(texture);
  }

  setSolution(key: string, deformation: SolutionDeformation, data: SolutionData): void {
    this.#forget();
    this.#solved = { key, deformation };
    this.#renderer.setSolution(data);
  }

  /** Draws the pose. Until a changed project is solved, the picture follows by its last solution. */
  draw(project: Project): void {
    const ready = this.key === solveKey(project);
    this.#canvas.classList.toggle('waiting', !ready);
    this.#canvas.ariaBusy = String(!ready);
    this.#paint(project, devicePixelRatio);
  }

  /** The drawn picture as the address of a PNG; null without a solution. */
  png(project: Project): string | null {
    if (!this.#paint(project, SAVED_RATIO)) return null;
    const url = this.#canvas.toDataURL();
    this.#changed();
    return url;
  }

  dispose(): void {
    this.#forget();
    this.#renderer.dispose();
  }

  /** Returns whether there is something to show. */
  #paint(project: Project, pixelRatio: number): boolean {
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    if (!this.#solved || width === 0 || height === 0) return false;
    const { deformation } = this.#solved;
    const pose = deformation.pose(project);
    if (pose) {
      this.#renderer.setPlaces(pose.places);
      const crossed = project.edges ? pose.crossed() : null;
      this.#renderer.setMotions(pose.motions, blendOf(project), pose.triangles, crossed);
    }
    this.#renderer.load();
    this.#renderer.draw(
      deviceView(this.#camera(project, deformation, { width, height }), { width, height }, pixelRatio),
    );
    if (this.#renderer.isLoading) this.#changed();
    return true;
  }

  #camera(project: Project, deformation: SolutionDeformation, size: Size): ReturnType<typeof fitted> {
    const { width, height } = project.image;
    const frame = { min: [0, 0], max: [width, height] } as const;
    const bounds = deformation.bounds(project);
    return fitted(bounds ? boxOfBoth(frame, bounds) : frame, size, RIM);
  }

  #forget(): void {
    this.#solved?.deformation.free();
    this.#solved = null;
  }
}
