/** @jsxImportSource solid-js */
/** Templates of Solid. */
import type {} from 'c2warp/types/solid';

export const right = (
  <>
    <c2-warp
      src="cat.png"
      project={{ format: 'c2warp/1', image: { src: '', width: 2, height: 2 }, handles: [] }}
      tool="lasso"
      theme="dark"
      readonly
      posable={true}
      hint-for="head"
      selection={['head']}
      samples={[{ name: 'Cat', src: 'cat.png' }]}
      onselectionchange={({ detail }) => detail.selection.map((id) => id.length)}
      onerror={({ detail }) => detail.code === 'webgl'}
      onbeforesave={(event) => event.preventDefault()}
      id="editor"
      title="An editor"
      aria-label="An editor"
    />
    <c2-warp-player
      src="cat.c2rig"
      loop
      width={300}
      onended={({ type }) => type.length}
      onerror={({ message }) => message.length}
    />
    <c2-warp class="wide" ref={(warp) => warp.undo()} on:load={({ detail }) => detail.origin === 'page'} />
  </>
);

export const wrong = (
  <>
    {/* @ts-expect-error A boolean. */}
    <c2-warp readonly={3} />
    {/* @ts-expect-error There is no such tool. */}
    <c2-warp tool="pencil" />
    {/* @ts-expect-error There is no such theme. */}
    <c2-warp theme="blue" />
    {/* @ts-expect-error There is no such attribute. */}
    <c2-warp pictures="cat.png" />
    {/* @ts-expect-error A project has handles. */}
    <c2-warp project={{ format: 'c2warp/1' }} />
    {/* @ts-expect-error The ids are strings. */}
    <c2-warp onselectionchange={({ detail }) => detail.selection.map((id) => id.toFixed())} />
    {/* @ts-expect-error There is no such detail. */}
    <c2-warp ontoolchange={({ detail }) => detail.selection} />
    {/* @ts-expect-error A boolean. */}
    <c2-warp-player loop={3} />
    {/* @ts-expect-error There is no such origin. */}
    <c2-warp on:load={({ detail }) => detail.origin === 'nowhere'} />
  </>
);
