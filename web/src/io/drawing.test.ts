import { describe, expect, it } from 'vitest';
import { drawnPicture, sizedDrawing } from './drawing';

const size = (attributes: string) => {
  const { width, height } = sizedDrawing(`<svg ${attributes}><path/></svg>`);
  return [width, height];
};

describe('sizedDrawing', () => {
  it('enlarges small drawings, and shrinks large ones', () => {
    expect(size('viewBox="0 0 24 12"')).toEqual([1024, 512]);
    expect(size('width="1500" height="1200"')).toEqual([1500, 1200]);
    expect(size("width='9000px' height='3000'")).toEqual([4096, 1365]);
  });

  it('takes lengths with units, and ratios of the view box', () => {
    expect(size('width="100mm" height="50mm"')).toEqual([1024, 512]);
    expect(size('width="100%" height="100%" viewBox="0,0,30,60"')).toEqual([512, 1024]);
    expect(size('height="2000" viewBox="0 0 1 2"')).toEqual([1000, 2000]);
  });

  it('keeps all else, and adds a view box to a drawing without one', () => {
    const text =
      '<?xml version="1.0"?><!-- <svg> -->\n<svg xmlns="a" stroke-width="3" width="8" height="8">&amp;</svg>';
    expect(sizedDrawing(text).sized).toBe(
      '<?xml version="1.0"?><!-- <svg> -->\n' +
        '<svg xmlns="a" stroke-width="3" width="1024" height="1024" viewBox="0 0 8 8">&amp;</svg>',
    );
  });

  it('reads entities before the drawing, and is quick with unclosed brackets', () => {
    const text = '<!DOCTYPE svg [<!ENTITY a "[]">]><svg viewBox="0 0 9 9"/>';
    expect(sizedDrawing(text).width).toBe(1024);
    expect(() => sizedDrawing(`<!DOCTYPE svg ${'[]'.repeat(50_000)}`)).toThrow(/damaged/);
  });

  it('rejects drawings without a size, and texts that are not drawings', () => {
    expect(() => size('')).toThrow(/no size/);
    expect(() => size('viewBox="0 0 0 5"')).toThrow(/no size/);
    expect(() => sizedDrawing('<?xml version="1.0"?><html/>')).toThrow(/damaged/);
  });
});

describe('drawnPicture', () => {
  /** Whether a worker is asked for the picture of a drawing. */
  async function isDrawnApart(content: string | Uint8Array<ArrayBuffer>): Promise<boolean> {
    let isAsked = false;
    const drawApart = async () => {
      isAsked = true;
      return { png: new Uint8Array(1), lacksTexts: false };
    };
    // This environment has no images, so the browser's own picture fails.
    await drawnPicture(new Blob([content]), drawApart).catch(() => null);
    return isAsked;
  }
  const svg = (content: string) => `<svg viewBox="0 0 9 9">${content}</svg>`;

  it('leaves plain drawings to the browser', async () => {
    const plain =
      '<defs><linearGradient id="a"/></defs><g opacity=".5"><text>A</text><path fill="url(#a)"/></g>';
    const entity = '<!DOCTYPE svg [<!ENTITY ns_ai "http://ns.adobe.com/">]>';
    expect(await isDrawnApart(entity + svg(plain))).toBe(false);
  });

  it('has a worker draw filters, pictures and copies, however they are written', async () => {
    for (const content of [
      '<filter id="a"/>',
      '<g style="FILTER:blur(9px)"/>',
      String.raw`<g style="f\69lter:blur(9px)"/>`,
      '<g style="f&#105;lter:blur(9px)"/>',
      '<image href="data:,"/>',
      '<s:use href="#a"/>',
      '<pattern/>',
      '<mask/>',
      '<marker/>',
    ])
      expect(await isDrawnApart(svg(content)), content).toBe(true);
    expect(await isDrawnApart(`<!DOCTYPE svg [<!ENTITY a "<use/>">]>${svg('&a;')}`)).toBe(true);
  });

  it('decompresses drawings, but no other files', async () => {
    const packed = async (text: string) => {
      const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('gzip'));
      return new Uint8Array(await new Response(stream).arrayBuffer());
    };
    expect(await isDrawnApart(await packed(svg('<use/>')))).toBe(true);
    const other = await packed('once upon a time');
    expect(await drawnPicture(new Blob([other]), () => Promise.reject())).toBeNull();
  });
});
