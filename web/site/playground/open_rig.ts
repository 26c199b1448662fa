/** The rig that is open in the playground: in the element, as text, and as an address. */

import type { C2Warp } from '../../src/element';
import { projectText } from './project_text';
import { SAMPLES, type Sample, sampleOf } from './samples';
import { hashOf, projectIn, SharedRigError } from './shared_rig';

/** The parts of the page that follow the rig. */
export interface Shown {
  sample: Sample;
  text: string;
  /** A sentence about the last action, or an empty string. */
  message: string;
}

const sentence = (error: unknown): string => (error instanceof Error ? error.message : String(error));

const aborted = (error: unknown): boolean => error instanceof DOMException && error.name === 'AbortError';

export class OpenRig {
  private readonly element: C2Warp;
  private readonly samples: string;
  private readonly show: (part: Partial<Shown>) => void;
  private sample: Sample = SAMPLES[0];
  /** Counts openings, of which the newest wins. */
  private openings = 0;

  /** @param samples The address of the folder with all samples. */
  constructor(element: C2Warp, samples: string, show: (part: Partial<Shown>) => void) {
    this.element = element;
    this.samples = samples;
    this.show = show;
  }

  /** Opens a sample with its own project. */
  async choose(sample: Sample): Promise<void> {
    try {
      await this.open(sample);
    } catch (error) {
      this.show({ message: sentence(error) });
    }
  }

  /** Opens a sample with a project, or with its own one. Rejects if the project is refused. */
  private async open(sample: Sample, project?: unknown): Promise<void> {
    const opening = ++this.openings;
    const address = `${this.samples}${sample}`;
    const given = project ?? (await (await fetch(`${address}.c2warp.json`)).json());
    if (opening !== this.openings) return;
    this.sample = sample;
    this.show({ sample, text: projectText(given) });
    try {
      await this.element.load(`${address}.png`, given);
    } catch (error) {
      if (aborted(error)) return;
      throw error;
    }
    if (opening === this.openings) this.show({ text: projectText(this.element.project), message: '' });
  }

  /** Opens the rig in a hash. Without one, opens the sample. */
  async openHash(hash: string): Promise<void> {
    try {
      const project = await projectIn(hash);
      const sample = project === undefined ? this.sample : sampleOf(project);
      if (!sample)
        throw new SharedRigError('This link names a picture that is no sample. The sample is shown instead.');
      await this.open(sample, project);
    } catch (error) {
      await this.choose(SAMPLES[0]);
      this.show({ message: sentence(error) });
    }
  }

  /** Applies a text. Until it is valid, the picture keeps the last valid project. */
  async apply(text: string): Promise<void> {
    try {
      const project: C2Warp['project'] = JSON.parse(text);
      const sample = sampleOf(project);
      if (!sample) throw new Error(`image.src names no sample. There are ${SAMPLES.join('.png, ')}.png.`);
      if (sample === this.sample) this.element.project = project;
      else await this.open(sample, project);
      this.show({ message: '' });
    } catch (error) {
      this.show({ message: sentence(error) });
    }
  }

  /** Puts the rig into the address of the page, and copies the address. */
  async copyLink(): Promise<void> {
    try {
      history.replaceState(history.state, '', await hashOf(this.element.project));
    } catch (error) {
      this.show({ message: sentence(error) });
      return;
    }
    try {
      await navigator.clipboard.writeText(location.href);
      this.show({ message: 'The link is copied.' });
    } catch {
      this.show({ message: 'Copy the link from the address bar.' });
    }
  }
}
