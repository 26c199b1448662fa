import { expect, it } from 'vitest';
import { projectText } from './project_text';

it('a project has its points on one line each', () => {
  const text = projectText({
    id: 'a',
    rest: [1, -2.5],
    posed: [
      [3, 4],
      [5e-7, 6],
    ],
  });
  expect(text.split('\n')).toEqual([
    '{',
    '  "id": "a",',
    '  "rest": [1, -2.5],',
    '  "posed": [',
    '    [3, 4],',
    '    [5e-7, 6]',
    '  ]',
    '}',
  ]);
});
