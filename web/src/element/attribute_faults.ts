/** Attributes with values that mean nothing. */
import { FEATURES, unknownFeatures } from '../editor/features';
import { WarpError } from '../error';
import { isToolName, TOOL_NAMES } from '../tools/machine';

/** The faults of attributes with these names, in sentences for the author of the page. */
export function attributeFaults(
  element: {
    readonly toolSource: string | null;
    readonly theme: string | null;
    readonly features: string | null;
  },
  changed: { has(name: string): boolean },
): readonly WarpError[] {
  const { toolSource, theme, features } = element;
  const faults: string[] = [];
  if (changed.has('toolSource') && toolSource !== null && !isToolName(toolSource))
    faults.push(`tool: expected one of ${TOOL_NAMES.join(', ')}, found "${toolSource}"`);
  if (changed.has('theme') && theme !== null && !['light', 'dark'].includes(theme))
    faults.push(`theme: expected light or dark, found "${theme}"`);
  const [unknown] = unknownFeatures(features);
  if (changed.has('features') && unknown !== undefined)
    faults.push(`features: expected words of ${FEATURES.join(', ')}, found "${unknown}"`);
  return faults.map((fault) => new WarpError('attribute', fault));
}
