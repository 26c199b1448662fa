import { describe, expect, it } from 'vitest';
import { de } from '../texts/de/index';
import { en } from '../texts/en/index';
import { es } from '../texts/es/index';
import { fr } from '../texts/fr/index';
import { ja } from '../texts/ja/index';
import type { PartialTexts } from '../texts/texts';
import { worded } from '../texts/wording';
import { zh } from '../texts/zh/index';
import { newProject, openDocument } from './document';
import { addHandle } from './edits';
import { nameOf } from './handle';
import { mirrorHandles } from './mirror';
import { nameFault, nameWords, numberOf, ofOtherSide, renameHandle, tidyName } from './names';
import type { PointHandle } from './project';
import { followedHandles, solveKey, withIdsOf } from './solved';

const handle = (id: string, x = id.length): PointHandle => ({
  id,
  kind: 'point',
  rest: [x, 0],
  posed: [x, 0],
});
const documentOf = (...handles: readonly PointHandle[]) =>
  handles.reduce(addHandle, openDocument(newProject({ src: 'a.png', width: 9, height: 9 }, null)));

describe('a name', () => {
  const { project } = documentOf(handle('left-hand'), handle('handle-1'));

  it('is the id, as words where it is written in small letters and hyphens', () => {
    expect(['left-hand', 'T-shirt', 'left hand', 'handle_2'].map((id) => nameOf({ id }))).toEqual([
      'left hand',
      'T-shirt',
      'left hand',
      'handle 2',
    ]);
  });

  it('is stored without surplus spaces', () => {
    expect(tidyName('  long \t tail ')).toBe('long tail');
  });

  it('is refused if it is empty, or reads like another one', () => {
    const fault = (name: string) => nameFault(project, 'handle-1', name);
    expect(['', 'LEFT hand', 'left_hand', 'left, hand'].map(fault)).toEqual([
      'empty',
      'taken',
      'taken',
      'taken',
    ]);
    expect(['nose', 'Handle 1', 'left-hand-2'].map(fault)).toEqual([null, null, null]);
  });

  it('replaces the id of a handle and its place in the selection', () => {
    const renamed = renameHandle(documentOf(handle('head'), handle('left-hand')), 'left-hand', 'Paw');
    expect(renamed.project.handles.map(({ id }) => id)).toEqual(['head', 'Paw']);
    expect(renamed.selection).toEqual(['Paw']);
  });

  it('has a number until somebody gives one', () => {
    const ids = ['handle-12', 'bar-2', 'head', 'left-hand-2', 'Handle 3'];
    expect(ids.map((id) => numberOf(handle(id)))).toEqual(['12', '2', null, null, null]);
  });

  it('of a suggested handle is in the language of its reader', () => {
    const ids = [
      'left-arm-end',
      'upper-right-leg-2-joint',
      'tail-joint-3',
      'head',
      'body-2',
      'top-left',
      'middle-2',
    ];
    const inLanguage = (texts: PartialTexts) => ids.map((id) => worded(texts, nameWords({ id })));
    expect(inLanguage(en)).toEqual([
      'left arm, end',
      'upper right leg 2, joint',
      'tail, joint 3',
      'head',
      'body 2',
      'top left',
      'middle 2',
    ]);
    expect(inLanguage(de)).toEqual([
      'linker Arm, Ende',
      'oberes rechtes Bein 2, Gelenk',
      'Schwanz, Gelenk 3',
      'Kopf',
      'Körper 2',
      'oben links',
      'Mitte 2',
    ]);
    expect(inLanguage(fr).slice(0, 2)).toEqual([
      'bras gauche, extrémité',
      'jambe droite supérieure 2, articulation',
    ]);
    expect(inLanguage(es).slice(0, 2)).toEqual([
      'brazo izquierdo, extremo',
      'pierna derecha superior 2, articulación',
    ]);
    expect(inLanguage(ja).slice(0, 2)).toEqual(['左の腕、先端', '右上の脚 2、関節']);
    expect(inLanguage(zh).slice(0, 2)).toEqual(['左侧手臂，末端', '右上方腿 2，关节']);
    expect(['left-hand', 'Head', 'arm-one', 'tail-tip'].map((id) => nameWords({ id }))).toEqual([
      'left hand',
      'Head',
      'arm one',
      'tail tip',
    ]);
  });

  it('shows signs that are not drawn', () => {
    expect(nameWords({ id: 'left\u202e-hand\u0007' })).toBe(String.raw`left\u{202e} hand\u{7}`);
  });

  it('is not mirrored beyond its greatest length', () => {
    const box = { min: [0, 0], max: [100, 100] } as const;
    const long = `left ${'x'.repeat(195)}`;
    const { document } = mirrorHandles(documentOf(handle(long, 10)), box, () => true);
    expect(document.project.handles.at(-1)?.id).toBe('handle-1');
  });

  it('says the side of a handle', () => {
    const names = ['left-hand', 'Right eye', 'cleft', 'head'];
    expect(names.map(ofOtherSide)).toEqual(['right-hand', 'Left eye', 'cleft', 'head']);
    const box = { min: [0, 0], max: [100, 100] } as const;
    const { document } = mirrorHandles(documentOf(handle('Left paw', 10)), box, () => true);
    expect(document.project.handles.at(-1)?.id).toBe('Right paw');
  });
});

describe('a renamed handle', () => {
  const before = documentOf(handle('a', 1), handle('b', 2));
  const solved = before.project;

  it('needs no other solution', () => {
    const { project } = renameHandle(before, 'a', 'Paw');
    expect(solveKey(project)).toBe(solveKey(solved));
    expect(withIdsOf(solved, project)).toEqual(solved);
  });

  it('is the handle that was solved at its place, also when names were swapped', () => {
    const swapped = renameHandle(renameHandle(renameHandle(before, 'a', 'c'), 'b', 'a'), 'c', 'b');
    const followed = followedHandles(solved, swapped.project);
    expect(followed.map(({ id, rest }) => [id, rest])).toEqual([
      ['b', [1, 0]],
      ['a', [2, 0]],
    ]);
  });

  it('does not stand for a removed handle of its new name', () => {
    const { project } = renameHandle(documentOf(handle('b', 2)), 'b', 'a');
    expect(followedHandles(solved, project)).toEqual([handle('a', 1), handle('a', 2)]);
  });
});
