/** The layouts of the editor: conditions on the size of `.shell`, for container queries. */

import { LOW, LOW_HINTS, LOWEST, NARROW, PHONE } from '../../editor/sizes';
import { css } from './css';

/** No room for labels on buttons. */
export const narrow = css`shell (width < ${NARROW}px)`;
/** Tools side by side, in two columns or four. */
export const low = css`shell (width >= ${PHONE}px) and (height < ${LOW.wide}px)`;
export const lowest = css`shell (width >= ${PHONE}px) and (height < ${LOWEST}px)`;
/** Cards at both sides. */
export const notPhone = css`shell (width >= ${PHONE}px)`;
/** Phones: tools at the bottom within the thumb's reach, and the panel as a sheet above them. */
export const phone = css`shell (width < ${PHONE}px)`;
/** Upright phones: tools in one row. */
export const uprightPhone = css`shell (width < ${PHONE}px) and (height >= ${LOW.phone}px)`;
/** Phones held sideways: tools at the left in columns, and the sheet beside them. */
export const lowPhone = css`shell (width < ${PHONE}px) and (height < ${LOW.phone}px)`;
export const lowestPhone = css`shell (width < ${PHONE}px) and (height < ${LOWEST}px)`;
/** The strip of a phone that an on-screen keyboard leaves. */
export const strip = css`shell (width < ${PHONE}px) and (height < ${LOW_HINTS}px)`;
/** No room for long hints. */
export const lowHints = css`shell (height < ${LOW_HINTS}px)`;
