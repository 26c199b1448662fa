/** The stage on the page: its size, the input on it, and places on it. */

import type { Dispatch } from '../editor/events';
import type { EditorState } from '../editor/state';
import { toImage, toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { KeyboardInput } from '../input/keyboard';
import { PointerInput } from '../input/pointer';
import { clientToStage, stageToClient } from '../ui/client';
import type { Focus } from './focus';

export interface CanvasViewHost {
  readonly state: EditorState;
  readonly dispatch: Dispatch;
  readonly focus: Focus;
}

export class CanvasView {
  readonly #root: ShadowRoot;
  readonly #stage: HTMLElement;
  readonly #host: CanvasViewHost;
  readonly #observer: ResizeObserver;
  #pointer: PointerInput;
  #keyboard: KeyboardInput;

  constructor(root: ShadowRoot, stage: HTMLElement, host: CanvasViewHost) {
    this.#root = root;
    this.#stage = stage;
    this.#host = host;
    this.#observer = new ResizeObserver(([entry]) => entry && this.#resized(entry.contentRect));
    this.#observer.observe(stage);
    this.measure();
    [this.#pointer, this.#keyboard] = this.#listen();
  }

  /** The place of the picture, image pixels, at a place in the window. */
  imageAt(client: Vec): Vec {
    return toImage(this.#host.state.view.camera, clientToStage(this.#stage, client));
  }

  /** The place in the window of a place of the picture, image pixels. */
  clientAt(image: Vec): Vec {
    return stageToClient(this.#stage, toStage(this.#host.state.view.camera, image));
  }

  /** Takes the size of the stage. */
  measure(): void {
    const { clientWidth: width, clientHeight: height } = this.#stage;
    this.#resized({ width, height });
  }

  /** Adapts to the current `play` and `readonly`. */
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
    const host = this.#host;
    const { dispatch, focus } = host;
    const pointer = {
      get state() {
        return host.state;
      },
      dispatch,
      leaveField: () => focus.leaveField(),
    };
    const owner = host.state.page.playing ? 'page' : 'editor';
    return [new PointerInput(this.#stage, pointer, owner), new KeyboardInput(this.#root, host)];
  }

  #resized({ width, height }: { readonly width: number; readonly height: number }): void {
    const typing = this.#host.focus.isInField;
    this.#host.dispatch({ type: 'stage-resized', size: { width, height }, typing });
  }
}
