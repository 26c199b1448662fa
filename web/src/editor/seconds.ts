/** Seconds with two digits after the point. */
export const secondsText = (seconds: number): string => `${seconds.toFixed(2)} s`;
