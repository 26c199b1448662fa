/** The timeline of the editor, and the picture at its playhead. */
import type { Locator } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import type { Editor } from './editor';
import { expect } from './fixtures';

export const timeline = ({ page }: Editor): Locator => page.getByRole('region', { name: 'Timeline' });
export const ruler = (editor: Editor): Locator => timeline(editor).getByRole('slider', { name: 'Playhead' });

export async function openTimeline(editor: Editor): Promise<void> {
  await editor.page.keyboard.press('t');
  await expect(timeline(editor)).toBeVisible();
}

/** Moves the playhead by a press on the ruler. */
export async function goTo(editor: Editor, seconds: number): Promise<void> {
  const lane = await ruler(editor).locator('.time').boundingBox();
  const duration = Number(await ruler(editor).getAttribute('aria-valuemax'));
  if (!lane) throw new Error('the ruler is not visible');
  await editor.page.mouse.click(lane.x + (lane.width * seconds) / duration, lane.y + 8);
  await expect
    .poll(async () => Number(await ruler(editor).getAttribute('aria-valuenow')))
    .toBeCloseTo(seconds, 1);
}

/** What the editor draws now at half the size, as a PNG in base64. */
export const drawn = ({ page }: Editor): Promise<string> =>
  page.locator('c2-warp').evaluate(async (element) => {
    const file = await (element as C2Warp).toBlob({ scale: 0.5 });
    let text = '';
    for (const byte of new Uint8Array(await file.arrayBuffer())) text += String.fromCharCode(byte);
    return btoa(text);
  });
