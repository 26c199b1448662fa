/**
 * The first steps of a user, in any browser: opens the editor, drags a handle, exports the picture, and reloads to
 * restore the work.
 *
 * A private session may refuse to store files, as WebKit's driver does. The editor must say so.
 */
import { StepError } from '../steps.mjs';

/** @typedef {{ x: number, y: number }} Place CSS pixels of the page. */

/**
 * @typedef {object} Visitor A browser that is driven.
 * @property {(url: string) => Promise<void>} open
 * @property {(script: string) => Promise<unknown>} ask The value of an expression in the page.
 * @property {(from: Place, to: Place) => Promise<void>} drag By the pointer; without a way it is a click.
 * @property {() => Promise<void>} close
 */

/** Software draws, on machines of any load. */
const PATIENCE_MS = 120_000;
const PAUSE_MS = 100;
const HANDLE = { id: 'left-hand', name: 'left hand' };
const BY = { x: 20, y: -40 };

const EDITOR = `document.querySelector('c2-warp')`;
const POSED = `${EDITOR}.project.handles.find(({ id }) => id === '${HANDLE.id}')?.posed`;
const TEXT = `${EDITOR}.shadowRoot.textContent.replace(/\\s+/g, ' ')`;

/** Keeps the size of a saved PNG in the page: drivers treat downloads differently. */
const KEEP_SAVED = `(() => {
  const { createObjectURL } = URL;
  URL.createObjectURL = (blob) => {
    if (blob.type === 'image/png') {
      blob.arrayBuffer().then((buffer) => {
        const view = new DataView(buffer);
        globalThis.saved = [view.getUint32(0).toString(16), view.getUint32(16), view.getUint32(20)].join(' ');
      });
    }
    return createObjectURL.call(URL, blob);
  };
  HTMLAnchorElement.prototype.click = () => {};
})()`;
/** The beginning of PNG, and the size of the sample. */
const SAVED = '89504e47 1024 1280';

/** The middle of a shown button, or null. @param {RegExp} name */
const middle = (name) => `(() => {
  const shown = [...${EDITOR}.shadowRoot.querySelectorAll('button, [role="button"]')]
    .filter((element) => ${name}.test(element.getAttribute('aria-label') ?? element.textContent.trim()))
    .map((element) => element.getBoundingClientRect())
    .find(({ width }) => width > 0);
  return shown ? { x: shown.x + shown.width / 2, y: shown.y + shown.height / 2 } : null;
})()`;

/**
 * @param {Visitor} visitor
 * @param {string} origin of the served editor.
 * @param {(step: string) => void} tell
 */
export async function visit(visitor, origin, tell) {
  await visitor.open(origin);
  await until(visitor, 'the sample is solved', `/\\d samples/.test(${TEXT}) && ${POSED} !== undefined`);
  tell('opens');

  const before = /** @type {[number, number]} */ (await visitor.ask(POSED));
  const place = await placeOf(visitor, new RegExp(`^Handle ${HANDLE.name}, `, 'i'));
  await visitor.drag(place, { x: place.x + BY.x, y: place.y + BY.y });
  const moved = `${POSED}[0] > ${before[0]} && ${POSED}[1] < ${before[1]}`;
  await until(visitor, 'the handle follows the pointer', moved);
  const bent = JSON.stringify(await visitor.ask(POSED));
  tell('bends');

  await visitor.ask(KEEP_SAVED);
  await click(visitor, /^Export as/);
  await click(visitor, /^Export PNG/);
  await until(visitor, 'a PNG is saved', 'globalThis.saved !== undefined');
  const saved = await visitor.ask('globalThis.saved');
  if (saved !== SAVED) throw new StepError(`The saved file begins with ${saved}.`);
  tell('exports');

  const lost = `${TEXT}.includes('This browser cannot store your work')`;
  await until(visitor, 'the work is stored', `${TEXT}.includes('kept in this browser') || ${lost}`);
  const isLost = await visitor.ask(lost);
  await visitor.open(origin);
  if (isLost) {
    await until(
      visitor,
      'a reload opens the sample',
      `/\\d samples/.test(${TEXT}) && ${POSED} !== undefined`,
    );
    tell('says that this session stores no work, and reloads');
  } else {
    await until(visitor, 'a reload restores the pose', `JSON.stringify(${POSED} ?? null) === '${bent}'`);
    tell('has the work again after a reload');
  }
}

/**
 * @param {Visitor} visitor
 * @param {RegExp} button
 */
async function click(visitor, button) {
  const place = await placeOf(visitor, button);
  await visitor.drag(place, place);
}

/**
 * @param {Visitor} visitor
 * @param {RegExp} button
 * @returns {Promise<Place>}
 */
async function placeOf(visitor, button) {
  await until(visitor, `${button} is shown`, `${middle(button)} !== null`);
  return /** @type {Place} */ (await visitor.ask(middle(button)));
}

/**
 * @param {Visitor} visitor
 * @param {string} title
 * @param {string} condition
 */
async function until(visitor, title, condition) {
  const end = performance.now() + PATIENCE_MS;
  const script = `Boolean(${EDITOR}?.shadowRoot && ${EDITOR}.project && (${condition}))`;
  while (!(await visitor.ask(script))) {
    if (performance.now() > end) throw new StepError(`Timed out while waiting for: ${title}.`);
    await new Promise((done) => setTimeout(done, PAUSE_MS));
  }
}
