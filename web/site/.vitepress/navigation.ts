/** The navigation of the site. */
import type { DefaultTheme } from 'vitepress';

type Link = { text: string; link: string; target?: string };

const STARTS: Link[] = [
  { text: 'A plain page', link: '/start/plain/' },
  { text: 'Vite', link: '/start/vite/' },
  { text: 'React', link: '/start/react/' },
  { text: 'Vue', link: '/start/vue/' },
  { text: 'Svelte', link: '/start/svelte/' },
  { text: 'Next', link: '/start/next/' },
  { text: 'Rust', link: '/start/rust/' },
  { text: 'Command line', link: '/start/command-line/' },
  { text: 'Player', link: '/start/player/' },
];

const EMBED: Link[] = [
  { text: 'Element', link: '/docs/element/' },
  { text: 'Player', link: '/docs/player/' },
  { text: 'Core', link: '/docs/core/' },
  { text: 'Rust', link: '/docs/rust/' },
  // No page of VitePress, so that its router leaves it alone.
  { text: 'Rust library', link: '/rustdoc/c2warp/index.html', target: '_self' },
  { text: 'Command line', link: '/docs/cli/' },
  { text: 'Languages', link: '/docs/languages/' },
  { text: 'Hosting', link: '/docs/hosting/' },
  { text: 'Versions', link: '/docs/versions/' },
];

const FORMATS: Link[] = [
  { text: 'Project file', link: '/project-file/' },
  { text: 'Clips', link: '/docs/clips/' },
  { text: 'Rig format', link: '/docs/rig-format/' },
  { text: 'Maps', link: '/docs/maps/' },
  { text: 'Vectors', link: '/docs/vectors/' },
  { text: 'Engines', link: '/docs/engines/' },
  { text: 'Pictures', link: '/docs/pictures/' },
];

const BACKGROUND: Link[] = [
  { text: 'The method explained', link: '/explained/' },
  { text: 'Method', link: '/docs/method/' },
  { text: 'Quality', link: '/docs/quality/' },
  { text: 'Limits', link: '/limits/' },
  { text: 'Accessibility', link: '/accessibility/' },
  { text: 'Architecture', link: '/docs/architecture/' },
];

export const NAVIGATION: Link[] = [
  { text: 'Start', link: '/start/plain/' },
  { text: 'Editor', link: '/docs/editor/' },
  { text: 'Reference', link: '/docs/element/' },
  { text: 'How it works', link: '/explained/' },
  { text: 'Playground', link: '/playground/' },
];

export const SIDEBAR: DefaultTheme.SidebarItem[] = [
  { text: 'Five minutes', items: STARTS },
  { text: 'Manual', items: [{ text: 'Editor', link: '/docs/editor/' }] },
  { text: 'Embedding', items: EMBED },
  { text: 'Formats', items: FORMATS },
  { text: 'Background', items: BACKGROUND },
];
