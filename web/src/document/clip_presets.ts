/** Clips that suit any handles: the first loop takes one click. */
import { centre } from '../geometry/polyline';
import { add, distance, rotated, subtract, type Vec } from '../geometry/vec';
import { keyOf } from './clip_keys';
import { freeClipName } from './clips';
import { anchor, corners, isAutomatic, isLine, replaced, roundedVec, turnedAbout } from './handle';
import type { Clip, Handle, Project } from './project';

export const CLIP_PRESETS = ['sway', 'breathe', 'wave'] as const;
export type ClipPreset = (typeof CLIP_PRESETS)[number];

/** Handles that move less have no track, image pixels. */
const LEAST_MOVE = 0.5;

/**
 * A clip of the project's handles, from their present pose.
 *
 * - `sway`: the picture bends to both sides, the more the higher. The lowest handle stays.
 * - `breathe`: it grows a little and shrinks again.
 * - `wave`: the selected handles, or else the outermost one, turn about the nearest other handle.
 */
export function presetClip(project: Project, preset: ClipPreset, selection: readonly string[]): Clip {
  const { duration, poses } = MAKE[preset](project, selection);
  const tracks = project.handles.flatMap((handle) => {
    const posed = poses.map(({ time, pose }) => ({ time, handle: pose(handle) }));
    if (posed.every((one) => moveBetween(one.handle, handle) < LEAST_MOVE)) return [];
    const values = isLine(handle) || isAutomatic(handle) ? [] : (['rotation'] as const);
    return { handle: handle.id, keys: posed.map((one) => keyOf(one.handle, one.time, values)) };
  });
  return { name: freeClipName(project, preset), duration, loop: 'repeat', tracks };
}

interface Motion {
  readonly duration: number;
  readonly poses: readonly { readonly time: number; readonly pose: (handle: Handle) => Handle }[];
}

const moveBetween = (a: Handle, b: Handle): number =>
  Math.max(...corners(a).map((corner, k) => distance(corner, corners(b)[k] ?? corner)));

/** Degrees that the highest point sways to each side. */
const SWAY = 7;
/** Growth of height and width in a breath. */
const BREATH = { height: 0.03, width: 0.015 } as const;
/** Degrees of a wave, up and down. */
const WAVE = { up: 26, down: 8 } as const;

const MAKE: Readonly<Record<ClipPreset, (project: Project, selection: readonly string[]) => Motion>> = {
  sway: (project) => {
    const { foot, height } = stand(project);
    const swayed = (side: number) => (handle: Handle) =>
      replaced(handle, (p) => {
        const turn = side * SWAY * Math.min(1, Math.max(0, (foot[1] - p[1]) / height));
        return roundedVec(add(foot, rotated(subtract(p, foot), turn)));
      });
    const at = (time: number, side: number) => ({ time, pose: swayed(side) });
    return { duration: 2.4, poses: [at(0, 0), at(0.6, 1), at(1.2, 0), at(1.8, -1)] };
  },
  breathe: (project) => {
    const { foot } = stand(project);
    const grown = (handle: Handle) =>
      replaced(handle, ([x, y]) =>
        roundedVec([
          foot[0] + (x - foot[0]) * (1 + BREATH.width),
          foot[1] + (y - foot[1]) * (1 + BREATH.height),
        ]),
      );
    return {
      duration: 3,
      poses: [
        { time: 0, pose: (handle) => handle },
        { time: 1.3, pose: grown },
      ],
    };
  },
  wave: (project, selection) => {
    const waving = wavingHandles(project, selection);
    const ids = waving.map(({ id }) => id);
    const from = centre(waving.map((handle) => anchor(handle)));
    const others = project.handles.filter(({ id }) => !ids.includes(id)).map((handle) => anchor(handle));
    const pivot = nearestOf(others, from) ?? middleOf(project);
    // Up is towards smaller y.
    const side = add(pivot, rotated(subtract(from, pivot), WAVE.up))[1] <= from[1] ? 1 : -1;
    const at = (time: number, degrees: number) => ({
      time,
      pose: (handle: Handle) =>
        ids.includes(handle.id) ? turnedAbout(handle, pivot, side * degrees, 1) : handle,
    });
    return { duration: 1.2, poses: [at(0, 0), at(0.3, WAVE.up), at(0.6, -WAVE.down), at(0.9, WAVE.up)] };
  },
};

/** Handles this near to the lowest one stand on the ground too, as parts of the height. */
const GROUND = 0.12;

/** Where the picture stands, and the height above it. A single handle stands on the lower edge of the picture. */
function stand({ handles, image }: Project): { readonly foot: Vec; readonly height: number } {
  const places = handles.map((handle) => anchor(handle));
  const [high, low] = [Math.min(...places.map(([, y]) => y)), Math.max(...places.map(([, y]) => y))];
  const standing = places.filter(([, y]) => y >= low - GROUND * (low - high));
  const foot: Vec =
    standing.length < places.length ? [centre(standing)[0], low] : [centre(places)[0], image.height];
  return { foot, height: Math.max(foot[1] - high, image.height / 8) };
}

/** The selected handles or, without a selection or with all selected, the outermost one. */
function wavingHandles(project: Project, selection: readonly string[]): readonly Handle[] {
  const { handles } = project;
  const selected = handles.filter(({ id }) => selection.includes(id));
  if (selected.length > 0 && selected.length < handles.length) return selected;
  const middle = centre(handles.map((handle) => anchor(handle)));
  // High up and far out.
  const reach = (handle: Handle) => {
    const [x, y] = subtract(anchor(handle), middle);
    return Math.abs(x) - y / 2;
  };
  return [handles.reduce((outermost, handle) => (reach(handle) > reach(outermost) ? handle : outermost))];
}

const nearestOf = (places: readonly Vec[], to: Vec): Vec | undefined =>
  places.reduce<Vec | undefined>(
    (nearest, p) => (!nearest || distance(p, to) < distance(nearest, to) ? p : nearest),
    undefined,
  );

const middleOf = ({ image }: Project): Vec => [image.width / 2, image.height / 2];
