/** Fingers on the screen. */
import type { CDPSession } from '@playwright/test';
import type { Position } from './editor';

/** Puts fingers on places, or moves them there. */
export async function send(
  session: CDPSession,
  type: 'Start' | 'Move' | 'End',
  places: readonly Position[] = [],
): Promise<void> {
  const touchPoints = places.map((at, id) => ({ ...at, id }));
  await session.send('Input.dispatchTouchEvent', { type: `touch${type}`, touchPoints });
}

/**
 * Lets the fingers rest, and lifts them. After a quick move the browser would see a fling: it would scroll on, and
 * ignore the next tap for a third of a second.
 */
export async function lift(session: CDPSession): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, 200));
  await send(session, 'End');
}

/** Sends touches, one step per list of places, and lifts the fingers. */
export async function touch(session: CDPSession, steps: readonly (readonly Position[])[]): Promise<void> {
  for (const [index, places] of steps.entries()) {
    await send(session, index === 0 ? 'Start' : 'Move', places);
  }
  await lift(session);
}
