/** The clips of a project: pure edits, and their names. */
import { MAX_NAME } from './generated/settings';
import type { Clip, Project } from './project';

/** Seconds of a new clip. */
const NEW_DURATION = 2;

/** The range of durations, in seconds: a frame at 100 a second, and an hour. */
export const DURATIONS = { least: 0.01, most: 3600 } as const;

export const clipsOf = ({ clips }: Project): readonly Clip[] => clips ?? NONE;

const NONE: readonly Clip[] = [];

export const clipNamed = (project: Project, name: string): Clip | undefined =>
  clipsOf(project).find((clip) => clip.name === name);

/** Without clips there is no list either, as in opened files. */
const withClips = ({ clips: _, ...project }: Project, clips: readonly Clip[]): Project =>
  clips.length > 0 ? { ...project, clips } : project;

/** Adds a clip after the existing ones. */
export const addClip = (project: Project, clip: Clip): Project =>
  withClips(project, [...clipsOf(project), clip]);

export const newClip = (name: string): Clip => ({
  name,
  duration: NEW_DURATION,
  loop: 'repeat',
  tracks: [],
});

export const changeClip = (project: Project, name: string, change: (clip: Clip) => Clip): Project =>
  withClips(
    project,
    clipsOf(project).map((clip) => (clip.name === name ? change(clip) : clip)),
  );

export const removeClip = (project: Project, name: string): Project =>
  withClips(
    project,
    clipsOf(project).filter((clip) => clip.name !== name),
  );

/** Characters that a number takes behind a name. */
const NUMBER = 6;

/** A name that no clip has: the word itself, or the word with a number. It is cut where names end. */
export function freeClipName(project: Project, long: string): string {
  const word = [...long].slice(0, MAX_NAME - NUMBER).join('');
  if (!clipNamed(project, word)) return word;
  let number = 2;
  while (clipNamed(project, `${word} ${number}`)) number++;
  return `${word} ${number}`;
}

/** The time of the last key, in seconds. */
export const lastKeyTime = ({ tracks }: Clip): number =>
  Math.max(0, ...tracks.map(({ keys }) => keys.at(-1)?.time ?? 0));

/** Sets the duration, within its range and not before the last key. */
export const withDuration = (clip: Clip, seconds: number): Clip => ({
  ...clip,
  duration: Math.min(Math.max(seconds, DURATIONS.least, lastKeyTime(clip)), DURATIONS.most),
});

/**
 * The last time that the playhead can be at. The end of a clip that repeats is its beginning, so that is the frame
 * before.
 */
export const lastTime = ({ duration, loop }: Clip, rate: number): number =>
  loop === 'alternate' || loop === 'none'
    ? duration
    : Math.max(0, Math.ceil(duration * rate - 1e-6) - 1) / rate;

/** The time in a clip after seconds of playing; null once it has ended. */
export function timePlayed({ duration, loop }: Clip, seconds: number): number | null {
  if (loop === 'none') return seconds < duration ? seconds : null;
  if (loop !== 'alternate') return seconds % duration;
  const there = seconds % (2 * duration);
  return there > duration ? 2 * duration - there : there;
}
