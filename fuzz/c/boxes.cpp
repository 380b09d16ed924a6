// Broad phases and the changes of their pairs.
#include "c/calls.hpp"

GrazeAabbd Calls::box() {
  const GrazeVec3d lower = in.vector();
  return {lower, {lower.x + in.length(), lower.y + in.length(), lower.z + in.length()}};
}

void Calls::ask_broad_phase() {
  if (broad == nullptr) told(graze_broad_phase_create_d(in.choice<GrazeBroadPhaseKind>(6), in.maybe(&broad)));
  const GrazeAabbd around = box();
  const std::uint32_t id = in.byte() % 16;
  const GrazeIdPair* pairs;
  const std::uint32_t* ids;
  const GrazeBroadPhasePartd* parts;
  std::size_t count = 0;
  switch (in.byte() % 8) {
  case 0: ask_changes(); break;
  case 1: told(graze_broad_phase_insert_d(broad, id, in.maybe(&around))); break;
  case 2: told(graze_broad_phase_move_d(broad, id, in.maybe(&around))); break;
  case 3: told(graze_broad_phase_remove_d(broad, id)); break;
  case 4:
    if (told(graze_broad_phase_moved_pairs_d(broad, buffer, in.maybe(&pairs), &count)))
      for (std::size_t i = 0; i < count; ++i) require(pairs[i].a < pairs[i].b);
    break;
  case 5: told(graze_broad_phase_sweep_d(broad, in.maybe(&around), in.vector(), buffer, &ids, in.maybe(&count))); break;
  case 6: told(graze_broad_phase_parts_d(broad, in.maybe(buffer), in.maybe(&parts), &count)); break;
  default:
    told(graze_broad_phase_pairs_d(broad, in.maybe(buffer), &pairs, &count));
    if (told(graze_broad_phase_query_d(broad, in.maybe(&around), buffer, &ids, &count)) && count > 0)
      require(graze_broad_phase_insert_d(broad, ids[0], &around) == GRAZE_INVALID_VALUE);
  }
}

void Calls::ask_changes() {
  if (changes == nullptr) told(graze_pair_changes_create_d(in.choice<GrazeBroadPhaseKind>(6), in.maybe(&changes)));
  const GrazeAabbd around = box();
  const std::uint32_t id = in.byte() % 16;
  const GrazeIdPair *begun, *ended;
  std::size_t count = 0, ended_count = 0;
  switch (in.byte() % 4) {
  case 0: told(graze_pair_changes_insert_d(changes, id, in.maybe(&around))); break;
  case 1: told(graze_pair_changes_move_d(changes, id, in.maybe(&around))); break;
  case 2: told(graze_pair_changes_remove_d(changes, id)); break;
  default:
    if (told(graze_pair_changes_find_d(changes, in.maybe(buffer), &begun, &count, in.maybe(&ended), &ended_count)))
      for (std::size_t i = 0; i < count; ++i) require(begun[i].a < begun[i].b);
  }
}
