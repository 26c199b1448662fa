// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** A warp: a picture, the part of it to warp, and the handles. */
export interface Project {
  /** The version of the format. */
  readonly format: Format;
  /** The picture. */
  readonly image: ImageRef;
  /** The part of the picture to warp. The default is the opaque part of a picture with transparency, and all of any other. */
  readonly domain?: Domain;
  /** How the picture behind a domain of rings is filled. Without it, a part that moves away leaves a gap. Other domains have nothing behind them, and ignore it. */
  readonly fill?: Fill;
  /** Approximate number of samples, from 100 to 2,000,000. Left out: 10000. */
  readonly samples?: number;
  /** Settings of the weights. */
  readonly weighting?: Weighting;
  /** Settings of the pose. */
  readonly pose?: Pose;
  /** Whether the boundary of the domain stays in place. Left out: false. */
  readonly fix_boundary?: boolean;
  /** Whether parts of the picture cast a thin dark edge on the parts that they cross. Left out: false. */
  readonly edges?: boolean;
  /** How connected parts of the domain without a handle move. Left out: "stay". */
  readonly loose_parts?: LooseParts;
  /** The handles. Their order has no meaning. */
  readonly handles: readonly Handle[];
  /** Poses of handles over time. */
  readonly clips?: readonly Clip[];
  /** How stiff the picture is, as a grid over it: distortion counts more where it is stiff. It affects only rigid mode. The default is a picture without stiff places. */
  readonly stiffness?: Stiffness;
  /** How a brush has moved places of the picture at rest, before the handles pose them: a displacement field. The default is a picture that no brush has moved. */
  readonly displacement?: Displacement;
  /** The shape in which a drag has left the picture, as up to 64 samples: eight numbers for each. They are x and y at rest, x and y posed, and the linear part of the map there: its images of (1, 0) and (0, 1). In rigid mode, the same handles allow several shapes at rest, and the picture takes the one near the samples. The default is the shape that depends on the handles alone. */
  readonly shape?: readonly (readonly number[])[];
}

/** The version of the format. */
export type Format = 'c2warp/1';

/** The file of the picture, and the size in pixels that the project's coordinates refer to. */
export interface ImageRef {
  /** File name of the picture, relative to the project file. It may be empty. */
  readonly src: string;
  /** Width in pixels, at least 1. The solver accepts 2 to 16,384. */
  readonly width: number;
  /** Height in pixels, at least 1. The solver accepts 2 to 16,384. */
  readonly height: number;
}

/** The whole picture. */
export interface ImageDomain {
  readonly kind: 'image';
}

/** The part of the picture with enough opacity. */
export interface AlphaDomain {
  readonly kind: 'alpha';
  /** Minimum opacity of the domain, above 0 and up to 1. Left out: 0.5. */
  readonly threshold?: number;
}

/** The inside of closed rings by the even-odd rule: a ring inside a ring is a hole. The rest of the picture does not move. */
export interface PolygonDomain {
  readonly kind: 'polygon';
  /** One or more rings of at least three points `[x, y]`. */
  readonly rings: readonly (readonly Point[])[];
  /** Width of the soft rim around the rings, in pixels, from 0 to 64. Moving parts extend this far beyond their outline and fade out. At rest, nothing changes. Left out: 0. */
  readonly feather?: number;
}

/** The part of the picture to warp. */
export type Domain = ImageDomain | AlphaDomain | PolygonDomain;

/** A point `[x, y]` in image pixels, with pixel centres at +0.5 and y down. */
export type Point = readonly [number, number];

/** How the picture behind a domain of rings is filled where the bending part moves away. */
export interface Fill {
  /** The source of the colours. Left out: "patches". */
  readonly method?: FillMethod;
  /** Chooses one of many equally good results. The same seed always gives the same pixels. Left out: 0. */
  readonly seed?: number;
}

/** The source of the colours of a fill. */
export type FillMethod = 'patches';

/** The parameters of the weights. */
export interface Weighting {
  /** α, from 0 (smallest supports) to 1 (widest supports). Left out: 1. */
  readonly shape_factor?: number;
  /** Degree n of the Bézier polynomial φ, from 5 to 32. It is C² for degrees from 5. Left out: 5. */
  readonly degree?: number;
  /** Position of the inner control points of φ. They do not affect continuity. Left out: "line". */
  readonly filling?: Filling;
  /** Rule for the radius of a support. Left out: "paper". */
  readonly support?: Support;
  /** The region in which weights have two continuous derivatives. Left out: "exact". */
  readonly continuity?: Continuity;
}

