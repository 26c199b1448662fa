/** The tracks of clips, as handles are removed, renamed and get other corners. */
import type { Vec } from '../geometry/vec';
import { trackOf } from './clip_keys';
import { clipNamed } from './clips';
import type { Clip, Key, LineHandle, Posed, Project, Track } from './project';

/** Changes tracks in their clips; null removes a track. */
function withTracks(project: Project, change: (track: Track, clip: Clip) => Track | null): Project {
  if (!project.clips) return project;
  const changed = (clip: Clip): Clip => ({
    ...clip,
    tracks: clip.tracks.flatMap((track) => change(track, clip) ?? []),
  });
  return { ...project, clips: project.clips.map(changed) };
}

/** Removes the tracks of handles that the project does not have. */
export function withoutLostTracks(project: Project): Project {
  const ids = new Set(project.handles.map(({ id }) => id));
  return withTracks(project, (track) => (ids.has(track.handle) ? track : null));
}

export const withRenamedTracks = (project: Project, from: string, to: string): Project =>
  withTracks(project, (track) => (track.handle === from ? { ...track, handle: to } : track));

/** Gives a handle the tracks that it has in the clips of an earlier project. */
export const withTracksOf = (project: Project, handle: string, earlier: Project): Project =>
  withTracks(project, (track, { name }) => {
    if (track.handle !== handle) return track;
    const clip = clipNamed(earlier, name);
    return (clip && trackOf(clip, handle)) ?? null;
  });

/** Changes the corners of a handle in the keys of its tracks, as `change` changes the handle itself. */
export const withChangedCorners = (
  project: Project,
  handle: LineHandle,
  change: (handle: LineHandle) => LineHandle,
): Project =>
  withTracks(project, (track) => {
    if (track.handle !== handle.id) return track;
    const changed = (key: Key): Key =>
      isCorners(key.posed) ? { ...key, posed: change({ ...handle, posed: key.posed }).posed } : key;
    return { ...track, keys: track.keys.map(changed) };
  });

const isCorners = (posed: Posed | undefined): posed is readonly Vec[] => Array.isArray(posed?.[0]);
