/** Pages without a framework. */
import { type C2Warp, C2WarpError, type C2WarpErrorCode, type ToolName } from 'c2warp';
import manifest from 'c2warp/custom-elements.json';
import type { C2WarpPlayer } from 'c2warp/player';

const warp: C2Warp = document.createElement('c2-warp');
const player: C2WarpPlayer = document.createElement('c2-warp-player');

warp.addEventListener('selectionchange', ({ detail }) => {
  const ids: readonly string[] = detail.selection;
  // @ts-expect-error A selection has ids.
  const numbers: readonly number[] = detail.selection;
  return [ids, numbers];
});

warp.addEventListener('error', ({ detail }) => {
  const code: C2WarpErrorCode = detail.code;
  const handles: readonly string[] = detail.handles;
  // @ts-expect-error There is no such code.
  if (detail.code === 'handle-inside') return [];
  return detail.code === 'handle-outside' ? handles : [code, detail.message];
});

warp.load('cat.png').catch((error: unknown) => {
  if (error instanceof C2WarpError && error.code === 'image-size') warp.load('cat.png');
});

const tool: ToolName = warp.tool;
warp.tool = tool;
warp.tool = null;
// @ts-expect-error There is no such tool.
warp.tool = 'pencil';
// @ts-expect-error There is no such theme.
warp.theme = 'blue';
// @ts-expect-error A boolean property.
warp.readonly = 3;
// @ts-expect-error It can only be read.
warp.naturalWidth = 3;

player.addEventListener('error', ({ message }) => message.length);
player.pose([{ id: 'head', posed: [1, 2] }]);
// @ts-expect-error A handle has an id.
player.pose([{ posed: [1, 2] }]);

manifest.modules.map(({ declarations }) => declarations.map(({ tagName }) => tagName));
