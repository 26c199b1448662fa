/** A pose as text for the clipboard: handles as in the project file. */
import { checkedHandle } from './handle';
import { type Handle, posedHandle } from './project';
import { projectText } from './project_text';

const FORMAT = 'c2warp-pose/1';
/** Also of a text that is cut off. */
const SAYS_SO = /^\s*\{.*"format"\s*:\s*"c2warp-pose\//s;

/** Writes a pose. It contains the rest positions, since a pose is relative to them. */
export const poseText = (handles: readonly Handle[]): string => projectText({ format: FORMAT, handles });

/**
 * Returns the handles of a pose, or `null` if a text does not say that it is one.
 * @throws RangeError with the reason if the pose is invalid.
 */
export function parsePose(text: string): readonly Handle[] | null {
  if (!SAYS_SO.test(text)) return null;
  const { format, handles } = parsed(text);
  if (format !== FORMAT) throw new RangeError(`format: expected "${FORMAT}"`);
  if (!Array.isArray(handles) || handles.length === 0)
    throw new RangeError('handles: expected a list of them');
  return handles.map((handle) => checkedHandle(posedHandle(Object(handle))));
}

function parsed(text: string): { readonly format?: unknown; readonly handles?: unknown } {
  try {
    return JSON.parse(text);
  } catch (cause) {
    throw new RangeError('its text is not whole', { cause });
  }
}
