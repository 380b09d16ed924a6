// The plane: shapes, queries, worlds and simulations.
#include "c/calls.hpp"

void Calls::plane() {
  GrazePlaneShaped* made = nullptr;
  std::vector<GrazeVec2d> points(in.byte() % 8);
  for (auto& p : points) p = {in.number(), in.number()};
  GrazeStatus status = GRAZE_OK;
  switch (in.byte() % 9) {
  case 0: status = graze_plane_shape_circle_d(in.length(), &made); break;
  case 1: status = graze_plane_shape_capsule_d(in.length(), in.length(), in.length(), &made); break;
  case 2: status = graze_plane_shape_box_d({in.length(), in.length()}, in.maybe(&made)); break;
  case 3: status = graze_plane_shape_convex_d(in.maybe(points.data()), 0, points.size(), &made); break;
  case 4: status = graze_plane_shape_polygon_d(in.maybe(points.data()), 0, points.size(), &made); break;
  case 5:
    status = graze_plane_shape_chain_d(in.maybe(points.data()), 0, points.size(), in.byte() < 128,
                                       in.choice<GrazeSides>(2), &made);
    break;
  case 6: status = graze_plane_shape_half_plane_d(&made); break;
  case 7: {
    const GrazePose2d pose = in.pose2();
    status = in.byte() < 128 ? graze_plane_shape_rounded_d(plane_shape(), in.length(), &made)
                             : graze_plane_shape_swept_d(plane_shape(), in.maybe(&pose), in.vector2(), &made);
    break;
  }
  default: {
    const GrazePlaneChildd children[2] = {{plane_shape(), in.pose2()}, {plane_shape(), in.pose2()}};
    status = graze_plane_shape_compound_d(children, 0, in.byte() % 3, &made);
  }
  }
  if (told(status)) keep(made);
  const GrazePlaneShaped *a = plane_shape(), *b = plane_shape();
  const GrazePose2d pose_a = in.pose2(), pose_b = in.pose2();
  bool yes = false;
  GrazePlaneDistanced d;
  GrazePlaneContactsd contacts;
  GrazePlaneClosestd closest;
  told(graze_plane_overlap_d(a, in.maybe(&pose_a), b, in.maybe(&pose_b), in.maybe(&yes)));
  if (told(graze_plane_distance_d(a, &pose_a, b, &pose_b, in.maybe(&d)))) require(d.certainty <= GRAZE_UNBOUNDED);
  told(graze_plane_distance_up_to_d(a, &pose_a, b, in.maybe(&pose_b), in.length(), in.maybe(&yes), in.maybe(&d)));
  told(graze_plane_within_d(a, in.maybe(&pose_a), b, &pose_b, in.length(), in.maybe(&yes)));
  const GrazePlanePieceDistanced* pieces;
  GrazeVec2d furthest;
  std::size_t count = 0;
  told(graze_plane_near_pieces_d(a, &pose_a, b, &pose_b, in.length(), in.maybe(buffer), in.maybe(&pieces), &count));
  told(graze_plane_shape_support_d(a, in.vector2(), in.maybe(&furthest)));
  const GrazeVec2d away[] = {in.vector2(), in.vector2()};
  told(graze_plane_along_lines_d(in.vector2(), in.maybe(away), 0, 2, in.maybe(&furthest)));
  GrazePolygons polygons;
  told(graze_plane_shape_tessellate_d(a, &pose_a, in.vector2(), in.length(), buffer, in.maybe(&polygons)));
  told(graze_plane_contacts_d(a, &pose_a, b, &pose_b, in.length(), in.maybe(buffer), in.maybe(&contacts)));
  const std::size_t most = in.byte();
  if (told(graze_plane_contacts_reduced_d(a, &pose_a, b, &pose_b, in.length(), most, in.maybe(buffer), &contacts)))
    require(contacts.point_count <= most);
  told(graze_plane_closest_d(a, &pose_a, {in.number(), in.number()}, in.maybe(&closest)));
  const GrazePlaneRayd ray = {{in.number(), in.number()}, {in.number(), in.number()}};
  GrazePlaneRayHitd hit;
  told(graze_plane_raycast_d(a, &pose_a, &ray, in.length(), in.maybe(&yes), &hit));
  const GrazePlaneRayHitd* hits;
  const GrazePlaneCastHitd* casts;
  GrazePlaneMassPropertiesd mass;
  told(graze_plane_shape_mass_properties_d(a, in.maybe(&mass)));
  told(graze_plane_raycast_any_d(b, in.maybe(&pose_b), &ray, in.length(), in.maybe(&yes)));
  told(graze_plane_raycast_all_d(b, &pose_b, in.maybe(&ray), in.length(), in.maybe(buffer), &hits, &count));
  const GrazePlaneMovingd fast = {a, pose_a, {{in.number(), 1}, 0}}, still = {b, pose_b, {{0, 0}, 0}};
  std::uint8_t met[2];
  GrazePlaneCastHitd met_at[2];
  GrazePlaneClosestd nearest[2];
  const GrazeVec2d asked[] = {ray.origin, ray.direction};
  const std::size_t stride = in.byte() < 8 ? sizeof ray : 0;
  told(graze_plane_closest_batch_d(a, &pose_a, in.maybe(asked), 0, 2, in.maybe(nearest), 0, nullptr));
  told(graze_plane_raycast_batch_d(b, in.maybe(&pose_b), in.maybe(&ray), stride, 1, in.length(), in.maybe(met), 0,
                                   in.maybe(&hit), 0));
  told(graze_plane_cast_batch_d(in.maybe(&fast), 0, &still, 0, 1, in.length(), in.choice<GrazeSeparating>(2),
                                in.maybe(met), 0, in.maybe(met_at), 0, nullptr));
  told(graze_plane_cast_all_d(in.maybe(&fast), &still, 1, in.choice<GrazeSeparating>(2), in.maybe(buffer), &casts,
                              &count));
  ask_plane_batch();
}

