/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'ファイルが空です。',
  unreadable:
    'ファイルを読み込めませんでした。フォルダーであるか、移動または変更されています。ファイルを選び直してください。',
  incomplete:
    '画像が不完全です。ファイルの末尾が欠けています。もう一度ダウンロードまたはコピーしてください。',
  unknown: 'このブラウザーはファイルを画像として読めません。PNG、JPEG、WebPを使ってください。',
  otherKind: (kind) => `これは${kind}です。PNG、JPEG、WebPのいずれかで保存してください。`,
  kinds: {
    png: 'PNG画像',
    jpeg: 'JPEG画像',
    gif: 'GIF画像',
    webp: 'WebP画像',
    avif: 'AVIF画像',
    heic: 'HEIC画像',
    bmp: 'BMP画像',
    icon: 'アイコン',
    tiff: 'TIFF画像',
    photoshop: 'Photoshopドキュメント',
    pdf: 'PDF文書',
    postscript: 'PostScript文書',
    jpegXl: 'JPEG XL画像',
    jpeg2000: 'JPEG 2000画像',
    svg: 'SVG図形',
    compressed: '圧縮ファイル',
  },
  damaged:
    '画像が壊れているか、このブラウザーでは読めません。PNG、JPEG、WebPのいずれかで保存し直してください。',
  tooSmall: (width, height, least) =>
    `画像は${width} × ${height} pxです。${least} × ${least} px以上である必要があります。`,
  tooLong: (width, height, most) =>
    `画像は${width} × ${height} pxです。一辺は最大${number(most)} pxです。画像を縮小してください。`,
  tooLarge: (width, height, millions) =>
    `画像は${width} × ${height} pxです。最大で${number(millions * 100)}万ピクセルです。画像を縮小してください。`,
  drawingDamaged: '図形が壊れているか、このブラウザーでは表示できません。',
  drawingWithoutSize: '図形にサイズがありません。幅と高さ、またはviewBoxを指定してください。',
  drawingTooLarge: '図形が64 MBを超えています。簡略化してください。',
  drawingEncoding: (encoding) => `図形を${encoding}として読み込めません。UTF-8で保存してください。`,
  drawingRefused: (detail) => `この図形は開けません：${detail}`,
  noWebgl:
    'このブラウザーはWebGL2で画像を読み込めません。ハードウェアアクセラレーションを有効にするか、別のブラウザーを使ってください。',
  contextLost:
    '画像の読み込み中に、ブラウザーがグラフィックスカードを使えなくなりました。画像を開き直してください。',
};

export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `${file}を読み込めませんでした：サーバーの応答は${status}でした。`,
  webPage: (file) => `${file}はWebページです。画像そのもののアドレスを入力してください。`,
  unreachable: (file) => `${file}を読み込めませんでした。アドレスと接続を確認してください。`,
  refused: (file, host) =>
    `${file}を読み込めませんでした。${host}がこのページからの読み込みを許可していないか（CORS）、接続できません。画像を保存して、そのファイルを開いてください。`,
  damaged: 'アドレスに含まれる画像が壊れています。コピーし直すか、ファイルとして保存してください。',
};

export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'この画像に含まれるプロジェクトは大きすぎます。',
  damaged: 'この画像に含まれるプロジェクトは壊れています。',
  compressed:
    'この画像に含まれるプロジェクトは圧縮されています。エディターが読めるのは非圧縮のプロジェクトだけです。',
};
