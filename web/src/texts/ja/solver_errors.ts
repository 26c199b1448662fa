/** Errors of the solver and its worker. */
import type { Texts } from '../texts';

export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: '画像に必要なメモリが足りません。画像を縮小してください。',
  pictures: '画像に必要なメモリが足りません。それぞれの画像を縮小してください。',
  suggest: 'ハンドルの提案に必要なメモリが足りません。画像を縮小してください。',
  solve: '使えるメモリではソルバーが処理しきれません。',
  fill: '背景を埋めるためのメモリが足りません。画像を縮小してください。',
  draw: '画像の描画に必要なメモリが足りません。',
  film: '動画の描画に必要なメモリが、このブラウザーでは足りません。',
  points: '点の処理に必要なメモリが足りません。',
  cells: 'このブラウザーのソルバーではセルを処理しきれません。',
  study: 'このブラウザーのソルバーでは図を処理しきれません。',
  lens: 'このブラウザーのソルバーではレンズを処理しきれません。',
  rig: 'このブラウザーではクリップがリグに収まりません。クリップを短くしてください。',
  map: 'このブラウザーではファイルを扱いきれません。コマンドラインなら書き出せます。',
  drawing: 'このブラウザーでは図形を変形しきれません。簡略化してください。',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `ソルバーを読み込めませんでした：${why}`,
  exportNotLoaded: (why) => `書き出しを開始できませんでした：${why}`,
  status: (address, status) => `${address}の応答は${status}です`,
  isPage: (address) => `${address}がなく、代わりにWebページがあります`,
  absent: (address) => `${address}が届きません。ネットワークと、ページで許可されているかを確認してください`,
  incomplete: (address, detail) => `${address}が不完全に届いたか、ここでは実行できません（${detail}）。`,
  noWorkers: 'ソルバーを開始できませんでした。このブラウザーまたはページがワーカーを許可していません。',
  notStarted: (address) =>
    `ソルバーのワーカーを開始できませんでした。${address}があるか、ページで許可されているかを確認してください。`,
  exportNotStarted: (address) =>
    `書き出しを開始できませんでした。${address}があるか、ページでワーカーが許可されているかを確認してください。`,
  lostDrawing: '描画中にソルバーが失敗しました。',
  released: '画像のピクセルが失われたか、そのためのメモリがありません。画像を開き直してください。',
};

export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `プロジェクトが正しくありません：${detail}`,
  picture: (detail) => `この画像は使えません：${detail}`,
  'picture-mismatch': () => 'このプロジェクトは、サイズの異なる別の画像用です。',
  scale: () => '書き出しが大きすぎるか小さすぎます。別のサイズを選んでください。',
  canvas: () => '全体では大きすぎます。サイズを小さくするか、元の画像の長方形を選んでください。',
  'nothing-drawn': () => '描画部分がありません。画像全体が透明です。',
  'nothing-opaque': () =>
    '変形できるほど不透明なピクセルがありません。設定「不透明度の下限」を下げてください。',
  'nothing-to-fill-from': () =>
    '選択範囲のまわりに、背景を埋めるための絵が残っていません。小さく囲み直すか、空のままにしてください。',
  'no-outline': () => 'この画像には透明部分がなく、リグを合わせる輪郭がありません。',
  domain: (detail) => `選択範囲が正しくありません：${detail}`,
  'handle-outside': (_, name) => `「${name}」が形の外にあります。画像の上に置いてください。`,
  'handle-far-outside': (_, name) => `「${name}」がこの画像から大きく外れます。リグが画像に合いません。`,
  'handles-too-close': (_, name, other) =>
    `「${name}」と「${other}」が同じ場所にあります。どちらかを移動または削除してください。`,
  'bar-too-short': (_, name) =>
    `「${name}」の2つの角が同じ場所にあります。どちらかを移動または削除してください。`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `「${name}」が自分自身に沿って折り返しています。交差や接触はできますが、重なることはできません。`
      : `「${name}」と「${other}」が互いに沿って重なっています。交差や接触はできますが、重なることはできません。`,
  'on-held-boundary': (_, name) =>
    `「${name}」が固定された境界の上にあります。内側に移動するか、境界の固定を解除してください。`,
  'too-many-handles': () => 'ハンドルが多すぎます。いくつか削除してください。',
  'too-many-corners': (_, name) =>
    `バーと多角形の角が多すぎます。${name ? `「${name}」の` : ''}角を減らして描いてください。`,
  'handles-crowded': () => '近すぎるハンドルが多すぎます。いくつかを離すか、削除してください。',
  'outline-too-long': () =>
    'この輪郭には切れ込みや突起が多すぎます。もっと単純に、または大まかに描いてください。',
  'too-many-sites': () =>
    'ハンドルどうしが近すぎるか、多すぎます。いくつかを離すか、細かさを下げてください。',
  'too-much-memory': () => 'ブラウザーのメモリが足りません。ハンドルを減らすか、細かさを下げてください。',
  'too-much-work': () => '複雑すぎて数秒では計算できません。ハンドルを減らすか、輪郭を単純にしてください。',
  'held-too-fine': () =>
    'この輪郭は角が多すぎて固定できません。もっと単純に描くか、動けるようにしてください。',
  unsupported: (detail) => `対応していない設定です：${detail}`,
  pose: (detail) => `ポーズが正しくありません：${detail}`,
  film: (detail) => `動画を作成できません：${detail}`,
  'point-outside': (detail) => `点が形の外にあります：${detail}`,
  mesh: (detail) => `メッシュが正しくありません：${detail}`,
  cloud: (detail) => `点群が正しくありません：${detail}`,
  poser: (detail) => `ポーズを適用できません：${detail}`,
};
