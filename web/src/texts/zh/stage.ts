/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import type { Texts } from '../texts';
import { number } from './language';

export const stage: Texts['stage'] = {
  keys: '方向键移动所选内容。逗号键和句号键旋转，同时按住 Alt 则缩放。',
  noPicture: '没有图片',
  picture: (name) => `图片：${name}`,
  disabled: (picture) => `${picture}，已停用`,
  posable: (picture) => `${picture}，可通过控制点摆姿势`,
  original: '原图',
  opening: '正在打开…',
  drop: '将图片拖放或粘贴到这里，或者',
  openPicture: '打开图片',
  required: '请打开一张图片。',
  wouldFold: '此处会折叠',
  dismiss: '关闭',
  handles: '控制点',
  selectionCorners: '选区的角点',
  selectionCorner: (corner, part, x, y) =>
    `${part === null ? '选区' : `选区第 ${part} 部分`}的第 ${corner} 个角点，x ${x}，y ${y}`,
  selectionCornerKeys: '方向键移动角点。Del 将其删除，C 在其后添加一个。',
  pictureMenu: '图片',
  cornerMenu: (corner, handle) => `${handle}：第 ${corner} 个角点`,
};

export const hints: Texts['hints'] = {
  bar: { click: '拖动以绘制折线，或单击各个角点', tap: '拖动以绘制折线，或点按各个角点' },
  polygon: { click: '单击多边形的各个角点', tap: '点按多边形的各个角点' },
  lasso: {
    click: '圈出要变形的部分：拖动，或单击各个角点',
    tap: '圈出要变形的部分：拖动，或点按各个角点',
  },
  lassoAgain: '拖动选区的角点，或圈出另一个部分',
  select: {
    click: '选择点工具，然后单击图片',
    tap: '选择点工具，然后点按图片',
  },
  point: {
    click: '在图片上单击要放置控制点的位置',
    tap: '在图片上点按要放置控制点的位置',
  },
  snapToEdges: '吸附到边缘',
  snapToEdgesTip: '套索会贴合图片中的边缘。按住 Alt 可自由绘制',
};

export const drawing: Texts['drawing'] = {
  label: '绘制',
  ready: '添加角点，或完成',
  oneMore: '还需 1 个角点',
  more: (count) => `还需 ${count} 个角点`,
  takeBack: '移除最后一个角点',
  giveUp: '取消绘制',
  finish: '完成',
};

export const brush: Texts['brush'] = {
  label: '画笔',
  effect: '画笔效果',
  kinds: {
    push: '推动',
    pinch: '收缩',
    bloat: '膨胀',
    smooth: '平滑',
    restore: '恢复',
    stiffen: '硬化',
  },
  tips: {
    push: '推动：拖着图片移动',
    pinch: '收缩：将图片向内收拢',
    bloat: '膨胀：将图片向外推开',
    smooth: '平滑：抚平画笔的笔触',
    restore: '恢复：去除画笔的笔触',
    stiffen: '硬化：让涂过的区域保持刚性',
  },
  hints: {
    push: '拖动以推动图片。',
    pinch: '按住或拖动，将图片向内收拢。',
    bloat: '按住或拖动，将图片向外推开。',
    smooth: '拖动以抚平画笔的笔触。',
    restore: '拖动以去除画笔的笔触。',
    stiffen: '在要保持刚性的区域上拖动。',
  },
  altHints: {
    push: '按住 Alt 可恢复。',
    pinch: '按住 Alt 可膨胀。',
    bloat: '按住 Alt 可收缩。',
    smooth: '',
    restore: '按住 Alt 可推动。',
    stiffen: '按住 Alt 可擦除。',
  },
  size: '大小',
  strength: '强度',
  sizeLabel: '画笔大小（%）',
  strengthLabel: '画笔强度（%）',
  erase: '擦除',
  eraseTip: '擦除刚度',
  clearStiffness: '清除刚度',
  clearStiffnessTip: '让整张图片恢复柔软',
  clearStrokes: '清除画笔笔触',
  clearStrokesTip: '从图片中去除所有画笔笔触',
  holding: '方向键推动，Enter 松开。',
  rigidOnly: '刚度仅在刚性模式下起作用。',
  bendRigidly: '使用刚性模式',
};

export const status: Texts['status'] = {
  label: '状态',
  hasCreases: '图片有折叠',
  privacy: '任何内容都不会离开浏览器',
  privacyTip: '图片的打开、变形和保存都只在这台设备上进行。',
  view: '视图',
  zoom: '缩放',
  seeIt: '预览',
  out: '缩小',
  in: '放大',
  fit: '适合',
  actual: '实际',
  stoppedAtFold: '已在折叠前停止',
  creases: (count) => `${number(count)} 处折叠`,
  creasesAnd: (creases, effect) => `${creases}。${effect}`,
  hideCreases: '隐藏折叠',
  showCreases: '显示折叠',
  zoomToCrease: '放大到折叠处',
  zoomToNextCrease: '放大到下一处折叠',
  cancel: '取消',
  samples: (count) => `${number(count)} 个网格点`,
  virtualHandles: (count) => `${number(count)} 个辅助点`,
};

export const tasks: Texts['tasks'] = {
  opening: (name) => `正在打开：${name}`,
  start: '正在查找轮廓',
  domain: '正在构建网格',
  sampling: '正在测量距离',
  regions: '正在计算权重',
  weights: '正在计算权重',
  suggesting: '正在寻找放置控制点的位置',
  filling: '正在填充背景',
  exporting: '正在导出',
};
