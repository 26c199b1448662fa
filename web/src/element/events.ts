/** The events of `<c2-warp>` and their types, for emitters and listeners. */

import type { Handle, Project } from '../document/project';
import type { Origin } from '../editor/effects';
import type { ExportKind } from '../editor/export_choices';
import type { C2WarpError } from '../error';
import type { ToolName } from '../tools/machine';
import { UpdatingElement } from './updating_element';

/** The `detail` of each event; null if it has none. */
export interface EventDetails extends QuestionDetails {
  /** Fires once after each connection, when the initial content is open, absent, failed or superseded. */
  readonly ready: null;
  /** A picture is open and solved. `origin` is `page`, `person`, or `restored` for earlier work. */
  readonly load: { readonly origin: Origin };
  /** `tool` is the current tool, chosen by the page or by the user. */
  readonly toolchange: { readonly tool: ToolName };
  /** The clip starts to play. */
  readonly play: null;
  /** The clip pauses, also at its end. */
  readonly pause: null;
  /** `currentTime` has changed. Fires several times a second while the clip plays. */
  readonly timeupdate: null;
  /** The clip has played to its end. */
  readonly ended: null;
  /** During a drag. `project` is a copy of the project. @bubbles */
  readonly input: { readonly project: Project };
  /** A step was made, undone or redone, by a person or a method. `project` is a copy of the project. @bubbles */
  readonly change: { readonly project: Project };
  /** The selection has changed, for any reason. `selection` has the ids of the selected handles. */
  readonly selectionchange: { readonly selection: readonly string[] };
  /** `undo` and `redo` are labels of the next steps to undo and redo, or null. */
  readonly historychange: { readonly undo: string | null; readonly redo: string | null };
  /** `name` is the name of the open picture, or null. `unsaved`: the last changes are not saved in a file. */
  readonly titlechange: { readonly name: string | null; readonly unsaved: boolean };
  /**
   * `label` is the stage of a noticeable wait, or the export; null at its end. `fraction` is the completed fraction of
   * an export, from 0 to 1, else null.
   */
  readonly progress: { readonly label: string | null; readonly fraction: number | null };
  /** `detail` is an error that no method can throw or reject with. */
  readonly error: C2WarpError;
}

/** The events before an action of a person. If their default is prevented, the editor does nothing. */
export interface QuestionDetails {
  /**
   * A person is about to open files, by picker, drop or paste, or an address. `address` is null for files, and `files`
   * is empty for an address. @cancelable
   */
  readonly beforeopen: { readonly files: readonly File[]; readonly address: string | null };
  /** A person is about to save the project. `picture` will be included in the file, or is null. @cancelable */
  readonly beforesave: { readonly name: string; readonly project: Project; readonly picture: File | null };
  /** A person is about to export. `name` is the name of the file. @cancelable */
  readonly beforeexport: { readonly name: string; readonly kind: ExportKind };
  /** A person is about to add handles. @cancelable */
  readonly beforeadd: { readonly handles: readonly Handle[] };
  /** A person is about to remove handles. @cancelable */
  readonly beforeremove: { readonly handles: readonly Handle[] };
}

export type EventName = keyof EventDetails;

export type C2WarpEventMap = { [T in EventName]: CustomEvent<EventDetails[T]> };

/** Events of other names keep their standard types. */
type EventMap = Omit<HTMLElementEventMap, EventName> & C2WarpEventMap;

/** Returns whether the default was not prevented. */
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
