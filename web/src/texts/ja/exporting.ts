/** The export panel. */
import type { Texts } from '../texts';
import { list, number } from './language';

export const exporting: Texts['exporting'] = {
  kind: '種類',
  kinds: { picture: '画像', film: '動画', page: 'Webページ', engine: 'エンジン', maps: 'マップ' },
  format: '形式',
  size: 'サイズ',
  quality: '品質',
  background: '背景',
  area: '範囲',
  original: '元のまま',
  allOfIt: '全体',
  covered: '描画部分',
  export: (format) => `${format}を書き出す`,
  exportRig: 'リグを書き出す',
  exportMap: 'マップを書き出す',
  exportWeights: 'ウェイトを書き出す',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: '全ピクセルをそのまま、透明も含めて保存します。',
    jpeg: '写真を小さなファイルにします。透明は使えません。',
    webp: '透明も使える小さなファイルです。',
    svg: 'パスを変形した図形です。どのサイズでも鮮明です。',
  },
  areaNotes: {
    picture: '元の画像の長方形です。',
    grown: '元の画像からはみ出した部分まで広げます。',
    covered: '描画された部分だけで、空の余白はありません。',
  },
  remark: (detail) => `図形についての注意：${detail}`,
};

export const film: Texts['film'] = {
  noClip: 'まだクリップがありません。動画にはクリップが必要です。',
  openTimeline: 'タイムラインを開く',
  clip: 'クリップ',
  frames: '連番PNG',
  sheet: 'シート',
  formatNotes: {
    webm: '小さく、半透明も使えます。Webページ向けです。',
    mp4: '小さく、透明は使えません。ほぼどこでも再生できます。',
    gif: 'どこでも再生できます。255色で、縁は硬くなります。',
    apng: '全ピクセルをそのまま、半透明も含めて保存します。',
    webp: '全ピクセルをそのまま保存し、APNGより小さくなります。',
    frames: 'フレームごとのPNGをまとめたZIPです。',
    sheet: '全フレームを1枚のPNGにまとめ、ゲームエンジン用のJSONを添えたZIPです。',
  },
  codec: (name) => `${name}を使います。`,
  codecWithEvenSides: (name, width, height) =>
    `${name}を使います。辺は偶数になります：${width} × ${height} px。`,
  gifRate: (most) => `GIFは、ビューアーが再生できる上限の毎秒${most}フレームになります。`,
  noCodec: (formats) => `${list(formats)}：このブラウザーではエンコードできません。`,
  rate: 'レート',
  rateTip: '毎秒のフレーム数',
  allFrames: '全フレーム',
  part: '範囲',
  wholeClip: 'クリップ全体',
  aPart: '一部',
  from: '開始',
  to: '終了',
  transparent: '透明',
  colour: '色',
  softEdgesOn: '縁をなじませる色',
  frameCount: (count) => `${number(count)}フレーム`,
  estimate: (size, time) => `約${size}、${time}`,
  aFewSeconds: '数秒',
  aFewSecondsLeft: '残り数秒',
  left: (time) => `残り約${time}`,
};

export const webPage: Texts['webPage'] = {
  note: '全クリップを収めた小さなファイル1つです。プレーヤーは14 kBのスクリプトで、エディターは要りません。',
  withoutClips: 'まだクリップがありません。ページにはポーズが表示されます。',
  readers: '閲覧者',
  watch: 'クリップを見る',
  pose: 'ハンドルを動かす',
  solver: 'ページの読み込みが100 kB増え、ファイルもほぼ同じだけ大きくなります。',
  code: 'コード',
  copyCode: 'コードをコピー',
  codeNote: 'このファイルとパッケージのフォルダー“player”を隣に置いたページに貼り付けてください。',
  codeCopied: (file) =>
    `コピーしました。ページの隣に${file}とパッケージのフォルダー“player”を置くと表示されます。`,
  codeNotCopied:
    'ブラウザーがクリップボードの使用を拒否しました。コードを選択してあるので、手動でコピーしてください。',
};

export const engine: Texts['engine'] = {
  notes: {
    spine: 'Spine 4.2とそのランタイム用：JSON、アトラス、PNG。',
    dragonbones: 'DragonBones 5.5とそのランタイム用：JSONファイル2つとPNG。',
    gltf: 'three.jsやBlenderなどで使えるglTF 2.0：ファイル1つ。',
    godot: 'Godot 4のシーンとPNG。',
  },
  clips: (count) =>
    count === 0
      ? 'メッシュ、ボーン、ポーズを含みます。まだクリップはありません。'
      : `${number(count)}個のクリップをアニメーションとして含みます。`,
  rough:
    'ボーンの混合はハンドルより単純なため、リグには少しずれが出ます。ずれの量は書き出し時に表示されます。',
  bones: 'ボーン',
  bonesTip: 'ルート以外のボーンの最大数。ハンドルごとに 1 本あります',
  vertices: '頂点',
  verticesTip: 'メッシュの頂点の最大数',
  influences: '頂点ごとのボーン数',
  files: 'ファイル',
  zip: 'ZIP',
  folder: 'フォルダー',
  lossCaption: (bones, sites, vertices) =>
    `直前のリグは、${sites}個の制御点に対してボーンが${bones}本、頂点が${vertices}個です。ずれ（ピクセル）：`,
  largest: '最大',
  pose: 'ポーズ',
  randomPoses: '無作為なポーズ',
  clip: (name) => `クリップ ${name}`,
  betweenVertices: '頂点の間',
  loss: (percentile, largest) => `頂点の99 %でずれは${percentile} px以下、最大で${largest} pxです。`,
};

export const maps: Texts['maps'] = {
  map: 'マップ',
  names: {
    inverse: '逆変換',
    forward: '順変換',
    stretch: '伸縮',
    disocclusion: '遮蔽の変化',
    heat: 'ヒートマップ',
    weights: 'ウェイト',
  },
  notes: {
    inverse: 'コンポジットソフト用のSTマップ：ほかの画像をこの画像と同じように変形します。',
    forward: '逆方向のマップ：変形後の画像にSTマップとして使うと、変形を元に戻します。',
    stretch: '変形後の画像の各ピクセルで、面積と長さがどれだけ伸びるか。',
    disocclusion: '変形で現れる場所は赤、隠れる場所は緑。',
    heat: '画像がハンドルにどれだけついて動くかを、元の画像に色で重ねます。',
    weights: '元の画像の点がどれだけついて動くかを、スクリプト用の数値にします。',
  },
  formatNotes: {
    exr: '32ビット浮動小数点のOpenEXR。チャンネルの意味はヘッダーにあります。',
    png: 'チャンネルあたり16ビット。OpenEXRを使えないソフト用です。',
  },
  csvNote: '0より大きいウェイトごとに1行です。',
  npyNote: 'NumPyの配列です。',
  npyZipNote: 'NumPyの配列と制御点の一覧を収めたZIPです。',
  of: '対象',
  allSites: 'すべての制御点',
  selectedHandle: '選択中のハンドル',
  every: '点の間隔（ピクセル）',
  points: (width, height) => `${number(width)} × ${number(height)}点`,
  selected: (handle) => `選択中：${handle}。`,
};
