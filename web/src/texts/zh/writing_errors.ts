/** Errors of files that are written: exports of pictures and films. */
import type { Texts } from '../texts';

export const writingErrors: Texts['errors']['writing'] = {
  picture: (format, why) => `无法写入 ${format}：${why}`,
  film: (why) => `无法编码影片：${why}`,
  filmStorage: (why) => `无法保存影片：${why}`,
  reasons: {
    encoderFailed: '编码器出错或未能加载。请重新加载页面。',
    encoderStopped: '编码器已停止或未能加载。请重新加载页面。',
    encoderNotLoaded: (address) => `编码器未能加载。请检查 ${address} 是否存在，以及网络连接是否正常。`,
    canvasTooLarge: '此浏览器无法绘制这么大的图片。请选择较小的尺寸，或 PNG。',
    formatUnsupported: '此浏览器无法写入该格式。请选择 PNG。',
    noCodec: '此浏览器无法以此尺寸编码该格式。请选择其他格式。',
    codecFailed: '浏览器的编码器出错。请选择较小的尺寸，或其他格式。',
    filmTooLarge: '影片对此浏览器的内存来说太大。请选择较小的尺寸，或其他格式。',
    zipTooLarge: 'zip 最多容纳 4 GB。请选择较小的尺寸，或减少帧数。',
    diskFull: '磁盘已满。',
    diskRefuses: '磁盘拒绝写入。请检查磁盘是否已连接，以及本页面是否有写入权限。',
    other: (detail) => `${detail}。`,
  },
};