void Calls::ask_plane_batch() {
  const std::size_t count = in.byte() % 20;
  std::vector<const GrazePlaneShaped*> handles(in.byte() < 128 ? 1 : count);
  for (auto& h : handles) h = plane_shape();
  std::vector<GrazePose2d> poses(in.byte() < 32 ? 1 : count);
  for (auto& p : poses) p = in.pose2();
  std::vector<GrazeIdPair> places(in.byte() % 8);
  for (auto& p : places) p = {in.byte() % 21u, in.byte() % 3u};
  GrazePlaneBatchd batch{};
  batch.a = graze_plane_bodies_d(in.maybe(handles.data()), handles.size(), in.maybe(poses.data()), poses.size());
  batch.b = graze_plane_bodies_d(handles.data(), handles.empty() ? 0 : 1, poses.data(), poses.empty() ? 0 : 1);
  if (in.byte() < 64) batch.b.rotations = nullptr;
  if (!places.empty()) batch.places = places.data(), batch.place_count = places.size();
  std::size_t size = 0;
  if (!told(graze_plane_batch_size_d(in.maybe(&batch), in.maybe(&size)))) return;
  const std::size_t pairs = size;
  std::vector<std::uint8_t> touch(pairs);
  std::vector<GrazePlaneDistanced> distances(pairs);
  told(graze_plane_overlap_batch_d(&batch, in.maybe(touch.data()), 0, nullptr));
  told(graze_plane_distance_batch_d(&batch, in.maybe(distances.data()), 0, nullptr));
  GrazePlaneBatchContactsd contacts;
  const std::size_t most = in.byte();
  if (told(graze_plane_contacts_batch_reduced_d(&batch, in.length(), most, in.maybe(buffer), &contacts, nullptr)))
    require(contacts.pair_count == pairs && contacts.point_count <= most * pairs);
  const GrazePlanePieceDistanced* pieces;
  const std::size_t* ends;
  if (told(graze_plane_near_pieces_batch_d(&batch, in.length(), in.maybe(buffer), &pieces, in.maybe(&ends), &size)))
    require(size == 0 || ends[pairs - 1] == size);
}

void Calls::change_plane_world() {
  GrazePlaneBodyd b = graze_plane_body_default_d(plane_shape());
  b.pose = in.pose2();
  b.linear = {in.number(), in.number()};
  b.angular = in.byte() < 4 ? in.number() : in.byte() / 64.0;
  b.fixed = in.byte() < 64;
  b.trigger = in.byte() < 32;
  GrazeBodyId id;
  const GrazePose2d pose = in.pose2();
  const GrazePlaneVelocityd velocity{{in.number(), in.number()}, in.number()};
  switch (in.byte() % 7) {
  case 0:
  case 1:
    if (plane_bodies.size() < 16 && told(graze_plane_world_add_d(in.maybe(plane_world), in.maybe(&b), in.maybe(&id))))
      plane_bodies.push_back(id);
    break;
  case 2: told(graze_plane_world_remove_d(plane_world, body(plane_bodies))); break;
  case 3:
    told(graze_plane_world_move_d(plane_world, body(plane_bodies), in.maybe(&pose),
                                  in.byte() < 128 ? nullptr : &velocity));
    break;
  case 4: told(graze_plane_world_set_shape_d(plane_world, body(plane_bodies), plane_shape())); break;
  case 5: told(graze_plane_world_reduce_d(plane_world, in.byte() % 4)); break;
  default: told(graze_plane_world_update_d(in.maybe(plane_world), in.byte() < 8 ? -1 : 0));
  }
  ask_plane_world(pose);
}

