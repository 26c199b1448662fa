/** The card that explains the solution. In its sentences `r_d` and `r_h` stand for the symbols of the paper. */
import type { Texts } from '../texts';
import { number } from './language';

export const study: Texts['study'] = {
  title: '論文を見る',
  page: 'ページ',
  pages: { lens: 'レンズ', cells: 'セル', rounds: 'ラウンド', compare: '比較', settings: '設定' },
  close: '閉じる',
  saveAsSvg: 'SVGで保存',
};

export const lens: Texts['lens'] = {
  title: '点のウェイト',
  point: '画像を指してください',
  nothingBends: 'ここは変形しません',
  note: 'どの点も、まわりのハンドルのウェイトに応じて動きます。レンズは矢印キーでも動かせます。',
  tap: 'タップした点を調べます',
  click: 'クリックするとこの点を固定',
  follow: 'ポインターを追う',
  weights: 'ウェイト',
  weightsAt: (x, y) => `x ${x}、y ${y}のウェイト`,
  noHandle: 'この部分にはハンドルがないため、動きません。',
  ownWeight: '自身のウェイト',
  passedOn: '仮想ハンドル経由',
  virtualHandles: '仮想ハンドル',
  countOfThem: (count) => `${number(count)}個`,
  virtual: (number) => `仮想 ${number}`,
  distancePassed: (distance, percent) => `${distance}、${percent}を伝達`,
  spoken: (x, y, shares) => `x ${x}、y ${y}：${shares.join('、') || '動かすハンドルはありません'}`,
  share: (handle, percent) => `${handle} ${percent}`,
  virtualShare: (percent) => `仮想ハンドル ${percent}`,

  falloff: '減衰',
  falloffOf: (handle) => `${handle}の減衰`,
  noEnd: 'この部分にはほかのハンドルがないため、影響範囲に終わりがありません。',
  falloffLabel: (value, distance, end) => `減衰は距離${distance}で${value}、${end}で終わります。`,
  radii: (cell, nearest, support) =>
    `セル r_d ${cell}${nearest === null ? '' : `、最も近いほかのハンドル r_h ${nearest}`}${support === null ? '' : `、影響範囲 r ${support}`}。図の r または α をドラッグできます。`,
  distanceAxis: '形の内側の距離 d、px',
  thisPoint: (distance) => `この点：${distance} →`,
};

export const cells: Texts['cells'] = {
  title: 'セルとその半径',
  none: 'ハンドルがないとセルはありません。',
  counts: (own, virtual) => `ハンドルのセル${number(own)}個、仮想ハンドルのセル${number(virtual)}個`,
  label: '形とそのセル、セルの半径',
  farthest: 'r_d：セルの最も遠い点まで',
  nearest: 'r_h：最も近いほかのハンドルまで',
  note: '影響範囲は自分のセルを覆い、次のハンドルの手前で終わります。そのため r_d は r_h の限度内でなければなりません。',
  toFarthest: 'セルの最も遠い点まで',
  toNearest: '最も近いほかの制御点まで',
  times: '今回の計算時間',
  stages: {
    domain: '輪郭の検出',
    sampling: 'サンプリング',
    regions: '距離、セル、仮想ハンドル',
    weights: 'ウェイト',
    pose: 'ポーズ1回',
  },
};

export const rounds: Texts['rounds'] = {
  title: 'アルゴリズム1',
  figure: (round) => `アルゴリズム1のラウンド${round}`,
  none: 'ハンドルがないと挿入するものがありません。',
  play: '再生',
  pause: '一時停止',
  previous: '前のラウンド',
  next: '次のラウンド',
  round: 'ラウンド',
  roundOf: (round, rounds) => `ラウンド ${round}／${rounds}`,
  end: (round, handles) =>
    `ラウンド${round}：終了。大きすぎるセルはなく、ハンドルは${number(handles)}個です。`,
  tooLarge: (round, reach, allowed, enters) =>
    `ラウンド${round}：${reach}に及ぶセルがあり、許容は${allowed}です。${enters}`,
  asked: (round, enters) =>
    `ラウンド${round}：大きすぎるセルはありませんが、プロジェクトがさらに仮想ハンドルを求めています。${enters}`,
  enters: (handle, distance, others) =>
    `${handle}のセルの${distance}離れた場所に仮想ハンドルが入り${others > 0 ? `、別の場所にもさらに${number(others)}個入り` : ''}ます。`,
  curve: (score, allowed) => `スコアは${score}です。許容される最大値は${allowed}です。`,
  note: '論文の図3と同じく、各ラウンドの前の最悪のセルのスコアです。線より下では、どの影響範囲も自分のセルを覆い、次のハンドルの手前で終わります。その後のラウンドでは、プロジェクトが求める仮想ハンドルを挿入します。',
  roundAxis: 'ラウンド',
  allowed: '許容値',
};

