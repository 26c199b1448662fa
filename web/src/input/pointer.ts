/**
 * Turns the pointers and the wheel on a stage into events: presses of a tool and moves of the camera.
 *
 * One pointer works the tool. With space, the middle button or a second finger it navigates instead. A second finger
 * cancels the press of the first: two fingers never edit. A right click or a long press opens the menu. If that finger
 * then moves, its press continues.
 *
 * While a pen is near, touches are those of the hand that holds it, and count for nothing.
 *
 * With the owner `page`, the page keeps all gestures that hold no handle: it scrolls, zooms, and shows its own menu.
 * Places are CSS pixels of the stage, at any scale of the page.
 */

import type { EditorAccess } from '../editor/access';
import { holdsAt } from '../editor/hit_areas';
import type { StagePointer } from '../editor/stage_pointer';
import { opensMenu } from '../editor/update/menu';
import { type Camera, panned, pinched } from '../geometry/camera';
import { distance, subtract, type Vec } from '../geometry/vec';
import { clientToStage } from '../ui/client';
import { type Click, isDoubleClick } from './double_click';
import { wheeled } from './wheel';

/** A press that moves farther than this is a drag, here as in the tools. CSS pixels. */
const SLIP = { fine: 3, coarse: 8 } as const;

/** A finger that rests for this long opens the menu, as elsewhere on phones. */
const HOLD_MS = 500;

/** Who receives the gestures that hold nothing. */
export type Owner = 'editor' | 'page';

/** Once the browser has begun to scroll, its touch events cannot be cancelled. */
const prevent = (event: Event): void => {
  if (event.cancelable) event.preventDefault();
};

export class PointerInput {
  readonly #stage: HTMLElement;
  readonly #editor: EditorAccess;
  readonly #leaveField: () => void;
  readonly #owner: Owner;
  readonly #listening = new AbortController();
  readonly #fingers = new Map<number, Vec>();
  #pressing: number | null = null;
  /** The bit of `PointerEvent.buttons` that holds the press. */
  #button = 1;
  /** Where the current press began, null if it pans. `#clicked` is where and when the last click ended. */
  #begun: Vec | null = null;
  /** Where a press that is left to the page began. */
  #beside: Vec | null = null;
  #clicked: Click | null = null;
  #navigating = false;
  /** Whether a pen is on the stage, or hovers over it. */
  #penIsNear = false;
  #holding: ReturnType<typeof setTimeout> | undefined;
  /** The start of the press that opened the menu, until it moves or ends. */
  #stayed: { readonly id: number; readonly pointer: StagePointer } | null = null;

