/** A clip in which the sample raises its right hand. @param duration in seconds, above 0.25. */
export const wave = (duration: number) => ({
  name: 'wave',
  duration,
  loop: 'repeat',
  tracks: [
    {
      handle: 'right-hand',
      keys: [
        { time: 0, posed: [900, 516] },
        { time: 0.25, posed: [860, 330] },
      ],
    },
  ],
});
