/**
 * The displacements of a history, in the stored form: each as its differences from the one before it.
 *
 * A displacement is a long text, and a stroke changes little of it. Five hundred strokes would be stored as 35 MB with
 * every change of the work.
 */
import type { Document } from '../document/document';
import type { HistoryRecord, Step } from '../document/history';
import type { Displacement, Project } from '../document/project';
import type { Work } from './work';

/** Where a text differs from another of its length, from left to right. */
type Runs = readonly (readonly [at: number, text: string])[];

/** A displacement by its differences from the one before. */
interface Packed {
  readonly runs: Runs;
}

type Stored = Displacement | Packed;

/** Equal characters between two differences that are stored as one. */
const GAP = 24;

/** The work with each displacement but the first as differences. The present comes first, then the past, backwards. */
export const packed = <W extends Work>(work: W): W =>
  changed(work, (displacement, before) =>
    before ? packedAfter(before, displacement as Displacement) : displacement,
  );

/** The work of {@link packed}. */
export const unpacked = <W extends Work>(work: W): W =>
  changed(work, (stored, before) =>
    'runs' in stored && before ? { ...before, values: patched(before.values, stored.runs) } : stored,
  );

/** The differences from a displacement that was packed after another. Both are values. */
const known = new WeakMap<Displacement, { readonly before: Displacement; readonly packed: Packed }>();

function packedAfter(before: Displacement, displacement: Displacement): Stored {
  const { width, height, values } = displacement;
  if (before.width !== width || before.height !== height) return displacement;
  const last = known.get(displacement);
  if (last?.before === before) return last.packed;
  const packed = { runs: runsOf(before.values, values) };
  known.set(displacement, { before, packed });
  return packed;
}

/** The differences of a text from another of its length. */
export function runsOf(before: string, after: string): Runs {
  const runs: [number, string][] = [];
  let [start, end] = [-1, -1];
  for (let at = 0; at < after.length; at++) {
    if (before.charCodeAt(at) === after.charCodeAt(at)) continue;
    if (start >= 0 && at - end > GAP) runs.push([start, after.slice(start, end)]);
    if (start < 0 || at - end > GAP) start = at;
    end = at + 1;
  }
  if (start >= 0) runs.push([start, after.slice(start, end)]);
  return runs;
}

/** The text that differs so from another. */
export function patched(before: string, runs: Runs): string {
  let [text, from] = ['', 0];
  for (const [at, run] of runs) {
    text += before.slice(from, at) + run;
    from = at + run.length;
  }
  return text + before.slice(from);
}

/**
 * Changes each displacement of a work once. The same objects stay the same: a saved project may be one of the history.
 *
 * @param change takes a displacement, and the last one before it, as an object in memory.
 */
function changed<W extends Work>(
  work: W,
  change: (displacement: Stored, before: Displacement | null) => Stored,
): W {
  const displacements = new Map<Stored, Stored>();
  const projects = new Map<Project, Project>();
  let before: Displacement | null = null;

  const ofProject = (project: Project): Project => {
    const stored: Stored | undefined = project.displacement;
    if (!stored) return project;
    const displacement = displacements.get(stored) ?? change(stored, before);
    displacements.set(stored, displacement);
    // One of both is as in memory.
    before = 'values' in stored ? stored : 'values' in displacement ? displacement : before;
    const done = projects.get(project) ?? { ...project, displacement: displacement as Displacement };
    projects.set(project, done);
    return done;
  };
  const ofDocument = (document: Document): Document => ({
    ...document,
    project: ofProject(document.project),
    ...(document.moment && { moment: { ...document.moment, base: ofProject(document.moment.base) } }),
  });
  const ofSteps = (steps: readonly Step<Document>[]): readonly Step<Document>[] =>
    [...steps]
      .reverse()
      .map(({ label, value }) => ({ label, value: ofDocument(value) }))
      .reverse();

  const present = ofDocument(work.record.present);
  const record: HistoryRecord<Document> = {
    present,
    past: ofSteps(work.record.past),
    future: ofSteps(work.record.future),
  };
  return { ...work, record, ...(work.saved && { saved: ofProject(work.saved) }) };
}
