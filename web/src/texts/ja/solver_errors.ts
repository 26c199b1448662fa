/** Errors of the solver and its worker. */
import type { Texts } from '../texts';

export const tooMuchErrors: Texts['errors']['tooMuch'] = {
  picture: '画像が大きすぎてメモリに収まりません。画像を縮小してください。',
  pictures: '画像が大きすぎてメモリに収まりません。それぞれの画像を縮小してください。',
  suggest: 'ハンドルを提案するためのメモリが足りません。画像を縮小してください。',
  solve: 'この変形に必要なメモリが足りません。ハンドルを減らすか、細かさを下げてください。',
  fill: '背景を埋めるためのメモリが足りません。画像を縮小してください。',
  draw: '画像の描画に必要なメモリが足りません。サイズを小さくしてください。',
  film: 'このブラウザーでは、動画の描画に必要なメモリが足りません。サイズを小さくしてください。',
  points: '点が多すぎて、メモリが足りません。',
  cells: 'このブラウザーでは、セルの計算に必要なメモリが足りません。',
  study: 'このブラウザーでは、図の計算に必要なメモリが足りません。',
  lens: 'このブラウザーでは、レンズに必要なメモリが足りません。',
  rig: 'クリップが長すぎて、このブラウザーではリグにできません。クリップを短くしてください。',
  map: 'ファイルがこのブラウザーには大きすぎます。コマンドラインを使ってください。',
  drawing: '図形が複雑すぎて、このブラウザーでは変形できません。簡略化してください。',
};

export const engineErrors: Texts['errors']['engine'] = {
  notLoaded: (why) => `計算エンジンを読み込めませんでした：${why}`,
  exportNotLoaded: (why) => `書き出しを開始できませんでした：${why}`,
  status: (address, status) => `${address}に対するサーバーの応答は${status}でした。`,
  isPage: (address) => `サーバーが${address}の代わりにWebページを返しました。`,
  absent: (address) => `${address}に接続できません。接続とページのセキュリティポリシーを確認してください。`,
  incomplete: (address, detail) => `${address}が不完全か、ここでは実行できません（${detail}）。`,
  noWorkers: '計算エンジンを開始できませんでした。このブラウザーまたはページがワーカーを許可していません。',
  notStarted: (address) =>
    `計算エンジンを開始できませんでした。${address}が存在し、ページでワーカーが許可されていることを確認してください。`,
  exportNotStarted: (address) =>
    `書き出しを開始できませんでした。${address}が存在し、ページでワーカーが許可されていることを確認してください。`,
  drawingNotChecked:
    'この図形に必要なエディターの一部を読み込めませんでした。接続と、ページがワーカーを許可していることを確認してください。',
  lostDrawing: '描画中に計算エンジンが失敗しました。',
  released: '画像のピクセルがメモリに残っていません。画像を開き直してください。',
};

export const refusals: Texts['errors']['refusals'] = {
  project: (detail) => `プロジェクトが正しくありません：${detail}`,
  picture: (detail) => `この画像は使えません：${detail}`,
  'picture-mismatch': () => 'このプロジェクトは、サイズの異なる別の画像用です。',
  scale: () => '書き出しが大きすぎるか小さすぎます。別のサイズを選んでください。',
  canvas: () => '拡張した画像が大きすぎます。サイズを小さくするか、元の枠を選んでください。',
  'nothing-drawn': () => '画像全体が透明です。',
  'nothing-opaque': () => '変形できるほど不透明な部分がありません。設定「不透明度の下限」を下げてください。',
  'nothing-to-fill-from': () =>
    '選択範囲の外に、背景を埋めるための絵が残っていません。小さく囲み直すか、背景の埋め込みをオフにしてください。',
  'no-outline': () => 'この画像には透明部分がなく、リグを合わせる輪郭がありません。',
  domain: (detail) => `選択範囲が正しくありません：${detail}`,
  'handle-outside': (_, name) => `「${name}」が形の外にあります。画像の上に置いてください。`,
  'handle-far-outside': (_, name) => `このリグは画像に合いません。「${name}」が画像から大きく外れます。`,
  'handles-too-close': (_, name, other) =>
    `「${name}」と「${other}」が同じ場所にあります。どちらかを移動または削除してください。`,
  'bar-too-short': (_, name) =>
    `「${name}」の2つの角が同じ場所にあります。どちらかを移動または削除してください。`,
  'bars-overlap': (_, name, other) =>
    name === other
      ? `「${name}」が自分自身に沿って折り返しています。交差や接触はできますが、重なることはできません。`
      : `「${name}」と「${other}」が互いに沿って重なっています。交差や接触はできますが、重なることはできません。`,
  'on-held-boundary': (_, name) =>
    `「${name}」が固定された輪郭の上にあります。内側に移動するか、輪郭の固定を解除してください。`,
  'too-many-handles': () => 'ハンドルが多すぎます。いくつか削除してください。',
  'too-many-corners': (_, name) =>
    `バーと多角形の角が多すぎます。${name ? `「${name}」の` : ''}角を減らして描いてください。`,
  'handles-crowded': () => '近すぎるハンドルが多すぎます。いくつかを離すか、削除してください。',
  'outline-too-long': () =>
    'この輪郭には切れ込みや突起が多すぎます。もっと単純に、または大まかに描いてください。',
  'too-many-sites': () =>
    'ハンドルが多すぎるか、互いに近すぎます。いくつかを離すか、細かさを下げてください。',
  'too-much-memory': () =>
    'この変形に必要なメモリがブラウザーには足りません。ハンドルを減らすか、細かさを下げてください。',
  'too-much-work': () =>
    'この変形は複雑すぎて数秒では計算できません。ハンドルを減らすか、輪郭を単純にしてください。',
  'held-too-fine': () =>
    'この輪郭は角が多すぎて固定できません。もっと単純に描くか、輪郭の固定を解除してください。',
  unsupported: (detail) => `対応していない設定です：${detail}`,
  pose: (detail) => `ポーズが正しくありません：${detail}`,
  film: (detail) => `動画を作成できません：${detail}`,
  'point-outside': (detail) => `点が形の外にあります：${detail}`,
  mesh: (detail) => `メッシュが正しくありません：${detail}`,
  cloud: (detail) => `点群が正しくありません：${detail}`,
  poser: (detail) => `ポーズを計算できません：${detail}`,
};
