/** Errors of the solver and its worker. */
import type { Texts } from '../texts';

export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: '图片太大，内存不足。请缩小图片。',
  pictures: '这些图片太大，内存不足。请缩小图片。',
  suggest: '内存不足，无法推荐控制点。请缩小图片。',
  solve: '内存不足，无法完成此变形。请减少控制点，或降低精细度。',
  fill: '内存不足，无法填充背景。请缩小图片。',
  draw: '内存不足，无法绘制图片。请选择较小的尺寸。',
  film: '此浏览器的内存不足，无法绘制影片。请选择较小的尺寸。',
  points: '点太多，内存不足。',
  cells: '此浏览器的内存不足，无法计算单元。',
  study: '此浏览器的内存不足，无法计算图表。',
  lens: '此浏览器的内存不足，无法使用透镜。',
  rig: '这些片段太长，此浏览器无法制作 Rig。请将其缩短。',
  map: '文件对此浏览器来说太大。请改用命令行。',
  drawing: '矢量图太复杂，此浏览器无法使其变形。请将其简化。',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `无法加载计算引擎：${why}`,
  exportNotLoaded: (why) => `无法启动导出：${why}`,
  status: (address, status) => `服务器对 ${address} 返回 ${status}。`,
  isPage: (address) => `服务器返回的是网页，而不是 ${address}。`,
  absent: (address) => `无法访问 ${address}。请检查网络连接和页面的安全策略。`,
  incomplete: (address, detail) => `${address} 不完整，或无法在此运行（${detail}）。`,
  noWorkers: '无法启动计算引擎：此浏览器或此页面不允许 worker。',
  notStarted: (address) => `无法启动计算引擎。请检查 ${address} 是否存在，以及页面是否允许 worker。`,
  exportNotStarted: (address) => `无法启动导出。请检查 ${address} 是否存在，以及页面是否允许 worker。`,
  drawingNotChecked: '无法加载此矢量图所需的编辑器组件。请检查网络连接，并确认页面允许使用 worker。',
  lostDrawing: '计算引擎在绘制过程中出错。',
  released: '图片的像素已不在内存中。请重新打开图片。',
};

export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `项目无效：${detail}`,
  picture: (detail) => `无法使用此图片：${detail}`,
  'picture-mismatch': () => '此项目属于另一尺寸的图片。',
  scale: () => '导出的图像会过大或过小。请选择其他尺寸。',
  canvas: () => '扩展后的图片会过大。请选择较小的尺寸，或原图的边框。',
  'nothing-drawn': () => '图片处处透明。',
  'nothing-opaque': () => '图片没有足够不透明的部分可供变形。请降低“最低不透明度”。',
  'nothing-to-fill-from': () => '选区之外没有可用来填充背景的内容。请画一个较小的选区，或关闭填充。',
  'no-outline': () => '图片没有透明部分，因此没有可供 Rig 适配的轮廓。',
  domain: (detail) => `选区无效：${detail}`,
  'handle-outside': (_, name) => `“${name}”在形状之外。请将其放在图片上。`,
  'handle-far-outside': (_, name) => `此 Rig 与图片不符：“${name}”会远在图片之外。`,
  'handles-too-close': (_, name, other) => `“${name}”和“${other}”在同一位置。请移动或删除其中一个。`,
  'bar-too-short': (_, name) => `“${name}”有两个角点在同一位置。请移动或删除其中一个。`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `“${name}”沿自身折返。各段可以交叉或接触，但不能重叠。`
      : `“${name}”和“${other}”有一段重合。它们可以交叉或接触，但不能重叠。`,
  'on-held-boundary': (_, name) => `“${name}”在固定的轮廓上。请将其移到更靠内的位置，或解除轮廓固定。`,
  'too-many-handles': () => '控制点太多。请删除一些。',
  'too-many-corners': (_, name) =>
    `折线和多边形的角点太多。${name ? `请减少“${name}”的角点` : '请减少角点'}。`,
  'handles-crowded': () => '有太多控制点彼此非常近。请将一些移开或删除。',
  'outline-too-long': () => '此轮廓的缝隙和尖刺太多。请画一个较简单或较粗略的轮廓。',
  'too-many-sites': () => '控制点太多或彼此太近。请将一些移开，或降低精细度。',
  'too-much-memory': () => '此变形所需的内存超出浏览器的上限。请减少控制点，或降低精细度。',
  'too-much-work': () => '此变形过于复杂，无法在几秒内算出。请减少控制点，或使用较简单的轮廓。',
  'held-too-fine': () => '此轮廓的角点太多，无法固定。请画一个较简单的轮廓，或解除轮廓固定。',
  unsupported: (detail) => `项目中有不受支持的设置：${detail}`,
  pose: (detail) => `姿势无效：${detail}`,
  film: (detail) => `无法制作此影片：${detail}`,
  'point-outside': (detail) => `点在形状之外：${detail}`,
  mesh: (detail) => `网格无效：${detail}`,
  cloud: (detail) => `点云无效：${detail}`,
  poser: (detail) => `无法计算姿势：${detail}`,
};