export const compare: Texts['compare'] = {
  title: '1枚の画像を3つの方法で',
  note: '画像のハンドルをドラッグすると、3つとも動きます。',
  names: { paper: '論文', rigid: '剛体', plain: '単純な距離' },
  labels: {
    paper: '論文の方法による画像',
    rigid: '剛体変形による画像',
    plain: '単純な距離による画像',
  },
  notes: {
    paper: '形の内側の距離と調和場を使います。ハンドルは自分で回します。',
    rigid: '形ができるだけ保たれます。ハンドルは自動で回転します。',
    plain: '論文と同じですが、距離が隙間を越えるため、近くの部分も一緒に動きます。',
  },
};

export const settings: Texts['settings'] = {
  motion: '仮想ハンドルの動き',
  motionNotes: {
    rigid: '画像の形を保ちます。手足が曲がり、ハンドルは自動で回転します。',
    harmonic: '論文（式4）のとおり、調和場がハンドルの動きを混ぜ合わせます。ハンドルは自分で回します。',
  },
  rigid: '剛体',
  byHand: '手動',
  density: '仮想ハンドル',
  densityNote:
    '多いほど画像は細かく変形し、ドラッグの影響は狭くなります。0にすると論文のアルゴリズムが決めます。',
  atLeast: '最小数',
  shapeFactor: '影響範囲の係数 α',
  shapeFactorNote:
    '各ハンドルの影響がどこまで及ぶかです。0では自分のセルを少し越えるだけで、曲がりがきつくなります。1では許される限り広く及び、曲がりが緩やかになります。',
  support: '影響範囲の規則',
  supportNotes: {
    smooth: '仮想ハンドルの影響範囲が重なり合います。画像は均一に曲がります。',
    paper: '影響範囲は、仮想ハンドルも含む次のハンドルで終わります（式3）。画像は小刻みに曲がります。',
  },
  smooth: '滑らか',
  paper: '論文',
  continuity: '連続性',
  continuityNotes: {
    c2: '角の裏や穴のまわりでも滑らかに曲がります（2階微分まで連続）。穴には仮想ハンドルが置かれます。',
    exact: '穴の裏で左右の道のりが等しくなる場所に、細い折れ目が見えることがあります。',
  },
  exact: '厳密',
  degree: '減衰の次数 n',
  degreeNote:
    '5では2つのハンドルの間の曲がりが短く、ハンドルの近くはまとまって動きます。次数を上げると曲がりが道のり全体に広がります。',
  filling: '減衰の補間',
  fillingNote:
    '次数7以上で、減衰が両端の間をどう進むかです。「直線」は均等に減ります。「半分」は段を残し、そこでは2つのハンドルに半分ずつ従います。',
  line: '直線',
  half: '半分',
  blend: '混合方法',
  blendNotes: {
    rigid: '回転どうしを混ぜると回転になります。逆向きの2つの回転の間でも大きさが保たれます。',
    linear: '論文（式1）のとおり動きを平均します。逆向きの2つの回転の間は縮みます。',
  },
  linear: '線形',
  samples: 'サンプル点',
  samplesNote: '画像を支える点です。多いほど曲がりが細かく描かれ、計算に時間がかかります。',
  points: '点',
  threshold: '不透明度の下限',
  thresholdNote: 'これより透明な部分は変形しません。小さくすると、柔らかい縁や細い毛も含まれます。',
  opacity: '不透明度',
  asInPaper: '論文のとおり',
  asInEditor: 'エディターの標準',
};
