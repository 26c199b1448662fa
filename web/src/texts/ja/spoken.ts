/** Texts for screen readers: labels of handles, and announcements. */
import type { Texts } from '../texts';

const rotation = (degrees: number): string => `回転${degrees}度`;

export const spoken: Texts['spoken'] = {
  point: (name) => (name.includes('ハンドル') || name.includes('ポイント') ? name : `ハンドル「${name}」`),
  bar: (name, corners) =>
    name.includes('バー') ? `${name}、角${corners}個` : `ハンドル「${name}」、バー、角${corners}個`,
  polygon: (name, corners) =>
    name.includes('多角形') ? `${name}、角${corners}個` : `ハンドル「${name}」、多角形、角${corners}個`,
  x: (x) => `x ${x}`,
  y: (y) => `y ${y}`,
  rotation,
  scale: (scale) => `倍率${scale}`,
  depth: (depth) => `重なり順${depth}`,
  behind: '別の部分の後ろ',
  corner: (corner, handle, x, y) => `${handle}の角 ${corner}、x ${x}、y ${y}`,

  place: (handles, x, y, degrees, scale) =>
    `${handles}：x ${x}、y ${y}、${rotation(degrees)}${scale === null ? '' : `、倍率${scale}`}`,
  time: (time) => time,
  at: (x, y) => `x ${x}、y ${y}`,
  cornerAt: (corner, handle, x, y) => `${handle}の角 ${corner}：x ${x}、y ${y}`,
  selectionCornerAt: (corner, x, y) => `選択範囲の角 ${corner}：x ${x}、y ${y}`,
  depthOf: (handle, depth) => `${handle}：重なり順${depth}`,
  depthInFront: (handle, depth) => `${handle}：重なり順${depth}、最前面`,
  depthAtBack: (handle, depth) => `${handle}：重なり順${depth}、最背面`,
  draft: {
    bar: (corner, x, y) => `バー、角 ${corner}：x ${x}、y ${y}`,
    polygon: (corner, x, y) => `多角形、角 ${corner}：x ${x}、y ${y}`,
    lasso: (corner, x, y) => `投げ縄、角 ${corner}：x ${x}、y ${y}`,
  },
  drawingGivenUp: '描画をやめました',
  stepAt: (step, place) => `${step}。${place}`,
  undone: (step) => `元に戻しました：${step}`,
  redone: (step) => `やり直しました：${step}`,
  selected: (handles) => `${handles}を選択しました`,
  copiedPose: (handles) => `${handles}のポーズをコピーしました`,
  cancelled: '中止しました',
  stoppedAtFold: '画像が折れる手前で停止しました',
  held: 'つかみました。矢印キーで押し、Enterで放します',
  cornerCrosses: '輪郭が自分自身と交差します',
  cornerStays: 'この角は輪郭に必要です',
  brushSize: (percent) => `ブラシのサイズ${percent}パーセント`,
  brush: {
    push: 'ブラシ：押す',
    pinch: 'ブラシ：縮める',
    bloat: 'ブラシ：膨らます',
    smooth: 'ブラシ：ならす',
    restore: 'ブラシ：戻す',
    stiffen: 'ブラシ：固める',
    paints: 'ブラシ：硬さを塗る',
    erases: 'ブラシ：硬さを消す',
  },
  pictureOpen: (name) => `${name}が開きました`,
  toolAndPicture: (tool, picture) => `${tool}、${picture}が開きました`,
  timelineOpen: 'タイムライン',
  timelineClosed: 'タイムラインを閉じました',
  exporting: (percent) => `書き出し中、${percent}パーセント`,
  exportCancelled: '書き出しを中止しました',
};
