/** The stage: its labels, hints, drawings, the brush, and the line below it. */
import type { Texts } from '../texts';
import { number } from './language';

export const stage: Texts['stage'] = {
  keys: '矢印キーで選択中のハンドルを移動します。コンマとピリオドで回転し、Altを押しながらだと拡大・縮小します。',
  noPicture: '画像なし',
  picture: (name) => `画像 ${name}`,
  disabled: (picture) => `${picture}、無効`,
  posable: (picture) => `${picture}、ハンドルでポーズを付けられます`,
  original: '元の画像',
  opening: '開いています…',
  drop: 'ここに画像をドロップするか、貼り付けるか、',
  openPicture: '画像を開く',
  required: '画像を開いてください。',
  wouldFold: 'ここで折れます',
  dismiss: '閉じる',
  handles: 'ハンドル',
  selectionCorners: '選択範囲の角',
  selectionCorner: (corner, part, x, y) =>
    `${part === null ? '選択範囲' : `選択範囲の部分 ${part}`}の角 ${corner}、x ${x}、y ${y}`,
  selectionCornerKeys: '矢印キーで角を移動します。Deleteで削除し、Cで次の角を追加します。',
  pictureMenu: '画像',
  cornerMenu: (corner, handle) => `${handle}の角 ${corner}`,
};

export const hints: Texts['hints'] = {
  bar: {
    click: 'ドラッグしてバーを描くか、角をクリックしてください',
    tap: 'ドラッグしてバーを描くか、角をタップしてください',
  },
  polygon: {
    click: '角をクリックして多角形を描いてください',
    tap: '角をタップして多角形を描いてください',
  },
  lasso: {
    click: '変形する部分を囲んでください：ドラッグ、または角をクリック',
    tap: '変形する部分を囲んでください：ドラッグ、または角をタップ',
  },
  lassoAgain: '選択範囲の角をドラッグするか、別の部分を囲んでください',
  select: {
    click: 'ポイントツールを選び、画像をクリックしてください',
    tap: 'ポイントツールを選び、画像をタップしてください',
  },
  point: {
    click: 'ハンドルを置きたい場所をクリックしてください',
    tap: 'ハンドルを置きたい場所をタップしてください',
  },
  snapToEdges: '輪郭に吸着',
  snapToEdgesTip: '投げ縄が画像の輪郭に沿います。Altを押している間は自由に描けます',
};

export const drawing: Texts['drawing'] = {
  label: '描画',
  ready: '角を追加するか、完了してください',
  oneMore: '角があと1個必要です',
  more: (count) => `角があと${count}個必要です`,
  takeBack: '最後の角を削除',
  giveUp: '描画をやめる',
  finish: '完了',
};

export const brush: Texts['brush'] = {
  label: 'ブラシ',
  effect: 'ブラシの効果',
  kinds: {
    push: '押す',
    pinch: '縮める',
    bloat: '膨らます',
    smooth: 'ならす',
    restore: '戻す',
    stiffen: '固める',
  },
  tips: {
    push: '押す：画像を引きずって動かします',
    pinch: '縮める：画像を中心に寄せます',
    bloat: '膨らます：画像を外側に広げます',
    smooth: 'ならす：ブラシの跡を滑らかにします',
    restore: '戻す：ブラシの跡を取り除きます',
    stiffen: '固める：領域を硬く保ちます',
  },
  hints: {
    push: 'ドラッグすると画像を押して動かします。',
    pinch: '押すかドラッグすると画像を縮めます。',
    bloat: '押すかドラッグすると画像を膨らませます。',
    smooth: 'ドラッグするとブラシの跡が滑らかになります。',
    restore: 'ドラッグするとブラシの跡を取り除きます。',
    stiffen: '硬く保ちたい領域をドラッグしてください。',
  },
  altHints: {
    push: 'Altで戻します。',
    pinch: 'Altで膨らませます。',
    bloat: 'Altで縮めます。',
    smooth: '',
    restore: 'Altで押します。',
    stiffen: 'Altで消します。',
  },
  size: 'サイズ',
  strength: '強さ',
  sizeLabel: 'ブラシのサイズ（%）',
  strengthLabel: 'ブラシの強さ（%）',
  erase: '消す',
  eraseTip: '硬さを消す',
  clearStiffness: '硬さを消去',
  clearStiffnessTip: '画像全体を再び柔らかくします',
  clearStrokes: 'ブラシの跡を消去',
  clearStrokesTip: '画像からブラシの跡をすべて取り除きます',
  holding: '矢印キーで押し、Enterで放します。',
  rigidOnly: '硬さは剛体モードでのみ働きます。',
  bendRigidly: '剛体モードを使う',
};

export const status: Texts['status'] = {
  label: '状態',
  hasCreases: '画像に折れがあります',
  privacy: 'データはブラウザーの外に出ません',
  privacyTip: '画像を開く、変形する、保存する処理は、すべてこの端末だけで行われます。',
  view: '表示',
  zoom: 'ズーム',
  seeIt: '確認',
  out: '縮小',
  in: '拡大',
  fit: '全体',
  actual: '等倍',
  stoppedAtFold: '折れの手前で停止',
  creases: (count) => `折れ${number(count)}か所`,
  creasesAnd: (creases, effect) => `${creases}。${effect}`,
  hideCreases: '折れを隠す',
  showCreases: '折れを表示',
  zoomToCrease: '折れを拡大表示',
  zoomToNextCrease: '次の折れを拡大表示',
  cancel: '中止',
  samples: (count) => `メッシュ点${number(count)}個`,
  virtualHandles: (count) => `補助点${number(count)}個`,
};

export const tasks: Texts['tasks'] = {
  opening: (name) => `${name}を開いています`,
  start: '輪郭を検出中',
  domain: 'メッシュを作成中',
  sampling: '距離を計測中',
  regions: 'ウェイトを計算中',
  weights: 'ウェイトを計算中',
  suggesting: 'ハンドルの場所を探索中',
  filling: '背景を埋めています',
  exporting: '書き出し中',
};
