/**
 * The project of the editor: the types of the file format, in which every handle has a pose.
 *
 * Coordinates are image pixels, angles degrees.
 */
import type * as file from './generated/project';

export type {
  Clip,
  Displacement,
  Domain,
  Ease,
  Fill,
  ImageRef,
  Key,
  Loop,
  Posed,
  PoseMode,
  Rotation,
  Stiffness,
  Track,
} from './generated/project';

/** A project from a file or a page. Handles may lack a pose. */
export type ProjectFile = file.Project;
export type HandleFile = file.Handle;

type WithPose<H extends HandleFile> = H & { readonly posed: H['rest'] };

export type PointHandle = WithPose<file.PointHandle>;
export type BarHandle = WithPose<file.BarHandle>;
export type PolygonHandle = WithPose<file.PolygonHandle>;
/** A handle with corners. */
export type LineHandle = BarHandle | PolygonHandle;
export type Handle = PointHandle | LineHandle;

export interface Project extends Omit<ProjectFile, 'handles'> {
  readonly handles: readonly Handle[];
}

/** Returns the handle with a pose: the rest pose if the file omits it. */
export const posedHandle = (handle: HandleFile): Handle =>
  ({ ...handle, posed: handle.posed ?? handle.rest }) as Handle;

/** Returns a deep copy, which a page can change without changing the history. */
export const deepCopy = <T>(data: T): T => JSON.parse(JSON.stringify(data));
