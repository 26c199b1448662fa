/**
 * An element that renders a template in its shadow root, once after all changes in a task.
 *
 * Properties reflect attributes at once. A property that a page set before the element was defined is set again when
 * the element is connected, after the attributes.
 */
import { type RootPart, render } from 'lit-html';
import { AnyElement } from './html_element';
import { attributeOf, type Properties, propertiesByAttribute, taken, textOf, valueFrom } from './properties';
import { dress } from './style_sheets';

/** Names of changed properties. */
export type Changes = ReadonlySet<string>;

export abstract class UpdatingElement extends AnyElement {
  /** @internal */
  static readonly properties: Properties = {};
  /** @internal Further properties, which a page may set before the element is defined. */
  static readonly accessors: readonly string[] = [];
  /** @internal */
  static readonly styles: readonly string[] = [];

  /** The browser reads this when it defines the element. */
  static get observedAttributes(): string[] {
    // biome-ignore lint/complexity/noThisInStatic: each element has properties of its own.
    return UpdatingElement.#observed(this);
  }

  /** Of properties without an attribute. */
  readonly #values = new Map<string, unknown>();
  /** Values that the page set before the element was defined. */
  #early: Readonly<Record<string, unknown>>;
  #changes = new Set<string>();
  #part: RootPart | undefined;
  #isPending = false;
  #hasUpdated = false;
  readonly #connected: () => void;
  #update: Promise<void>;

  constructor() {
    super();
    this.#early = taken(this, [...Object.keys(this.#properties), ...this.#accessors]);
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
    Object.assign(this, this.#early);
    this.#early = {};
    this.#connected();
  }

  disconnectedCallback(): void {
    this.#part?.setConnected(false);
  }

  /** Called when the element is moved to another document. */
  adoptedCallback(): void {
    if (this.shadowRoot) dress(this.shadowRoot, this.#styles);
  }

  attributeChangedCallback(attribute: string, before: string | null, text: string | null): void {
    const name = propertiesByAttribute(this.#properties).get(attribute);
    if (name !== undefined && before !== text) this.propertyChanged(name);
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
  protected propertyChanged(name: string): void {
    this.#changes.add(name);
    this.requestUpdate();
  }

  /** @internal A template of lit-html. */
  protected abstract render(): unknown;
  /** @internal Its changes cause another update. */
  protected abstract updated(changes: Changes): void;

  get #properties(): Properties {
    return (this.constructor as typeof UpdatingElement).properties;
  }

  get #accessors(): readonly string[] {
    return (this.constructor as typeof UpdatingElement).accessors;
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
      const template = this.render();
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
    this.#changes = new Set();
    this.#isPending = false;
  }

  /** Defines the accessors of an element's properties, and returns its attributes. */
  static #observed({ prototype, properties }: typeof UpdatingElement): string[] {
    for (const [name, options] of Object.entries(properties)) {
      const attribute = attributeOf(properties, name);
      Object.defineProperty(prototype, name, {
        configurable: true,
        enumerable: true,
        get(this: UpdatingElement) {
          if (attribute === null) return this.#values.get(name) ?? options.initial;
          return valueFrom(options, this.getAttribute(attribute), this.baseURI);
        },
        set(this: UpdatingElement, value: unknown) {
          if (attribute === null) {
            this.#values.set(name, value);
            this.propertyChanged(name);
            return;
          }
          const text = textOf(options, value);
          if (text === null) this.removeAttribute(attribute);
          else this.setAttribute(attribute, text);
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
