// Blows, free motion, worlds and simulations of space.
#include "c/calls.hpp"

void Calls::ask_blow() {
  GrazeInverseMassd inverse{};
  GrazeResponsed response;
  GrazeMotiond after;
  told(graze_inverse_mass_d(in.length(), in.vector(), in.pose().rotation, in.maybe(&inverse)));
  const GrazeMat3d tensor{{in.vector(), in.vector(), in.vector()}};
  if (in.byte() < 32) told(graze_inverse_mass_of_tensor_d(in.length(), in.maybe(&tensor), {0, 0, 0, 1}, &inverse));
  if (in.byte() < 64) told(graze_inverse_mass_of_shape_d(shape(), in.length(), in.pose().rotation, &inverse));
  const GrazeStruckBodyd ground{}, body{{in.vector(), in.vector(), in.vector()}, inverse};
  const GrazeStruckContactd contact{in.vector(), in.vector(), in.length(), in.length()};
  if (told(graze_response_d(&contact, in.maybe(&ground), in.maybe(&body), in.maybe(&response))))
    require(!(response.normal_impulse < 0));
  told(graze_apply_impulse_d(in.maybe(&body), in.vector(), in.vector(), in.maybe(&after)));
  pass_on(ground, body);
  fall();
}

void Calls::pass_on(const GrazeStruckBodyd& ground, const GrazeStruckBodyd& body) {
  GrazeStruckBodyd struck[] = {ground, body};
  const GrazePlaneStruckBodyd flat_body{{{in.number(), in.number()}, in.number(), {0, 0}}, {in.length(), in.length()}};
  GrazePlaneStruckBodyd flat_struck[] = {{}, flat_body};
  const GrazeVec3d points[] = {in.vector(), in.vector()};
  const GrazeVec2d flat_points[] = {{points[0].x, points[0].y}, {points[1].x, points[1].y}};
  const std::uint32_t a = in.byte() % 3, b = in.byte() % 3, first = in.byte() % 4, count = in.byte() % 4;
  const GrazeBlowd blow{a, b, {0, in.byte() < 8 ? in.number() : 1, 0}, in.length(), first, count};
  const GrazePlaneBlowd flat{a, b, {0, blow.normal.y}, blow.restitution, first, count};
  double impulses[2] = {};
  GrazePassedOnd passed{};
  const GrazeTouchingd touching{in.maybe(struck), 0, 2, in.maybe(&blow),    0, 1,
                                in.maybe(points), 0, 2, in.maybe(impulses), 0};
  if (told(graze_pass_on_d(in.maybe(&touching), in.length(), in.byte(), in.maybe(&passed))))
    require(first + count <= 2 && a != b && passed.struck < 256);
  const GrazePlaneTouchingd touching_flat{flat_struck, 0, 2, &flat, 0, 1, flat_points, 0, 2, impulses, 0};
  told(graze_plane_pass_on_d(in.maybe(&touching_flat), in.length(), in.byte(), in.maybe(&passed)));
  GrazePlaneMotiond after;
  told(graze_plane_apply_impulse_d(in.maybe(&flat_body), flat_points[0], flat_points[1], in.maybe(&after)));
}

void Calls::fall() {
  GrazeFreeBodyd free{in.vector(), in.pose().rotation, in.vector(), in.vector(), in.vector()};
  GrazePlaneFreeBodyd flat{{in.number(), in.number()}, in.pose2().rotation, {0, 1}, in.number(), in.length()};
  GrazeVec3d angular;
  double turning;
  told(graze_free_set_angular_velocity_d(in.maybe(&free), in.vector()));
  told(graze_free_advance_d(in.maybe(&free), in.vector(), in.number()));
  told(graze_free_angular_velocity_d(in.maybe(&free), in.maybe(&angular)));
  told(graze_plane_free_set_angular_velocity_d(in.maybe(&flat), in.number()));
  told(graze_plane_free_advance_d(in.maybe(&flat), {in.number(), in.number()}, in.number()));
  told(graze_plane_free_angular_velocity_d(in.maybe(&flat), in.maybe(&turning)));
  GrazeMeshFindings found;
  if (told(graze_shape_findings_d(shape(), in.maybe(&found)))) require(found.triangles > 0);
}

GrazeBodyd Calls::new_body() {
  GrazeBodyd b = graze_body_default_d(shape());
  if (in.byte() < 4) b = GrazeBodyd{b.shape, {}, {}, {}, {}, false, false, false};
  b.pose = in.pose();
  b.linear = in.vector();
  b.angular = {in.byte() / 64.0, 0, 0};
  b.fixed = in.byte() < 64;
  b.trigger = in.byte() < 32;
  return b;
}

