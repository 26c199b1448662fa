/** How a person exports rigs for game engines: kept for the next one, and stored with the work. */

import type { EngineFormat } from '../document/engine_rig';
import type { Project } from '../document/project';
import { stem } from './picture';

export interface EngineChoices {
  readonly format: EngineFormat;
  /** The most bones besides the root. */
  readonly bones: number;
  /** The most bones that move a vertex. */
  readonly influences: number;
  readonly vertices: number;
  /** Several files go into a zip, or into a folder that the person picks. */
  readonly into: 'zip' | 'folder';
}

/** Those of the command. */
export const DEFAULT_ENGINE: EngineChoices = {
  format: 'spine',
  bones: 64,
  influences: 4,
  vertices: 300,
  into: 'zip',
};

/** The module refuses other numbers. */
export const BONES = { least: 1, most: 255 } as const;
export const INFLUENCES = { least: 1, most: 32, mostOfGodot: 4 } as const;
export const VERTICES = { least: 3, most: 65_535 } as const;

/** `extension`: of the only file; null for formats of several files. */
export const ENGINE_FORMATS = {
  spine: { name: 'Spine', extension: null },
  dragonbones: { name: 'DragonBones', extension: null },
  gltf: { name: 'glTF', extension: 'glb' },
  godot: { name: 'Godot', extension: null },
} as const satisfies Record<EngineFormat, object>;

/** The name of the only file. @param picture The name of the picture's file. */
export const engineFile = (picture: string, format: EngineFormat): string => {
  const { extension } = ENGINE_FORMATS[format];
  return extension ? `${stem(picture)}.${extension}` : `${stem(picture)}-${format}.zip`;
};

/** The fewest bones of a project: each handle has one. */
export const leastBones = ({ handles }: Project): number =>
  Math.min(Math.max(BONES.least, handles.length), BONES.most);

/** The most bones besides the root, in a project. */
export const bonesOf = ({ bones }: EngineChoices, project: Project): number =>
  Math.max(bones, leastBones(project));

/** The most bones that move a vertex, in a format. */
export const influencesOf = ({ format, influences }: EngineChoices): number =>
  format === 'godot' ? Math.min(influences, INFLUENCES.mostOfGodot) : influences;
