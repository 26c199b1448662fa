/** Displacements for tests, as a brush leaves them. */
import { withField } from '../../web/src/document/displacement';
import type { Project } from '../../web/src/document/project';

/** A project whose picture is displaced by waves of so many pixels, without folds. */
export function waved(project: Project, most: number): Project {
  const { width, height } = project.image;
  const [columns, rows] = [15, 15];
  const spacing = [width / (columns - 3), height / (rows - 3)] as const;
  const values = Float64Array.from({ length: 2 * columns * rows }, (_, at) => {
    const [column, row] = [(at >> 1) % columns, Math.floor((at >> 1) / columns)];
    return most * (at % 2 === 0 ? Math.sin(row / 1.3 + column / 4) : Math.cos(column / 1.7));
  });
  return withField(project, { width: columns, height: rows, spacing, values });
}
