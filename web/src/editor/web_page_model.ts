/** An export for a web page, as the panel shows it. */
import { playerCode, rigName } from './player_code';
import { type EditorState, type ExportState, filedProject } from './state';

export interface WebPageModel {
  /** HTML that shows the rig. */
  readonly code: string;
  /** The name of the file. */
  readonly file: string;
  readonly copying: ExportState['code'];
  /** The number of clips. */
  readonly clips: number;
  /** Whether pages can pose the handles: that needs no solver in the harmonic mode. */
  readonly posable: boolean;
}

export function webPageModel(state: EditorState): WebPageModel {
  const project = filedProject(state);
  const { handles, clips = [], pose } = project;
  const posable =
    pose?.mode === 'harmonic' && handles.length > 0 && handles.every(({ rotation }) => rotation !== 'auto');
  const name = state.picture?.name ?? '';
  const { code: copying } = state.exporting;
  return { code: playerCode(project, name), file: rigName(name), copying, clips: clips.length, posable };
}
