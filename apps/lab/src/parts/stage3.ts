// Space: three.js. It draws when something changed, never otherwise: a still page uses no processor.

import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { Axes } from "./axes.ts";
import { isSeen } from "./camera.ts";
import { h } from "./dom.ts";
import type { Drawing, Handle, Look, Meaning, Stage, View } from "./drawing.ts";
import { Crowd } from "./crowd.ts";
import { Handles } from "./handles.ts";
import { LabelPlaces } from "./labels.ts";
import { Paints } from "./paints.ts";
import { color, onTheme } from "./theme.ts";
import { solidOf, type Solid } from "./solid.ts";
import { length, mix, sub, toWorld } from "./vec.ts";
import type { Body, Vec } from "../question.ts";

/** The angle that is seen of the lesser of width and height, in degrees. */
const fieldOfView = 40;
/** The width of a point as a part of the lesser of width and height. */
const pointWidth = 0.018;
/** The pixel of what lies behind the camera. */
const nowhere: [number, number] = [-1000, -1000];
const v3 = (p: Vec): THREE.Vector3 => new THREE.Vector3(p[0], p[1], p[2] ?? 0);

export class Stage3 implements Stage, Drawing {
  readonly element = h("div", { class: "stage stage3" });
  onDrag: (id: string, to: Vec, done: boolean) => void = () => {};
  onPoint: (key: string | null) => void = () => {};
  onCamera: () => void = () => {};
  /** Called at a click: with the body by its place in the order of `shape` calls, the ray through the pointer, and the
   *  key of the point there. */
  onPick: (body: number | null, ray: { origin: Vec; direction: Vec }, key: string | null) => void = () => {};
  /** Whether the ground's lines are drawn. */
  hasGrid = true;
  /** Bodies beyond those that are drawn one by one. */
  readonly crowd = new Crowd();
  private readonly canvas = document.createElement("canvas");
  private readonly labels = h("div", { class: "labels", "aria-hidden": "true" });
  private readonly axes = new Axes();
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly eye = new THREE.PerspectiveCamera(fieldOfView, 1, 0.01, 5000);
  private readonly controls: OrbitControls;
  private readonly handles: Handles;
  private readonly observer: ResizeObserver;
  private readonly stopTheme: () => void;
  private readonly drawn = new THREE.Group();
  private readonly paints = new Paints();
  private lines = new Map<string, { positions: number[]; meaning: Meaning; look: Look; onTop: boolean }>();
  /** Points by their looks, which are drawn together as lines are. */
  private points = new Map<string, { positions: number[]; meaning: Meaning; ghost: boolean; part: number; hidden: boolean }>();
  private texts: { at: Vec; text: string; meaning: Meaning; from?: Vec }[] = [];
  private picks: THREE.Object3D[] = [];
  private dots: { at: Vec; key: string }[] = [];
  /** Lines and faces that have a key. */
  private keyedLines: { ends: [Vec, Vec]; key: string }[] = [];
  private keyedFaces: THREE.Mesh[] = [];
  /** The places of points that are drawn big, and the ends of lines that are drawn wide. */
  private spots: Vec[] = [];
  private wide: [Vec, Vec][] = [];
  private last: { paint: (d: Drawing) => void; handles: Handle[]; says: string } | null = null;
  private lit: string | null = null;
  private waiting = 0;
  private reach = 3;
  private flat = false;
  private moved = false;
  private size: [number, number] = [600, 480];
  private readonly solids = new Map<string, Solid>();

