/**
 * One picture by three methods, live beside each other. A separate worker solves, so that the editor never waits.
 *
 * Loaded when the comparison is first shown. Worker and graphics are released when it is left.
 */

import { Engine } from '../compute/engine';
import type { Project } from '../document/project';
import { solveKey } from '../document/solved';
import { byVariant, VARIANTS, type Variant, variantOf } from '../document/variants';
import type { EditorAccess } from '../editor/access';
import { errorWords } from '../editor/error_words';
import type { Picture } from '../editor/picture';
import { projectOf } from '../editor/state';
import { asError, isAbort } from '../error';
import type { Wording } from '../texts/wording';
import type { VariantCanvases, VariantPictures } from '../ui/study_view';
import { ComparedPicture } from './compared_picture';
import { SolutionDeformation } from './deformation';
import type { Pictures } from './pictures';

export class Compare {
  readonly #editor: EditorAccess;
  readonly #pictures: Pictures;
  readonly #shown: Readonly<Record<Variant, ComparedPicture>>;
  /** Keys that the solver refused. */
  readonly #refused = new Map<Variant, string>();
  #engine: Promise<Engine> | null = null;
  #picture: Picture | null = null;
  #request = 0;
  #solving = false;
  #disposed = false;

  constructor(editor: EditorAccess, pictures: Pictures, canvases: VariantCanvases) {
    this.#editor = editor;
    this.#pictures = pictures;
    this.#shown = byVariant((variant) => new ComparedPicture(canvases[variant], () => this.follow()));
  }

  /** The state may have changed: draws with the next frame. */
  follow(): void {
    if (this.#request === 0 && !this.#disposed) this.#request = requestAnimationFrame(() => this.#frame());
  }

  /** The shown pictures, as addresses of PNGs; null where one is not solved yet. */
  pngs(): VariantPictures {
    const project = projectOf(this.#editor.state);
    return byVariant((variant) => this.#shown[variant].png(variantOf(project, variant)));
  }

  dispose(): void {
    this.#disposed = true;
    cancelAnimationFrame(this.#request);
    for (const variant of VARIANTS) this.#shown[variant].dispose();
    this.#engine?.then(
      (engine) => engine.dispose(),
      () => {},
    );
  }

  #frame(): void {
    this.#request = 0;
    const { picture } = this.#editor.state;
    if (picture !== this.#picture) this.#show(picture);
    if (!picture) return;
    const project = projectOf(this.#editor.state);
    for (const variant of VARIANTS) this.#shown[variant].draw(variantOf(project, variant));
    void this.#solve();
  }

  /** Shows another picture. */
  #show(picture: Picture | null): void {
    this.#refused.clear();
    this.#picture = picture;
    if (!picture) return;
    const { texture, pixels } = this.#pictures.opened(picture);
    this.#engine ??= Engine.start();
    this.#engine.then(
      (engine) => engine.setPicture(pixels),
      () => {},
    );
    for (const variant of VARIANTS) this.#shown[variant].setPicture(texture);
  }

  /** Solves one variant after another until all are those of the present project. */
  async #solve(): Promise<void> {
    if (this.#solving) return;
    this.#solving = true;
    try {
      for (let next = this.#stale(); next; next = this.#stale()) await this.#solveOne(...next);
    } finally {
      this.#solving = false;
    }
  }

  async #solveOne(variant: Variant, project: Project): Promise<void> {
    const key = solveKey(project);
    const picture = this.#picture;
    try {
      const engine = await this.#engine;
      const data = await engine?.solve(project);
      if (!engine || !data || this.#disposed || picture !== this.#picture) return;
      const deformation = new SolutionDeformation(engine.posedPicture(data, project), data);
      this.#shown[variant].setSolution(key, deformation, data);
      this.#report(variant, null);
    } catch (thrown) {
      const error = asError(thrown);
      // Another picture was opened meanwhile: its own solve follows.
      if (isAbort(error) || this.#disposed) return;
      this.#refused.set(variant, key);
      this.#report(variant, errorWords(error));
    }
    this.follow();
  }

  /** A variant whose solution is not that of the present project, unless the solver refused it. */
  #stale(): [Variant, Project] | undefined {
    if (this.#disposed || !this.#picture || this.#editor.state.picture !== this.#picture) return undefined;
    const present = projectOf(this.#editor.state);
    for (const variant of VARIANTS) {
      const project = variantOf(present, variant);
      const key = solveKey(project);
      if (this.#shown[variant].key !== key && this.#refused.get(variant) !== key) return [variant, project];
    }
    return undefined;
  }

  #report(variant: Variant, refusal: Wording | null): void {
    if (refusal === null) this.#refused.delete(variant);
    if (this.#editor.state.study.refusals[variant] !== refusal)
      this.#editor.dispatch({ type: 'variant-solved', variant, refusal });
  }
}
