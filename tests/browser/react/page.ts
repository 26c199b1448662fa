/** A page with React and the component. Tests render by these, since a strict page runs no other script. */
import { createElement, createRef, StrictMode } from 'react';
import { createRoot, hydrateRoot } from 'react-dom/client';
import { C2Warp } from '../../../web/src/react';

const page = { C2Warp, createElement, createRef, createRoot, hydrateRoot, StrictMode };

export type ReactPage = typeof page;

Object.assign(globalThis, { page });
