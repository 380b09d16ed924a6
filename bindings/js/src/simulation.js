// Bodies that fall, collide, rest and are tied together; and what one blow does.

import { InvalidValue, shown } from "./core.js";
import { named } from "./layout.js";

const axes = ["x", "y", "z"];
const jointKinds = ["fixed", "ball", "hinge", "slider"];

export function simulationClasses(core, layout, args, shapes, worlds, Handle) {
  const { written, answered, pose, vec3 } = args;
  const { idAt, bodyAt, questionable } = worlds;
  const call = (name, ...parameters) => core.call(`simulation_${name}`, ...parameters);
  /** The library's defaults, and what the caller says. */
  const settled = (type, name, value) => {
    const p = core.room(type.size);
    core.exports[`graze_${name}_default_${core.scalar}`](p);
    type.write(p, value, name);
    return p;
  };
  const dynamicsAt = (value = {}) =>
    settled(layout.dynamics, "dynamics", {
      ...value,
      hasMass: value.mass !== undefined,
      hasCenterOfMass: value.centerOfMass !== undefined,
      hasInertia: value.inertiaDiagonal !== undefined,
    });
  const materialAt = (value = {}) => settled(layout.material, "material", value);

  /** Structs one behind the other. */
  const several = (type, values, path) => {
    const first = core.room(Math.max(1, values.length) * type.size);
    values.forEach((value, i) => type.write(first + i * type.size, value, `${path}[${i}]`));
    return first;
  };
  const limit = (value) => ({
    space: value.space,
    axes: axes.map((axis) => value.axes.includes(axis)),
    min: value.min ?? -Infinity,
    max: value.max ?? Infinity,
    stiffness: value.stiffness ?? 0,
    damping: value.damping ?? 0,
  });
  const drive = (value) => ({
    mode: "force", positionTarget: 0, velocityTarget: 0, stiffness: 0, damping: 0, maxForce: Infinity, ...value });
  const jointAt = (value) => {
    const p = core.room(layout.joint.size);
    const frames = [value.frameA, value.frameB].map((frame) => ({
      translation: frame?.translation ?? [0, 0, 0],
      rotation: frame?.rotation ?? [0, 0, 0, 1],
    }));
    layout.joint.write(p, { a: value.a, b: value.b, frameA: frames[0], frameB: frames[1] }, "joint");
    const own = (value.limits ?? []).map(limit);
    const size = layout.jointLimit.size;
    let count = 0;
    let first = 0;
    if (value.kind !== undefined) {
      const held = core.room(layout.joint.size);
      const kind = named(jointKinds, value.kind, "joint.kind");
      core.call(
        "joint_of_kind", kind, idAt(value.a, "joint.a"), pose(value.frameA, "joint.frameA"), idAt(value.b, "joint.b"),
        pose(value.frameB, "joint.frameB"), held);
      ({ limits: first, limitCount: count } = layout.joint.read(held));
    }
    const all = core.room(Math.max(1, count + own.length) * size);
    core.copy(first, all, count * size);
    own.forEach((bound, i) => layout.jointLimit.write(all + (count + i) * size, bound, `joint.limits[${i}]`));
    const drives = (value.drives ?? []).map(drive);
    layout.joint.write(p, {
      limits: all, limitCount: count + own.length, drives: several(layout.jointDrive, drives, "joint.drives"),
      driveCount: drives.length, enableCollision: value.enableCollision ?? false });
    return p;
  };

  class State extends Handle {
    constructor(pointer) {
      if (typeof pointer !== "number") throw new TypeError("graze: a State is made by Simulation.save");
      super(pointer, (p) => core.exports[`graze_state_destroy_${core.scalar}`](p));
    }
  }

  class Simulation extends Handle {
    constructor(settings = {}) {
      super(
        core.frame(() => {
          const result = core.room(4);
          call("create", settled(layout.simulationSettings, "simulation_settings", settings), 0, result);
          return core.data.getUint32(result, true);
        }),
        (p) => core.exports[`graze_simulation_destroy_${core.scalar}`](p),
      );
      const world = () => core.frame(() => answered(layout.u32, (p) => call("world", at(this), p)));
      this.world = questionable({}, world);
    }
    add(body, dynamics, material) {
      return core.frame(() =>
        answered(layout.id, (p) => call("add", at(this), bodyAt(body), dynamicsAt(dynamics), materialAt(material), p)));
    }
    remove(id) {
      core.frame(() => call("remove", at(this), idAt(id, "body")));
    }
    addJoint(joint) {
      return core.frame(() => answered(layout.id, (p) => call("add_joint", at(this), jointAt(joint), p)));
    }
    removeJoint(id) {
      core.frame(() => call("remove_joint", at(this), idAt(id, "joint")));
    }
    step(dt) {
      core.frame(() => call("step", at(this), dt));
    }
    applyImpulse(id, impulse, point) {
      core.frame(() =>
        call("apply_impulse", at(this), idAt(id, "body"), vec3(impulse, "impulse"), vec3(point, "point")));
    }
    applyAngularImpulse(id, impulse) {
      core.frame(() => call("apply_angular_impulse", at(this), idAt(id, "body"), vec3(impulse, "impulse")));
    }
    applyForce(id, force) {
      core.frame(() => call("apply_force", at(this), idAt(id, "body"), vec3(force, "force")));
    }
    applyTorque(id, torque) {
      core.frame(() => call("apply_torque", at(this), idAt(id, "body"), vec3(torque, "torque")));
    }
    setVelocity(id, velocity) {
      core.frame(() => call("set_velocity", at(this), idAt(id, "body"), written(layout.velocity, velocity, "velocity")));
    }
    setPose(id, to) {
      core.frame(() => call("set_pose", at(this), idAt(id, "body"), pose(to, "pose")));
    }
    moveTo(id, to, dt) {
      core.frame(() => call("move_to", at(this), idAt(id, "body"), pose(to, "pose"), dt));
    }
    setMaterial(id, material) {
      core.frame(() => call("set_material", at(this), idAt(id, "body"), materialAt(material)));
    }
    setGravity(gravity) {
      core.frame(() => call("set_gravity", at(this), vec3(gravity, "gravity")));
    }
    wake(id) {
      core.frame(() => call("wake", at(this), idAt(id, "body")));
    }
    pose(id) {
      return core.frame(() => answered(layout.pose, (p) => call("pose", at(this), idAt(id, "body"), p)));
    }
    poses() {
      return core.frame(() => {
        const first = core.room(4);
        const count = core.room(4);
        call("poses", at(this), first, count);
        return core.numbers(core.data.getUint32(first, true), 7 * core.data.getUint32(count, true));
      });
    }
    motion(id) {
      return core.frame(() => {
        const velocity = core.room(layout.velocity.size);
        const center = core.room(layout.vec3.size);
        call("motion", at(this), idAt(id, "body"), velocity, center);
        return { ...layout.velocity.read(velocity), center: layout.vec3.read(center) };
      });
    }
    mass(id) {
      return core.frame(() => answered(layout.num, (p) => call("mass", at(this), idAt(id, "body"), p)));
    }
    asleep(id) {
      return core.frame(() => answered(layout.bool, (p) => call("asleep", at(this), idAt(id, "body"), p)));
    }
    jointImpulses(id) {
      return core.frame(() => {
        const first = core.room(4);
        const count = core.room(4);
        call("joint_impulses", at(this), idAt(id, "joint"), first, count);
        return Array.from(core.numbers(core.data.getUint32(first, true), core.data.getUint32(count, true)));
      });
    }
    report() {
      return core.frame(() => answered(layout.stepReport, (p) => call("report", at(this), p)));
    }
    save() {
      return new State(core.frame(() => answered(layout.u32, (p) => call("save", at(this), p))));
    }
    restore(state) {
      core.frame(() => call("restore", at(this), Handle.pointer(state, "state", State)));
    }
  }
  const at = (simulation) => Handle.pointer(simulation, "simulation", Simulation);
  return { Simulation, State };
}

