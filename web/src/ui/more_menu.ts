/** The menu of a phone, for commands that its bar has no room for. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch, EditorEvent } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { placeBelowButton } from './below_button';
import { closePopover } from './close_popover';
import { captionOf } from './command_button';
import { type IconName, icon } from './icons';
import { themeLabel } from './theme';

export function moreMenu(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { texts } = model;
  const entry = (name: IconName, label: string, event: EditorEvent, possible = true) => html`<button
    type="button"
    class="entry"
    data-entry=${name}
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
  const brush = { type: 'command-run', command: 'brush' } as const;
  const timeline = { type: 'command-run', command: 'timeline' } as const;
  const keys = { type: 'command-run', command: 'keys' } as const;
  return html`<div class="menu more">
    <button type="button" class="button" part="button" popovertarget="more" aria-label=${texts.toolbar.more}>
      ${icon('more')}${captionOf(texts.toolbar.more)}
    </button>
    <div
      id="more"
      class="popover card"
      part="menu"
      popover
      role="group"
      aria-label=${texts.toolbar.more}
      @beforetoggle=${placeBelowButton}
      @toggle=${placeBelowButton}
    >
      ${model.offers('timeline') ? entry('timeline', texts.commands.timeline, timeline, model.canRun('timeline')) : nothing}
      ${model.offers('suggest') ? entry('suggest', texts.commands.suggest, suggest, model.canRun('suggest')) : nothing}
      ${entry('without-folds', texts.commands['without-folds'], unfold, model.canRun('without-folds'))}
      ${entry('reset', texts.commands['reset-all'], reset, model.canRun('reset-all'))}
      ${entry(model.dark ? 'light' : 'dark', themeLabel(model), { type: 'theme-switched' })}
      ${model.offers('brush') ? entry('brush', texts.commands.brush, brush) : nothing}
      ${model.offers('hand') ? entry('hand', texts.commands.hand, hand) : nothing}
      ${model.offers('lens') ? entry('lens', texts.commands.lens, lens, model.canRun('lens')) : nothing}
      ${entry('keys', texts.commands.keys, keys)}
    </div>
  </div>`;
}
