import { describe, expect, it } from 'vitest';
import { type Document, newProject } from '../document/document';
import { packed, patched, runsOf, unpacked } from './stored_displacements';

const image = { src: 'cat.png', width: 400, height: 300 };

/** As long as the text of a displacement in the editor. */
const LENGTH = 69_000;

/** The text after some strokes, each of which has changed a hundred characters. */
const text = (strokes: number): string =>
  Array.from({ length: strokes }, (_, k) => k).reduce((before, k) => {
    const at = (k * 7919) % (LENGTH - 100);
    return before.slice(0, at) + String(k % 10).repeat(100) + before.slice(at + 100);
  }, 'A'.repeat(LENGTH));

const documentOf = (strokes: number): Document => ({
  project: {
    ...newProject(image, null),
    ...(strokes > 0 && { displacement: { width: 131, height: 99, values: text(strokes) } }),
  },
  selection: [],
});

describe('differences of texts', () => {
  it('give the text back', () => {
    for (const [before, after] of [
      ['aaaa', 'aaaa'],
      ['abcd', 'xbcy'],
      [text(3), text(9)],
      [text(9), text(0)],
    ] as const)
      expect(patched(before, runsOf(before, after))).toBe(after);
    expect(runsOf('aaaa', 'aaaa')).toEqual([]);
  });
});

describe('the displacements of a history', () => {
  const steps = Array.from({ length: 41 }, (_, strokes) => documentOf(strokes));
  const step = (value: Document) => ({ label: 'Push', value });
  const [present, saved] = [steps[30], steps[12]?.project];
  const future = steps.slice(31).reverse().map(step);
  const work = {
    record: { past: steps.slice(0, 30).map(step), present: present ?? documentOf(0), future },
    saved,
  };

  it('are stored in little more than the text of one, and come back', () => {
    const stored = packed(work as never);
    expect(JSON.stringify(work).length).toBeGreaterThan(30 * LENGTH);
    expect(JSON.stringify(stored).length).toBeLessThan(2 * LENGTH);
    // As the storage of the browser copies it.
    const read = unpacked(structuredClone(stored)) as typeof work;
    expect(read).toEqual(work);
    expect(read.saved).toBe(read.record.past[12]?.value.project);
  });

  it('are whole where the grid changes', () => {
    const other = { width: 4, height: 4, values: 'A'.repeat(88) };
    const past = [step({ project: { ...newProject(image, null), displacement: other }, selection: [] })];
    const changed = { record: { past, present: documentOf(2), future: [] } };
    expect(unpacked(structuredClone(packed(changed as never)))).toEqual(changed);
  });
});
