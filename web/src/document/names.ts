/**
 * Names of handles. The name of a handle is its id, by which programs and project files refer to it, so a new name is a
 * new id.
 */
import type { Height, Part, Place, Side } from '../texts/en/names';
import { shownName } from '../texts/shown_name';
import { say, type Words } from '../texts/wording';
import type { Document } from './document';
import { nameOf } from './handle';
import type { Handle, Project } from './project';
import { withRenamedTracks } from './tracks';

export type NameFault = 'empty' | 'taken';

/** Characters that a person can type. Longer names fit no list. */
export const MOST_CHARACTERS = 60;

/** A typed name without spaces around it, and with single spaces inside. */
export const tidyName = (typed: string): string => typed.trim().replace(/\s+/gu, ' ');

/** Why a handle cannot have a tidy name; null if it can. Names that read alike are the same, whatever their case. */
export function nameFault({ handles }: Project, id: string, name: string): NameFault | null {
  if (name === '') return 'empty';
  const read = (id: string) => nameOf({ id }).toLowerCase().replaceAll(', ', ' ');
  return handles.some((other) => other.id !== id && read(other.id) === read(name)) ? 'taken' : null;
}

/** Gives a handle another id. A selected handle stays selected. */
export function renameHandle(document: Document, id: string, name: string): Document {
  const { project, selection } = document;
  const renamed = (handle: Handle): Handle => (handle.id === id ? { ...handle, id: name } : handle);
  return {
    ...document,
    project: withRenamedTracks({ ...project, handles: project.handles.map(renamed) }, id, name),
    selection: selection.map((selected) => (selected === id ? name : selected)),
  };
}

const NUMBERED = /^(handle|bar|polygon)-(\d+)$/;

/** The number of a handle that nobody has named; null for others. */
export const numberOf = ({ id }: Handle): string | null => NUMBERED.exec(id)?.[2] ?? null;

/** Ids of suggested handles: `wasm/core/src/suggest/` makes them. */
const ON_LIMB =
  /^(?:(upper|lower)-)?(?:(left|right)-)?(head|neck|body|arm|leg|tail|part)(?:-(\d+))?(?:-(end|joint)(?:-(\d+))?)?$/;
const AT_POSITION = /^(?:(top|bottom)(?:-(left|right))?|(left|right)|middle)(?:-(\d+))?$/;

/** The name of a suggested handle in words; null for other names. */
function suggestedWords(id: string): Words | null {
  const limb = ON_LIMB.exec(id);
  if (limb) {
    const [, height = '', side = '', part, number = '', place = '', of = ''] = limb;
    return say('names.limb', part as Part, height as Height, side as Side, number, place as Place, of);
  }
  const position = AT_POSITION.exec(id);
  if (!position) return null;
  const [, height, side, only, number = ''] = position;
  const up = height === 'top' ? 'upper' : height === 'bottom' ? 'lower' : '';
  return say('names.position', up, (side ?? only ?? '') as Side, number);
}

/**
 * The name of a handle for people. A handle that nobody has named has its kind and number, or the part that it was
 * suggested for.
 */
export function nameWords({ id }: Pick<Handle, 'id'>): Words {
  const [, word, number] = NUMBERED.exec(id) ?? [];
  if (number === undefined) return suggestedWords(id) ?? shownName(nameOf({ id }));
  return say(word === 'bar' ? 'names.bar' : word === 'polygon' ? 'names.polygon' : 'names.point', number);
}

const SIDE = /(?<![a-z])(left|right)(?![a-z])/i;
const OPPOSITE: Readonly<Record<string, string>> = {
  left: 'right',
  right: 'left',
  Left: 'Right',
  Right: 'Left',
  LEFT: 'RIGHT',
  RIGHT: 'LEFT',
};

/** The name for the other side: "right-hand" for "left-hand". Other names stay. */
export const ofOtherSide = (name: string): string => name.replace(SIDE, (side) => OPPOSITE[side] ?? side);