/** Position of the inner control points of φ (section V-A). */
export type Filling = 'line' | 'half';

/** The rule for the radius of a support. */
export type Support = 'paper' | 'smooth';

/** The region in which weights have two continuous derivatives. */
export type Continuity = 'exact' | 'c2';

/** Settings of the pose. */
export interface Pose {
  /** How virtual sites derive their motions. Left out: "harmonic". */
  readonly mode?: PoseMode;
  /** How the motions at a point are blended. Left out: "linear". */
  readonly blend?: Blend;
  /** Least number of virtual sites, up to 4,096. With 0, Algorithm 1 determines the number. Left out: 0. */
  readonly density?: number;
}

/** How virtual sites derive their motions from handles. */
export type PoseMode = 'harmonic' | 'rigid';

/** How the motions at a point are blended. */
export type Blend = 'linear' | 'rigid';

/** How connected parts of the domain without a handle move. */
export type LooseParts = 'stay' | 'follow';

/** One point. */
export interface PointHandle {
  /** A name of 1 to 200 characters, unique in the project. */
  readonly id: string;
  /** Rotation about the handle itself, in degrees. The corners of a bar or polygon define its rotation up to whole turns: each piece takes the angle closest to this number. Left out: 0. */
  readonly rotation?: Rotation;
  /** Scale about the handle itself, above 0. A bar or polygon has this scale across its line, and its corners define the scale along it. In rigid mode, bars and points with automatic rotation take as much of it as their surroundings allow. Left out: 1. */
  readonly scale?: number;
  /** Drawing order where the picture overlaps itself: greater depths are in front. Left out: 0. */
  readonly depth?: number;
  /** Stiffness of the picture inside a polygon, from 0 to 1: distortion counts more where it is stiff. Other kinds have no stiffness. It only affects rigid mode. */
  readonly stiffness?: number;
  readonly kind: 'point';
  /** The point at rest. */
  readonly rest: Point;
  /** The posed point. The default is the point at rest. */
  readonly posed?: Point;
}

/** An open line through two or more points. */
export interface BarHandle {
  /** A name of 1 to 200 characters, unique in the project. */
  readonly id: string;
  /** Rotation about the handle itself, in degrees. The corners of a bar or polygon define its rotation up to whole turns: each piece takes the angle closest to this number. Left out: 0. */
  readonly rotation?: Rotation;
  /** Scale about the handle itself, above 0. A bar or polygon has this scale across its line, and its corners define the scale along it. In rigid mode, bars and points with automatic rotation take as much of it as their surroundings allow. Left out: 1. */
  readonly scale?: number;
  /** Drawing order where the picture overlaps itself: greater depths are in front. Left out: 0. */
  readonly depth?: number;
  /** Stiffness of the picture inside a polygon, from 0 to 1: distortion counts more where it is stiff. Other kinds have no stiffness. It only affects rigid mode. */
  readonly stiffness?: number;
  readonly kind: 'bar';
  /** The corners at rest. */
  readonly rest: readonly Point[];
  /** The posed corners. The default is the corners at rest. */
  readonly posed?: readonly Point[];
}

/** A closed ring of three or more points. */
export interface PolygonHandle {
  /** A name of 1 to 200 characters, unique in the project. */
  readonly id: string;
  /** Rotation about the handle itself, in degrees. The corners of a bar or polygon define its rotation up to whole turns: each piece takes the angle closest to this number. Left out: 0. */
  readonly rotation?: Rotation;
  /** Scale about the handle itself, above 0. A bar or polygon has this scale across its line, and its corners define the scale along it. In rigid mode, bars and points with automatic rotation take as much of it as their surroundings allow. Left out: 1. */
  readonly scale?: number;
  /** Drawing order where the picture overlaps itself: greater depths are in front. Left out: 0. */
  readonly depth?: number;
  /** Stiffness of the picture inside a polygon, from 0 to 1: distortion counts more where it is stiff. Other kinds have no stiffness. It only affects rigid mode. */
  readonly stiffness?: number;
  readonly kind: 'polygon';
  /** The corners at rest. */
  readonly rest: readonly Point[];
  /** The posed corners. The default is the corners at rest. */
  readonly posed?: readonly Point[];
}

