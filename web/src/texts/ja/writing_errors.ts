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
      `エンコーダーを読み込めませんでした。${address}があるか、ネットワークにつながっているかを確認してください。`,
    canvasTooLarge:
      'このブラウザーではこのサイズのキャンバスを使えません。倍率を下げるか、PNGを選んでください。',
    formatUnsupported: 'このブラウザーはこの形式を書き出せません。PNGを選んでください。',
    noCodec: 'このブラウザーはこの形式をこのサイズでエンコードできません。別の形式を選んでください。',
    codecFailed: 'ブラウザーのエンコーダーが失敗しました。サイズを小さくするか、別の形式を選んでください。',
    filmTooLarge: 'このブラウザーのメモリでは足りません。サイズを小さくするか、別の形式を選んでください。',
    zipTooLarge: 'ZIPに入るのは最大4 GBです。サイズを小さくするか、フレームを減らしてください。',
    diskFull: 'ディスクが一杯です。',
    diskRefuses:
      'ディスクに書き込めません。ディスクがまだあるか、このページに書き込みが許可されているかを確認してください。',
    other: (detail) => `${detail}.`,
  },
};
