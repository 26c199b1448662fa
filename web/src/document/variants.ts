/** One project by three methods, to be compared: the same handles in the same pose. */
import { modeOf, withMode } from './bending';
import type { Project } from './project';

export const VARIANTS = ['paper', 'rigid', 'plain'] as const;
export type Variant = (typeof VARIANTS)[number];

/**
 * - `paper`: harmonic fields, and distances inside the shape.
 * - `rigid`: as rigid as possible.
 * - `plain`: as the paper, with straight distances. Without gaps in the shape, they are the same.
 */
export function variantOf(project: Project, variant: Variant): Project {
  if (variant === 'rigid') return modeOf(project) === 'rigid' ? project : withMode(project, 'rigid');
  const paper = modeOf(project) === 'harmonic' ? project : withMode(project, 'harmonic');
  return variant === 'paper' ? paper : { ...paper, domain: { kind: 'image' } };
}

/** Something for each variant. */
export const byVariant = <T>(make: (variant: Variant) => T): Readonly<Record<Variant, T>> => ({
  paper: make('paper'),
  rigid: make('rigid'),
  plain: make('plain'),
});
