/** The data that the templates show, and the actions that they call. The element owns the state; none is kept here. */
import type { Detail } from '../document/bending';
import type { Document } from '../document/document';
import type { Turns } from '../document/handle';
import type { PoseMode } from '../document/project';
import type { Box } from '../geometry/box';
import type { Camera, Size } from '../geometry/camera';
import type { Blend } from '../geometry/skin';
import type { Vec } from '../geometry/vec';
import type { ToolName } from '../tools/machine';
import type { Draft, Grips } from '../tools/state';
import type { BareView, CommandName } from './commands';
import type { FoldedMesh, OverlayFlags, SiteGraph } from './overlays';

export interface EditorModel {
  readonly document: Document;
  readonly turns: Turns;
  readonly picture: PictureLabel | null;
  /** A picture is being opened. */
  readonly opening: boolean;
  readonly tool: ToolName;
  readonly readonly: boolean;
  /** Shows only the picture and its handles, or only the picture where `readonly`. */
  readonly playing: boolean;
  readonly disabled: boolean;
  readonly camera: Camera;
  /** CSS pixels. */
  readonly stage: Size;
  readonly grips: Grips;
  /** A press on the stage is in progress. */
  readonly pressing: boolean;
  /** The word for a short press: fingers tap. */
  readonly press: 'click' | 'tap';
  readonly undo: string | null;
  readonly redo: string | null;
  readonly solved: SolvedLabel | null;
  /** The running task, once it has taken long enough to be shown. */
  readonly progress: Progress | null;
  readonly notice: Notice | null;
  readonly hint: Hint | null;
  readonly announcement: string;
  /** What is shown alone, without handles and overlays: the original, or the posed picture. */
  readonly bare: BareView | null;
  readonly overlays: OverlayFlags;
  readonly sites: SiteGraph | null;
  /** Pieces × 2 ends × 2: the borders between cells, while they are to be shown and are known. */
  readonly borders: Float32Array | null;
  /** Triangles that have turned over, while they are to be shown. */
  readonly folded: FoldedMesh | null;
  /** The number of triangles that have turned over. */
  readonly folds: number;
  /** Part of the posed picture lies beyond the picture's frame, which bounds the export. */
  readonly beyond: boolean;
  /** `guarded`: the guard against folds is on. `holding`: it holds a drag back now. */
  readonly guarded: boolean;
  /** Whether the picture is drawn as pixel art; null where it is too large for that. */
  readonly pixelated: boolean | null;
  readonly holding: boolean;
  /** The corner in hand, of the only selected handle. */
  readonly corner: number | null;
  /** Open on a small screen: the settings of the whole picture; the numbers of the selected handles. */
  readonly settings: boolean;
  readonly numbers: boolean;
  /** The open context menu. */
  readonly menu: Menu | null;
  /** The line being drawn with the current tool. */
  readonly draft: Draft | null;
  /** Unfinished lines of the other tools. */
  readonly waiting: readonly Draft[];
  readonly box: Box | null;
  /** Where the keyboard would place a handle, image pixels. */
  readonly crosshair: Vec | null;
  readonly cursor: string;
  readonly platform: string;
  /** What the picture shows, in the words of the page. */
  readonly alt: string | null;
  /** The colours in use, so that the switch can offer the others. */
  readonly dark: boolean;
}

/** A hint shown until the first change, and the place of the picture that it points to. */
export interface Hint {
  readonly text: string;
  readonly at: Vec;
  /** Shown above the place, since there is no room to the right of it. */
  readonly above: boolean;
}

export interface PictureLabel extends Size {
  readonly name: string;
}

export interface SolvedLabel {
  readonly samples: number;
  readonly virtualSites: number;
  readonly ms: number;
}

export interface Progress {
  readonly label: string;
  /** Cancels the task; null where it cannot be cancelled. */
  readonly cancel: (() => void) | null;
}

export interface Notice {
  readonly kind: 'error' | 'info';
  readonly text: string;
  /** `reads`: it changes nothing, and is there for who may change nothing. */
  readonly action?: { readonly label: string; readonly reads?: true; run(): void };
  /** With an action that can be had again, or is no edit: gives way as if it had none. */
  readonly passes?: true;
  /** It is about the last step: others about that join it, and the next step ends it. */
  readonly ofStep?: true;
}

/** A corner of a bar or polygon, counted from 0. */
export interface Corner {
  readonly id: string;
  readonly index: number;
}

/** What a context menu is about. */
export interface Menu {
  readonly name: string;
  /** The selected handles, or the picture. */
  readonly about: 'handles' | 'picture';
  /** Of the handles, the one corner that it was asked for on. */
  readonly corner: Corner | null;
  /** Where it was asked for, image pixels, and whether that place can hold a point handle. */
  readonly at: Vec;
  readonly bends: boolean;
}

/** A number of the selected handles that the panel can set. */
export type Field = 'x' | 'y' | 'rotation' | 'scale' | 'depth';

export interface EditorActions {
  run(command: CommandName): void;
  /** Closes the context menu and runs one of its commands, or none. */
  ofMenu(command: CommandName | null): void;
  showBare(view: BareView | null): void;
  overlay(name: keyof OverlayFlags, on: boolean): void;
  /** Sets a number of each selected handle, from its current value. */
  field(field: Field, value: (now: number) => number): void;
  /** Sets a coordinate of the corner in hand: 0 for x, 1 for y. */
  corner(axis: 0 | 1, value: (now: number) => number): void;
  automatic(on: boolean): void;
  bend(mode: PoseMode): void;
  detail(detail: Detail): void;
  /** Lets all of the picture bend again. */
  unlasso(): void;
  holdBoundary(held: boolean): void;
  /** Sets how motions blend. */
  blend(blend: Blend): void;
  /** Sets whether drags stop where they would fold the picture. */
  guard(on: boolean): void;
  /** Sets whether the picture is drawn as pixel art. */
  pixelate(on: boolean): void;
  /** `finish` completes the line being drawn; `back` removes its last corner. */
  finish(): void;
  back(): void;
  settings(on: boolean): void;
  numbers(on: boolean): void;
  select(ids: readonly string[]): void;
  toggle(id: string): void;
  /** Focuses a handle. */
  hold(id: string): void;
  /** A corner has got the focus; null for a handle, or the stage. */
  focused(corner: Corner | null): void;
  /** Rejects what was typed, with words on what is valid. */
  refuse(words: string): void;
  /** Brings a place of the picture into view. */
  reveal(at: Vec): void;
  dismiss(): void;
  /** Keeps a notice that would disappear by itself, or no longer does. */
  linger(on: boolean): void;
  theme(): void;
}