void Calls::change_world() {
  const GrazeBodyd b = new_body();
  GrazeBodyId id;
  const GrazePosed pose = in.pose();
  switch (in.byte() % 6) {
  case 0:
  case 1:
    if (bodies.size() < 16 && told(graze_world_add_d(in.maybe(world), in.maybe(&b), in.maybe(&id))))
      bodies.push_back(id);
    break;
  case 2: told(graze_world_remove_d(world, body(bodies))); break;
  case 3: told(graze_world_move_d(world, body(bodies), in.maybe(&pose), nullptr)); break;
  case 4: told(graze_world_set_shape_d(world, body(bodies), shape())); break;
  default: told(graze_world_update_d(in.maybe(world), in.byte() < 8 ? -1 : 0));
  }
  GrazeWorldContactsd contacts;
  const GrazeContactEvent* events;
  const GrazeBodyId* found;
  const GrazeBodyDistanced* distances;
  std::size_t count = 0;
  if (told(graze_world_contacts_d(world, in.maybe(&contacts))) && contacts.pair_count > 0)
    require(contacts.pairs[0].a < contacts.pairs[0].b);
  told(graze_world_events_d(world, &events, in.maybe(&count)));
  told(graze_world_overlapping_d(world, shape(), &pose, nullptr, buffer, in.maybe(&found), &count));
  told(graze_world_nearest_d(world, shape(), &pose, in.byte(), in.length(), nullptr, buffer, &distances, &count));
  GrazePosed end;
  GrazeVec3d left;
  const GrazeBodyCastHitd* touched;
  told(graze_world_slide_d(world, shape(), in.maybe(&pose), in.vector(), in.byte() % 9, nullptr, buffer, &end, &left,
                           in.maybe(&touched), &count));
  const GrazeVec3d away[] = {in.vector(), in.vector(), in.vector()};
  told(graze_along_planes_d(in.vector(), in.maybe(away), 0, 3, in.maybe(&left)));
  GrazeBodyd known;
  if (told(graze_world_body_d(world, body(bodies), in.maybe(&known)))) graze_shape_release_d(known.shape);
}

void Calls::change_simulation() {
  GrazeBodyd b = new_body();
  b.pose = graze_pose_at_place_d((in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, 0);
  b.linear = {};
  GrazeDynamicsd dynamics = graze_dynamics_default_d();
  dynamics.has_mass = dynamics.has_inertia = dynamics.has_center_of_mass = in.byte() < 128 || ++masses > 2;
  dynamics.mass = in.length();
  dynamics.inertia_diagonal = {in.length(), in.length(), in.length()};
  GrazeMateriald material = graze_material_default_d();
  material.restitution = in.number();
  material.friction_combine = in.byte() % 6;
  GrazeBodyId id;
  GrazeJointd joint;
  GrazeJointId joint_id;
  const GrazePosed frame = graze_pose_at_place_d(in.byte() / 64.0, 0, 0);
  GrazePosed pose;
  switch (in.byte() % 8) {
  case 0:
  case 1:
    if (simulated.size() < 8 && told(graze_simulation_add_d(in.maybe(simulation), in.maybe(&b), in.maybe(&dynamics),
                                                            in.maybe(&material), in.maybe(&id))))
      simulated.push_back(id);
    break;
  case 2: told(graze_simulation_remove_d(simulation, body(simulated))); break;
  case 3:
    if (told(graze_joint_of_kind_d(in.choice<GrazeJointKind>(4), body(simulated), in.maybe(&frame), body(simulated),
                                   &frame, in.maybe(&joint))) &&
        joints.size() < 4 && told(graze_simulation_add_joint_d(simulation, in.maybe(&joint), &joint_id)))
      joints.push_back(joint_id);
    break;
  case 4:
    if (!joints.empty()) told(graze_simulation_remove_joint_d(simulation, joints[in.byte() % joints.size()]));
    break;
  case 5:
    if (state == nullptr)
      told(graze_simulation_save_d(simulation, in.maybe(&state)));
    else
      told(graze_simulation_restore_d(simulation, in.maybe(state)));
    break;
  case 6: told(graze_simulation_apply_impulse_d(simulation, body(simulated), in.vector(), in.vector())); break;
  default: told(graze_simulation_step_d(in.maybe(simulation), in.byte() < 8 ? in.number() : 1.0 / 60));
  }
  told(graze_simulation_pose_d(simulation, body(simulated), in.maybe(&pose)));
  const GrazeJointId* all;
  std::size_t count = 0;
  std::int32_t sub_steps = 0;
  std::uint64_t hash = 0;
  told(graze_simulation_sub_steps_d(simulation, body(simulated), in.maybe(&sub_steps)));
  told(graze_simulation_state_hash_d(simulation, in.maybe(&hash)));
  if (told(graze_simulation_joints_d(simulation, in.maybe(buffer), &all, &count)) && count > 0)
    told(graze_simulation_joint_d(simulation, all[0], buffer, in.maybe(&joint)));
  const GrazeWorldd* borrowed;
  if (told(graze_simulation_world_d(simulation, in.maybe(&borrowed))))
    require(graze_world_update_d(const_cast<GrazeWorldd*>(borrowed), 0) == GRAZE_INVALID_VALUE);
}
