import { describe, expect, it } from 'vitest';
import { en } from '../texts/en';
import { ariaKeys, COMMANDS, commandOfKey, commandsFor, type KeyPress, keyHint } from './commands';

const press = (key: string, held: Partial<KeyPress> = {}): KeyPress => ({
  key,
  code: '',
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  shiftKey: false,
  ...held,
});

describe('commandOfKey', () => {
  it('reads letters in either case, and marks on any keyboard layout', () => {
    expect(commandOfKey(press('v'))).toBe('select');
    expect(commandOfKey(press('V', { shiftKey: true }))).toBe('select');
    expect(commandOfKey(press('+', { shiftKey: true }))).toBe('zoom-in');
  });

  it('distinguishes undo from redo, with Ctrl and with Cmd', () => {
    expect(commandOfKey(press('z', { ctrlKey: true }))).toBe('undo');
    expect(commandOfKey(press('Z', { metaKey: true, shiftKey: true }))).toBe('redo');
    expect(commandOfKey(press('y', { ctrlKey: true }))).toBe('redo');
  });

  it('takes a letter of another script by its place', () => {
    expect(commandOfKey(press('я', { code: 'KeyZ', ctrlKey: true }))).toBe('undo');
    expect(commandOfKey(press('Φ', { code: 'KeyV', shiftKey: true }))).toBe('select');
    expect(commandOfKey(press('é', { code: 'Digit2' }))).toBeNull();
    // Latin letters count as typed: on a French keyboard A is where others have Q.
    expect(commandOfKey(press('a', { code: 'KeyQ', ctrlKey: true }))).toBe('select-all');
  });

  it('knows brackets that take Alt to be typed', () => {
    expect(commandOfKey(press('[', { altKey: true, ctrlKey: true }))).toBe('backward');
    expect(commandOfKey(press(']', { altKey: true }))).toBe('forward');
  });

  it('offers posing commands alone in a posable picture, and none in a readonly one', () => {
    const posable = commandsFor(true, false, 'select', false);
    const asked = (key: string, ctrlKey = false) => commandOfKey(press(key, { ctrlKey }), posable);
    expect([asked('z', true), asked('y', true), asked('a', true)]).toEqual(['undo', 'redo', 'select-all']);
    expect([asked('r'), asked('o'), asked('Escape')]).toEqual(['reset', 'compare', 'bail']);
    const ofEditors = [
      'v',
      'p',
      'b',
      'g',
      'h',
      'c',
      'x',
      'm',
      '[',
      ']',
      '0',
      '1',
      '+',
      '-',
      'Delete',
      'Backspace',
    ];
    expect(ofEditors.map((key) => asked(key))).toEqual(ofEditors.map(() => null));
    expect(['o', 's', 'e', 'c', 'v'].map((key) => asked(key, true))).toEqual(Array(5).fill(null));
    expect(commandsFor(true, true, 'select', false)).toEqual([]);
  });

  it('does not change unknown parts', () => {
    expect(commandOfKey(press('p', { ctrlKey: true }))).toBeNull();
    expect(commandOfKey(press('h', { altKey: true }))).toBeNull();
    expect(commandOfKey(press('Tab'))).toBeNull();
  });

  it('has no key twice with any tool', () => {
    for (const tool of ['select', 'brush'] as const) {
      for (const ofClip of [false, true]) {
        const names = commandsFor(false, false, tool, ofClip);
        const keys = names.flatMap((name): readonly string[] => COMMANDS[name]);
        expect(new Set(keys).size).toBe(keys.length);
      }
    }
  });

  it('has the same keys for handles and for the selected keys of a clip', () => {
    const asked = (keys: boolean) =>
      (['Delete', 'Backspace', 'm', 'Ctrl c', 'Ctrl v', 'Ctrl a'] as const).map((written) => {
        const key = written.split(' ').at(-1) ?? '';
        return commandOfKey(
          press(key, { ctrlKey: key !== written }),
          commandsFor(false, false, 'select', keys),
        );
      });
    expect(asked(false)).toEqual(['remove', 'remove', 'mirror', 'copy', 'paste', 'select-all']);
    expect(asked(true)).toEqual([
      'remove-keys',
      'remove-keys',
      'mirror-keys',
      'copy-keys',
      'paste-keys',
      'select-all-keys',
    ]);
  });

  it('has the sizes of the brush on the keys of depths, with the brush alone', () => {
    const brushing = commandsFor(false, false, 'brush', false);
    expect(['[', ']', 'e'].map((key) => commandOfKey(press(key), brushing))).toEqual([
      'brush-smaller',
      'brush-larger',
      'brush-erase',
    ]);
    const otherwise = commandsFor(false, false, 'select', false);
    expect(['[', ']', 'e'].map((key) => commandOfKey(press(key), otherwise))).toEqual([
      'backward',
      'forward',
      null,
    ]);
  });
});

describe('hints', () => {
  it('show the first key as the platform writes it', () => {
    expect(keyHint('redo', 'Linux x86_64', en)).toBe('Ctrl + Shift + Z');
    expect(keyHint('redo', 'MacIntel', en)).toBe('⌘⇧Z');
    expect(keyHint('zoom-in', 'Linux x86_64', en)).toBe('+');
    expect(keyHint('reset-all', 'Linux x86_64', en)).toBe('');
  });

  it('name keys for assistive technology', () => {
    expect(ariaKeys('redo', 'Linux x86_64')).toBe('Control+Shift+Z Control+Y');
    expect(ariaKeys('redo', 'MacIntel')).toBe('Meta+Shift+Z Meta+Y');
    expect(ariaKeys('zoom-in', 'Linux x86_64')).toBe('=');
  });
});
