import { expect, it } from 'vitest';
import { Latest } from './latest';

it('answers one question at a time, and of those that wait the last one', async () => {
  let asked = 0;
  const answered: number[] = [];
  const gates: (() => void)[] = [];
  const latest = new Latest(
    async () => {
      const question = asked;
      await new Promise<void>((open) => gates.push(open));
      answered.push(question);
    },
    () => {},
  );
  for (asked = 1; asked <= 3; asked++) latest.ask();
  asked = 3;
  expect(gates).toHaveLength(1);
  gates[0]?.();
  await expect.poll(() => gates.length).toBe(2);
  gates[1]?.();
  await expect.poll(() => answered).toEqual([1, 3]);
  expect(gates).toHaveLength(2);
});

it('continues after a failure', async () => {
  const errors: unknown[] = [];
  let fails = true;
  let answers = 0;
  const latest = new Latest(
    async () => {
      if (fails) throw new Error('once');
      answers += 1;
    },
    (error) => errors.push(error),
  );
  latest.ask();
  await expect.poll(() => errors.length).toBe(1);
  fails = false;
  latest.ask();
  await expect.poll(() => answers).toBe(1);
});
