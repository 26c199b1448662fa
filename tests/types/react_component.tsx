/** @jsxImportSource react */
/** The component for React. */
import { C2Warp, type C2WarpElement, type C2WarpProps } from 'c2warp/react';
import { createRef, useCallback, useState } from 'react';

const warp = createRef<C2WarpElement>();

export const right = (
  <C2Warp
    ref={warp}
    key="1"
    src="cat.png"
    project={null}
    tool="lasso"
    readonly
    hintFor="head"
    className="wide"
    style={{ height: 300 }}
    onChange={({ detail }) => detail.project.handles.length}
    onSelectionChange={({ detail }) => detail.selection.map((id) => id.length)}
    onTimeUpdate={({ type }) => type.length}
    onBeforeSave={(event) => event.preventDefault()}
    onError={({ detail }) => detail.code === 'webgl'}
    onClick={({ currentTarget }) => currentTarget.undo()}
  >
    <img src="cat.png" alt="A cat" />
  </C2Warp>
);

export function Host(props: C2WarpProps) {
  const [selection, setSelection] = useState<readonly string[]>([]);
  const changed = useCallback<NonNullable<C2WarpProps['onSelectionChange']>>(
    ({ detail }) => setSelection(detail.selection),
    [],
  );
  return <C2Warp {...props} selection={selection} onSelectionChange={changed} />;
}

export const wrong = (
  <>
    {/* @ts-expect-error A boolean. */}
    <C2Warp readonly={3} />
    {/* @ts-expect-error There is no such tool. */}
    <C2Warp tool="pencil" />
    {/* @ts-expect-error There is no such property. */}
    <C2Warp pictures="cat.png" />
    {/* @ts-expect-error The ids are strings. */}
    <C2Warp onSelectionChange={({ detail }) => detail.selection.map((id) => id.toFixed())} />
    {/* @ts-expect-error There is no such listener. */}
    <C2Warp onPictureChange={() => {}} />
  </>
);
