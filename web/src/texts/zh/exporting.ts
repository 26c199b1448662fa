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
  allOfIt: '扩展',
  covered: '裁剪',
  export: (format) => `导出 ${format}`,
  exportRig: '导出 Rig',
  exportMap: '导出贴图',
  exportWeights: '导出权重',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: '无损，支持透明。',
    jpeg: '适合照片的小文件，不支持透明。',
    webp: '文件小，支持透明。',
    svg: '路径已变形的矢量图，任何尺寸下都清晰。',
  },
  areaNotes: {
    picture: '原图的边框。',
    grown: '扩展边框，以容纳变形后超出原图的部分。',
    covered: '裁剪到可见部分，不留空白边缘。',
  },
  remark: (detail) => `备注：${detail}`,
};

export const film: Texts['film'] = {
  noClip: '影片需要一个片段。请在时间轴中添加。',
  openTimeline: '打开时间轴',
  clip: '片段',
  frames: 'PNG 序列',
  sheet: '精灵图',
  formatNotes: {
    webm: '文件小，支持柔和透明，适合网页。',
    mp4: '文件小，不支持透明。几乎到处都能播放。',
    gif: '到处都能播放，但只有 255 种颜色，边缘生硬。',
    apng: '无损，支持柔和透明。',
    webp: '无损，且比 APNG 小。',
    frames: '一个 zip，每帧一张 PNG。',
    sheet: '一个含精灵图的 zip：所有帧合为一张 PNG，并附带供游戏引擎使用的 JSON 文件。',
  },
  codec: (name) => `编码器：${name}。`,
  codecWithEvenSides: (name, width, height) =>
    `编码器：${name}。宽和高会向上取为偶数：${width} × ${height} px。`,
  gifRate: (most) => `GIF 最多每秒 ${most} 帧，这是播放器支持的上限。`,
  noCodec: (formats) => `此浏览器无法编码 ${list(formats)}。`,
  rate: '帧率',
  rateTip: '每秒帧数',
  allFrames: '扩展',
  part: '范围',
  wholeClip: '整个片段',
  aPart: '一段',
  from: '从',
  to: '到',
  transparent: '透明',
  colour: '颜色',
  softEdgesOn: '边缘底色',
  frameCount: (count) => `${number(count)} 帧`,
  estimate: (size, time) => `约 ${size}，${time}`,
  aFewSeconds: '几秒',
  aFewSecondsLeft: '还剩几秒',
  left: (time) => `还剩约 ${time}`,
};

export const webPage: Texts['webPage'] = {
  note: '一个包含所有片段的小文件。15 kB 的播放脚本无需编辑器即可显示它。',
  withoutClips: '没有片段时，网页显示当前姿势。',
  readers: '访客可以',
  watch: '观看片段',
  pose: '移动控制点',
  solver: '这会使文件增大约 100 kB，网页也会多加载 100 kB。',
  code: '代码',
  copyCode: '复制代码',
  codeNote: '请将代码粘贴到网页中，并把该文件和软件包的文件夹“player”放在网页旁边。',
  codeCopied: (file) => `已复制。请把 ${file} 和软件包的文件夹“player”放在网页旁边。`,
  codeNotCopied: '浏览器阻止了剪贴板。请自行复制已选中的代码。',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: '用于 Spine 4.2 及其运行时：JSON、atlas 和 PNG。',
    dragonbones: '用于 DragonBones 5.5 及其运行时：两个 JSON 文件和一张 PNG。',
    gltf: '用于 three.js、Blender 等的 glTF 2.0，一个文件。',
    godot: 'Godot 4 的场景，附带 PNG。',
  },
  clips: (count) =>
    count === 0 ? '包含网格、骨骼和姿势。添加片段后会包含动画。' : `包含 ${number(count)} 个片段，作为动画。`,
  rough: '骨骼只是近似控制点，因此 Rig 会略有偏差。导出时会告知偏差有多大。',
  bones: '骨骼',
  bonesTip: '最大骨骼数，不计根骨骼',
  vertices: '顶点',
  verticesTip: '网格的最大顶点数',
  influences: '每个顶点的骨骼数',
  files: '文件',
  zip: 'Zip',
  folder: '文件夹',
  lossCaption: (bones, sites, vertices) =>
    `上一个 Rig 用 ${bones} 根骨骼对应 ${sites} 个控制点和辅助点，有 ${vertices} 个顶点。误差（像素）：`,
  largest: '最大',
  pose: '姿势',
  randomPoses: '随机姿势',
  clip: (name) => `片段：${name}`,
  betweenVertices: '顶点之间',
  loss: (percentile, largest) => `99 % 的顶点误差不超过 ${percentile} px，最大误差为 ${largest} px。`,
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
    inverse: '供合成软件使用的 ST 贴图。可将此变形应用于其他图片。',
    forward: '用于变形后的图片时可还原变形的 ST 贴图。',
    stretch: '变形后图片的每个像素处，面积和长度增大了多少。',
    disocclusion: '红色表示变形后露出的区域，绿色表示被遮住的区域。',
    heat: '图片跟随某个控制点的程度，以颜色叠加在原图上。',
    weights: '原图各点跟随每个控制点的程度，以数值供脚本使用。',
  },
  formatNotes: {
    exr: '32 位浮点的 OpenEXR。文件头说明各通道的含义。',
    png: '每通道 16 位，供不支持 OpenEXR 的软件使用。',
  },
  csvNote: '每个大于 0 的权重占一行。',
  npyNote: '一个 NumPy 数组。',
  npyZipNote: '一个 zip，含 NumPy 数组以及控制点和辅助点的列表。',
  of: '权重属于',
  allSites: '所有控制点',
  selectedHandle: '所选控制点',
  every: '间隔（像素）',
  points: (width, height) => `${number(width)} × ${number(height)} 个点`,
  selected: (handle) => `所选：${handle}。`,
};
