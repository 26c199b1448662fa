/** The surroundings of the editor: the attributes of its element, and the device. */

import type { ProjectDefaults } from '../document/defaults';
import type { Feature } from './features';

/** The attributes of the element that the editor goes by. */
export interface PageAttributes {
  /** People can look, pan and zoom, but change nothing. */
  readonly readonly: boolean;
  /** People can do nothing. */
  readonly disabled: boolean;
  /** Handles can only be posed. Gestures and keys of the view are left to the page. */
  readonly posable: boolean;
  /** The clip that the page plays; null for the first one. */
  readonly clip: string | null;
  /** The clip plays once a picture of the page is open. */
  readonly autoplay: boolean;
  /** The clip begins again at its end. */
  readonly loop: boolean;
  /** The tool that the page has set. */
  readonly tool: string | null;
  /** A description of the picture, in the words of the page. */
  readonly alt: string | null;
  readonly hint: PageHint | null;
  /** The addresses of the picture and its project; null if the page does not set them. */
  readonly src: string | null;
  readonly projectSource: string | null;
  /** Whether requests for pictures and projects of other origins carry cookies. */
  readonly credentials: 'same-origin' | 'include';
  /** Settings of new projects, instead of the editor's. */
  readonly defaults: ProjectDefaults;
  /** The parts of the editor that people get; null for all. */
  readonly features: readonly Feature[] | null;
  /** Pictures that the page offers to open. */
  readonly samples: readonly Sample[];
}

/** A picture that a page offers, with the addresses of the picture and its project. */
export interface Sample {
  readonly name: string;
  readonly src: string;
  readonly project?: string;
}

/** A hint beside the handle of this id, or beside the first handle, until the document is first changed. */
export interface PageHint {
  readonly text: string;
  readonly handle: string | null;
}

/** The device and its settings. */
export interface Media {
  readonly dark: boolean;
  /** The device has no pointer finer than a finger. */
  readonly coarse: boolean;
  /** The person prefers reduced motion. */
  readonly still: boolean;
  /** The browser's name of the platform, for the names of keys. */
  readonly platform: string;
  /** The layout goes from the right to the left. */
  readonly rtl: boolean;
  /** The browser can let a person choose a folder to write into. */
  readonly folders: boolean;
}
