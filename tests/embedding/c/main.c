#include <foredraw/c/functions.h>

#include <stdio.h>

int main(void) {
  const unsigned short indices[] = {0, 1, 2, 3, 4, 5, 2, 1, 3};
  const foredraw_triangles mesh = {indices, 9, sizeof *indices, 6};
  unsigned short ordered[9];
  uint32_t order[3];
  int status = foredraw_tipsify(order, &mesh, 0);
  if (status == FOREDRAW_DONE) status = foredraw_reorder_triangles(ordered, &mesh, order);
  if (status != FOREDRAW_DONE) return fprintf(stderr, "%s\n", foredraw_status_text(status)), 1;
  for (int i = 0; i < 9; i += 3) printf("%d %d %d\n", ordered[i], ordered[i + 1], ordered[i + 2]);
  return 0;
}
