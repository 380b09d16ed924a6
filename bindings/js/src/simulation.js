// Bodies that fall, collide, rest and are tied together; and the response to one blow.

import { bytesWritten, copied, created } from "./capture.js";
import { arrayOf, callback, InvalidValue, membersOf, shown } from "./core.js";
import { named } from "./layout.js";
import { freeMotion, passing, struckMembers } from "./motion.js";

const axes = ["x", "y", "z"];
const spaces = ["linear", "angular"];
const jointKinds = ["fixed", "ball", "hinge", "slider"];
/** The kinds that have bounds of their own: a slider's are along its axis, where it has any. */
const usualBounds = { slider: [-Infinity, Infinity], distance: [0, Infinity] };
const jointMembers = ["a", "b", "frameA", "frameB", "kind", "min", "max", "limits", "drives", "enableCollision"];
/** The members of a struct that say whether others are there, which the caller does not write. */
const told = (name) => !name.startsWith("has");

/** The simulations of a dimension, whose turnings are written by `turning`. */
export function simulationClasses(core, layout, dimension, worlds, Handle) {
  const { prefix, types, args, pose, shown: shownPose, turning, ask } = dimension;
  const { written, answered } = args;
  const { idAt, bodyAt, velocityAt } = worlds;
  const call = (name, ...parameters) => core.call(`${prefix}simulation_${name}`, ...parameters);
  const vector = (value, path) => written(types.vector, value, path);
  /** The number of numbers that a pose in an array has. */
  const poseNumbers = types.pose.size / core.numberSize;
  /** The library's defaults, overwritten by the caller's values, of which none may be named otherwise; `besides` are
   * members that the caller does not write. */
  const settled = (type, name, given, path, besides = () => ({})) => {
    const value = membersOf(given, path, Object.keys(type.members).filter(told));
    const p = core.room(type.size);
    core.exports[`graze_${prefix}${name}_default_${core.scalar}`](p);
    type.write(p, { ...value, ...besides(value) }, path);
    return p;
  };
  const inertia = types.dynamics.members.inertia === undefined ? "inertiaDiagonal" : "inertia";
  const dynamicsAt = (given) =>
    settled(types.dynamics, "dynamics", given, "dynamics", (value) => ({
      hasMass: value.mass !== undefined,
      hasCenterOfMass: value.centerOfMass !== undefined,
      hasInertia: value[inertia] !== undefined,
    }));
  const materialAt = (given, path = "material") => settled(types.material, "material", given, path);

  /** Writes structs one behind the other. */
  const several = (type, values, path) => {
    const first = core.room(Math.max(1, values.length) * type.size);
    values.forEach((value, i) => type.write(first + i * type.size, value, `${path}[${i}]`));
    return first;
  };
  const limit = (given, i) => {
    const path = `joint.limits[${i}]`;
    const { space, axes: held, min = -Infinity, max = Infinity, stiffness = 0, damping = 0 } =
      membersOf(given, path, Object.keys(layout.jointLimit.members));
    named(spaces, space, `${path}.space`);
    for (const axis of arrayOf(held, `${path}.axes`)) named(axes, axis, `${path}.axes`);
    return { space, axes: axes.map((axis) => held.includes(axis)), min, max, stiffness, damping };
  };
  const shownLimit = ({ axes: held, ...bounds }) => ({ ...bounds, axes: axes.filter((_, i) => held[i]) });
  const drive = (given, i) => {
    const path = `joint.drives[${i}]`;
    const {
      space, axis, mode = "force", positionTarget = 0, velocityTarget = 0, stiffness = 0, damping = 0,
      maxForce = Infinity } = membersOf(given, path, Object.keys(layout.jointDrive.members));
    named(spaces, space, `${path}.space`);
    named(axes, axis, `${path}.axis`);
    return { space, axis, mode, positionTarget, velocityTarget, stiffness, damping, maxForce };
  };
  const isGiven = (bound) => bound !== undefined && bound !== null;
  /** The bounds of a joint of a kind, or null where it has none. */
  const boundsOf = ({ kind, min, max }) => {
    named([...jointKinds, "distance"], kind, "joint.kind");
    const usual = usualBounds[kind];
    const [name] = Object.entries({ min, max }).find(([, bound]) => isGiven(bound)) ?? [];
    if (name !== undefined && usual === undefined)
      throw new InvalidValue(`joint.${name}: expected none of the kind ${kind}, got ${shown(min ?? max)}`);
    return name === undefined && kind !== "distance" ? null : [min ?? usual[0], max ?? usual[1]];
  };
  const jointAt = (given) => {
    const value = membersOf(given, "joint", jointMembers);
    if (value.kind === undefined && (isGiven(value.min) || isGiven(value.max)))
      throw new InvalidValue("joint.kind: expected slider or distance, whose bounds are min and max, got undefined");
    const p = core.room(types.joint.size);
    const frameA = pose(value.frameA, "joint.frameA");
    const frameB = pose(value.frameB, "joint.frameB");
    types.joint.write(p, { a: value.a, b: value.b }, "joint");
    core.copy(frameA, p + types.joint.offset.frameA, types.pose.size);
    core.copy(frameB, p + types.joint.offset.frameB, types.pose.size);
    const own = Array.from(arrayOf(value.limits ?? [], "joint.limits"), limit);
    const size = layout.jointLimit.size;
    let count = 0;
    let first = 0;
    if (value.kind !== undefined) {
      const held = core.room(types.joint.size);
      const frames = [idAt(value.a, "joint.a"), frameA, idAt(value.b, "joint.b"), frameB];
      const bounds = boundsOf(value);
      if (bounds === null) core.call(`${prefix}joint_of_kind`, named(jointKinds, value.kind), ...frames, held);
      else core.call(`${prefix}joint_${value.kind}`, ...frames, ...bounds, ask.room(), held);
      ({ limits: first, limitCount: count } = types.joint.read(held));
    }
    const all = core.room(Math.max(1, count + own.length) * size);
    core.copy(first, all, count * size);
    own.forEach((bound, i) => layout.jointLimit.write(all + (count + i) * size, bound, `joint.limits[${i}]`));
    const drives = Array.from(arrayOf(value.drives ?? [], "joint.drives"), drive);
    types.joint.write(p, {
      limits: all, limitCount: count + own.length, drives: several(layout.jointDrive, drives, "joint.drives"),
      driveCount: drives.length, enableCollision: value.enableCollision ?? false });
    return p;
  };

  /** The queries of a simulation, also of one that is played again; `pointer` returns its pointer. */
  const asked = (pointer) => ({
    pose: (id) => shownPose(answered(types.pose, (p) => call("pose", pointer(), idAt(id, "body"), p))),
    poses() {
      const first = core.room(4);
      const count = core.room(4);
      call("poses", pointer(), first, count);
      return core.numbers(core.data.getUint32(first, true), poseNumbers * core.data.getUint32(count, true));
    },
    motion(id) {
      const velocity = core.room(types.velocity.size);
      const center = core.room(types.vector.size);
      call("motion", pointer(), idAt(id, "body"), velocity, center);
      return { ...types.velocity.read(velocity), center: types.vector.read(center) };
    },
    mass: (id) => answered(layout.num, (p) => call("mass", pointer(), idAt(id, "body"), p)),
    angularMomentum: (id) => answered(types.turning, (p) => call("angular_momentum", pointer(), idAt(id, "body"), p)),
    asleep: (id) => answered(layout.bool, (p) => call("asleep", pointer(), idAt(id, "body"), p)),
    subSteps: (id) => answered(layout.i32, (p) => call("sub_steps", pointer(), idAt(id, "body"), p)),
    joints: () => ask.listed(layout.id, (...to) => call("joints", pointer(), ...to)),
    joint(id) {
      const { frameA, frameB, limits, limitCount, drives, driveCount, ...joint } = answered(types.joint, (p) =>
        call("joint", pointer(), idAt(id, "joint"), ask.room(), p));
      return {
        ...joint, frameA: shownPose(frameA), frameB: shownPose(frameB),
        limits: layout.readAll(layout.jointLimit, limits, limitCount).map(shownLimit),
        drives: layout.readAll(layout.jointDrive, drives, driveCount) };
    },
    jointImpulses(id) {
      const first = core.room(4);
      const count = core.room(4);
      call("joint_impulses", pointer(), idAt(id, "joint"), first, count);
      return Array.from(core.numbers(core.data.getUint32(first, true), core.data.getUint32(count, true)));
    },
    settings: () => answered(types.simulationSettings, (p) => call("settings", pointer(), p)),
    report: () => answered(types.stepReport, (p) => call("report", pointer(), p)),
    stateHash: () => answered(layout.u64, (p) => call("state_hash", pointer(), p)),
  });
  /** The function that returns the pointer of the simulation, for each object with those queries. */
  const pointers = new WeakMap();
  const pointerOf = (simulation) => {
    const pointer = pointers.get(simulation);
    if (pointer === undefined) throw new InvalidValue(`simulation: expected a Simulation, got ${shown(simulation)}`);
    return pointer();
  };
  /** Gives `target` those queries as methods, and those of its world as a member. */
  const questionable = (target, pointer) => {
    for (const [name, value] of Object.entries(ask.framed(asked(pointer)))) Object.defineProperty(target, name, { value });
    target.world = worlds.questionable({}, () => answered(layout.u32, (p) => call("world", pointer(), p)));
    pointers.set(target, pointer);
    return target;
  };
  /** The pointer of the simulation whose world it is, for questions alone; 0 for a world of its own. */
  const ofWorld = (world) => answered(layout.u32, (p) => core.call(`${prefix}world_simulation`, world, p));

  class State extends Handle {
    constructor(pointer) {
      if (typeof pointer !== "number") throw new TypeError("graze: a State is made by Simulation.save");
      super(pointer, (p) => core.exports[`graze_${prefix}state_destroy_${core.scalar}`](p));
    }
    static fromBytes(bytes) {
      const read = (p) => core.call(`${prefix}state_read`, ...copied(core, bytes), p);
      return new State(core.frame(() => answered(layout.u32, read)));
    }
    bytes() {
      const from = Handle.pointer(this, "state", State);
      return core.frame(() => bytesWritten(core, (write, key) => core.call(`${prefix}state_bytes`, from, write, key)));
    }
  }

  class Simulation extends Handle {
    constructor(given) {
      const names = [...Object.keys(types.simulationSettings.members), "capture"];
      const { capture, ...settings } = membersOf(given, "settings", names);
      const begin = () => settled(types.simulationSettings, "simulation_settings", settings, "settings");
      super(...created(core, `${prefix}simulation`, begin, callback(capture, "settings.capture")));
      questionable(this, () => at(this));
    }
    add(body, dynamics, material) {
      return core.frame(() =>
        answered(layout.id, (p) => call("add", changed(this), bodyAt(body), dynamicsAt(dynamics), materialAt(material), p)));
    }
    remove(id) {
      core.frame(() => call("remove", changed(this), idAt(id, "body")));
    }
    addJoint(joint) {
      return core.frame(() => answered(layout.id, (p) => call("add_joint", changed(this), jointAt(joint), p)));
    }
    setJoint(id, joint) {
      core.frame(() => call("set_joint", changed(this), idAt(id, "joint"), jointAt(joint)));
    }
    setFilter(id, filter) {
      core.frame(() => call("set_filter", changed(this), idAt(id, "body"), worlds.filterAt(filter)));
    }
    removeJoint(id) {
      core.frame(() => call("remove_joint", changed(this), idAt(id, "joint")));
    }
    step(dt) {
      core.frame(() => call("step", changed(this), dt));
    }
    applyImpulse(id, impulse, point) {
      core.frame(() =>
        call("apply_impulse", changed(this), idAt(id, "body"), vector(impulse, "impulse"), vector(point, "point")));
    }
    applyAngularImpulse(id, impulse) {
      core.frame(() => call("apply_angular_impulse", changed(this), idAt(id, "body"), turning(impulse, "impulse")));
    }
    applyForce(id, force) {
      core.frame(() => call("apply_force", changed(this), idAt(id, "body"), vector(force, "force")));
    }
    applyTorque(id, torque) {
      core.frame(() => call("apply_torque", changed(this), idAt(id, "body"), turning(torque, "torque")));
    }
    setVelocity(id, velocity) {
      core.frame(() => call("set_velocity", changed(this), idAt(id, "body"), velocityAt(velocity)));
    }
    setPose(id, to) {
      core.frame(() => call("set_pose", changed(this), idAt(id, "body"), pose(to, "pose")));
    }
    moveTo(id, to, dt) {
      core.frame(() => call("move_to", changed(this), idAt(id, "body"), pose(to, "pose"), dt));
    }
    setMaterial(id, material) {
      core.frame(() => call("set_material", changed(this), idAt(id, "body"), materialAt(material)));
    }
    setMaterials(id, materials, ofPiece) {
      core.frame(() => {
        const all = Array.from(arrayOf(materials, "materials"));
        const size = types.material.size;
        const first = core.room(Math.max(1, all.length) * size);
        all.forEach((material, i) => core.copy(materialAt(material, `materials[${i}]`), first + i * size, size));
        const { pointer, count } = args.rows(ofPiece, 1, "ofPiece", Uint32Array);
        call("set_materials", changed(this), idAt(id, "body"), first, all.length, pointer, count);
      });
    }
    setGravity(gravity) {
      core.frame(() => call("set_gravity", changed(this), vector(gravity, "gravity")));
    }
    setName(id, name) {
      core.frame(() => call("set_name", changed(this), idAt(id, "body"), core.written(name, "name")));
    }
    wake(id) {
      core.frame(() => call("wake", changed(this), idAt(id, "body")));
    }
    save() {
      return new State(core.frame(() => answered(layout.u32, (p) => call("save", changed(this), p))));
    }
    restore(state) {
      core.frame(() => call("restore", changed(this), Handle.pointer(state, "state", State)));
    }
  }
  const at = (simulation) => Handle.pointer(simulation, "simulation", Simulation);
  const changed = (simulation) => Handle.changed(simulation, "simulation", Simulation);
  const isOne = (value) => pointers.has(value);
  return { names: { Simulation, State }, questionable, pointerOf, isOne, ofWorld };
}

