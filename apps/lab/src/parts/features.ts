// The words of a feature id: 16 bits for each shape, of which two are the kind and fourteen the number; an edge is
// low · 127 + high of its two vertices (src/narrow/manifold/features.hpp), in the plane the vertex at which it begins.

function half(bits: number, whose: string, flat: boolean): string {
  const kind = bits >> 14, n = bits & 0x3fff;
  if (kind === 1) return `vertex ${n} of ${whose}`;
  if (kind === 2 && flat) return `edge ${n} of ${whose}`;
  if (kind === 2) return `edge ${Math.floor(n / 127)}–${n % 127} of ${whose}`;
  if (kind === 3) return `face ${n} of ${whose}`;
  return whose;
}

/** A hexadecimal id of the protocol in words: "vertex 2 of A × face 1 of B". */
export function featureWords(id: string, dimension = 3): string {
  const bits = Number.parseInt(id, 16);
  const flat = dimension === 2;
  return `${half(Math.floor(bits / 65536) & 0xffff, "A", flat)} × ${half(bits & 0xffff, "B", flat)}`;
}
