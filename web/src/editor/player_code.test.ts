import { describe, expect, it } from 'vitest';
import { newProject } from '../document/document';
import { playerCode } from './player_code';

const project = { ...newProject({ src: '', width: 40, height: 30 }, null), clips: [] };
const clip = (loop: 'none' | 'repeat') => ({ name: 'wave', duration: 1, loop, tracks: [] });

describe('the code of a player', () => {
  it('is two lines with the file, its size and its name', () => {
    expect(playerCode(project, 'my-cat.png', false)).toBe(
      `<script type="module" src="player/c2warp-player.js"></script>
<c2-warp-player src="my-cat.c2rig" width="40" height="30" alt="my cat"></c2-warp-player>
`,
    );
  });

  it('plays a clip, and again and again if it loops', () => {
    expect(playerCode({ ...project, clips: [clip('none')] }, 'a.png', false)).toContain(
      'alt="a" autoplay></c2-warp',
    );
    expect(playerCode({ ...project, clips: [clip('repeat')] }, 'a.png', false)).toContain(
      ' autoplay loop></c2-warp',
    );
  });

  it('lets readers pose handles, if there are any', () => {
    const handles = [{ id: 'a', kind: 'point', rest: [1, 2], posed: [1, 2] } as const];
    expect(playerCode({ ...project, handles }, 'a.png', true)).toContain('alt="a" posable></c2-warp');
    expect(playerCode(project, 'a.png', true)).not.toContain('posable');
  });

  it('takes any file name', () => {
    const code = playerCode(project, 'a "b" & <c>.png', false);
    expect(code).toContain('src="a%20%22b%22%20%26%20%3Cc%3E.c2rig"');
    expect(code).toContain('alt="a &quot;b&quot; &amp; &lt;c>"');
  });
});
