// Bytes as a file that the browser saves.

import { h } from "./dom.ts";

export function saveFile(name: string, parts: Uint8Array[]): void {
  const address = URL.createObjectURL(new Blob(parts as BlobPart[], { type: "application/octet-stream" }));
  h("a", { href: address, download: name }).click();
  // The browser has begun to read by then.
  window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
