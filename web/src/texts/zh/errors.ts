/** Errors that people see. */
import type { Texts } from '../texts';
import { quoted } from './language';
import { addressErrors, carriedErrors, pictureErrors } from './picture_errors';
import { engineErrors, refusals, tooMuchErrors } from './solver_errors';
import { writingErrors } from './writing_errors';

export const errors: Texts['errors'] = {
  picture: pictureErrors,
  address: addressErrors,
  carried: carriedErrors,
  tooMuch: tooMuchErrors,
  engine: engineErrors,
  refusals,
  writing: writingErrors,
  takenBack: '该步骤已撤销。',
  inFile: (file, sentence) => `${file}：${sentence}`,
  nothingOpaque: (picture) => `${picture}：此图片没有足够不透明的部分可供变形。`,
  pictureTooMuch: (picture) => `${quoted(picture)}太大，此浏览器无法处理。请缩小图片。`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `项目适用于 ${width} × ${height} px 的图片，但${quoted(picture)}为 ${itsWidth} × ${itsHeight} px。`,
  emptyProject: '文件是空的。',
  exportRefused: (detail) => `无法导出此项目：${detail}`,
  cardNotLoaded: '无法加载此面板。请检查网络连接。',
  noWebgl: '此浏览器无法用 WebGL2 绘制。请开启硬件加速，或使用其他浏览器。',
  noCanvas: '此浏览器无法在 2D 画布上显示图片。',
  other: (detail) => `发生错误：${detail}`,
};
