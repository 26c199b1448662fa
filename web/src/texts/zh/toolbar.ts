/** The bar at the top with its menus, and the card of tools. */
import type { Texts } from '../texts';
import { number } from './language';

export const toolbar: Texts['toolbar'] = {
  label: '文档',
  open: '打开',
  save: '保存',
  export: '导出',
  undo: '撤销',
  redo: '重做',
  undoStep: (step) => `撤销“${step}”`,
  redoStep: (step) => `重做“${step}”`,
  compare: '比较',
  animate: '动画',
  more: '更多',
  lightColours: '浅色',
  darkColours: '深色',
  unsaved: '未保存',
  unsavedKept: '未保存，已暂存在此浏览器中',
  noFile: '最近的更改尚未存入文件',
  kept: '已暂存在此浏览器中',
};

export const files: Texts['files'] = {
  label: '打开最近的作品、示例或网址',
  address: '图片或项目的网址',
  placeholder: 'https://…/picture.png',
  open: '打开',
  recent: '最近的作品',
  removeAll: '全部移除',
  noRecent: '打开另一张图片后，编辑过的图片会列在这里。',
  remove: (name) => `从列表中移除：${name}`,
  drawing: '未完成的绘制',
  steps: (count) => `${number(count)} 步`,
  samples: '示例',
  openSample: (name) => `打开示例：${name}`,
  whole: '全部存入一个文件',
  saveWhole: '连同图片保存',
  exportWhole: '导出可编辑的 PNG',
};

export const tools: Texts['tools'] = {
  label: '工具',
  select: '移动',
  point: '点',
  bar: '折线',
  polygon: '多边形',
  lasso: '套索',
  brush: '画笔',
  hand: '平移',
  lens: '透镜',
  bend: '变形',
};
