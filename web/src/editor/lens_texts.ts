/** The lens in words. */
import type { Lens } from '../document/generated/lens';
import { nameOf } from '../document/handle';
import type { Project } from '../document/project';

export const VIRTUAL = 'Virtual handles';

/** The name of a handle by its index, or of the held boundary. */
export const siteName = ({ handles }: Project, handle: number): string => {
  const own = handles[handle];
  return own ? nameOf(own) : handle === -1 ? 'a virtual handle' : 'the boundary';
};

export const percent = (part: number): string => {
  const whole = 100 * part;
  return `${whole >= 10 || whole === 0 ? Math.round(whole) : whole.toFixed(1)} %`;
};

/** The weights at a point, for screen readers. @param project The project that was solved. */
export function lensWords({ at: [x, y], shares, virtual_weight }: Lens, project: Project): string {
  const parts = shares
    .filter(({ weight }) => weight > 0)
    .map(({ handle, weight }) => `${siteName(project, handle)} ${percent(weight)}`);
  if (virtual_weight > 0) parts.push(`${VIRTUAL.toLowerCase()} ${percent(virtual_weight)}`);
  const place = `x ${Math.round(x)}, y ${Math.round(y)}`;
  return `${place}: ${parts.join(', ') || 'no handle moves it'}`;
}

export const NOTHING_BENDS = 'Nothing bends here';
