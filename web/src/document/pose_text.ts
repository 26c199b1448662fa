/** A pose as text for the clipboard: handles as in the project file. */
import { listIn, saysFormat } from './clipboard_text';
import { checkedHandle } from './handle';
import { type Handle, posedHandle } from './project';
import { projectText } from './project_text';

const FORMAT = 'c2warp-pose/1';

/** Writes a pose. It contains the rest positions, since a pose is relative to them. */
export const poseText = (handles: readonly Handle[]): string => projectText({ format: FORMAT, handles });

/** Whether a text says that it is a pose. */
export const isPose = (text: string): boolean => saysFormat(text, 'c2warp-pose');

/**
 * Returns the handles of a pose, or `null` if a text does not say that it is one.
 * @throws RangeError with the reason if the pose is invalid.
 */
export const parsePose = (text: string): readonly Handle[] | null =>
  isPose(text)
    ? listIn(text, FORMAT, 'handles').map((handle) => checkedHandle(posedHandle(Object(handle))))
    : null;
