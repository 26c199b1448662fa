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
  /** Whether readers may pose the handles; null without handles. */
  readonly posable: boolean | null;
  /** Whether that needs the solver: the harmonic mode does not. */
  readonly solver: boolean;
}

export function webPageModel(state: EditorState): WebPageModel {
  const project = filedProject(state);
  const { handles, clips = [], pose } = project;
  const solver = pose?.mode !== 'harmonic' || handles.some(({ rotation }) => rotation === 'auto');
  const name = state.picture?.name ?? '';
  const { code: copying, posable: chosen } = state.exporting;
  const posable = handles.length > 0 ? chosen : null;
  const code = playerCode(project, name, chosen);
  return { code, file: rigName(name), copying, clips: clips.length, posable, solver };
}
