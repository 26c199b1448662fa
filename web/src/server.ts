/** Replaces the element during server-side rendering, which has no DOM to draw on. */
export class C2Warp {}
