/** Types of the arguments and attributes of `<c2-warp>`. */
import type { Handle, HandleFile, ProjectFile } from '../document/project';
import type { C2WarpEventMap } from './events';

/** A handle whose id is optional: the editor generates a missing one. */
export type NewHandle<H = HandleFile> = H extends HandleFile
  ? Omit<H, 'id'> & { readonly id?: string }
  : never;

/**
 * The pose of the handle with this id. Keys that are left out stay; `kind` and `rest` cannot change.
 */
export type HandlePose = Pick<Handle, 'id'> & Partial<Handle>;

/** The attributes, properties and listeners that a framework's template may set on the tag. */
export type C2WarpProps = {
  [T in keyof C2WarpEventMap as `on${T}`]?: ((event: C2WarpEventMap[T]) => void) | undefined;
} & {
  [T in 'src' | 'tool' | 'theme' | 'alt' | 'hint' | 'hint-for' | 'autosave']?: string | null | undefined;
} & {
  [T in 'readonly' | 'disabled' | 'play']?: boolean | undefined;
} & {
  project?: ProjectFile | string | null | undefined;
  selection?: readonly string[] | null | undefined;
};

/** How a warped picture is drawn. */
export interface WarpOptions {
  /** Enlarges the result to hold the parts that are bent beyond the picture. */
  readonly grow?: boolean;
  /** For pixel art: no colours are mixed. By default as the picture is shown. */
  readonly pixelated?: boolean | undefined;
}
