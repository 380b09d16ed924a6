// The questions about two shapes, from C.
#include <graze/graze.h>

#include <stdio.h>
#include <stdlib.h>

// Ends the program with what the library says where a call fails.
static void check(GrazeStatus status) {
  if (status == GRAZE_OK) return;
  fprintf(stderr, "graze: %s\n", graze_last_error());
  exit(EXIT_FAILURE);
}

int main(void) {
  GrazeShaped *box, *can;
  GrazeBufferd* buffer;
  check(graze_shape_box_d((GrazeVec3d){2, 2, 2}, &box));
  check(graze_shape_cylinder_d(1.5, 0.5, 0.5, &can));
  check(graze_buffer_create_d(&buffer));
  const GrazePosed standing = graze_pose_identity_d();
  const GrazePosed leaning = graze_pose_turned_d((GrazeVec3d){1.3, 0.4, 0}, (GrazeVec3d){0, 0, 1}, 0.5);

  bool touch;
  check(graze_overlap_d(box, &standing, can, &leaning, &touch));
  printf("touch: %s\n", touch ? "yes" : "no");

  GrazeDistanced d;
  check(graze_distance_d(box, &standing, can, &leaning, &d));
  printf("distance %.6f along (%.3f, %.3f, %.3f)\n", d.distance, d.normal.x, d.normal.y, d.normal.z);

  GrazeContactsd contacts;
  check(graze_contacts_d(box, &standing, can, &leaning, 0.01, buffer, &contacts));
  for (size_t i = 0; i < contacts.point_count; ++i) {
    const GrazeContactPointd* p = &contacts.points[i];
    printf("contact at (%.3f, %.3f, %.3f), %.6f apart\n", p->a.x, p->a.y, p->a.z, p->distance);
  }

  const GrazeRayd ray = {{-5, 0.3, 0}, {1, 0, 0}};
  GrazeRayHitd hit;
  bool found;
  check(graze_raycast_d(box, &standing, &ray, 100, GRAZE_BACK_FACES_HIT, &found, &hit));
  if (found) printf("the ray hits after %.3f at (%.3f, %.3f, %.3f)\n", hit.t, hit.point.x, hit.point.y, hit.point.z);

  // A value that makes no sense is refused, by name.
  GrazeShaped* ball;
  if (graze_shape_sphere_d(-1, (GrazeVec3d){0, 0, 0}, &ball) != GRAZE_OK) printf("%s\n", graze_last_error());

  graze_buffer_destroy_d(buffer);
  graze_shape_release_d(can);
  graze_shape_release_d(box);
  return 0;
}
