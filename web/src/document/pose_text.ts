/** A pose as text for the clipboard: handles as in the project file. */
import { checkedHandle } from './handle';
import { type Handle, posedHandle } from './project';
import { projectText } from './project_text';

const FORMAT = 'c2warp-pose/1';
/** Also matches a text that is cut off. */
const POSE = /^\s*\{.*"format"\s*:\s*"c2warp-pose\//s;

/** Writes a pose. It contains the rest positions, since a pose is relative to them. */
export const poseText = (handles: readonly Handle[]): string => projectText({ format: FORMAT, handles });

/** Whether a text says that it is a pose. */
export const isPose = (text: string): boolean => POSE.test(text);

/**
 * Returns the handles of a pose, or `null` if a text does not say that it is one.
 * @throws RangeError with the reason if the pose is invalid.
 */
export function parsePose(text: string): readonly Handle[] | null {
  if (!isPose(text)) return null;
  const { format, handles } = parsed(text);
  if (format !== FORMAT) throw new RangeError(`format: expected "${FORMAT}"`);
  if (!Array.isArray(handles) || handles.length === 0) throw new RangeError('handles: expected a list');
  return handles.map((handle) => checkedHandle(posedHandle(Object(handle))));
}

function parsed(text: string): { readonly format?: unknown; readonly handles?: unknown } {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new RangeError('its text is incomplete', { cause });
  }
}
