/** The events of `<c2-warp-player>`: those of `<video>`, and of a control that readers pose. */
export interface C2WarpPlayerEventMap {
  /** The rig is loaded. */
  readonly loadeddata: Event;
  /** The clip starts to play. */
  readonly play: Event;
  /** The clip pauses, also at its end. */
  readonly pause: Event;
  /** `currentTime` has changed. Fires four times a second while the clip plays. */
  readonly timeupdate: Event;
  /** `playbackRate` has been set. */
  readonly ratechange: Event;
  /** The clip has played to its end. */
  readonly ended: Event;
  /** The rig, the clip or a pose cannot be shown. `error` is a `C2WarpError`, `message` a sentence for people. */
  readonly error: ErrorEvent;
  /** With `posable`: a reader poses a handle. @bubbles */
  readonly input: Event;
  /** With `posable`: a reader has posed a handle. @bubbles */
  readonly change: Event;
}
