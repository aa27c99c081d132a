// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The map "viridis" (Smith, van der Walt) at 16 even steps.

const kViridis = [
  0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e, 0x1f988b,
  0x22a884, 0x35b779, 0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725,
];

/** The part that is seen well on the theme's background. */
const kSpans = { light: [0.0, 0.86], dark: [0.2, 1.0] };

function channels(value) {
  const at = Math.min(Math.max(value, 0), 1) * (kViridis.length - 1);
  const low = Math.min(Math.floor(at), kViridis.length - 2);
  const mix = (shift) => {
    const [a, b] = [(kViridis[low] >> shift) & 255, (kViridis[low + 1] >> shift) & 255];
    return Math.round(a + (at - low) * (b - a));
  };
  return [mix(16), mix(8), mix(0)];
}

/** 256 colours, RGBA. */
export function paletteBytes(theme) {
  const [low, high] = kSpans[theme];
  const bytes = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    bytes.set([...channels(low + ((high - low) * i) / 255), 255], 4 * i);
  }
  return bytes;
}

export function paletteGradient(theme) {
  const [low, high] = kSpans[theme];
  const stops = Array.from({ length: 9 }, (_, i) => {
    return `rgb(${channels(low + ((high - low) * i) / 8).join(" ")})`;
  });
  return `linear-gradient(to right, ${stops.join(", ")})`;
}
