/** Why a command cannot run now, in a few words: for menus and screen readers. */
export const reasons = {
  disabled: 'The editor is disabled',
  leftOut: 'This page leaves it out',
  viewOnly: 'This picture is for viewing only',
  noPicture: 'Open a picture first',
  noHandles: 'There is no handle yet',
  noneSelected: 'Select a handle first',
  noSingle: 'Select a single handle',
  noLine: 'Select a single bar or polygon',
  nothingToUndo: 'There is nothing to undo',
  nothingToRedo: 'There is nothing to redo',
  atRest: 'At rest already',
  inFront: 'In front already',
  atBack: 'At the back already',
  nothingFolded: 'Nothing is folded',
  noLasso: 'Draw a lasso around a part first',
  notOpaque: 'Only pictures without transparency have a frame to hold',
  nothingBends: 'Nothing bends here',
  noClipOpen: 'No clip is open.',
  /** @param count the least number of corners. */
  cornersNeeded: {
    bar: (count: number) => `A bar needs ${count} corners`,
    polygon: (count: number) => `A polygon needs ${count} corners`,
  },
};
