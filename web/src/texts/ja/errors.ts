/** Errors that people see. */
import type { Texts } from '../texts';
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
  takenBack: 'この操作は取り消されました。',
  inFile: (file, sentence) => `${file}：${sentence}`,
  nothingOpaque: (picture) => `${picture}：変形できるほど不透明な部分がこの画像にはありません。`,
  pictureTooMuch: (picture) =>
    `${picture}は大きすぎて、このブラウザーでは処理できません。画像を縮小してください。`,
  imageSize: (width, height, picture, itsWidth, itsHeight) =>
    `このプロジェクトは${width} × ${height} pxの画像用ですが、${picture}は${itsWidth} × ${itsHeight} pxです。`,
  emptyProject: 'ファイルが空です。',
  exportRefused: (detail) => `このプロジェクトは書き出せません：${detail}`,
  cardNotLoaded: 'このパネルを読み込めませんでした。接続を確認してください。',
  noWebgl:
    'このブラウザーはWebGL2で描画できません。ハードウェアアクセラレーションを有効にするか、別のブラウザーを使ってください。',
  noCanvas: 'このブラウザーは2Dキャンバスに画像を表示できません。',
  other: (detail) => `エラーが発生しました：${detail}`,
};
