/** A project as text for people: indented, with each point on one line. */

const NUMBERS = /\[\s+(-?[\d.e+-]+(?:,\s+-?[\d.e+-]+)*)\s+\]/g;

export const projectText = (project: unknown): string =>
  JSON.stringify(project, null, 2).replaceAll(
    NUMBERS,
    (_, inside: string) => `[${inside.replaceAll(/\s+/g, ' ')}]`,
  );
