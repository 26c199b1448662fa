/** Replaces the element on a server that renders pages: without a DOM there is nothing to draw. */
export class C2Warp {}
