import { describe, expect, it } from 'vitest';
import { en } from './en';
import { languageOf } from './language';
import { bestOf, changedBy, directionOf, parentsOf } from './lookup';
import { isSameWording, say, worded } from './wording';

describe('the language of a tag', () => {
  it('is its own, or else that of a parent', () => {
    expect(parentsOf('de-AT')).toEqual(['de-at', 'de']);
    expect(parentsOf(' zh_Hans-CN ')).toEqual(['zh-hans-cn', 'zh-hans', 'zh']);
    expect(parentsOf('')).toEqual([]);
  });

  it('is the first one of a person that there are texts for', () => {
    expect(bestOf(['pt-BR', 'de-AT', 'fr'], ['de', 'fr'])).toBe('de');
    expect(bestOf(['pt-BR', 'en-GB', 'de'], ['de'])).toBe('en');
    expect(bestOf(['pt-BR'], ['de'])).toBe('en');
    expect(bestOf(['de-AT'], ['de', 'de-at'])).toBe('de-at');
  });

  it('has a direction', () => {
    expect(['he', 'ar-EG', 'de', ''].map(directionOf)).toEqual(['rtl', 'rtl', 'ltr', 'ltr']);
  });
});

describe('a partial table', () => {
  it('falls back to the whole one, entry by entry', () => {
    const texts = changedBy(en, { toolbar: { open: 'Ouvrir' }, steps: { move: (who) => `Déplacer ${who}` } });
    expect([texts.toolbar.open, texts.toolbar.save]).toEqual(['Ouvrir', 'Save']);
    expect(worded(texts, say('steps.move', 'a'))).toBe('Déplacer a');
    expect(texts.commands).toEqual(en.commands);
  });
});

describe('a wording', () => {
  it('is data, and holds others', () => {
    const step = say('steps.move', say('names.bar', '2'));
    const stored = JSON.parse(JSON.stringify(say('spoken.undone', step)));
    expect(worded(en, stored)).toBe('Undone: Move bar 2');
    expect(isSameWording(stored, say('spoken.undone', step))).toBe(true);
    expect(worded(en, say('names.sentences', [say('notices.saved', 'a.png'), 'More.']))).toBe(
      'Saved as a.png. More.',
    );
  });

  it('of another version of the editor is empty', () => {
    expect(worded(en, { ...say('steps.fill'), key: 'steps.gone' as 'steps.fill' })).toBe('');
    expect(worded(en, { ...say('steps.fill'), key: 'gone.gone' as 'steps.fill' })).toBe('');
    expect(worded(en, { ...say('steps.fill'), key: 'steps' as 'steps.fill' })).toBe('');
  });
});

describe('plurals', () => {
  it('have the forms of their language', () => {
    const { plural } = languageOf('ru');
    const forms = { one: 'файл', few: 'файла', many: 'файлов', other: 'файла' };
    expect([1, 2, 5, 21].map((count) => plural(count, forms))).toEqual(['файл', 'файла', 'файлов', 'файл']);
    expect(languageOf('ja').plural(3, { other: '個' })).toBe('個');
  });

  it('are right in English', () => {
    expect([0, 1, 2].map(en.status.creases)).toEqual(['0 folds', '1 fold', '2 folds']);
    expect(en.status.samples(12_345)).toBe('12,345 mesh points');
    expect(en.notices.leftOut(1)).toMatch(/^One handle/);
    expect(en.spoken.rotation(-1)).toBe('rotation -1 degree');
  });
});
