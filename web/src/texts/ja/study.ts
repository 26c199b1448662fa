/** The card that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper. */
import type { Texts } from '../texts';
import { number } from './language';

export const study: Texts['study'] = {
  title: '変形の仕組み',
  page: 'ページ',
  pages: { lens: 'レンズ', cells: 'セル', rounds: 'ラウンド', compare: '比較', settings: '設定' },
  close: '閉じる',
  saveAsSvg: 'SVGで保存',
};

export const lens: Texts['lens'] = {
  title: '点でのウェイト',
  point: '画像を指してください',
  nothingBends: 'ここは変形しません',
  note: '各点は、まわりのハンドルにウェイトに応じてついて動きます。レンズは矢印キーでも動かせます。',
  tap: 'タップした点を調べます',
  click: 'クリックするとこの点を固定',
  follow: 'ポインターを追う',
  weights: 'ウェイト',
  weightsAt: (x, y) => `x ${x}、y ${y}のウェイト`,
  noHandle: 'この部分にはハンドルがないため、動きません。',
  ownWeight: '直接のウェイト',
  passedOn: '補助点を通した間接のウェイト',
  virtualHandles: '補助点',
  countOfThem: (count) => `${number(count)}個`,
  virtual: (number) => `補助点 ${number}`,
  distancePassed: (distance, percent) => `${distance}、間接 ${percent}`,
  spoken: (x, y, shares) => `x ${x}、y ${y}：${shares.join('、') || '動かすハンドルはありません'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `補助点 ${percent}`,

  falloff: '減衰',
  falloffOf: (handle) => `${handle}の減衰`,
  noEnd: 'この部分の唯一のハンドルなので、影響範囲に終わりがありません。',
  falloffLabel: (value, distance, end) => `減衰は距離${distance}で${value}、${end}で終わります。`,
  radii: (cell, nearest, support) =>
    `セルの半径 r_d ${cell}${nearest === null ? '' : `、最も近い隣の点 r_h ${nearest}`}${support === null ? '' : `、影響範囲 r ${support}`}。図の r をドラッグするか、α を設定してください。`,
  distanceAxis: '形の内側の距離 d、px',
  thisPoint: (distance) => `この点：${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'セルとその半径',
  none: 'セルを見るにはハンドルを追加してください。',
  counts: (own, virtual) => `セル：ハンドル${number(own)}個、補助点${number(virtual)}個`,
  label: '形とそのセル、セルの半径',
  farthest: 'r_d：セルの最も遠い点まで',
  nearest: 'r_h：最も近い隣の点まで',
  note: '影響範囲は自分のセルを覆い、次のハンドルの手前で終わります。そのため r_h が r_d を制限します。論文では補助点を「virtual handles」と呼びます。',
  toFarthest: 'セルの最も遠い点まで',
  toNearest: '最も近い隣の点まで',
  times: '段階ごとの計算時間',
  stages: {
    domain: '輪郭の検出',
    sampling: 'メッシュの作成',
    regions: '距離、セル、補助点',
    weights: 'ウェイト',
    pose: 'ポーズ',
  },
};

export const rounds: Texts['rounds'] = {
  title: 'アルゴリズム1',
  figure: (round) => `アルゴリズム1のラウンド${round}`,
  none: 'アルゴリズムを実行するにはハンドルを追加してください。',
  play: '再生',
  pause: '一時停止',
  previous: '前のラウンド',
  next: '次のラウンド',
  round: 'ラウンド',
  roundOf: (round, rounds) => `ラウンド ${round}／${rounds}`,
  end: (round, handles) =>
    `ラウンド${round}：完了。大きすぎるセルはなく、ハンドルと補助点は合わせて${number(handles)}個です。`,
  tooLarge: (round, reach, allowed, enters) =>
    `ラウンド${round}：${reach}に及ぶセルがあり、上限の${allowed}を超えています。${enters}`,
  asked: (round, enters) =>
    `ラウンド${round}：大きすぎるセルはありませんが、プロジェクトがさらに補助点を求めています。${enters}`,
  enters: (handle, distance, others) =>
    `${handle}のセルの${distance}離れた場所に補助点が入り${others > 0 ? `、別の場所にもさらに${number(others)}個入り` : ''}ます。`,
  curve: (score, allowed) => `スコアは${score}です。上限は${allowed}です。`,
  note: '論文の図3と同じく、各ラウンドの前の最悪のセルのスコアです。線より下では、どの影響範囲も自分のセルを覆い、次のハンドルの手前で終わります。その後のラウンドでは、プロジェクトが求める補助点を追加します。',
  roundAxis: 'ラウンド',
  allowed: '上限',
};

export const compare: Texts['compare'] = {
  title: '1枚の画像、3つの方法',
  note: '画像のハンドルをドラッグすると、3つとも動きます。',
  names: { paper: '論文', rigid: '剛体', plain: '単純な距離' },
  labels: {
    paper: '論文のとおりに変形した画像',
    rigid: '剛体モードで変形した画像',
    plain: '単純な距離で変形した画像',
  },
  notes: {
    paper: '形の内側の距離と調和場を使います。ハンドルは自分で回します。',
    rigid: '部分の形ができるだけ保たれます。ハンドルは自動で回転します。',
    plain: '論文と同じですが、距離が隙間を越えるため、近くの部分も一緒に動きます。',
  },
};

export const settings: Texts['settings'] = {
  motion: '補助点の動き',
  motionNotes: {
    rigid: '画像の形を保ちます。手足が曲がり、ハンドルは自動で回転します。',
    harmonic: '論文（式4）のとおり、調和場がハンドルの動きを混ぜ合わせます。ハンドルは自分で回します。',
  },
  rigid: '剛体',
  byHand: '弾性',
  density: '補助点',
  densityNote:
    '多いほど画像は細かく変形し、ドラッグの影響は狭くなります。0にすると論文のアルゴリズムが決めます。',
  atLeast: '最小数',
  shapeFactor: '影響範囲の係数 α',
  shapeFactorNote:
    '各ハンドルの影響がどこまで及ぶかです。0では自分のセルを少し越えるだけで、曲がりがきつくなります。1ではできるだけ広く及び、曲がりが緩やかになります。',
  support: '影響範囲の規則',
  supportNotes: {
    smooth: '補助点の影響範囲が重なり合い、画像は均一に曲がります。',
    paper: '影響範囲が次のハンドルまたは補助点で終わり（式3）、画像は小刻みに曲がります。',
  },
  smooth: '滑らか',
  paper: '論文',
  continuity: '連続性',
  continuityNotes: {
    c2: '角の裏や穴のまわりでも滑らかに曲がります（2階微分まで連続）。穴には補助点が置かれます。',
    exact: '穴の裏で左右の道のりが等しくなる場所に、細い折れ線が見えることがあります。',
  },
  exact: '厳密',
  degree: '減衰の次数 n',
  degreeNote:
    '5では2つのハンドルの間の曲がりが短く、ハンドルの近くはまとまって動きます。次数を上げると曲がりが道のり全体に広がります。',
  filling: '減衰の形',
  fillingNote:
    '次数7以上で、減衰が両端の間をどう進むかです。「直線」は均等に減ります。「半分」には段があり、そこでは2つのハンドルに同じだけ従います。',
  line: '直線',
  half: '半分',
  blend: '混合方法',
  blendNotes: {
    rigid: '回転どうしを混ぜると回転になります。逆向きの2つの回転の間でも大きさが保たれます。',
    linear: '論文（式1）のとおり動きを平均します。逆向きの2つの回転の間は縮みます。',
  },
  linear: '線形',
  samples: 'メッシュ点',
  samplesNote: '画像を支えるメッシュの角です。多いほど曲がりが細かく描かれますが、計算に時間がかかります。',
  points: '点',
  threshold: '不透明度の下限',
  thresholdNote: 'これより透明なピクセルは変形しません。小さくすると、柔らかい縁や細い毛も含まれます。',
  opacity: '不透明度',
  asInPaper: '論文の標準',
  asInEditor: 'エディターの標準',
};
