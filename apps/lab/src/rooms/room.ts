/** A page of the lab, from its first drawing to its end. */
export interface Room {
  readonly element: HTMLElement;
  dispose(): void;
  undo?(): void;
  redo?(): void;
}
