/** Checks attributes for invalid values. */
import { FEATURES, unknownFeatures } from '../editor/features';
import { C2WarpError } from '../error';
import { isToolName, TOOL_NAMES } from '../tools/machine';
import { isSubmitted, SUBMITTED } from './form_control';

const ORIGINS = ['', 'anonymous', 'use-credentials'];

/** The errors of attributes with these names, as sentences for the author of the page. */
export function attributeFaults(
  element: {
    readonly toolSource: string | null;
    readonly theme: string | null;
    readonly features: string | null;
    readonly crossOrigin: string | null;
    readonly submits: string | null;
  },
  changed: { has(name: string): boolean },
): readonly C2WarpError[] {
  const { toolSource, theme, features, crossOrigin, submits } = element;
  const faults: string[] = [];
  if (changed.has('toolSource') && toolSource !== null && !isToolName(toolSource))
    faults.push(`tool: expected one of ${TOOL_NAMES.join(', ')}, found "${toolSource}"`);
  if (changed.has('theme') && theme !== null && !['light', 'dark'].includes(theme))
    faults.push(`theme: expected light or dark, found "${theme}"`);
  const [unknown] = unknownFeatures(features);
  if (changed.has('features') && unknown !== undefined)
    faults.push(`features: expected some of ${FEATURES.join(', ')}, found "${unknown}"`);
  // Without a value the attribute means `anonymous`, as on `<img>`.
  if (changed.has('crossOrigin') && crossOrigin !== null && !ORIGINS.includes(crossOrigin))
    faults.push(`crossorigin: expected anonymous or use-credentials, found "${crossOrigin}"`);
  if (changed.has('submits') && submits !== null && !isSubmitted(submits))
    faults.push(`submits: expected ${SUBMITTED.join(' or ')}, found "${submits}"`);
  return faults.map((fault) => new C2WarpError('attribute', fault));
}
