// The page of one lesson: the drawing, the step's words, numbers and formula, and everything around them.

import { ask, line } from "../graze.ts";
import { lessons } from "../lessons/index.ts";
import type { Example, Lesson, Step } from "../lessons/lesson.ts";
import { Choices } from "../parts/choices.ts";
import { codeOf } from "../parts/code.ts";
import { h, write } from "../parts/dom.ts";
import type { Stage } from "../parts/drawing.ts";
import { Follower } from "../parts/follower.ts";
import { Formulas } from "../parts/formulas.ts";
import { drawGraph } from "../parts/graph.ts";
import { Stage2 } from "../parts/stage2.ts";
import { Stage3 } from "../parts/stage3.ts";
import { address, cameraOf, cameraText, History, parse, whenStill } from "../parts/state.ts";
import { Table } from "../parts/table.ts";
import { speeds, Timeline } from "../parts/timeline.ts";
import { copy, type Question, type State } from "../question.ts";
import type { Room } from "./room.ts";

const isState = (value: unknown): boolean =>
  typeof value === "object" && value !== null && typeof (value as State).q === "object" && typeof (value as State).q?.a === "object";

export class LessonRoom implements Room {
  readonly element: HTMLElement;
  private readonly lesson: Lesson;
  private state: State;
  private step: number;
  private steps: Step[] = [];
  private readonly history: History<State>;
  private stage!: Stage;
  private dimension: 2 | 3 | null = null;
  private readonly place = h("div", { class: "place" });
  private readonly table = new Table();
  private readonly timeline = new Timeline((step) => this.go(step), {}, 900, () => this.remember());
  private readonly still = whenStill(() => this.remember());
  private readonly title = h("h2");
  private readonly text = h("p");
  private readonly formulas = new Formulas();
  private readonly words = h("div", { class: "words", "aria-live": "polite" }, this.title, this.text, this.formulas.element);
  private readonly trouble = h("p", { class: "trouble", role: "alert", hidden: true });
  private readonly plot = h("div", { class: "plot" });
  private readonly choices: Choices;
  /** The drawing with its controls, and the words and numbers of the step. */
  private readonly board: HTMLElement;
  private readonly code = h("div", { class: "code" });
  private looked = "";
  private readonly copyQuestion = this.link("Copy as a question", () => line(this.question()!));
  private waiting = 0;
  /** The words and numbers of the step, which follow the picture while something is dragged. */
  private readonly telling = new Follower(() => this.tell());
  private settled = true;

  constructor(lesson: Lesson, values: Record<string, string>) {
    this.lesson = lesson;
    this.state = parse(values.s, copy(lesson.start), isState);
    this.step = Math.max(0, Number(values.step ?? 0) | 0);
    this.history = new History(this.state);
    this.choices = new Choices(lesson.choices ?? [], lesson.bits ?? [], (key, value) =>
      this.change({ ...copy(this.state), choice: { ...this.state.choice, [key]: value } }, true));
    this.board = h("div", { class: "board" },
      h("div", { class: "picture" }, this.choices.element, this.trouble, this.place, this.timeline.element),
      h("div", { class: "side" }, this.words, this.plot, this.table.element));
    this.table.onPoint = (key) => this.light(key);
    this.timeline.speed = speeds.includes(Number(values.speed)) ? Number(values.speed) : 1;
    this.element = this.page();
    this.build();
    this.show();
    this.stage.camera = cameraOf(values.view);
  }

  dispose(): void {
    cancelAnimationFrame(this.waiting);
    this.telling.cancel();
    this.still.cancel();
    this.timeline.stop();
    this.stage.dispose();
  }
  /** The state of the page, for the tests. */
  get shown(): { state: State; question: Question | undefined; step: number; steps: number } {
    return { state: this.state, question: this.question(), step: this.step, steps: this.steps.length };
  }
  undo(): void {
    this.restore(this.history.undo());
  }
  redo(): void {
    this.restore(this.history.redo());
  }

