/** The events of `<c2-warp>` and their types, for emitters and listeners. */

import type { Handle, Project } from '../document/project';
import type { Origin } from '../editor/effects';
import type { ExportKind } from '../editor/export_choices';
import type { C2WarpError } from '../error';
import type { ToolName } from '../tools/machine';
import { UpdatingElement } from './updating_element';

/** The `detail` of each event; null if it has none. */
export interface EventDetails extends QuestionDetails {
  readonly ready: null;
  readonly load: { readonly origin: Origin };
  readonly toolchange: { readonly tool: ToolName };
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
  readonly error: C2WarpError;
}

/** The events that come before an act of a person. Without their default the editor does nothing. */
export interface QuestionDetails {
  /** `address` is null for files, and the files are none for an address. */
  readonly beforeopen: { readonly files: readonly File[]; readonly address: string | null };
  /** `picture` is to be in the file too, or is null. */
  readonly beforesave: { readonly name: string; readonly project: Project; readonly picture: File | null };
  readonly beforeexport: { readonly name: string; readonly kind: ExportKind };
  readonly beforeadd: { readonly handles: readonly Handle[] };
  readonly beforeremove: { readonly handles: readonly Handle[] };
}

export type EventName = keyof EventDetails;

export type C2WarpEventMap = { [T in EventName]: CustomEvent<EventDetails[T]> };

/** Events of other names keep their standard types. */
type EventMap = Omit<HTMLElementEventMap, EventName> & C2WarpEventMap;

/** Returns whether nobody has prevented the default. */
export type Emit = <T extends EventName>(type: T, detail: EventDetails[T]) => boolean;

/** `input` and `change` bubble like those of form controls: some frameworks listen for these on the document. */
export const emitter =
  (element: EventTarget): Emit =>
  (type, detail) => {
    const bubbles = type === 'input' || type === 'change';
    const cancelable = type.startsWith('before');
    return element.dispatchEvent(new CustomEvent(type, { detail, bubbles, cancelable }));
  };

type Listener<T extends keyof EventMap> = (event: EventMap[T]) => unknown;
type AnyListener = EventListenerOrEventListenerObject | null;

/** An element whose listeners get typed events. */
export abstract class TypedElement extends UpdatingElement {
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
