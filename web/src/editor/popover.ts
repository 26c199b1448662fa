/** Panels of the toolbar that show something only while they are open. */
export type Popover = 'files' | 'export';
