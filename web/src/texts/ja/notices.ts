/** Notices: sentences over the picture, with the words of their buttons. */
import type { Texts } from '../texts';
import { counted, fewNames, number, quoted } from './language';

const GRAPHICS_LOST = 'グラフィックスカードが使えなくなったため、画像を表示できません。';

const inRows = (rows: boolean): string => (rows ? 'たどれる輪郭がないため、等間隔に' : '');

export const notices: Texts['notices'] = {
  nothingToHold: 'ここには押さえるものがありません。ハンドルは画像の上に置いてください。',
  lassoOutside: '選択範囲の外では画像は動きません。',
  lassoEmpty: '投げ縄の中が空です。画像の一部を囲んでください。',
  lassoFilled: 'この部分だけが、埋めた背景の上で変形します。',
  lassoLoose: 'この部分だけが変形します。動いた跡には隙間が残ります。',
  partOnFrame: 'この部分は固定された画像の枠に接しているため、回せません。',
  leftOut: (count) =>
    `投げ縄の外にある${counted(count, 'ハンドル')}を削除しました。「元に戻す」で復元できます。`,
  notKept:
    '作業内容がこのブラウザーに保管されていません。保管領域が一杯か、使用が禁止されています。離れる前にプロジェクトを保存してください。',
  otherTab: '別のタブでもこの作業が変更されました。両方の版が残っており、再読み込みすると選べます。',
  twoVersions: (picture) => `${picture}は2つのタブで変更されました。これは新しいほうの版です。`,
  graphicsLost: `${GRAPHICS_LOST}ページを再読み込みしてください。`,
  graphicsLostStored: `${GRAPHICS_LOST}作業内容は失われていません。ページを再読み込みしてください。`,
  graphicsLostUnstored: `${GRAPHICS_LOST}作業内容はまだ失われていません。プロジェクトを保存してから、ページを再読み込みしてください。`,
  clipNameTaken: (name) => `「${name}」という名前は別のクリップが使っています。元の名前のままにします。`,

  outsidePicture: (handles) => `${fewNames(handles)}の一部が画像の外にあり、その部分は何も動かしません。`,
  outsideLasso: (handles) => `${fewNames(handles)}の一部が投げ縄の外にあり、その部分は何も動かしません。`,
  nameStays: {
    empty: (name) => `ハンドルには名前が必要です。${quoted(name)}のままにします。`,
    taken: (name) => `この名前は別のハンドルが使っています。${quoted(name)}のままにします。`,
  },
  outlineSimplified: '輪郭がとても細かいため、大まかにたどります。',
  outlineBridged: (pixels) => `輪郭が細かすぎてたどれません。${pixels}ピクセル以内の部分は一緒に変形します。`,
  outlinePicture: '輪郭が細かすぎてたどれません。画像全体が変形します。',
  looseParts: (count) => `${number(count)}個の部分にハンドルがなく、取り残されます。`,
  sameThere: '両側はすでに同じです。',
  noOtherSide: (handles) => `${fewNames(handles)}の反対側には画像がありません。`,
  noCounterpart: (handles) => `${fewNames(handles)}のポーズに合うハンドルがここにはありません。`,
  brushedStill: 'ハンドルは初期位置にあります。ブラシの跡は残ります。',

  noPose: 'クリップボードにポーズがありません。先にコピーしてください。',
  badPose: (detail) => `このポーズは貼り付けられません：${detail}。`,
  notCopied: 'ブラウザーがクリップボードの使用を拒否しました。ポーズはこのページでのみ貼り付けられます。',
  notCopiedByMenu: (keys) =>
    `ブラウザーがクリップボードの使用を拒否しました。ポーズはこのページでのみ貼り付けられます。${keys}を押すと、ほかのページ用にもコピーできます。`,
  notRead: 'ブラウザーがクリップボードの使用を拒否しました。貼り付けるには許可してください。',
  notReadByMenu: (keys) =>
    `ブラウザーがクリップボードの使用を拒否しました。${keys}を押して貼り付けてください。`,

  emptyAddress: 'アドレスがありません。https:// で始まるアドレスを入力してください',
  noAddress: (text) =>
    `${quoted(text)}は画像のアドレスではありません。https:// または data:image/ で始まる必要があります。`,
  nothingDropped: 'ドロップされたものに、画像も画像のアドレスも含まれていません。',
  notCarried: (picture, why) => `${picture}は画像としてのみ開きました。${why}`,
  removed: (picture) => `${picture}を一覧から除去しました。`,
  removedAll: (count) => `${number(count)}個の画像を一覧から除去しました。`,
  notOpened: (file, more) =>
    `一度に開ける画像は1つだけです。${file}${more === 0 ? '' : `とほか${number(more)}個`}は開きませんでした。`,
  moves: (picture) => `${picture}は動画です。最初のフレームだけを開きました。`,
  lacksTexts: (picture) =>
    `${picture}は描画に時間がかかるため、テキストなしで開きました。表示するには、テキストをパスに変換してください。`,
  isOpen: (picture) => `${picture}を開きました。`,
  saved: (file) => `${file}として保存しました。`,
  savedCut: (file) => `${file}として保存しました。枠からはみ出した部分は切り取られています。`,
  selectOne: 'これは1つのハンドルに対する操作です。先にハンドルを選択してください。',

  awaiting: (project, source, width, height) =>
    `${project}は${source ? `画像「${source}」` : '元になった画像'}（${width} × ${height} px）用です。続けるにはその画像を開いてください。`,
  awaitingOrRig: (project, source, width, height, picture) =>
    `${project}は${source ? `画像「${source}」` : '元になった画像'}（${width} × ${height} px）用です。続けるにはその画像を開くか、リグを${picture}に使ってください。`,
  theProject: 'プロジェクト',
  movedInside: (handles) => `${fewNames(handles)}が画像の外にあったため、画像の上に移動しました。`,

  folds: '画像が折れています。',
  foldedBy: (handles) => `${fewNames(handles, quoted)}により画像が折れています。`,
  leftFolds: (handles) => `${fewNames(handles, quoted)}を、折れのない最も近いポーズに戻しました。`,
  noWayOut: '現在のポーズと初期ポーズの間に、折れのないポーズが見つかりませんでした。',

  placed: (added, rows) =>
    `${inRows(rows)}${counted(added, 'ハンドル')}を置きました。ドラッグすると画像が変形します。`,
  added: (added, there, rows) =>
    `${inRows(rows)}${counted(added, 'ハンドル')}を追加しました。前からある${counted(there, 'ハンドル')}はそのままです。`,
  noSuggestion: 'ハンドルを追加しませんでした。候補となるどの場所の近くにも、すでにハンドルがあります。',
  noPlace: 'この画像にはハンドルを置く余地がありません。',

  noKeysSelected: 'キーフレームが選択されていません。',
  noCopiedKeys: 'コピーされたキーフレームがありません。',
  copiedKeys: (count) => `${counted(count, 'キーフレーム')}をコピーしました`,
  keysLeftOut: (count) =>
    `${counted(count, 'キーフレーム')}を省きました。クリップの終わりを越えているか、ここにないハンドルのものです。`,

  newVersion: '新しいバージョンの準備ができました。次回の起動時に開きます。',
  newVersionWaits: '新しいバージョンの準備ができました。エディターのほかのウィンドウを閉じると開きます。',
  notOffline:
    'ダウンロードが途切れたため、エディターをオフラインで使う準備ができていません。次回の起動時にもう一度試みます。',
  shareFailed: '共有された画像が届きませんでした。ここでファイルを開いてください。',
  notGiven: (file) => `${file}を読み込めません。移動または変更されています。ここで開いてください。`,
};

export const answers: Texts['answers'] = {
  tryAgain: '再試行',
  takeBack: '取り消す',
  exportAll: '全体を書き出す',
  holdBoundary: '境界を固定',
  extendSelection: '選択範囲を広げる',
  letFollow: '一緒に動かす',
  putBack: '一覧に戻す',
  showOtherVersion: '別の版を表示',
  keepThis: 'この版を残す',
  backTo: (picture) => `${picture}に戻る`,
  openPicture: '画像を開く',
  useRig: 'このリグを使う',
};
