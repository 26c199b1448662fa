/** The card that explains the solution. `r_d` and `r_h` become symbols. */
import type { Texts } from '../texts';
import { number } from './language';

export const study: Texts['study'] = {
  title: '了解论文',
  page: '页面',
  pages: { lens: '透镜', cells: '单元', rounds: '轮次', compare: '比较', settings: '设置' },
  close: '关闭',
  saveAsSvg: '保存为 SVG',
};

export const lens: Texts['lens'] = {
  title: '一个点的权重',
  point: '请指向图片',
  nothingBends: '此处不会变形',
  note: '每个点都按周围控制点的权重移动。也可以用方向键移动透镜。',
  tap: '点按一个点以查看',
  click: '单击以固定此点',
  follow: '跟随指针',
  weights: '权重',
  weightsAt: (x, y) => `x ${x}，y ${y} 处的权重`,
  noHandle: '这一部分没有控制点，因此不动。',
  ownWeight: '自身权重',
  passedOn: '由虚拟控制点传递',
  virtualHandles: '虚拟控制点',
  countOfThem: (count) => `共 ${number(count)} 个`,
  virtual: (number) => `虚拟 ${number}`,
  distancePassed: (distance, percent) => `${distance}，传递 ${percent}`,
  spoken: (x, y, shares) => `x ${x}，y ${y}：${shares.join('、') || '没有控制点带动它'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `虚拟控制点 ${percent}`,

  falloff: '衰减',
  falloffOf: (handle) => `衰减：${handle}`,
  noEnd: '这一部分没有其他控制点，因此支撑域没有尽头。',
  falloffLabel: (value, distance, end) => `在距离 ${distance} 处衰减值为 ${value}，到 ${end} 处结束。`,
  radii: (cell, nearest, support) =>
    `单元 r_d ${cell}${nearest === null ? '' : `，最近的另一个 r_h ${nearest}`}${support === null ? '' : `，支撑域 r ${support}`}。拖动图中的 r，或 α。`,
  distanceAxis: '形状内的距离 d，px',
  thisPoint: (distance) => `此点：${distance} →`,
};

export const cells: Texts['cells'] = {
  title: '单元及其半径',
  none: '没有控制点就没有单元。',
  counts: (own, virtual) => `控制点的单元 ${own} 个，虚拟控制点的单元 ${virtual} 个`,
  label: '形状及其单元和半径',
  farthest: 'r_d，到单元中最远的点',
  nearest: 'r_h，到最近的另一个控制点',
  note: '支撑域覆盖其单元，并在你的下一个控制点之前结束。因此 r_d 必须在 r_h 的限度之内。',
  toFarthest: '到单元中最远的点',
  toNearest: '到最近的另一个点位',
  times: '本次求解的用时',
  stages: {
    domain: '查找轮廓',
    sampling: '采样',
    regions: '距离、单元和虚拟控制点',
    weights: '权重',
    pose: '一个姿势',
  },
};

export const rounds: Texts['rounds'] = {
  title: '算法 1',
  figure: (round) => `算法 1 的第 ${round} 轮`,
  none: '没有控制点就没有可插入的内容。',
  play: '播放',
  pause: '暂停',
  previous: '上一轮',
  next: '下一轮',
  round: '轮次',
  roundOf: (round, rounds) => `第 ${round} 轮，共 ${rounds} 轮`,
  end: (round, handles) => `第 ${round} 轮：结束。没有过大的单元，共有 ${handles} 个控制点。`,
  tooLarge: (round, reach, allowed, enters) =>
    `第 ${round} 轮：有一个单元伸展到 ${reach}，而允许的是 ${allowed}。${enters}`,
  asked: (round, enters) => `第 ${round} 轮：没有过大的单元，但项目要求更多虚拟控制点。${enters}`,
  enters: (handle, distance, others) =>
    `在“${handle}”的单元中加入一个虚拟控制点，相距 ${distance}${others > 0 ? `，另有 ${others} 个加入别处` : ''}。`,
  curve: (score, allowed) => `得分为 ${score}。最高允许 ${allowed}。`,
  note: '每一轮之前最差单元的得分，如论文图 3 所示。在线以下，每个支撑域都覆盖其单元，并在下一个控制点之前结束。此后的各轮插入项目所要求的虚拟控制点。',
  roundAxis: '轮次',
  allowed: '允许值',
};

export const compare: Texts['compare'] = {
  title: '一张图片，三种方法',
  note: '拖动图片的控制点，三张图片都会跟随。',
  names: { paper: '论文', rigid: '刚性', plain: '直线距离' },
  labels: {
    paper: '图片：论文方法',
    rigid: '图片：刚性方法',
    plain: '图片：直线距离方法',
  },
  notes: {
    paper: '采用形状内的距离和调和场。控制点由你自己旋转。',
    rigid: '形状尽可能保持原样。控制点自行旋转。',
    plain: '与论文相同，但距离会跨越空隙，因此邻近的部分也会跟着移动。',
  },
};

export const settings: Texts['settings'] = {
  motion: '虚拟控制点的运动',
  motionNotes: {
    rigid: '它们保持图片的形状：肢体弯曲，控制点自行旋转。',
    harmonic: '由调和场混合各控制点的运动，如论文所述（式 4）。控制点由你旋转。',
  },
  rigid: '刚性',
  byHand: '手动',
  density: '虚拟控制点',
  densityNote: '数量越多，图片变形越细致，拖动的影响范围越小。为 0 时由论文的算法决定。',
  atLeast: '至少',
  shapeFactor: '支撑系数 α',
  shapeFactorNote:
    '每个控制点的影响范围有多远。为 0 时只略微超出自己的单元，弯曲紧凑。为 1 时达到允许的最远处，弯曲柔和。',
  support: '支撑域规则',
  supportNotes: {
    smooth: '虚拟控制点的支撑域相互重叠。图片变形均匀。',
    paper: '支撑域在下一个控制点（含虚拟控制点）处结束（式 3）。图片以较小的步幅变形。',
  },
  smooth: '平滑',
  paper: '论文',
  continuity: '连续性',
  continuityNotes: {
    c2: '在拐角后面和孔洞周围，变形也是平滑的：二阶导数连续。孔洞会得到虚拟控制点。',
    exact: '在孔洞后面，绕行的两条路径等长之处，图片可能出现细微的折痕。',
  },
  exact: '精确',
  degree: '衰减的次数 n',
  degreeNote: '为 5 时，两个控制点之间的弯曲较短，控制点附近的部分整体移动。次数越高，弯曲越分散到整段路径。',
  filling: '衰减的填充',
  fillingNote:
    '次数从 7 起，衰减在两端之间如何延续。“直线”均匀下降。“半值”保留一个台阶，该处的部分各以一半跟随两个控制点。',
  line: '直线',
  half: '半值',
  blend: '混合',
  blendNotes: {
    rigid: '旋转混合后仍是旋转：处于两个相反旋转之间的部分保持大小。',
    linear: '对运动取平均，如论文所述（式 1）：处于两个相反旋转之间的部分会缩小。',
  },
  linear: '线性',
  samples: '采样点',
  samplesNote: '承载图片的点。数量越多，变形绘制得越细致，求解也越慢。',
  points: '点数',
  threshold: '最低不透明度',
  thresholdNote: '比这更透明的内容不会变形。数值越低，柔和的边缘和细发也会一起变形。',
  opacity: '不透明度',
  asInPaper: '与论文一致',
  asInEditor: '与编辑器一致',
};
