/**
 * The project file as the editor holds it: the format's own types, with every handle's pose written out.
 *
 * Coordinates are image pixels, angles degrees.
 */
import type * as file from './generated/project';

export type { Domain, ImageRef, PoseMode, Rotation } from './generated/project';

/** A project as a file or a page may give it. */
export type ProjectFile = file.Project;
export type HandleFile = file.Handle;

type Posed<H extends HandleFile> = H & { readonly posed: H['rest'] };

export type PointHandle = Posed<file.PointHandle>;
export type BarHandle = Posed<file.BarHandle>;
export type PolygonHandle = Posed<file.PolygonHandle>;
/** A handle with corners. */
export type LineHandle = BarHandle | PolygonHandle;
export type Handle = PointHandle | LineHandle;

export interface Project extends Omit<ProjectFile, 'handles'> {
  readonly handles: readonly Handle[];
}

/** The handle with its pose written out, which is the rest pose where the file has none. */
export const posedHandle = (handle: HandleFile): Handle =>
  ({ ...handle, posed: handle.posed ?? handle.rest }) as Handle;

/** A deep copy: a page may change it without changing a step of the history. */
export const deepCopy = <T>(data: T): T => JSON.parse(JSON.stringify(data));
