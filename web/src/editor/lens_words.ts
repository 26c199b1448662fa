/** A description of the lens. */
import type { Lens } from '../document/generated/lens';
import { nameWords } from '../document/names';
import type { Project } from '../document/project';
import { say, type Wording, type Words } from '../texts/wording';

/** The name of a handle by its index, or of the held boundary. */
export const siteName = ({ handles }: Project, handle: number): Words => {
  const own = handles[handle];
  return own ? nameWords(own) : say(handle === -1 ? 'names.aVirtualHandle' : 'names.boundary');
};

export const percent = (part: number): string => {
  const whole = 100 * part;
  return `${whole >= 10 || whole === 0 ? Math.round(whole) : whole.toFixed(1)} %`;
};

/** The weights at a point, for screen readers. @param project The project that was solved. */
export function lensWords({ at: [x, y], shares, virtual_weight }: Lens, project: Project): Wording {
  const parts: Wording[] = shares
    .filter(({ weight }) => weight > 0)
    .map(({ handle, weight }) => say('lens.share', siteName(project, handle), percent(weight)));
  if (virtual_weight > 0) parts.push(say('lens.virtualShare', percent(virtual_weight)));
  return say('lens.spoken', Math.round(x), Math.round(y), parts);
}
