/** The menu of a phone, for commands that its bar has no room for. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { COMMANDS } from '../editor/commands';
import type { Dispatch, EditorEvent } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { placeBelowButton } from './below_button';
import { closePopover } from './close_popover';
import { captionOf } from './command_button';
import { type IconName, icon } from './icons';
import { themeLabel } from './theme';

export function moreMenu(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const entry = (name: IconName, label: string, event: EditorEvent, possible = true) => html`<button
    type="button"
    class="entry"
    ?disabled=${!possible}
    @click=${(click: Event) => {
      closePopover(click);
      dispatch(event);
    }}
  >
    ${icon(name)}${label}
  </button>`;
  const suggest = { type: 'command-run', command: 'suggest' } as const;
  const unfold = { type: 'command-run', command: 'without-folds' } as const;
  const reset = { type: 'command-run', command: 'reset-all' } as const;
  const lens = { type: 'command-run', command: 'lens' } as const;
  const hand = { type: 'command-run', command: 'hand' } as const;
  const timeline = { type: 'command-run', command: 'timeline' } as const;
  const keys = { type: 'command-run', command: 'keys' } as const;
  return html`<div class="menu more">
    <button type="button" class="button" part="button" popovertarget="more" aria-label="More">
      ${icon('more')}${captionOf('More')}
    </button>
    <div
      id="more"
      class="popover card"
      part="menu"
      popover
      role="group"
      aria-label="More"
      @beforetoggle=${placeBelowButton}
    >
      ${model.offers('timeline') ? entry('timeline', COMMANDS.timeline.label, timeline, model.canRun('timeline')) : nothing}
      ${model.offers('suggest') ? entry('suggest', COMMANDS.suggest.label, suggest, model.canRun('suggest')) : nothing}
      ${entry('without-folds', COMMANDS['without-folds'].label, unfold, model.canRun('without-folds'))}
      ${entry('reset', COMMANDS['reset-all'].label, reset, model.canRun('reset-all'))}
      ${entry(model.dark ? 'light' : 'dark', themeLabel(model), { type: 'theme-switched' })}
      ${model.offers('hand') ? entry('hand', COMMANDS.hand.label, hand) : nothing}
      ${model.offers('lens') ? entry('lens', COMMANDS.lens.label, lens, model.canRun('lens')) : nothing}
      ${entry('keys', COMMANDS.keys.label, keys)}
    </div>
  </div>`;
}
