/** The commands that change the document: each is one undo step with its label, announced to screen readers. */
import { type Detail, modeOf, withBlend, withDetail, withMode } from '../document/bending';
import { type Document, handleById, isSameWork, selectedHandles } from '../document/document';
import { withLasso } from '../document/domain';
import {
  addCorner,
  changeHandles,
  holdBoundary,
  moveHandles,
  pastePose,
  putCorner,
  raiseHandles,
  removeCorner,
  removeHandles,
  resetHandles,
  selectHandles,
  turnHandles,
} from '../document/edits';
import { type PosedDocument, posedGroup } from '../document/group';
import {
  anchor,
  atDepth,
  CORNERS_NEEDED,
  depthOf,
  isLine,
  moved,
  nameOf,
  rotationOf,
  scaledTo,
  scaleOf,
  turnedTo,
  withAutoRotation,
} from '../document/handle';
import { mirrorHandles } from '../document/mirror';
import type { Domain, Handle, LineHandle, PoseMode, Project } from '../document/project';
import type { LinePlace } from '../geometry/polyline';
import type { Blend } from '../geometry/skin';
import { add, type Vec } from '../geometry/vec';
import type { Corner, Field } from '../ui/model';
import type { Editing } from './editing';
import type { Guarding } from './guarding';
import { noCounterpartText, noOtherSideText, SAME_THERE } from './notice_texts';
import type { Posing } from './posing';
import { cornerWords, depthWords, handleWords, placeWords, selectionName } from './wording';

export class EditCommands {
  readonly #editing: Editing;
  readonly #posing: Posing;
  readonly #guarding: Guarding;
  /** Announces a text. */
  readonly #say: (text: string) => void;

  constructor(editing: Editing, posing: Posing, guarding: Guarding, say: (text: string) => void) {
    this.#editing = editing;
    this.#posing = posing;
    this.#guarding = guarding;
    this.#say = say;
  }

  remove(): void {
    const { selection } = this.#document;
    if (selection.length === 0) return;
    this.#editing.step(`Delete ${selectionName(this.#document)}`, removeHandles(this.#document, selection));
  }

  /** Returns the selected handles, or all, to their rest pose. */
  reset(all: boolean): void {
    const ids = all ? this.#project.handles.map((handle) => handle.id) : this.#document.selection;
    if (!all && ids.length === 0) return;
    const label = all ? 'Reset all handles' : `Reset ${selectionName(this.#document)}`;
    this.#editing.step(label, resetHandles(this.#document, ids));
  }