  /** @param leaveField commits a number that is being typed, before a press changes the selection it belongs to. */
  constructor(stage: HTMLElement, editor: EditorAccess, owner: Owner, leaveField: () => void) {
    this.#stage = stage;
    this.#editor = editor;
    this.#leaveField = leaveField;
    this.#owner = owner;
    const { signal } = this.#listening;
    stage.addEventListener('pointerdown', (event) => this.#down(event), { signal });
    stage.addEventListener('pointermove', (event) => this.#move(event), { signal });
    stage.addEventListener('pointerup', (event) => this.#up(event), { signal });
    stage.addEventListener('pointercancel', (event) => this.#cancel(event), { signal });
    stage.addEventListener('pointerenter', (event) => this.#enter(event), { signal });
    stage.addEventListener('pointerleave', (event) => this.#exit(event), { signal });
    stage.addEventListener('contextmenu', (event) => this.#menu(event), { signal });
    if (owner === 'page') {
      stage.addEventListener('touchstart', (event) => this.#keep(event), { signal, passive: false });
      return;
    }
    // Otherwise a click follows, on any control that the press has opened under the finger.
    stage.addEventListener('touchend', (event) => prevent(event), { signal, passive: false });
    stage.addEventListener('wheel', (event) => this.#wheel(event), { signal, passive: false });
  }

  dispose(): void {
    clearTimeout(this.#holding);
    this.#listening.abort();
  }

  #enter({ pointerType }: PointerEvent): void {
    if (pointerType === 'pen') this.#penIsNear = true;
  }

  #exit({ pointerType }: PointerEvent): void {
    if (pointerType === 'pen') this.#penIsNear = false;
    this.#editor.dispatch({ type: 'pointer-hovered', pointer: null });
  }

  #down(event: PointerEvent): void {
    if (event.pointerType === 'touch' && this.#penIsNear) {
      event.preventDefault();
      return;
    }
    clearTimeout(this.#holding);
    const palmStayed = this.#stayed?.pointer.coarse === true;
    this.#stayed = null;
    if (event.pointerType === 'pen') this.#takePen();
    // One that was prevented has closed a menu. A pen continues if its palm has opened it.
    if (event.defaultPrevented && !(event.pointerType === 'pen' && palmStayed)) return;
    // The focus stays where it was while the menu is open.
    if (event.button === 2 && this.#owner === 'editor') event.preventDefault();
    if (event.button > 1) return;
    if (this.#isOfPage(event)) {
      this.#leave(event);
      return;
    }
    // A handle's button would otherwise start a text selection, or take the focus from where the editor puts it.
    event.preventDefault();
    this.#stage.setPointerCapture(event.pointerId);
    if (event.pointerType === 'touch') this.#fingers.set(event.pointerId, this.#place(event));
    if (this.#fingers.size > 1) {
      if (this.#pressing !== null) this.#editor.dispatch({ type: 'press-cancelled' });
      this.#pressing = null;
      this.#clicked = null;
      this.#navigating = true;
      return;
    }
    if (this.#pressing !== null) return;
    this.#pressing = event.pointerId;
    this.#button = event.button === 1 ? 4 : 1;
    const pans = this.#editor.state.pointer.space || event.button === 1;
    this.#begun = pans ? null : this.#place(event);
    const pointer = this.#pointer(event);
    this.#press(pointer, pans);
    if (event.pointerType !== 'mouse' && !pans)
      this.#holding = setTimeout(() => this.#stay(event.pointerId, pointer), HOLD_MS);
  }

  /** Forgets the touches before a pen: those of its palm. They end without an effect. */
  #takePen(): void {
    this.#penIsNear = true;
    if (this.#pressing !== null && this.#fingers.has(this.#pressing)) {
      this.#editor.dispatch({ type: 'press-cancelled' });
      this.#pressing = null;
    }
    this.#fingers.clear();
    this.#beside = null;
    this.#navigating = false;
  }

  #stay(id: number, pointer: StagePointer): void {
    if (this.#openMenu(pointer, true)) this.#stayed = { id, pointer };
  }

  /** Continues a press that has opened the menu, if it moves far enough for a drag. */
  #goOn({ pointerId }: PointerEvent, pointer: StagePointer): void {
    const stayed = this.#stayed;
    if (stayed?.id !== pointerId || !this.#slips(stayed.pointer.stage, pointer)) return;
    this.#stayed = null;
    this.#pressing = pointerId;
    this.#press(stayed.pointer, false);
  }

  #slips(begun: Vec, pointer: StagePointer): boolean {
    return distance(begun, pointer.stage) > (pointer.coarse ? SLIP.coarse : SLIP.fine);
  }

  #move(event: PointerEvent): void {
    const pointer = this.#pointer(event);
    const isPress = () => event.pointerId === this.#pressing;
    if (isPress() && this.#begun && this.#slips(this.#begun, pointer)) clearTimeout(this.#holding);
    this.#goOn(event, pointer);
    if (this.#navigating && this.#fingers.has(event.pointerId)) {
      this.#navigate(event);
    } else if (isPress()) {
      // The release was missed, or came while another button was held.
      if (event.pointerType === 'mouse' && !(event.buttons & this.#button)) this.#up(event);
      else this.#editor.dispatch({ type: 'press-moved', pointer });
    } else if (event.pointerType !== 'touch') {
      this.#editor.dispatch({ type: 'pointer-hovered', pointer });
    }
  }

  #up(event: PointerEvent): void {
    this.#lift(event);
    const pointer = this.#pointer(event);
    if (this.#beside && !this.#slips(this.#beside, pointer)) this.#editor.dispatch({ type: 'page-clicked' });
    this.#beside = null;
    if (event.pointerId !== this.#pressing) return;
    this.#pressing = null;
    const { tool } = this.#editor.state.tools;
    this.#editor.dispatch({ type: 'press-ended', pointer });
    if (
      this.#owner === 'editor' &&
      this.#isSecond(pointer, { place: pointer.stage, time: event.timeStamp, tool })
    )
      this.#editor.dispatch({ type: 'double-pressed', pointer });
  }

  /** Whether a press that ends now makes a double click with the one before; of three presses, only the second does. */
  #isSecond(pointer: StagePointer, click: Click): boolean {
    const isClick = this.#begun !== null && !this.#slips(this.#begun, pointer);
    const second = isClick && isDoubleClick(this.#clicked, click, pointer.coarse);
    this.#clicked = isClick && !second ? click : null;
    return second;
  }

  /** Whether the page receives a press: with the owner `page`, by other buttons or fingers, or beside handles. */
  #isOfPage(event: PointerEvent): boolean {
    if (this.#owner === 'editor') return false;
    return event.button !== 0 || this.#pressing !== null || !this.#holds(this.#pointer(event));
  }

  #leave(event: PointerEvent): void {
    if (this.#pressing !== null) this.#editor.dispatch({ type: 'press-cancelled' });
    this.#beside = event.button === 0 && this.#pressing === null ? this.#place(event) : null;
    this.#pressing = null;
  }

  /** Prevents a finger that holds something from scrolling. */
  #keep(event: TouchEvent): void {
    if (this.#pressing !== null) prevent(event);
  }

  #cancel(event: PointerEvent): void {
    this.#lift(event);
    this.#beside = null;
    if (event.pointerId !== this.#pressing) return;
    this.#pressing = null;
    this.#clicked = null;
    this.#editor.dispatch({ type: 'press-cancelled' });
  }

  /**
   * Opens the menu instead of the browser's, except with Shift. A finger's is a matter of `#holding`: few phones send
   * this event. A press in progress continues, except with Ctrl, which is a right click on a Mac.
   */
  #menu(event: MouseEvent): void {
    if (event.shiftKey) return;
    const busy = this.#fingers.size > 0 || (this.#pressing !== null && !event.ctrlKey);
    if (this.#owner === 'editor' || busy) event.preventDefault();
    if (!busy && this.#openMenu(this.#pointer(event), false)) event.preventDefault();
  }

  #openMenu(pointer: StagePointer, staying: boolean): boolean {
    const { state, dispatch } = this.#editor;
    if (!opensMenu(state, pointer, staying)) return false;
    this.#leaveField();
    dispatch({ type: 'menu-asked', pointer, resting: staying });
    clearTimeout(this.#holding);
    this.#pressing = null;
    this.#clicked = null;
    return true;
  }

  #lift(event: PointerEvent): void {
    if (event.pointerId === this.#pressing) clearTimeout(this.#holding);
    if (this.#stayed?.id === event.pointerId) this.#stayed = null;
    this.#fingers.delete(event.pointerId);
    if (this.#fingers.size === 0) this.#navigating = false;
  }

  #navigate(event: PointerEvent): void {
    const before = [...this.#fingers.values()];
    this.#fingers.set(event.pointerId, this.#place(event));
    const after = [...this.#fingers.values()];
    const { camera } = this.#editor.state.view;
    const [a, b] = before;
    const [c, d] = after;
    if (a && b && c && d) this.#look(pinched(camera, [a, b], [c, d]));
    else if (a && c) this.#look(panned(camera, subtract(c, a)));
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    this.#look(wheeled(this.#editor.state.view.camera, event, this.#place(event)));
    // Keeps a dragged handle under the pointer.
    if (this.#pressing !== null)
      this.#editor.dispatch({ type: 'press-moved', pointer: this.#pointer(event) });
  }

  #press(pointer: StagePointer, pans: boolean): void {
    this.#leaveField();
    this.#editor.dispatch({ type: 'press-began', pointer, pans });
  }

  /** Whether a press there would hold something. */
  #holds(pointer: StagePointer): boolean {
    this.#editor.dispatch({ type: 'pointer-noted', coarse: pointer.coarse });
    return holdsAt(this.#editor.state, pointer);
  }

  #look(camera: Camera): void {
    this.#editor.dispatch({ type: 'camera-moved', camera });
  }

  #place(event: MouseEvent): Vec {
    return clientToStage(this.#stage, [event.clientX, event.clientY]);
  }

  #pointer(event: MouseEvent): StagePointer {
    return {
      stage: this.#place(event),
      shift: event.shiftKey,
      alt: event.altKey,
      free: event.ctrlKey || event.metaKey,
      coarse: (event as Partial<PointerEvent>).pointerType === 'touch',
    };
  }
}
