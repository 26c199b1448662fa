import { describe, expect, it } from 'vitest';
import { newProject } from './document';
import { projectText } from './project_text';

describe('projectText', () => {
  it('writes one line per handle', () => {
    const project = {
      ...newProject({ src: 'a "b".png', width: 2, height: 3 }, 0.5),
      handles: [
        { id: 'a', kind: 'point' as const, rest: [1, 2] as const, posed: [1.5, 2] as const, rotation: 15 },
        {
          id: 'b',
          kind: 'bar' as const,
          rest: [
            [0, 0],
            [1, 1],
          ] as const,
          posed: [
            [0, 0],
            [1, 2],
          ] as const,
        },
      ],
    };
    const text = projectText(project);
    expect(JSON.parse(text)).toEqual(project);
    expect(text).toContain(
      '\n    {"id": "a", "kind": "point", "rest": [1, 2], "posed": [1.5, 2], "rotation": 15},\n',
    );
  });

  it('writes one line per key of a clip', () => {
    const keys = [
      { time: 0, posed: [1, 2] as const },
      { time: 0.5, rotation: 90, ease: 'linear' as const },
    ];
    const project = {
      ...newProject({ src: 'a.png', width: 2, height: 3 }, 0.5),
      clips: [
        { name: 'wave', duration: 1, tracks: [{ handle: 'a', keys }] },
        { name: 'still', duration: 2, tracks: [] },
      ],
    };
    const text = projectText(project);
    expect(JSON.parse(text)).toEqual(project);
    expect(text.slice(text.indexOf('  "clips"'))).toBe(`  "clips": [
    {"name": "wave", "duration": 1, "tracks": [
        {"handle": "a", "keys": [
            {"time": 0, "posed": [1, 2]},
            {"time": 0.5, "rotation": 90, "ease": "linear"}
          ]}
      ]},
    {"name": "still", "duration": 2, "tracks": []}
  ]
}
`);
  });

  it('writes an empty list of handles', () => {
    expect(projectText(newProject({ src: '', width: 2, height: 3 }, null))).toContain('"handles": []\n}\n');
  });
});