export function blows(core, layout, args, shapes) {
  const { written, answered, vec3 } = args;
  const noTurn = [0, 0, 0, 1];
  const inverseMass = (body, path) => {
    const p = core.room(layout.inverseMass.size);
    const rotation = () => written(layout.quat, body.rotation ?? noTurn, `${path}.rotation`);
    if (body.inertia !== undefined) core.call("inverse_mass", body.mass, vec3(body.inertia, `${path}.inertia`), rotation(), p);
    else if (body.shape !== undefined)
      core.call("inverse_mass_of_shape", shapes.of(body.shape, `${path}.shape`), body.mass, rotation(), p);
    else if (body.mass === Infinity) core.call("inverse_mass", body.mass, vec3([1, 1, 1]), rotation(), p);
    else throw new InvalidValue(`${path}.inertia: expected three numbers, or a shape, got ${shown(body.inertia)}`);
    return layout.inverseMass.read(p);
  };
  const bodyAt = (body, path) => {
    const center = body.translation ?? [0, 0, 0];
    const { linear, angular } = body;
    return written(layout.struckBody, { motion: { linear, angular, center }, mass: inverseMass(body, path) }, path);
  };
  return {
    response: (contact, a, b) =>
      core.frame(() => {
        const { point, normal, restitution = 0, friction = 0.6 } = contact;
        const at = written(layout.struckContact, { point, normal, restitution, friction }, "contact");
        return answered(layout.response, (p) => core.call("response", at, bodyAt(a, "a"), bodyAt(b, "b"), p));
      }),
    applyImpulse: (body, impulse, point) =>
      core.frame(() =>
        answered(layout.motion, (p) =>
          core.call("apply_impulse", bodyAt(body, "body"), vec3(impulse, "impulse"), vec3(point, "point"), p))),
  };
}