export function blows(core, layout, dimension, shapes) {
  const { args, ask } = dimension;
  const { written, answered, vec3 } = args;
  const noTurn = [0, 0, 0, 1];
  const inverseMass = (body, path) => {
    const p = core.room(layout.inverseMass.size);
    const rotation = () => written(layout.quat, body.rotation ?? noTurn, `${path}.rotation`);
    const matrix = typeof body.inertia?.[0] === "object";
    if (matrix) {
      const tensor = written(layout.mat3, body.inertia, `${path}.inertia`);
      core.call("inverse_mass_of_tensor", body.mass, tensor, rotation(), p);
    } else if (body.inertia !== undefined)
      core.call("inverse_mass", body.mass, vec3(body.inertia, `${path}.inertia`), rotation(), p);
    else if (body.shape !== undefined)
      core.call("inverse_mass_of_shape", shapes.of(body.shape, `${path}.shape`), body.mass, rotation(), p);
    else if (body.mass === Infinity) core.call("inverse_mass", body.mass, vec3([1, 1, 1]), rotation(), p);
    else throw new InvalidValue(`${path}.inertia: expected three numbers, or a shape, got ${shown(body.inertia)}`);
    return layout.inverseMass.read(p);
  };
  const bodyAt = (given, path) => {
    const body = membersOf(given, path, struckMembers);
    const { linear, angular, translation } = body;
    const motion = { linear, angular, center: translation };
    return written(layout.struckBody, { motion, mass: inverseMass(body, path) }, path);
  };
  const motion = {
    ...dimension, inverseMass, turnOf: (turn) => turn ?? [0, 0, 0], inverseInertiaOf: (inertia) => Array.from(inertia, (i) => 1 / i) };
  return ask.framed({
    response(contact, a, b) {
      const { point, normal, restitution = 0, friction = 0.6 } =
        membersOf(contact, "contact", ["point", "normal", "restitution", "friction"]);
      for (const [name, part] of Object.entries({ point, normal }))
        if (part === undefined) throw new InvalidValue(`contact.${name}: expected 3 numbers, got ${shown(part)}`);
      const at = written(layout.struckContact, { point, normal, restitution, friction }, "contact");
      return answered(layout.response, (p) => core.call("response", at, bodyAt(a, "a"), bodyAt(b, "b"), p));
    },
    ...passing(core, layout, motion),
    ...freeMotion(core, layout, motion),
  });
}
