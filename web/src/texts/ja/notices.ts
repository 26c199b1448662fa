/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { counted, fewNames, number, quoted } from './language';

const GRAPHICS_LOST = 'ブラウザーがグラフィックスカードを使えなくなり、画像を表示できません。';

const inRows = (rows: boolean): string => (rows ? '画像に輪郭がないため、等間隔に' : '');

export const notices: Texts['notices'] = {
  nothingToHold: 'ハンドルは画像の上に置いてください。',
  lassoOutside: '選択範囲の外では画像は変形しません。',
  lassoEmpty: '投げ縄の中が空です。画像の一部を囲んでください。',
  drawingEnded: '描画を終了しました。',
  lassoFilled: 'この部分だけが、埋めた背景の上で変形します。',
  lassoLoose: 'この部分だけが変形します。動いた跡には隙間が残ります。',
  partOnFrame: 'この部分は固定された画像の枠に接しているため、回せません。',
  leftOut: (count) =>
    `投げ縄の外にある${counted(count, 'ハンドル')}を削除しました。「元に戻す」で復元できます。`,
  notKept:
    'このブラウザーに作業内容を保管できません。保管領域が一杯か、使用が禁止されています。ページを離れる前にプロジェクトを保存してください。',
  newerWork:
    'このブラウザーには、新しい版のエディターで作成した作業が保管されています。その作業は残ります。ページを再読み込みして更新するか、離れる前にプロジェクトを保存してください。',
  otherTab:
    '別のタブでもこの作業が変更されました。両方の版が残っています。どちらかを選ぶには、ページを再読み込みしてください。',
  twoVersions: (picture) => `${picture}は2つのタブで変更されました。これは新しいほうの版です。`,
  graphicsLost: `${GRAPHICS_LOST}ページを再読み込みしてください。`,
  graphicsLostStored: `${GRAPHICS_LOST}作業内容は保管されています。ページを再読み込みしてください。`,
  graphicsLostUnstored: `${GRAPHICS_LOST}プロジェクトを保存してから、ページを再読み込みしてください。`,
  clipNameTaken: (name) => `「${name}」という名前は別のクリップが使っています。名前は変更されませんでした。`,

  outsidePicture: (handles) => `${fewNames(handles)}の一部が画像の外にあり、その部分は効きません。`,
  outsideLasso: (handles) => `${fewNames(handles)}の一部が投げ縄の外にあり、その部分は効きません。`,
  nameStays: {
    empty: (name) => `ハンドルには名前が必要です。${quoted(name)}のままにします。`,
    taken: (name) => `この名前は別のハンドルが使っています。${quoted(name)}のままにします。`,
  },
  outlineSimplified: '輪郭がとても細かいため、変形は輪郭を大まかにたどります。',
  outlineBridged: (pixels) => `輪郭が細かすぎてたどれません。${pixels}ピクセル以内の部分は一緒に変形します。`,
  outlinePicture: '輪郭が細かすぎてたどれません。画像全体が変形します。',
  looseParts: (count) => `${number(count)}個の部分にハンドルがなく、その場に残ります。`,
  sameThere: '両側はすでに同じです。',
  noOtherSide: (handles) => `${fewNames(handles)}を反転した位置は画像の外です。`,
  noCounterpart: (handles) => `${fewNames(handles)}のポーズに合うハンドルがここにはありません。`,
  brushedStill: 'すべてのハンドルをリセットしました。ブラシの跡は残っています。',

  noPose: 'クリップボードにポーズがありません。先にコピーしてください。',
  badPose: (detail) => `このポーズを貼り付けられませんでした：${detail}。`,
  badKeys: (detail) => `このキーフレームを貼り付けられませんでした：${detail}。`,
  notCopied:
    'ブラウザーがクリップボードの使用を拒否しました。コピーした内容はこのページでのみ貼り付けられます。',
  notCopiedByMenu: (keys) =>
    `ブラウザーがクリップボードの使用を拒否しました。コピーした内容はこのページでのみ貼り付けられます。${keys}を押すと、ほかのページ用にもコピーできます。`,
  notRead: 'ブラウザーがクリップボードの使用を拒否しました。貼り付けるには許可してください。',
  notReadByMenu: (keys) =>
    `ブラウザーがクリップボードの使用を拒否しました。${keys}を押して貼り付けてください。`,

  emptyAddress: 'https:// で始まるアドレスを入力してください。',
  noAddress: (text) =>
    `${quoted(text)}は画像のアドレスではありません。https:// または data:image/ で始まるアドレスを入力してください。`,
  nothingDropped: '画像、または画像へのリンクをドロップしてください。',
  notCarried: (picture, why) => `${picture}をプロジェクトなしで開きました。${why}`,
  removed: (picture) => `${picture}を一覧から除去しました。`,
  removedAll: (count) => `${number(count)}個の画像を一覧から除去しました。`,
  notOpened: (file, more) =>
    `一度に開ける画像は1つだけです。${file}${more === 0 ? '' : `とほか${number(more)}個`}は開きませんでした。`,
  moves: (picture) => `${picture}はアニメーションです。最初のフレームだけを開きました。`,
  lacksTexts: (picture) =>
    `${picture}は描画に時間がかかるため、テキストなしで開きました。表示するには、テキストをパスに変換してください。`,
  isOpen: (picture) => `${picture}を開きました。`,
  saved: (file) => `${file}として保存しました。`,
  savedCut: (file) => `${file}として保存しました。枠からはみ出した部分は切り取られました。`,
  selectOne: '先にハンドルを1つ選択してください。',

  awaiting: (project, source, width, height) =>
    `${project}は${source ? `画像「${source}」` : '元になった画像'}（${width} × ${height} px）用です。続けるにはその画像を開いてください。`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${project}は${source ? `画像「${source}」` : '元になった画像'}（${width} × ${height} px）用です。続けるにはその画像を開くか、リグを${picture}に使ってください。`,
  theProject: 'プロジェクト',
  movedInside: (handles) => `${fewNames(handles)}が画像の外にあったため、画像の上に移動しました。`,

  folds: '画像が折れ重なっています。',
  foldedBy: (handles) => `${fewNames(handles, quoted)}により画像が折れています。`,
  leftFolds: (handles) => `${fewNames(handles, quoted)}を、折れのない最も近いポーズに戻しました。`,
  noWayOut: '現在のポーズと初期ポーズの間に、折れのないポーズが見つかりませんでした。',

  placed: (added, rows) =>
    `${inRows(rows)}${counted(added, 'ハンドル')}を置きました。ドラッグすると画像が変形します。`,
  added: (added, there, rows) =>
    `${inRows(rows)}${counted(added, 'ハンドル')}を追加しました。前からある${counted(there, 'ハンドル')}はそのままです。`,
  noSuggestion: 'ハンドルを追加しませんでした。適した場所の近くには、すでにハンドルがあります。',
  noPlace: 'この画像にはハンドルを置く余地がありません。',

  noKeysSelected: '先にキーフレームを選択してください。',
  noCopiedKeys: '先にキーフレームをコピーしてください。',
  copiedKeys: (count) => `${counted(count, 'キーフレーム')}をコピーしました`,
  keysLeftOut: (count) =>
    `${counted(count, 'キーフレーム')}を省きました。クリップの終わりを越えているか、対応するハンドルがありません。`,

  newVersion: '新しいバージョンの準備ができました。次にエディターを開いたときに起動します。',
  newVersionWaits:
    '新しいバージョンの準備ができました。エディターのほかのウィンドウをすべて閉じると起動します。',
  notOffline:
    'ダウンロードが中断されたため、エディターはまだオフラインで使えません。次回の起動時に再開します。',
  offered: (files) => `リンクまたはほかのアプリが${fewNames(files)}を開こうとしています。`,
  shareFailed: '共有された画像を受け取れませんでした。ここでファイルを開いてください。',
  notGiven: (file) => `${file}を読み込めませんでした。移動または変更されています。ここで開いてください。`,
};

export const answers: Texts['answers'] = {
  tryAgain: '再試行',
  continueDrawing: '描画を続ける',
  takeBack: '跡を消去',
  exportAll: '画像全体を書き出す',
  holdBoundary: '輪郭を固定',
  extendSelection: '選択範囲を広げる',
  letFollow: '一緒に動かす',
  putBack: '復元',
  showOtherVersion: '別の版を表示',
  keepThis: 'この版を残す',
  backTo: (picture) => `${picture}に戻る`,
  open: '開く',
  openPicture: '画像を開く',
  useRig: 'このリグを使う',
};
