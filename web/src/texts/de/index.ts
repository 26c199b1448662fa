/** All texts in German. */
import type { Texts } from '../texts';
import { commands } from './commands';
import { errors } from './errors';
import { engine, exporting, film, maps, webPage } from './exporting';
import { keys } from './keys';
import { names } from './names';
import { answers, notices } from './notices';
import { page } from './page';
import { bending, handleList, overlays, panel } from './panel';
import { reasons } from './reasons';
import { spoken } from './spoken';
import { brush, drawing, hints, stage, status, tasks } from './stage';
import { steps } from './steps';
import { cells, compare, lens, rounds, settings, study } from './study';
import { timeline } from './timeline';
import { files, toolbar, tools } from './toolbar';

export const de: Texts = {
  language: 'Deutsch',
  commands,
  reasons,
  keys,
  names,
  toolbar,
  files,
  tools,
  panel,
  handleList,
  bending,
  overlays,
  stage,
  hints,
  drawing,
  brush,
  status,
  tasks,
  spoken,
  steps,
  notices,
  answers,
  exporting,
  film,
  webPage,
  engine,
  maps,
  timeline,
  study,
  lens,
  cells,
  rounds,
  compare,
  settings,
  errors,
  page,
};
