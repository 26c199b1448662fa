/** Texts for screen readers: labels of handles, and announcements. */
import type { Texts } from '../texts';

const rotation = (degrees: number): string => `旋转 ${degrees} 度`;

export const spoken: Texts['spoken'] = {
  point: (name) => (name.includes('控制点') ? name : `控制点 ${name}`),
  bar: (name, corners) =>
    name.includes('折线') ? `${name}，${corners} 个角点` : `控制点 ${name}，折线，${corners} 个角点`,
  polygon: (name, corners) =>
    name.includes('多边形') ? `${name}，${corners} 个角点` : `控制点 ${name}，多边形，${corners} 个角点`,
  x: (x) => `x ${x}`,
  y: (y) => `y ${y}`,
  rotation,
  scale: (scale) => `缩放 ${scale}`,
  depth: (depth) => `深度 ${depth}`,
  behind: '在另一部分后面',
  corner: (corner, handle, x, y) => `${handle} 的第 ${corner} 个角点，x ${x}，y ${y}`,

  place: (handles, x, y, degrees, scale) =>
    `${handles}：x ${x}，y ${y}，${rotation(degrees)}${scale === null ? '' : `，缩放 ${scale}`}`,
  time: (time) => time,
  at: (x, y) => `x ${x}，y ${y}`,
  cornerAt: (corner, handle, x, y) => `${handle} 的第 ${corner} 个角点：x ${x}，y ${y}`,
  selectionCornerAt: (corner, x, y) => `选区的第 ${corner} 个角点：x ${x}，y ${y}`,
  depthOf: (handle, depth) => `${handle}：深度 ${depth}`,
  depthInFront: (handle, depth) => `${handle}：深度 ${depth}，在最前面`,
  depthAtBack: (handle, depth) => `${handle}：深度 ${depth}，在最后面`,
  draft: {
    bar: (corner, x, y) => `折线，第 ${corner} 个角点：x ${x}，y ${y}`,
    polygon: (corner, x, y) => `多边形，第 ${corner} 个角点：x ${x}，y ${y}`,
    lasso: (corner, x, y) => `套索，第 ${corner} 个角点：x ${x}，y ${y}`,
  },
  drawingGivenUp: '已取消绘制',
  stepAt: (step, place) => `${step}。${place}`,
  undone: (step) => `已撤销：${step}`,
  redone: (step) => `已重做：${step}`,
  selected: (handles) => `已选择：${handles}`,
  copiedPose: (handles) => `已复制姿势：${handles}`,
  cancelled: '已取消',
  stoppedAtFold: '已在图片折叠之前停止',
  held: '已抓住。方向键推动，Enter 松开',
  cornerCrosses: '轮廓会自相交叉',
  cornerStays: '轮廓需要这个角点',
  brushSize: (percent) => `画笔大小 ${percent}%`,
  brush: {
    push: '画笔：推动',
    pinch: '画笔：收缩',
    bloat: '画笔：膨胀',
    smooth: '画笔：平滑',
    restore: '画笔：恢复',
    stiffen: '画笔：硬化',
    paints: '画笔：绘制刚度',
    erases: '画笔：擦除刚度',
  },
  pictureOpen: (name) => `已打开：${name}`,
  toolAndPicture: (tool, picture) => `${tool}，已打开：${picture}`,
  timelineOpen: '时间轴',
  timelineClosed: '时间轴已关闭',
  exporting: (percent) => `正在导出，${percent}%`,
  exportCancelled: '导出已取消',
};
