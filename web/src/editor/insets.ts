/**
 * Room for the cards over the stage, in the layouts of `ui/style/layouts.ts`, which measure the stage with its bars.
 */
import type { Insets, Size } from '../geometry/camera';
import {
  BARS,
  FROM_BOTTOM,
  LOW,
  LOWEST,
  NARROW,
  OVER_TIMELINE,
  PANEL,
  PHONE,
  SHEET,
  STUDY,
  TIMELINE,
  TOOLS,
} from './sizes';
import type { StudyPage } from './study_state';
import type { Sheet } from './view_state';

/** The layout that the insets depend on. */
export interface Cards {
  /** CSS pixels. */
  readonly stage: Size;
  /** Bars and buttons are sized for fingers. */
  readonly coarse: boolean;
  /** The panel, if the layout shows it as a sheet. */
  readonly sheet: Sheet;
  /** The study card is open instead of the panel. */
  readonly study?: StudyPage | null;
  /** The timeline is open, below the stage. */
  readonly timeline?: boolean;
  /** What `posable` shows without bars and cards; null in the editor. */
  readonly bare: 'handles' | 'picture' | null;
}

/** Room for a whole handle at the rim of a bare picture, and for its hit area, CSS pixels. */
const RIM = { fine: 16, coarse: 24 } as const;

const even = (by: number): Insets => ({ top: by, right: by, bottom: by, left: by });

/** Room for the study card. A comparison takes half of the stage. */
const studyWidth = (page: StudyPage, stage: number): number =>
  page === 'compare' ? Math.max(STUDY.wide, stage / 2) : STUDY.wide;

/** The height of the editor, by that of its stage and bars. */
function wholeHeight(above: number, timeline: boolean, kind: keyof typeof RIM): number {
  if (!timeline) return above;
  const most = kind === 'coarse' ? TIMELINE.coarse : TIMELINE.height;
  const share = TIMELINE.share / 100;
  const shared = above / (1 - share);
  return share * shared <= most ? shared : above + most;
}

export function insetsOf({
  stage: { width, height },
  coarse,
  sheet,
  study,
  timeline = false,
  bare,
}: Cards): Insets {
  const right = (panel: number) => (study ? studyWidth(study, width) : panel);
  const kind = coarse ? 'coarse' : 'fine';
  if (bare) return even(bare === 'picture' ? 0 : RIM[kind]);
  const { toolbar, status } = BARS[kind];
  const whole = wholeHeight(toolbar + height + status, timeline, kind);
  const tools = whole < LOWEST ? 'lowest' : 'low';
  if (width < PHONE) {
    const settings = Math.min(SHEET.tall, (SHEET.share / 100) * height);
    if (whole < LOW.phone) {
      // Too low for room beside one line: the sheet may cover the picture.
      const bottom = sheet === 'tall' ? 8 + settings : 8;
      return { ...even(8), bottom, left: TOOLS[`${tools}Phone`][kind] };
    }
    if (study) return { ...even(16), bottom: FROM_BOTTOM.sheet + STUDY.share * height };
    const [line, tall] = [FROM_BOTTOM.sheet + SHEET.line, FROM_BOTTOM.sheet + settings];
    return { ...even(16), bottom: { none: FROM_BOTTOM.aboveTools, line, tall }[sheet] };
  }
  if (whole < LOW.wide && !timeline)
    return { ...even(16), left: TOOLS[tools][kind], right: right(PANEL.narrow) };
  if (timeline && whole < OVER_TIMELINE.low) {
    const columns = whole < OVER_TIMELINE.lowest ? 'lowest' : 'low';
    const left = TOOLS[columns][kind];
    return { ...even(16), left, right: right(width < NARROW ? PANEL.narrow : PANEL.wide) };
  }
  if (width < NARROW) return { ...even(20), left: TOOLS.narrow, right: right(PANEL.narrow) };
  return { ...even(28), left: TOOLS.wide, right: right(PANEL.wide) };
}
