/** The events of `<c2-warp>` and their types, for emitters and listeners. */
import { LitElement } from 'lit';
import type { Project } from '../document/project';

/** The `detail` of each event; null if it has none. */
export interface EventDetails {
  readonly ready: null;
  readonly load: null;
  readonly play: null;
  readonly pause: null;
  readonly timeupdate: null;
  readonly ended: null;
  readonly input: { readonly project: Project };
  readonly change: { readonly project: Project };
  readonly selectionchange: { readonly selection: readonly string[] };
  readonly historychange: { readonly undo: string | null; readonly redo: string | null };
  readonly titlechange: { readonly name: string | null; readonly unsaved: boolean };
  readonly progress: { readonly label: string | null; readonly fraction: number | null };
  readonly error: Error;
}

export type EventName = keyof EventDetails;

export type C2WarpEventMap = { [T in EventName]: CustomEvent<EventDetails[T]> };

/** Events of other names keep their standard types. */
type EventMap = Omit<HTMLElementEventMap, EventName> & C2WarpEventMap;

export type Emit = <T extends EventName>(type: T, detail: EventDetails[T]) => void;

/** `input` and `change` bubble like those of form controls: some frameworks listen for these on the document. */
export const emitter =
  (element: EventTarget): Emit =>
  (type, detail) => {
    const bubbles = type === 'input' || type === 'change';
    element.dispatchEvent(new CustomEvent(type, { detail, bubbles }));
  };

type Listener<T extends keyof EventMap> = (event: EventMap[T]) => unknown;
type AnyListener = EventListenerOrEventListenerObject | null;

/** An element whose listeners get typed events. */
export abstract class TypedElement extends LitElement {
  override addEventListener<T extends keyof EventMap>(
    type: T,
    listener: Listener<T>,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: AnyListener,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: AnyListener,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener as EventListener, options);
  }

  override removeEventListener<T extends keyof EventMap>(
    type: T,
    listener: Listener<T>,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: AnyListener,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: AnyListener,
    options?: boolean | EventListenerOptions,
  ): void {
    super.removeEventListener(type, listener as EventListener, options);
  }
}
