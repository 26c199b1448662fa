/** Why a command cannot run now, in a few words: for menus and screen readers. */

export const DISABLED = 'The editor is disabled';
export const LEFT_OUT = 'This page leaves it out';
export const VIEW_ONLY = 'This picture is for viewing only';
export const NO_PICTURE = 'Open a picture first';
export const NO_HANDLES = 'There is no handle yet';
export const NONE_SELECTED = 'Select a handle first';
export const NO_SINGLE = 'Select a single handle';
export const NO_LINE = 'Select a single bar or polygon';
export const NOTHING_TO_UNDO = 'There is nothing to undo';
export const NOTHING_TO_REDO = 'There is nothing to redo';
export const AT_REST = 'At rest already';
export const IN_FRONT = 'In front already';
export const AT_BACK = 'At the back already';
export const NOTHING_FOLDED = 'Nothing is folded';
export const NO_LASSO = 'Draw a lasso around a part first';
export const NOT_OPAQUE = 'Only pictures without transparency have a frame to hold';
export const STILL_HERE = 'Nothing bends here';

export const cornersNeededText = (kind: string, count: number): string => `A ${kind} needs ${count} corners`;
