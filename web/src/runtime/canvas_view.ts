/** The stage on the page: its size, the input on it, and places on it. */

import type { EditorAccess } from '../editor/access';
import { toImage, toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { KeyboardInput } from '../input/keyboard';
import { PointerInput } from '../input/pointer';
import { clientToStage, stageToClient } from '../ui/client';
import type { Focus } from './focus';

export class CanvasView {
  readonly #root: ShadowRoot;
  readonly #stage: HTMLElement;
  readonly #editor: EditorAccess;
  readonly #focus: Focus;
  readonly #observer: ResizeObserver;
  #pointer: PointerInput;
  #keyboard: KeyboardInput;

  constructor(root: ShadowRoot, stage: HTMLElement, editor: EditorAccess, focus: Focus) {
    this.#root = root;
    this.#stage = stage;
    this.#editor = editor;
    this.#focus = focus;
    this.#observer = new ResizeObserver(([entry]) => entry && this.#resized(entry.contentRect));
    this.#observer.observe(stage);
    this.measure();
    [this.#pointer, this.#keyboard] = this.#listen();
  }

  /** The place of the picture, image pixels, at a place in the window. */
  imageAt(client: Vec): Vec {
    return toImage(this.#editor.state.view.camera, clientToStage(this.#stage, client));
  }

  /** The place in the window of a place of the picture, image pixels. */
  clientAt(image: Vec): Vec {
    return stageToClient(this.#stage, toStage(this.#editor.state.view.camera, image));
  }

  /** Takes the size of the stage. */
  measure(): void {
    const { clientWidth: width, clientHeight: height } = this.#stage;
    this.#resized({ width, height });
  }

  /** Adapts to the current `posable` and `readonly`. */
  rearrange(): void {
    this.#pointer.dispose();
    this.#keyboard.dispose();
    [this.#pointer, this.#keyboard] = this.#listen();
    this.measure();
  }

  dispose(): void {
    this.#observer.disconnect();
    this.#pointer.dispose();
    this.#keyboard.dispose();
  }

  #listen(): [PointerInput, KeyboardInput] {
    const editor = this.#editor;
    const owner = editor.state.page.posable ? 'page' : 'editor';
    const pointer = new PointerInput(this.#stage, editor, owner, () => this.#focus.leaveField());
    return [pointer, new KeyboardInput(this.#root, editor)];
  }

  #resized({ width, height }: { readonly width: number; readonly height: number }): void {
    const typing = this.#focus.isInField;
    this.#editor.dispatch({ type: 'stage-resized', size: { width, height }, typing });
  }
}
