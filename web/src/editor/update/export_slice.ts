/** Exports in the state. */
import type { EditorState, ExportState } from '../state';

export const withExport = (state: EditorState, change: Partial<ExportState>): EditorState => ({
  ...state,
  exporting: { ...state.exporting, ...change },
});
