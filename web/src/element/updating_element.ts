/**
 * An element that renders a template in its shadow root, once after all changes in a task.
 *
 * Properties mirror attributes. A property set before the element was defined is set again at the first update, after
 * the attributes.
 */
import { type RootPart, render } from 'lit-html';
import { AnyElement } from './html_element';
import { attributeOf, type Properties, propertiesByAttribute, taken, textOf, valueFrom } from './properties';
import { dress } from './style_sheets';

/** Names of changed properties, with their previous values. */
export type Changes = ReadonlyMap<string, unknown>;

export abstract class UpdatingElement extends AnyElement {
  /** @internal */
  static readonly properties: Properties = {};
  /** @internal */
  static readonly styles: readonly string[] = [];

  /** The browser reads this when it defines the element. */
  static get observedAttributes(): string[] {
    // biome-ignore lint/complexity/noThisInStatic: each element has properties of its own.
    return UpdatingElement.#observed(this);
  }

  readonly #values = new Map<string, unknown>();
  /** Values that the page set before the element was defined. */
  readonly #early: Readonly<Record<string, unknown>>;
  #changes = new Map<string, unknown>();
  readonly #reflected = new Set<string>();
  /** The property that is being set by its attribute, or vice versa. */
  #mirrored: string | null = null;
  #part: RootPart | undefined;
  #isPending = false;
  #hasUpdated = false;
  readonly #connected: () => void;
  #update: Promise<void>;

  constructor() {
    super();
    this.#early = taken(this, Object.keys(this.#properties));
    const { promise, resolve } = settled();
    this.#update = promise;
    this.#connected = resolve;
    this.requestUpdate();
  }

  /** Resolves once the element shows all changes so far. Rejects if it cannot. */
  get updateComplete(): Promise<void> {
    return this.#update;
  }

  connectedCallback(): void {
    if (!this.shadowRoot) dress(this.attachShadow({ mode: 'open' }), this.#styles);
    this.#part?.setConnected(true);
    this.#connected();
  }

  disconnectedCallback(): void {
    this.#part?.setConnected(false);
  }

  /** Called when the element is moved to another document. */
  adoptedCallback(): void {
    if (this.shadowRoot) dress(this.shadowRoot, this.#styles);
  }

  attributeChangedCallback(attribute: string, _: string | null, text: string | null): void {
    const name = propertiesByAttribute(this.#properties).get(attribute);
    const options = name === undefined ? undefined : this.#properties[name];
    if (name === undefined || !options || name === this.#mirrored) return;
    this.#mirror(name, () => Reflect.set(this, name, valueFrom(options, text)));
  }

  /** @internal */
  protected get hasUpdated(): boolean {
    return this.#hasUpdated;
  }

  /** @internal */
  protected requestUpdate(): void {
    if (this.#isPending) return;
    this.#isPending = true;
    this.#update = this.#updateAfter(this.#update);
  }

  /** @internal */
  protected propertyChanged(name: string, before: unknown): void {
    if (!this.#changes.has(name)) this.#changes.set(name, before);
    if (this.#properties[name]?.reflect && name !== this.#mirrored) this.#reflected.add(name);
    this.requestUpdate();
  }

  /** @internal Its changes belong to the current update. */
  protected abstract willUpdate(changes: Changes): void;
  /** @internal A template of lit-html. */
  protected abstract render(): unknown;
  /** @internal Its changes cause another update. */
  protected abstract updated(changes: Changes): void;

  get #properties(): Properties {
    return (this.constructor as typeof UpdatingElement).properties;
  }

  get #styles(): readonly string[] {
    return (this.constructor as typeof UpdatingElement).styles;
  }

  /** @param before the previous update, which reports its failure to its own listeners. */
  async #updateAfter(before: Promise<void>): Promise<void> {
    // One turn of the queue: what waits for the update in a microtask comes after it.
    try {
      await before;
    } catch {}
    const changes = this.#changes;
    try {
      if (!this.#hasUpdated) Object.assign(this, this.#early);
      this.willUpdate(changes);
      const template = this.render();
      this.#reflect();
      this.#settle();
      if (this.shadowRoot)
        this.#part = render(template, this.shadowRoot, { host: this, isConnected: this.isConnected });
    } catch (error) {
      this.#settle();
      throw error;
    }
    this.#hasUpdated = true;
    this.updated(changes);
  }

  #settle(): void {
    this.#changes = new Map();
    this.#isPending = false;
  }

  #reflect(): void {
    for (const name of this.#reflected) {
      const attribute = attributeOf(this.#properties, name);
      if (attribute === null) continue;
      const text = textOf(this.#properties[name] ?? {}, this.#values.get(name));
      this.#mirror(name, () => {
        if (text === null) this.removeAttribute(attribute);
        else this.setAttribute(attribute, text);
      });
    }
    this.#reflected.clear();
  }

  #mirror(name: string, set: () => void): void {
    this.#mirrored = name;
    set();
    this.#mirrored = null;
  }

  /** Defines the accessors of an element's properties, and returns its attributes. */
  static #observed({ prototype, properties }: typeof UpdatingElement): string[] {
    for (const name of Object.keys(properties)) {
      Object.defineProperty(prototype, name, {
        configurable: true,
        enumerable: true,
        get(this: UpdatingElement) {
          return this.#values.get(name);
        },
        set(this: UpdatingElement, value: unknown) {
          const before = this.#values.get(name);
          if (Object.is(value, before)) return;
          this.#values.set(name, value);
          this.propertyChanged(name, before);
        },
      });
    }
    return [...propertiesByAttribute(properties).keys()];
  }
}

/** A promise with the function that resolves it. */
function settled(): { promise: Promise<void>; resolve: () => void } {
  let resolve = () => {};
  const promise = new Promise<void>((done) => {
    resolve = done;
  });
  return { promise, resolve };
}
