/** The line at the top of the stage while a task runs: as long as the part that is done, or moving if nobody knows. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { ShownTask } from '../editor/view_model';
import { percentOf } from './status';

export const progressBar = (task: ShownTask): TemplateResult => {
  const known = task.fraction !== undefined;
  return html`<div
    class="bar ${known ? 'known' : ''}"
    role="progressbar"
    aria-label=${task.label}
    aria-valuenow=${known ? percentOf(task) : nothing}
    .style=${known ? `--_done: ${percentOf(task)}%` : ''}
  ></div>`;
};
