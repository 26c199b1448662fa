/** The card that explains the solution. `r_d` and `r_h` become symbols. */
import type { Texts } from '../texts';
import { number } from './language';

export const study: Texts['study'] = {
  title: '变形的原理',
  page: '页面',
  pages: { lens: '透镜', cells: '单元', rounds: '轮次', compare: '比较', settings: '设置' },
  close: '关闭',
  saveAsSvg: '保存为 SVG',
};

export const lens: Texts['lens'] = {
  title: '某一点的权重',
  point: '请指向图片',
  nothingBends: '此处不会变形',
  note: '每个点按权重跟随周围的控制点。也可以用方向键移动透镜。',
  tap: '点按一个点以查看',
  click: '单击以固定此点',
  follow: '跟随指针',
  weights: '权重',
  weightsAt: (x, y) => `x ${x}，y ${y} 处的权重`,
  noHandle: '这一部分没有控制点，因此留在原处。',
  ownWeight: '直接权重',
  passedOn: '经辅助点的间接权重',
  virtualHandles: '辅助点',
  countOfThem: (count) => `${number(count)} 个点`,
  virtual: (number) => `辅助点 ${number}`,
  distancePassed: (distance, percent) => `${distance}，间接 ${percent}`,
  spoken: (x, y, shares) => `x ${x}，y ${y}：${shares.join('、') || '没有控制点带动它'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `辅助点 ${percent}`,

  falloff: '衰减',
  falloffOf: (handle) => `衰减：${handle}`,
  noEnd: '这是该部分唯一的控制点，因此支撑域没有尽头。',
  falloffLabel: (value, distance, end) => `在距离 ${distance} 处衰减值为 ${value}，到 ${end} 处结束。`,
  radii: (cell, nearest, support) =>
    `单元半径 r_d ${cell}${nearest === null ? '' : `，最近的相邻点 r_h ${nearest}`}${support === null ? '' : `，支撑域 r ${support}`}。拖动图中的 r，或设置 α。`,
  distanceAxis: '形状内的距离 d，px',
  thisPoint: (distance) => `此点：${distance} →`,
};

export const cells: Texts['cells'] = {
  title: '单元及其半径',
  none: '添加控制点即可看到其单元。',
  counts: (own, virtual) => `单元：控制点 ${own} 个，辅助点 ${virtual} 个`,
  label: '形状及其单元和半径',
  farthest: 'r_d，到单元中最远的点',
  nearest: 'r_h，到最近的相邻点',
  note: '支撑域覆盖其单元，并在你的下一个控制点之前结束。因此 r_h 限制 r_d。论文把辅助点称为“virtual handles”。',
  toFarthest: '到单元中最远的点',
  toNearest: '到最近的相邻点',
  times: '各阶段的计算时间',
  stages: {
    domain: '查找轮廓',
    sampling: '构建网格',
    regions: '距离、单元和辅助点',
    weights: '权重',
    pose: '姿势',
  },
};

export const rounds: Texts['rounds'] = {
  title: '算法 1',
  figure: (round) => `算法 1 的第 ${round} 轮`,
  none: '添加控制点即可运行算法。',
  play: '播放',
  pause: '暂停',
  previous: '上一轮',
  next: '下一轮',
  round: '轮次',
  roundOf: (round, rounds) => `第 ${round} 轮，共 ${rounds} 轮`,
  end: (round, handles) => `第 ${round} 轮：完成。没有过大的单元，共有 ${handles} 个控制点和辅助点。`,
  tooLarge: (round, reach, allowed, enters) =>
    `第 ${round} 轮：有一个单元伸展到 ${reach}，超出上限 ${allowed}。${enters}`,
  asked: (round, enters) => `第 ${round} 轮：没有过大的单元，但项目要求更多辅助点。${enters}`,
  enters: (handle, distance, others) =>
    `在“${handle}”的单元中加入一个辅助点，相距 ${distance}${others > 0 ? `，另有 ${others} 个加入别处` : ''}。`,
  curve: (score, allowed) => `得分为 ${score}。上限为 ${allowed}。`,
  note: '每一轮之前最差单元的得分，如论文图 3 所示。在线以下，每个支撑域都覆盖其单元，并在下一个控制点之前结束。此后的各轮添加项目所要求的辅助点。',
  roundAxis: '轮次',
  allowed: '上限',
};

export const compare: Texts['compare'] = {
  title: '一张图片，三种方法',
  note: '拖动图片的控制点，三张图片都会跟随。',
  names: { paper: '论文', rigid: '刚性', plain: '直线距离' },
  labels: {
    paper: '按论文方法变形的图片',
    rigid: '以刚性模式变形的图片',
    plain: '按直线距离变形的图片',
  },
  notes: {
    paper: '采用形状内的距离和调和场。控制点由你自己旋转。',
    rigid: '各部分尽可能保持形状。控制点自动旋转。',
    plain: '与论文相同，但距离会跨越空隙，因此邻近的部分也会跟着移动。',
  },
};

export const settings: Texts['settings'] = {
  motion: '辅助点的运动',
  motionNotes: {
    rigid: '它们保持图片的形状：肢体弯曲，控制点自动旋转。',
    harmonic: '由调和场混合各控制点的运动，如论文所述（式 4）。控制点由你旋转。',
  },
  rigid: '刚性',
  byHand: '弹性',
  density: '辅助点',
  densityNote: '数量越多，图片变形越细致，拖动的影响范围越小。为 0 时由论文的算法决定。',
  atLeast: '至少',
  shapeFactor: '支撑系数 α',
  shapeFactorNote:
    '每个控制点的影响范围有多远。为 0 时只略微超出自己的单元，弯曲紧凑。为 1 时达到尽可能远处，弯曲柔和。',
  support: '支撑域规则',
  supportNotes: {
    smooth: '辅助点的支撑域相互重叠，因此图片变形均匀。',
    paper: '支撑域在下一个控制点或辅助点处结束（式 3），因此图片以较小的步幅变形。',
  },
  smooth: '平滑',
  paper: '论文',
  continuity: '连续性',
  continuityNotes: {
    c2: '在拐角后面和孔洞周围，变形也是平滑的：二阶导数连续。孔洞会得到辅助点。',
    exact: '在孔洞后面，绕行的两条路径等长之处，可能出现细微的折线。',
  },
  exact: '精确',
  degree: '衰减的次数 n',
  degreeNote: '为 5 时，两个控制点之间的弯曲较短，控制点附近的部分整体移动。次数越高，弯曲越分散到整段路径。',
  filling: '衰减的形状',
  fillingNote:
    '次数从 7 起，衰减在两端之间如何延续。“直线”均匀下降。“半值”有一个平台，图片在该处同等地跟随两个控制点。',
  line: '直线',
  half: '半值',
  blend: '混合',
  blendNotes: {
    rigid: '旋转混合后仍是旋转：处于两个相反旋转之间的部分保持大小。',
    linear: '对运动取平均，如论文所述（式 1）：处于两个相反旋转之间的部分会缩小。',
  },
  linear: '线性',
  samples: '网格点',
  samplesNote: '承载图片的网格的顶点。数量越多，变形绘制得越细致，但计算也越慢。',
  points: '点数',
  threshold: '最低不透明度',
  thresholdNote: '比这更透明的像素不会变形。较低的数值会包含柔和的边缘和细发。',
  opacity: '不透明度',
  asInPaper: '论文默认值',
  asInEditor: '编辑器默认值',
};
