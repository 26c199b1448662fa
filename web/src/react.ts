/**
 * `c2warp/react`: `<c2-warp>` as a component of React 18 and later.
 *
 * React 18 only sets attributes, and no version of React maps `onSelectionChange` to an event such as
 * `selectionchange`. So effects set properties and add listeners. They run before the element first updates, and never
 * on a server. The types of the component are generated from the manifest, like the tables.
 */
import { EVENTS, PROPERTIES } from 'virtual:c2warp-react';
import {
  createElement,
  forwardRef,
  type HTMLAttributes,
  useEffect,
  useImperativeHandle,
  useLayoutEffect,
  useRef,
} from 'react';
import type { C2Warp as C2WarpElement } from './element';

type Props = Readonly<Record<string, unknown>>;

/** On servers, React 18 warns of layout effects. */
const useSetting = typeof document === 'undefined' ? useEffect : useLayoutEffect;

export const C2Warp = forwardRef<C2WarpElement, Props>(function C2Warp(props, ref) {
  const host = useRef<C2WarpElement>(null);
  const current = useRef(props);
  const shown = useRef<Props>({});
  useImperativeHandle(ref, () => host.current as C2WarpElement, []);
  useSetting(() => {
    const ended = new AbortController();
    for (const [listener, type] of Object.entries(EVENTS)) {
      const heard = (event: Event) => (current.current[listener] as EventListener | undefined)?.(event);
      host.current?.addEventListener(type, heard, { signal: ended.signal });
    }
    return () => ended.abort();
  }, []);
  useSetting(() => {
    current.current = props;
    for (const name of PROPERTIES) {
      // A property that is left out belongs to the element and its reader.
      if (Object.is(props[name], shown.current[name])) continue;
      Reflect.set(host.current as C2WarpElement, name, props[name] ?? null);
    }
    shown.current = props;
  });
  return createElement('c2-warp', { ...others(props), ref: host } as HTMLAttributes<C2WarpElement>);
});

/** Properties of any element. React 18 does not support `className` on custom elements. */
function others(props: Props): Props {
  const given = Object.entries(props).filter(([name]) => !(PROPERTIES.includes(name) || name in EVENTS));
  return Object.fromEntries(given.map(([name, value]) => [name === 'className' ? 'class' : name, value]));
}
