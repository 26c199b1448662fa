/** The edited document: the project and the selection. */
import { DETAILS, withMode } from './bending';
import type { ProjectDefaults } from './defaults';
import { domainOf } from './domain';
import type { Handle, ImageRef, Project } from './project';

export interface Document {
  readonly project: Project;
  /** Ids of selected handles, in the order they were selected. */
  readonly selection: readonly string[];
  /** The time of a clip that poses the handles. */
  readonly moment?: Moment | null;
}

/** A time of a clip. */
export interface Moment {
  readonly clip: string;
  /** Seconds from the beginning of the clip. */
  readonly time: number;
  /** The project without the poses of the clip. */
  readonly base: Project;
}

export const openDocument = (project: Project): Document => ({ project, selection: [] });

/**
 * Returns a project without handles for a newly opened picture. The editor's defaults are explicit in it. The picture
 * bends rigidly, so that dragged parts keep their shape and distant parts stay. The boundary of an opaque picture is
 * held: its edges would leave gaps behind them.
 *
 * @param threshold the alpha threshold of a picture with transparency, `null` for an opaque picture.
 * @param defaults the page's settings, which go before these.
 */
export function newProject(
  image: ImageRef,
  threshold: number | null,
  defaults: ProjectDefaults = {},
): Project {
  const rigid: Project = {
    format: 'c2warp/1',
    image,
    domain: domainOf(threshold),
    samples: 10000,
    weighting: { shape_factor: 1, degree: 5, filling: 'line', support: 'smooth' },
    pose: { mode: 'rigid', blend: 'linear', density: DETAILS.medium },
    fix_boundary: threshold === null,
    edges: true,
    loose_parts: 'stay',
    handles: [],
  };
  const project = withMode(rigid, defaults.pose?.mode ?? 'rigid');
  return {
    ...project,
    ...defaults,
    weighting: { ...project.weighting, ...defaults.weighting },
    pose: { ...project.pose, ...defaults.pose },
  };
}

/** The project as its file holds it: without the poses of a clip. */
export const fileProject = ({ project, moment }: Document): Project => moment?.base ?? project;

export const isSameMoment = (
  a: Moment | null | undefined,
  b: Pick<Moment, 'clip' | 'time'> | null | undefined,
): boolean => a?.clip === b?.clip && a?.time === b?.time;

/** Whether two documents have equal projects. Neither the selection nor the time of a clip counts. */
export const isSameWork = (a: Document, b: Document): boolean =>
  isEqual(fileProject(a), fileProject(b)) &&
  (!a.moment || !isSameMoment(a.moment, b.moment) || isEqual(a.project, b.project));

const isEqual = (a: Project, b: Project): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);

export const handleById = (document: Document, id: string): Handle | undefined =>
  document.project.handles.find((handle) => handle.id === id);

export const selectedHandles = (document: Document): readonly Handle[] =>
  document.project.handles.filter((handle) => document.selection.includes(handle.id));
