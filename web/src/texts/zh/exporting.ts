/** The export panel. */
import type { Texts } from '../texts';
import { list, number } from './language';

export const exporting: Texts['exporting'] = {
  kind: '类型',
  kinds: { picture: '图片', film: '影片', page: '网页', engine: '引擎', maps: '贴图' },
  format: '格式',
  size: '尺寸',
  quality: '质量',
  background: '背景',
  area: '区域',
  original: '原图',
  allOfIt: '全部',
  covered: '有内容处',
  export: (format) => `导出 ${format}`,
  exportRig: '导出 Rig',
  exportMap: '导出贴图',
  exportWeights: '导出权重',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: '每个像素原样保留，支持透明。',
    jpeg: '照片文件较小，不支持透明。',
    webp: '文件较小，支持透明。',
    svg: '路径已变形的矢量图，任何尺寸下都清晰。',
  },
  areaNotes: {
    picture: '原图的矩形范围。',
    grown: '扩大范围，以容纳变形后超出原图的部分。',
    covered: '只包含有内容的部分，不留空白边缘。',
  },
  remark: (detail) => `备注：${detail}`,
};

export const film: Texts['film'] = {
  noClip: '还没有 Clip：影片展示的是一个 Clip。',
  openTimeline: '打开时间轴',
  clip: 'Clip',
  frames: 'PNG 序列',
  sheet: '精灵图',
  formatNotes: {
    webm: '文件小，支持柔和透明。适合网页。',
    mp4: '文件小，不支持透明。几乎到处都能播放。',
    gif: '到处都能播放。255 种颜色，边缘生硬。',
    apng: '每个像素原样保留，支持柔和透明。',
    webp: '每个像素原样保留，比 APNG 小。',
    frames: '一个 zip，每帧一张 PNG。',
    sheet: '一个 zip，所有帧合为一张 PNG，附带供游戏引擎使用的 JSON 文件。',
  },
  codec: (name) => `编码器：${name}。`,
  codecWithEvenSides: (name, width, height) => `编码器：${name}。边长须为偶数：${width} × ${height} px。`,
  gifRate: (most) => `GIF 将采用每秒 ${most} 帧，这是播放器支持的上限。`,
  noCodec: (formats) => `${list(formats)}：此浏览器无法编码。`,
  rate: '帧率',
  rateTip: '每秒帧数',
  allFrames: '所有帧',
  part: '范围',
  wholeClip: '整个 Clip',
  aPart: '一段',
  from: '从',
  to: '到',
  transparent: '透明',
  colour: '颜色',
  softEdgesOn: '柔和边缘的底色',
  frameCount: (count) => `${number(count)} 帧`,
  estimate: (size, time) => `约 ${size}，${time}`,
  aFewSeconds: '几秒',
  aFewSecondsLeft: '还剩几秒',
  left: (time) => `还剩约 ${time}`,
};

export const webPage: Texts['webPage'] = {
  note: '一个包含所有 Clip 的小文件，供 player 使用：它是 14 kB 的脚本，无需编辑器。',
  withoutClips: '还没有 Clip：网页将显示姿势。',
  readers: '读者',
  watch: '观看 Clip',
  pose: '移动控制点',
  solver: '网页会再加载 100 kB，文件也会增大约同样的大小。',
  code: '代码',
  copyCode: '复制代码',
  codeNote: '将代码粘贴到网页中，网页须与该文件以及软件包的文件夹“player”放在一起。',
  codeCopied: (file) =>
    `已复制。代码会在网页中显示 ${file}，网页须与该文件以及软件包的文件夹“player”放在一起。`,
  codeNotCopied: '浏览器阻止了剪贴板。代码已选中：请手动复制。',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Spine 4.2 及其运行时：JSON、atlas 和 PNG。',
    dragonbones: 'DragonBones 5.5 及其运行时：两个 JSON 文件和一张 PNG。',
    gltf: '用于 three.js、Blender 等的 glTF 2.0：一个文件。',
    godot: 'Godot 4 的场景，附带 PNG。',
  },
  clips: (count) =>
    count === 0 ? '网格、骨骼和姿势。还没有 Clip。' : `包含 ${number(count)} 个 Clip，作为动画。`,
  rough: '骨骼的混合比控制点简单，因此 Rig 会略有偏差。导出时会告知偏差有多大。',
  bones: '骨骼',
  bonesTip: '除根骨骼外的最大骨骼数；每个控制点各有一根',
  vertices: '顶点',
  verticesTip: '网格的最大顶点数',
  influences: '每个顶点的骨骼数',
  files: '文件',
  zip: 'Zip',
  folder: '文件夹',
  lossCaption: (bones, sites, vertices) =>
    `上一个 Rig 用 ${bones} 根骨骼对应 ${sites} 个点位，有 ${vertices} 个顶点。偏差如下，以像素计：`,
  largest: '最大',
  pose: '姿势',
  randomPoses: '随机姿势',
  clip: (name) => `Clip：${name}`,
  betweenVertices: '顶点之间',
  loss: (percentile, largest) => `99 % 的顶点偏差不超过 ${percentile} px，最大偏差为 ${largest} px。`,
};

export const maps: Texts['maps'] = {
  map: '贴图',
  names: {
    inverse: '逆向',
    forward: '正向',
    stretch: '拉伸',
    disocclusion: '遮挡变化',
    heat: '热图',
    weights: '权重',
  },
  notes: {
    inverse: '供合成软件使用的 ST 贴图：让其他图片像这张图片一样变形。',
    forward: '反方向：作为 ST 贴图用于变形后的图片，可还原变形。',
    stretch: '变形后图片的每个像素处，面积和长度增大了多少。',
    disocclusion: '红色表示变形后露出的地方，绿色表示被遮住的地方。',
    heat: '图片跟随某个控制点的程度，以颜色叠加在原图上。',
    weights: '原图各点跟随的程度，以数值供脚本使用。',
  },
  formatNotes: {
    exr: '32 位浮点的 OpenEXR。文件头说明各通道的含义。',
    png: '每通道 16 位，供不支持 OpenEXR 的软件使用。',
  },
  csvNote: '每个大于 0 的权重占一行。',
  npyNote: '供 NumPy 使用的数组。',
  npyZipNote: '一个 zip：供 NumPy 使用的数组，以及其点位列表。',
  of: '对象',
  allSites: '所有点位',
  selectedHandle: '所选控制点',
  every: '点与点之间的像素数',
  points: (width, height) => `${number(width)} × ${number(height)} 个点`,
  selected: (handle) => `所选：${handle}。`,
};