  /**
   * Mirrors what is selected to the other side, which is selected then. Returns what is to be told where that was not
   * possible or has changed nothing, else null.
   */
  mirror(): string | null {
    const bounds = this.#posing.restBounds();
    const before = this.#document;
    if (!bounds || before.selection.length === 0) return null;
    const { document, unmatched } = mirrorHandles(before, bounds, (rest) => this.#posing.bends(rest));
    const goes = document.selection.some((id) => !before.selection.includes(id));
    if (goes || !isSameWork(before, document)) {
      const label = `Mirror ${selectionName(before)}`;
      this.#editing.step(label, document);
      // Counterparts that were posed so already: no step, but selected.
      this.#editing.select(document.selection);
      this.#say(`${label}. ${this.#placeWords}`);
    } else if (unmatched.length === 0) return SAME_THERE;
    return unmatched.length > 0 ? noOtherSideText(unmatched.map(nameOf)) : null;
  }

  /** Poses handles like copied ones. Returns what is to be told of those that no handle is posed like, else null. */
  paste(copied: readonly Handle[]): string | null {
    const { document, unmatched } = pastePose(this.#document, copied);
    const posed = copied.filter((handle) => !unmatched.includes(handle));
    if (posed.length > 0) this.#editing.step(`Paste the pose of ${handleWords(posed)}`, document);
    return unmatched.length > 0 ? noCounterpartText(unmatched.map(nameOf)) : null;
  }

  nudge(by: Vec): void {
    const { selection } = this.#document;
    const label = `Move ${selectionName(this.#document)}`;
    const document = moveHandles(this.#document, selection, by);
    this.#guarded(label, { document }, `nudge ${selection.join(' ')}`);
  }

  nudgeCorner(corner: Corner, by: Vec): void {
    this.#moveCorner(corner, 'nudge', (at) => add(at, by));
  }

  /** Sets a coordinate of a corner: 0 for x, 1 for y. */
  corner(corner: Corner, axis: 0 | 1, value: (now: number) => number): void {
    this.#moveCorner(corner, axis === 0 ? 'x' : 'y', ([x, y]) =>
      axis === 0 ? [value(x), y] : [x, value(y)],
    );
  }

  /** @param way moves of one corner by the same way are one undo step. */
  #moveCorner({ id, index }: Corner, way: string, to: (at: Vec) => Vec): void {
    const handle = handleById(this.#document, id);
    const at = handle && isLine(handle) ? handle.posed[index] : undefined;
    if (!handle || !at) return;
    const document = putCorner(this.#document, id, index, to(at));
    this.#guarded(`Move a corner of ${nameOf(handle)}`, { document }, `${way} ${id} ${index}`, () => {
      const moved = handleById(this.#document, id);
      return moved && isLine(moved) ? cornerWords(moved, index) : '';
    });
  }

  /** Adds a corner to a bar or polygon. Returns its index. */
  addCorner(handle: LineHandle, at: LinePlace): number {
    this.#editing.step(`Add a corner to ${nameOf(handle)}`, addCorner(this.#document, handle.id, at));
    return at.edge + 1;
  }

  /** Removes a corner if enough remain. Returns the index of the corner before it, or null if none was removed. */
  removeCorner(handle: LineHandle, index: number): number | null {
    const needed = CORNERS_NEEDED[handle.kind];
    if (handle.posed.length <= needed) {
      this.#say(`A ${handle.kind} needs ${needed} corners`);
      return null;
    }
    this.#editing.step(
      `Delete a corner of ${nameOf(handle)}`,
      removeCorner(this.#document, handle.id, index),
    );
    return Math.max(0, index - 1);
  }

  /** Brings the selected handles forward by this many depth steps; negative sends them back. */
  raise(by: number): void {
    const { selection } = this.#document;
    if (selection.length === 0) return;
    const label = `${by > 0 ? 'Bring forward' : 'Send back'} ${selectionName(this.#document)}`;
    this.#editing.commit(label, raiseHandles(this.#document, selection, by), `raise ${selection.join(' ')}`);
    this.#sayDepth();
  }

  blend(blend: Blend): void {
    const project = withBlend(this.#project, blend);
    this.#editing.step(blend === 'rigid' ? 'Keep turns rigid' : 'Blend turns linearly', {
      ...this.#document,
      project,
    });
  }

  /**
   * Lets only the inside of a ring bend, or cuts a hole there. Returns how many handles lay outside and were left out,
   * or null if the ring holds nothing of the picture.
   */
  lasso(ring: readonly Vec[], hole: boolean): number | null {
    const found = withLasso(this.#project, ring, hole);
    if (!found) return null;
    const { project, cut } = found;
    const left = this.#project.handles.length - project.handles.length;
    const document = selectHandles({ ...this.#document, project }, this.#document.selection);
    this.#editing.step(cut ? 'Cut a hole' : 'Bend what is inside', document);
    return left;
  }

  /** Lets all of the picture bend. @param domain that of the picture by itself. */
  unlasso(domain: Domain): void {
    const project = { ...this.#project, domain };
    this.#editing.step('Bend all of the picture', { ...this.#document, project });
  }

  holdBoundary(held: boolean): void {
    this.#editing.step(held ? 'Hold the boundary' : 'Free the boundary', holdBoundary(this.#document, held));
  }

  /** Turns the selected handle about its own place; scales it, or turns and scales several as one about theirs. */
  turn(by: number, scale = 1): void {
    const selected = selectedHandles(this.#document);
    const ids = this.#document.selection;
    const turns = this.#posing.turns();
    const alone = selected.length === 1 && scale === 1;
    const wanted: PosedDocument = alone
      ? { document: turnHandles(this.#document, ids, (handle) => rotationOf(handle, turns) + by) }
      : posedGroup(this.#document, by, scale);
    const verb = scale === 1 ? 'Turn' : 'Scale';
    this.#guarded(`${verb} ${handleWords(selected)}`, wanted, `${verb} ${ids.join(' ')}`);
  }

  /** Makes the rotation of the selected points automatic, or pins it as it is now. */
  automatic(on: boolean): void {
    const turns = this.#posing.turns();
    // Bars and polygons take their rotation from their corners.
    const points = selectedHandles(this.#document).filter((handle) => !isLine(handle));
    const ids = points.map((handle) => handle.id);
    const document = on
      ? changeHandles(this.#document, ids, withAutoRotation)
      : turnHandles(this.#document, ids, (handle) => rotationOf(handle, turns));
    this.#editing.step(`${on ? 'Free' : 'Pin'} the turn of ${selectionName(this.#document)}`, document);
  }

  /** Changes the pose mode, with the settings that belong to it. */
  bend(mode: PoseMode): void {
    if (mode === modeOf(this.#project)) return;
    const label = mode === 'rigid' ? 'Bend rigidly' : 'Bend smoothly';
    const last = this.#editing.last((project) => modeOf(project) === mode);
    this.#editing.step(label, { ...this.#document, project: withMode(this.#project, mode, last) });
  }

  detail(detail: Detail): void {
    this.#editing.step(`Set detail to ${detail}`, {
      ...this.#document,
      project: withDetail(this.#project, detail),
    });
  }

  /** Sets one field of every selected handle, computed from its current value. */
  field(field: Field, value: (now: number) => number): void {
    const turns = this.#posing.turns();
    const further = (now: number) => value(now) - now;
    const set: Readonly<Record<Field, (handle: Handle) => Handle>> = {
      x: (handle) => moved(handle, [further(anchor(handle)[0]), 0]),
      y: (handle) => moved(handle, [0, further(anchor(handle)[1])]),
      rotation: (handle) => turnedTo(handle, value(rotationOf(handle, turns))),
      scale: (handle) => scaledTo(handle, value(scaleOf(handle))),
      depth: (handle) => atDepth(handle, value(depthOf(handle))),
    };
    const { selection } = this.#document;
    const document = changeHandles(this.#document, selection, set[field]);
    const label = `Set ${field} of ${selectionName(this.#document)}`;
    this.#guarded(label, { document }, `${field} ${selection.join(' ')}`);
    if (field === 'depth') this.#sayDepth();
  }

  /**
   * Commits a change as far as the guard against folds allows, and announces the result.
   * @param words the result: by default the pose of what is selected.
   */
  #guarded(label: string, wanted: PosedDocument, key: string, words = () => this.#placeWords): void {
    const document = this.#guarding.limited(this.#document, wanted);
    if (document === this.#document && this.#guarding.holding) {
      this.#say('Stopped: more would fold the picture');
      return;
    }
    this.#editing.commit(label, document, key);
    this.#say(words());
  }

  get #placeWords(): string {
    return placeWords(this.#document, this.#posing.turns());
  }

  #sayDepth(): void {
    const words = depthWords(this.#document);
    if (words !== null) this.#say(words);
  }

  get #document(): Document {
    return this.#editing.document;
  }

  get #project(): Project {
    return this.#editing.project;
  }
}
