import { describe, expect, it } from 'vitest';
import { type Document, newProject, openDocument } from '../document/document';
import { addHandle, changeHandles, selectHandles } from '../document/edits';
import { transformGroup } from '../document/group';
import { DEPTHS, scaledTo } from '../document/handle';
import { C2WarpError } from '../error';
import { inEnglish } from './english';
import { errorWords } from './error_words';
import { cornerWords, depthWords, draftWords, placeWords, selectionName } from './selection_words';

const empty = openDocument(newProject({ src: '', width: 8, height: 8 }, null));
const withPoint = (id: string, document: Document, depth = 0): Document =>
  addHandle(document, { id, kind: 'point', rest: [1, 2], posed: [3.4, 4.6], rotation: 10.4, depth });

describe('words', () => {
  it('name what is selected', () => {
    const two = withPoint('b', withPoint('a', empty));
    expect(inEnglish(selectionName(selectHandles(two, [])))).toBe('nothing');
    expect(inEnglish(selectionName(selectHandles(two, ['a'])))).toContain('a');
    expect(inEnglish(selectionName(selectHandles(two, ['a', 'b'])))).toBe('2 handles');
  });

  it('say where the selected handle is', () => {
    expect(inEnglish(placeWords(withPoint('a', empty), new Map()))).toMatch(
      /: x 3, y 5, rotation 10 degrees$/,
    );
    expect(placeWords(empty, new Map())).toBeNull();
  });

  it('say where several are, and how they are turned and scaled as one', () => {
    const two = ([0, 40] as const).reduce(
      (document, x) => addHandle(document, { id: `${x}`, kind: 'point', rest: [x, 0], posed: [x, 0] }),
      empty,
    );
    const both = selectHandles(two, ['0', '40']);
    expect(inEnglish(placeWords(transformGroup(both, 30), new Map()))).toBe(
      '2 handles: x 20, y 0, rotation 30 degrees',
    );
    expect(inEnglish(placeWords(transformGroup(both, 0, 1.234), new Map()))).toMatch(
      /rotation 0 degrees, scale 1.23$/,
    );
    const mixed = changeHandles(both, ['0'], (handle) => scaledTo(handle, 2));
    expect(inEnglish(placeWords(mixed, new Map()))).toMatch(/rotation 0 degrees$/);
  });

  it('say its depth, and where that is an end', () => {
    expect(inEnglish(depthWords(withPoint('a', empty)))).toMatch(/: depth 0$/);
    expect(inEnglish(depthWords(withPoint('a', empty, DEPTHS.most)))).toMatch(/, in front$/);
    expect(inEnglish(depthWords(withPoint('a', empty, DEPTHS.least)))).toMatch(/, at the back$/);
    expect(inEnglish(depthWords(empty))).toBeNull();
  });

  it('say where a corner is', () => {
    const places = [
      [0, 0],
      [7.6, 2],
    ] as const;
    const bar = { id: 'left-leg', kind: 'bar', rest: places, posed: places } as const;
    expect(inEnglish(cornerWords(bar, 1))).toBe('Corner 2 of left leg: x 8, y 2');
  });

  it('translate rejections of the solver by their code', () => {
    const message = 'handle “left-hand” at (1, 2) lies outside the domain';
    const error = new C2WarpError('handle-outside', message, { handles: ['left-hand'] });
    expect(inEnglish(errorWords(error))).toMatch(/^“left hand” lies outside the shape/);
    const short = new C2WarpError('bar-too-short', 'handle “bar-1”', { handles: ['bar-1'] });
    expect(inEnglish(errorWords(short))).toMatch(/^Two corners of “bar 1” are in the same place/);
    expect(inEnglish(errorWords(new C2WarpError('domain', 'crossed')))).toBe('crossed');
    const along = (...handles: string[]) =>
      inEnglish(errorWords(new C2WarpError('bars-overlap', 'along', { handles })));
    expect(along('bar-1', 'left-leg')).toMatch(/^“Bar 1” and “left leg” run along each other/i);
    expect(along('polygon-1', 'polygon-1')).toMatch(/^“Polygon 1” runs back along itself/i);
    expect(inEnglish(errorWords(new Error('no such file')))).toBe('no such file');
  });

  it('say which corner a drawing has got', () => {
    const draft = {
      kind: 'bar',
      corners: [
        [0, 0],
        [1.6, 2],
      ],
      taken: [],
      next: null,
      finishing: false,
    } as const;
    expect(inEnglish(draftWords(draft))).toBe('bar, corner 2: x 2, y 2');
    expect(inEnglish(draftWords(null))).toBe('Drawing cancelled');
  });
});
