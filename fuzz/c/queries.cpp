// Queries of one pair, one ray, moving pairs and many pairs.
#include "c/calls.hpp"

void Calls::ask_pair() {
  const GrazeShaped *a = shape(), *b = shape();
  const GrazePosed pose_a = in.pose(), pose_b = in.pose();
  const GrazePosed *pa = in.maybe(&pose_a), *pb = in.maybe(&pose_b);
  bool yes = false;
  GrazeDistanced d{};
  told(graze_overlap_d(a, pa, b, pb, in.maybe(&yes)));
  told(graze_may_overlap_d(a, pa, b, pb, in.maybe(&yes)));
  if (told(graze_distance_d(a, pa, b, pb, in.maybe(&d)))) require(d.certainty <= GRAZE_UNBOUNDED && d.error >= 0);
  told(graze_distance_up_to_d(a, pa, b, pb, in.length(), in.maybe(&yes), in.maybe(&d)));
  told(graze_within_d(a, pa, b, pb, in.length(), in.maybe(&yes)));
  const GrazePieceDistanced* pieces;
  std::size_t count = 0;
  told(graze_near_pieces_d(a, pa, b, pb, in.length(), in.maybe(buffer), in.maybe(&pieces), in.maybe(&count)));
  const GrazeVec3d* corners;
  const auto feature = static_cast<std::uint16_t>(in.byte() << 8 | in.byte());
  told(graze_feature_corners_d(a, in.byte(), feature, in.maybe(buffer), in.maybe(&corners), in.maybe(&count)));
  GrazeContactsd contacts;
  if (told(graze_contacts_reduced_d(a, pa, b, pb, in.length(), in.byte(), in.maybe(buffer), &contacts)))
    for (std::size_t i = 0; i < contacts.manifold_count; ++i)
      require(contacts.manifolds[i].first_point + contacts.manifolds[i].point_count <= contacts.point_count);
  GrazeDistanced explained{};
  GrazeTraceView view;
  if (graze_distance_d(a, &pose_a, b, &pose_b, &d) == GRAZE_OK &&
      told(graze_distance_explained_d(a, &pose_a, b, &pose_b, &explained, in.maybe(trace))))
    require(explained.distance == d.distance);
  if (told(graze_trace_view(in.maybe(trace), in.maybe(&view))) && view.axis_count > 0)
    require(view.axes[0].name != nullptr);
}

void Calls::ask_ray() {
  const GrazeShaped* s = shape();
  const GrazePosed pose = in.pose();
  const GrazeRayd ray = {in.vector(), in.vector()};
  bool found = false;
  GrazeRayHitd hit;
  const GrazeRayHitd* hits;
  std::size_t count = 0;
  const auto back = in.choice<GrazeBackFaces>(2);
  told(graze_raycast_d(s, in.maybe(&pose), in.maybe(&ray), in.length(), back, in.maybe(&found), in.maybe(&hit)));
  told(graze_raycast_any_d(s, &pose, in.maybe(&ray), in.length(), back, in.maybe(&found)));
  told(graze_raycast_all_d(s, &pose, &ray, in.length(), back, in.maybe(buffer), &hits, in.maybe(&count)));
  const GrazeBodyRayHitd* body_hits;
  told(graze_world_raycast_all_d(world, &ray, in.length(), nullptr, back, buffer, in.maybe(&body_hits), &count));
}

void Calls::ask_cast() {
  // What turns while it lies deep in its like takes seconds: most of these begin apart and meet.
  const auto moving = [&] {
    GrazeMovingd m{shape(), graze_pose_at_place_d((in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, 0), {}};
    m.velocity.linear = {(in.byte() - 128) / 32.0, (in.byte() - 128) / 32.0, 0};
    m.velocity.angular.z = (in.byte() - 128) / 128.0;
    if (in.byte() < 4) m.velocity.angular.x = in.number() * 0;  // not a number, at times
    return m;
  };
  const GrazeMovingd a = moving();
  GrazeMovingd b = moving();
  b.pose.translation.x += 16;
  b.velocity.linear.x -= 12;
  bool found = false;
  GrazeCastHitd hit;
  const double duration = in.byte() < 8 ? in.number() * 1e-9 : in.byte() / 128.0;
  if (!(duration < 4)) return;
  told(graze_cast_d(in.maybe(&a), &b, duration, in.choice<GrazeSeparating>(2), in.maybe(&found), in.maybe(&hit)));
}

void Calls::ask_batch() {
  const std::size_t count = in.byte() % 20;
  std::vector<const GrazeShaped*> handles(in.byte() < 128 ? 1 : count);
  for (auto& h : handles) h = shape();
  std::vector<GrazePosed> poses(in.byte() < 32 ? 1 : count);
  for (auto& p : poses) p = in.pose();
  std::vector<GrazeIdPair> places(in.byte() % 8);
  for (auto& p : places) p = {in.byte() % 21u, in.byte() % 3u};
  GrazeBatchd batch{};
  batch.a = graze_bodies_d(in.maybe(handles.data()), handles.size(), in.maybe(poses.data()), poses.size());
  batch.b = graze_bodies_d(handles.data(), handles.empty() ? 0 : 1, poses.data(), poses.empty() ? 0 : 1);
  if (in.byte() < 64) batch.b.rotations = nullptr;
  if (!places.empty()) batch.places = places.data(), batch.place_count = places.size();
  std::size_t size = 0;
  if (!told(graze_batch_size_d(in.maybe(&batch), in.maybe(&size)))) return;
  std::vector<std::uint8_t> touch(size);
  std::vector<GrazeDistanced> distances(size);
  told(graze_overlap_batch_d(&batch, in.maybe(touch.data()), 0, nullptr));
  told(graze_distance_batch_d(&batch, in.maybe(distances.data()), 0, nullptr));
  GrazeBatchContactsd contacts;
  GrazeCompactContactsd compact;
  if (told(graze_compact_contacts_batch_d(&batch, in.length(), in.maybe(buffer), in.maybe(&compact), nullptr)))
    for (std::size_t i = 0; i < compact.manifold_count; ++i)
      require(compact.manifolds[i].first_point + compact.manifolds[i].point_count <= compact.point_count);
  const std::size_t most = in.byte();
  if (told(graze_contacts_batch_reduced_d(&batch, in.length(), most, in.maybe(buffer), &contacts, nullptr)))
    require(contacts.pair_count == size && contacts.point_count <= most * size);
  const GrazePieceDistanced* pieces;
  const std::size_t* ends;
  if (told(graze_near_pieces_batch_d(&batch, in.length(), in.maybe(buffer), &pieces, in.maybe(&ends), &size)))
    require(size == 0 || ends[touch.size() - 1] == size);
}