/** A handle at rest and posed. */
export type Handle = PointHandle | BarHandle | PolygonHandle;

/** Degrees, clockwise on the screen, or automatic: fitted to the surrounding handles. */
export type Rotation = number | 'auto';

/** Poses of handles over time. */
export interface Clip {
  /** A name of 1 to 200 characters, unique in the project. */
  readonly name: string;
  /** Length in seconds, above 0 and up to 3,600. */
  readonly duration: number;
  /** What happens after the end. Left out: "repeat". */
  readonly loop?: Loop;
  /** The moving handles, each at most once. Other handles keep their pose. */
  readonly tracks: readonly Track[];
}

/** What happens after the end of a clip. */
export type Loop = 'repeat' | 'alternate' | 'none';

/** The keys of one handle in a clip. */
export interface Track {
  /** The id of the handle. */
  readonly handle: string;
  /** One or more keys, in ascending order of time. */
  readonly keys: readonly Key[];
}

/** The pose of a handle at one time. Values that are left out are interpolated past this key. */
export interface Key {
  /** Seconds from the beginning of the clip, up to its duration. */
  readonly time: number;
  /** The posed corners: one point for a point handle, all corners of a bar or polygon. */
  readonly posed?: Posed;
  /** The rotation. */
  readonly rotation?: Rotation;
  /** The scale, above 0. */
  readonly scale?: number;
  /** The depth. A whole number holds until another key. */
  readonly depth?: number;
  /** How values change to the next key. Left out: "smooth". */
  readonly ease?: Ease;
}

/** A posed point, or posed corners. */
export type Posed = Point | readonly Point[];

/** How values change from a key to the next one. */
export type Ease = 'smooth' | 'linear' | 'hold';

/** The stiffness of each point of the picture at rest: a grid of equal cells that covers the picture, regardless of its aspect ratio.  Between the centres of cells, values are bilinear; beyond the outermost centres, they are constant.  ``` use c2warp::project::{Project, Stiffness};  let mut project = Project::for_picture(640, 480); // The right half is stiff. project.stiffness = Some(Stiffness::new(4, 3, [0, 0, 255, 255].repeat(3))); assert!(project.to_json().contains(r#""stiffness": { "width": 4, "height": 3, "values": "AAD//wAA//8AAP//" }"#)); assert_eq!(Project::from_json(&project.to_json())?, project); # Ok::<(), c2warp::project::ProjectError>(()) ``` */
export interface Stiffness {
  /** Number of columns, from 1 to 128. */
  readonly width: number;
  /** Number of rows, from 1 to 128. */
  readonly height: number;
  /** A byte for each cell in base64, rows from top to bottom: 0 is as soft as without a mask, 255 is stiff. */
  readonly values: string;
}

/** The displacement of the picture at rest, applied before the handles pose it: a cubic B-spline over the picture.  A point p moves where the handles would move p + d(p), with the weights of p. Of `width` × `height` control points, one row and column lies beyond each edge of the picture. Beyond the picture, the displacement at its edge continues.  ``` use c2warp::project::{Displacement, Project};  let mut project = Project::for_picture(640, 480); // Everything moves by half a spacing to the right, and by a quarter up: a segment has 320 × 240 px. project.displacement = Some(Displacement::new(5, 5, [128, -64].repeat(25))); let displacement = project.displacement.as_ref().unwrap(); let moved = displacement.at([320.0, 90.0].into(), [640.0, 480.0].into()); assert!(moved.distance([160.0, -60.0].into()) < 1e-9); assert_eq!(Project::from_json(&project.to_json())?, project); # Ok::<(), c2warp::project::ProjectError>(()) ``` */
export interface Displacement {
  /** Number of columns of control points, from 4 to 259. They are the picture's width / (`width` − 3) apart. */
  readonly width: number;
  /** Number of rows of control points, from 4 to 259. They are the picture's height / (`height` − 3) apart. */
  readonly height: number;
  /** For each control point, rows from top to bottom, its displacement in x, then in y: 256 is the distance between columns, or rows. In base64: signed 16-bit integers, little-endian. */
  readonly values: string;
}
