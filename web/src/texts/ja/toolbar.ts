/** The bar at the top with its menus, and the card of tools. */
import type { Texts } from '../texts';
import { number } from './language';

export const toolbar: Texts['toolbar'] = {
  label: 'ドキュメント',
  open: '開く',
  save: '保存',
  export: '書き出し',
  undo: '元に戻す',
  redo: 'やり直し',
  undoStep: (step) => `元に戻す：${step}`,
  redoStep: (step) => `やり直し：${step}`,
  compare: '比較',
  animate: 'アニメ',
  more: 'その他',
  lightColours: '明るい配色',
  darkColours: '暗い配色',
  unsaved: '未保存',
  unsavedKept: '未保存、ブラウザーに保管済み',
  noFile: '最後の変更はファイルに保存されていません',
  kept: 'ブラウザーに保管済み',
};

export const files: Texts['files'] = {
  label: '最近の作業、サンプル、アドレスを開く',
  address: '画像またはプロジェクトのアドレス',
  placeholder: 'https://…/picture.png',
  open: '開く',
  recent: '最近の作業',
  removeAll: 'すべて除去',
  noRecent: '編集した画像は、別の画像を開くとここに表示されます。',
  remove: (name) => `${name}を一覧から除去`,
  drawing: '描きかけ',
  steps: (count) => `${number(count)}ステップ`,
  samples: 'サンプル',
  openSample: (name) => `サンプル「${name}」を開く`,
  whole: 'すべてを1つのファイルに',
  saveWhole: '画像ごと保存',
  exportWhole: '編集可能なPNGを書き出す',
};

export const tools: Texts['tools'] = {
  label: 'ツール',
  select: '移動',
  point: 'ポイント',
  bar: 'バー',
  polygon: '多角形',
  lasso: '投げ縄',
  brush: 'ブラシ',
  hand: '手のひら',
  lens: 'レンズ',
  bend: '変形',
};
