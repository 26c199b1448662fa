/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { fewNames, handleCount, keyCount, number, quoted } from './language';

const GRAPHICS_LOST = '显卡已失去连接，因此无法显示图片。';

const inRows = (rows: boolean): string => (rows ? '，由于没有可依循的轮廓，按均匀的行排列' : '');

const belongsTo = (project: string, source: string, width: number, height: number): string =>
  `${project}：属于图片${source ? quoted(source) : ''}（${width} × ${height} px）。`;

export const notices: Texts['notices'] = {
  nothingToHold: '这里没有可控制的内容：请将控制点放在图片上。',
  lassoOutside: '选区之外的图片保持不动。',
  lassoEmpty: '套索是空的：请圈出图片的一个部分。',
  lassoFilled: '现在只有这一部分会变形，其后的背景已填充。',
  lassoLoose: '现在只有这一部分会变形。它移开后会留下空缺。',
  partOnFrame: '这一部分紧贴图片的边框，而边框是固定的：无法转动。',
  leftOut: (count) => `已移除套索之外的 ${handleCount(count)}。撤销可将其恢复。`,
  notKept: '你的作品没有存储在此浏览器中：存储空间已满或被阻止。离开前请保存项目。',
  otherTab: '另一个标签页也更改了此作品。两个版本都已保留：重新加载页面后可以选择。',
  twoVersions: (picture) => `${quoted(picture)}在两个标签页中被更改。这是较新的版本。`,
  graphicsLost: `${GRAPHICS_LOST}请重新加载页面。`,
  graphicsLostStored: `${GRAPHICS_LOST}没有丢失任何内容：请重新加载页面。`,
  graphicsLostUnstored: `${GRAPHICS_LOST}目前没有丢失任何内容：请先保存项目，再重新加载页面。`,
  clipNameTaken: (name) => `另一个 Clip 已使用名称${quoted(name)}。保留原来的名称。`,

  outsidePicture: (handles) => `${fewNames(handles)}有一部分在图片之外，不会带动任何内容。`,
  outsideLasso: (handles) => `${fewNames(handles)}有一部分在套索之外，不会带动任何内容。`,
  nameStays: {
    empty: (name) => `控制点需要名称：保留原名${quoted(name)}。`,
    taken: (name) => `另一个控制点已使用此名称：保留原名${quoted(name)}。`,
  },
  outlineSimplified: '此轮廓非常精细，因此只做近似跟随。',
  outlineBridged: (pixels) => `此轮廓过于精细，无法跟随：相距不超过 ${pixels} 像素的部分会一起变形。`,
  outlinePicture: '此轮廓过于精细，无法跟随：整张图片都会变形。',
  looseParts: (count) => `${number(count)} 个部分没有控制点，会留在原处。`,
  sameThere: '两侧已经相同。',
  noOtherSide: (handles) => `在${fewNames(handles)}的另一侧，图片没有内容。`,
  noCounterpart: (handles) => `这里没有与${fewNames(handles)}的姿势相对应的控制点。`,
  brushedStill: '控制点都在初始位置。画笔的笔触保留不变。',

  noPose: '剪贴板上没有姿势：请先复制一个。',
  badPose: (detail) => `无法粘贴此姿势：${detail}。`,
  notCopied: '浏览器阻止了剪贴板：姿势只能粘贴到本页面。',
  notCopiedByMenu: (keys) => `浏览器阻止了剪贴板：姿势只能粘贴到本页面。按 ${keys} 复制则可用于其他页面。`,
  notRead: '浏览器阻止了剪贴板：请允许访问以便粘贴。',
  notReadByMenu: (keys) => `浏览器阻止了剪贴板：请按 ${keys} 粘贴。`,

  emptyAddress: '没有网址：请输入以 https:// 开头的网址',
  noAddress: (text) => `${quoted(text)}不是图片的网址：必须以 https:// 或 data:image/ 开头。`,
  nothingDropped: '拖放的内容中没有图片，也没有图片的网址。',
  notCarried: (picture, why) => `${quoted(picture)}仅作为图片打开。${why}`,
  removed: (picture) => `已从列表中移除${quoted(picture)}。`,
  removedAll: (count) => `已从列表中移除 ${number(count)} 张图片。`,
  notOpened: (file, more) =>
    `一次只能打开一张图片：${quoted(file)}${more === 0 ? '' : `和另外 ${number(more)} 个文件`}未打开。`,
  moves: (picture) => `${quoted(picture)}是动图。只打开了第一帧。`,
  lacksTexts: (picture) =>
    `${quoted(picture)}绘制耗时较长，因此打开时不含文字。要显示文字，请将其转换为路径。`,
  isOpen: (picture) => `已打开${quoted(picture)}。`,
  saved: (file) => `已保存为${quoted(file)}。`,
  savedCut: (file) => `已保存为${quoted(file)}。超出边框的部分已裁掉。`,
  selectOne: '此操作针对单个控制点：请先选择一个。',

  awaiting: (project, source, width, height) =>
    `${belongsTo(project, source, width, height)}请打开该图片以继续。`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belongsTo(project, source, width, height)}请打开该图片以继续，或将其 Rig 用于${quoted(picture)}。`,
  theProject: '项目',
  movedInside: (handles) => `${fewNames(handles)}原本在此图片之外，已移到图片上。`,

  folds: '图片产生了折痕。',
  foldedBy: (handles) =>
    handles.length > 1
      ? `${fewNames(handles)}共同使图片产生了折痕。`
      : `${fewNames(handles)}使图片产生了折痕。`,
  leftFolds: (handles) => `${fewNames(handles)}已退回到最接近的无折痕姿势。`,
  noWayOut: '在此姿势与初始姿势之间，没有找到无折痕的姿势。',

  placed: (added, rows) => `已放置 ${handleCount(added)}${inRows(rows)}。拖动其中一个即可让图片变形。`,
  added: (added, there, rows) =>
    `已添加 ${handleCount(added)}${inRows(rows)}。原有的 ${handleCount(there)}保留不变。`,
  noSuggestion: '没有添加控制点：每个适合的位置附近都已有控制点。',
  noPlace: '此图片没有放置控制点的空间。',

  noKeysSelected: '没有选择关键帧。',
  noCopiedKeys: '没有复制过关键帧。',
  copiedKeys: (count) => `已复制 ${keyCount(count)}`,
  keysLeftOut: (count) => `已略去 ${keyCount(count)}：超出 Clip 的末尾，或所属的控制点不在这里。`,

  newVersion: '新版本已就绪。下次启动时打开。',
  newVersionWaits: '新版本已就绪。关闭编辑器的其他窗口后即可打开。',
  notOffline: '编辑器尚未存储，无法离线使用：下载中断了。下次启动时会重试。',
  shareFailed: '分享的图片未能送达。请在此打开它的文件。',
  notGiven: (file) => `无法读取${quoted(file)}：文件已被移动或更改。请在此打开。`,
};

export const answers: Texts['answers'] = {
  tryAgain: '重试',
  takeBack: '撤回',
  exportAll: '导出全部',
  holdBoundary: '固定其边界',
  extendSelection: '扩展选区',
  letFollow: '让它们跟随',
  putBack: '放回',
  showOtherVersion: '显示另一版本',
  keepThis: '保留此版本',
  backTo: (picture) => `返回：${picture}`,
  openPicture: '打开图片',
  useRig: '使用此 Rig',
};
