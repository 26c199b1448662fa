/** The notifications of the editor as events of the element. */
import { deepCopy } from '../document/project';
import type { PageNotification } from '../editor/effects';
import { asC2WarpError } from '../error';
import { en } from '../texts/en';
import { type Wording, worded } from '../texts/wording';
import type { Emit } from './events';

export function emitNotification(emit: Emit, notification: PageNotification): void {
  const { type } = notification;
  switch (type) {
    case 'load':
      emit(type, { origin: notification.origin });
      break;
    case 'toolchange':
      emit(type, { tool: notification.tool });
      break;
    case 'ready':
    case 'play':
    case 'pause':
    case 'timeupdate':
    case 'ended':
      emit(type, null);
      break;
    case 'input':
    case 'change': {
      const { project } = notification;
      // Copied only when read: a drag emits many events.
      const detail = {
        get project() {
          return deepCopy(project);
        },
      };
      emit(type, detail);
      break;
    }
    case 'selectionchange':
      emit(type, { selection: [...notification.selection] });
      break;
    case 'historychange':
      emit(type, { undo: inEnglish(notification.undo), redo: inEnglish(notification.redo) });
      break;
    case 'titlechange': {
      const { name = null, unsaved = false } = notification.title ?? {};
      emit(type, { name, unsaved });
      break;
    }
    case 'progress':
      emit(type, { label: inEnglish(notification.label), fraction: notification.fraction });
      break;
    case 'error':
      emit(type, asC2WarpError(notification.error));
      break;
  }
}

/** Events are for programs, in one language. */
const inEnglish = (words: Wording | null): string | null => words && worded(en, words);
