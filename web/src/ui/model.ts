/** What the templates show and what they can ask for. The element owns the state; nothing here keeps any. */
import type { Detail } from '../document/bending';
import type { Document } from '../document/document';
import type { Turns } from '../document/handle';
import type { PoseMode } from '../document/project';
import type { Blend } from '../geometry/blend';
import type { Box } from '../geometry/box';
import type { Camera, Size } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import type { ToolName } from '../tools/machine';
import type { Draft, Grips } from '../tools/state';
import type { CommandName } from './commands';
import type { FoldedMesh, SiteGraph } from './overlays';

export interface EditorModel {
  readonly document: Document;
  readonly turns: Turns;
  readonly picture: PictureLabel | null;
  /** One is on its way. */
  readonly opening: boolean;
  readonly tool: ToolName;
  readonly readonly: boolean;
  /** The picture and its handles alone; where it is readonly, the picture alone. */
  readonly playing: boolean;
  readonly disabled: boolean;
  readonly camera: Camera;
  /** CSS pixels. */
  readonly stage: Size;
  readonly grips: Grips;
  /** A press on the stage goes on. */
  readonly pressing: boolean;
  /** What a short press is called: fingers tap. */
  readonly press: 'click' | 'tap';
  readonly undo: string | null;
  readonly redo: string | null;
  readonly solved: SolvedLabel | null;
  /** What is under way, once it has taken long enough to be worth a word. */
  readonly progress: Progress | null;
  readonly notice: Notice | null;
  readonly hint: Hint | null;
  readonly announcement: string;
  readonly comparing: boolean;
  readonly overlays: OverlayFlags;
  readonly sites: SiteGraph | null;
  /** Triangles that have turned over, where they are to be shown. */
  readonly folded: FoldedMesh | null;
  /** How many there are. */
  readonly folds: number;
  /** Something of the posed picture lies beyond the picture's frame, which is what is exported. */
  readonly beyond: boolean;
  /** The guard against folds is on; it holds something back now. */
  readonly guarded: boolean;
  readonly holding: boolean;
  /** What is open where there is no room for it always: settings of the whole picture, numbers of the selected handles. */
  readonly settings: boolean;
  readonly numbers: boolean;
  /** What is being drawn. */
  readonly draft: Draft | null;
  /** What is being drawn with tools that are not in hand. */
  readonly waiting: readonly Draft[];
  readonly box: Box | null;
  /** Where the keyboard would place a handle, image pixels. */
  readonly crosshair: Vec | null;
  readonly cursor: string;
  readonly platform: string;
  /** The colours in use, so that the switch can offer the others. */
  readonly dark: boolean;
}

/** What a first visitor is told, and the place of the picture it is about. */
export interface Hint {
  readonly text: string;
  readonly at: Vec;
  /** There is no room to the right of it. */
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
  /** Gives it up, where it can be. */
  readonly cancel: (() => void) | null;
}

export interface Notice {
  readonly kind: 'error' | 'info';
  readonly text: string;
  readonly action?: { readonly label: string; run(): void };
}

export type OverlayFlags = Readonly<Record<'mesh' | 'sites' | 'graph' | 'folds' | 'reach', boolean>>;

/** A number of the selected handles that the panel can set. */
export type Field = 'x' | 'y' | 'rotation' | 'scale' | 'depth';

export interface EditorActions {
  run(command: CommandName): void;
  compare(on: boolean): void;
  overlay(name: keyof OverlayFlags, on: boolean): void;
  /** Sets a number of what is selected, from what it is of each. */
  field(field: Field, value: (now: number) => number): void;
  automatic(on: boolean): void;
  bend(mode: PoseMode): void;
  detail(detail: Detail): void;
  holdBoundary(held: boolean): void;
  /** How motions blend. */
  blend(blend: Blend): void;
  /** Drags stop where they would fold the picture. */
  guard(on: boolean): void;
  /** What is being drawn is done; its last corner is taken back. */
  finish(): void;
  back(): void;
  settings(on: boolean): void;
  numbers(on: boolean): void;
  select(ids: readonly string[]): void;
  toggle(id: string): void;
  /** A handle takes the focus. */
  hold(id: string): void;
  /** What was typed cannot be: a word on what can. */
  refuse(words: string): void;
  /** A place of the picture comes into view. */
  reveal(at: Vec): void;
  dismiss(): void;
  theme(): void;
}
