/** Closes the menu or panel around the control of an event. */
export const closePopover = ({ currentTarget }: Event): void =>
  (currentTarget as Element).closest<HTMLElement>('[popover]')?.hidePopover();
