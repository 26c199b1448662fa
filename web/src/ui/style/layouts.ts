/** The layouts of the editor: conditions on the size of `.shell`, for container queries. */
import { css } from 'lit';
import { LOW, LOWEST, NARROW, PHONE } from './sizes';

/** No room for words on buttons. */
export const narrow = css`shell (width < ${NARROW}px)`;
/** Tools side by side, in two columns or three. */
export const low = css`shell (width >= ${PHONE}px) and (height < ${LOW.wide}px)`;
export const lowest = css`shell (width >= ${PHONE}px) and (height < ${LOWEST}px)`;
/** Cards at both sides. */
export const notPhone = css`shell (width >= ${PHONE}px)`;
/** Tools within the thumb's reach, and the panel a sheet above them. */
export const phone = css`shell (width < ${PHONE}px)`;
/** A phone held upright: tools side by side in one row. */
export const uprightPhone = css`shell (width < ${PHONE}px) and (height >= ${LOW.phone}px)`;
/** A phone held sideways: tools at the left, as much side by side as it asks for, and the sheet beside them. */
export const lowPhone = css`shell (width < ${PHONE}px) and (height < ${LOW.phone}px)`;
export const lowestPhone = css`shell (width < ${PHONE}px) and (height < ${LOWEST}px)`;
/** A keyboard on the glass leaves a strip of a phone. */
export const strip = css`shell (width < ${PHONE}px) and (height < 460px)`;
