/** What people may do now, by the attributes `readonly`, `disabled` and `play` and by whether a picture is open. */
import type { Workbench } from './workbench';

/** The attributes of the element, as they are now. */
export interface Attributes {
  readonly readonly: boolean;
  readonly disabled: boolean;
  readonly play: boolean;
}

export class Permissions {
  readonly #attributes: Attributes;
  readonly #workbench: Workbench;

  constructor(attributes: Attributes, workbench: Workbench) {
    this.#attributes = attributes;
    this.#workbench = workbench;
  }

  /** People can look, pan and zoom, but change nothing. */
  get readonly(): boolean {
    return this.#attributes.readonly;
  }

  /** People can do nothing. */
  get disabled(): boolean {
    return this.#attributes.disabled;
  }

  /** Handles can only be posed, and gestures and keys of the view are left to the page. */
  get playing(): boolean {
    return this.#attributes.play;
  }

  /** Whether people may open and change something. */
  get changing(): boolean {
    return !this.readonly && !this.disabled;
  }

  /** Whether people may change the open document. */
  get editable(): boolean {
    return this.changing && this.#workbench.picture !== null;
  }
}
