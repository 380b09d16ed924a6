// The corner of a picture of space: the directions of the axes, as the camera sees them, and the scale bar, which holds
// at the depth of the point that the camera looks at.

import * as THREE from "three";
import { svg } from "./dom.ts";
import type { Box } from "./labels.ts";
import { roundStep, scaleBar } from "./scale-bar.ts";

/** The length of an axis across the line of sight, and the distance of its letter from the middle, in pixels. */
const arm = 22, letter = 31;
/** The height of the corner, and that of the middle of the axes below its top. */
const height = 96, middle: [number, number] = [44, 38];

export class Axes {
  readonly element = svg("svg", { class: "axes", "aria-hidden": "true" });

  constructor() {
    this.element.style.height = `${height}px`;
  }
  /** Shows the axes and the bar for a camera that looks at `target` and a picture of a height in pixels; in a plane
   *  only the two axes that lie in it. */
  show(eye: THREE.PerspectiveCamera, target: THREE.Vector3, pixels: number, flat: boolean): void {
    const seen = 2 * Math.tan((eye.fov * Math.PI) / 360) * eye.position.distanceTo(target), step = roundStep(seen * Math.min(1, eye.aspect));
    const toEye = eye.quaternion.clone().invert();
    const arms = [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), ...(flat ? [] : [new THREE.Vector3(0, 0, 1)])]
      .map((axis, i) => ({ name: "xyz"[i], to: axis.applyQuaternion(toEye) }))
      .sort((p, q) => p.to.z - q.to.z); // the nearest is drawn last
    const [x, y] = middle, at = ({ x: right, y: up }: THREE.Vector3, far: number): [number, number] => [x + right * far, y - up * far];
    this.element.replaceChildren(...arms.flatMap(({ name, to }) => {
      const [x2, y2] = at(to, arm), [left, top] = at(to, letter);
      return [svg("line", { x1: x, y1: y, x2, y2, "data-axis": name }), svg("text", { x: left, y: top + 4, "text-anchor": "middle" }, name)];
    }), ...scaleBar(step, (step / seen) * pixels, height - 14));
  }
  /** The place in a picture of this height that labels leave free. */
  taken(pixels: number): Box {
    return { left: 0, top: pixels - height, right: middle[0] + letter + 8, bottom: pixels };
  }
}
