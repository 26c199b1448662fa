import { describe, expect, it } from 'vitest';
import { newProject, openDocument } from './document';
import { addCorner, addHandle, removeCorner, removeHandles } from './edits';
import { straightBar } from './fixtures';
import { renameHandle } from './names';
import type { Clip, Key } from './project';
import { revertHandle } from './reverting';
import { settingsKey } from './solved';

const bar = straightBar(8);
const keys: readonly Key[] = [
  {
    time: 0,
    posed: [
      [0, 0],
      [0, 4],
    ],
  },
  { time: 1, rotation: 90 },
];
const clip: Clip = { name: 'swing', duration: 1, tracks: [{ handle: 'arm', keys }] };
const empty = openDocument(newProject({ src: 'a.png', width: 9, height: 9 }, null));
const withBar = addHandle(empty, bar);
const document = { ...withBar, project: { ...withBar.project, clips: [clip] } };
const tracks = ({ project }: typeof document) => project.clips?.[0]?.tracks;

describe('a track', () => {
  it('goes with its handle, and the clip stays', () => {
    expect(removeHandles(document, ['arm']).project.clips).toEqual([{ ...clip, tracks: [] }]);
    expect(tracks(removeHandles(document, ['leg']) as typeof document)).toEqual(clip.tracks);
  });

  it('takes the new name of its handle', () => {
    expect(tracks(renameHandle(document, 'arm', 'Left arm') as typeof document)).toEqual([
      { handle: 'Left arm', keys },
    ]);
  });

  it('has as many corners as its handle', () => {
    const longer = addCorner(document, 'arm', { edge: 0, fraction: 0.5 }) as typeof document;
    const posed = [
      [0, 0],
      [0, 2],
      [0, 4],
    ];
    expect(tracks(longer)?.[0]?.keys).toEqual([{ time: 0, posed }, keys[1]]);
    expect(tracks(removeCorner(longer, 'arm', 1) as typeof document)).toEqual(clip.tracks);
  });

  it('is the previous one if its handle is reverted', () => {
    const longer = addCorner(document, 'arm', { edge: 0, fraction: 0.5 });
    const [handle] = longer.project.handles;
    if (!handle) throw new Error('no handle');
    expect(revertHandle(longer, handle, document)).toBe(document);
    expect(tracks(revertHandle(longer, handle, undefined) as typeof document)).toEqual([]);
  });

  it('needs no other solution', () => {
    expect(settingsKey(document.project)).toBe(settingsKey(withBar.project));
  });
});