  constructor() {
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.canvas.setAttribute("role", "img");
    this.canvas.tabIndex = 0;
    this.handles = new Handles(
      {
        toScreen: (p) => this.pixel(p),
        fromScreen: (x, y, near) => this.facing(x, y, near),
        step: () => this.reach / 50,
      },
      (id, to, done) => this.onDrag(id, to, done),
    );
    this.element.append(this.canvas, this.axes.element, this.labels, this.handles.element);
    this.controls = new OrbitControls(this.eye, this.canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.request());
    this.controls.addEventListener("end", () => this.cameraMoved());
    const sun = new THREE.DirectionalLight(0xffffff, 1.6);
    sun.position.set(3, 8, 5);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x667788, 1.7), sun, this.drawn, this.crowd.group);
    this.observer = new ResizeObserver(() => {
      const frame = this.element.getBoundingClientRect();
      if (frame.width === 0) return;
      this.size = [frame.width, frame.height];
      this.renderer.setSize(frame.width, frame.height, false);
      this.eye.aspect = frame.width / frame.height;
      // What is seen of the height in a wide picture is seen of the width in a narrow one.
      this.eye.fov = (360 / Math.PI) * Math.atan(Math.tan((fieldOfView * Math.PI) / 360) / Math.min(1, this.eye.aspect));
      this.eye.updateProjectionMatrix();
      this.request();
    });
    this.observer.observe(this.element);
    this.stopTheme = onTheme(() => (this.crowd.repaint(), this.redraw()));
    this.canvas.addEventListener("keydown", (event) => this.turnCamera(event));
    let down: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    this.canvas.addEventListener("pointerup", (event) => {
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) this.pick(event);
      down = null;
    });
    this.canvas.addEventListener("pointermove", (event) => event.buttons === 0 && this.pointTo(event));
    this.canvas.addEventListener("pointerleave", (event) => event.pointerType === "mouse" && this.pointTo(null));
  }

  dispose(): void {
    cancelAnimationFrame(this.waiting);
    this.stopTheme();
    this.observer.disconnect();
    this.controls.dispose();
    this.clear();
    this.paints.dispose();
    this.crowd.dispose();
    this.forget();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  look(view: View): void {
    if (view.reach !== this.reach || (view.flat ?? false) !== this.flat) this.forget();
    this.reach = view.reach;
    const center = v3(view.center);
    const from = v3(view.flat ? [0, 0, 1] : (view.from ?? [0.55, 0.5, 1])).normalize();
    this.lieFlat(view.flat ?? false);
    this.controls.target.copy(center);
    this.eye.position.copy(center).addScaledVector(from, (view.reach * 1.15) / Math.tan((fieldOfView * Math.PI) / 360));
    this.eye.near = view.reach / 200;
    this.eye.far = view.reach * 400;
    this.eye.updateProjectionMatrix();
    this.controls.update();
    this.moved = false;
    this.request();
  }
  /** The place of the camera, and the point that it looks at. */
  get camera(): Vec | null {
    return this.moved ? [...this.eye.position.toArray(), ...this.controls.target.toArray()] : null;
  }
  set camera(of: Vec | null) {
    if (of?.length !== 6) return;
    const eye = of.slice(0, 3), target = of.slice(3);
    if (!isSeen(of, length(sub(eye, target)))) return;
    this.eye.position.copy(v3(eye));
    this.controls.target.copy(v3(target));
    this.controls.update();
    this.eye.position.copy(v3(eye)); // which the controls have rounded by their angles
    this.moved = true;
    this.request();
  }
  private cameraMoved(): void {
    this.moved = true;
    this.onCamera();
  }
  /** Whether the pointer pushes the scene about, as in the plane, instead of turning it. */
  private lieFlat(flat: boolean): void {
    this.flat = flat;
    this.controls.enableRotate = !flat;
    this.controls.mouseButtons.LEFT = flat ? THREE.MOUSE.PAN : THREE.MOUSE.ROTATE;
    this.controls.touches.ONE = flat ? THREE.TOUCH.PAN : THREE.TOUCH.ROTATE;
  }
  /** Half of the height that is seen at least. */
  get seen(): number {
    return this.reach;
  }
  light(key: string | null): void {
    if (key === this.lit) return;
    this.lit = key;
    this.redraw();
  }
  draw(paint: (drawing: Drawing) => void, handles: Handle[], says: string): void {
    this.last = { paint, handles, says };
    this.redraw();
  }
  /** The ray through a pixel of the window. */
  rayAt(clientX: number, clientY: number): { origin: Vec; direction: Vec } {
    const frame = this.canvas.getBoundingClientRect();
    const caster = this.caster(clientX - frame.left, clientY - frame.top);
    return { origin: caster.ray.origin.toArray(), direction: caster.ray.direction.toArray() };
  }

  // --- Drawing ---

  shape(body: Body, meaning: Meaning, look?: Look): void {
    const ends = (body.shape[body.shape.type] as { points?: Vec[] } | undefined)?.points;
    if (ends?.length === 2) return this.line(toWorld(body, ends[0]), toWorld(body, ends[1]), meaning, { ...look, wide: true });
    const group = new THREE.Group();
    if (body.translation) group.position.set(...(body.translation as [number, number, number]));
    if (Array.isArray(body.rotation)) group.quaternion.set(...(body.rotation as [number, number, number, number])).normalize();
    const { faces, edges } = this.solid(look?.made ?? JSON.stringify(body.shape), body);
    const lit = look?.key !== undefined && look.key === this.lit;
    const usual = look?.ghost && !lit ? 0.12 : look?.wide ? 1 : body.shape.type === "plane" ? 0.25 : 0.55;
    const opacity = lit ? Math.min(1, usual + 0.2) : usual;
    const material = this.paints.of("faces", { color: color(meaning), opacity }, (paint) => new THREE.MeshLambertMaterial({
      ...paint, transparent: opacity < 1, side: THREE.DoubleSide, depthWrite: opacity === 1,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    }));
    const mesh = new THREE.Mesh(faces, material);
    mesh.userData.body = this.picks.length;
    this.picks.push(mesh);
    this.keep(mesh, look);
    group.add(mesh);
    if (!look?.bare) group.add(new THREE.LineSegments(edges, this.paints.of("edges", { color: color(meaning), opacity: look?.ghost && !lit ? 0.35 : 1 },
      (paint) => new THREE.LineBasicMaterial({ ...paint, transparent: true }))));
    this.drawn.add(group);
    if (lit) this.drawEdges(edges, group, meaning);
    if (look?.label) this.texts.push({ at: body.translation ?? [0, 0, 0], text: look.label, meaning });
  }
  /** The edges of a shape that is lit, as wide lines. */
  private drawEdges(edges: THREE.BufferGeometry, { position, quaternion }: THREE.Object3D, meaning: Meaning): void {
    const ends = edges.getAttribute("position"), corner = new THREE.Vector3();
    const { positions } = this.linesOf(meaning, { wide: true });
    for (let i = 0; i < ends.count; i++) positions.push(...corner.fromBufferAttribute(ends, i).applyQuaternion(quaternion).add(position).toArray());
  }
  private forget(): void {
    for (const { faces, edges } of this.solids.values()) {
      faces.dispose();
      edges.dispose();
    }
    this.solids.clear();
  }
  private solid(key: string, body: Body): Solid {
    const known = this.solids.get(key);
    if (known) return known;
    if (this.solids.size > 200) this.forget();
    const made = solidOf(body.shape, this.flat, this.reach);
    this.solids.set(key, made);
    return made;
  }
  point(at: Vec, meaning: Meaning, look?: Look): void {
    const lit = look?.key !== undefined && look.key === this.lit;
    this.pointsOf(lit ? "touch" : meaning, lit, look).positions.push(at[0], at[1], at[2] ?? 0);
    if (look?.key !== undefined) this.dots.push({ at, key: look.key });
    if (look?.wide) this.spots.push(at);
    if (look?.label) this.texts.push({ at, text: look.label, meaning });
  }
  line(from: Vec, to: Vec, meaning: Meaning, look: Look = {}, onTop = false): void {
    const lit = look.key !== undefined && look.key === this.lit, wide = look.wide || lit;
    const batch = this.linesOf(meaning, { ...look, wide }, onTop);
    if (look.key !== undefined) this.keyedLines.push({ ends: [from, to], key: look.key });
    if (look.wide) this.wide.push([from, to]);
    batch.positions.push(...v3(from).toArray(), ...v3(to).toArray());
    if (look.label) this.texts.push({ at: from.map((x, i) => (x + to[i]) / 2), text: look.label, meaning });
  }
  /** The points of one look, which are drawn together. */
  private pointsOf(meaning: Meaning, lit: boolean, { ghost = false, wide = false, small = false }: Look = {}): { positions: number[] } {
    const kind = `${meaning} ${lit} ${ghost} ${wide} ${small}`;
    let batch = this.points.get(kind);
    if (!batch) {
      batch = { positions: [], meaning, ghost, part: pointWidth * (lit || wide ? 2 : small ? 0.5 : 1), hidden: small && !lit };
      this.points.set(kind, batch);
    }
    return batch;
  }
  /** The lines of one look, which are drawn together. */
  private linesOf(meaning: Meaning, look: Look, onTop = false): { positions: number[] } {
    const kind = [meaning, look.ghost, look.dashed, look.wide, onTop].join();
    let batch = this.lines.get(kind);
    if (!batch) {
      batch = { positions: [], meaning, look, onTop: look.wide || onTop };
      this.lines.set(kind, batch);
    }
    return batch;
  }
  arrow(from: Vec, to: Vec, meaning: Meaning, look: Look = {}): void {
    this.line(from, to, meaning, { ...look, label: undefined }, true);
    const along = v3(sub(to, from));
    const size = Math.min(this.reach / 22, length(sub(to, from)) / 2);
    if (size > 0) {
      const head = new THREE.Mesh(coneGeometry, this.paints.of("head", { color: color(meaning), opacity: look.ghost ? 0.4 : 1 },
        (paint) => new THREE.MeshBasicMaterial({ ...paint, depthTest: false, transparent: true })));
      head.scale.set(size * 0.35, size, size * 0.35);
      head.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.clone().normalize());
      head.position.copy(v3(to)).addScaledVector(along.normalize(), -size / 2);
      head.renderOrder = 3;
      this.drawn.add(head);
    }
    if (look.label) this.texts.push({ at: to, text: look.label, meaning, from });
  }
  polygon(points: Vec[], meaning: Meaning, look?: Look): void {
    if (points.length > 2) {
      const geometry = new THREE.BufferGeometry().setFromPoints(points.map(v3));
      geometry.setIndex(points.slice(2).flatMap((_, i) => [0, i + 1, i + 2]));
      const lit = look?.key !== undefined && look.key === this.lit;
      const mesh = new THREE.Mesh(geometry, this.paints.of("polygon", { color: color(meaning), opacity: lit ? 0.6 : look?.ghost ? 0.1 : 0.35 },
        (paint) => new THREE.MeshBasicMaterial({ ...paint, transparent: true, side: THREE.DoubleSide, depthWrite: false })));
      mesh.userData.own = true;
      this.keep(mesh, look);
      this.drawn.add(mesh);
    }
    points.forEach((p, i) => this.line(p, points[(i + 1) % points.length], meaning, { ...look, label: undefined }));
    if (look?.label) this.texts.push({ at: points[0], text: look.label, meaning });
  }
  text(at: Vec, text: string, meaning: Meaning): void {
    this.texts.push({ at, text, meaning });
  }

  private keep(faces: THREE.Mesh, look?: Look): void {
    if (look?.key === undefined) return;
    faces.userData.key = look.key;
    this.keyedFaces.push(faces);
  }

  // --- Frames ---

  private clear(): void {
    this.drawn.traverse((object) => {
      if (object.userData.own) (object as THREE.Mesh).geometry.dispose();
    });
    this.drawn.clear();
    this.paints.limit();
    this.lines.clear();
    this.points.clear();
    this.texts = [];
    this.picks = [];
    this.dots = [];
    this.keyedLines = [];
    this.keyedFaces = [];
    this.spots = [];
    this.wide = [];
  }
  private redraw(): void {
    if (!this.last) return;
    const { paint, handles, says } = this.last;
    this.clear();
    this.canvas.setAttribute("aria-label", says);
    paint(this);
    this.ground();
    for (const { positions, meaning, look, onTop } of this.lines.values()) {
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(positions);
      const dashes = look.dashed ? { dashed: true, dashSize: this.reach / 30, gapSize: this.reach / 40 } : {};
      const line = new LineSegments2(geometry, this.paints.of("line",
        { color: color(meaning), linewidth: look.wide ? 4 : 2, opacity: look.ghost ? 0.4 : 1, depthTest: !onTop, ...dashes },
        (looks) => new LineMaterial({ ...looks, transparent: true })));
      if (look.dashed) line.computeLineDistances();
      line.renderOrder = onTop ? 2 : 1;
      line.userData.own = true;
      this.drawn.add(line);
    }
    for (const { positions, meaning, ghost, part, hidden } of this.points.values()) {
      const geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
      const points = new THREE.Points(geometry, this.paints.of("points", { color: color(meaning), opacity: ghost ? 0.4 : 1, part, depthTest: hidden }, pointMaterial));
      points.renderOrder = 3;
      points.frustumCulled = false;
      points.userData.own = true;
      this.drawn.add(points);
    }
    this.labels.replaceChildren(...this.texts.map(({ text, meaning }) => h("span", { class: `of-${meaning}` }, text)));
    this.handles.show(handles);
    this.request();
  }
  /** The ground's lines, and those of them on which a coordinate is zero. */
  private ground(): void {
    this.axes.element.toggleAttribute("hidden", !this.hasGrid);
    if (!this.hasGrid) return;
    const half = this.reach * 4, grid = new THREE.GridHelper(2 * half, 16), corner = new THREE.Vector3(half, 0, 0);
    const zero = new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(
      [corner.clone().negate(), corner, new THREE.Vector3(0, 0, -half), new THREE.Vector3(0, 0, half)]));
    for (const [lines, meaning] of [[grid, "grid"], [zero, "line"]] as const) {
      // Lines through bodies that cross the ground would look like edges: they are drawn first, and all else hides
      // them.
      lines.material = this.paints.of("grid", { color: color(meaning) },
        (looks) => new THREE.LineBasicMaterial({ ...looks, depthTest: false, depthWrite: false }));
      lines.renderOrder = meaning === "grid" ? -2 : -1;
      lines.userData.own = true;
      if (this.flat) lines.rotation.x = Math.PI / 2;
      this.drawn.add(lines);
    }
  }
  private request(): void {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.renderer.render(this.scene, this.eye);
      this.handles.place();
      if (this.hasGrid) this.axes.show(this.eye, this.controls.target, this.size[1], this.flat);
      this.placeTexts();
    });
  }
  private placeTexts(): void {
    if (this.texts.length === 0) return;
    const places = new LabelPlaces(this.size);
    this.handles.keepFree(places);
    if (this.hasGrid) places.keepBox(this.axes.taken(this.size[1]));
    for (const at of this.spots) places.keep(this.pixel(at), 6);
    for (const [from, to] of this.wide) places.keepLine(this.pixel(from), this.pixel(to), 3);
    this.texts.forEach(({ at, text, from }, i) => {
      const { left, top } = places.place(this.pixel(at), text, from && this.pixel(from));
      const label = this.labels.children[i] as HTMLElement | undefined;
      if (label) label.style.transform = `translate(${left}px, ${top}px)`;
    });
  }

  // --- Pointer and camera ---

  private pixel(p: Vec): [number, number] {
    this.eye.updateMatrixWorld();
    const q = v3(p).project(this.eye);
    if (q.z > 1) return nowhere;
    return [((q.x + 1) / 2) * this.size[0], ((1 - q.y) / 2) * this.size[1]];
  }
  private caster(x: number, y: number): THREE.Raycaster {
    const caster = new THREE.Raycaster();
    this.eye.updateMatrixWorld();
    caster.setFromCamera(new THREE.Vector2((2 * x) / this.size[0] - 1, 1 - (2 * y) / this.size[1]), this.eye);
    return caster;
  }
  private facing(x: number, y: number, near: Vec): Vec {
    const normal = this.eye.getWorldDirection(new THREE.Vector3());
    const hit = this.caster(x, y).ray.intersectPlane(
      new THREE.Plane().setFromNormalAndCoplanarPoint(normal, v3(near)), new THREE.Vector3());
    return hit ? hit.toArray() : near;
  }
  /** The pixel of the stage below the pointer, and the number of pixels by which one may miss a point or a line. */
  private under({ clientX, clientY, pointerType }: PointerEvent): [x: number, y: number, within: number] {
    const frame = this.canvas.getBoundingClientRect();
    return [clientX - frame.left, clientY - frame.top, pointerType === "touch" ? 16 : 7];
  }
  private pick(event: PointerEvent): void {
    const [x, y, within] = this.under(event), caster = this.caster(x, y);
    const [first] = caster.intersectObjects(this.picks, false);
    this.onPick(first ? (first.object.userData.body as number) : this.crowd.pick(caster),
      { origin: caster.ray.origin.toArray(), direction: caster.ray.direction.toArray() }, this.dotAt(x, y, within));
    if (event.pointerType === "touch") this.pointTo(event);
  }
  /** Says which key is below the pointer: that of a point, a line or a face, in this order. */
  private pointTo(event: PointerEvent | null): void {
    const [x, y, within] = event ? this.under(event) : [0, 0, 0];
    const key = event && (this.dotAt(x, y, within) ?? this.lineAt(x, y, within) ?? this.faceAt(x, y));
    if (key !== this.lit) this.onPoint(key);
  }
  /** For the tests: the key and the pixel of the middle of each line that has one. */
  get linesSeen(): { key: string; at: [number, number] }[] {
    return this.keyedLines.map(({ ends: [from, to], key }) => ({ key, at: this.pixel(mix(from, to, 0.5)) }));
  }
  /** For the tests: the pixels of the points that have a key. */
  get pointsSeen(): [number, number][] {
    return this.dots.map(({ at }) => this.pixel(at));
  }
  /** The key of the point nearest to a pixel, at most `within` pixels away. */
  private dotAt(x: number, y: number, within: number): string | null {
    let key: string | null = null, least = within;
    for (const dot of this.dots) {
      const [px, py] = this.pixel(dot.at), away = Math.hypot(px - x, py - y);
      if (away < least) [key, least] = [dot.key, away];
    }
    return key;
  }
  /** The key of the line nearest to a pixel, at most `within` pixels away. */
  private lineAt(x: number, y: number, within: number): string | null {
    let key: string | null = null, least = within;
    for (const line of this.keyedLines) {
      const ends = line.ends.map((end) => this.pixel(end));
      if (ends.includes(nowhere)) continue;
      const [[x1, y1], [x2, y2]] = ends;
      const squared = (x2 - x1) ** 2 + (y2 - y1) ** 2, along = squared > 0 ? ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / squared : 0;
      const t = Math.max(0, Math.min(1, along)), away = Math.hypot(x1 + t * (x2 - x1) - x, y1 + t * (y2 - y1) - y);
      if (away < least) [key, least] = [line.key, away];
    }
    return key;
  }
  /** The key of the first face that has one, seen through a pixel. */
  private faceAt(x: number, y: number): string | null {
    if (this.keyedFaces.length === 0) return null;
    const [first] = this.caster(x, y).intersectObjects(this.keyedFaces, false);
    return first ? (first.object.userData.key as string) : null;
  }
  private turnCamera(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    const offset = this.eye.position.clone().sub(this.controls.target);
    if (event.key === "+" || event.key === "-") offset.multiplyScalar(event.key === "+" ? 0.9 : 1.1);
    else if (turns[event.key] && this.flat) {
      const [x, y] = turns[event.key];
      this.controls.target.add(new THREE.Vector3(x, -y, 0).multiplyScalar(this.reach));
    } else if (turns[event.key]) {
      const ball = new THREE.Spherical().setFromVector3(offset);
      ball.theta += turns[event.key][0];
      ball.phi = Math.max(0.05, Math.min(3.09, ball.phi + turns[event.key][1]));
      offset.setFromSpherical(ball);
    } else return;
    event.preventDefault();
    this.eye.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.cameraMoved();
    this.request();
  }
}

/** The material of points that are seen as discs, as wide as a part of the lesser of width and height. */
function pointMaterial({ part, ...paint }: { color: string; opacity: number; part: number; depthTest: boolean }): THREE.PointsMaterial {
  const material = new THREE.PointsMaterial({ ...paint, map: disc(), sizeAttenuation: false, transparent: true }), size = new THREE.Vector2();
  material.onBeforeRender = (renderer) => void (material.size = part * Math.min(...renderer.getSize(size).toArray()));
  return material;
}
const coneGeometry = new THREE.ConeGeometry(1, 1, 16);
let discTexture: THREE.Texture | null = null;
function disc(): THREE.Texture {
  if (discTexture) return discTexture;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d")!;
  pen.fillStyle = "#fff";
  pen.beginPath();
  pen.arc(32, 32, 30, 0, 2 * Math.PI);
  pen.fill();
  discTexture = new THREE.CanvasTexture(canvas);
  return discTexture;
}
