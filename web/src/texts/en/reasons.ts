/** Why a command cannot run now, in a few words: for menus and screen readers. */
export const reasons = {
  disabled: 'The editor is disabled',
  leftOut: 'Not available on this page',
  viewOnly: 'This picture is view-only',
  noPicture: 'Open a picture first',
  noHandles: 'Add a handle first',
  noneSelected: 'Select a handle first',
  noSingle: 'Select a single handle',
  noLine: 'Select a single bar or polygon',
  nothingToUndo: 'Nothing to undo',
  nothingToRedo: 'Nothing to redo',
  atRest: 'Already in the rest position',
  inFront: 'Already in front',
  atBack: 'Already at the back',
  nothingFolded: 'Nothing is folded',
  noLasso: 'Draw a lasso around a part first',
  notOpaque: 'Works only in pictures without transparency',
  nothingBends: 'Nothing bends here',
  noClipOpen: 'Open a clip first',
  /** @param count the least number of corners. */
  cornersNeeded: {
    bar: (count: number) => `A bar needs at least ${count} corners`,
    polygon: (count: number) => `A polygon needs at least ${count} corners`,
  },
};
