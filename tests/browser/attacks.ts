/** Attacks on the editor by its surroundings: how often, and where each begins. */
import { expect } from '@playwright/test';
import { randomOf } from '../../web/src/editor/random';
import type { Editor } from './editor';
import { disc, png } from './files';

/** How often an attack is made: `npm run test:long` has all of them. */
export const times = (all: number, few: number): number => (process.env.LONG_TESTS ? all : few);

/** The same random numbers in every run. @param name of the attack. */
export const randomIn = (name: string): (() => number) =>
  randomOf([...name].reduce((sum, character) => (sum * 31 + character.charCodeAt(0)) | 0, 7));

/** Opens a disc as wide as its picture, and places a handle in its middle. */
export async function openWithHandle(editor: Editor, name: string, side: number): Promise<void> {
  await editor.chooseFile(png(name, disc(side)));
  await expect(editor.page.getByText(name, { exact: true })).toBeVisible();
  await editor.page.keyboard.press('p');
  await editor.page.keyboard.press('Enter');
  await expect(editor.handles).toHaveCount(1);
}
