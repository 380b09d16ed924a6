// The least that a user of the installed C interface writes: two balls, how far apart.
#include <graze/graze.h>

int main(void) {
  GrazeShaped *ball;
  if (graze_shape_sphere_d(1, (GrazeVec3d){0, 0, 0}, &ball) != GRAZE_OK) return 1;
  const GrazePosed here = graze_pose_identity_d(), there = graze_pose_at_place_d(0, 3, 0);
  GrazeDistanced d;
  if (graze_distance_d(ball, &here, ball, &there, &d) != GRAZE_OK) return 1;
  graze_shape_release_d(ball);
  return d.distance == 1 && d.normal.y == 1 ? 0 : 1;
}
