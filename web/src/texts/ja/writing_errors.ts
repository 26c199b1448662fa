/** Errors of files that are written: exports of pictures and films. */
import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `${format}を書き出せませんでした：${why}`,
  film: (why) => `動画をエンコードできませんでした：${why}`,
  filmStorage: (why) => `動画を保存できませんでした：${why}`,
  reasons: {
    encoderFailed: 'エンコーダーが失敗したか、読み込めませんでした。ページを再読み込みしてください。',
    encoderStopped: 'エンコーダーが停止したか、読み込めませんでした。ページを再読み込みしてください。',
    encoderNotLoaded: (address) =>
      `エンコーダーを読み込めませんでした。${address}が存在することと、接続を確認してください。`,
    canvasTooLarge:
      'このブラウザーはこのサイズの画像を描画できません。サイズを小さくするか、PNGを選んでください。',
    formatUnsupported: 'このブラウザーはこの形式を書き出せません。PNGを選んでください。',
    noCodec: 'このブラウザーはこの形式をこのサイズでエンコードできません。別の形式を選んでください。',
    codecFailed: 'ブラウザーのエンコーダーが失敗しました。サイズを小さくするか、別の形式を選んでください。',
    filmTooLarge: 'このブラウザーのメモリには大きすぎます。サイズを小さくするか、別の形式を選んでください。',
    zipTooLarge: 'ZIPに入るのは最大4 GBです。サイズを小さくするか、フレームを減らしてください。',
    diskFull: 'ディスクが一杯です。',
    diskRefuses:
      'ディスクに書き込めません。ディスクが接続され、このページに書き込みが許可されていることを確認してください。',
    other: (detail) => `${detail}.`,
  },
};
