/** Words about films. */
import { say, type Words } from '../texts/wording';

const PREFIXES = [
  [1e9, 'GB'],
  [1e6, 'MB'],
  [1e3, 'kB'],
] as const;

/** A rough size, with one digit that counts. */
export function roughSize(bytes: number): string {
  const [unit, name] = PREFIXES.find(([least]) => bytes >= least) ?? [1e3, 'kB'];
  const value = bytes / unit;
  return `${value >= 10 ? Math.round(value / 5) * 5 : Math.max(1, Math.round(value))} ${name}`;
}

const FEW_SECONDS = 5;

/** A rough time, as people say it. */
export function roughTime(seconds: number): Words {
  if (seconds < FEW_SECONDS) return say('film.aFewSeconds');
  if (seconds < 57.5) return `${Math.round(seconds / 5) * 5} s`;
  return `${Math.round(seconds / 60)} min`;
}

export const timeLeft = (seconds: number): Words =>
  seconds < FEW_SECONDS ? say('film.aFewSecondsLeft') : say('film.left', roughTime(seconds));
