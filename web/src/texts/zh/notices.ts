/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { fewNames, handleCount, keyCount, number, quoted } from './language';

const GRAPHICS_LOST = '浏览器无法再访问显卡，因此不能显示图片。';

const inRows = (rows: boolean): string => (rows ? '，由于图片没有轮廓，按均匀的行排列' : '');

const belongsTo = (project: string, source: string, width: number, height: number): string =>
  `${project}属于${source ? `图片${quoted(source)}` : '另一张图片'}（${width} × ${height} px）。`;

export const notices: Texts['notices'] = {
  nothingToHold: '请将控制点放在图片上。',
  lassoOutside: '选区之外的图片不会变形。',
  lassoEmpty: '套索是空的。请圈出图片的一个部分。',
  drawingEnded: '绘制已结束。',
  lassoFilled: '现在只有这一部分会变形，其后的背景已填充。',
  lassoLoose: '现在只有这一部分会变形。它移开后会留下空缺。',
  partOnFrame: '这一部分紧贴图片固定的边缘，因此无法转动。',
  leftOut: (count) => `已移除套索之外的 ${handleCount(count)}。“撤销”可将其恢复。`,
  notKept: '此浏览器无法存储你的作品：存储空间已满或被阻止。离开前请保存项目。',
  newerWork: '此浏览器中存有较新版本编辑器的作品，该作品会保留。请重新加载页面以更新，或在离开前保存项目。',
  otherTab: '另一个标签页也更改了此作品。两个版本都已保留。请重新加载页面以选择其一。',
  twoVersions: (picture) => `${quoted(picture)}在两个标签页中被更改。这是较新的版本。`,
  graphicsLost: `${GRAPHICS_LOST}请重新加载页面。`,
  graphicsLostStored: `${GRAPHICS_LOST}你的作品已妥善保存。请重新加载页面。`,
  graphicsLostUnstored: `${GRAPHICS_LOST}请先保存项目，再重新加载页面。`,
  clipNameTaken: (name) => `另一个片段已使用名称${quoted(name)}。名称没有更改。`,

  outsidePicture: (handles) => `${fewNames(handles)}有一部分在图片之外，不起作用。`,
  outsideLasso: (handles) => `${fewNames(handles)}有一部分在套索之外，不起作用。`,
  nameStays: {
    empty: (name) => `控制点需要名称。已保留名称${quoted(name)}。`,
    taken: (name) => `另一个控制点已使用此名称。已保留名称${quoted(name)}。`,
  },
  outlineSimplified: '此轮廓非常精细，因此变形只近似跟随轮廓。',
  outlineBridged: (pixels) => `此轮廓过于精细，无法跟随：相距不超过 ${pixels} 像素的部分会一起变形。`,
  outlinePicture: '此轮廓过于精细，无法跟随：整张图片都会变形。',
  looseParts: (count) => `${number(count)} 个部分没有控制点，会留在原处。`,
  sameThere: '两侧已经一致。',
  noOtherSide: (handles) => `${fewNames(handles)}的镜像位置在图片之外。`,
  noCounterpart: (handles) => `这里没有与${fewNames(handles)}的姿势相对应的控制点。`,
  brushedStill: '已重置所有控制点。画笔的笔触仍然保留。',

  noPose: '剪贴板上没有姿势。请先复制一个。',
  badPose: (detail) => `无法粘贴此姿势：${detail}。`,
  badKeys: (detail) => `无法粘贴这些关键帧：${detail}。`,
  notCopied: '浏览器阻止了剪贴板。复制的内容只能粘贴到本页面。',
  notCopiedByMenu: (keys) =>
    `浏览器阻止了剪贴板。复制的内容只能粘贴到本页面。如需用于其他页面，请按 ${keys} 复制。`,
  notRead: '浏览器阻止了剪贴板。请允许访问以便粘贴。',
  notReadByMenu: (keys) => `浏览器阻止了剪贴板。请按 ${keys} 粘贴。`,

  emptyAddress: '请输入以 https:// 开头的网址。',
  noAddress: (text) => `${quoted(text)}不是图片的网址。请输入以 https:// 或 data:image/ 开头的网址。`,
  nothingDropped: '请拖入图片或图片的链接。',
  notCarried: (picture, why) => `已打开${quoted(picture)}，但未含其项目。${why}`,
  removed: (picture) => `已从列表中移除${quoted(picture)}。`,
  removedAll: (count) => `已从列表中移除 ${number(count)} 张图片。`,
  notOpened: (file, more) =>
    `一次只能打开一张图片。${quoted(file)}${more === 0 ? '' : `和另外 ${number(more)} 个文件`}未打开。`,
  moves: (picture) => `${quoted(picture)}是动图。只打开了第一帧。`,
  lacksTexts: (picture) =>
    `${quoted(picture)}绘制耗时较长，因此打开时不含文字。要显示文字，请将其转换为路径。`,
  isOpen: (picture) => `已打开${quoted(picture)}。`,
  saved: (file) => `已保存为${quoted(file)}。`,
  savedCut: (file) => `已保存为${quoted(file)}。超出边框的部分已被裁掉。`,
  selectOne: '请先选择一个控制点。',

  awaiting: (project, source, width, height) =>
    `${belongsTo(project, source, width, height)}请打开该图片以继续。`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${belongsTo(project, source, width, height)}请打开该图片以继续，或将其 Rig 用于${quoted(picture)}。`,
  theProject: '项目',
  movedInside: (handles) => `${fewNames(handles)}原本在此图片之外，已移到图片上。`,

  folds: '图片发生了折叠。',
  foldedBy: (handles) =>
    handles.length > 1 ? `${fewNames(handles)}共同使图片折叠。` : `${fewNames(handles)}使图片折叠。`,
  leftFolds: (handles) => `${fewNames(handles)}已退回到最接近的无折叠姿势。`,
  noWayOut: '在此姿势与初始姿势之间，没有找到无折叠的姿势。',

  placed: (added, rows) => `已放置 ${handleCount(added)}${inRows(rows)}。拖动其中一个即可让图片变形。`,
  added: (added, there, rows) =>
    `已添加 ${handleCount(added)}${inRows(rows)}。原有的 ${handleCount(there)}保留不变。`,
  noSuggestion: '没有添加控制点：每个适合的位置附近都已有控制点。',
  noPlace: '此图片没有放置控制点的空间。',

  noKeysSelected: '请先选择关键帧。',
  noCopiedKeys: '请先复制关键帧。',
  copiedKeys: (count) => `已复制 ${keyCount(count)}`,
  keysLeftOut: (count) => `已略去 ${keyCount(count)}。它们超出片段的末尾，或缺少所属的控制点。`,

  newVersion: '新版本已就绪。下次打开编辑器时启用。',
  newVersionWaits: '新版本已就绪。关闭编辑器的所有其他窗口后启用。',
  notOffline: '编辑器还不能离线使用：下载中断了。下次启动时会继续。',
  offered: (files) => `链接或其他程序想打开${fewNames(files)}。`,
  shareFailed: '无法接收分享的图片。请在此打开它的文件。',
  notGiven: (file) => `无法读取${quoted(file)}：文件已被移动或更改。请在此打开。`,
};

export const answers: Texts['answers'] = {
  tryAgain: '重试',
  continueDrawing: '继续绘制',
  takeBack: '清除笔触',
  exportAll: '导出整张图片',
  holdBoundary: '固定其轮廓',
  extendSelection: '扩展选区',
  letFollow: '让它们跟随',
  putBack: '恢复',
  showOtherVersion: '显示另一版本',
  keepThis: '保留此版本',
  backTo: (picture) => `返回：${picture}`,
  open: '打开',
  openPicture: '打开图片',
  useRig: '使用此 Rig',
};