  private restore(state: State | null): void {
    if (!state) return;
    this.state = state;
    this.show();
    this.remember();
  }
  /** Draws once a frame, however many moves of the pointer there were; the programs and the address follow when it is
   *  let go. */
  private change(state: State, done: boolean): void {
    this.state = state;
    if (done) this.history.push(state);
    this.settled = done;
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.show();
      if (this.settled) this.remember();
    });
  }
  /** Shows an example, and scrolls to the drawing, which may be far above the examples. */
  private tryOut(example: Example): void {
    this.change(copy(example.state), true);
    if (this.stage.element.getBoundingClientRect().top < 0) this.board.scrollIntoView();
  }
  /** Shows a step, and scrolls to its title where that is below the screen: on a phone it stands below the drawing. */
  private go(step: number): void {
    this.step = step;
    this.paint();
    this.remember();
    const [title, bar] = [this.words.firstElementChild!, this.timeline.element].map((x) => x.getBoundingClientRect());
    if (title.bottom > bar.top) this.board.scrollIntoView();
  }
  private light(key: string | null): void {
    this.stage.light(key);
    this.table.light(key);
  }
  private remember(): void {
    const values: Record<string, string> = {};
    if (this.step) values.step = String(this.step);
    if (JSON.stringify(this.state) !== JSON.stringify(this.lesson.start)) values.s = JSON.stringify(this.state);
    if (this.timeline.speed !== 1) values.speed = String(this.timeline.speed);
    const { camera } = this.stage;
    if (camera) values.view = cameraText(camera);
    history.replaceState(null, "", address(`/lesson/${this.lesson.id}`, values));
  }

  /** Builds the stage of the state's dimension. */
  private build(): void {
    const { lesson } = this, wanted = typeof lesson.dimension === "function" ? lesson.dimension(this.state) : lesson.dimension;
    if (wanted === this.dimension) return;
    if (this.dimension !== null) this.stage.dispose();
    this.dimension = wanted;
    this.stage = wanted === 2 ? new Stage2() : new Stage3();
    this.stage.onDrag = (id, to, done) => this.change(lesson.drag(this.state, id, to), done);
    this.stage.onPoint = (key) => this.light(key);
    this.stage.onCamera = () => this.still.call();
    this.place.replaceChildren(this.stage.element);
    this.looked = "";
  }
  private look(): void {
    this.build();
    const { view } = this.lesson;
    const wanted = typeof view === "function" ? view(this.state) : view;
    const text = JSON.stringify(wanted);
    if (text === this.looked) return;
    this.looked = text;
    this.stage.look(wanted);
  }
  private show(): void {
    try {
      const question = this.question(), error = question && ask(question).error;
      if (error) throw new Error(error);
      this.steps = this.lesson.steps(this.state);
      this.trouble.hidden = true;
    } catch (error) {
      this.trouble.textContent = `This situation cannot be shown: ${(error as Error).message}`;
      this.trouble.hidden = false;
      if (this.steps.length === 0) return;
    }
    this.step = Math.min(this.step, this.steps.length - 1);
    this.look();
    this.paint();
    this.choices.show(this.state);
    if (this.settled && this.trouble.hidden) this.showCode();
  }
  private paint(): void {
    const step = this.steps[this.step];
    this.timeline.show(this.step, this.steps.length);
    const handles = this.lesson.handles(this.state).filter(({ id, named }) => !named || step.handles?.includes(id));
    this.stage.draw((drawing) => step.draw(drawing), handles, step.says);
    if (this.settled) this.telling.now();
    else this.telling.soon();
  }
  /** Shows the words and numbers of the step. */
  private tell(): void {
    const step = this.steps[this.step];
    write(this.title, step.title);
    write(this.text, step.text);
    this.table.show(step.numbers);
    this.plot.replaceChildren(...(step.graph ? [drawGraph(step.graph)] : []));
    this.formulas.show(step.formula ?? [], this.settled); // last, so that the page is laid out once
  }

  private page(): HTMLElement {
    const { lesson } = this;
    const at = lessons.indexOf(lesson);
    const neighbour = (l: Lesson | undefined, sign: string): Node | null =>
      l ? h("a", { href: address(`/lesson/${l.id}`, {}) }, sign.replace("%", `${l.number} ${l.title}`)) : h("span");
    const example = (e: Example): HTMLElement =>
      h("li", {},
        h("button", { type: "button", class: "example", onclick: () => this.tryOut(e) }, e.label),
        h("span", {}, ` ${e.note}`));
    return h("article", { class: "lesson" },
      h("header", {},
        h("p", { class: "number" }, `Lesson ${lesson.number} · ${lesson.title}`),
        h("h1", {}, lesson.question),
        h("p", { class: "intro" }, lesson.intro)),
      this.board,
      h("div", { class: "more" },
        h("section", {}, h("h2", {}, "Try this"), h("ul", {}, ...lesson.tryThis.map(example)),
          h("p", { class: "actions" },
            h("button", { type: "button", onclick: () => this.undo() }, "Undo"),
            h("button", { type: "button", onclick: () => this.redo() }, "Redo"),
            h("button", { type: "button", onclick: () => this.change(copy(lesson.start), true) }, "Start again"),
            this.link("Copy permalink", () => location.href),
            this.copyQuestion)),
        h("section", {}, h("h2", {}, "What goes wrong"), h("ul", {}, ...lesson.wrong.map(example))),
        h("section", { class: "in-code" }, h("h2", {}, "In code"), this.code),
        h("section", {}, h("h2", {}, "Where it comes from"), h("ul", {}, ...lesson.sources.map((s) => h("li", {}, s))))),
      h("nav", { class: "neighbours", "aria-label": "Lessons before and after" },
        neighbour(lessons[at - 1], "← %"), neighbour(lessons[at + 1], "% →")));
  }
  private question(): Question | undefined {
    return this.lesson.asks ? this.lesson.asks(this.state) : this.state.q;
  }
  private link(label: string, text: () => string): HTMLElement {
    const button = h("button", { type: "button", onclick: () => void this.put(text(), button) }, label);
    return button;
  }
  private showCode(): void {
    const question = this.question();
    const programs = this.lesson.code?.(this.state).programs ?? (question ? codeOf(question) : {});
    const open = new Set([...this.code.querySelectorAll("details[open] > summary")].map((summary) => summary.textContent));
    if (!this.code.firstChild) open.add("JavaScript");
    const shown = (name: string, text: string): HTMLElement =>
      h("details", { open: open.has(name) }, h("summary", {}, name), h("pre", { tabindex: 0 }, h("code", {}, text)));
    this.code.replaceChildren(
      ...Object.entries(programs).map(([language, text]) => shown(language, text)),
      ...(question ? [shown("A line for graze query", line(question))] : []));
    this.copyQuestion.hidden = !question;
  }
  private async put(text: string, button: HTMLElement): Promise<void> {
    const before = button.textContent;
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      button.textContent = "The browser forbids it";
    }
    window.setTimeout(() => (button.textContent = before), 1500);
  }
}
