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
  allOfIt: '拡張',
  covered: 'トリミング',
  export: (format) => `${format}を書き出す`,
  exportRig: 'リグを書き出す',
  exportMap: 'マップを書き出す',
  exportWeights: 'ウェイトを書き出す',
  pixels: (width, height) => `${number(width)} × ${number(height)} px`,
  aboutPixels: (width, height) => `≈ ${number(width)} × ${number(height)} px`,

  formatNotes: {
    png: '可逆圧縮です。透明も使えます。',
    jpeg: '写真に向いた小さなファイルです。透明は使えません。',
    webp: '透明も使える小さなファイルです。',
    svg: 'パスを変形した図形です。どのサイズでも鮮明です。',
  },
  areaNotes: {
    picture: '元の画像の枠です。',
    grown: '元の枠からはみ出した部分まで広げます。',
    covered: '見える部分に合わせ、空の余白を除きます。',
  },
  remark: (detail) => `図形についての注意：${detail}`,
};

export const film: Texts['film'] = {
  noClip: '動画にはクリップが必要です。タイムラインで追加してください。',
  openTimeline: 'タイムラインを開く',
  clip: 'クリップ',
  frames: '連番PNG',
  sheet: 'シート',
  formatNotes: {
    webm: '半透明も使える小さなファイルです。Webページ向けです。',
    mp4: '透明を使えない小さなファイルです。ほぼどこでも再生できます。',
    gif: 'どこでも再生できますが、255色で、縁は硬くなります。',
    apng: '可逆圧縮です。半透明も使えます。',
    webp: '可逆圧縮です。APNGより小さくなります。',
    frames: 'フレームごとのPNGをまとめたZIPです。',
    sheet: 'スプライトシートのZIPです。全フレームの1枚のPNGと、ゲームエンジン用のJSONが入ります。',
  },
  codec: (name) => `コーデック：${name}。`,
  codecWithEvenSides: (name, width, height) =>
    `コーデック：${name}。幅と高さは偶数に切り上げられます：${width} × ${height} px。`,
  gifRate: (most) => `GIFは毎秒${most}フレームまでです。ビューアーが再生できる上限です。`,
  noCodec: (formats) => `このブラウザーは${list(formats)}をエンコードできません。`,
  rate: 'レート',
  rateTip: '毎秒のフレーム数',
  allFrames: '拡張',
  part: '範囲',
  wholeClip: 'クリップ全体',
  aPart: '一部',
  from: '開始',
  to: '終了',
  transparent: '透明',
  colour: '色',
  softEdgesOn: 'マットの色',
  frameCount: (count) => `${number(count)}フレーム`,
  estimate: (size, time) => `約${size}、${time}`,
  aFewSeconds: '数秒',
  aFewSecondsLeft: '残り数秒',
  left: (time) => `残り約${time}`,
};

export const webPage: Texts['webPage'] = {
  note: '全クリップを収めた小さなファイル1つです。15 kBのプレーヤースクリプトで、エディターなしで表示できます。',
  withoutClips: 'クリップがない場合、ページには現在のポーズが表示されます。',
  readers: '閲覧者ができること',
  watch: 'クリップを見る',
  pose: 'ハンドルを動かす',
  solver: 'ファイルが約100 kB大きくなり、ページの読み込みも100 kB増えます。',
  code: 'コード',
  copyCode: 'コードをコピー',
  codeNote: 'これをページに貼り付け、ファイルとパッケージのフォルダー“player”をページの隣に置いてください。',
  codeCopied: (file) =>
    `コピーしました。${file}とパッケージのフォルダー“player”をページの隣に置いてください。`,
  codeNotCopied: 'ブラウザーがクリップボードの使用を拒否しました。選択されたコードをコピーしてください。',
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
      ? 'メッシュ、ボーン、ポーズを含みます。クリップを追加するとアニメーションも入ります。'
      : `${number(count)}個のクリップをアニメーションとして含みます。`,
  rough: 'ボーンはハンドルの近似なので、リグには少しずれが出ます。ずれの量は書き出し時に表示されます。',
  bones: 'ボーン',
  bonesTip: 'ボーンの最大数（ルートを除く）',
  vertices: '頂点',
  verticesTip: 'メッシュの頂点の最大数',
  influences: '頂点ごとのボーン数',
  files: 'ファイル',
  zip: 'ZIP',
  folder: 'フォルダー',
  lossCaption: (bones, sites, vertices) =>
    `直前のリグは、ハンドルと補助点${sites}個に対してボーン${bones}本、頂点${vertices}個です。ずれ（ピクセル）：`,
  largest: '最大',
  pose: 'ポーズ',
  randomPoses: '無作為なポーズ',
  clip: (name) => `クリップ ${name}`,
  betweenVertices: '頂点の間',
  loss: (percentile, largest) =>
    `頂点の99 %でずれは${percentile} px以下です。最大のずれは${largest} pxです。`,
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
    inverse: 'コンポジットソフト用のSTマップです。この変形をほかの画像に適用します。',
    forward: '変形後の画像に適用すると、変形を元に戻すSTマップです。',
    stretch: '変形後の画像の各ピクセルで、面積と長さがどれだけ伸びるか。',
    disocclusion: '変形で現れる場所は赤、隠れる場所は緑。',
    heat: '画像がハンドルにどれだけついて動くかを、元の画像に色で重ねます。',
    weights: '元の画像の点が各ハンドルにどれだけついて動くかを、スクリプト用の数値にします。',
  },
  formatNotes: {
    exr: '32ビット浮動小数点のOpenEXR。チャンネルの説明はヘッダーにあります。',
    png: 'チャンネルあたり16ビット。OpenEXRを使えないソフト用です。',
  },
  csvNote: '0より大きいウェイトごとに1行です。',
  npyNote: 'NumPyの配列です。',
  npyZipNote: 'NumPyの配列と、ハンドルと補助点の一覧を収めたZIPです。',
  of: 'ウェイトの対象',
  allSites: 'すべてのハンドル',
  selectedHandle: '選択中のハンドル',
  every: '点の間隔（ピクセル）',
  points: (width, height) => `${number(width)} × ${number(height)}点`,
  selected: (handle) => `選択中：${handle}。`,
};