void Calls::ask_plane_world(const GrazePose2d& pose) {
  GrazePlaneWorldContactsd contacts;
  const GrazeContactEvent* events;
  const GrazeBodyId* found;
  const GrazePlaneBodyDistanced* distances;
  const GrazePlaneBodyRayHitd* hits;
  std::size_t count = 0;
  if (told(graze_plane_world_contacts_d(plane_world, in.maybe(&contacts))))
    for (std::size_t i = 0; i < contacts.manifold_count; ++i)
      require(contacts.manifolds[i].first_point + contacts.manifolds[i].point_count <= contacts.point_count);
  told(graze_plane_world_events_d(plane_world, &events, in.maybe(&count)));
  const GrazePlaneShaped* s = plane_shape();
  told(graze_plane_world_overlapping_d(plane_world, s, &pose, nullptr, buffer, in.maybe(&found), &count));
  told(graze_plane_world_nearest_d(plane_world, s, &pose, in.byte(), in.length(), nullptr, buffer, &distances, &count));
  const GrazePlaneRayd ray = {{in.number(), in.number()}, {in.number(), in.number()}};
  told(graze_plane_world_raycast_all_d(plane_world, in.maybe(&ray), in.length(), nullptr, in.maybe(buffer), &hits,
                                       &count));
  GrazePose2d end;
  GrazeVec2d left;
  const GrazePlaneBodyCastHitd* touched;
  told(graze_plane_world_slide_d(plane_world, s, &pose, in.vector2(), in.byte() % 9, nullptr, in.maybe(buffer), &end,
                                 in.maybe(&left), in.maybe(&touched), &count));
  GrazePlaneBodyd known;
  if (told(graze_plane_world_body_d(plane_world, body(plane_bodies), in.maybe(&known))))
    graze_plane_shape_release_d(known.shape);
}

void Calls::change_plane_simulation() {
  GrazePlaneBodyd b = graze_plane_body_default_d(plane_shape());
  b.pose = graze_plane_pose_d((in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, in.byte() / 16.0);
  b.fixed = in.byte() < 64;
  GrazePlaneDynamicsd dynamics = graze_plane_dynamics_default_d();
  dynamics.has_mass = dynamics.has_inertia = dynamics.has_center_of_mass = in.byte() < 128;
  dynamics.mass = in.length();
  dynamics.inertia = in.length();
  GrazePlaneMateriald material = graze_plane_material_default_d();
  material.restitution = in.number();
  material.friction_combine = in.byte() % 6;
  GrazeBodyId id;
  GrazePlaneJointd joint;
  GrazeJointId joint_id;
  const GrazePose2d frame = graze_plane_pose_d(in.byte() / 64.0, 0, 0);
  GrazePose2d pose;
  switch (in.byte() % 8) {
  case 0:
  case 1:
    if (plane_simulated.size() < 8 &&
        told(graze_plane_simulation_add_d(in.maybe(plane_simulation), in.maybe(&b), in.maybe(&dynamics),
                                          in.maybe(&material), in.maybe(&id))))
      plane_simulated.push_back(id);
    break;
  case 2: told(graze_plane_simulation_remove_d(plane_simulation, body(plane_simulated))); break;
  case 3:
    if (told(graze_plane_joint_of_kind_d(in.choice<GrazeJointKind>(4), body(plane_simulated), in.maybe(&frame),
                                         body(plane_simulated), &frame, in.maybe(&joint))) &&
        plane_joints.size() < 4 &&
        told(graze_plane_simulation_add_joint_d(plane_simulation, in.maybe(&joint), &joint_id)))
      plane_joints.push_back(joint_id);
    break;
  case 4:
    if (!plane_joints.empty())
      told(graze_plane_simulation_remove_joint_d(plane_simulation, plane_joints[in.byte() % plane_joints.size()]));
    break;
  case 5:
    if (plane_state == nullptr)
      told(graze_plane_simulation_save_d(plane_simulation, in.maybe(&plane_state)));
    else
      told(graze_plane_simulation_restore_d(plane_simulation, in.maybe(plane_state)));
    break;
  case 6:
    told(graze_plane_simulation_apply_impulse_d(plane_simulation, body(plane_simulated), {in.number(), in.number()},
                                                {in.number(), in.number()}));
    break;
  default: told(graze_plane_simulation_step_d(in.maybe(plane_simulation), in.byte() < 8 ? in.number() : 1.0 / 60));
  }
  told(graze_plane_simulation_pose_d(plane_simulation, body(plane_simulated), in.maybe(&pose)));
  const GrazeJointId* all;
  std::size_t count = 0;
  std::int32_t sub_steps = 0;
  std::uint64_t hash = 0;
  told(graze_plane_simulation_sub_steps_d(plane_simulation, body(plane_simulated), in.maybe(&sub_steps)));
  told(graze_plane_simulation_state_hash_d(plane_simulation, in.maybe(&hash)));
  if (told(graze_plane_simulation_joints_d(plane_simulation, in.maybe(buffer), &all, &count)) && count > 0)
    told(graze_plane_simulation_joint_d(plane_simulation, all[0], buffer, in.maybe(&joint)));
  const GrazePlaneWorldd* borrowed;
  if (told(graze_plane_simulation_world_d(plane_simulation, in.maybe(&borrowed))))
    require(graze_plane_world_update_d(const_cast<GrazePlaneWorldd*>(borrowed), 0) == GRAZE_INVALID_VALUE);
}
