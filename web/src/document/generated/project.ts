// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** A warp: a picture, the part of it that bends, and the handles that bend it. */
export interface Project {
  /** The version of the format. */
  readonly format: Format;
  /** The picture. */
  readonly image: ImageRef;
  /** The part of the picture that bends; left out: where the picture is opaque if it has transparency, else all of it. */
  readonly domain?: Domain;
  /** How many samples the domain gets, about: from 100 to 2,000,000. Left out: 10000. */
  readonly samples?: number;
  /** How far a handle reaches and how its weight falls off. */
  readonly weighting?: Weighting;
  /** How a pose is made from the handles. */
  readonly pose?: Pose;
  /** Whether the rim of the picture stays where it is. Left out: false. */
  readonly fix_boundary?: boolean;
  /** The handles; the order has no meaning. */
  readonly handles: readonly Handle[];
}

/** The version of the format. */
export type Format = 'c2warp/1';

/** Where the picture is found, and the size that the project's coordinates mean. */
export interface ImageRef {
  /** The picture's file name, beside the project file; may be empty for a picture that has none. */
  readonly src: string;
  /** Width in pixels, 1 or more; the solver takes 2 to 16,384. */
  readonly width: number;
  /** Height in pixels, likewise. */
  readonly height: number;
}

/** The whole rectangle. */
export interface ImageDomain {
  readonly kind: 'image';
}

/** Where the picture is opaque enough. */
export interface AlphaDomain {
  readonly kind: 'alpha';
  /** The least opacity that belongs to the domain, above 0 and up to 1. Left out: 0.5. */
  readonly threshold?: number;
}

/** The inside of closed rings by the even-odd rule, so that a ring inside a ring is a hole. What lies around stays. */
export interface PolygonDomain {
  readonly kind: 'polygon';
  /** One or more rings of at least three points `[x, y]`. */
  readonly rings: readonly (readonly Point[])[];
}

/** How the domain is found in the picture. */
export type Domain = ImageDomain | AlphaDomain | PolygonDomain;

/** A place `[x, y]` in image pixels, pixel centres at +0.5, y down. */
export type Point = readonly [number, number];

/** The parameters of the weights. */
export interface Weighting {
  /** α, from 0 (supports as small as they may be) to 1 (as wide as they may be). Left out: 1. */
  readonly shape_factor?: number;
  /** The degree n of the Bézier polynomial φ: from 5, the least that is C², to 32. Left out: 5. */
  readonly degree?: number;
  /** Where the control points of φ lie that continuity leaves free. Left out: "line". */
  readonly filling?: Filling;
  /** What a support must keep clear of. Left out: "paper". */
  readonly support?: Support;
}

/** The two ways of section V-A to place the inner control points of φ. */
export type Filling = 'line' | 'half';

/** The rule for the radius of a support. */
export type Support = 'paper' | 'smooth';

/** How a pose is made from the handles. */
export interface Pose {
  /** Where virtual sites get their motions from. Left out: "harmonic". */
  readonly mode?: PoseMode;
  /** How the motions that reach a point are blended. Left out: "linear". */
  readonly blend?: Blend;
  /** The least number of virtual sites to insert, up to 4,096; 0 leaves it to Algorithm 1. Left out: 0. */
  readonly density?: number;
}

/** Where virtual sites get their motions from. */
export type PoseMode = 'harmonic' | 'rigid';

/** How the motions that reach a point are blended. */
export type Blend = 'linear' | 'rigid';

/** One point. */
export interface PointHandle {
  /** A name that no other handle of the project has. */
  readonly id: string;
  /** The turn about the handle's own place, in degrees. The corners of a bar or polygon tell how far it is turned; the number then tells of the whole turns: each piece is turned by the angle nearest to it. Left out: 0. */
  readonly rotation?: Rotation;
  /** The growth about the handle's own place, above 0. Of a bar or polygon the growth across its line; along it, the corners tell. In the rigid mode a point whose rotation is automatic, and a bar, grow by as much of it as what is around them allows. Left out: 1. */
  readonly scale?: number;
  /** What lies over what where the picture covers itself: more is nearer. Left out: 0. */
  readonly depth?: number;
  readonly kind: 'point';
  /** Before. */
  readonly rest: Point;
  /** After; left out: as before. */
  readonly posed?: Point;
}

/** An open line through two or more points. */
export interface BarHandle {
  /** A name that no other handle of the project has. */
  readonly id: string;
  /** The turn about the handle's own place, in degrees. The corners of a bar or polygon tell how far it is turned; the number then tells of the whole turns: each piece is turned by the angle nearest to it. Left out: 0. */
  readonly rotation?: Rotation;
  /** The growth about the handle's own place, above 0. Of a bar or polygon the growth across its line; along it, the corners tell. In the rigid mode a point whose rotation is automatic, and a bar, grow by as much of it as what is around them allows. Left out: 1. */
  readonly scale?: number;
  /** What lies over what where the picture covers itself: more is nearer. Left out: 0. */
  readonly depth?: number;
  readonly kind: 'bar';
  /** Before. */
  readonly rest: readonly Point[];
  /** After; left out: as before. */
  readonly posed?: readonly Point[];
}

/** A closed ring of three or more points. */
export interface PolygonHandle {
  /** A name that no other handle of the project has. */
  readonly id: string;
  /** The turn about the handle's own place, in degrees. The corners of a bar or polygon tell how far it is turned; the number then tells of the whole turns: each piece is turned by the angle nearest to it. Left out: 0. */
  readonly rotation?: Rotation;
  /** The growth about the handle's own place, above 0. Of a bar or polygon the growth across its line; along it, the corners tell. In the rigid mode a point whose rotation is automatic, and a bar, grow by as much of it as what is around them allows. Left out: 1. */
  readonly scale?: number;
  /** What lies over what where the picture covers itself: more is nearer. Left out: 0. */
  readonly depth?: number;
  readonly kind: 'polygon';
  /** Before. */
  readonly rest: readonly Point[];
  /** After; left out: as before. */
  readonly posed?: readonly Point[];
}

/** A handle, where it rests and where it was taken. */
export type Handle = PointHandle | BarHandle | PolygonHandle;

/** Degrees, clockwise on the screen, or as much as suits the handles around. */
export type Rotation = number | 'auto';
