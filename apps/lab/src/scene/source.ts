// The sources of scenes: files that somebody chose or dropped, and one that `graze view` serves, which is
// read again when it changes.

import { button, h } from "../parts/dom.ts";
import type { Captured } from "./captured.ts";
import type { Scene } from "./model.ts";
import { kindOf, openFile } from "./open.ts";
import { readCapture } from "./replay.ts";
import { WatchedFile } from "./watched.ts";

const accepted = ".gltf,.glb,.bin,.obj,.stl,.ply,.svg,.json,.jsonl,.capture";

/** A file that `graze view` serves: its path, and the object that watches it. */
export interface Served {
  path: string;
  watched: WatchedFile;
}
/** The callbacks for files. */
export interface Reader {
  onScene(scene: Scene): void;
  /** Called with a capture, and if it is served with the watch that the receiver has to end. */
  onCapture(name: string, captured: Captured, served: Served | null): void;
  onTrouble(text: string): void;
}

/** A button that opens files, and the field behind it. */
export function opener(label: string, onFiles: (files: File[]) => void): HTMLElement[] {
  const field = h("input", { type: "file", multiple: true, class: "hidden", accept: accepted, "aria-label": label,
    onchange: () => onFiles([...(field.files ?? [])]) }) as HTMLInputElement;
  return [button(label, () => field.click()), field];
}

export class Source {
  /** A button that opens a file, and the field behind it. */
  readonly elements: HTMLElement[];
  private served_: Served | null = null;
  private readonly reader: Reader;

  constructor(reader: Reader) {
    this.reader = reader;
    this.elements = opener("Open a file", (files) => void this.chosen(files));
  }
  /** The path of the served file. */
  get served(): string | null {
    return this.served_?.path ?? null;
  }
  watch(path: string): void {
    const watched = new WatchedFile(path, { onFile: (file) => this.read(file), onTrouble: (text) => this.reader.onTrouble(text) });
    this.served_ = { path, watched };
  }
  /** Ends the watch, after something else was chosen. */
  unwatch(): void {
    this.handOver()?.watched.end();
  }
  private handOver(): Served | null {
    const served = this.served_;
    this.served_ = null;
    return served;
  }
  /** Reads a scene, and with it the files of its buffers. */
  async chosen(files: File[]): Promise<void> {
    const scene = files.find((file) => kindOf(file) !== "bin") ?? files[0];
    if (!scene) return;
    this.unwatch();
    await this.read(scene, files);
  }
  private async read(file: File, beside: File[] = []): Promise<void> {
    try {
      if (kindOf(file) === "capture") {
        const from = this.served_, captured = await readCapture(await file.arrayBuffer());
        if (from === this.served_) this.reader.onCapture(file.name, captured, this.handOver());
      }
      else this.reader.onScene(await openFile(file, beside));
    } catch (error) {
      this.reader.onTrouble((error as Error).message);
    }
  }
}
