// A simulation from C: boxes fall onto a floor, one hangs on a hinge, and all come to rest.
#include <graze/graze.h>

#include <stdio.h>
#include <stdlib.h>

static void check(GrazeStatus status) {
  if (status == GRAZE_OK) return;
  fprintf(stderr, "graze: %s\n", graze_last_error());
  exit(EXIT_FAILURE);
}

enum { box_count = 4 };

int main(void) {
  GrazeSimulationd* simulation;
  check(graze_simulation_create_d(NULL, NULL, &simulation));

  GrazeShaped *ground, *box;
  check(graze_shape_half_space_d(&ground));
  check(graze_shape_box_d((GrazeVec3d){1, 1, 1}, &box));

  GrazeBodyd floor = graze_body_default_d(ground);
  floor.fixed = true;
  GrazeBodyId floor_id;
  check(graze_simulation_add_d(simulation, &floor, NULL, NULL, &floor_id));

  GrazeBodyId ids[box_count];
  for (int i = 0; i < box_count; ++i) {
    GrazeBodyd body = graze_body_default_d(box);
    body.pose = graze_pose_at_place_d(0.1 * i, 1 + 1.5 * i, 0);
    check(graze_simulation_add_d(simulation, &body, NULL, NULL, &ids[i]));
  }
  // The simulation keeps shares of its own.
  graze_shape_release_d(ground);
  graze_shape_release_d(box);

  // The highest hangs on a hinge half a metre beside it.
  const GrazePosed place = graze_pose_at_place_d(1, 5.5, 0), frame = graze_pose_at_place_d(0.7, 0, 0);
  GrazeJointd hinge;
  GrazeJointId hinge_id;
  check(graze_joint_of_kind_d(GRAZE_JOINT_HINGE, floor_id, &place, ids[box_count - 1], &frame, &hinge));
  check(graze_simulation_add_joint_d(simulation, &hinge, &hinge_id));

  const GrazeWorldd* world;
  check(graze_simulation_world_d(simulation, &world));
  for (int step = 0; step < 240; ++step) {
    check(graze_simulation_step_d(simulation, 1.0 / 60));
    const GrazeContactEvent* events;
    size_t count;
    check(graze_world_events_d(world, &events, &count));
    for (size_t i = 0; i < count; ++i)
      if (events[i].kind == GRAZE_EVENT_BEGIN)
        printf("%.2f s: %u and %u begin to touch\n", (step + 1) / 60.0, events[i].a.index, events[i].b.index);
  }

  for (int i = 0; i < box_count; ++i) {
    GrazePosed pose;
    check(graze_simulation_pose_d(simulation, ids[i], &pose));
    printf("box %d at (%.2f, %.2f, %.2f)\n", i, pose.translation.x, pose.translation.y, pose.translation.z);
  }
  graze_simulation_destroy_d(simulation);
  return 0;
}
