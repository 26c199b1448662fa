/** The poses of handles at a frame of a clip, derived from the motions of their sites. */
import { linearOf, type MotionNumber } from './clip';
import type { Handle, Place, Sources } from './shares';

/**
 * Depths are those of the project, because a clip stores drawing orders instead.
 *
 * @param rest Sites × 2.
 */
export function handlesAt(sources: Sources, motion: MotionNumber, rest: Float64Array): readonly Handle[] {
  const { handles, bones, driven } = sources;
  const siteOf = (source: number) => driven.indexOf(source + 2);
  const numbersOf = (site: number) => [0, 1, 2, 3, 4, 5].map((index) => motion(site, index));
  /** The position to which a site moves a nearby point. */
  const moved = (site: number, [x, y]: Place): Place => {
    const numbers = numbersOf(site);
    const [a = 0, b = 0, c = 0, d = 0] = linearOf(numbers);
    const [rx = 0, ry = 0] = rest.subarray(2 * site);
    return [
      rx + (numbers[4] ?? 0) + a * (x - rx) + c * (y - ry),
      ry + (numbers[5] ?? 0) + b * (x - rx) + d * (y - ry),
    ];
  };
  return handles.map((handle, index) => {
    const count = handle.rest.length;
    const boneAt = (segment: number) =>
      bones.findIndex((bone) => bone.handle === index && bone.segment === segment);
    const sites = handle.rest.map((_, corner) => {
      if (handle.kind === 'point') return siteOf(index);
      const bone = [corner, (corner + count - 1) % count].map(boneAt).find((bone) => bone >= 0) ?? -1;
      return bone < 0 ? -1 : siteOf(handles.length + bone);
    });
    const [first = -1] = sites;
    // A part outside the picture has no site.
    if (sites.includes(-1)) return handle;
    const [angle = 0, xx = 0, , yy = 0] = numbersOf(first);
    const posed = handle.rest.map((place, corner) => moved(sites[corner] ?? first, place));
    const scale = handle.kind === 'point' ? Math.exp((xx + yy) / 2) : handle.scale;
    // Such a site is also stretched as its surroundings are.
    if (handle.rotation === 'auto') return { ...handle, posed };
    return { ...handle, posed, rotation: (angle * 180) / Math.PI, scale };
  });
}
