import { expect, it } from 'vitest';
import { nameOf } from '../../document/handle';
import type { PointHandle } from '../../document/project';
import { FakeRuntime } from '../fake_runtime';
import { projectOf } from '../state';

it('leaves a name that was not typed, whatever spaces it has', () => {
  const runtime = new FakeRuntime();
  runtime.open();
  const handle: PointHandle = { id: 'Left  hand\n', kind: 'point', rest: [100, 150], posed: [100, 150] };
  runtime.dispatch({ type: 'handle-added', handle });
  runtime.solve();
  const ids = () => projectOf(runtime.state).handles.map(({ id }) => id);
  const rename = (name: string) => {
    runtime.dispatch({ type: 'rename-asked', id: handle.id });
    runtime.dispatch({ type: 'name-given', name, keyed: false });
  };
  rename(nameOf(handle));
  expect(ids()).toEqual([handle.id]);
  rename(' Paw  1 ');
  expect(ids()).toEqual(['Paw 1']);
});
