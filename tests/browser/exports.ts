/** Exports by the panel, as small as they can be. */
import { type Download, expect } from '@playwright/test';
import type { Editor } from './editor';

const panelOf = ({ page }: Editor) => page.getByRole('dialog', { name: 'Export' });

/** Opens a page of the panel. */
async function open(editor: Editor, kind: string): Promise<void> {
  const panel = panelOf(editor);
  if (!(await panel.isVisible())) await editor.button('Export as …').click();
  await panel.getByRole('button', { name: kind, exact: true }).click();
}

/** Exports a PNG, whatever was exported last. */
export async function exportPicture(editor: Editor): Promise<Download> {
  await open(editor, 'Picture');
  const download = editor.page.waitForEvent('download');
  await panelOf(editor).getByRole('button', { name: 'Export PNG' }).click();
  return download;
}

/** Exports a film at 5 % of the size. The picture needs a clip. */
export async function exportFilm(editor: Editor, format: string): Promise<Download> {
  const panel = panelOf(editor);
  await open(editor, 'Film');
  const size = panel.getByRole('spinbutton', { name: 'Size (%)' });
  await size.fill('5');
  await size.press('Enter');
  await panel.getByRole('button', { name: format, exact: true }).click();
  const download = editor.page.waitForEvent('download');
  await panel.getByRole('button', { name: `Export ${format}` }).click();
  const film = await download;
  await expect(panel).toBeHidden();
  return film;
}

/** Exports a rig for web pages. */
export async function exportRig(editor: Editor): Promise<Download> {
  const panel = panelOf(editor);
  await open(editor, 'Web page');
  const download = editor.page.waitForEvent('download');
  await panel.getByRole('button', { name: 'Export rig' }).click();
  const rig = await download;
  await expect(panel).toBeHidden();
  return rig;
}
