// Bytes as a file that the browser saves.

import { digits, h } from "./dom.ts";

/** The size of a file in words: "12.3 kB". */
export function sizeWords(bytes: number): string {
  const [unit, size] = bytes < 1e3 ? ["bytes", 1] : bytes < 1e6 ? ["kB", 1e3] : ["MB", 1e6];
  return `${digits(bytes / Number(size), 3)} ${unit}`;
}

export function saveFile(name: string, parts: Uint8Array[]): void {
  const address = URL.createObjectURL(new Blob(parts as BlobPart[], { type: "application/octet-stream" }));
  h("a", { href: address, download: name }).click();
  // The browser has begun to read by then.
  window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
