/**
 * The style sheets of the editor, in cascade order. Shared styles come first, then the parts of the editor. Sheets that
 * change many parts come last: touch, posable pictures and forced colours.
 *
 * A sheet styles one part in every layout. It has the name of the part's template file, if there is one.
 */
import { baseStyle } from './base';
import { bendingStyle } from './bending';
import { brushStyle } from './brush';
import { buttonsStyle } from './buttons';
import { drawingStyle } from './drawing';
import { emptyStyle } from './empty';
import { exportMenuStyle } from './export_menu';
import { fieldsStyle } from './fields';
import { filesMenuStyle } from './files_menu';
import { floatingStyle } from './floating';
import { forcedStyle } from './forced';
import { handleListStyle } from './handle_list';
import { handlesStyle } from './handles';
import { hintsStyle } from './hints';
import { keysStyle } from './keys';
import { legendsStyle } from './legends';
import { marksStyle } from './marks';
import { menuStyle } from './menu';
import { noticeStyle } from './notice';
import { overlaysStyle } from './overlays';
import { panelStyle } from './panel';
import { posableStyle } from './posable';
import { progressStyle } from './progress';
import { segmentsStyle } from './segments';
import { shellStyle } from './shell';
import { stageStyle } from './stage';
import { statusStyle } from './status';
import { switchesStyle } from './switches';
import { tokensStyle } from './tokens';
import { toolStripStyle } from './tool_strip';
import { toolbarStyle } from './toolbar';
import { tooltipsStyle } from './tooltips';
import { touchStyle } from './touch';

export const editorStyle = [
  tokensStyle,
  baseStyle,
  buttonsStyle,
  tooltipsStyle,
  shellStyle,
  toolbarStyle,
  menuStyle,
  filesMenuStyle,
  keysStyle,
  toolStripStyle,
  panelStyle,
  fieldsStyle,
  bendingStyle,
  segmentsStyle,
  switchesStyle,
  handleListStyle,
  statusStyle,
  stageStyle,
  handlesStyle,
  marksStyle,
  overlaysStyle,
  emptyStyle,
  floatingStyle,
  hintsStyle,
  legendsStyle,
  brushStyle,
  drawingStyle,
  noticeStyle,
  progressStyle,
  exportMenuStyle,
  touchStyle,
  posableStyle,
  forcedStyle,
];
