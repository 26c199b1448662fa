/** What a server that renders pages imports in place of the element: there is no DOM for it, and nothing to draw. */
export class C2Warp {}
