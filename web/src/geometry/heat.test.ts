import { expect, it } from 'vitest';
import { HEAT_RAMP } from './heat';

it('gets lighter in equal OKLab steps', () => {
  const lightness = HEAT_RAMP.map(([red, green, blue]) => {
    const [r = 0, g = 0, b = 0] = [red, green, blue].map((value) =>
      value > 0.04045 * 255 ? ((value / 255 + 0.055) / 1.055) ** 2.4 : value / 255 / 12.92,
    );
    const long = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const medium = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const short = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return 0.2104542553 * long + 0.793617785 * medium - 0.0040720468 * short;
  });
  lightness.forEach((value, at) => {
    expect(value).toBeCloseTo(0.42 + (at * (0.93 - 0.42)) / 5, 2);
  });
});
