/** Errors of the solver and its worker. */
import type { Texts } from '../texts';

export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: '图片所需的内存超出现有内存：请缩小图片。',
  pictures: '这些图片所需的内存超出现有内存：请缩小图片。',
  suggest: '内存不足，无法为此图片推荐控制点：请缩小图片。',
  solve: '现有内存不足，求解器无法完成此操作。',
  fill: '内存不足，无法填充此图片的背景：请缩小图片。',
  draw: '内存不足，无法绘制此图片。',
  film: '绘制影片所需的内存超出此浏览器所能提供的内存。',
  points: '这些点所需的内存超出现有内存。',
  cells: '在此浏览器中，求解器无法处理这么多单元。',
  study: '在此浏览器中，求解器无法处理这些图表。',
  lens: '在此浏览器中，求解器无法处理透镜。',
  rig: '在此浏览器中，Rig 容纳不下这些 Clip：请将其缩短。',
  map: '文件超出此浏览器的容量：可用命令行写出。',
  drawing: '此浏览器无法让这么复杂的矢量图变形：请将其简化。',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `无法加载求解器：${why}`,
  exportNotLoaded: (why) => `无法启动导出：${why}`,
  status: (address, status) => `${address} 返回 ${status}`,
  isPage: (address) => `${address} 不存在：该处是一个网页`,
  absent: (address) => `${address} 没有响应：网络是否正常，页面是否允许访问？`,
  incomplete: (address, detail) => `${address} 不完整，或无法在此运行（${detail}）。`,
  noWorkers: '无法启动求解器：此浏览器或此页面不允许 worker。',
  notStarted: (address) => `求解器出错：无法启动其 worker：${address} 是否存在，页面是否允许访问？`,
  exportNotStarted: (address) => `无法启动导出：${address} 是否存在，页面是否允许 worker？`,
  lostDrawing: '求解器在绘制过程中出错。',
  released: '图片的像素已丢失，或没有足够的内存。请重新打开图片。',
};

export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `项目无效：${detail}`,
  picture: (detail) => `无法使用此图片：${detail}`,
  'picture-mismatch': () => '此项目属于另一尺寸的图片。',
  scale: () => '导出的图像会过大或过小：请选择其他尺寸。',
  canvas: () => '整张图片会过大：请选择较小的尺寸，或原图的矩形范围。',
  'nothing-drawn': () => '没有任何内容：图片处处透明。',
  'nothing-opaque': () => '图片中没有足够不透明的内容可供变形：请降低“最低不透明度”。',
  'nothing-to-fill-from': () => '选区周围没有可用来填充背景的内容：请画一个较小的选区，或将背景留空。',
  'no-outline': () => '图片没有透明部分，因此没有可供 Rig 适配的轮廓。',
  domain: (detail) => `选区无效：${detail}`,
  'handle-outside': (_, name) => `“${name}”在形状之外：请将其放在图片上。`,
  'handle-far-outside': (_, name) => `“${name}”会远在此图片之外：此 Rig 与图片不符。`,
  'handles-too-close': (_, name, other) => `“${name}”和“${other}”在同一位置：请移动或删除其中一个。`,
  'bar-too-short': (_, name) => `“${name}”有两个角点在同一位置：请移动或删除其中一个。`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `“${name}”沿自身折返：各段可以交叉和接触，但不能重叠。`
      : `“${name}”和“${other}”有一段重合：它们可以交叉和接触，但不能重叠。`,
  'on-held-boundary': (_, name) => `“${name}”在固定的边界上：请将其移到更靠内的位置，或放开边界。`,
  'too-many-handles': () => '控制点超出求解器支持的数量：请删除一些。',
  'too-many-corners': (_, name) =>
    `折线和多边形的角点超出求解器支持的数量：${name ? `请减少“${name}”的角点` : '请减少角点'}。`,
  'handles-crowded': () => '有太多控制点彼此非常近：请将一些移开或删除。',
  'outline-too-long': () => '此轮廓的缝隙和尖刺太多：请画一个较简单或较粗略的轮廓。',
  'too-many-sites': () => '控制点彼此太近，或数量太多：请将一些移开，或降低精细度。',
  'too-much-memory': () => '所需内存超出浏览器所能提供的内存：请减少控制点，或降低精细度。',
  'too-much-work': () => '此场景过于复杂，无法在几秒内求解：请减少控制点，或使用较简单的轮廓。',
  'held-too-fine': () => '此轮廓的角点太多，无法固定：请画一个较简单的轮廓，或让它移动。',
  unsupported: (detail) => `项目中有不受支持的设置：${detail}`,
  pose: (detail) => `姿势无效：${detail}`,
  film: (detail) => `无法制作此影片：${detail}`,
  'point-outside': (detail) => `点在形状之外：${detail}`,
  mesh: (detail) => `网格无效：${detail}`,
  cloud: (detail) => `点云无效：${detail}`,
  poser: (detail) => `无法摆出姿势：${detail}`,
};
