import { readFileSync } from 'node:fs';
import Ajv from 'ajv';
import { describe, expect, it } from 'vitest';
import { htmlData, webTypes } from './editors.mjs';
import { frameworkTypes, reactListener, settable } from './frameworks.mjs';
import { elements, written } from './manifest.mjs';
import { withTables } from './tables.mjs';

const SCHEMA = new URL('../../../node_modules/custom-elements-manifest/schema.json', import.meta.url);

describe('the manifest', () => {
  const all = elements();
  const [warp] = all;
  if (!warp) throw new Error('there are no elements');

  it('is valid by its schema', () => {
    const ajv = new Ajv({ strict: false });
    const validate = ajv.compile(JSON.parse(readFileSync(SCHEMA, 'utf8')));
    validate(JSON.parse(JSON.stringify(written(all))));
    expect(validate.errors).toBeNull();
  });

  it('has types, defaults, errors and the words of a type', () => {
    const tool = warp.attributes.find(({ name }) => name === 'tool');
    expect(tool).toMatchObject({ fieldName: 'toolSource', type: { text: 'ToolName' } });
    expect(tool?.type.words).toContain('lasso');
    expect(warp.fields.find(({ name }) => name === 'readonly')).toMatchObject({
      type: { text: 'boolean' },
      default: 'false',
      attribute: 'readonly',
      reflects: true,
    });
    const load = warp.methods.find(({ name }) => name === 'load');
    expect(load?.description).toContain('Throws C2WarpError');
    expect(load?.parameters?.map(({ name, optional = false }) => [name, optional])).toEqual([
      ['source', false],
      ['project', true],
      ['options', true],
    ]);
    const save = warp.events.find(({ name }) => name === 'beforesave');
    expect(save).toMatchObject({
      cancelable: true,
      type: { text: expect.stringMatching(/^CustomEvent<\{ name/) },
    });
  });

  it('gives editors the words of attributes, and which have no value', () => {
    const attributes = htmlData(all).tags[0]?.attributes ?? [];
    expect(attributes.find(({ name }) => name === 'theme')?.values).toEqual([
      { name: 'auto' },
      { name: 'dark' },
      { name: 'light' },
    ]);
    expect(attributes.find(({ name }) => name === 'loop')?.valueSet).toBe('v');
    const [element] = webTypes(all, { name: 'c2warp', version: '1.0.0' }).contributions.html.elements;
    expect(element?.attributes.find(({ name }) => name === 'theme')?.value.type).toBe(
      "'auto' | 'dark' | 'light'",
    );
  });

  it('lists for templates the properties that can be set before connection', () => {
    const names = settable(warp).map(({ name }) => name);
    expect(names).toEqual(expect.arrayContaining(['project', 'tool', 'hint-for', 'hintFor', 'samples']));
    for (const name of ['projectSource', 'zoom', 'paused']) expect(names).not.toContain(name);
    expect(frameworkTypes(all)['solid.d.ts']).toContain("'on:selectionchange'?:");
  });

  it('names listeners of React by the words of an event', () => {
    const names = ['change', 'selectionchange', 'timeupdate', 'beforeopen', 'ended'].map(reactListener);
    expect(names).toEqual(['onChange', 'onSelectionChange', 'onTimeUpdate', 'onBeforeOpen', 'onEnded']);
  });

  it('fills the tables of a document, and changes nothing else', () => {
    const before = 'First.\n\n<!-- manifest: c2-warp slots -->\nold\n<!-- /manifest -->\n\nLast.\n';
    const after = withTables(before, [{ ...warp, slots: [{ name: '', description: 'A | B.' }] }], '');
    expect(after).toBe(
      'First.\n\n<!-- manifest: c2-warp slots -->\n\n| slot | meaning |\n|---|---|\n' +
        '| the default one | A \\| B. |\n\n<!-- /manifest -->\n\nLast.\n',
    );
    expect(withTables(after, all, '')).not.toContain('A \\| B');
    expect(() => withTables(before.replace('slots', 'colours'), all, '')).toThrow('no table of colours');
  });
});
