// A file beside the page, which `graze view` serves, read again when it changes.

/** The callbacks of a watch. */
export interface Watcher {
  onFile(file: File): Promise<void>;
  onTrouble(text: string): void;
}

export class WatchedFile {
  private timer = 0;
  /** Whether the watch has ended. */
  ended = false;
  private watcher: Watcher;

  /** Begins to watch. Nothing is fetched from elsewhere than where the page comes from. */
  constructor(path: string, watcher: Watcher) {
    this.watcher = watcher;
    const where = new URL(path, location.href);
    if (where.origin === location.origin) void this.read(where, "");
    else watcher.onTrouble(`${path}: lies elsewhere`);
  }
  /** Sends further news to another watcher. */
  tell(watcher: Watcher): void {
    this.watcher = watcher;
  }
  end(): void {
    clearTimeout(this.timer);
    this.ended = true;
  }

  /** Reads the file unless it still has the known version; a file with versions is checked again and again. */
  private async read(where: URL, known: string): Promise<void> {
    const name = decodeURIComponent(where.pathname.split("/").pop() ?? "");
    let version = known;
    try {
      const response = await fetch(where, { cache: "no-store", headers: known ? { "If-None-Match": known } : {} });
      if (this.ended) return;
      if (response.ok) {
        version = response.headers.get("ETag") ?? "";
        await this.watcher.onFile(new File([await response.blob()], name));
      } else if (response.status !== 304) {
        throw new Error(`${name}: ${response.status === 404 ? "the file is gone" : `${response.status} ${response.statusText}`}`);
      }
    } catch (error) {
      this.watcher.onTrouble(error instanceof TypeError ? `${name}: graze view does not answer any more` : (error as Error).message);
    }
    if (version && !this.ended) this.timer = window.setTimeout(() => void this.read(where, version), document.hidden ? 5000 : 1000);
  }
}
