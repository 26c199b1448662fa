/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: 'ファイルが空です。',
  unreadable:
    'ファイルを読み込めません。フォルダーであるか、移動または変更されています。ファイルを選び直してください。',
  incomplete: '画像が不完全です。ファイルの末尾が欠けています。ファイルを入手し直してください。',
  unknown: 'このブラウザーで読める画像ファイルではありません。PNG、JPEG、WebPを使ってください。',
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
  drawingEncoding: (encoding) => `図形を${encoding}として読み込めません。UTF-8 で保存してください。`,
  drawingUnread: '図形を読み込めませんでした。接続を確認して、もう一度開いてください。',
  drawingTooManyElements: (most) => `図形の要素が${number(most)}個を超えています。簡単にしてください。`,
  drawingTooManyAttributes: (most) => `図形に属性が${most}個を超える要素があります。減らしてください。`,
  drawingTooDeep: (most) => `図形の要素の入れ子が${most}段を超えています。グループを解除してください。`,
  drawingTooManyCopies: '図形の要素が使い回されすぎています。小さくするか、使う回数を減らしてください。',
  drawingTooManyStyles: '図形のスタイルの処理に時間がかかりすぎます。簡単にしてください。',
  drawingTooSlow: (element) =>
    `図形の描画に時間がかかりすぎます。主な原因は<${element}>です。簡単にしてください。`,
  drawingTooMuchMemory: (element) =>
    `図形の描画に必要なメモリが多すぎます。主な原因は<${element}>です。簡単にしてください。`,
  noWebgl:
    'このブラウザーはWebGL2で画像を読み込めません。ハードウェアアクセラレーションを有効にするか、別のブラウザーを使ってください。',
  contextLost: '画像の読み込み中にグラフィックスコンテキストが失われました。画像を開き直してください。',
};

export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `${file}を読み込めませんでした：サーバーの応答は${status}でした。`,
  webPage: (file) =>
    `${file}を読み込めませんでした：これはWebページです。画像そのもののアドレスを入力してください。`,
  unreachable: (file) => `${file}を読み込めませんでした。アドレスとネットワーク接続を確認してください。`,
  refused: (file, host) =>
    `${file}を読み込めませんでした。${host}がこのページからの読み込みを許可していないか（CORS）、接続できません。画像を保存して、そのファイルを開いてください。`,
  damaged: 'アドレスに含まれる画像が壊れています。コピーし直すか、ファイルとして保存してください。',
};

export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: 'この画像に含まれるプロジェクトは長すぎます。',
  damaged: 'この画像に含まれるプロジェクトは壊れています。',
  compressed: 'この画像に含まれるプロジェクトは圧縮されており、対応していません。',
};
