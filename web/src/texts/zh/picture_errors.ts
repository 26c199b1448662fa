/** Errors of pictures and of the files that they are in. */
import type { Texts } from '../texts';
import { number, quoted } from './language';

export const pictureErrors: Texts['errors']['picture'] = {
  empty: '文件是空的。',
  unreadable: '无法读取文件。它是文件夹，或者已被移动或更改。请重新选择文件。',
  incomplete: '图片不完整：缺少文件末尾。请重新下载或复制文件。',
  unknown: '此浏览器无法将该文件作为图片读取。请使用 PNG、JPEG 或 WebP。',
  otherKind: (kind) => `这是 ${kind}。请另存为 PNG、JPEG 或 WebP。`,
  kinds: {
    png: 'PNG 图片',
    jpeg: 'JPEG 图片',
    gif: 'GIF 图片',
    webp: 'WebP 图片',
    avif: 'AVIF 图片',
    heic: 'HEIC 图片',
    bmp: 'BMP 图片',
    icon: '图标',
    tiff: 'TIFF 图片',
    photoshop: 'Photoshop 文档',
    pdf: 'PDF 文档',
    postscript: 'PostScript 文档',
    jpegXl: 'JPEG XL 图片',
    jpeg2000: 'JPEG 2000 图片',
    svg: 'SVG 矢量图',
    compressed: '压缩文件',
  },
  damaged: '图片已损坏，或此浏览器无法读取。请重新保存为 PNG、JPEG 或 WebP。',
  tooSmall: (width, height, least) => `图片为 ${width} × ${height} px。至少须为 ${least} × ${least} px。`,
  tooLong: (width, height, most) =>
    `图片为 ${width} × ${height} px。边长最多 ${number(most)} px。请缩小图片。`,
  tooLarge: (width, height, millions) =>
    `图片为 ${width} × ${height} px。最多 ${number(millions * 100)} 万像素。请缩小图片。`,
  drawingDamaged: '矢量图已损坏，或此浏览器无法显示。',
  drawingWithoutSize: '矢量图没有尺寸。请为其设定宽度和高度，或 viewBox。',
  drawingTooLarge: '矢量图超过 64 MB。请将其简化。',
  drawingEncoding: (encoding) => `矢量图不能按${encoding}读取。请另存为 UTF-8。`,
  drawingRefused: (detail) => `无法打开此矢量图：${detail}`,
  noWebgl: '此浏览器无法用 WebGL2 读取图片。请开启硬件加速，或使用其他浏览器。',
  contextLost: '读取图片时，浏览器无法再访问显卡。请重新打开图片。',
};

export const addressErrors: Texts['errors']['address'] = {
  status: (file, status) => `无法加载${quoted(file)}：服务器返回 ${status}。`,
  webPage: (file) => `${quoted(file)}是网页。请输入图片本身的网址。`,
  unreachable: (file) => `无法加载${quoted(file)}。请检查网址和网络连接。`,
  refused: (file, host) =>
    `无法加载${quoted(file)}。${host} 不允许本页面读取（CORS），或无法连接。请先保存图片，再打开文件。`,
  damaged: '网址中的图片已损坏。请重新复制，或将其保存为文件。',
};

export const carriedErrors: Texts['errors']['carried'] = {
  tooLong: '此图片中的项目过大。',
  damaged: '此图片中的项目已损坏。',
  compressed: '此图片中的项目经过压缩。编辑器只能读取未压缩的项目。',
};
