import { expect, it } from 'vitest';
import { de } from './de';
import { en } from './en';
import { es } from './es';
import { fr } from './fr';
import { ja } from './ja';
import type { Texts } from './texts';
import { zh } from './zh';

const SHIPPED: Readonly<Record<string, Texts>> = { de, es, fr, ja, zh };

/** Signs and keys that are the same everywhere. */
const EVERYWHERE = ['keys.presses.alt', 'keys.presses.tab', 'panel.x', 'panel.y'];

/** Words that a language shares with English. */
const SHARED: Readonly<Record<string, readonly string[]>> = {
  de: [
    'keys.names.escape',
    'toolbar.export',
    'tools.polygon',
    'tools.lasso',
    'panel.auto',
    'overlays.title',
    'stage.original',
    'status.label',
    'status.zoom',
    'exporting.kinds.film',
    'exporting.kinds.engine',
    'exporting.format',
    'exporting.original',
    'film.clip',
    'film.frames',
    'film.transparent',
    'webPage.code',
    'engine.zip',
    'engine.pose',
    'timeline.clips',
    'timeline.clip',
    'timeline.eases.linear',
    'rounds.pause',
    'settings.linear',
  ],
  es: [
    'keys.names.ctrl',
    'keys.names.escape',
    'keys.effects.zoom',
    'panel.auto',
    'bending.pixelArt',
    'stage.original',
    'status.zoom',
    'exporting.original',
    'film.clip',
    'engine.zip',
    'engine.pose',
    'timeline.clips',
    'timeline.clip',
    'page.samples.cactus',
    'page.samples.robot',
  ],
  fr: [
    'keys.names.ctrl',
    'keys.groups.document',
    'toolbar.label',
    'tools.point',
    'tools.lasso',
    'panel.turn',
    'panel.auto',
    'bending.pixelArt',
    'stage.original',
    'status.zoom',
    'exporting.kind',
    'exporting.kinds.film',
    'exporting.format',
    'exporting.original',
    'film.clip',
    'film.transparent',
    'webPage.code',
    'engine.zip',
    'engine.pose',
    'maps.names.inverse',
    'timeline.clips',
    'timeline.clip',
    'study.page',
    'rounds.pause',
    'settings.points',
    'page.samples.cactus',
    'page.samples.robot',
    'page.samples.portrait',
  ],
  ja: [
    'keys.names.ctrl',
    'keys.names.shift',
    'keys.names.escape',
    'keys.presses.enter',
    'keys.presses.shift',
    'keys.presses.shiftF10',
    'files.placeholder',
  ],
  zh: [
    'keys.names.ctrl',
    'keys.names.shift',
    'keys.names.delete',
    'keys.names.escape',
    'keys.presses.enter',
    'keys.presses.shift',
    'keys.presses.shiftF10',
    'files.placeholder',
    'engine.zip',
  ],
};

/** The strings of a table by their paths. */
function textsOf(table: object, path = ''): ReadonlyMap<string, string> {
  const entries = Object.entries(table).flatMap(([key, entry]): (readonly [string, string])[] => {
    const name = path === '' ? key : `${path}.${key}`;
    if (typeof entry === 'object') return [...textsOf(entry, name)];
    return typeof entry === 'string' ? [[name, entry]] : [];
  });
  return new Map(entries);
}

const english = textsOf(en);

it.each(Object.entries(SHIPPED))('%s translates every text but shared words', (tag, table) => {
  const same = [...textsOf(table)].filter(
    ([path, text]) => text === english.get(path) && /\p{L}/u.test(text),
  );
  const shared = [...EVERYWHERE, ...(SHARED[tag] ?? [])];
  expect(same.map(([path]) => path).filter((path) => !shared.includes(path))).toEqual([]);
});
