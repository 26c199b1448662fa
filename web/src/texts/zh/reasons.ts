/** Why a command cannot run now. */
import type { Texts } from '../texts';

export const reasons: Texts['reasons'] = {
  disabled: '编辑器已停用',
  leftOut: '此页面不提供这项功能',
  viewOnly: '此图片仅供查看',
  noPicture: '请先打开图片',
  noHandles: '请先添加控制点',
  noneSelected: '请先选择控制点',
  noSingle: '请只选择一个控制点',
  noLine: '请只选择一条折线或一个多边形',
  nothingToUndo: '没有可撤销的操作',
  nothingToRedo: '没有可重做的操作',
  atRest: '已在初始位置',
  inFront: '已在最前面',
  atBack: '已在最后面',
  nothingFolded: '没有折叠',
  noLasso: '请先用套索圈出一个部分',
  notOpaque: '仅适用于没有透明部分的图片',
  nothingBends: '此处不会变形',
  noClipOpen: '请先打开一个片段',
  cornersNeeded: {
    bar: (count) => `折线至少需要 ${count} 个角点`,
    polygon: (count) => `多边形至少需要 ${count} 个角点`,
  },
};
