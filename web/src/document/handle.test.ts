import { describe, expect, it } from 'vitest';
import { straightBar } from './fixtures';
import { checkedHandle } from './handle';
import { deepCopy, type Handle, posedHandle } from './project';

const head = { id: 'head', kind: 'point', rest: [3, 4], posed: [5, 6] } as const;
const refusal = (change: object) => () => checkedHandle({ ...head, ...change } as Handle);

describe('checkedHandle', () => {
  it('returns a valid handle', () => {
    expect(checkedHandle(head)).toBe(head);
    expect(checkedHandle(straightBar(10))).toEqual(straightBar(10));
    expect(checkedHandle({ ...head, rotation: 'auto', scale: 2, depth: -3 })).toBeTruthy();
  });

  it.each([
    [{ id: 5 }, 'handle "5", id: expected a name'],
    [{ id: '' }, 'id: expected a name'],
    [{ id: 'é'.repeat(201) }, 'id: expected a name of at most 200 characters'],
    [{ kind: 'circle' }, 'kind: expected "point", "bar" or "polygon"'],
    [{ kind: 'bar' }, 'rest: expected 2 points or more [x, y]'],
    [{ posed: undefined }, 'posed: expected a point [x, y]'],
    [{ posed: [1e300, 0] }, 'posed: expected a point [x, y]'],
    [{ rotation: '12' }, 'rotation: expected degrees or "auto"'],
    [{ scale: null }, 'scale: expected a number above 0'],
    [{ depth: 1e300 }, 'depth: expected a number'],
    [{ colour: 'red' }, 'colour: unknown key'],
  ])('rejects a handle with its id and the key: %o', (change, message) => {
    expect(refusal(change)).toThrow(RangeError);
    expect(refusal(change)).toThrow(message);
  });
});

describe('data from a page', () => {
  it('is at rest without a pose', () => {
    expect(posedHandle({ id: 'head', kind: 'point', rest: [3, 4] })).toMatchObject({ posed: [3, 4] });
  });

  it('is independent of its deep copy', () => {
    const given = { place: [1, 2] };
    const copy = deepCopy(given);
    given.place[0] = 7;
    expect(copy).toEqual({ place: [1, 2] });
  });
});
