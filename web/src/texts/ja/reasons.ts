/** Why a command cannot run now, in a few words. */
import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: 'エディターは無効です',
  leftOut: 'このページでは使えません',
  viewOnly: 'この画像は表示専用です',
  noPicture: '先に画像を開いてください',
  noHandles: '先にハンドルを追加してください',
  noneSelected: '先にハンドルを選択してください',
  noSingle: 'ハンドルを1つだけ選択してください',
  noLine: 'バーまたは多角形を1つだけ選択してください',
  nothingToUndo: '元に戻す操作がありません',
  nothingToRedo: 'やり直す操作がありません',
  atRest: 'すでに初期位置にあります',
  inFront: 'すでに最前面にあります',
  atBack: 'すでに最背面にあります',
  nothingFolded: '折れはありません',
  noLasso: '先に投げ縄で部分を囲んでください',
  notOpaque: '透明部分のない画像でのみ使えます',
  nothingBends: 'ここは変形しません',
  noClipOpen: '先にクリップを開いてください',
  cornersNeeded: {
    bar: (count) => `バーには角が${count}個以上必要です`,
    polygon: (count) => `多角形には角が${count}個以上必要です`,
  },
};
